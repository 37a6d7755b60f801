package lancer.correction.depot;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.Panne;

/**
 * Les rendus d'une classe : un dossier, l'archive de Moodle telle quelle, ou un seul rendu. Chaque étudiant a sa ligne,
 * que son rendu soit lisible ou non.
 */
public final class Depot {

    private static final int SOURCE_MAX = 1 << 20;
    private static final int CHEMIN_MAX = 1000;
    private static final int EMBOITEMENT_MAX = 3;
    private static final int ENTREES_MAX = 20_000;
    private static final Pattern AUTRE_ARCHIVE =
            Pattern.compile(".*\\.(rar|7z|tar|tgz|tar\\.(gz|xz|bz2)|gz|xz|bz2|zipx)");
    /** Ce que les systèmes et les outils ajoutent, et qui n'est le travail de personne. */
    private static final Pattern DEBRIS = Pattern.compile(
            "(.*/)?(__MACOSX|\\.git|\\.idea|\\.settings|\\.metadata|\\.vscode|"
            + "target|bin|build|out|node_modules)/.*|(.*/)?(\\._.*|\\.DS_Store)");
    /** Parmi eux et d'autres, ceux que l'énoncé demande d'enlever. */
    private static final Pattern OUTIL = Pattern.compile("(?:.*/)?(\\.idea|\\.settings|\\.metadata|\\.vscode|target|bin|build|out"
            + "|\\.classpath|\\.project|[^/]*\\.iml|[^/]*\\.class)(?:/.*)?");
    private static final Pattern UN_SEUL_RENDU =
            Pattern.compile("(?i)src|pom\\.xml|.*\\.java|lancer|lancer-?(java|base).*|brume|antialias|blinn");

    private final Map<String, Rendu> rendus = new LinkedHashMap<>();
    private final Map<String, Set<String>> outils = new HashMap<>();
    private final Path temporaire;

    private Depot(Path temporaire) {
        this.temporaire = temporaire;
    }

    /**
     * @param temporaire dossier où écrire les archives emboîtées, le temps de les lire
     * @throws Panne s'il n'y a rien là, ou si l'archive entière est illisible
     */
    public static List<Rendu> lire(Path rendus, Path temporaire) {
        Depot depot = new Depot(temporaire);
        try {
            if (Files.isDirectory(rendus)) {
                depot.lireDossier(rendus);
            } else if (Files.isRegularFile(rendus)) {
                depot.lireFichier(rendus);
            } else {
                throw new Panne(2, "aucun rendu à cet endroit : " + rendus + " ; attendu : un dossier, ou un .zip");
            }
        } catch (IOException e) {
            throw new Panne(2, "rendus illisibles : " + rendus + " (" + e.getMessage() + ")");
        }
        if (depot.rendus.isEmpty()) {
            throw new Panne(2, "aucun rendu dans " + rendus);
        }
        depot.rendus.values().forEach(Depot::conclure);
        depot.rendus.forEach((id, rendu) -> rendu.getOutils().addAll(depot.outils.getOrDefault(id, Set.of())));
        List<Rendu> liste = new ArrayList<>(depot.rendus.values());
        liste.sort(Comparator.comparing((Rendu r) -> naturel(r.getNom())).thenComparing(r -> naturel(r.getId())));
        return liste;
    }

    /** Ce qui est refusé n'empêche pas de juger le reste, si c'en est assez pour qu'il y ait quelque chose à juger. */
    private static void conclure(Rendu rendu) {
        rendu.abreger();
        if (!rendu.compter(0)) {
            rendu.oublierSources();
        } else if (!rendu.getSources().isEmpty()) {
            rendu.getRemarques().addAll(rendu.getRefus());
            rendu.getRefus().clear();
        } else if (rendu.getRefus().isEmpty()) {
            rendu.getRefus().add("aucun fichier .java dans ce rendu");
        }
    }

    private void lireDossier(Path dossier) throws IOException {
        List<Path> contenu;
        try (Stream<Path> flux = Files.list(dossier)) {
            contenu = flux.filter(f -> !DEBRIS.matcher(f.getFileName() + (Files.isDirectory(f) ? "/" : "")).matches())
                    .sorted().collect(Collectors.toList());
        }
        List<String> noms = contenu.stream().map(f -> f.getFileName().toString()).collect(Collectors.toList());
        NomMoodle lui = NomMoodle.lire(dossier.toAbsolutePath().normalize().getFileName().toString());
        if (estUnSeul(noms)) {
            String nom = dossier.toAbsolutePath().normalize().getFileName().toString();
            prendre(lui != null ? rendu(lui.id, lui.nom) : rendu(nom, nom), "", dossier);
            return;
        }
        for (Path fichier : contenu) {
            String nom = fichier.getFileName().toString();
            NomMoodle moodle = NomMoodle.lire(nom);
            if (moodle != null) {
                Rendu rendu = rendu(moodle.id, moodle.nom);
                if (moodle.fichier) {
                    prendre(rendu, moodle.reste, fichier);
                }
            } else if (Files.isDirectory(fichier) || estArchive(nom)) {
                String sansFin = nom.replaceFirst("(?i)\\.zip$", "");
                // « dupont » et « dupont.zip » : deux rendus, deux lignes
                String id = rendus.containsKey(sansFin) ? nom : sansFin;
                prendre(rendu(id, id), Files.isDirectory(fichier) ? "" : nom, fichier);
            }
        }
    }

