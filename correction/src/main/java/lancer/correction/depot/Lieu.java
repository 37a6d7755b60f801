package lancer.correction.depot;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.commons.compress.archivers.zip.ZipArchiveEntry;
import org.apache.commons.compress.archivers.zip.ZipFile;

/**
 * L'endroit où sont les rendus d'une classe : un dossier, ou un dossier d'une archive. Un dossier ou une archive qui n'en contient qu'un
 * autre est ouvert, autant de fois qu'il le faut, sauf si Moodle lui a donné le nom d'un rendu.
 */
final class Lieu implements AutoCloseable {

    /** Taille maximale d'une archive seule dans une archive, en octets. */
    private static final int CLASSE_MAX = 200 << 20;

    /** Le début d'un nom absolu, sous Linux ou Windows. */
    private static final Pattern RACINE = Pattern.compile("^([A-Za-z]:)?/+|^[A-Za-z]:");

    private Path dossier;
    private ZipFile zip;
    private String debut = "";
    /** Les entrées de l'archive, par leur premier nom à partir d'ici. */
    private Map<String, List<ZipArchiveEntry>> entrees;

    /** @param entrer faux si tout cet endroit est un seul rendu */
    Lieu(Path ici, boolean entrer) throws IOException {
        dossier = dossier(ici) ? ici : null;
        zip = dossier == null ? ZipFile.builder().setPath(ici).get() : null;
        for (Map<String, Boolean> noms = noms(); entrer && noms.size() == 1; noms = noms()) {
            String seul = noms.keySet().iterator().next();
            boolean fichier = noms.get(seul);
            entrer = !Depot.deMoodle(seul) && (!fichier || seul.toLowerCase(Locale.ROOT).endsWith(".zip"));
            if (entrer && fichier) {
                zip = zip == null ? ZipFile.builder().setPath(enfants(dossier).get(seul)).get() : emboitee(seul);
                dossier = null;
                debut = "";
            } else if (entrer) {
                dossier = zip == null ? enfants(dossier).get(seul) : null;
                debut += zip == null ? "" : seul + "/";
            }
        }
    }

    private ZipFile emboitee(String nom) throws IOException {
        byte[] octets;
        try (InputStream flux = zip.getInputStream(entrees.get(nom).get(0))) {
            octets = flux.readNBytes(CLASSE_MAX + 1);
        }
        zip.close();
        if (octets.length > CLASSE_MAX) {
            throw new IOException(nom + Contenu.A_DEPLIER);
        }
        return ZipFile.builder().setByteArray(octets).get();
    }

    /** Les noms qui comptent ; vrai pour un fichier. */
    Map<String, Boolean> noms() {
        Map<String, Boolean> noms = new LinkedHashMap<>();
        if (zip == null) {
            enfants(dossier).forEach((nom, chemin) -> noms.put(nom, !dossier(chemin)));
        } else {
            entrees = Collections.list(zip.getEntries()).stream().filter(e -> nom(e).startsWith(debut) && nom(e).length() > debut.length())
                    .collect(Collectors.groupingBy(e -> nom(e).substring(debut.length()).split("/", 2)[0], LinkedHashMap::new,
                            Collectors.toList()));
            entrees.forEach((nom, siennes) -> noms.put(nom, siennes.stream().allMatch(e -> nom(e).equals(debut + nom))));
        }
        noms.keySet().removeIf(Lieu::cache);
        return noms;
    }

    /** Lit ces entrées. @param noms le chemin de chacune dans le rendu */
    void lire(Map<String, String> noms, Contenu contenu) {
        noms.forEach((nom, chemin) -> {
            if (zip == null) {
                contenu.parcourir(enfants(dossier).get(nom), chemin);
            } else {
                entrees.get(nom).stream().allMatch(e -> contenu.prendre(zip, e, Contenu.joindre(chemin,
                        nom(e).substring(debut.length() + nom.length()).replaceFirst("^/", "")), "", 0));
            }
        });
    }

    static boolean dossier(Path chemin) {
        return Files.isDirectory(chemin, LinkOption.NOFOLLOW_LINKS);
    }

    /** Dit si un système ou un outil a ajouté ce fichier ou ce dossier, qui ne compte pas. */
    static boolean cache(String nom) {
        return nom.startsWith(".") || nom.equals("__MACOSX");
    }

    /** Le contenu d'un dossier, par ordre alphabétique, sans suivre les liens. */
    static Map<String, Path> enfants(Path dossier) {
        Map<String, Path> enfants = new LinkedHashMap<>();
        try (Stream<Path> flux = Files.list(dossier)) {
            for (Path f : flux.sorted().collect(Collectors.toList())) {
                String nom = f.getFileName().toString();
                while (enfants.putIfAbsent(nom, f) != null) {
                    // deux noms différents peuvent se lire pareils, si la langue de la machine n'a pas leurs caractères
                    nom = "'" + nom;
                }
            }
        } catch (IOException | RuntimeException e) {
            // le reste du dossier est lu quand même
        }
        return enfants;
    }

    /** Le nom d'une entrée à partir d'ici, avec des « / » même si elle vient de Windows : sans « ./ », ni racine. */
    static String nom(ZipArchiveEntry entree) {
        return RACINE.matcher(brut(entree)).replaceFirst("").replaceAll("(?<![^/])\\./", "");
    }

    /** Dit si ce nom part de la racine d'une machine, au lieu de l'archive. */
    static boolean absolu(ZipArchiveEntry entree) {
        return RACINE.matcher(brut(entree)).find();
    }

    private static String brut(ZipArchiveEntry entree) {
        return entree.getName().replace('\\', '/');
    }

    @Override
    public void close() throws IOException {
        if (zip != null) {
            zip.close();
        }
    }
}
