package lancer.correction.note;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.correction.Panne;
import lancer.correction.depot.Source;
import lancer.correction.jugement.GrilleDeNotation;
import lancer.correction.modele.SourcesDuCours;
import org.ini4j.Ini;
import org.ini4j.InvalidFileFormatException;
import org.ini4j.Profile;

/**
 * Les points de chaque étape, dans un petit fichier INI que l'enseignant peut changer. Il peut y ajouter des lignes libres (« qualité du
 * code=3 »), dont il donne lui-même les points.
 */
public final class Bareme {

    private final Map<String, Double> poids = new HashMap<>();
    /** La note maximale, sans les consignes, qui enlèvent des points, ni les lignes libres ({@link Eleve#sur}). */
    public final double total;

    /**
     * Lit le barème, ou l'écrit d'abord s'il n'existe pas. Ses lignes libres sont ajoutées à la grille.
     *
     * @throws Panne si le barème est fautif
     */
    public Bareme(Path fichier, GrilleDeNotation grille) {
        List<String> etapes = grille.etapes.stream().map(e -> e.nom).collect(Collectors.toList());
        Profile.Section section;
        try {
            if (!Files.exists(fichier)) {
                Files.writeString(fichier, SourcesDuCours.ressource("bareme.ini"));
            }
            section = new Ini(new StringReader(Source.decoder(Files.readAllBytes(fichier)))).get("Barème");
        } catch (InvalidFileFormatException e) {
            throw new Panne(2, fichier + " : ligne incomprise ; attendu : étape=points ("
                    + e.getMessage().replace("parse error (at line: ", "ligne ").replaceFirst("\\)", "") + ")");
        } catch (IOException e) {
            throw new Panne(2, "barème illisible : " + fichier + " (" + e.getMessage() + ")");
        }
        if (section == null) {
            throw new Panne(2, fichier + " : la section [Barème] manque");
        }
        section.forEach((nom, points) -> {
            String faute = fichier + ", [Barème], " + nom;
            boolean connue = etapes.contains(nom);
            if (!connue && etapes.stream().anyMatch(e -> debut(e).equals(debut(nom)))) {
                throw new Panne(2, faute + " : étape inconnue ; attendu : une parmi " + String.join(", ", etapes)
                        + ", ou une ligne libre, qui ne commence pas comme une étape");
            } else if (!connue) {
                grille.etapes.add(new GrilleDeNotation.Etape(nom, nom));
            }
            String texte = points == null ? "" : points.trim().replace(',', '.');
            if (!texte.matches("\\d{1,4}(\\.\\d{1,6})?")) {
                throw new Panne(2, faute + " : « " + texte + " » ; attendu : un nombre de 0 à 9999");
            }
            poids.put(nom, Double.valueOf(texte));
        });
        total = grille.etapes.stream().filter(e -> !e.libre() && !e.nom.equals(GrilleDeNotation.CONSIGNES))
                .mapToDouble(e -> poids(e.nom)).sum();
        if (total == 0) {
            throw new Panne(2, fichier + " : la somme des points est nulle");
        }
    }

    /** Début d'une clé : une clé inconnue qui commence comme une étape est une étape mal écrite, et non une ligne libre. */
    private static String debut(String cle) {
        String bas = cle.toLowerCase(Locale.ROOT);
        return bas.substring(0, Math.min(4, bas.length()));
    }

    public double poids(String etape) {
        return poids.getOrDefault(etape, 0.0);
    }
}
