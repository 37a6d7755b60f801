package lancer.auto;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import lancer.Constantes;
import lancer.commande.Etape;
import lancer.commande.Reglages;
import lancer.contrat.Variante;

/** Les réglages que l'on essaie pour une scène, du moins cher au plus juste. */
public final class Echelle {

    /** Nombre de réflexions d'un rayon que rien ne limite. */
    static final int PROFONDEUR = 1000;
    /** Les réflexions des échelons d'une scène dont aucune variante ne propose de sections. */
    private static final int[] REFLETS = {0, 1, 2, Constantes.MAX_REFLETS, PROFONDEUR};

    private Echelle() {
    }

    /**
     * L'échelle d'une scène. Chaque échelon ne change de ses réglages que la section de la variante essayée, les
     * réflexions et le seuil.
     *
     * @param presents les réglages de la scène lue
     * @param gardeReflets vrai si le nombre de réflexions n'est pas à choisir ; de même pour le seuil
     * @return un échelon au moins
     */
    public static List<Reglages> de(Reglages presents, boolean gardeReflets, boolean gardeSeuil) {
        List<Reglages> echelle = new ArrayList<>();
        boolean fixes = gardeReflets || presents.getEtape() != Etape.REFLETS;
        Variante essayee = presents.getEssayee();
        if (essayee != null) {
            int reflets = fixes ? presents.getReflets() : PROFONDEUR;
            presents.getSectionsProposees(essayee).forEach((section, seuil) -> echelle.add(presents
                    .avecSection(essayee, section).avecReflets(reflets)
                    .avecSeuil(gardeSeuil ? presents.getSeuil() : seuil)));
            return echelle;
        }
        Reglages base = gardeSeuil ? presents : presents.avecSeuil(Constantes.SEUIL);
        if (fixes) {
            return Collections.singletonList(base);
        }
        for (int reflets : REFLETS) {
            echelle.add(base.avecReflets(reflets));
        }
        return echelle;
    }

    /** Texte d'un échelon : la section à écrire dans la scène, et les options. */
    public static String dire(Reglages echelon) {
        Variante essayee = echelon.getEssayee();
        String deLaScene = echelon.getModele().getEchantillonnage() == null ? "un rayon par pixel"
                : "l'échantillonnage de la scène";
        String echantillonnage = essayee != null ? echelon.getSection(essayee).toString() : deLaScene;
        return echantillonnage + ", --reflets " + echelon.getProfondeur() + " --seuil "
                + BigDecimal.valueOf(echelon.getSeuil()).toPlainString();
    }
}
