package lancer.correction.depot;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lancer.correction.enfant.Echange;
import lancer.correction.enfant.Texte;
import org.apache.commons.compress.archivers.zip.UnsupportedZipFeatureException;
import org.apache.commons.compress.archivers.zip.ZipArchiveEntry;
import org.apache.commons.compress.archivers.zip.ZipFile;
import org.apache.commons.compress.archivers.zip.ZipMethod;
import org.apache.commons.io.function.IOSupplier;

/**
 * Lit des dossiers et des archives, dans une autre machine virtuelle, qui n'exécute aucun rendu. Ce qui n'est pas lu (images, bibliothèques,
 * documents) ne compte pas dans la taille d'un rendu. Les noms qui commencent par un point et {@code __MACOSX} ne comptent jamais.
 */
public final class Contenu {

    /** Milieu d'une remarque qui commence par un fichier, et qui finit par la raison de ne pas le lire. */
    static final String DE_COTE = " : laissé de côté, ";
    /** Fin d'un refus : ce fichier est une archive que l'enseignant doit déplier. */
    static final String A_DEPLIER = " : à déplier à la main ; seuls les dossiers et les .zip le sont ici";

    /** Taille maximale de ce qui est lu d'un rendu, décompressé, en octets. */
    private static final long OCTETS_MAX = 50L << 20;
    /** Taille maximale d'une archive seule dans l'archive de la classe, en octets. */
    private static final int CLASSE_MAX = 200 << 20;
    /** Nombre maximal d'entrées d'une archive. */
    private static final int FICHES_MAX = 200_000;
    private static final int SOURCE_MAX = 1 << 20;
    private static final int SOURCES_MAX = 500;
    private static final int PESEE_MAX = 6 << 20;
    private static final int CHEMIN_MAX = 1000;
    private static final int EMBOITEMENT_MAX = 3;
    private static final int CITES_MAX = 5;
    private static final int NOM_MAX = 70;
    private static final Pattern AUTRE_ARCHIVE =
            Pattern.compile("(?is).*\\.(rar|(7z|zip)\\.\\d+|7z|z\\d\\d|tar|tgz|tbz2?|txz|gz|xz|bz2|zst|lzma|zipx|ace|arj|cab|dmg)");
    /** Ce que des outils ajoutent, et que l'énoncé demande d'enlever. Un dossier de ce nom qui a des sources n'en est pas. */
    private static final Set<String> DOSSIERS_OUTILS =
            Set.of(".idea", ".settings", ".metadata", ".vscode", "target", "bin", "build", "out");
    private static final Pattern OUTIL = Pattern.compile("(?s)\\.classpath|\\.project|.*\\.iml|.*\\.class");

    /** Ce qui est demandé : les noms de l'endroit où sont les rendus, ou le contenu d'un rendu. */
    public static final class Demande {

        final String lieu;
        /** Vrai si tout ce lieu est un seul rendu. */
        final boolean seul;
        /** Les entrées d'un rendu, et le chemin de chacune dans ce rendu ; {@code null} pour demander les noms. */
        final Map<String, String> noms;

        public Demande(String lieu, boolean seul, Map<String, String> noms) {
            this.lieu = lieu;
            this.seul = seul;
            this.noms = noms;
        }
    }

    /** La faute de lecture, vide s'il n'y en a pas, puis ce qui est demandé. */
    public static final class Reponse {

        String faute = "";
        /** Les noms de l'endroit où sont les rendus ; vrai pour un fichier. */
        final Map<String, Boolean> noms = new LinkedHashMap<>();
        final Map<String, byte[]> sources = new TreeMap<>();
        final List<String> refus = new ArrayList<>();
        final List<String> remarques = new ArrayList<>();
        /** Les fichiers et les dossiers d'outils, par leur chemin, et leur nom. */
        final Map<String, String> outils = new TreeMap<>();
        final Set<String> bibliotheques = new TreeSet<>();

        private static void dire(List<String> liste, String texte) {
            if (!liste.contains(texte)) {
                liste.add(texte);
            }
        }
    }

    private final Reponse reponse = new Reponse();
    private final Set<String> autres = new TreeSet<>();
    private long octets;
    private long pesee;
    private boolean tropDeFiches;

    private Contenu() {
    }

