package lancer.correction.enfant;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.compress.archivers.zip.UnsupportedZipFeatureException;
import org.apache.commons.compress.archivers.zip.ZipArchiveEntry;
import org.apache.commons.compress.archivers.zip.ZipFile;
import org.apache.commons.compress.archivers.zip.ZipMethod;
import org.apache.commons.io.function.IOSupplier;

/**
 * Lit des dossiers et des archives, dans une autre machine virtuelle, qui n'exécute aucun rendu. Le premier nom d'une demande est celui du
 * dossier ou de l'archive de la classe. Seul, il demande les noms que celle-ci contient. Les noms suivants demandent le contenu d'un rendu.
 */
public final class Contenu {

    /** Milieu d'une remarque qui commence par un fichier, et qui finit par la raison de ne pas le lire. */
    public static final String DE_COTE = " : laissé de côté, ";

    /** Taille maximale d'un rendu décompressé, en octets, et nombre maximal de fichiers. */
    private static final long OCTETS_MAX = 50L << 20;
    private static final int FICHIERS_MAX = 20_000;
    /** Nombre maximal d'entrées d'une archive, dossiers et fichiers d'outils compris. */
    private static final int FICHES_MAX = 200_000;
    private static final int SOURCE_MAX = 1 << 20;
    private static final int SOURCES_MAX = 500;
    private static final int PESEE_MAX = 6 << 20;
    private static final int CHEMIN_MAX = 1000;
    private static final int EMBOITEMENT_MAX = 3;
    /** Nombres maximaux de noms d'une classe, et de noms cités. */
    private static final int NOMS_MAX = 5000;
    private static final int CITES_MAX = 5;
    private static final int NOM_MAX = 70;
    private static final Pattern AUTRE_ARCHIVE =
            Pattern.compile("(?is).*\\.(rar|(7z|zip)\\.\\d+|7z|z\\d\\d|tar|tgz|tbz2?|txz|gz|xz|bz2|zst|lzma|zipx|ace|arj|cab|dmg)");
    /** Fichiers d'outils que l'énoncé demande d'enlever ; les dossiers ne sont pas lus. */
    private static final Set<String> DOSSIERS_OUTILS =
            Set.of(".idea", ".settings", ".metadata", ".vscode", "target", "bin", "build", "out");
    private static final Pattern OUTIL = Pattern.compile("(?s)\\.classpath|\\.project|.*\\.iml|.*\\.class");

    private final Set<String> refus = new LinkedHashSet<>();
    private final Set<String> remarques = new LinkedHashSet<>();
    private final Set<String> outils = new TreeSet<>();
    private final Set<String> bibliotheques = new TreeSet<>();
    private final Set<String> autres = new TreeSet<>();
    private final Map<String, byte[]> sources = new TreeMap<>();
    private long octets;
    private long pesee;
    private int fichiers;

    private Contenu() {
    }

    public static void main(String[] args) throws IOException {
        Echange.servir(demande -> repondre(Echange.lireTout(demande)));
    }

    /** La réponse est la faute de lecture, vide s'il n'y en a pas, puis ce qui est demandé. */
    public static Echange.Redaction repondre(Map<String, byte[]> demande) {
        if (demande.isEmpty()) {
            return reponse -> Echange.ecrireTexte(reponse, "");
        }
        Map<String, byte[]> rendu = new LinkedHashMap<>(demande);
        Path lieu = Path.of(rendu.keySet().iterator().next());
        rendu.remove(lieu.toString());
        Contenu contenu = new Contenu();
        Map<String, byte[]> noms = new LinkedHashMap<>();
        try (ZipFile zip = Files.isDirectory(lieu) ? null : ZipFile.builder().setPath(lieu).get()) {
            Map<String, Path> enfants = zip == null ? enfants(lieu) : Map.of();
            if (rendu.isEmpty()) {
                (zip == null ? enfants.entrySet().stream().map(e -> e.getKey() + (dossier(e.getValue()) ? "/" : ""))
                        : entrees(zip).map(Contenu::nom)).takeWhile(nom -> noms.size() < NOMS_MAX)
                        .forEach(nom -> noms.put(premier(nom), nom.indexOf('/') < 0 ? new byte[1] : new byte[0]));
            } else if (zip == null) {
                rendu.forEach((nom, debut) -> {
                    if (enfants.containsKey(nom)) {
                        contenu.parcourir(enfants.get(nom), nom, debut);
                    }
                });
            } else {
                entrees(zip).filter(e -> rendu.containsKey(premier(nom(e)))).allMatch(e -> contenu.prendre(zip, e, chemin(nom(e),
                        rendu.get(premier(nom(e)))), "", 0));
            }
        } catch (IOException | RuntimeException e) {
            return reponse -> Echange.ecrireTexte(reponse, String.valueOf(e.getMessage()));
        }
        return reponse -> {
            Echange.ecrireTexte(reponse, "");
            if (rendu.isEmpty()) {
                Echange.ecrireTout(reponse, noms);
            } else {
                contenu.ecrire(reponse);
            }
        };
    }

