package lancer.correction.depot;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.correction.enfant.Texte;
import lancer.correction.modele.SourcesDuCours;
import org.apache.commons.compress.archivers.zip.UnsupportedZipFeatureException;
import org.apache.commons.compress.archivers.zip.ZipArchiveEntry;
import org.apache.commons.compress.archivers.zip.ZipFile;
import org.apache.commons.compress.archivers.zip.ZipMethod;
import org.apache.commons.io.function.IOSupplier;

/**
 * Lit le contenu d'un rendu. Ce qui n'est pas lu (images, bibliothèques, documents) ne compte pas dans sa taille. Les noms qui commencent
 * par un point et {@code __MACOSX} ne comptent jamais.
 */
final class Contenu {

    /** Milieu d'une remarque qui commence par un fichier, et qui finit par la raison de ne pas le lire. */
    static final String DE_COTE = " : laissé de côté, ";
    /** Fin d'un refus : ce fichier est une archive que l'enseignant doit déplier. */
    static final String A_DEPLIER = " : à déplier à la main ; seuls les dossiers et les .zip le sont ici";

    /** Taille maximale de ce qui est lu d'un rendu, décompressé, en octets. */
    private static final long OCTETS_MAX = 50L << 20;
    /** Taille maximale des sources d'un rendu, en octets. */
    private static final int PESEE_MAX = 6 << 20;
    /** Nombre maximal de sources d'un rendu. */
    private static final int SOURCES_MAX = 300;
    private static final int EMBOITEMENT_MAX = 3;
    private static final int CITES_MAX = 5;
    private static final Pattern AUTRE_ARCHIVE =
            Pattern.compile("(?is).*\\.(rar|(7z|zip)\\.\\d+|7z|z\\d\\d|tar|tgz|tbz2?|txz|gz|xz|bz2|zst|lzma|zipx|ace|arj|cab|dmg)");
    /** Ce que des outils ajoutent, et que l'énoncé demande d'enlever. Un dossier de ce nom qui a des sources n'en est pas. */
    private static final Set<String> DOSSIERS_OUTILS =
            Set.of(".idea", ".settings", ".metadata", ".vscode", "target", "bin", "build", "out");
    /** Fichiers qui ne sont pas jugés : les tests qui notent sont ceux de la correction. */
    private static final Pattern DE_TEST = Pattern.compile("(?is)(?:^|.*/)(?:src/test/.*|(?:Tests|Demande|Causes|Repetition|Valeurs|Etapes"
            + "|module-info|package-info)\\.java)");
    private static final Pattern OUTIL = Pattern.compile("(?s)\\.classpath|\\.project|.*\\.iml|.*\\.class");

    private final Rendu rendu;
    /** Les fichiers et les dossiers d'outils, par leur chemin, et leur nom. */
    private final Map<String, String> outils = new TreeMap<>();
    private final Set<String> autres = new TreeSet<>();
    /** Les premières archives .jar, qui peuvent avoir les sources d'un rendu sans autres sources. */
    private final Map<String, IOSupplier<InputStream>> jars = new TreeMap<>();
    private long octets;

    Contenu(Rendu rendu) {
        this.rendu = rendu;
    }

    static String joindre(String a, String b) {
        return a.isEmpty() || b.isEmpty() ? a + b : a + "/" + b;
    }

    /** @return faux s'il n'y a plus rien à lire de ce rendu */
    boolean prendre(ZipFile zip, ZipArchiveEntry entree, String chemin, String archive, int niveau) {
        String nom = Lieu.nom(entree);
        if (List.of(nom.split("/")).contains("..")) {
            refuser("entrée refusée, qui sort de son archive : " + nom);
            return true;
        } else if (Lieu.absolu(entree)) {
            refuser("des noms absolus dans l'archive (" + Texte.protege(entree.getName()).split("[/\\\\]", 2)[0]
                    + "/…) : lus sans leur racine");
        }
        return prendre(chemin + (nom.endsWith("/") ? "/" : ""), entree.isUnixSymlink(), () -> ouvrir(zip, entree), archive, niveau);
    }

