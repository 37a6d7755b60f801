package lancer.temoins;

import java.util.Collections;
import java.util.function.IntConsumer;
import lancer.Camera;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.contrat.Suivi;
import lancer.contrat.Temoignage;
import lancer.contrat.Toile;
import lancer.fils.Equipe;
import lancer.rapide.Preparation;
import lancer.rapide.RechercheRapide;

/** Un {@link Lancer} dont des {@link Temoins} jugent la recherche ; si elle se trompe, les boucles dessinent. */
public final class LancerSurveille extends Lancer {

    private volatile Temoignage temoignage = Temoignage.SANS_OBJET;
    private Temoins temoins;
    private boolean tires;
    private long jugementNs;
    /** La recherche dont parle ce témoignage, et à quelle profondeur : refaire le même dessin n'en apprend rien. */
    private Recherche jugee;
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
    public static Lancer preparer(Scene scene, int largeur, int hauteur, boolean simple) {
        return preparer(scene, largeur, hauteur, simple, Suivi.AUCUN);
    }

    /** De même, en disant à {@code suivi} la part faite, de 0 à 1, après chaque étape. */
    public static Lancer preparer(Scene scene, int largeur, int hauteur, boolean simple, Suivi suivi) {
        Camera camera = new Camera(largeur, hauteur);
        scene.setRecherche(simple ? new RechercheSimple(scene.getObjets(), scene.getCompteurs())
                : Preparation.pour(scene, camera, suivi));
        return new LancerSurveille(scene, camera);
    }

    @Override
    public Lancer avec(Echantillonnage echantillonnage, double seuil) {
        return new LancerSurveille(getScene().avec(echantillonnage, seuil), getCamera());
    }

    /** {@inheritDoc} Des témoins sont tirés au hasard avant le brouillon, que l'on regarde déjà. */
    @Override
    public void TracerImage(Toile toile, int profondeur, int fils) {
        jugementNs = 0;
        juger(profondeur, true);
        super.TracerImage(toile, profondeur, fils);
    }

    /** {@inheritDoc} Personne ne regarde encore l'image : ses témoins viennent tous après elle. */
    @Override
    public void TracerPixels(Toile toile, int profondeur, int fils) {
        boolean juste = temoignage.ecart == null;
        super.TracerPixels(toile, profondeur, fils);
        if (!tires) {
            jugementNs = 0;
            juger(profondeur, true);
        }
        juger(profondeur, false);
        tires = false;
        if (juste && temoignage.ecart != null) {
            super.TracerPixels(toile, profondeur, fils);
        }
        getCompteurs().pixelsTemoins = temoignage.pixels;
        getCompteurs().examensEssais = jugee instanceof RechercheRapide ? ((RechercheRapide) jugee).getEssais() : 0;
    }

    /**
     * Fait juger la recherche, dans un fil dont la pile suffit aux réflexions permises.
     *
     * @param auHasard vrai pour des témoins tirés au hasard, faux pour d'autres, choisis
     * @throws lancer.contrat.PixelFautif si un témoin ne peut être calculé
     */
    private void juger(int profondeur, boolean auHasard) {
        tires = true;
        Recherche recherche = getScene().getRecherche();
        if (!(recherche instanceof RechercheRapide) || recherche == jugee && profondeur == profondeurJugee) {
            return;
        }
        long debut = System.nanoTime();
        if (auHasard) {
            temoins = new Temoins((RechercheRapide) recherche, this, profondeur);
        }
        Temoignage avant = temoignage;
        new Equipe("temoins").faire(1, Collections.singletonList(new IntConsumer() {
            @Override
            public void accept(int rang) {
                temoignage = auHasard ? temoins.auHasard() : new Temoignage(avant.pixels, temoins.choisis().ecart);
            }
        }));
        if (!auHasard) {
            jugee = recherche;
            profondeurJugee = profondeur;
        }
        if (temoignage.ecart != null) {
            getScene().setRecherche(new RechercheSimple(getScene().getObjets(), getScene().getCompteurs()));
        }
        jugementNs += System.nanoTime() - debut;
    }

    @Override
    public Temoignage getTemoignage() {
        return temoignage;
    }

    /** {@inheritDoc} Celui des témoins est compris. */
    @Override
    public long getDureeNs() {
        return super.getDureeNs() + jugementNs;
    }
}
