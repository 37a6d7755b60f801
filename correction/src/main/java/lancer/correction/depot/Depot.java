package lancer.correction.depot;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.Panne;
import org.apache.commons.compress.archivers.zip.ZipFile;
import org.apache.commons.io.function.IOSupplier;

/** Rendus d'une classe : un dossier, l'archive de Moodle, ou un seul rendu. Chaque étudiant y figure, même si son rendu est illisible. */
public final class Depot {

    private static final int SOURCE_MAX = 1 << 20;
    private static final int CHEMIN_MAX = 1000;
    private static final int EMBOITEMENT_MAX = 3;
    private static final Pattern AUTRE_ARCHIVE =
            Pattern.compile("(?is).*\\.(rar|(7z|zip)\\.\\d+|7z|z\\d\\d|tar|tgz|tbz2?|txz|gz|xz|bz2|zst|lzma|zipx|ace|arj|cab|dmg)");
    /** Fichiers que les systèmes et les outils ajoutent. */
    private static final Pattern DEBRIS = Pattern.compile(
            "(.*/)?(__MACOSX|\\.git|\\.idea|\\.settings|\\.metadata|\\.vscode|"
            + "target|bin|build|out|node_modules)/.*|(.*/)?(\\._.*|\\.DS_Store)");
    /** Fichiers d'outils que l'énoncé demande d'enlever. */
    private static final Pattern OUTIL = Pattern.compile("(?:.*/)?(\\.idea|\\.settings|\\.metadata|\\.vscode|target|bin|build|out"
            + "|\\.classpath|\\.project|[^/]*\\.iml|[^/]*\\.class)(?:/.*)?");
    private static final Pattern UN_SEUL_RENDU =
            Pattern.compile("(?i)src|pom\\.xml|.*\\.java|lancer|lancer-?(java|base).*|brume|antialias|blinn");
    /**
     * Le nom que Moodle donne à un rendu : {@code <nom>_<numéro>_assignsubmission_file}, suivi ou non de « _ », puis, en mode plat, du nom
     * du fichier (moodle, {@code mod/assign/classes/downloader.php}).
     */
    private static final Pattern MOODLE = Pattern.compile("(?s)([^/]*?)_(\\d{1,18})_assignsubmission_([a-z]+)(?:_(.*))?");

    /** Un fichier, un dossier ou un lien d'un rendu, sur le disque ou dans une archive. */
    private static final class Entree {

        /** Nom depuis le dossier, ou dans l'archive ; celui d'un dossier finit par « / ». */
        final String chemin;
        final boolean lien;
        /** Taille annoncée, en octets ; négative si elle n'est pas annoncée. */
        final long taille;
        /** Flux de lecture. */
        final IOSupplier<InputStream> contenu;

        Entree(String chemin, boolean lien, long taille, IOSupplier<InputStream> contenu) {
            this.chemin = chemin;
            this.lien = lien;
            this.taille = taille;
            this.contenu = contenu;
        }

        String premierNom() {
            return chemin.replaceFirst("(?s)/.*", "");
        }
    }

    private final Map<String, Rendu> rendus = new LinkedHashMap<>();
    private final Set<String> ids = new HashSet<>();

    private Depot() {
    }

    /** @throws Panne si cet endroit n'a pas de rendu, ou si l'archive entière est illisible */
    public static List<Rendu> lire(Path rendus) {
        Depot depot = new Depot();
        String nom = rendus.toAbsolutePath().normalize().getFileName().toString();
        try {
            if (Files.isDirectory(rendus)) {
                List<Entree> entrees = new ArrayList<>();
                ajouter(rendus.toRealPath(), "", entrees);
                depot.repartir(nom, entrees);
            } else if (!Files.isRegularFile(rendus)) {
                throw new Panne(2, "aucun rendu à cet endroit : " + rendus + " ; attendu : un dossier, ou un .zip");
            } else if (AUTRE_ARCHIVE.matcher(nom).matches()) {
                depot.prendre(depot.seul(nom), nom, new Entree(nom, false, 0, null), 0);
            } else {
                try (ZipFile zip = ZipFile.builder().setPath(rendus).get()) {
                    depot.repartir(nom, entrees(zip));
                }
            }
        } catch (IOException e) {
            throw new Panne(2, "rendus illisibles : " + rendus + " (" + e.getMessage() + ")");
        }
        if (depot.rendus.isEmpty()) {
            throw new Panne(2, "aucun rendu dans " + rendus);
        }
        List<Rendu> liste = new ArrayList<>(depot.rendus.values());
        liste.forEach(Rendu::conclure);
        liste.sort(Comparator.comparing(r -> ordre(r.nom, r.id)));
        return liste;
    }

