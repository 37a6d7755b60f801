package lancer.mesures;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.Paths;

/**
 * Mesure chaque scène dans une machine virtuelle à elle, comme le ferait le programme : la lecture et la préparation y sont
 * froides, et le code n'y est compilé que pour cette scène-là.
 */
final class MachineSeparee implements Banc.Essai {

    private final Reglages reglages;

    MachineSeparee(Reglages reglages) {
        this.reglages = reglages;
    }

    @Override
    public Mesure mesurer(Path fichier) throws IOException {
        ProcessBuilder commande = new ProcessBuilder(Paths.get(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp", System.getProperty("java.class.path"), MachineSeparee.class.getName(), fichier.toString(),
                String.valueOf(reglages.largeur), String.valueOf(reglages.hauteur), String.valueOf(reglages.fils),
                String.valueOf(reglages.dureeNs), String.valueOf(reglages.limiteNs)).redirectError(ProcessBuilder.Redirect.INHERIT);
        Process processus = commande.start();
        try (BufferedReader sortie = new BufferedReader(new InputStreamReader(processus.getInputStream(), StandardCharsets.UTF_8))) {
            String ligne = sortie.readLine();
            return ligne == null ? Mesure.fautive("la machine virtuelle s'est arrêtée sans rien dire") : Mesure.lire(ligne);
        } finally {
            // elle n'a plus rien à dire ; Ctrl+C ne doit pas la laisser seule
            processus.destroy();
        }
    }

    /** @param args fichier, largeur, hauteur, fils, durée et limite en nanosecondes */
    public static void main(String[] args) throws IOException {
        Reglages reglages = new Reglages(Integer.parseInt(args[1]), Integer.parseInt(args[2]), Integer.parseInt(args[3]),
                Long.parseLong(args[4]), Long.parseLong(args[5]));
        Mesure mesure = new Chronometre(Chronometre.DU_PROGRAMME, reglages).mesurer(Paths.get(args[0]));
        PrintStream sortie = new PrintStream(System.out, true, "UTF-8");
        sortie.println(mesure);
    }
}
