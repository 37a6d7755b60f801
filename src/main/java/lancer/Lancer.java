package lancer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.contrat.Temoignage;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import lancer.fils.Equipe;

/**
 * L'algorithme : de la scène à l'image (cours, « Algorithme général »). Un {@code Lancer} dessine une image à la fois.
 */
public class Lancer {

    private final Scene scene;
    private final Camera camera;
    private final Equipe equipe = new Equipe("lancer");
    private volatile boolean brouillonFait;
    private volatile Temoignage temoignage = Temoignage.SANS_OBJET;
    /** La recherche dont parle ce témoignage, et à quelle profondeur : refaire le même dessin n'en apprend rien. */
    private Recherche jugee;
    private int profondeurJugee;
    private Compteurs compteurs = new Compteurs();
    private long dureeNs;

    public Lancer(Scene scene, Camera camera) {
        this.scene = scene;
        this.camera = camera;
    }

    public Scene getScene() {
        return scene;
    }

    public Camera getCamera() {
        return camera;
    }

    /**
     * La couleur vue à travers un point de l'écran, non limitée.
     *
     * @param xe en pixels depuis la gauche ; le centre du pixel i est i + 0,5
     * @param ye en pixels depuis le haut
     * @param profondeur nombre de réflexions permises
     */
    public Couleur getCouleurPixel(double xe, double ye, int profondeur) {
        scene.getCompteurs().primaires++;
        Rayon initial = camera.getRayon(xe, ye);
        return scene.getCouleurVue(initial, null, profondeur);
    }

    /**
     * {@link #getCouleurPixel}, ou un échec qui dit où.
     *
     * @throws PixelFautif si ce calcul échoue, ou si une composante n'est pas un nombre fini
     */
    public Couleur voir(double xe, double ye, int profondeur) {
        Couleur couleur;
        try {
            couleur = getCouleurPixel(xe, ye, profondeur);
        } catch (OutOfMemoryError e) {
            // ce n'est pas ce pixel qui est en cause
            throw e;
        } catch (RuntimeException | Error e) {
            throw new PixelFautif(xe, ye, e);
        }
        if (couleur == null || !couleur.estFinie()) {
            throw new PixelFautif(xe, ye,
                    new ArithmeticException("ce n'est pas une couleur aux composantes finies : " + couleur));
        }
        return couleur;
    }

    /**
     * Dessine un brouillon, puis tous les pixels.
     *
     * @param profondeur nombre de réflexions permises
     * @param fils nombre de fils d'exécution, au moins 1 ; l'image n'en dépend pas
     * @throws CancellationException si {@link #arreter()} a été appelé
     * @throws PixelFautif si un pixel ne peut être calculé
     */
    public void TracerImage(Toile toile, int profondeur, int fils) {
        long jugementNs = juger(profondeur, true);
        TracerBrouillon(toile, profondeur, fils);
        brouillonFait = true;
        boolean juste = temoignage.ecart == null;
        parcourir(scene.getEchantillonnage(), toile, profondeur, fils);
        if (juste) {
            jugementNs += juger(profondeur, false);
            if (temoignage.ecart != null) {
                parcourir(scene.getEchantillonnage(), toile, profondeur, fils);
            }
        }
        dureeNs += jugementNs;
    }

    /** Dessine des carrés de 4 × 4 pixels, chacun de la couleur de son centre, avec une réflexion au plus. */
    public void TracerBrouillon(Toile toile, int profondeur, int fils) {
        parcourir(new Brouillon(), toile, Math.min(profondeur, Constantes.REFLETS_BROUILLON), fils);
    }

    /**
     * Dessine tous les pixels, sans brouillon. Personne ne regarde encore l'image : ses témoins viennent tous après
     * elle.
     */
    public void TracerPixels(Toile toile, int profondeur, int fils) {
        parcourir(scene.getEchantillonnage(), toile, profondeur, fils);
        if (temoignage.ecart == null) {
            long jugementNs = juger(profondeur, true) + juger(profondeur, false);
            if (temoignage.ecart != null) {
                parcourir(scene.getEchantillonnage(), toile, profondeur, fils);
            }
            dureeNs += jugementNs;
        }
    }

    /** Abandonne le dessin en cours, au prochain rayon de chaque fil, et tous les suivants. */
    public void arreter() {
        equipe.arreter();
    }

    /** La part faite de l'image (ou du brouillon) en cours, de 0 à 1. */
    public double getAvancement() {
        return (double) equipe.getFaites() / Pave.nombre(camera.getLargeur(), camera.getHauteur());
    }

    /** Vrai dès que {@link #TracerImage} a fini le brouillon : chaque pixel de l'image a une couleur. */
    public boolean isBrouillonFait() {
        return brouillonFait;
    }

