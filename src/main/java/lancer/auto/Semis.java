package lancer.auto;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lancer.contrat.Pave;

/** Des blocs semés sur l'image, toujours les mêmes pour une taille : les uns pour choisir, d'autres pour contrôler. */
final class Semis {

    private static final int BLOCS = 4000;
    private static final long GRAINE = 1;

    final List<Pave> choix = new ArrayList<>();

    /** Vide si l'image n'a qu'un bloc. */
    final List<Pave> controle = new ArrayList<>();

    /** L'image coupée en tranches égales, dans l'ordre de la lecture ; de chacune, un bloc au hasard, et un autre. */
    Semis(int largeur, int hauteur) {
        int nombre = Pave.nombre(largeur, hauteur, Essais.COTE);
        int tranches = Math.max(1, Math.min(BLOCS, nombre / 2));
        Random hasard = new Random(GRAINE);
        for (int k = 0; k < tranches; k++) {
            int debut = (int) ((long) k * nombre / tranches);
            int combien = (int) ((k + 1L) * nombre / tranches) - debut;
            int premier = hasard.nextInt(combien);
            choix.add(Pave.deRang(debut + premier, largeur, hauteur, Essais.COTE));
            if (combien > 1) {
                int autre = (premier + 1 + hasard.nextInt(combien - 1)) % combien;
                controle.add(Pave.deRang(debut + autre, largeur, hauteur, Essais.COTE));
            }
        }
    }
}
