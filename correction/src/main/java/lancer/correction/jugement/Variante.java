package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Machines.Assemblage;
import lancer.correction.jugement.Verdict.Etat;
import lancer.correction.modele.Modele;

/**
 * Valeur d'une extension : ce qu'elle change à l'image de la base du même étudiant, comparé à ce qu'y change celle du
 * corrigé. La ressemblance propose une note ; l'enseignant en décide.
 */
final class Variante {

    /** Titre, par extension, ce qu'on y regarde, et sur quelle scène. */
    static final Map<String, String[]> TITRES = Map.of(
            "brume", new String[] {"brume",
                "la couleur de la base, mêlée à celle d'une brume, d'autant plus que c'est loin", "brume"},
            "antialias", new String[] {"anticrénelage",
                "les bords approchent la moyenne de plusieurs rayons par pixel, et le reste ne change pas", "scene1"},
            "blinn", new String[] {"reflet de Blinn", "le reflet est (N.H) à la puissance ns, 2 ns ou 4 ns", "bowling"});

    /** Ressemblance à partir de laquelle proposer tous les points, et jusqu'à laquelle aucun. */
    private static final double TOUT = 0.8;
    private static final double RIEN = 0.4;

    private static final String[] TEINTES = {"0.1", "0.5", "0.9"};

    private final JugeImage juge;
    private final String nom;
    private final String scene;

    Variante(JugeImage juge, String nom) {
        this.juge = juge;
        this.nom = nom;
        scene = Modele.scene(TITRES.get(nom)[2]).replaceFirst("(?s)\\[Brume\\].*?(?=\\n\\[)", "");
    }

    /** @param attendu la base, et l'extension du corrigé */
    Verdict juger(Assemblage base, Assemblage lui, Assemblage attendu) {
        double accord = 0;
        try {
            Image image = dessin(lui, scene);
            juge.resultat.images.put(nom, image);
            Image sans = dessin(base, scene);
            Image ciel = dessin(base, "");
            // ôter le reflet de Phong, que celui de Blinn remplace, ne fait pas à soi seul un reflet de Blinn
            Image mate = nom.equals("blinn") ? dessin(base, scene.replaceAll("(?m)^ns=.*", "ns=1000000")) : sans;
            for (String texte : attendues()) {
                Image attendue = dessin(attendu, texte);
                accord = Math.max(accord, Math.min(Image.accord(image, attendue, sans, ciel),
                        Image.accord(image, attendue, mate, ciel)));
            }
        } catch (Arret | Dialogue.Echec e) {
            return new Verdict(Etat.RATE, e.getMessage());
        }
        double part = accord >= TOUT ? 1 : Math.max(0, Math.min(3, Math.round(4 * (accord - RIEN) / (TOUT - RIEN)))) / 4.0;
        return new Verdict(part == 1 ? Etat.REUSSI : part > 0 ? Etat.PARTIEL : Etat.RATE, String.format(Locale.FRANCE,
                "mesuré sur « %s » : ce que votre extension change à votre base ressemble à %.0f %% à ce qu'on attend ; "
                + "tous les points à partir de %.0f %%, aucun jusqu'à %.0f %%, sauf avis de l'enseignant",
                TITRES.get(nom)[2], 100 * accord, 100 * TOUT, 100 * RIEN), part);
    }

    /** La scène, avec ce que l'énoncé laisse choisir : la couleur de la brume, la puissance de Blinn. */
    private List<String> attendues() {
        List<String> scenes = new ArrayList<>(List.of(scene));
        if (nom.equals("blinn")) {
            for (int facteur : new int[] {2, 4}) {
                scenes.add(Pattern.compile("(?m)^ns=(\\S+)").matcher(scene)
                        .replaceAll(m -> "ns=" + facteur * Double.parseDouble(m.group(1))));
            }
        } else if (nom.equals("brume")) {
            for (int k = 0; k < 27; k++) {
                scenes.add(scene + "\n[Brume]\ndensite=0.05\ncouleur=" + TEINTES[k / 9] + " " + TEINTES[k / 3 % 3] + " " + TEINTES[k % 3]
                        + "\n");
            }
        }
        return scenes;
    }

    private Image dessin(Assemblage assemblage, String texte) throws Arret {
        return juge.tracer(assemblage, texte, 80, 60, 1);
    }
}
