package lancer.correction.depot;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.correction.enfant.Texte;

/** Une méthode ou un constructeur : son type de retour, son nom, les types de ses paramètres. */
public final class Signature {

    private static final int TEXTE_MAX = 3000;

    /** Types qui peuvent en remplacer un autre ; la correction le signale. */
    private static final List<String> COMPATIBLES = List.of("Objet3D Sphere", "Sphere Objet3D", "int double", "float double");

    /** Type de retour, vide pour un constructeur. */
    public final String rend;
    public final String nom;
    final List<String> types = new ArrayList<>();
    private final boolean statique;
    public final boolean privee;
    /** Son texte, limité à {@value #TEXTE_MAX} caractères. */
    public final String texte;
    /** Empreinte de l'arbre syntaxique. */
    public final String arbre;
    /** Empreinte de cet arbre, où chaque variable a pour nom son rang, vide s'il est court ; et sa longueur. */
    String forme = "";
    int longueur;

    Signature(String nom, String rend, boolean statique, boolean privee, String texte, String arbre) {
        this.nom = nom;
        this.rend = rend;
        this.statique = statique;
        this.privee = privee;
        this.texte = Texte.couper(texte, TEXTE_MAX);
        this.arbre = arbre;
    }

    /**
     * Écrit, pour chaque méthode dont l'étudiant a changé le type des paramètres, une méthode de forme attendue qui appelle la
     * sienne.
     *
     * @param dites reçoit ces changements
     */
    static String ponts(Type duCours, Type lui, List<String> dites) {
        StringBuilder ponts = new StringBuilder();
        for (Signature attendue : duCours.methodes) {
            List<Signature> siennes = lui.methodes.stream().filter(m -> m.nom.equals(attendue.nom) && m.statique == attendue.statique
                    && m.rend.isEmpty() == attendue.rend.isEmpty() && m.convient(attendue)).collect(Collectors.toList());
            if (!attendue.privee && !siennes.isEmpty() && siennes.stream().noneMatch(m -> m.vaut(attendue))) {
                ponts.append(siennes.get(0).pont(attendue));
                dites.add((attendue.rend.isEmpty() ? "" : lui.nom + ".") + attendue.nom + "(" + String.join(", ", siennes.get(0).types)
                        + ") au lieu de (" + String.join(", ", attendue.types) + ")");
            }
        }
        return ponts.toString();
    }

    /** Dit si elle prend et rend ce que prend et rend celle-là. @param duCours noms des classes du cours, par ceux de l'étudiant */
    boolean memesTypes(Signature attendue, Map<String, String> duCours) {
        return duCours.getOrDefault(rend, rend).equals(attendue.rend) && types.stream().map(t -> duCours.getOrDefault(t, t))
                .collect(Collectors.toList()).equals(attendue.types);
    }

    private String pont(Signature attendue) {
        String parametres = IntStream.range(0, types.size()).mapToObj(k -> attendue.types.get(k) + " p" + k)
                .collect(Collectors.joining(", "));
        String arguments = IntStream.range(0, types.size()).mapToObj(k -> (types.get(k).equals(attendue.types.get(k)) ? ""
                : "(" + types.get(k) + ") ") + "p" + k).collect(Collectors.joining(", "));
        String resultat = rend.isEmpty() || rend.equals("void") ? "" : "return ";
        String appelee = rend.isEmpty() ? "this" : nom;
        return " public " + (statique ? "static " : "") + rend + " " + nom + "(" + parametres + ") { "
                + resultat + appelee + "(" + arguments + "); }";
    }

    /** Dit si un appel de l'attendue appelle celle-ci : un {@code Objet3D} reçoit une {@code Sphere}. */
    private boolean vaut(Signature attendue) {
        return IntStream.range(0, types.size()).allMatch(k -> types.get(k).equals(attendue.types.get(k)) || types.get(k).equals("Objet3D"));
    }

    /** Dit si un appel de l'attendue peut devenir un appel de celle-ci. */
    private boolean convient(Signature attendue) {
        return types.size() == attendue.types.size() && IntStream.range(0, types.size()).allMatch(k ->
                types.get(k).equals(attendue.types.get(k)) || COMPATIBLES.contains(types.get(k) + " " + attendue.types.get(k)));
    }
}
