package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import lancer.mesures.stabilite.Stabilite;
import lancer.mesures.trace.Planche;

/** Des mesures notées aux courbes, aux tableaux et aux pages. */
final class Rapport {

    /** Ce que « make mesures » réécrit dans le projet. */
    static final Path[] PAGES = {Paths.get("README.md"), Paths.get("docs/vitesse-et-precision.md"), Paths.get("docs/stabilite.md")};

    private final Path dossier;
    private final Path atelier;
    private final PrintStream sortie;

    /**
     * @param dossier où sont les mesures, et où vont les courbes
     * @param atelier où les images des différences ont été gardées
     */
    Rapport(Path dossier, Path atelier, PrintStream sortie) {
        this.dossier = dossier;
        this.atelier = atelier;
        this.sortie = sortie;
    }

    /** @param pages vrai pour réécrire aussi les nombres des pages du projet */
    void ecrire(boolean pages) throws IOException {
        Releves releves = new Releves(new Journal(dossier.resolve(Ouvrier.CSV)).lire());
        if (releves.estVide()) {
            throw new IOException("aucune mesure dans " + dossier.resolve(Ouvrier.CSV));
        }
        String note = note(releves.get().get(releves.get().size() - 1));
        for (String scene : releves.de(Famille.ECHANTILLONNAGE).scenes()) {
            for (Cout cout : Cout.values()) {
                ecrire(new FigureScene(scene, releves, cout, note).planche(), scene + "-" + cout.nom);
            }
            FigureDifferences differences = new FigureDifferences(scene, releves, atelier.resolve(Ouvrier.DIFFERENCES), note);
            if (differences.possible()) {
                ecrire(differences.planche(), scene + "-differences");
            }
        }
        ecrire(new FigureModele(releves, note).planche(), "phong-blinn");
        ecrire(new FigureDemandes(releves, note).planche(), "demandes");
        ecrire(new FigureSpheres(releves, note).planche(), "spheres");
        Stabilite.dessiner(dossier);
        List<Map<String, String>> besoins = TableBesoins.lire(dossier.resolve("besoins.csv"));
        Files.write(dossier.resolve("besoins.md"), TableBesoins.markdown(besoins).getBytes(StandardCharsets.UTF_8));
        for (String scene : releves.de(Famille.ECHANTILLONNAGE).scenes()) {
            Constats constats = new Constats(scene, releves, Cout.RAYONS);
            sortie.println(constats.titre());
            sortie.println("  " + constats.anticrenelage());
            sortie.println("  " + constats.limites());
        }
        if (pages) {
            Map<String, String> valeurs = new TreeMap<>(new Chiffres(releves, besoins).get());
            valeurs.putAll(Stabilite.pages(dossier));
            for (Path page : PAGES) {
                PagesMesurees.reecrire(page, valeurs);
            }
        }
    }

    private void ecrire(Planche planche, String nom) throws IOException {
        planche.ecrire(dossier.resolve(nom + ".png"));
    }

    private static String note(Releve r) {
        String fils = r.texte("fils").equals("1") ? "un fil" : r.texte("fils") + " fils";
        return "Images de " + r.texte("largeur") + " × " + r.texte("hauteur") + ", " + fils + ". " + r.texte("machine") + ", "
                + r.texte("jvm") + ", commit " + r.texte("commit") + ", " + r.texte("date").replace('T', ' ')
                + ". Barres : la moitié centrale des temps. make mesures";
    }
}
