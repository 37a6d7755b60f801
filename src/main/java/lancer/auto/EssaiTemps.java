package lancer.auto;

import java.util.List;
import lancer.Camera;
import lancer.Lancer;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/** Le temps d'un dessin, prévu en dessinant un pavé sur quelques-uns ; à peu près, la machine n'étant pas seule. */
final class EssaiTemps {

    /** Un pavé sur huit, s'il y en a assez pour que chaque fil en ait quelques-uns. */
    private static final int UN_SUR = 8;
    private static final int PAVES_MIN = 16;

    /** Réglages mesurés avant de s'en tenir là. */
    private static final int MESURES = 6;

    private static final double NS_PAR_S = 1e9;

    private final Essais essais;
    private final int fils;
    private final double voulu;

    /** Le dernier mesuré qui tienne le temps voulu, ou le moins cher, et le temps attendu, en secondes. */
    private Reglage choisi;
    private double attendu;

    private double secondesParPrix;

    /** @param voulu en secondes */
    EssaiTemps(Essais essais, int fils, double voulu) {
        this.essais = essais;
        this.fils = fils;
        this.voulu = voulu;
    }

    /** Le plus juste de ceux qui devraient tenir le temps voulu ; le moins cher si aucun ne le devrait. */
    Reglage choisir(List<Reglage> reglages) {
        choisi = Choix.moinsCher(reglages);
        // plusieurs fois : d'abord la machine virtuelle compile, et toujours quelque chose peut déranger
        attendu = Math.min(mesurer(choisi), Math.min(mesurer(choisi), mesurer(choisi)));
        secondesParPrix = attendu / choisi.getPrix();
        double plafond = Double.POSITIVE_INFINITY;
        for (int k = 0; k < MESURES; k++) {
            Reglage juste = Choix.plusJuste(reglages, Math.min(plafond, voulu / secondesParPrix));
            if (juste == null || juste == choisi) {
                break;
            }
            double temps = mesurer(juste);
            secondesParPrix = temps / juste.getPrix();
            if (temps <= voulu) {
                choisi = juste;
                attendu = temps;
            } else {
                plafond = Math.nextDown(juste.getPrix());
            }
        }
        return choisi;
    }

    /** Le temps attendu pour ce qui est choisi, en secondes. */
    double getAttendu() {
        return attendu;
    }

    /** Le temps qu'il faudrait pour toute l'image, en secondes. */
    private double mesurer(Reglage reglage) {
        Camera camera = essais.getCamera();
        int paves = Pave.nombre(camera.getLargeur(), camera.getHauteur());
        int unSur = Math.max(1, Math.min(UN_SUR, paves / PAVES_MIN));
        Lancer lancer = essais.lancer(reglage.finesse.getEchantillonnage(), reglage.limites.seuil);
        lancer.parcourir(new Extrait(reglage.finesse.getEchantillonnage(), unSur), Essais.AVEUGLE,
                reglage.getReflets(), fils);
        return lancer.getDureeNs() / NS_PAR_S * unSur;
    }

    /** Un pavé sur quelques-uns, en diagonales. */
    private static final class Extrait implements Echantillonnage {

        private final Echantillonnage entier;
        private final int unSur;

        Extrait(Echantillonnage entier, int unSur) {
            this.entier = entier;
            this.unSur = unSur;
        }

        @Override
        public int tracer(Pave pave, Vue vue, Toile toile) {
            return (pave.i0 + 3 * pave.j0) / Pave.COTE % unSur == 0 ? entier.tracer(pave, vue, toile) : 0;
        }
    }
}
