package lancer.correction.depot;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Une classe lue par le JDK, et le texte qui la contient. */
public final class Type {

    public final String nom;
    /** Début et fin de la classe dans son fichier. */
    final int debut;
    final int fin;
    /** Empreinte de l'arbre syntaxique, qui ignore les commentaires et la présentation. */
    public final String empreinte;
    /** Noms utilisés, {@code float} compris. */
    public final Set<String> noms = new TreeSet<>();
    public final List<Signature> methodes = new ArrayList<>();
    transient Source source;
    /** D'où vient son texte, et s'il cède la place à un autre : voir {@link Cours#provenance}. */
    transient int provenance;
    transient String texte;
    /** Longueur du texte après la fin de la classe. */
    private transient int reste;

    Type(String nom, int debut, int fin, String empreinte) {
        this.nom = nom;
        this.debut = debut;
        this.fin = fin;
        this.empreinte = empreinte;
    }

    /** Une classe dont seul le nom est connu. */
    static Type rien(String nom) {
        return new Type(nom, 0, 0, "");
    }

    Type placer(Source fichier, String sien, int suite) {
        source = fichier;
        texte = sien;
        reste = suite;
        return this;
    }

    /** Son nom complet, avec des « / » entre les paquets. */
    String chemin() {
        return (source.paquet.isEmpty() ? "" : source.paquet.replace('.', '/') + "/") + nom;
    }

    /** Le texte, avec ces membres ajoutés à la fin de la classe. */
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

    /** Nombre de ces méthodes que la classe contient. */
    long parmi(Set<String> attendues) {
        return attendues.stream().filter(nommees()::contains).count();
    }
}
