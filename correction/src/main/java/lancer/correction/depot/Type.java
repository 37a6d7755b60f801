package lancer.correction.depot;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Une classe, telle que le JDK la lit. */
public final class Type {

    /** Celle dont on n'a rien pu lire. */
    static final Type RIEN = new Type(List.of("", 0, 0, "", List.of(), List.of()), "");

    public final String nom;
    /** Où elle commence et finit dans son fichier. */
    final int debut;
    final int fin;
    /** Empreinte de son arbre : ni les commentaires, ni la présentation, ni les noms des variables locales. */
    public final String empreinte;
    /** Noms qu'elle emploie, {@code float} et {@code System.in} compris. */
    public final Set<String> noms = new TreeSet<>();
    public final List<Methode> methodes;

    /** @param lue voir {@link lancer.correction.enfant.Lecteur#lire} ; @param texte son fichier */
    Type(List<?> lue, String texte) {
        nom = (String) lue.get(0);
        debut = (Integer) lue.get(1);
        fin = (Integer) lue.get(2);
        empreinte = (String) lue.get(3);
        ((List<?>) lue.get(4)).forEach(n -> noms.add((String) n));
        methodes = ((List<?>) lue.get(5)).stream().map(m -> new Methode((List<?>) m, texte)).collect(Collectors.toList());
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
