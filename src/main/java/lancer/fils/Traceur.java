package lancer.fils;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import lancer.Camera;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Boucle;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Recherche;
import lancer.contrat.Toile;

/**
 * Le dessin d'une scène par plusieurs fils : le partage de l'image en pavés, l'arrêt, l'avancement, les comptes. Un
 * traceur dessine une image à la fois ; elle ne dépend pas du nombre de fils.
 */
public final class Traceur implements Boucle {

    private final Lancer lancer;
    private final Equipe equipe = new Equipe("lancer");
    /** Recherche de la scène préparée, et le temps qu'elle avait passé à construire dans la préparation, puis ici. */
    private final Recherche preparee;
    private final long prepareNs;
    private long construitNs;
    private volatile boolean brouillonFait;
    private volatile Fautes fautes;
    private Runnable entracte;
    private Compteurs compteurs = new Compteurs();
    private long dureeNs;

    public Traceur(Scene scene, Camera camera) {
        lancer = new Lancer(scene, camera);
        preparee = scene.getModele().getRecherche();
        prepareNs = preparee.getConstructionNs();
    }

    /** L'algorithme, pour un seul fil. */
    public Lancer getLancer() {
        return lancer;
    }

    public Scene getScene() {
        return lancer.getScene();
    }

    public Camera getCamera() {
        return lancer.getCamera();
    }

    /** Traceur de la même scène, à cet échantillonnage et ce seuil : ce que compare {@code --auto}. */
    public Traceur avec(Echantillonnage echantillonnage, double seuil) {
        return new Traceur(getScene().avec(getScene().getModele().avec(echantillonnage, seuil)), getCamera());
    }

    /**
     * Dessine un brouillon, puis tous les pixels ({@link Lancer#TracerImage}).
     *
     * @param profondeur nombre de réflexions permises
     * @param fils nombre de fils d'exécution, au moins 1
     * @throws CancellationException si {@link #arreter()} a été appelé
     * @throws PixelFautif si un pixel ne peut être calculé
     */
    public void TracerImage(Toile toile, int profondeur, int fils) {
        lancer.TracerImage(this, toile, profondeur, fils);
    }

    @Override
    public void TracerBrouillon(Toile toile, int profondeur, int fils) {
        parcourir(Echantillonnage.BROUILLON, toile, profondeur, fils);
        brouillonFait = true;
        if (entracte != null) {
            entracte.run();
        }
    }

    /** Fait faire ceci entre le brouillon et l'image. */
    public void setEntracte(Runnable entracte) {
        this.entracte = entracte;
    }

    @Override
    public void TracerPixels(Toile toile, int profondeur, int fils) {
        long duree = parcourir(getScene().getModele().getEchantillonnage(), toile, profondeur, fils);
        long construit = getConstructionNs();
        dureeNs = duree - (construit - construitNs);
        construitNs = construit;
    }

    /** Dessine désormais malgré les pixels qui échouent : ils sont comptés, et peints en damier. */
    public void tolerer() {
        fautes = new Fautes(getCamera().getLargeur());
    }

    /** Les pixels qui ont échoué ; {@code null} s'ils arrêtent le dessin. */
    public Fautes getFautes() {
        return fautes;
    }

    /** Abandonne le dessin en cours, dans les 50 millisecondes, et tous les suivants. */
    public void arreter() {
        equipe.arreter();
    }

    /** La part faite de l'image (ou du brouillon) en cours, de 0 à 1. */
    public double getAvancement() {
        return (double) equipe.getFaites() / Pave.nombre(getCamera().getLargeur(), getCamera().getHauteur(), Pave.COTE);
    }

    /** Dit si le brouillon est fini : chaque pixel de l'image a une couleur. */
    public boolean isBrouillonFait() {
        return brouillonFait;
    }

    /** Raison pour laquelle les boucles du cours remplacent la recherche rapide, en une phrase, ou {@code null}. */
    public String getEcart() {
        return preparee.getEcart();
    }

    /** Comptes du dernier dessin achevé, tous fils ensemble. */
    public Compteurs getCompteurs() {
        return compteurs;
    }

    /** Le temps du dernier dessin achevé, en nanosecondes. */
    public long getDureeNs() {
        return dureeNs;
    }

    /** Le temps passé depuis la préparation à construire ce que des rayons ont demandé, en nanosecondes. */
    public long getConstructionNs() {
        return preparee.getConstructionNs() - prepareNs;
    }

    /** Dessine toute l'image par cet échantillonnage. @return le temps que cela a pris, en nanosecondes */
    public long parcourir(Echantillonnage echantillonnage, Toile toile, int profondeur, int fils) {
        long debut = System.nanoTime();
        int nombre = Pave.nombre(getCamera().getLargeur(), getCamera().getHauteur(), Pave.COTE);
        Echantillonnage prepare = echantillonnage.pour(getScene().getObjets(), getCamera());
        List<Fil> ouvriers = new ArrayList<>();
        for (int k = 0; k < Math.min(fils, nombre); k++) {
            ouvriers.add(new Fil(prepare, toile, profondeur));
        }
        equipe.faire(nombre, ouvriers);
        Compteurs total = new Compteurs();
        for (Fil fil : ouvriers) {
            total.ajouter(fil.sien.getScene().getCompteurs());
        }
        compteurs = total;
        return System.nanoTime() - debut;
    }

    /** Le travail d'un fil : des pavés, vus à travers sa propre vue de la scène. */
    private final class Fil implements IntConsumer {

        private final Lancer sien = new Lancer(getScene().avec(getScene().getModele()), getCamera());
        private final Echantillonnage echantillonnage;
        private final Toile toile;
        private final Regard regard;

        Fil(Echantillonnage echantillonnage, Toile toile, int profondeur) {
            this.echantillonnage = echantillonnage;
            this.toile = toile;
            regard = new Regard(equipe, sien, profondeur, fautes);
        }

        @Override
        public void accept(int rang) {
            Pave pave = Pave.eparpille(rang, getCamera().getLargeur(), getCamera().getHauteur(), Pave.COTE);
            sien.getScene().getCompteurs().pixelsRaffines += echantillonnage.tracer(pave, pave, regard, toile);
            if (fautes != null) {
                fautes.peindre(pave, toile);
            }
        }
    }
}
