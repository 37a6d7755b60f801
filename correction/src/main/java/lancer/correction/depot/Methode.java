package lancer.correction.depot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.correction.modele.Modele;

/** Une méthode déclarée : ce qu'elle rend, son nom, les types de ses paramètres. */
final class Methode {

    private static final Pattern DECLARATION = Pattern.compile(
            "\\b(?!(?:return|new|else|throw|public|protected|private)\\b)(\\w+)\\s+(\\w+)\\s*\\(([^()]*)\\)\\s*(?:throws[\\w\\s,.]+)?[{;]");

    /** Types qu'on peut passer, en le disant, à la place d'autre chose. */
    private static final List<String> COMPATIBLES = List.of("Objet3D Sphere", "Sphere Objet3D", "int double", "float double");

    final String rend;
    final String nom;
    final List<String> types;

    private Methode(MatchResult m) {
        rend = m.group(1);
        nom = m.group(2);
        types = Arrays.stream(m.group(3).split(",")).map(p -> p.replaceAll("\\bfinal\\b", "").trim().split("\\s+")[0])
                .collect(Collectors.toList());
    }

    /** Méthodes que déclare un texte. */
    static List<Methode> de(String texte) {
        return DECLARATION.matcher(Source.sansCommentaires(texte)).results().map(Methode::new).collect(Collectors.toList());
    }

    /**
     * Le texte d'une classe du cours, avec la forme attendue des méthodes dont l'étudiant a changé l'ordre ou la sorte des
     * paramètres : elle appelle la sienne. C'est dit une fois, et rien d'autre n'en souffre.
     */
    static String avecPonts(String classe, String texte, List<String> remarques) {
        StringBuilder ponts = new StringBuilder();
        List<Methode> toutes = de(texte);
        for (Methode attendue : de(Modele.squelette(classe))) {
            List<Methode> siennes = toutes.stream().filter(m -> m.nom.equals(attendue.nom)).collect(Collectors.toList());
            if (!attendue.rend.equals("void") && siennes.stream().noneMatch(attendue::convient)) {
                siennes.stream().filter(m -> m.arguments(attendue) != null).findFirst().ifPresent(m -> {
                    List<String> parametres = new ArrayList<>();
                    attendue.types.forEach(type -> parametres.add(type + " p" + parametres.size()));
                    ponts.append(" public " + attendue.rend + " " + attendue.nom + "(" + String.join(", ", parametres) + ") { return "
                            + attendue.nom + "(" + String.join(", ", m.arguments(attendue)) + "); } ");
                    remarques.add("signature : " + classe + "." + attendue.nom + "(" + String.join(", ", m.types) + ") au lieu de ("
                            + String.join(", ", attendue.types) + ") ; jugée comme si elle avait celle du cours");
                });
            }
        }
        int fin = Math.max(0, texte.lastIndexOf('}'));
        return texte.substring(0, fin) + ponts + texte.substring(fin);
    }

    /** Vrai si l'on peut appeler celle-là telle quelle à la place : un objet quelconque y convient aussi. */
    private boolean convient(Methode sienne) {
        return sienne.types.size() == types.size() && IntStream.range(0, types.size())
                .allMatch(k -> sienne.types.get(k).equals(types.get(k)) || sienne.types.get(k).equals("Objet3D"));
    }

    /** Paramètres de l'attendue avec lesquels l'appeler, {@code null} s'il lui en faut d'autres. */
    private List<String> arguments(Methode attendue) {
        List<String> restent = new ArrayList<>(attendue.types);
        boolean memePlace = types.size() == restent.size() && IntStream.range(0, types.size()).allMatch(k ->
                types.get(k).equals(restent.get(k)) || COMPATIBLES.contains(types.get(k) + " " + restent.get(k)));
        List<String> arguments = new ArrayList<>();
        for (String type : types) {
            int k = memePlace ? arguments.size() : restent.indexOf(type);
            if (k < 0) {
                return null;
            }
            arguments.add((type.equals(restent.set(k, "")) ? "" : "(" + type + ") ") + "p" + k);
        }
        return types.size() == attendue.types.size() ? arguments : null;
    }
}
