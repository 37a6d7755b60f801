package lancer.temoins;

import java.util.Collections;
import java.util.function.DoubleConsumer;
import lancer.Camera;
import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.contrat.Toile;
import lancer.fils.Traceur;
import lancer.rapide.Preparation;
import lancer.rapide.RechercheRapide;

/** Un {@link Traceur} dont des {@link Temoins} jugent la recherche ; si elle se trompe, les boucles dessinent. */
public final class LancerSurveille extends Traceur {

    private volatile String ecart;
    /** Ceux du dessin en cours, {@code null} s'ils ne sont pas tirés, ou n'ont plus rien à dire. */
    private Temoins temoins;
    private int nombre;
    private long jugementNs;
    /** La recherche qu'ils jugent ou ont jugée, et à quelle profondeur : refaire le même dessin n'en apprend rien. */
    private RechercheRapide jugee;
    private int profondeurJugee;

    public LancerSurveille(Scene scene, Camera camera) {
        super(scene, camera);
    }

    /**
     * Prépare une scène pour une image de cette taille : tout dessin du programme passe par ici, et ceux qu'on mesure
     * aussi.
     *
     * @param simple vrai pour les boucles du cours
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     */
    public static Traceur preparer(Scene scene, int largeur, int hauteur, boolean simple) {
        return preparer(scene, largeur, hauteur, simple, part -> { });
    }

    /** De même, en disant à {@code suivi} la part faite, de 0 à 1, après chaque étape. */
    public static Traceur preparer(Scene scene, int largeur, int hauteur, boolean simple, DoubleConsumer suivi) {
        Camera camera = new Camera(largeur, hauteur);
        scene.getModele().setRecherche(simple ? new RechercheSimple(scene.getObjets(), scene.getCompteurs())
                : Preparation.pour(scene, camera, suivi));
        return new LancerSurveille(scene, camera);
    }

    @Override
    public Traceur avec(Echantillonnage echantillonnage, double seuil) {
        return new LancerSurveille(getScene().avec(getScene().getModele().avec(echantillonnage, seuil)), getCamera());
    }

    /** {@inheritDoc} Des témoins sont tirés au hasard avant le brouillon, que l'on regarde déjà. */
    @Override
    public void TracerImage(Toile toile, int profondeur, int fils) {
        tirer(profondeur);
        super.TracerImage(toile, profondeur, fils);
    }

    /** {@inheritDoc} Si personne ne regarde encore l'image, ses témoins viennent tous après elle. */
    @Override
    public void TracerPixels(Toile toile, int profondeur, int fils) {
        boolean juste = ecart == null;
        super.TracerPixels(toile, profondeur, fils);
        if (temoins == null) {
            tirer(profondeur);
        }
        if (temoins != null) {
            juger();
            temoins = null;
        }
        if (juste && ecart != null) {
            super.TracerPixels(toile, profondeur, fils);
        }
        getCompteurs().pixelsTemoins = nombre;
        getCompteurs().examensEssais = jugee == null ? 0 : jugee.getEssais();
    }

    /** Tire des témoins au hasard, si cette recherche en a besoin. */
    private void tirer(int profondeur) {
        jugementNs = 0;
        Recherche recherche = getScene().getModele().getRecherche();
        if (recherche instanceof RechercheRapide && (recherche != jugee || profondeur != profondeurJugee)) {
            jugee = (RechercheRapide) recherche;
            profondeurJugee = profondeur;
            temoins = new Temoins(jugee, getLancer(), profondeur);
            juger();
        }
    }

    /**
     * Fait juger la recherche, dans un fil dont la pile suffit aux réflexions permises.
     *
     * @throws lancer.contrat.PixelFautif si un témoin ne peut être calculé
     */
    private void juger() {
        long debut = System.nanoTime();
        temoins.equipe.faire(1, Collections.singletonList(temoins));
        nombre = temoins.nombre;
        ecart = temoins.ecart;
        if (ecart != null) {
            temoins = null;
            getScene().getModele().setRecherche(new RechercheSimple(getScene().getObjets(), getScene().getCompteurs()));
        }
        jugementNs += System.nanoTime() - debut;
    }

    @Override
    public String getEcart() {
        return ecart;
    }

    /** {@inheritDoc} Celui des témoins est compris. */
    @Override
    public long getDureeNs() {
        return super.getDureeNs() + jugementNs;
    }
}