    /** Ajoute le contenu d'un dossier, par ordre alphabétique, sans suivre les liens. Un fichier illisible n'arrête pas la lecture. */
    private static void ajouter(Path dossier, String debut, List<Entree> entrees) {
        Set<String> vus = new HashSet<>();
        try (Stream<Path> flux = Files.list(dossier)) {
            for (Path f : flux.sorted().collect(Collectors.toList())) {
                String chemin = debut + f.getFileName();
                while (!vus.add(chemin)) {
                    // deux noms différents peuvent se lire pareils, si la langue de la machine n'a pas leurs caractères
                    chemin = debut + "'" + chemin.substring(debut.length());
                }
                if (Files.isDirectory(f, LinkOption.NOFOLLOW_LINKS)) {
                    entrees.add(new Entree(chemin + "/", false, 0, null));
                    ajouter(f, chemin + "/", entrees);
                } else {
                    boolean lien = !Files.isRegularFile(f, LinkOption.NOFOLLOW_LINKS);
                    entrees.add(new Entree(chemin, lien, lien ? 0 : f.toFile().length(), () -> Files.newInputStream(f)));
                }
            }
        } catch (IOException | UncheckedIOException e) {
            // le reste du dossier est lu quand même
        }
    }

    /** Les entrées d'une archive, dans l'ordre, avec des « / » même si elle vient de Windows. */
    private static List<Entree> entrees(ZipFile zip) {
        return Collections.list(zip.getEntries()).stream().map(e -> new Entree(e.getName().replace('\\', '/'), e.isUnixSymlink(),
                e.getSize(), () -> zip.getInputStream(e))).collect(Collectors.toList());
    }

    /** Donne chaque entrée à l'étudiant que désigne le premier nom de son chemin, ou toutes au même étudiant. */
    private void repartir(String nom, List<Entree> entrees) {
        Set<String> noms = entrees.stream().filter(e -> !DEBRIS.matcher(e.chemin).matches()).map(Entree::premierNom)
                .collect(Collectors.toSet());
        boolean unSeul = MOODLE.matcher(nom).matches() || noms.stream().noneMatch(n -> MOODLE.matcher(n).matches())
                && noms.stream().anyMatch(n -> !estArchive(n) && UN_SEUL_RENDU.matcher(n).matches());
        for (Entree entree : entrees) {
            String premier = entree.premierNom();
            boolean fichier = premier.equals(entree.chemin);
            String suite = fichier ? "" : entree.chemin.substring(premier.length() + 1);
            Matcher moodle = MOODLE.matcher(premier);
            if (unSeul) {
                prendre(seul(nom), entree.chemin, entree, 0);
            } else if (moodle.matches()) {
                Rendu rendu = seul(premier);
                // un texte en ligne, ou le contenu d'un autre greffon, n'est pas un fichier
                if (moodle.group(3).equals("file")) {
                    String reste = moodle.group(4) == null ? "" : moodle.group(4);
                    prendre(rendu, joindre(reste, suite), entree, 0);
                }
            } else if (!DEBRIS.matcher(fichier ? premier : premier + "/").matches() && (!fichier || estArchive(premier))) {
                // « dupont » et « dupont.zip » sont deux rendus
                String id = fichier && !noms.contains(sansFin(premier)) ? sansFin(premier) : premier;
                prendre(rendu(id, id), fichier ? premier : suite, entree, 0);
            }
        }
    }

    private Rendu seul(String nom) {
        Matcher moodle = MOODLE.matcher(nom);
        return moodle.matches() ? rendu(moodle.group(2), moodle.group(1).trim()) : rendu(sansFin(nom), sansFin(nom));
    }