    private static String premier(String nom) {
        return nom.indexOf('/') < 0 ? nom : nom.substring(0, nom.indexOf('/'));
    }

    /** Le chemin, dans le rendu, de cette entrée, dont le premier nom devient ce début. */
    private static String chemin(String nom, byte[] debut) {
        return joindre(new String(debut, StandardCharsets.UTF_8), nom.indexOf('/') < 0 ? "" : nom.substring(nom.indexOf('/') + 1));
    }

    private static String joindre(String a, String b) {
        return a.isEmpty() ? b : b.isEmpty() ? a : a + "/" + b;
    }

    private static boolean dossier(Path chemin) {
        return Files.isDirectory(chemin, LinkOption.NOFOLLOW_LINKS);
    }

    /** Le contenu d'un dossier, par ordre alphabétique, sans suivre les liens. */
    private static Map<String, Path> enfants(Path dossier) {
        Map<String, Path> enfants = new LinkedHashMap<>();
        try (Stream<Path> flux = Files.list(dossier)) {
            for (Path f : flux.limit(FICHIERS_MAX).sorted().collect(Collectors.toList())) {
                String nom = f.getFileName().toString();
                while (enfants.putIfAbsent(nom, f) != null) {
                    // deux noms différents peuvent se lire pareils, si la langue de la machine n'a pas leurs caractères
                    nom = "'" + nom;
                }
            }
        } catch (IOException | UncheckedIOException e) {
            // le reste du dossier est lu quand même
        }
        return enfants;
    }

    private static Stream<ZipArchiveEntry> entrees(ZipFile zip) {
        return Collections.list(zip.getEntries()).stream();
    }

    /** Le nom d'une entrée, avec des « / » même si elle vient de Windows. */
    private static String nom(ZipArchiveEntry entree) {
        return entree.getName().replace('\\', '/');
    }

    private boolean prendre(ZipFile zip, ZipArchiveEntry entree, String chemin, String archive, int niveau) {
        return prendre(nom(entree), entree.isUnixSymlink(), entree.getSize(), () -> ouvrir(zip, entree), chemin, archive, niveau);
    }

    private static InputStream ouvrir(ZipFile zip, ZipArchiveEntry entree) throws IOException {
        try {
            return zip.getInputStream(entree);
        } catch (UnsupportedZipFeatureException | LinkageError e) {
            // une bibliothèque facultative, qui n'est pas ici, lirait XZ ou Zstandard
            ZipMethod methode = ZipMethod.getMethodByCode(entree.getMethod());
            throw new UnsupportedOperationException(entree.getGeneralPurposeBit().usesEncryption() ? "protégée par un mot de passe"
                    : "comprimée d'une façon qui n'est pas lue ici (" + (methode == null ? entree.getMethod() : methode) + ")");
        }
    }

    /** @return faux s'il n'y a plus rien à lire de ce rendu */
    private boolean parcourir(Path lieu, String nom, byte[] debut) {
        boolean lien = !Files.isRegularFile(lieu, LinkOption.NOFOLLOW_LINKS);
        if (!dossier(lieu)) {
            return prendre(nom, lien, lien ? 0 : lieu.toFile().length(), () -> Files.newInputStream(lieu), chemin(nom, debut), "", 0);
        }
        return prendre(nom + "/", false, 0, null, chemin(nom + "/", debut), "", 0) && enfants(lieu).entrySet().stream()
                .allMatch(e -> parcourir(e.getValue(), nom + "/" + e.getKey(), debut));
    }