    /** Ce que des pixels témoins ont dit de la recherche du dernier dessin. */
    public Temoignage getTemoignage() {
        return temoignage;
    }

    /** Ce que le dernier dessin achevé a compté, tous fils ensemble. */
    public Compteurs getCompteurs() {
        return compteurs;
    }

    /** Le temps du dernier dessin achevé, celui des témoins compris, en nanosecondes. */
    public long getDureeNs() {
        return dureeNs;
    }

    /**
     * Fait juger la recherche de la scène ; si elle se trompe, les boucles du cours la remplacent.
     *
     * @param tires vrai pour des témoins tirés au hasard, faux pour d'autres, choisis
     * @return le temps que cela a pris, en nanosecondes
     * @throws PixelFautif si un témoin ne peut être calculé
     */
    private long juger(int profondeur, boolean tires) {
        long debut = System.nanoTime();
        if (temoignage.ecart != null || scene.getRecherche() == jugee && profondeur == profondeurJugee) {
            // déjà dit : s'il y a un écart, depuis, les boucles dessinent
            return 0;
        }
        int nombre = temoignage.pixels;
        new Equipe("temoins").faire(1, Collections.singletonList(new Jugement(profondeur, tires)));
        if (!tires) {
            temoignage = new Temoignage(nombre, temoignage.ecart);
            jugee = scene.getRecherche();
            profondeurJugee = profondeur;
        }
        compteurs.pixelsTemoins = temoignage.pixels;
        if (temoignage.ecart != null) {
            scene.setRecherche(new RechercheSimple(scene.getObjets(), scene.getCompteurs()));
        }
        return System.nanoTime() - debut;
    }

    /** La boucle sur l'image, dont chaque pavé est dessiné par cet échantillonnage ; personne ne juge la recherche. */
    public void parcourir(Echantillonnage echantillonnage, Toile toile, int profondeur, int fils) {
        long debut = System.nanoTime();
        int nombre = Pave.nombre(camera.getLargeur(), camera.getHauteur());
        List<Fil> ouvriers = new ArrayList<>();
        for (int k = 0; k < Math.min(fils, nombre); k++) {
            ouvriers.add(new Fil(echantillonnage, toile, profondeur));
        }
        equipe.faire(nombre, ouvriers);
        Compteurs total = new Compteurs();
        for (Fil fil : ouvriers) {
            total.ajouter(fil.sien.scene.getCompteurs());
        }
        total.pixelsTemoins = temoignage.pixels;
        compteurs = total;
        dureeNs = System.nanoTime() - debut;
    }

    /** Le travail d'un fil : des pavés, vus à travers sa propre vue de la scène. */
    private final class Fil implements IntConsumer, Vue {

        private final Lancer sien = new Lancer(scene.pourUnFil(), camera);
        private final Echantillonnage echantillonnage;
        private final Toile toile;
        private final int profondeur;

        Fil(Echantillonnage echantillonnage, Toile toile, int profondeur) {
            this.echantillonnage = echantillonnage;
            this.toile = toile;
            this.profondeur = profondeur;
        }

        @Override
        public void accept(int rang) {
            Pave pave = Pave.eparpille(rang, camera.getLargeur(), camera.getHauteur());
            sien.scene.getCompteurs().pixelsRaffines += echantillonnage.tracer(pave, this, toile);
        }

        /** La couleur vue, et le seul endroit où l'arrêt est observé : avant chaque rayon. */
        @Override
        public Couleur couleur(double xe, double ye) {
            equipe.verifier();
            return sien.voir(xe, ye, profondeur);
        }
    }

    private final class Jugement implements IntConsumer {

        private final int profondeur;
        private final boolean tires;

        Jugement(int profondeur, boolean tires) {
            this.profondeur = profondeur;
            this.tires = tires;
        }

        @Override
        public void accept(int rang) {
            temoignage = scene.getRecherche().juger(Lancer.this, profondeur, tires);
        }
    }

    /** Un rayon pour seize pixels ; sur les bords, au centre de la part du carré qui est dans l'image. */
    private static final class Brouillon implements Echantillonnage {
        @Override
        public int tracer(Pave pave, Vue vue, Toile toile) {
            int pas = Constantes.PAS_BROUILLON;
            for (int j = pave.j0; j < pave.j1; j += pas) {
                int jFin = Math.min(j + pas, pave.j1);
                for (int i = pave.i0; i < pave.i1; i += pas) {
                    int iFin = Math.min(i + pas, pave.i1);
                    Couleur couleur = vue.couleur((i + iFin) / 2.0, (j + jFin) / 2.0);
                    for (int y = j; y < jFin; y++) {
                        for (int x = i; x < iFin; x++) {
                            toile.drawPixel(couleur, x, y);
                        }
                    }
                }
            }
            return 0;
        }
    }
}