    private Rendu rendu(String id, String nom) {
        return rendus.computeIfAbsent(id, i -> {
            // deux noms peuvent devenir égaux une fois nettoyés : le second reçoit un numéro
            String sien = Rendu.propre(i);
            for (int k = 2; !ids.add(sien); k++) {
                sien = Rendu.propre(i) + " " + k;
            }
            return new Rendu(sien, nom.isEmpty() || nom.equals(i) ? sien : Rendu.propre(nom));
        });
    }

    private static String sansFin(String nom) {
        return nom.replaceFirst("(?i)\\.zip$", "");
    }

    /** Clé de tri d'un étudiant, qui range « Étudiant 2 » avant « Étudiant 10 ». */
    public static String ordre(String nom, String id) {
        return Pattern.compile("\\d{1,18}").matcher(nom + "\0" + id).replaceAll(n -> String.format("%018d", Long.parseLong(n.group())));
    }

    private static boolean estArchive(String nom) {
        return nom.toLowerCase(Locale.ROOT).endsWith(".zip") || AUTRE_ARCHIVE.matcher(nom).matches();
    }

    private static String joindre(String a, String b) {
        return a.isEmpty() ? b : b.isEmpty() ? a : a + "/" + b;
    }

    /** Lit une entrée, si c'est une source ou une archive. Une entrée illisible n'empêche pas de lire les autres. */
    private void prendre(Rendu rendu, String chemin, Entree entree, int niveau) {
        Matcher outil = OUTIL.matcher(chemin);
        if (outil.matches()) {
            rendu.outils.add(Rendu.propre(outil.group(1)));
        }
        boolean source = chemin.toLowerCase(Locale.ROOT).endsWith(".java");
        // un fichier lu compte pour les octets lus, quelle que soit la taille annoncée
        if (DEBRIS.matcher(chemin).matches() || entree.chemin.endsWith("/")
                || !rendu.compter(source || estArchive(chemin) ? 0 : Math.max(0, entree.taille))) {
            return;
        }
        if (chemin.toLowerCase(Locale.ROOT).endsWith(".jar")) {
            rendu.bibliotheques.add(chemin.replaceFirst("(?s).*/", ""));
        }
        String brut = entree.chemin;
        if (brut.startsWith("/") || brut.matches("(?s)[A-Za-z]:.*") || List.of(brut.split("/")).contains("..")) {
            rendu.refus.add("entrée refusée, qui sort de son archive : " + brut);
        } else if (entree.lien) {
            rendu.refus.add("lien refusé : " + brut.replaceFirst("(?s).*/", ""));
        } else if (AUTRE_ARCHIVE.matcher(chemin).matches()) {
            rendu.refus.add(chemin + " : à déplier à la main ; seuls les dossiers et les .zip le sont ici");
        } else if (source) {
            try (InputStream flux = entree.contenu.get()) {
                byte[] octets = flux.readNBytes(SOURCE_MAX + 1);
                rendu.octets += octets.length;
                if (octets.length > SOURCE_MAX || chemin.length() > CHEMIN_MAX || !rendu.ajouter(chemin, octets)) {
                    rendu.remarques.add(chemin + Projet.DE_COTE + "plus d'un mégaoctet, trop de sources, ou un nom trop long");
                }
            } catch (IOException | RuntimeException e) {
                rendu.refus.add(chemin + " : illisible (" + e.getMessage() + ")");
            }
        } else if (estArchive(chemin)) {
            deplier(rendu, chemin, entree, niveau);
        }
    }

    private void deplier(Rendu rendu, String chemin, Entree entree, int niveau) {
        if (niveau >= EMBOITEMENT_MAX) {
            rendu.refus.add(chemin + " : trop d'archives l'une dans l'autre");
            return;
        }
        try (InputStream flux = entree.contenu.get()) {
            byte[] archive = flux.readNBytes((int) Rendu.OCTETS_MAX);
            rendu.octets += archive.length;
            try (ZipFile zip = ZipFile.builder().setByteArray(archive).get()) {
                entrees(zip).forEach(e -> prendre(rendu, joindre(sansFin(chemin), e.chemin), e, niveau + 1));
            }
        } catch (IOException | RuntimeException e) {
            rendu.refus.add(chemin + " : archive illisible, abîmée ou protégée par un mot de passe (" + e.getMessage() + ")");
        }
    }
}
