package lancer.auto;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import lancer.Constantes;
import lancer.Lancer;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.ReglagePropose;
import lancer.contrat.Section;
import lancer.contrat.Variante;

/** Un échelon : un réglage complet d'une scène, parmi ceux que l'on essaie du moins cher au plus juste. Immuable. */
public final class Echelon {

    /** Nombre de réflexions d'un rayon que rien ne limite. */
    static final int PROFONDEUR = 1000;
    /** Les échelons d'une scène dont aucune variante ne propose de réglages. */
    private static final int[] REFLETS = {0, 1, 2, Constantes.MAX_REFLETS, PROFONDEUR};

    /** Section de la variante d'échantillonnage, ou {@code null} sans section ; réflexions, seuil des reflets. */
    public final Section section;
    public final int reflets;
    public final double seuil;
    final Echantillonnage echantillonnage;

    public Echelon(Section section, Echantillonnage echantillonnage, int reflets, double seuil) {
        this.section = section;
        this.echantillonnage = echantillonnage;
        this.reflets = reflets;
        this.seuil = seuil;
    }

    /**
     * L'échelle d'une scène, du moins cher au plus juste.
     *
     * @param modele celui de la scène, dont l'échantillonnage sert si aucune variante ne propose de réglages
     * @param variantes celles qui en proposent, chacune avec sa section
     * @param reflets nombre de réflexions ; {@code null} s'il est à choisir ; de même le seuil
     * @throws lancer.SceneFautive si une variante propose un réglage fautif
     */
    public static List<Echelon> echelle(Modele modele, Map<Variante, Section> variantes, Integer reflets,
            Double seuil) {
        List<Echelon> echelle = new ArrayList<>();
        variantes.forEach((variante, sienne) -> {
            for (ReglagePropose propose : Objects.requireNonNull(variante.getReglagesProposes(sienne),
                    variante.getClass().getName() + ".getReglagesProposes a rendu null")) {
                Modele essaye = new Modele();
                variante.installer(propose.section, essaye);
                propose.section.verifierCles();
                echelle.add(new Echelon(propose.section, essaye.getEchantillonnage(),
                        reflets == null ? PROFONDEUR : reflets, seuil == null ? propose.seuil : seuil));
            }
        });
        for (int k = 0; variantes.isEmpty() && k < (reflets == null ? REFLETS.length : 1); k++) {
            echelle.add(new Echelon(null, modele.getEchantillonnage(), reflets == null ? REFLETS[k] : reflets,
                    seuil == null ? Constantes.SEUIL : seuil));
        }
        return echelle;
    }

    /** Le lancer qui dessine avec cet échelon, à sa profondeur, la scène de ce lancer, déjà préparée. */
    public Lancer lancer(Lancer prepare) {
        return new Lancer(prepare.getScene().avec(prepare.getScene().getModele().avec(echantillonnage, seuil)),
                prepare.getCamera());
    }

    /** Texte de ce réglage : la section à écrire dans la scène, et les options. */
    @Override
    public String toString() {
        return (section != null ? section.toString() : echantillonnage == null ? "un rayon par pixel"
                : "l'échantillonnage de la scène") + ", --reflets " + reflets + " --seuil "
                + BigDecimal.valueOf(seuil).toPlainString();
    }
}
