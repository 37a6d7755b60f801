package lancer.auto;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiConsumer;
import java.util.function.IntConsumer;
import lancer.Couleur;
import lancer.Lancer;
import lancer.contrat.Vue;
import lancer.fils.Equipe;

/** Essais d'une scène préparée. Chaque rayon est compté. Les résultats ne dépendent pas du nombre de fils. */
final class Essais {

    /** Profondeur et seuil d'un rayon sans limite : au-dessous de ce produit des Ks, un reflet est invisible. */
    static final int PROFONDEUR = 1000;
    static final double SANS_LIMITE = 1e-9;
    /** Nombre des premiers essais, qui donnent un prix ; part des rayons restants permise aux essais suivants. */
    private static final int PREMIERS = 4;
    private static final double PRUDENCE = 0.9;

    final Lancer prepare;
    private final int fils;
    /** Rayons de toutes sortes déjà lancés, durée des essais dans tous les fils, nombre maximal de rayons. */
    final AtomicLong rayons = new AtomicLong();
    final AtomicLong dureeNs = new AtomicLong();
    private long borne;

    Essais(Lancer prepare, int fils) {
        this.prepare = prepare;
        this.fils = fils;
    }

    /**
     * Exécute les essais de 0 à {@code nombre} − 1, ou seulement les premiers si les rayons permis ne suffisent pas. Le
     * prix de quelques essais fixe le nombre des suivants. Un essai interrompu faute de rayons ne compte pas.
     *
     * @return le nombre d'essais faits
     */
    int passer(int nombre, int reflets, double seuil, double permis, BiConsumer<Integer, Vue> essai) {
        long avant = rayons.get();
        borne = avant + (long) Math.min(Math.max(0, permis), Long.MAX_VALUE / 2);
        int faits = 0;
        int fin = permis < 1 ? 0 : Math.min(PREMIERS, nombre);
        while (fin > faits) {
            int debut = faits;
            Equipe equipe = new Equipe("lancer");
            List<IntConsumer> ouvriers = new ArrayList<>();
            for (int k = 0; k < Math.min(fils, fin - debut); k++) {
                Lancer sien = new Lancer(prepare.getScene().avec(prepare.getScene().getModele()), prepare.getCamera());
                sien.getScene().getModele().setSeuil(seuil);
                Vue vue = vue(equipe, sien, reflets);
                ouvriers.add(rang -> {
                    long commence = System.nanoTime();
                    essai.accept(debut + rang, vue);
                    dureeNs.addAndGet(System.nanoTime() - commence);
                });
            }
            try {
                equipe.faire(fin - debut, ouvriers);
                faits = fin;
            } catch (CancellationException e) {
                if (rayons.get() <= borne) {
                    throw e;
                }
            }
            if (rayons.get() > borne) {
                rayons.set(borne);
                return debut;
            }
            double encore = PRUDENCE * (borne - rayons.get()) * faits / Math.max(1, rayons.get() - avant);
            fin = (int) Math.min(nombre, faits + Math.min(encore, (PREMIERS - 1.0) * faits));
        }
        return faits;
    }

    private Vue vue(Equipe equipe, Lancer sien, int reflets) {
        return new Vue() {
            @Override
            public Couleur couleur(double xe, double ye) {
                equipe.verifier();
                long avant = rayons();
                Couleur couleur = sien.getCouleurPixel(xe, ye, reflets);
                if (rayons.addAndGet(rayons() - avant) > borne) {
                    equipe.arreter();
                }
                return couleur;
            }

            @Override
            public long rayons() {
                return sien.getScene().getCompteurs().rayons();
            }
        };
    }
}
