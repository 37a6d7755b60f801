package lancer.correction.depot;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.correction.enfant.Echange;

/** Une méthode ou un constructeur : son type de retour, son nom, les types de ses paramètres. */
public final class Signature {

    private static final int TEXTE_MAX = 3000;

    /** Types qui peuvent en remplacer un autre ; la correction le signale. */
    private static final List<String> COMPATIBLES = List.of("Objet3D Sphere", "Sphere Objet3D", "int double", "float double");

    /** Type de retour, vide pour un constructeur. */
    final String rend;
    public final String nom;
    final List<String> types;
    private final boolean statique;
    final boolean privee;
    /** Son texte, limité à {@value #TEXTE_MAX} caractères. */
    public final String texte;
    /** Empreinte de l'arbre syntaxique. */
    public final String arbre;

    Signature(List<?> lue, String fichier) {
        nom = (String) lue.get(0);
        rend = (String) lue.get(1);
        types = ((List<?>) lue.get(2)).stream().map(String.class::cast).collect(Collectors.toList());
        statique = ((String) lue.get(3)).contains("static");
        privee = ((String) lue.get(3)).contains("private");
        int debut = Math.max(0, (Integer) lue.get(4));
        texte = Echange.couper(fichier.substring(debut, Math.max(debut, (Integer) lue.get(5))), TEXTE_MAX);
        arbre = (String) lue.get(6);
    }

    public String signature() {
        return nom + "(" + String.join(", ", types) + ")";
    }

    /**
     * Écrit, pour chaque méthode dont l'étudiant a changé l'ordre ou le type des paramètres, une méthode de forme attendue qui appelle la
     * sienne.
     *
     * @param dites reçoit ces changements
     */
    static String ponts(Type duCours, Type lui, List<String> dites) {
        StringBuilder ponts = new StringBuilder();
        for (Signature attendue : duCours.methodes) {
            List<Signature> siennes = lui.methodes.stream().filter(m -> m.nom.equals(attendue.nom) && m.statique == attendue.statique
                    && m.rend.isEmpty() == attendue.rend.isEmpty()).collect(Collectors.toList());
            if (!attendue.privee && siennes.stream().noneMatch(attendue::convient)) {
                siennes.stream().filter(m -> m.arguments(attendue) != null).findFirst().ifPresent(m -> {
                    List<String> parametres = new ArrayList<>();
                    attendue.types.forEach(type -> parametres.add(type + " p" + parametres.size()));
                    ponts.append(" public " + (m.statique ? "static " : "") + m.rend + " " + m.nom + "(" + String.join(", ", parametres)
                            + ") { " + (m.rend.isEmpty() ? "this" : (m.rend.equals("void") ? "" : "return ") + m.nom)
                            + "(" + String.join(", ", m.arguments(attendue)) + "); }");
                    dites.add((m.rend.isEmpty() ? "" : lui.nom + ".") + m.signature() + " au lieu de ("
                            + String.join(", ", attendue.types) + ")");
                });
            }
        }
        return ponts.toString();
    }

    /** Dit si {@code sienne} peut être appelée à la place de cette méthode, sans adaptation. */
    private boolean convient(Signature sienne) {
        return sienne.types.size() == types.size() && IntStream.range(0, types.size())
                .allMatch(k -> sienne.types.get(k).equals(types.get(k)) || sienne.types.get(k).equals("Objet3D"));
    }

    /** Arguments qui permettent d'appeler cette méthode depuis l'attendue ; {@code null} si c'est impossible. */
    private List<String> arguments(Signature attendue) {
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
