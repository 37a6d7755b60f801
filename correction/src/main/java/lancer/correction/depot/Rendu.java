package lancer.correction.depot;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.UUID;
import java.util.stream.Collectors;
import lancer.correction.enfant.Texte;

/** Le travail rendu par un étudiant, une ligne de la classe : ses sources, ou la raison pour laquelle elles sont illisibles. */
public final class Rendu {

    /** Nombre maximal de caractères d'un nom : avec le suffixe de Moodle, il tient en 255 octets. */
    public static final int NOM_MAX = 70;

    /** Identifiant unique : le numéro que donne Moodle ou, à défaut, le nom exact de l'entrée. */
    public final String id;
    /** Le nom de l'étudiant, de l'entrée à défaut, en une ligne courte. */
    public final String nom;
    /** Les entrées de la classe qui sont ce rendu, et le chemin de chacune dans ce rendu. */
    public final Map<String, String> entrees = new TreeMap<>();
    /** Les fichiers .java, par chemin. */
    public final Map<String, byte[]> sources = new TreeMap<>();
    /** Les classes dont le fichier est vide, et pourquoi ; ce fichier n'est pas parmi les sources. */
    public final Map<String, String> vides = new TreeMap<>();
    /** Ce qui n'a pu être lu, et pourquoi. Sans aucune source, le rendu ne peut être jugé. */
    public final List<String> refus = new ArrayList<>();
    public final List<String> remarques = new ArrayList<>();
    /** Les fichiers et les dossiers d'outils qu'il fallait enlever. */
    public final Set<String> outils = new TreeSet<>();
    /** Les bibliothèques (.jar) jointes, par leur nom. */
    public final Set<String> bibliotheques = new TreeSet<>();

    public Rendu(String id, String nom) {
        this.id = id;
        String propre = Texte.protege(nom, NOM_MAX);
        this.nom = propre.isEmpty() ? "sans nom" : propre;
    }

    /** Lit ses fichiers, si rien ne l'a refusé. Ce qui arrive alors ne coûte que ce rendu. @param seul vrai si ce lieu est ce rendu */
    void lire(Lieu ici, boolean seul) {
        if (!refus.isEmpty()) {
            return;
        }
        try {
            Contenu contenu = new Contenu(this);
            ici.lire(seul ? ici.noms().keySet().stream().collect(Collectors.toMap(n -> n, n -> n)) : entrees, contenu);
            contenu.finir();
        } catch (RuntimeException | Error e) {
            sources.clear();
            refus.add(Texte.protege("arrêté : " + e) + " (en lisant ses fichiers)");
        }
    }

    /** Ce qui distingue ce rendu d'un autre : ses sources ou, sans sources, la raison. */
    public String empreinte() {
        ByteArrayOutputStream tout = new ByteArrayOutputStream();
        sources.forEach((chemin, octets) -> {
            tout.writeBytes(chemin.getBytes(StandardCharsets.UTF_8));
            tout.writeBytes(octets);
        });
        tout.writeBytes(refus.toString().getBytes(StandardCharsets.UTF_8));
        return UUID.nameUUIDFromBytes(tout.toByteArray()).toString();
    }
}