    public static void main(String[] args) throws IOException {
        Echange.servir(System.in, System.out, demande -> Json.ecrire(repondre(Json.lire(Demande.class, demande))));
    }

    static Reponse repondre(Demande demande) {
        Contenu contenu = new Contenu();
        if (demande.lieu.isEmpty()) {
            return contenu.reponse;
        }
        try (Lieu ici = new Lieu(Path.of(demande.lieu), !demande.seul)) {
            if (demande.noms == null) {
                contenu.reponse.noms.putAll(ici.noms());
            } else {
                contenu.lire(ici, demande.seul ? ici.noms().keySet().stream().collect(Collectors.toMap(n -> n, n -> n)) : demande.noms);
                contenu.finir();
            }
        } catch (IOException | RuntimeException e) {
            contenu.reponse.faute = String.valueOf(e.getMessage());
        }
        return contenu.reponse;
    }

    /**
     * L'endroit où sont les rendus : un dossier, ou un dossier d'une archive. Un dossier ou une archive qui n'en contient qu'un autre est
     * ouvert, autant de fois qu'il le faut, sauf s'il porte un nom que Moodle donne à un rendu.
     */
    private static final class Lieu implements AutoCloseable {

        private Path dossier;
        private ZipFile zip;
        private String debut = "";

        Lieu(Path ici, boolean entrer) throws IOException {
            dossier = dossier(ici) ? ici : null;
            zip = dossier == null ? ZipFile.builder().setPath(ici).get() : null;
            for (Map<String, Boolean> noms = noms(); entrer && noms.size() == 1; noms = noms()) {
                String seul = noms.keySet().iterator().next();
                boolean fichier = noms.get(seul);
                entrer = !Depot.deMoodle(seul) && (!fichier || seul.toLowerCase(Locale.ROOT).endsWith(".zip"));
                if (entrer && !fichier) {
                    dossier = dossier == null ? null : enfants(dossier).get(seul);
                    debut += zip == null ? "" : seul + "/";
                } else if (entrer && zip == null) {
                    zip = ZipFile.builder().setPath(enfants(dossier).get(seul)).get();
                    dossier = null;
                } else if (entrer) {
                    zip = emboitee(entrees().filter(e -> nom(e).equals(debut + seul)).findFirst().get());
                    debut = "";
                }
            }
        }

        private ZipFile emboitee(ZipArchiveEntry entree) throws IOException {
            try (InputStream flux = zip.getInputStream(entree)) {
                byte[] octets = flux.readNBytes(CLASSE_MAX + 1);
                if (octets.length > CLASSE_MAX) {
                    throw new IOException(nom(entree) + A_DEPLIER);
                }
                zip.close();
                return ZipFile.builder().setByteArray(octets).get();
            }
        }

        private Stream<ZipArchiveEntry> entrees() {
            return Collections.list(zip.getEntries()).stream().filter(e -> nom(e).startsWith(debut) && nom(e).length() > debut.length());
        }

        /** Le premier nom d'une entrée, à partir d'ici. */
        private String premier(ZipArchiveEntry entree) {
            return nom(entree).substring(debut.length()).split("/", 2)[0];
        }

        /** Les noms qui comptent ; vrai pour un fichier. */
        Map<String, Boolean> noms() {
            Map<String, Boolean> noms = new LinkedHashMap<>();
            if (zip == null) {
                enfants(dossier).forEach((nom, chemin) -> noms.put(nom, !dossier(chemin)));
            } else {
                entrees().forEach(e -> noms.merge(premier(e), nom(e).indexOf('/', debut.length()) < 0, Boolean::logicalAnd));
            }
            noms.keySet().removeIf(Contenu::cache);
            return noms;
        }

        @Override
        public void close() throws IOException {
            if (zip != null) {
                zip.close();
            }
        }
    }

    private void lire(Lieu ici, Map<String, String> noms) {
        if (ici.zip == null) {
            enfants(ici.dossier).forEach((nom, chemin) -> {
                if (noms.containsKey(nom)) {
                    parcourir(chemin, noms.get(nom));
                }
            });
        } else {
            ici.entrees().filter(e -> noms.containsKey(ici.premier(e))).allMatch(e -> {
                String premier = ici.premier(e);
                String suite = nom(e).substring(ici.debut.length() + premier.length()).replaceFirst("^/", "");
                return prendre(ici.zip, e, joindre(noms.get(premier), suite), "", 0);
            });
        }
    }

