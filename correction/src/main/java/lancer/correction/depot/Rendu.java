package lancer.correction.depot;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import lancer.correction.enfant.Echange;

/** Le travail rendu par un étudiant : ses sources, ou la raison pour laquelle elles sont illisibles. */
public final class Rendu {

    /** Taille maximale d'un rendu décompressé, en octets, et nombre maximal de fichiers. */
    static final long OCTETS_MAX = 50L << 20;
    private static final int FICHIERS_MAX = 20_000;
    private static final int SOURCES_MAX = 500;
    private static final int PESEE_MAX = 6 << 20;
    /** Nombre maximal de caractères d'un nom : avec le suffixe de Moodle, il tient en 255 octets. */
    private static final int NOM_MAX = 70;

    /** Identifiant unique : le numéro de Moodle ou, à défaut, le nom du dossier, en une ligne. */
    public final String id;
    public final String nom;
    /** Les fichiers .java, par chemin. */
    public final Map<String, byte[]> sources = new TreeMap<>();
    /** Ce qui n'a pu être lu, et pourquoi. Sans aucune source, le rendu ne peut être jugé. */
    public final List<String> refus = new ArrayList<>();
    public final List<String> remarques = new ArrayList<>();
    /** Les fichiers et les dossiers d'outils qu'il fallait enlever. */
    public final Set<String> outils = new TreeSet<>();
    /** Les bibliothèques (.jar) jointes, par leur nom. */
    public final Set<String> bibliotheques = new TreeSet<>();
    /** Taille du rendu décompressé, en octets. */
    long octets;
    private int fichiers;
    private long pesee;

    public Rendu(String id, String nom) {
        this.id = id;
        this.nom = nom;
    }

    /** Un nom d'étudiant, de dossier ou d'archive, en une ligne courte. */
    static String propre(String nom) {
        String propre = Echange.protege(nom, NOM_MAX);
        return propre.isEmpty() ? "sans nom" : propre;
    }

    /** Le début, sans extension, du nom des fichiers écrits pour ce rendu. @param rang dans la classe, différent pour chaque rendu */
    public String fichier(int rang) {
        String lettres = Normalizer.normalize(id, Normalizer.Form.NFD).replaceAll("\\p{M}", "").replaceAll("[^A-Za-z0-9]+", "-");
        return String.format("%03d-%s", rang + 1, lettres);
    }

    /** @return faux s'il y a trop de sources, ou si elles sont trop grandes */
    boolean ajouter(String chemin, byte[] contenu) {
        pesee += contenu.length;
        if (sources.size() >= SOURCES_MAX || pesee > PESEE_MAX) {
            return false;
        }
        sources.put(chemin, contenu);
        return true;
    }

    /** Termine la lecture, et abrège les messages. */
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

    /** Compte un fichier de plus. @return faux s'il y a trop de fichiers, ou si le rendu décompressé est trop grand */
    boolean compter(long deplus) {
        octets += deplus;
        fichiers++;
        return octets <= OCTETS_MAX && fichiers <= FICHIERS_MAX;
    }
}
