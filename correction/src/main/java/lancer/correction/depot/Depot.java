package lancer.correction.depot;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.correction.Panne;
import lancer.correction.enfant.Contenu;
import lancer.correction.enfant.Echange;
import lancer.correction.isolement.Arret;

/** Rendus d'une classe : un dossier, l'archive de Moodle, ou un seul rendu. Chaque étudiant y figure, même si son rendu est illisible. */
public final class Depot {

    private static final Pattern UN_SEUL_RENDU =
            Pattern.compile("(?i)src|pom\\.xml|.*\\.java|lancer|lancer-?(java|base).*|brume|antialias|blinn");
    /**
     * Le nom que Moodle donne à un rendu : {@code <nom>_<numéro>_assignsubmission_file}, suivi ou non de « _ », puis, en mode plat, du nom
     * du fichier (moodle, {@code mod/assign/classes/downloader.php}).
     */
    private static final Pattern MOODLE = Pattern.compile("(?s)([^/]*?)_(\\d{1,18})_assignsubmission_([a-z]+)(?:_(.*))?");

    /** Lecture des dossiers et des archives. */
    public interface Acces {

        /** La réponse de {@link Contenu#repondre} à une demande, sans le nom de la classe. @throws Arret si la lecture est arrêtée */
        DataInputStream demander(Map<String, byte[]> noms) throws Arret;
    }

    /** Les rendus, et les premiers noms des chemins de chacun, avec ce qui les remplace dans le rendu. */
    private final Map<String, Rendu> rendus = new LinkedHashMap<>();
    private final Map<Rendu, Map<String, byte[]>> noms = new LinkedHashMap<>();
    private final Set<String> ids = new HashSet<>();

    private Depot() {
    }

    /** @throws Panne si cet endroit n'a pas de rendu, ou si l'archive entière est illisible */
    public static List<Rendu> lire(Path lieu, Acces acces) {
        Depot depot = new Depot();
        String nom = lieu.toAbsolutePath().normalize().getFileName().toString();
        boolean autre = !Files.isDirectory(lieu) && !nom.matches("(?i).*\\.zip") && Contenu.estArchive(nom);
        try {
            if (autre) {
                depot.seul(nom).refus.add(nom + " : à déplier à la main ; seuls les dossiers et les .zip le sont ici");
            } else {
                DataInputStream contenu = acces.demander(Map.of());
                String faute = Echange.lireTexte(contenu);
                if (!faute.isEmpty()) {
                    throw new Panne(2, "rendus illisibles : " + lieu + " (" + faute + ")");
                }
                depot.repartir(nom, Echange.lireTout(contenu));
            }
        } catch (Arret e) {
            depot.seul(nom).refus.add(e.getMessage() + " (en lisant ses fichiers)");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        if (depot.rendus.isEmpty()) {
            throw new Panne(2, "aucun rendu dans " + lieu);
        }
        List<Rendu> liste = new ArrayList<>(depot.rendus.values());
        liste.stream().filter(r -> r.refus.isEmpty()).forEach(r -> r.lire(acces, depot.noms.getOrDefault(r, Map.of())));
        liste.sort(Comparator.comparing(r -> ordre(r.nom, r.id)));
        return liste;
    }

    /** Donne chaque premier nom à l'étudiant qu'il désigne, ou tous au même étudiant. @param contenu vide pour un dossier */
    private void repartir(String nom, Map<String, byte[]> contenu) {
        boolean unSeul = MOODLE.matcher(nom).matches() || contenu.keySet().stream().noneMatch(n -> MOODLE.matcher(n).matches())
                && contenu.keySet().stream().anyMatch(n -> !Contenu.estArchive(n) && UN_SEUL_RENDU.matcher(n).matches());
        contenu.forEach((premier, sorte) -> {
            boolean fichier = sorte.length > 0;
            Matcher moodle = MOODLE.matcher(premier);
            if (unSeul) {
                prendre(seul(nom), premier, premier);
            } else if (moodle.matches()) {
                Rendu rendu = seul(premier);
                // un texte en ligne, ou le contenu d'un autre greffon, n'est pas un fichier
                if (moodle.group(3).equals("file")) {
                    prendre(rendu, premier, moodle.group(4) == null ? "" : moodle.group(4));
                }
            } else if (fichier ? Contenu.estArchive(premier) : !Contenu.estDebris(List.of(premier, ""))) {
                // « dupont » et « dupont.zip » sont deux rendus
                String id = fichier && !contenu.containsKey(sansFin(premier)) ? sansFin(premier) : premier;
                prendre(rendu(id, id), premier, fichier ? premier : "");
            }
        });
    }

    private void prendre(Rendu rendu, String premier, String debut) {
        noms.computeIfAbsent(rendu, r -> new LinkedHashMap<>()).put(premier, debut.getBytes(StandardCharsets.UTF_8));
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
}
