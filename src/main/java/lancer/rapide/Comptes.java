package lancer.rapide;

import java.util.Arrays;
import lancer.Camera;
import lancer.Constantes;
import lancer.Point;

/**
 * Les comptes d'examens d'un fil, pixel par pixel : ils bornent ce que coûtent les structures, quoi qu'on leur demande.
 * Chaque pixel a sa part de ce que vaut la construction d'un arbre, chaque rayon {@link #PAR_RAYON} examens de plus ;
 * une structure y prend ce qu'elle examine, et quand le compte est vide elle passe la main à l'arbre, qui recommence ;
 * pour une première rencontre, il y remet autant qu'il a examiné. Un dessin examine donc au plus, structures et arbre,
 * une construction, 32 sphères ou cases par rayon, et deux fois ce qu'examine l'arbre. Rien n'y passe d'un pixel à
 * l'autre : les comptes ne dépendent ni des fils, ni de ce qui a été dessiné avant.
 */
final class Comptes {

    /** Examens permis de plus à chaque rayon : 32, moins la case d'une carte, qu'elle ne prend pas au compte. */
    static final int PAR_RAYON = 31;

    /**
     * Examens que vaut la construction d'un arbre de N sphères, rapportés à N log₂ N. Mesuré de 14 à 23, de 100 à
     * 100 000 sphères, programme compilé ; il en est pris moins, pour que l'arbre vienne plutôt tôt que tard.
     */
    private static final double PAR_CONSTRUCTION = 10;

    /** Côté, en pixels, de ce dont les comptes sont gardés : un pavé, dont un échantillonnage mêle les pixels. */
    private static final int COTE = 32;

    private final Parcours parcours;
    private final long part;
    private final double pixelsParUnite;
    private final double colonneDuMilieu;
    private final double ligneDuMilieu;
    /** De chaque pixel d'un pavé, lequel c'est, et ce qui lui restait quand il a été quitté. */
    private final long[] pixels = new long[COTE * COTE];
    private final long[] credits = new long[COTE * COTE];
    private long pixel = -1;
    private int rang;

    Comptes(Parcours parcours, int nombre, Camera camera) {
        this.parcours = parcours;
        part = part(nombre, camera);
        pixelsParUnite = camera.getLargeur() / Constantes.ECHELLE;
        colonneDuMilieu = camera.getLargeur() / 2.0;
        ligneDuMilieu = camera.getHauteur() / 2.0;
        Arrays.fill(pixels, -1);
    }

    /** Ce que chaque pixel peut examiner de plus que ses rayons : sa part d'une construction pour tant de sphères. */
    static long part(int nombre, Camera camera) {
        double n = Math.max(2, nombre);
        return (long) (PAR_CONSTRUCTION * n * Math.log(n) / Math.log(2) / camera.getLargeur() / camera.getHauteur());
    }

    /** Ouvre le compte du pixel que traverse un rayon qui part de ce point de l'écran. */
    void ouvrir(Point ecran) {
        int i = (int) (ecran.x * pixelsParUnite + colonneDuMilieu);
        int j = (int) (ligneDuMilieu - ecran.y * pixelsParUnite);
        long nouveau = (long) j << Integer.SIZE | i & 0xFFFFFFFFL;
        if (nouveau != pixel) {
            credits[rang] = parcours.credit;
            pixel = nouveau;
            rang = j % COTE * COTE + i % COTE & COTE * COTE - 1;
            parcours.credit = pixels[rang] == nouveau ? credits[rang] : part;
            pixels[rang] = nouveau;
            parcours.bloqueur = -1;
        }
    }
}