    private static InputStream ouvrir(ZipFile zip, ZipArchiveEntry entree) throws IOException {
        try {
            return zip.getInputStream(entree);
        } catch (UnsupportedZipFeatureException | LinkageError e) {
            // une bibliothèque facultative, qui n'est pas ici, lirait XZ ou Zstandard
            if (entree.getGeneralPurposeBit().usesEncryption()) {
                throw new UnsupportedOperationException("protégée par un mot de passe");
            }
            ZipMethod methode = ZipMethod.getMethodByCode(entree.getMethod());
            throw new UnsupportedOperationException("comprimée d'une façon qui n'est pas lue ici ("
                    + (methode == null ? entree.getMethod() : methode) + ")");
        }
    }

    /** @return faux s'il n'y a plus rien à lire de ce rendu */
    boolean parcourir(Path lieu, String chemin) {
        if (!Lieu.dossier(lieu)) {
            return prendre(chemin, !Files.isRegularFile(lieu, LinkOption.NOFOLLOW_LINKS), () -> Files.newInputStream(lieu), "", 0);
        }
        boolean suite = prendre(chemin + "/", false, null, "", 0);
        return suite && (Lieu.cache(lieu.getFileName().toString()) || Lieu.enfants(lieu).entrySet().stream()
                .allMatch(e -> parcourir(e.getValue(), joindre(chemin, e.getKey()))));
    }

    /**
     * Lit une entrée, si c'est une source ou une archive. Une entrée illisible n'empêche pas de lire les autres.
     *
     * @param chemin dans le rendu ; celui d'un dossier finit par « / »
     * @param archive celle qui contient l'entrée, vide si c'est celle de la classe
     * @return faux s'il n'y a plus rien à lire de ce rendu
     */
    private boolean prendre(String chemin, boolean lien, IOSupplier<InputStream> contenu, String archive, int niveau) {
        if (octets > OCTETS_MAX) {
            return false;
        }
        List<String> noms = List.of(chemin.split("/"));
        String fin = noms.isEmpty() ? "" : noms.get(noms.size() - 1);
        retenirLesOutils(noms);
        if (chemin.endsWith("/") || noms.stream().anyMatch(Lieu::cache)) {
            return true;
        }
        String bas = fin.toLowerCase(Locale.ROOT);
        boolean zip = bas.endsWith(".zip");
        if (bas.endsWith(".jar")) {
            rendu.bibliotheques.add(Texte.protege(fin, Rendu.NOM_MAX));
            if (jars.size() < CITES_MAX) {
                jars.put(fin, contenu);
            }
        }
        if (lien) {
            refuser("lien refusé : " + fin);
        } else if (AUTRE_ARCHIVE.matcher(fin).matches()) {
            refuser(chemin + A_DEPLIER + ", dans un dossier de même nom que ce rendu : « "
                    + Texte.protege(rendu.entrees.keySet().iterator().next(), Rendu.NOM_MAX) + " »");
        } else if (zip || bas.endsWith(".java") && !DE_TEST.matcher(chemin).matches()) {
            lire(chemin, contenu, archive, niveau);
        } else if (autres.size() < CITES_MAX || bas.matches("(?s).*\\.(kt|class)")) {
            autres.add(Texte.protege(fin, Rendu.NOM_MAX));
        }
        return true;
    }

    /** Ce qu'il faut savoir d'une archive .jar : le nombre de ses sources, et le remède ; vide si elle n'en a pas. */
    private static String sources(String nom, IOSupplier<InputStream> contenu) {
        try (InputStream flux = contenu.get();
                ZipFile zip = ZipFile.builder().setByteArray(flux.readNBytes((int) OCTETS_MAX)).get()) {
            long sources = Collections.list(zip.getEntries()).stream().filter(e -> e.getName().endsWith(".java")).count();
            return sources == 0 ? "" : " ; " + Texte.protege(nom, Rendu.NOM_MAX) + ", qui en a " + sources + ", est à renommer en .zip";
        } catch (IOException | RuntimeException e) {
            return "";
        }
    }