    private void lireFichier(Path fichier) throws IOException {
        String nom = fichier.getFileName().toString();
        NomMoodle lui = NomMoodle.lire(nom);
        if (AUTRE_ARCHIVE.matcher(nom.toLowerCase(Locale.ROOT)).matches()) {
            refuserFormat(lui != null ? rendu(lui.id, lui.nom) : rendu(nom, nom), nom);
            return;
        }
        try (Archive archive = new Archive(fichier)) {
            List<String> noms = new ArrayList<>();
            for (int k = 0; k < archive.taille(); k++) {
                String chemin = archive.chemin(k);
                if (!DEBRIS.matcher(chemin).matches()) {
                    noms.add(chemin.replaceFirst("/.*", ""));
                }
            }
            if (lui != null || estUnSeul(noms)) {
                String sansFin = nom.replaceFirst("(?i)\\.zip$", "");
                deplier(lui != null ? rendu(lui.id, lui.nom) : rendu(sansFin, sansFin), "", archive, 0);
                return;
            }
            for (int k = 0; k < archive.taille(); k++) {
                String chemin = archive.chemin(k);
                int barre = chemin.indexOf('/');
                String premier = barre < 0 ? chemin : chemin.substring(0, barre);
                String suite = barre < 0 ? "" : chemin.substring(barre + 1);
                NomMoodle moodle = NomMoodle.lire(premier);
                noterOutil(moodle != null ? moodle.id : premier, suite);
                if (DEBRIS.matcher(chemin).matches()) {
                    continue;
                }
                if (moodle != null) {
                    Rendu rendu = rendu(moodle.id, moodle.nom);
                    if (moodle.fichier) {
                        entree(rendu, joindre(moodle.reste, suite), archive, k, 0);
                    }
                } else if (barre > 0 || estArchive(premier)) {
                    String sansFin = premier.replaceFirst("(?i)\\.zip$", "");
                    entree(rendu(sansFin, sansFin), barre < 0 ? premier : suite, archive, k, 0);
                }
            }
        }
    }

    /**
     * Vrai si ces noms, les premiers d'un dossier ou d'une archive, sont ceux d'un projet, et non ceux de plusieurs
     * étudiants.
     */
    private static boolean estUnSeul(List<String> noms) {
        return noms.stream().noneMatch(n -> NomMoodle.lire(n) != null) && noms.stream()
                .anyMatch(n -> !estArchive(n) && UN_SEUL_RENDU.matcher(n).matches());
    }

    /** De quoi ranger « Étudiant 2 » avant « Étudiant 10 ». */
    private static String naturel(String nom) {
        Matcher m = Pattern.compile("\\d{1,18}").matcher(nom);
        return m.replaceAll(n -> String.format("%018d", Long.parseLong(n.group())));
    }

    private static boolean estArchive(String nom) {
        String bas = nom.toLowerCase(Locale.ROOT);
        return bas.endsWith(".zip") || AUTRE_ARCHIVE.matcher(bas).matches();
    }

    private static String joindre(String a, String b) {
        return a.isEmpty() ? b : b.isEmpty() ? a : a + "/" + b;
    }

    private Rendu rendu(String id, String nom) {
        return rendus.computeIfAbsent(id, i -> new Rendu(i, nom.isEmpty() ? i : nom));
    }

    private void noterOutil(String id, String chemin) {
        Matcher outil = OUTIL.matcher(chemin);
        if (outil.matches()) {
            outils.computeIfAbsent(id, i -> new TreeSet<>()).add(outil.group(1));
        }
    }

    private static void refuserFormat(Rendu rendu, String nom) {
        rendu.getRefus().add(nom + " : format non pris en charge ; attendu : un dossier, ou un .zip");
    }

    /** Prend un fichier, ou tout un dossier, du disque ; ce qui s'y lit mal ne coûte qu'à lui. */
    private void prendre(Rendu rendu, String nom, Path fichier) {
        try {
            parcourir(rendu, nom, fichier);
        } catch (IOException | RuntimeException e) {
            rendu.getRefus().add(fichier.getFileName() + " : illisible (" + e + ")");
        }
    }

