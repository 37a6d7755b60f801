package lancer.correction.depot;

import java.io.DataInputStream;
import java.io.IOException;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import lancer.correction.enfant.Contenu;
import lancer.correction.enfant.Echange;
import lancer.correction.isolement.Arret;

/** Le travail rendu par un étudiant : ses sources, ou la raison pour laquelle elles sont illisibles. */
public final class Rendu {

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

    /** Lit ses fichiers. Tout ce qui arrive alors ne coûte que ce rendu. @param noms voir {@link Contenu} */
    void lire(Depot.Acces acces, Map<String, byte[]> noms) {
        try {
            DataInputStream contenu = noms.isEmpty() ? null : acces.demander(noms);
            String faute = contenu == null ? "aucun fichier dans ce rendu" : Echange.lireTexte(contenu);
            if (!faute.isEmpty()) {
                refus.add(faute);
                return;
            }
            sources.putAll(Echange.lireTout(contenu));
            Iterator<?> listes = ((List<?>) Echange.lireValeur(contenu, o -> null)).iterator();
            for (Collection<String> liste : List.of(refus, remarques, outils, bibliotheques)) {
                ((List<?>) listes.next()).forEach(texte -> liste.add((String) texte));
            }
        } catch (Arret | IOException | RuntimeException | Error e) {
            sources.clear();
            refus.add((e instanceof Arret ? e.getMessage() : Echange.protege("arrêté : " + e)) + " (en lisant ses fichiers)");
        }
    }
}
