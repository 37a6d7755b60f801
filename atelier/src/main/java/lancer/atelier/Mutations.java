package lancer.atelier;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Compare les rapports CSV de PIT à ce qu'en disent une page, le score de chaque classe, et une liste, les mutants qu'aucun test n'a tués.
 * Un mutant est reconnu à sa méthode, à sa mutation et au texte de sa ligne, non au numéro de celle-ci. Lancé par {@code make mutations}.
 */
public final class Mutations {

    /** {@code classe : tués sur tous}, ou {@code - Classe.méthode, Mutateur ×2, `ligne` : raison} moins la raison. */
    private static final Pattern ECRIT = Pattern.compile("([\\w.$]+ : [0-9]+ sur [0-9]+)|(- \\S+, \\w+ ×[0-9]+, `.+`) : .+");

    private Mutations() {
    }

    /** @param args la page, la liste, puis les dossiers des modules */
    public static void main(String[] args) throws IOException {
        List<Path> modules = Arrays.stream(args).skip(2).map(Paths::get).collect(Collectors.toList());
        StringBuilder dit = new StringBuilder();
        boolean conforme = verifier(Arrays.asList(Paths.get(args[0]), Paths.get(args[1])), modules, dit);
        System.out.print(dit);
        System.exit(conforme ? 0 : 1);
    }

    /**
     * Vrai si les pages disent exactement, ensemble, ce que disent les rapports.
     *
     * @param dit le score de chaque classe, puis ce qui manque aux pages, prêt à y être mis, et ce qu'elles ont de trop
     */
    static boolean verifier(List<Path> pages, List<Path> modules, StringBuilder dit) throws IOException {
        Map<String, int[]> scores = new TreeMap<>();
        Map<String, Integer> survivants = new TreeMap<>();
        int tropLongs = 0;
        for (Path module : modules) {
            tropLongs += lire(module, scores, survivants);
        }
        Set<String> vrai = new TreeSet<>();
        scores.forEach((classe, n) -> vrai.add(classe + " : " + n[0] + " sur " + n[1]));
        vrai.forEach(ligne -> dit.append(ligne).append('\n'));
        if (tropLongs > 0) {
            dit.append("dont arrêtés, trop longs : ").append(tropLongs).append(" (boucle sans fin, ou machine trop chargée)\n");
        }
        survivants.forEach((mutant, fois) -> vrai.add("- " + mutant.replaceFirst(", `", " ×" + fois + ", `")));
        Set<String> ecrit = new TreeSet<>();
        for (Path page : pages) {
            Files.readAllLines(page).stream().map(ECRIT::matcher).filter(Matcher::matches)
                    .forEach(m -> ecrit.add(m.group(1) != null ? m.group(1) : m.group(2)));
        }
        dire(dit, "manque à " + pages, vrai, ecrit);
        dire(dit, "n'est plus vrai dans " + pages, ecrit, vrai);
        return vrai.equals(ecrit);
    }

    private static void dire(StringBuilder dit, String quoi, Set<String> lignes, Set<String> saufElles) {
        Set<String> reste = new TreeSet<>(lignes);
        reste.removeAll(saufElles);
        if (!reste.isEmpty()) {
            dit.append(quoi).append(" :\n").append(String.join("\n", reste)).append('\n');
        }
    }

    /**
     * Une ligne du rapport : fichier, classe, mutateur, méthode, ligne, sort, test.
     *
     * @return le nombre de mutants arrêtés parce que trop longs, que PIT compte parmi les tués
     */
    private static int lire(Path module, Map<String, int[]> scores, Map<String, Integer> survivants) throws IOException {
        int tropLongs = 0;
        for (String mutant : Files.readAllLines(module.resolve("target/pit-reports/mutations.csv"))) {
            String[] m = mutant.split(",");
            String classe = m[1].replaceFirst("\\$.*", "");
            boolean survit = m[5].equals("SURVIVED") || m[5].equals("NO_COVERAGE");
            tropLongs += m[5].equals("TIMED_OUT") ? 1 : 0;
            for (String qui : new String[] {classe, "total"}) {
                int[] n = scores.computeIfAbsent(qui, rien -> new int[2]);
                n[0] += survit ? 0 : 1;
                n[1]++;
            }
            if (survit) {
                Path source = module.resolve("src/main/java").resolve(classe.replace('.', '/') + ".java");
                String ligne = Files.readAllLines(source).get(Integer.parseInt(m[4]) - 1).trim();
                survivants.merge(apresDernierPoint(m[1]) + "." + m[3] + ", " + apresDernierPoint(m[2]) + ", `" + ligne + "`", 1,
                        Integer::sum);
            }
        }
        return tropLongs;
    }

    private static String apresDernierPoint(String nom) {
        return nom.substring(nom.lastIndexOf('.') + 1);
    }
}
