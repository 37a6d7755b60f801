package lancer;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/** L'algorithme : de la scène à l'image (cours, « Algorithme général »). Un {@code Lancer} dessine une image à la fois. */
public class Lancer {

    /** Pile d'un fil, en octets : mille réflexions sont permises, de deux appels chacune. */
    private static final long PILE = 16 << 20;

    /**
     * Le retard du dernier cœur à la première image, en millisecondes : la machine virtuelle compile alors ce qu'elle exécute, et le
     * lui disputer double le temps que cela lui prend. Scène du cours, deux cœurs, programme entier, médiane de 15 : 237 ms sans
     * retard, 221, 213 et 211 avec 40, 60 et 75. Le brouillon n'attend pas.
     */
    private static final long RETARD = 65;

    /** Vrai dès que ce programme a dessiné une image : le plus gros est compilé. */
    private static volatile boolean chaud;

    private final Scene scene;
    private final Camera camera;
    private final AtomicInteger suivant = new AtomicInteger();
    private final AtomicInteger faits = new AtomicInteger();
    private volatile boolean arrete;
    private volatile Throwable echec;
    private volatile boolean brouillonFait;
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
     * Dessine un brouillon, puis tous les pixels.
     *
     * @param profondeur nombre de réflexions permises
     * @param fils nombre de fils d'exécution, au moins 1 ; l'image n'en dépend pas
     * @throws CancellationException si {@link #arreter()} a été appelé
     */
    public void TracerImage(Toile toile, int profondeur, int fils) {
        TracerBrouillon(toile, profondeur, fils);
        brouillonFait = true;
        TracerPixels(toile, profondeur, fils);
    }

    /** Dessine des carrés de 4 × 4 pixels, chacun de la couleur de son centre, avec une réflexion au plus. */
    public void TracerBrouillon(Toile toile, int profondeur, int fils) {
        tracer(new Brouillon(), toile, Math.min(profondeur, Constantes.REFLETS_BROUILLON), fils, 0);
    }

    /** Dessine tous les pixels, sans brouillon. */
    public void TracerPixels(Toile toile, int profondeur, int fils) {
        tracer(scene.getEchantillonnage(), toile, profondeur, fils, chaud ? 0 : RETARD);
        chaud = true;
    }

    /** Abandonne le dessin en cours, au prochain rayon de chaque fil, et tous les suivants. */
    public void arreter() {
        arrete = true;
    }

    /** La part faite de l'image (ou du brouillon) en cours, de 0 à 1. */
    public double getAvancement() {
        return (double) faits.get() / Pave.nombre(camera.getLargeur(), camera.getHauteur());
    }

    /** Vrai dès que {@link #TracerImage} a fini le brouillon : chaque pixel de l'image a une couleur. */
    public boolean isBrouillonFait() {
        return brouillonFait;
    }

    /** Ce que le dernier dessin achevé a compté, tous fils ensemble. */
    public Compteurs getCompteurs() {
        return compteurs;
    }

    /** Le temps du dernier dessin achevé, en nanosecondes. */
    public long getDureeNs() {
        return dureeNs;
    }

    /** La boucle sur l'image : chaque fil prend le premier pavé que personne n'a pris, jusqu'au dernier. */
    private void tracer(Echantillonnage echantillonnage, Toile toile, int profondeur, int fils, long retard) {
        long debut = System.nanoTime();
        suivant.set(0);
        faits.set(0);
        echec = null;
        int utiles = Math.min(fils, Pave.nombre(camera.getLargeur(), camera.getHauteur()));
        List<Fil> equipe = new ArrayList<>();
        int sansRetard = Math.max(1, Runtime.getRuntime().availableProcessors() - 1);
        try {
            for (int k = 0; k < utiles; k++) {
                if (k == sansRetard && retard > 0) {
                    equipe.get(0).attendre(retard);
                }
                Fil fil = new Fil(echantillonnage, toile, profondeur, "lancer-" + (k + 1));
                fil.thread.start();
                equipe.add(fil);
            }
        } catch (RuntimeException | Error e) {
            // plus de mémoire pour un fil : ceux qui sont partis ne doivent pas dessiner sans nous
            echec = e;
            arrete = true;
        }
        Compteurs total = new Compteurs();
        for (Fil fil : equipe) {
            fil.attendre(0);
            total.ajouter(fil.scene.getCompteurs());
        }
        if (echec instanceof Error) {
            throw (Error) echec;
        }
        if (echec != null) {
            throw (RuntimeException) echec;
        }
        if (arrete) {
            throw new CancellationException("dessin arrêté");
        }
        compteurs = total;
        dureeNs = System.nanoTime() - debut;
    }

    /**
     * De combien de pavés avancer, modulo {@code nombre}, pour les faire tous une fois en sautant d'un bout à l'autre de l'image :
     * environ sa part d'or, et premier avec lui. La machine virtuelle compile d'après ce qu'elle a vu : si c'est un haut d'image
     * tout de ciel, elle doit tout recompiler au premier objet (un tiers du temps d'une première image).
     */
    private static int eparpillement(int nombre) {
        int pas = Math.max(1, (int) (nombre * 0.618));
        while (pgcd(pas, nombre) > 1) {
            pas++;
        }
        return pas;
    }

    private static int pgcd(int a, int b) {
        return b == 0 ? a : pgcd(b, a % b);
    }

    /** Le travail d'un fil : des pavés, vus à travers sa propre vue de la scène. */
    private final class Fil implements Runnable, Vue {

        private final Echantillonnage echantillonnage;
        private final Toile toile;
        private final Scene scene = Lancer.this.scene.pourUnFil();
        private final Vue vue;
        private final Thread thread;

        Fil(Echantillonnage echantillonnage, Toile toile, int profondeur, String nom) {
            this.echantillonnage = echantillonnage;
            this.toile = toile;
            this.vue = scene.getRecherche().vue(new Lancer(scene, camera), profondeur);
            this.thread = new Thread(null, this, nom, PILE);
            this.thread.setDaemon(true);
        }

        @Override
        public void run() {
            int largeur = camera.getLargeur();
            int hauteur = camera.getHauteur();
            int nombre = Pave.nombre(largeur, hauteur);
            int pas = eparpillement(nombre);
            try {
                for (int k = suivant.getAndIncrement(); k < nombre; k = suivant.getAndIncrement()) {
                    Pave pave = Pave.deRang((int) ((long) k * pas % nombre), largeur, hauteur);
                    scene.getCompteurs().pixelsRaffines += echantillonnage.tracer(pave, this, toile);
                    faits.incrementAndGet();
                }
            } catch (CancellationException e) {
                // arrêté ici ou ailleurs : celui qui a demandé l'arrêt le sait
            } catch (RuntimeException | Error e) {
                echec = e;
                arrete = true;
            }
        }

        /** La couleur vue, et le seul endroit où l'arrêt est observé : avant chaque rayon. */
        @Override
        public Couleur couleur(double xe, double ye) {
            if (arrete) {
                throw new CancellationException();
            }
            return vue.couleur(xe, ye);
        }

        /** @param millisecondes au plus, 0 pour attendre jusqu'au bout */
        void attendre(long millisecondes) {
            boolean interrompu = false;
            while (true) {
                try {
                    thread.join(millisecondes);
                    break;
                } catch (InterruptedException e) {
                    // on nous demande d'abandonner : les fils d'abord, ils s'arrêtent aussitôt
                    interrompu = true;
                    arrete = true;
                }
            }
            if (interrompu) {
                Thread.currentThread().interrupt();
            }
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
