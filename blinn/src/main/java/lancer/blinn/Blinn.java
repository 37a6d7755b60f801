package lancer.blinn;

import java.util.Collections;
import java.util.List;
import java.util.function.DoubleFunction;
import lancer.Vecteur;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Specularite;
import lancer.contrat.Variante;

/** Le reflet de Blinn (cours) : max(0, N·H)^(facteur·ns), où H est la bissectrice de L et −V. Immuable. */
public final class Blinn implements Variante, Specularite {

    private static final double FACTEUR = 1;

    private final double facteur;

    /** Le reflet d'une scène sans section {@code [Blinn]}. */
    public Blinn() {
        this(FACTEUR);
    }

    /** @param facteur multiplie ns, plus grand que 0 */
    Blinn(double facteur) {
        this.facteur = facteur;
    }

    @Override
    public String getSection() {
        return "Blinn";
    }

    @Override
    public void installer(Section valeurs, Modele.Construction modele) {
        modele.setSpecularite(new Blinn(valeurs.reel("facteur", FACTEUR, Double.MIN_VALUE, Double.MAX_VALUE)));
    }

    @Override
    public List<Parametre> getParametres() {
        return Collections.singletonList(Parametre.nombre("facteur", FACTEUR, 0.1, 10, 0.1));
    }

    @Override
    public double eclat(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns) {
        double cosinus = cosinus(V, N, L);
        return Double.isNaN(cosinus) ? 0 : Specularite.puissance(cosinus, facteur * ns);
    }

    /** N·H ; NaN si L = V : la bissectrice n'existe pas, et le reflet est nul. */
    private static double cosinus(Vecteur V, Vecteur N, Vecteur L) {
        Vecteur H = L.sub(V);
        return N.dot(H) / H.norme();
    }

    @Override
    public String dire(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns, DoubleFunction<String> nombre) {
        return Specularite.puissance("N·H", cosinus(V, N, L), facteur * ns, nombre);
    }
}
