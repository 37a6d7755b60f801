package lancer.dessin;

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
import lancer.rapide.Temoins;

/** Un {@link Traceur} dont des {@link Temoins} jugent la recherche ; si elle se trompe, les boucles dessinent. */
public final class LancerSurveille extends Traceur {

    private volatile String ecart;
    private int nombre;
    /** Le temps des témoins tirés depuis le dernier dessin, et celui du dernier dessin, eux compris. */
    private long jugementNs;
    private long dureeNs;
    /** Ce qui se construit, et le temps que cela avait pris à la fin de la préparation, et au dernier dessin. */
    private final Recherche construite;
    private final long prepareNs;
    private long construitNs;
    /** La recherche jugée, et à quelle profondeur : refaire le même dessin n'en apprend rien. */
    private Recherche jugee;
    private int profondeurJugee;

    public LancerSurveille(Scene scene, Camera camera) {
        super(scene, camera);
        construite = scene.getModele().getRecherche();
        prepareNs = construitNs();
        construitNs = prepareNs;
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
        juger(profondeur);
        super.TracerImage(toile, profondeur, fils);
    }

    /** {@inheritDoc} Si personne ne regarde encore l'image, ses témoins viennent après elle. */
    @Override
    public void TracerPixels(Toile toile, int profondeur, int fils) {
        super.TracerPixels(toile, profondeur, fils);
        dureeNs = super.getDureeNs();
        if (juger(profondeur)) {
            super.TracerPixels(toile, profondeur, fils);
            dureeNs += super.getDureeNs();
        }
        long construit = construitNs();
        dureeNs += jugementNs - (construit - construitNs);
        construitNs = construit;
        jugementNs = 0;
        getCompteurs().pixelsTemoins = nombre;
    }

    private long construitNs() {
        return construite instanceof RechercheRapide ? ((RechercheRapide) construite).getConstructionNs() : 0;
    }

    /** Juge la recherche, si elle ne l'est pas encore. @return vrai si les boucles du cours la remplacent */
    private boolean juger(int profondeur) {
        Recherche recherche = getScene().getModele().getRecherche();
        if (!(recherche instanceof RechercheRapide) || recherche == jugee && profondeur == profondeurJugee) {
            return false;
        }
        jugee = recherche;
        profondeurJugee = profondeur;
        long debut = System.nanoTime();
        Temoins temoins = new Temoins(getScene(), getCamera(), profondeur);
        if (getFautes() != null) {
            temoins.tolerer(getFautes());
        }
        temoins.juger();
        nombre = temoins.getNombre();
        ecart = temoins.getEcart();
        if (ecart != null) {
            getScene().getModele().setRecherche(new RechercheSimple(getScene().getObjets(), getScene().getCompteurs()));
        }
        jugementNs = System.nanoTime() - debut;
        return ecart != null;
    }

    @Override
    public String getEcart() {
        return ecart;
    }

    /** {@inheritDoc} Celui des témoins est compris, celui d'une construction ne l'est pas. */
    @Override
    public long getDureeNs() {
        return dureeNs;
    }

    @Override
    public long getConstructionNs() {
        return construitNs - prepareNs;
    }
}
