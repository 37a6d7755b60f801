package lancer.correction.note;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import lancer.correction.Panne;
import lancer.correction.depot.Source;
import lancer.correction.enfant.Texte;
import lancer.correction.jugement.GrilleDeNotation;
import lancer.correction.modele.SourcesDuCours;
import org.ini4j.Ini;
import org.ini4j.InvalidFileFormatException;
import org.ini4j.Profile;

/**
 * Les points de chaque étape, dans un petit fichier INI que l'enseignant peut changer. Il peut y ajouter des lignes libres, dont il donne
 * lui-même les points : « qualité du code=3 » entre dans le total ; « bonus=+1 » et « retard=-2 » n'y entrent pas.
 */
public final class Bareme {

    /** Une ligne vide, un commentaire, une section, ou une valeur. */
    private static final String LIGNE = "\\s*([;#].*|\\[.+\\]\\s*|[^=:]+[=:].*)?";
    private static final String NOMBRE = "\\d{1,4}(\\.\\d{1,6})?";

    /** Points de chaque ligne dans le fichier ; négatifs si elle en enlève. */
    private final Map<String, Double> points = new HashMap<>();
    private final Set<String> horsTotal = new HashSet<>(Set.of(GrilleDeNotation.CONSIGNES));
    /** La somme des points du fichier, sans les lignes hors du total. */
    public final double somme;
    /** La note maximale : celle de la feuille de notes ou, sans feuille, {@link #somme}. */
    public final double total;

    /**
     * Lit le barème, ou l'écrit d'abord s'il n'existe pas. Ses lignes libres sont ajoutées à la grille.
     *
     * @param maximum la note maximale, à laquelle tous les points sont ramenés ; 0 : la somme des points
     * @throws Panne si le barème est fautif
     */
    public Bareme(Path fichier, GrilleDeNotation grille, double maximum) {
        List<String> etapes = grille.etapes.stream().map(e -> e.nom).collect(Collectors.toList());
        Profile.Section section;
        String lu = "";
        try {
            if (!Files.exists(fichier)) {
                Files.writeString(fichier, SourcesDuCours.ressource("bareme.ini"));
            }
            lu = Source.decoder(Files.readAllBytes(fichier));
            section = new Ini(new StringReader(lu)).get("Barème");
        } catch (InvalidFileFormatException e) {
            long ligne = lu.lines().takeWhile(l -> l.matches(LIGNE)).count();
            throw new Panne(2, fichier + " : ligne incomprise ; attendu : étape=points (ligne " + (ligne + 1) + " : "
                    + Texte.protege(lu.lines().skip(ligne).findFirst().orElse("")) + ")");
        } catch (IOException e) {
            throw new Panne(2, "barème illisible : " + fichier + " (" + e.getMessage() + ")");
        }
        if (section == null) {
            throw new Panne(2, fichier + " : la section [Barème] manque");
        }
        for (Map.Entry<String, String> ligne : section.entrySet()) {
            String nom = ligne.getKey();
            String faute = fichier + ", [Barème], " + nom;
            boolean connue = etapes.contains(nom);
            if (!connue && etapes.stream().anyMatch(e -> debut(e).equals(debut(nom)))) {
                throw new Panne(2, faute + " : étape inconnue ; attendu : une parmi " + String.join(", ", etapes)
                        + ", ou une ligne libre, qui ne commence pas comme une étape");
            }
            String texte = ligne.getValue() == null ? "" : ligne.getValue().trim().replace(',', '.');
            String signe = nom.equals(GrilleDeNotation.CONSIGNES) ? "-?" : "";
            if (!texte.matches((connue ? signe : "[+-]?") + NOMBRE)) {
                throw new Panne(2, faute + " : « " + texte + " » ; attendu : un nombre de 0 à 9999"
                        + (connue ? "" : ", de signe + pour un bonus, - pour une pénalité"));
            } else if (!connue) {
                grille.etapes.add(new GrilleDeNotation.Etape(nom, nom));
            }
            if (texte.matches("[+-].*")) {
                horsTotal.add(nom);
            }
            points.put(nom, nom.equals(GrilleDeNotation.CONSIGNES) ? -Math.abs(Double.parseDouble(texte)) : Double.valueOf(texte));
        }
        somme = points.entrySet().stream().filter(p -> !horsTotal(p.getKey())).mapToDouble(Map.Entry::getValue).sum();
        if (somme == 0) {
            throw new Panne(2, fichier + " : la somme des points est nulle");
        }
        total = maximum > 0 ? maximum : somme;
    }

    /** Début d'une clé : une clé inconnue qui commence comme une étape est une étape mal écrite, et non une ligne libre. */
    private static String debut(String cle) {
        String bas = cle.toLowerCase(Locale.ROOT);
        return bas.substring(0, Math.min(4, bas.length()));
    }

    /** Points d'une ligne dans le fichier ; négatifs si elle en enlève. */
    double ecrits(String ligne) {
        return points.getOrDefault(ligne, 0.0);
    }

    /** Les mêmes points, sur {@link #total}. */
    public double poids(String ligne) {
        return ramener(ecrits(ligne));
    }

    /** Ramène à {@link #total} des points du fichier, ou d'un ajustement. */
    double ramener(double nombre) {
        return nombre * total / somme;
    }

    /** Vrai pour les consignes, un bonus ou une pénalité. */
    public boolean horsTotal(String ligne) {
        return horsTotal.contains(ligne);
    }
}