    private void parcourir(Rendu rendu, String nom, Path fichier) throws IOException {
        if (Files.isSymbolicLink(fichier)) {
            rendu.getRefus().add("lien refusé : " + fichier.getFileName());
        } else if (Files.isDirectory(fichier)) {
            Files.walkFileTree(fichier, new SimpleFileVisitor<Path>() {
                @Override
                public FileVisitResult visitFile(Path f, BasicFileAttributes attributs) throws IOException {
                    String chemin = joindre(nom, fichier.relativize(f).toString().replace('\\', '/'));
                    noterOutil(rendu.getId(), chemin);
                    if (DEBRIS.matcher(chemin).matches()) {
                        return FileVisitResult.CONTINUE;
                    }
                    if (attributs.isSymbolicLink()) {
                        rendu.getRefus().add("lien refusé : " + chemin);
                    } else if (!rendu.compter(attributs.size())) {
                        trop(rendu);
                        return FileVisitResult.TERMINATE;
                    } else if (attributs.isRegularFile()) {
                        contenu(rendu, chemin, f, 0);
                    }
                    return FileVisitResult.CONTINUE;
                }

                @Override
                public FileVisitResult visitFileFailed(Path f, IOException e) {
                    rendu.getRefus().add(joindre(nom, fichier.relativize(f).toString()) + " : illisible (" + e + ")");
                    return FileVisitResult.CONTINUE;
                }
            });
        } else if (Files.isRegularFile(fichier)) {
            contenu(rendu, nom.isEmpty() ? fichier.getFileName().toString() : nom, fichier, 0);
        }
    }

    private void contenu(Rendu rendu, String chemin, Path fichier, int niveau) throws IOException {
        String bas = chemin.toLowerCase(Locale.ROOT);
        if (bas.endsWith(".java")) {
            source(rendu, chemin, Files.size(fichier) > SOURCE_MAX ? null : Files.readAllBytes(fichier));
        } else if (bas.endsWith(".zip")) {
            if (niveau >= EMBOITEMENT_MAX) {
                rendu.getRefus().add(chemin + " : trop d'archives l'une dans l'autre");
                return;
            }
            try (Archive archive = new Archive(fichier)) {
                deplier(rendu, chemin.substring(0, chemin.length() - 4), archive, niveau + 1);
            } catch (IOException | RuntimeException e) {
                rendu.getRefus().add(chemin + " : archive illisible, abîmée ou protégée par un mot de passe ("
                        + e.getMessage() + ")");
            }
        } else if (AUTRE_ARCHIVE.matcher(bas).matches()) {
            refuserFormat(rendu, chemin);
        }
    }

    private void deplier(Rendu rendu, String prefixe, Archive archive, int niveau) throws IOException {
        if (archive.taille() > ENTREES_MAX) {
            rendu.getRefus().add("plus de " + ENTREES_MAX + " fichiers dans une archive");
            return;
        }
        for (int k = 0; k < archive.taille() && rendu.compter(0); k++) {
            noterOutil(rendu.getId(), archive.chemin(k));
            if (!DEBRIS.matcher(archive.chemin(k)).matches()) {
                entree(rendu, joindre(prefixe, archive.chemin(k)), archive, k, niveau);
            }
        }
    }

    private void entree(Rendu rendu, String chemin, Archive archive, int k, int niveau) throws IOException {
        String brut = archive.chemin(k);
        if (brut.startsWith("/") || brut.matches("[A-Za-z]:.*") || List.of(brut.split("/")).contains("..")) {
            rendu.getRefus().add("entrée refusée, qui sort de son archive : " + brut);
        } else if (archive.estLien(k)) {
            rendu.getRefus().add("lien refusé : " + brut);
        } else if (!archive.estDossier(k) && rendu.compter(0)) {
            byte[] octets;
            try {
                octets = archive.lire(k, Archive.OCTETS_MAX);
            } catch (IOException | RuntimeException e) {
                rendu.getRefus().add(brut + " : illisible dans l'archive (" + e.getMessage() + ")");
                return;
            }
            if (octets == null || !rendu.compter(octets.length)) {
                rendu.compter(Archive.OCTETS_MAX);
                trop(rendu);
            } else if (chemin.toLowerCase(Locale.ROOT).endsWith(".java")) {
                source(rendu, chemin, octets);
            } else if (estArchive(chemin)) {
                Path copie = Files.createTempFile(temporaire, "emboitee", null);
                try {
                    Files.write(copie, octets);
                    contenu(rendu, chemin, copie, niveau);
                } finally {
                    Files.delete(copie);
                }
            }
        }
    }

    private static void source(Rendu rendu, String chemin, byte[] octets) {
        if (octets == null || octets.length > SOURCE_MAX) {
            rendu.getRemarques().add(chemin + " : plus d'un mégaoctet de source, laissé de côté");
        } else if (chemin.length() > CHEMIN_MAX || !rendu.ajouter(chemin, octets)) {
            rendu.getRemarques().add(chemin + " : laissé de côté, trop de sources ou un nom trop long");
        }
    }

    private static void trop(Rendu rendu) {
        String refus = "plus de " + (Archive.OCTETS_MAX >> 20) + " Mo une fois déplié";
        if (!rendu.getRefus().contains(refus)) {
            rendu.getRefus().add(refus);
        }
    }
}