    private static String joindre(String a, String b) {
        return a.isEmpty() || b.isEmpty() ? a + b : a + "/" + b;
    }

    private static boolean dossier(Path chemin) {
        return Files.isDirectory(chemin, LinkOption.NOFOLLOW_LINKS);
    }

    /** Dit si un système ou un outil a ajouté ce fichier ou ce dossier. */
    private static boolean cache(String nom) {
        return nom.startsWith(".") || nom.equals("__MACOSX");
    }

    /** Le contenu d'un dossier, par ordre alphabétique, sans suivre les liens. */
    private static Map<String, Path> enfants(Path dossier) {
        Map<String, Path> enfants = new LinkedHashMap<>();
        try (Stream<Path> flux = Files.list(dossier)) {
            for (Path f : flux.limit(FICHES_MAX).sorted().collect(Collectors.toList())) {
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

    /** Le nom d'une entrée, avec des « / » même si elle vient de Windows. */
    private static String nom(ZipArchiveEntry entree) {
        return entree.getName().replace('\\', '/');
    }

    private boolean prendre(ZipFile zip, ZipArchiveEntry entree, String chemin, String archive, int niveau) {
        String nom = nom(entree);
        if (nom.startsWith("/") || nom.matches("(?s)[A-Za-z]:.*") || List.of(nom.split("/")).contains("..")) {
            Reponse.dire(reponse.refus, "entrée refusée, qui sort de son archive : " + nom);
            return true;
        }
        return prendre(chemin + (nom.endsWith("/") ? "/" : ""), entree.isUnixSymlink(), () -> ouvrir(zip, entree), archive, niveau);
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
    private boolean parcourir(Path lieu, String chemin) {
        if (!dossier(lieu)) {
            return prendre(chemin, !Files.isRegularFile(lieu, LinkOption.NOFOLLOW_LINKS), () -> Files.newInputStream(lieu), "", 0);
        }
        boolean suite = prendre(chemin + "/", false, null, "", 0);
        return suite && (cache(lieu.getFileName().toString()) || enfants(lieu).entrySet().stream()
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
        if (octets > OCTETS_MAX || tropDeFiches) {
            return false;
        } else if (chemin.length() > CHEMIN_MAX) {
            Reponse.dire(reponse.refus, "des noms de plus de " + CHEMIN_MAX + " caractères : laissés de côté");
            return true;
        }
        List<String> noms = List.of(chemin.split("/"));
        String fin = noms.isEmpty() ? "" : noms.get(noms.size() - 1);
        retenirLesOutils(noms);
        if (chemin.endsWith("/") || noms.stream().anyMatch(Contenu::cache)) {
            return true;
        }
        String bas = fin.toLowerCase(Locale.ROOT);
        boolean zip = bas.endsWith(".zip");
        if (bas.endsWith(".jar")) {
            reponse.bibliotheques.add(Texte.protege(fin, NOM_MAX));
        }
        if (lien) {
            Reponse.dire(reponse.refus, "lien refusé : " + fin);
        } else if (AUTRE_ARCHIVE.matcher(fin).matches()) {
            Reponse.dire(reponse.refus, chemin + A_DEPLIER);
        } else if (zip || bas.endsWith(".java")) {
            lire(chemin, contenu, archive, niveau);
        } else if (autres.size() < CITES_MAX || bas.matches("(?s).*\\.(kt|class)")) {
            autres.add(Texte.protege(fin, NOM_MAX));
        }
        return true;
    }

    private void retenirLesOutils(List<String> noms) {
        for (int k = 0; k < noms.size(); k++) {
            String nom = noms.get(k);
            if (DOSSIERS_OUTILS.contains(nom) || k == noms.size() - 1 && OUTIL.matcher(nom).matches()) {
                reponse.outils.putIfAbsent(DOSSIERS_OUTILS.contains(nom) ? String.join("/", noms.subList(0, k + 1)) : nom,
                        Texte.protege(nom, NOM_MAX));
                return;
            }
        }
    }

    private void lire(String chemin, IOSupplier<InputStream> contenu, String archive, int niveau) {
        boolean zip = chemin.toLowerCase(Locale.ROOT).endsWith(".zip");
        try (InputStream flux = contenu.get()) {
            if (zip) {
                deplier(flux, chemin, niveau);
            } else {
                ajouter(chemin, flux.readNBytes(SOURCE_MAX + 1));
            }
        } catch (UnsupportedOperationException e) {
            Reponse.dire(reponse.refus, (archive.isEmpty() ? chemin : archive) + " : archive " + e.getMessage() + " ; à déplier à la main");
        } catch (IOException | RuntimeException e) {
            Reponse.dire(reponse.refus, chemin + " : " + (zip ? "archive illisible, abîmée ou protégée par un mot de passe" : "illisible")
                    + " (" + e.getMessage() + ")");
        }
    }

    private void ajouter(String chemin, byte[] lus) {
        octets += lus.length;
        pesee += lus.length;
        if (lus.length > SOURCE_MAX) {
            Reponse.dire(reponse.remarques, chemin + DE_COTE + "plus d'un mégaoctet");
        } else if (reponse.sources.size() >= SOURCES_MAX || pesee > PESEE_MAX) {
            Reponse.dire(reponse.remarques, "des sources" + DE_COTE + "il y en a plus de " + SOURCES_MAX + ", ou de " + (PESEE_MAX >> 20)
                    + " Mo en tout");
        } else if (!Arrays.equals(lus, Objects.requireNonNullElse(reponse.sources.putIfAbsent(chemin, lus), lus))) {
            Reponse.dire(reponse.remarques, chemin + DE_COTE + "un autre fichier a ce chemin, dans ce dossier ou dans une archive");
        }
    }

    private void deplier(InputStream flux, String chemin, int niveau) throws IOException {
        if (niveau >= EMBOITEMENT_MAX) {
            Reponse.dire(reponse.refus, chemin + " : trop d'archives l'une dans l'autre");
            return;
        }
        byte[] archive = flux.readNBytes((int) OCTETS_MAX + 1);
        octets += archive.length;
        // les fiches du répertoire central, que la bibliothèque retient toutes (APPNOTE.TXT, 4.3.12)
        tropDeFiches |= IntStream.range(0, archive.length - 3).filter(k -> archive[k] == 'P' && archive[k + 1] == 'K' && archive[k + 2] == 1
                && archive[k + 3] == 2).limit(FICHES_MAX + 1).count() > FICHES_MAX;
        if (octets > OCTETS_MAX || tropDeFiches) {
            return;
        }
        try (ZipFile zip = ZipFile.builder().setByteArray(archive).get()) {
            String dans = chemin.substring(0, chemin.length() - ".zip".length());
            Collections.list(zip.getEntries()).stream()
                    .allMatch(e -> prendre(zip, e, joindre(dans, nom(e)).replaceFirst("/$", ""), chemin, niveau + 1));
        }
    }

    private void finir() {
        reponse.outils.keySet().removeIf(dossier -> reponse.sources.keySet().stream().anyMatch(s -> s.startsWith(dossier + "/")));
        if (octets > OCTETS_MAX || tropDeFiches) {
            reponse.refus.add(tropDeFiches ? "une archive de plus de " + FICHES_MAX + " entrées"
                    : "plus de " + (OCTETS_MAX >> 20) + " Mo de sources et d'archives une fois dépliées");
            reponse.sources.clear();
        } else if (reponse.sources.isEmpty() && reponse.refus.isEmpty()) {
            autres.addAll(reponse.bibliotheques);
            autres.addAll(reponse.outils.values());
            reponse.refus.add(sansSource());
        }
        Texte.abreger(reponse.refus);
        Texte.abreger(reponse.remarques);
    }

    /** Ce que contient un rendu sans source. */
    private String sansSource() {
        for (String[] sorte : new String[][] {{".kt", "des sources Kotlin, et non Java"},
            {".class", "des classes compilées, sans leurs sources"}}) {
            String siens = autres.stream().filter(a -> a.endsWith(sorte[0])).limit(CITES_MAX).collect(Collectors.joining(", "));
            if (!siens.isEmpty()) {
                return "aucun fichier .java dans ce rendu : " + sorte[1] + " (" + siens + ")";
            }
        }
        return "aucun fichier .java dans ce rendu ; " + (autres.isEmpty() ? "il est vide"
                : "il contient : " + autres.stream().limit(CITES_MAX).collect(Collectors.joining(", ")));
    }
}
