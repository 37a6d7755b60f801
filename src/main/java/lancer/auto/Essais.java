package lancer.auto;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lancer;
import lancer.contrat.Pave;
import lancer.contrat.Vue;
import lancer.fils.Equipe;
import lancer.fils.Regard;
import lancer.fils.Traceur;

/** De quoi essayer une scène préparée sur quelques blocs, avec tous les fils ; rien ne dépend de leur nombre. */
final class Essais {

    /** Côté d'un bloc, en pixels ; celui d'un pavé en est un nombre entier. Les blocs du bord sont plus petits. */
    static final int COTE = 2;

    /** Ce qu'on fait de chaque bloc, dans un ordre quelconque et par plusieurs fils ; {@code rang} dans la liste. */
    interface Essai {
        void faire(int rang, Pave bloc, Fil fil);
    }

    private static final long GRAINE = 1;
    private static final int BLOCS_CHRONOMETRES = 500;
    static final double NS_PAR_S = 1e9;

    final Traceur prepare;
    final Camera camera;
    private final int fils;

    /** Les rayons de toutes sortes lancés jusqu'ici, et ceux qu'aucune passe ne doit faire dépasser. */
    private final AtomicLong rayons = new AtomicLong();
    private double borne = Double.POSITIVE_INFINITY;

    /** Secondes que demande un rayon, dans la passe la plus rapide. */
    double parRayon = Double.POSITIVE_INFINITY;

    Essais(Traceur prepare, int fils) {
        this.prepare = prepare;
        this.fils = fils;
        camera = prepare.getCamera();
    }

    /** Nombre de blocs de l'image. */
    int blocs() {
        return Pave.nombre(camera.getLargeur(), camera.getHauteur(), COTE);
    }

    /** Dans l'ordre de la lecture, le rang du bloc où est ce pixel. */
    int rang(int i, int j) {
        return j / COTE * ((camera.getLargeur() + COTE - 1) / COTE) + i / COTE;
    }

    /**
     * Des blocs semés également, toujours les mêmes pour une taille : l'image est coupée en tranches, dans l'ordre de
     * la lecture, et chacune donne un bloc au hasard.
     *
     * @param combien au plus ; la moitié des blocs de l'image suffit
     * @param autres vrai pour d'autres blocs des mêmes tranches, si l'image en a plus d'un
     */
    List<Pave> semer(int combien, boolean autres) {
        int tranches = Math.max(1, Math.min(combien, blocs() / 2));
        Random hasard = new Random(GRAINE);
        List<Pave> semes = new ArrayList<>();
        for (int k = 0; k < tranches; k++) {
            int debut = (int) ((long) k * blocs() / tranches);
            int taille = (int) ((k + 1L) * blocs() / tranches) - debut;
            int rang = hasard.nextInt(taille);
            int autre = (rang + 1 + hasard.nextInt(Math.max(1, taille - 1))) % taille;
            semes.add(Pave.deRang(debut + (autres ? autre : rang), camera.getLargeur(), camera.getHauteur(), COTE));
        }
        return semes;
    }

    /** Nombre de pixels de ces blocs. Une boucle : la première lambda d'un programme coûte cher à son démarrage. */
    static int pixels(List<Pave> blocs) {
        int somme = 0;
        for (Pave bloc : blocs) {
            somme += bloc.pixels();
        }
        return somme;
    }

    long rayons() {
        return rayons.get();
    }

    /**
     * Fait ces passes s'il n'y faut pas plus de tant de rayons en tout ; sinon elles s'arrêtent au bloc où ils sont
     * lancés, et sont comptées pour autant, quel que soit le nombre de fils.
     *
     * @return ce qu'elles rendent ; {@code null} si elles se sont arrêtées
     */
    <T> T borner(double permis, Supplier<T> passes) {
        if (permis <= 0) {
            return null;
        }
        long avant = rayons();
        borne = avant + permis;
        try {
            return passes.get();
        } catch (CancellationException e) {
            if (rayons() <= borne) {
                throw e;
            }
            rayons.set(avant + (long) permis);
            return null;
        } finally {
            borne = Double.POSITIVE_INFINITY;
        }
    }

    /** Fait un essai sur chaque bloc. */
    void passer(List<Pave> blocs, Essai essai) {
        long debut = System.nanoTime();
        long avant = rayons();
        Equipe equipe = new Equipe("lancer");
        List<Fil> ouvriers = new ArrayList<>();
        for (int k = 0; k < Math.min(fils, blocs.size()); k++) {
            ouvriers.add(new Fil(equipe, blocs, essai));
        }
        equipe.faire(blocs.size(), ouvriers);
        // le temps d'une passe qui démarre, ou que l'on dérange, n'apprend rien
        parRayon = Math.min(parRayon, (System.nanoTime() - debut) / NS_PAR_S / Math.max(1, rayons() - avant));
    }

    /** Répète un essai tant de secondes, pour savoir celles que prend un rayon une fois le programme compilé. */
    void chronometrer(double secondes) {
        List<Pave> blocs = semer(BLOCS_CHRONOMETRES, false);
        long debut = System.nanoTime();
        while (System.nanoTime() - debut < secondes * NS_PAR_S) {
            passer(blocs, (rang, bloc, fil) -> fil.vue(Constantes.MAX_REFLETS, 0).couleur(bloc.i0, bloc.j0));
        }
    }

    /**
     * Le bloc et ce qu'un échantillonnage regarde autour d'un pixel pour en décider, sans sortir du pavé. Un qui
     * regarderait plus loin serait jugé à peu près, comme au bord d'un pavé.
     */
    Pave entoure(Pave bloc) {
        int i0 = bloc.i0 / Pave.COTE * Pave.COTE;
        int j0 = bloc.j0 / Pave.COTE * Pave.COTE;
        return new Pave(Math.max(i0, bloc.i0 - 1), Math.max(j0, bloc.j0 - 1),
                Math.min(Math.min(i0 + Pave.COTE, camera.getLargeur()), bloc.i1 + 2),
                Math.min(Math.min(j0 + Pave.COTE, camera.getHauteur()), bloc.j1 + 2));
    }

    /** Un fil, qui voit la scène sous les limites qu'on lui dit. */
    final class Fil implements IntConsumer {

        private final Lancer sien = new Lancer(prepare.getScene().avec(prepare.getScene().getModele()), camera);
        private final Equipe equipe;
        private final List<Pave> blocs;
        private final Essai essai;

        Fil(Equipe equipe, List<Pave> blocs, Essai essai) {
            this.equipe = equipe;
            this.blocs = blocs;
            this.essai = essai;
        }

        @Override
        public void accept(int rang) {
            long avant = lances();
            essai.faire(rang, blocs.get(rang), this);
            if (rayons.addAndGet(lances() - avant) > borne) {
                equipe.arreter();
            }
        }

        private long lances() {
            return sien.getScene().getCompteurs().rayons();
        }

        /** Ce qu'il voit à cette profondeur et sous ce seuil. */
        Vue vue(int reflets, double seuil) {
            Regard regard = new Regard(equipe, sien, reflets, null);
            return new Vue() {
                @Override
                public Couleur couleur(double xe, double ye) {
                    sien.getScene().getModele().setSeuil(seuil);
                    return regard.couleur(xe, ye);
                }

                @Override
                public long rayons() {
                    return lances();
                }
            };
        }
    }
}