    /**
     * Lit une entrée, si c'est une source ou une archive. Une entrée illisible n'empêche pas de lire les autres.
     *
     * @param nom depuis le dossier, ou dans l'archive ; celui d'un dossier finit par « / » ; @param chemin dans le rendu
     * @param taille annoncée, en octets ; négative si elle n'est pas annoncée
     * @param archive celle qui contient l'entrée, vide si c'est celle de la classe
     * @return faux s'il n'y a plus rien à lire de ce rendu
     */
    private boolean prendre(String nom, boolean lien, long taille, IOSupplier<InputStream> contenu, String chemin, String archive,
            int niveau) {
        if (octets > OCTETS_MAX || fichiers > FICHIERS_MAX) {
            return false;
        } else if (chemin.length() > CHEMIN_MAX) {
            refus.add("des noms de plus de " + CHEMIN_MAX + " caractères : laissés de côté");
            return true;
        }
        List<String> noms = List.of(chemin.split("/"));
        String fin = noms.isEmpty() ? "" : noms.get(noms.size() - 1);
        String bas = fin.toLowerCase(Locale.ROOT);
        noms.stream().filter(n -> DOSSIERS_OUTILS.contains(n) || OUTIL.matcher(n).matches()).findFirst()
                .ifPresent(n -> outils.add(Echange.protege(n, NOM_MAX)));
        boolean dossier = nom.endsWith("/");
        if (dossier || estDebris(noms)) {
            return true;
        }
        fichiers++;
        boolean source = bas.endsWith(".java");
        boolean zip = bas.endsWith(".zip");
        // un fichier lu compte pour les octets lus, quelle que soit la taille annoncée
        octets += source || zip ? 0 : Math.max(0, taille);
        if (bas.endsWith(".jar")) {
            bibliotheques.add(Echange.protege(fin, NOM_MAX));
        }
        if (nom.startsWith("/") || nom.matches("(?s)[A-Za-z]:.*") || List.of(nom.split("/")).contains("..")) {
            refus.add("entrée refusée, qui sort de son archive : " + nom);
        } else if (lien) {
            refus.add("lien refusé : " + fin);
        } else if (AUTRE_ARCHIVE.matcher(fin).matches()) {
            refus.add(chemin + " : à déplier à la main ; seuls les dossiers et les .zip le sont ici");
        } else if (source || zip) {
            try (InputStream flux = contenu.get()) {
                if (zip) {
                    deplier(flux, chemin, niveau);
                } else {
                    ajouter(chemin, flux.readNBytes(SOURCE_MAX + 1));
                }
            } catch (UnsupportedOperationException e) {
                refus.add((archive.isEmpty() ? chemin : archive) + " : archive " + e.getMessage() + " ; à déplier à la main");
            } catch (IOException | RuntimeException e) {
                refus.add(chemin + " : " + (zip ? "archive illisible, abîmée ou protégée par un mot de passe" : "illisible") + " ("
                        + e.getMessage() + ")");
            }
        } else if (autres.size() < CITES_MAX) {
            autres.add(Echange.protege(fin, NOM_MAX));
        }
        return true;
    }

    /** Dit si un système ou un outil a ajouté ce fichier. */
    public static boolean estDebris(List<String> noms) {
        String fin = noms.isEmpty() ? "" : noms.get(noms.size() - 1);
        return fin.startsWith("._") || fin.equals(".DS_Store") || noms.stream().limit(Math.max(0, noms.size() - 1))
                .anyMatch(n -> DOSSIERS_OUTILS.contains(n) || List.of("__MACOSX", ".git", "node_modules").contains(n));
    }

    public static boolean estArchive(String nom) {
        return nom.toLowerCase(Locale.ROOT).endsWith(".zip") || AUTRE_ARCHIVE.matcher(nom).matches();
    }

    private void ajouter(String chemin, byte[] lus) {
        octets += lus.length;
        pesee += lus.length;
        if (lus.length > SOURCE_MAX || sources.size() >= SOURCES_MAX || pesee > PESEE_MAX) {
            String trop = lus.length > SOURCE_MAX ? chemin + DE_COTE + "plus d'un mégaoctet"
                    : "des sources" + DE_COTE + "il y en a plus de " + SOURCES_MAX + ", ou de " + (PESEE_MAX >> 20) + " Mo en tout";
            remarques.add(trop);
        } else {
            sources.put(chemin, lus);
        }
    }

    private void deplier(InputStream flux, String chemin, int niveau) throws IOException {
        if (niveau >= EMBOITEMENT_MAX) {
            refus.add(chemin + " : trop d'archives l'une dans l'autre");
            return;
        }
        byte[] archive = flux.readNBytes((int) OCTETS_MAX);
        octets += archive.length;
        // les fiches du répertoire central, que la bibliothèque retient toutes (APPNOTE.TXT, 4.3.12)
        if (IntStream.range(0, archive.length - 3).filter(k -> archive[k] == 'P' && archive[k + 1] == 'K' && archive[k + 2] == 1
                && archive[k + 3] == 2).limit(FICHES_MAX + 1).count() > FICHES_MAX) {
            fichiers = FICHIERS_MAX + 1;
            return;
        }
        try (ZipFile zip = ZipFile.builder().setByteArray(archive).get()) {
            String dans = chemin.substring(0, chemin.length() - ".zip".length());
            entrees(zip).allMatch(e -> prendre(zip, e, joindre(dans, nom(e)), chemin, niveau + 1));
        }
    }

    private void ecrire(java.io.DataOutputStream reponse) throws IOException {
        if (octets > OCTETS_MAX || fichiers > FICHIERS_MAX) {
            refus.add(octets > OCTETS_MAX ? "plus de " + (OCTETS_MAX >> 20) + " Mo une fois déplié"
                    : "plus de " + FICHIERS_MAX + " fichiers");
            sources.clear();
        } else if (sources.isEmpty() && refus.isEmpty()) {
            autres.addAll(bibliotheques);
            refus.add("aucun fichier .java dans ce rendu ; " + (autres.isEmpty() ? "il est vide" : "il contient : "
                    + autres.stream().limit(CITES_MAX).collect(Collectors.joining(", "))));
        }
        Echange.ecrireTout(reponse, sources);
        List<ArrayList<String>> listes = Stream.of(refus, remarques, outils, bibliotheques).map(ArrayList::new)
                .collect(Collectors.toList());
        listes.forEach(Echange::abreger);
        Echange.ecrireValeur(reponse, listes, o -> null);
    }
}
