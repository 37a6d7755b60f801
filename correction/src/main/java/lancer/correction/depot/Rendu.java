package lancer.correction.depot;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Ce qu'un étudiant a rendu : ses sources, ou pourquoi on ne peut les lire. */
public final class Rendu {

    private final String id;
    private final String nom;
    private final Map<String, byte[]> sources = new TreeMap<>();
    private final List<String> refus = new ArrayList<>();
    private final List<String> remarques = new ArrayList<>();
    private long octets;

    /** @param id ce qui le distingue des autres : le numéro de Moodle, ou à défaut le nom du dossier */
    public Rendu(String id, String nom) {
        this.id = id;
        this.nom = nom;
    }

    public String getId() {
        return id;
    }

    public String getNom() {
        return nom;
    }

    /** Les fichiers .java, par chemin. */
    public Map<String, byte[]> getSources() {
        return Collections.unmodifiableMap(sources);
    }

    /** Pourquoi ce rendu ne peut être jugé ; vide s'il peut l'être. */
    public List<String> getRefus() {
        return refus;
    }

    public List<String> getRemarques() {
        return remarques;
    }

    void ajouter(String chemin, byte[] contenu) {
        sources.put(chemin, contenu);
    }

    void oublierSources() {
        sources.clear();
    }

    /** @return faux si tout ce qui est rendu, une fois déplié, dépasse la limite */
    boolean compter(long deplus) {
        octets += deplus;
        return octets <= Archive.OCTETS_MAX;
    }
}