    private void retenirLesOutils(List<String> noms) {
        for (int k = 0; k < noms.size(); k++) {
            String nom = noms.get(k);
            if (DOSSIERS_OUTILS.contains(nom) || k == noms.size() - 1 && OUTIL.matcher(nom).matches()) {
                outils.putIfAbsent(DOSSIERS_OUTILS.contains(nom) ? String.join("/", noms.subList(0, k + 1)) : nom,
                        Texte.protege(nom, Rendu.NOM_MAX));
                return;
            }
        }
    }

    private void lire(String chemin, IOSupplier<InputStream> contenu, String archive, int niveau) {
        boolean source = chemin.toLowerCase(Locale.ROOT).endsWith(".java");
        try (InputStream flux = contenu.get()) {
            byte[] lus = flux.readNBytes((int) OCTETS_MAX + 1);
            octets += lus.length;
            if (source) {
                ajouter(chemin, lus);
            } else if (octets <= OCTETS_MAX) {
                deplier(lus, chemin, niveau);
            }
        } catch (UnsupportedOperationException e) {
            refuser((archive.isEmpty() ? chemin : archive) + " : archive " + e.getMessage() + " ; à déplier à la main");
        } catch (IOException | RuntimeException e) {
            refuser(chemin + " : " + (source ? "illisible" : "archive illisible, abîmée ou protégée par un mot de passe")
                    + " (" + e.getMessage() + ")");
        }
    }

    private void ajouter(String chemin, byte[] lus) {
        String texte = Source.decoder(lus).replace("\0", "");
        boolean renvoi = texte.startsWith("version https://git-lfs.");
        if (renvoi || texte.isBlank()) {
            rendu.vides.put(chemin.replaceFirst("(?s).*/", "").replaceFirst("(?i)\\.java$", ""),
                    renvoi ? "un renvoi de Git LFS, sans le texte" : "vide");
        } else if (!Arrays.equals(lus, Objects.requireNonNullElse(rendu.sources.putIfAbsent(chemin, lus), lus))) {
            refuser(chemin + DE_COTE + "un autre fichier a ce chemin, dans ce dossier ou dans une archive");
        }
    }

    /** D'un rendu démesuré, garde d'abord les dossiers qui ont des classes du cours : le reste est une bibliothèque. */
    private void alleger() {
        Set<String> duCours = rendu.sources.keySet().stream().filter(s -> SourcesDuCours.A_COMPLETER.contains(s
                .replaceFirst("(?s).*/", "").replace(".java", ""))).map(Contenu::dossier).collect(Collectors.toSet());
        long pesee = 0;
        int nombre = 0;
        Map<String, Integer> laisses = new TreeMap<>();
        for (String chemin : rendu.sources.keySet().stream().sorted(Comparator.comparing(s -> !duCours.contains(dossier(s))))
                .collect(Collectors.toList())) {
            pesee += rendu.sources.get(chemin).length;
            if (++nombre > SOURCES_MAX || pesee > PESEE_MAX) {
                pesee -= rendu.sources.remove(chemin).length;
                String[] noms = chemin.split("/");
                laisses.merge(noms[0] + (noms.length > 2 ? "/" + noms[1] : ""), 1, Integer::sum);
            }
        }
        laisses.forEach((ou, combien) -> refuser(ou + DE_COTE + Texte.compter(combien, "fichier") + " au-delà de "
                + SOURCES_MAX + ", ou de " + (PESEE_MAX >> 20) + " Mo de sources : une bibliothèque ?"));
    }

    private static String dossier(String chemin) {
        return chemin.substring(0, chemin.lastIndexOf('/') + 1);
    }

