package lancer.correction.depot;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import lancer.correction.enfant.Echange;

/** Travail qu'un étudiant a rendu : ses sources, ou pourquoi on ne peut les lire. */
public final class Rendu {

    /** Octets qu'un rendu peut peser au plus, une fois déplié, et combien de fichiers il peut avoir. */
    static final long OCTETS_MAX = 50L << 20;
    private static final int FICHIERS_MAX = 20_000;
    private static final int SOURCES_MAX = 500;
    private static final int PESEE_MAX = 6 << 20;
    /** Signes d'un nom : au plus 255 octets, une fois suivi de ce qu'y ajoute Moodle. */
    private static final int NOM_MAX = 70;

    /** Identifiant qui le distingue des autres : le numéro de Moodle, ou à défaut le nom du dossier, en une ligne. */
    public final String id;
    public final String nom;
    /** Les fichiers .java, par chemin. */
    public final Map<String, byte[]> sources = new TreeMap<>();
    /** Ce qui n'a pu être lu, et pourquoi : à regarder ; s'il n'y a aucune source, ce rendu ne peut être jugé. */
    public final List<String> refus = new ArrayList<>();
    public final List<String> remarques = new ArrayList<>();
    /** Les fichiers et les dossiers que les outils ajoutent, et qu'il fallait enlever. */
    public final Set<String> outils = new TreeSet<>();
    /** Les bibliothèques (.jar) que l'étudiant a jointes, par leur nom. */
    public final Set<String> bibliotheques = new TreeSet<>();
    /** Octets qu'il pèse, une fois déplié. */
    long octets;
    private int fichiers;
    private long pesee;

    public Rendu(String id, String nom) {
        this.id = id;
        this.nom = nom;
    }

    /** Un nom d'étudiant, de dossier ou d'archive, en une ligne, et court. */
    static String propre(String nom) {
        String propre = Echange.protege(nom, NOM_MAX);
        return propre.isEmpty() ? "sans nom" : propre;
    }

    /** Le début, sans fin de nom, du nom de tout fichier que l'on écrit pour lui. @param rang dans la classe : aucun autre n'a le même */
    public String fichier(int rang) {
        String lettres = Normalizer.normalize(id, Normalizer.Form.NFD).replaceAll("\\p{M}", "").replaceAll("[^A-Za-z0-9]+", "-");
        return String.format("%03d-%s", rang + 1, lettres);
    }

    /** @return faux si c'en est un de trop, par son nombre ou par son poids */
    boolean ajouter(String chemin, byte[] contenu) {
        pesee += contenu.length;
        if (sources.size() >= SOURCES_MAX || pesee > PESEE_MAX) {
            return false;
        }
        sources.put(chemin, contenu);
        return true;
    }

    /** Conclut : ce qu'on en dit tient en peu de lignes, quoi qu'il contienne. */
    void conclure() {
        if (octets > OCTETS_MAX || fichiers > FICHIERS_MAX) {
            refus.add(octets > OCTETS_MAX ? "plus de " + (OCTETS_MAX >> 20) + " Mo une fois déplié"
                    : "plus de " + FICHIERS_MAX + " fichiers");
            sources.clear();
        } else if (sources.isEmpty() && refus.isEmpty()) {
            refus.add("aucun fichier .java dans ce rendu");
        }
        Echange.abreger(refus);
        Echange.abreger(remarques);
    }

    /** Compte un fichier de plus. @return faux si c'en est un de trop, ou si tout ce qui est rendu, une fois déplié, est trop gros */
    boolean compter(long deplus) {
        octets += deplus;
        fichiers++;
        return octets <= OCTETS_MAX && fichiers <= FICHIERS_MAX;
    }
}
