package lancer.auto;

import java.util.List;
import lancer.Lancer;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;

/** Le temps d'un dessin, prévu en dessinant un pavé sur quelques-uns ; à peu près, la machine n'étant pas seule. */
final class EssaiTemps {

    /** Un pavé sur huit, s'il y en a assez pour que chaque fil en ait quelques-uns. */
    private static final int UN_SUR = 8;
    private static final int PAVES_MIN = 16;

    /** Réglages mesurés avant de s'en tenir là. */
    private static final int MESURES = 6;

    private static final double NS_PAR_S = 1e9;

    private final Essais essais;

    /** Le temps attendu pour ce qui est choisi, en secondes. */
    private double attendu;

    EssaiTemps(Essais essais) {
        this.essais = essais;
    }

    /** Le plus juste de ceux qui devraient tenir ce temps, en secondes ; le moins cher si aucun ne le devrait. */
    Reglage choisir(List<Reglage> reglages, double voulu) {
        Reglage choisi = Choix.moinsCher(reglages);
        // plusieurs fois : d'abord la machine virtuelle compile, et toujours quelque chose peut déranger
        attendu = Math.min(mesurer(choisi), Math.min(mesurer(choisi), mesurer(choisi)));
        double secondesParPrix = attendu / choisi.getPrix();
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

    double getAttendu() {
        return attendu;
    }

    /** Le temps qu'il faudrait pour toute l'image, en secondes ; les pavés dessinés y sont en diagonales. */
    private double mesurer(Reglage reglage) {
        int paves = Pave.nombre(essais.camera.getLargeur(), essais.camera.getHauteur());
        int unSur = Math.max(1, Math.min(UN_SUR, paves / PAVES_MIN));
        Echantillonnage entier = reglage.finesse.echantillonnage;
        Lancer lancer = essais.lancer(entier, reglage.limites.seuil);
        lancer.parcourir((pave, vue, toile) -> (pave.i0 + 3 * pave.j0) / Pave.COTE % unSur == 0
                ? entier.tracer(pave, vue, toile) : 0, Essais.AVEUGLE, reglage.getReflets(), essais.fils);
        return lancer.getDureeNs() / NS_PAR_S * unSur;
    }
}