    private void deplier(byte[] archive, String chemin, int niveau) throws IOException {
        String sorte = sorte(archive);
        if (!sorte.isEmpty()) {
            refuser(chemin + " : c'est une archive " + sorte + ", malgré son nom ; " + A_DEPLIER.substring(3));
            return;
        } else if (niveau >= EMBOITEMENT_MAX) {
            refuser(chemin + " : trop d'archives l'une dans l'autre");
            return;
        }
        try (ZipFile zip = ZipFile.builder().setByteArray(archive).get()) {
            String dans = chemin.substring(0, chemin.length() - ".zip".length());
            Collections.list(zip.getEntries()).stream()
                    .allMatch(e -> prendre(zip, e, joindre(dans, Lieu.nom(e)).replaceFirst("/$", ""), chemin, niveau + 1));
        }
    }

    private void refuser(String pourquoi) {
        if (!rendu.refus.contains(pourquoi)) {
            rendu.refus.add(pourquoi);
        }
    }

    /** La sorte d'une archive qui n'est pas un zip, d'après ses premiers octets ; vide si c'en est un, ou si elle est abîmée. */
    private static String sorte(byte[] archive) {
        String debut = new String(archive, 0, Math.min(6, archive.length), StandardCharsets.ISO_8859_1);
        if (debut.startsWith("Rar!")) {
            return "RAR";
        }
        if (debut.startsWith("7z\u00BC\u00AF")) {
            return "7z";
        }
        return debut.startsWith("\u001F\u008B") ? "gzip" : "";
    }

    /** Conclut la lecture. */
    void finir() {
        outils.keySet().removeIf(dossier -> rendu.sources.keySet().stream().anyMatch(s -> s.startsWith(dossier + "/")));
        alleger();
        if (octets > OCTETS_MAX) {
            rendu.refus.add("plus de " + (OCTETS_MAX >> 20) + " Mo de sources et d'archives une fois dépliées");
            rendu.sources.clear();
        } else if (rendu.sources.isEmpty() && rendu.refus.isEmpty()) {
            autres.addAll(rendu.bibliotheques);
            autres.addAll(outils.values());
            rendu.refus.add(sansSource());
        } else if (!finissantPar(".kt").isEmpty()) {
            refuser("des sources Kotlin, qui ne sont pas jugées : " + finissantPar(".kt"));
        }
        if (!rendu.vides.isEmpty() && !rendu.sources.isEmpty()) {
            refuser(vides());
        }
        rendu.outils.addAll(outils.values());
        Texte.abreger(rendu.refus);
        Texte.abreger(rendu.remarques);
    }

    /** « vides : Point, Vecteur ; un renvoi de Git LFS, sans le texte : Sphere ». */
    private String vides() {
        Map<String, String> noms = new TreeMap<>();
        rendu.vides.forEach((nom, pourquoi) -> noms.merge(pourquoi, Texte.protege(nom, Rendu.NOM_MAX), (a, b) -> a + ", " + b));
        return noms.entrySet().stream().map(e -> (e.getKey().equals("vide") ? "des fichiers vides" : e.getKey()) + " : " + e.getValue())
                .collect(Collectors.joining(" ; "));
    }

    private String finissantPar(String fin) {
        return autres.stream().filter(a -> a.endsWith(fin)).limit(CITES_MAX).collect(Collectors.joining(", "));
    }

    /** Ce que contient un rendu sans source. */
    private String sansSource() {
        String debut = "aucun fichier .java dans ce rendu";
        String deSources = jars.entrySet().stream().map(j -> sources(j.getKey(), j.getValue())).collect(Collectors.joining());
        if (!rendu.vides.isEmpty()) {
            return vides();
        } else if (!deSources.isEmpty()) {
            return debut + deSources;
        } else if (!finissantPar(".kt").isEmpty()) {
            return debut + " : des sources Kotlin, et non Java (" + finissantPar(".kt") + ")";
        } else if (!finissantPar(".class").isEmpty()) {
            return debut + " : des classes compilées, sans leurs sources (" + finissantPar(".class") + ")";
        }
        return debut + " ; " + (autres.isEmpty() ? "il est vide"
                : "il contient : " + autres.stream().limit(CITES_MAX).collect(Collectors.joining(", ")));
    }
}
