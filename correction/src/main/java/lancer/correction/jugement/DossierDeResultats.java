package lancer.correction.jugement;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonDeserializer;
import com.google.gson.JsonPrimitive;
import com.google.gson.JsonSerializer;
import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.Panne;
import lancer.correction.depot.Rendu;

/**
 * Le dossier {@code resultats} : un fichier par rendu, du nom de son identifiant, et rien d'autre qui les compte. Chacun est écrit à part,
 * puis mis à sa place d'un coup : deux correcteurs à la fois donnent l'union de leurs rendus. La grille est à côté, dans
 * {@code corrige.json}.
 */
public final class DossierDeResultats {

    /** Une image s'écrit en PNG. */
    private static final Gson JSON = new GsonBuilder().disableHtmlEscaping()
            .registerTypeAdapter(Image.class, (JsonSerializer<Image>) (image, type, json) -> new JsonPrimitive(image.png(1)))
            .registerTypeAdapter(Image.class, (JsonDeserializer<Image>) (png, type, json) -> Image.lire(png.getAsString())).create();
    private static final String FIN = ".json";
    /** Longueur maximale d'un nom de fichier, sans sa fin, et longueur de son début s'il en faut plus. */
    private static final int NOM_MAX = 200;
    private static final int DEBUT = 160;

    private final Path dossier;
    private final Path grille;

    public DossierDeResultats(Path classe) {
        dossier = classe.resolve("resultats");
        grille = classe.resolve("corrige.json");
    }

    /** Le nom des fichiers de ce rendu, sans leur fin : deux identifiants n'ont jamais le même. */
    public static String nom(String id) {
        String nom = URLEncoder.encode(id, StandardCharsets.UTF_8).replace("+", "%20").replace("*", "%2A").replaceFirst("^\\.", "%2E");
        return nom.length() <= NOM_MAX ? nom
                : nom.substring(0, DEBUT) + "~" + UUID.nameUUIDFromBytes(id.getBytes(StandardCharsets.UTF_8));
    }

    /** @throws Panne si rien n'a été jugé, ou si ce fichier est abîmé */
    public GrilleDeNotation grille() {
        return lire(grille, GrilleDeNotation.class);
    }

    /** @throws Panne si le fichier d'un rendu est abîmé */
    public List<Resultat> resultats() {
        List<Resultat> tous = new ArrayList<>();
        if (!Files.exists(dossier)) {
            return tous;
        }
        try (Stream<Path> flux = Files.list(dossier)) {
            for (Path fichier : flux.filter(f -> f.toString().endsWith(FIN)).sorted().collect(Collectors.toList())) {
                tous.add(lire(fichier, Resultat.class));
            }
        } catch (IOException e) {
            throw new Panne(1, "résultats illisibles : " + e);
        }
        return tous;
    }

    private static <T> T lire(Path fichier, Class<T> type) {
        try {
            T lu = JSON.fromJson(Files.readString(fichier), type);
            if (lu != null && (!(lu instanceof Resultat) || ((Resultat) lu).id != null)) {
                return lu;
            }
        } catch (IOException | RuntimeException e) {
            // la même phrase
        }
        throw new Panne(2, "rien à noter : " + fichier + " manque, ou est abîmé ; attendu : le résultat de make corriger");
    }

    /**
     * Écrit la grille du corrigé.
     *
     * @throws Panne si des rendus ont été jugés avec d'autres critères
     */
    public void ecrire(GrilleDeNotation neuve) throws IOException {
        if (Files.exists(grille) && !resultats().isEmpty() && !JSON.toJson(grille().etapes).equals(JSON.toJson(neuve.etapes))) {
            throw new Panne(2, "rien n'est jugé : les résultats de ce dossier viennent d'une autre version du programme ; "
                    + "attendu : toute la classe, et NEUF=1 (--neuf) pour les mettre de côté");
        }
        deposer(grille, neuve);
    }

    /**
     * Écrit un résultat, à la place de celui du même rendu. Un résultat qui en remplace un autre, d'un travail différent, le dit.
     */
    public void ecrire(Resultat resultat) throws IOException {
        Path fichier = Files.createDirectories(dossier).resolve(nom(resultat.id) + FIN);
        if (Files.exists(fichier)) {
            Resultat avant = lire(fichier, Resultat.class);
            if (!resultat.empreinte.equals(avant.empreinte)) {
                resultat.remplace = "remplace un autre travail de « " + avant.nom + " », jugé le " + avant.date;
                resultat.regarder(resultat.remplace);
            }
        }
        deposer(fichier, resultat);
    }

    /** Ce que ces rendus vont remplacer : le jugement d'un autre travail de la même ligne. */
    public List<String> remplaces(List<Rendu> rendus) {
        Map<String, Resultat> avant = resultats().stream().collect(Collectors.toMap(r -> r.id, r -> r));
        return rendus.stream().filter(r -> avant.containsKey(r.id) && !avant.get(r.id).empreinte.equals(r.empreinte()))
                .map(r -> avant.get(r.id).nom + ", jugé le " + avant.get(r.id).date).collect(Collectors.toList());
    }

    /** Un demi-caractère, que l'UTF-8 n'a pas, devient « ? ». */
    private static void deposer(Path fichier, Object resultat) throws IOException {
        byte[] octets = JSON.toJson(resultat).getBytes(StandardCharsets.UTF_8);
        Path ecrit = fichier.resolveSibling(".ecrit-" + UUID.randomUUID());
        try {
            Files.write(ecrit, octets);
            Files.move(ecrit, fichier, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(ecrit);
        }
    }
}
