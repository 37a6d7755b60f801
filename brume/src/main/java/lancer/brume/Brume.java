package lancer.brume;

import java.util.Arrays;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.contrat.Atmosphere;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.texte.Texte;

/**
 * Brume de distance (cours, « Extensions ») : couleur finale = k·brume + (1 − k)·couleur de l'objet, sur le premier
 * rayon comme sur chaque rayon réfléchi, k dépendant de la longueur de ce rayon-là. Immuable.
 */
public final class Brume implements Variante, Atmosphere {

    private static final Couleur COULEUR = new Couleur(0.8);
    private static final double COULEUR_MAX = 1e6;
    private static final double DEBUT = 0;
    private static final double FIN = 30;

    private final Couleur couleur;
    private final LoiBrume loi;

    /** La brume d'une scène qui n'en dit rien. */
    public Brume() {
        this(COULEUR, new LoiBrume.Lineaire(DEBUT, FIN));
    }

    Brume(Couleur couleur, LoiBrume loi) {
        this.couleur = couleur;
        this.loi = loi;
    }

    @Override
    public String getSection() {
        return "Brume";
    }

    @Override
    public void installer(Section valeurs, Modele modele) {
        modele.setAtmosphere(new Brume(valeurs.couleur("couleur", COULEUR, COULEUR_MAX), loi(valeurs)));
    }

    @Override
    public List<Parametre> getParametres() {
        return Arrays.asList(Parametre.couleur("couleur", "0.8 0.8 0.8"), Parametre.nombre("debut", DEBUT, 0, 30, 0.5),
                Parametre.nombre("fin", FIN, 1, 100, 1).sans("densite"),
                Parametre.nombre("densite", null, 0, 0.5, 0.005).sans("fin"));
    }

    /** La loi demandée, par {@code densite} si elle est donnée, sinon par {@code fin}. */
    private static LoiBrume loi(Section valeurs) {
        double debut = valeurs.reel("debut", DEBUT, 0, Double.MAX_VALUE);
        if (!valeurs.contient("densite")) {
            double fin = valeurs.reel("fin", FIN, 0, Double.MAX_VALUE);
            if (debut >= fin) {
                throw valeurs.fautive(valeurs.contient("debut") ? "debut" : "fin", "la brume commencerait à "
                        + Texte.cite(valeurs.mot("debut", "0")) + " et finirait à "
                        + Texte.cite(valeurs.mot("fin", "30")),
                        "debut plus petit que fin (à défaut, 0 et 30)");
            }
            return new LoiBrume.Lineaire(debut, fin);
        }
        double densite = valeurs.reel("densite", 0, 0, Double.MAX_VALUE);
        if (valeurs.contient("fin")) {
            throw valeurs.fautive("densite", "donnée en même temps que fin", "fin ou densite, pas les deux");
        }
        return new LoiBrume.Exponentielle(debut, densite);
    }

    @Override
    public Couleur traverser(Couleur vue, double distance) {
        double k = k(distance);
        return couleur.mul(k).add(vue.mul(1 - k));
    }

    /** Un rayon qui ne rencontre rien traverse toute la brume : il ne voit qu'elle, si légère soit-elle. */
    @Override
    public double k(double distance) {
        return distance == Constantes.INFINI ? 1 : loi.k(distance);
    }
}
