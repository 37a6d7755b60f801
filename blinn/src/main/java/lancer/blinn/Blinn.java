package lancer.blinn;

import java.util.Collections;
import java.util.List;
import lancer.Vecteur;
import lancer.contrat.Ecoute;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Specularite;
import lancer.contrat.Variante;

/**
 * Le reflet de Blinn (cours, « Reflet spéculaire de Blinn ») : max(0, N·H)^(facteur·ns), H étant la bissectrice de L et
 * −V. Immuable.
 */
public final class Blinn implements Variante, Specularite {

    private static final double FACTEUR = 1;

    private final double facteur;
    /** Auditeur de la scène ; d'ordinaire {@code null}. */
    private final Ecoute ecoute;

    /** Le reflet d'une scène qui n'en dit rien. */
    public Blinn() {
        this(FACTEUR);
    }

    /** @param facteur ce qui multiplie ns, plus grand que 0 */
    Blinn(double facteur) {
        this(facteur, null);
    }

    private Blinn(double facteur, Ecoute ecoute) {
        this.facteur = facteur;
        this.ecoute = ecoute;
    }

    @Override
    public String getSection() {
        return "Blinn";
    }

    @Override
    public void installer(Section valeurs, Modele modele) {
        modele.setSpecularite(new Blinn(valeurs.reelPositif("facteur", FACTEUR, Double.MAX_VALUE)));
    }

    @Override
    public List<Parametre> getParametres() {
        return Collections.singletonList(Parametre.nombre("facteur", FACTEUR, 0.1, 10, 0.1));
    }

    @Override
    public double eclat(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns) {
        Vecteur H = L.sub(V);
        double norme = H.norme();
        // la lampe est droit derrière le contact : il n'y a pas de bissectrice, et rien à refléter
        if (norme == 0) {
            return 0;
        }
        double base = N.dot(H) / norme;
        Ecoute.reflet(ecoute, base, facteur * ns);
        return Specularite.puissance(base, facteur * ns);
    }

    @Override
    public Specularite quiDit(Ecoute autre) {
        return new Blinn(facteur, autre);
    }

    @Override
    public String nomDeLaBase() {
        return "N·H";
    }
}
