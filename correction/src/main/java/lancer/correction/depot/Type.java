package lancer.correction.depot;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Une classe, telle que le JDK la lit, et le texte où elle vient. */
public final class Type {

    public final String nom;
    /** Où elle commence et finit dans son fichier. */
    final int debut;
    final int fin;
    /** Empreinte de son arbre : ni les commentaires, ni la présentation, ni les noms des variables locales. */
    public final String empreinte;
    /** Noms qu'elle emploie, {@code float} et {@code System.in} compris. */
    public final Set<String> noms = new TreeSet<>();
    public final List<Signature> methodes;
    Source source;
    String texte;
    /** Longueur de ce qui suit, dans ce texte, la fin de la classe. */
    private int reste;

    /** @param lue voir {@link lancer.correction.enfant.Lecteur#lire} ; @param fichier le texte d'où elle vient */
    Type(List<?> lue, String fichier) {
        nom = (String) lue.get(0);
        debut = (Integer) lue.get(1);
        fin = (Integer) lue.get(2);
        empreinte = (String) lue.get(3);
        ((List<?>) lue.get(4)).forEach(n -> noms.add((String) n));
        methodes = ((List<?>) lue.get(5)).stream().map(m -> new Signature((List<?>) m, fichier)).collect(Collectors.toList());
    }

    /** Celle dont on n'a rien pu lire, que le nom. */
    static Type rien(String nom) {
        return new Type(List.of(nom, 0, 0, "", List.of(), List.of()), "");
    }

    Type placer(Source fichier, String sien, int suite) {
        source = fichier;
        texte = sien;
        reste = suite;
        return this;
    }

    /** Son nom complet, des « / » entre les paquets. */
    String chemin() {
        return (source.paquet.isEmpty() ? "" : source.paquet.replace('.', '/') + "/") + nom;
    }

    /** Le texte, où ceci est ajouté à la fin de la classe. */
    String avec(String membres) {
        int ici = texte.length() - reste - 1;
        return membres.isEmpty() || ici < 0 || texte.charAt(ici) != '}' ? texte
                : texte.substring(0, ici) + membres + " " + texte.substring(ici);
    }

    /** Noms de ses méthodes, sauf celles de toute classe. */
    Set<String> nommees() {
        Set<String> nommees = methodes.stream().filter(m -> !m.rend.isEmpty() && !m.privee).map(m -> m.nom)
                .collect(Collectors.toCollection(TreeSet::new));
        nommees.removeAll(List.of("toString", "equals", "hashCode"));
        return nommees;
    }

    /** Nombre de méthodes qu'elle a, de celles-ci. */
    long parmi(Set<String> attendues) {
        return attendues.stream().filter(nommees()::contains).count();
    }
}
