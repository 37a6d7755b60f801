package lancer.auto;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.commande.Etape;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.contrat.Variante;

/** Les réglages que l'on essaie pour une scène, du moins cher au plus juste. */
public final class Echelle {

    /** Nombre de réflexions d'un rayon que rien ne limite. */
    static final int PROFONDEUR = 1000;

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
        boolean fixes = gardeReflets || presents.get(Option.ETAPE) != Etape.REFLETS;
        Variante essayee = presents.getEssayee();
        if (essayee == null) {
            Reglages base = gardeSeuil ? presents : presents.avec(Option.SEUIL, Constantes.SEUIL);
            int[] reflets = fixes ? new int[] {presents.get(Option.REFLETS)}
                    : new int[] {0, 1, 2, Constantes.MAX_REFLETS, PROFONDEUR};
            return Arrays.stream(reflets).mapToObj(n -> base.avec(Option.REFLETS, n)).collect(Collectors.toList());
        }
        Reglages base = fixes ? presents : presents.avec(Option.REFLETS, PROFONDEUR);
        return essayee.getSectionsProposees(presents.getSection(essayee)).entrySet().stream()
                .map(proposee -> base.avecSection(essayee, proposee.getKey())
                        .avec(Option.SEUIL, gardeSeuil ? presents.get(Option.SEUIL) : proposee.getValue()))
                .collect(Collectors.toList());
    }

    /** Texte d'un échelon : la section à écrire dans la scène, et les options. */
    public static String dire(Reglages echelon) {
        return direLEchantillonnage(echelon) + ", --reflets " + echelon.getProfondeur() + " --seuil "
                + BigDecimal.valueOf(echelon.get(Option.SEUIL)).toPlainString();
    }

    /** La section à écrire dans la scène ou, à défaut, ce qui choisit les rayons. */
    public static String direLEchantillonnage(Reglages echelon) {
        Variante essayee = echelon.getEssayee();
        String deLaScene = echelon.getModele().getEchantillonnage().isPresent()
                ? "l'échantillonnage de la scène" : "un rayon par pixel";
        return essayee != null ? echelon.getSection(essayee).toString() : deLaScene;
    }
}
