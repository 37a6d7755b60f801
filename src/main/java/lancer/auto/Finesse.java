package lancer.auto;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Reglable;
import lancer.contrat.Section;
import lancer.contrat.Variante;

/** Un échantillonnage possible de la scène, et ce que les essais en disent. */
final class Finesse {

    /** La section de variante qui la donne ; {@code null} pour celle de la scène. */
    final Section section;
    final Echantillonnage echantillonnage;

    /** Contre les mêmes pixels, d'une moyenne exacte ; {@code null} tant que rien n'est essayé. */
    Estimation erreur;

    /** De l'écran, par pixel ; et leur prix avec ceux qu'ils lancent, celui d'un rayon par pixel étant 1. */
    double rayons;
    double prix;

    private Finesse(Section section, Echantillonnage echantillonnage) {
        this.section = section;
        this.echantillonnage = echantillonnage;
    }

    /**
     * Celles que proposent ces variantes ; sinon celle de la scène, seule.
     *
     * @throws lancer.SceneFautive si une variante propose une section fautive
     */
    static List<Finesse> possibles(Scene scene, List<Variante> variantes) {
        List<Finesse> finesses = new ArrayList<>();
        for (Variante variante : variantes) {
            if (variante instanceof Reglable) {
                for (Section reglage : Objects.requireNonNull(((Reglable) variante).getReglages(),
                        variante.getClass().getName() + ".getReglages a rendu null")) {
                    Modele modele = new Modele();
                    variante.installer(reglage, modele);
                    reglage.verifierCles();
                    finesses.add(new Finesse(reglage, modele.getEchantillonnage()));
                }
            }
        }
        if (finesses.isEmpty()) {
            finesses.add(de(scene));
        }
        return finesses;
    }

    /** Celle de la scène. */
    static Finesse de(Scene scene) {
        return new Finesse(null, scene.getModele().getEchantillonnage());
    }

    /** Comment l'obtenir soi-même. */
    @Override
    public String toString() {
        return section != null ? section.toString()
                : echantillonnage == Echantillonnage.CENTRE ? "un rayon par pixel" : "l'échantillonnage de la scène";
    }
}
