package lancer.scene;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Les objets et les lampes d'un fichier, dans son ordre, chacun avec sa section. */
public final class Origines {

    /** Début du refus d'une valeur qui n'est dans aucun fichier. */
    private static final String REFUS = "valeur refusée";

    private final List<Object> choses = new ArrayList<>();
    private final List<Origine> lues = new ArrayList<>();
    final LecteurSections lecteur;
    private final boolean avecTexte;
    /** Le rang de chaque objet ou lampe ; table construite à la première demande. */
    private Map<Object, Integer> rangs;

    /** Une section : son nom, sa ligne dans le fichier et, s'il est gardé, son texte en UTF-8, une ligne par clé. */
    static final class Origine {
        final String nom;
        final int ligne;
        private final byte[] octets;

        Origine(SectionLue section, int ligne, boolean avecTexte) {
            nom = section.nom;
            this.ligne = ligne;
            octets = avecTexte ? section.ecrire("\n").getBytes(StandardCharsets.UTF_8) : null;
        }

        @Override
        public String toString() {
            return "[" + nom + "] ligne " + ligne;
        }
    }

    /** Celles d'une scène sans fichier. */
    public Origines() {
        this(null, false);
    }

    /** @param avecTexte vrai pour garder le texte des sections */
    Origines(LecteurSections lecteur, boolean avecTexte) {
        this.lecteur = lecteur;
        this.avecTexte = avecTexte;
    }

    /** Les mêmes, où une section et sa chose en remplacent une autre. */
    Origines(Origines autres, int rang, Object nouvelle, SectionLue section) {
        this(autres.lecteur, true);
        choses.addAll(autres.choses);
        choses.set(rang, nouvelle);
        lues.addAll(autres.lues);
        lues.set(rang, new Origine(section, autres.lues.get(rang).ligne, true));
    }

    /** Les mêmes, où des choses en remplacent d'autres. */
    Origines remplacer(Map<Object, Object> autres) {
        Origines faites = new Origines(lecteur, avecTexte);
        choses.forEach(chose -> faites.choses.add(autres.getOrDefault(chose, chose)));
        faites.lues.addAll(lues);
        return faites;
    }

    void ajouter(Object chose, SectionLue section) {
        choses.add(chose);
        lues.add(new Origine(section, section.ligne, avecTexte));
    }

    public int getNombre() {
        return choses.size();
    }

    public Object getChose(int rang) {
        return choses.get(rang);
    }

    /** Le rang de cet objet ou de cette lampe dans le fichier ; −1 s'il n'en vient pas. */
    public synchronized int getRang(Object chose) {
        if (rangs == null) {
            rangs = new IdentityHashMap<>(choses.size());
            IntStream.range(0, choses.size()).forEach(k -> rangs.putIfAbsent(choses.get(k), k));
        }
        return rangs.getOrDefault(chose, -1);
    }

    /** La section de ce rang, avec ses changements. */
    public SectionLue getSection(int rang) {
        String nom = lues.get(rang).nom;
        String[] lignes = new String(lues.get(rang).octets, StandardCharsets.UTF_8).split("\n");
        SectionLue section = new SectionLue(REFUS, nom, 0, lecteur.cles(LecteurSections.type(nom)));
        for (int k = 1; k < lignes.length; k++) {
            int egal = lignes[k].indexOf('=');
            section.ajouter(lignes[k].substring(0, egal), lignes[k].substring(egal + 1), 0);
        }
        return section;
    }

    /** Nom de cette section ; si elle n'a que son type, sa ligne la situe. */
    public String getNom(int rang) {
        String nom = lues.get(rang).toString();
        return nom.indexOf(' ') < nom.indexOf(']') ? nom.substring(0, nom.lastIndexOf(']') + 1) : nom;
    }

    /** Les clés permises dans les sections des types présents. */
    public Stream<String> getCles() {
        return lecteur.cles().stream().flatMap(List::stream).distinct();
    }

    /** Les rangs des sections qui diffèrent de celles-ci. */
    IntStream getChanges(Origines avant) {
        return IntStream.range(0, lues.size()).filter(k -> lues.get(k) != avant.lues.get(k)
                && !Arrays.equals(lues.get(k).octets, avant.lues.get(k).octets));
    }

    /** Le rang de la section de ce nom, cherchée d'abord à ce rang-là ; −1 s'il n'y en a pas. */
    int getRangDuNom(String nom, int probable) {
        return IntStream.concat(IntStream.of(Math.min(probable, lues.size() - 1)), IntStream.range(0, lues.size()))
                .filter(k -> k >= 0 && lues.get(k).nom.equals(nom)).findFirst().orElse(-1);
    }

    /** Texte de la forme {@code [Sphere ambre] ligne 52} ; {@code null} si cet objet ne vient pas d'un fichier. */
    public String de(Object chose) {
        return getRang(chose) < 0 ? null : lues.get(getRang(chose)).toString();
    }
}
