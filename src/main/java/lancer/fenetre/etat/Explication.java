package lancer.fenetre.etat;

import lancer.Couleur;
import lancer.dessin.Dessin;
import lancer.image.ImageMemoire;
import lancer.inspection.Inspection;
import lancer.inspection.Recit.Noeud;

/** Ce qui explique un pixel d'un dessin, ou l'expliquera. L'explication d'avant reste, grisée, pendant le calcul. */
public final class Explication {

    static final Explication AUCUNE = new Explication(0, null, null, null);

    /** Celui du calcul en cours, ou 0. */
    final int numero;
    final Dessin dessin;
    final Pixel pixel;
    /** Ce qui est expliqué, {@code null} avant la première explication. */
    public final Faite faite;

    /** Une explication faite d'un dessin : les rayons, et leur récit ; ou ce qui a empêché de la faire. */
    public static final class Faite {

        final Dessin dessin;
        public final Inspection inspection;
        public final Noeud recit;
        final String faute;

        public Faite(Dessin dessin, Inspection inspection, Noeud recit, String faute) {
            this.dessin = dessin;
            this.inspection = inspection;
            this.recit = recit;
            this.faute = faute;
        }
    }

    Explication(int numero, Dessin dessin, Pixel pixel, Faite faite) {
        this.numero = numero;
        this.dessin = dessin;
        this.pixel = pixel;
        this.faite = faite;
    }

    /** Dit si ce pixel est déjà expliqué, ou le sera. */
    boolean est(Dessin celui, Pixel voulu) {
        return celui == dessin && voulu.equals(pixel);
    }

    public boolean enCours() {
        return numero != 0;
    }

    /** Compare la couleur expliquée à celle du pixel dessiné. @param image l'image achevée, ou {@code null} */
    public String direLeVerdict(ImageMemoire image) {
        if (enCours()) {
            return "calcul…";
        }
        if (faite == null) {
            return "Un clic sur l'image dit pourquoi un pixel a sa couleur.";
        }
        if (faite.faute != null) {
            return faite.faute;
        }
        if (faite.inspection.getFaute() != null) {
            return "Ce pixel n'a pu être calculé.";
        }
        Couleur couleur = faite.inspection.getCouleur();
        if (image == null) {
            return "L'image n'est pas achevée : rien encore à quoi comparer.";
        }
        if (!image.echelle.isEmpty()) {
            return "La couleur de ce pixel, que la vue remplace : #"
                    + String.format("%06X", couleur.getCode() & 0xFFFFFF);
        }
        int k = faite.inspection.y * image.largeur + faite.inspection.x;
        float[] vu = image.lineaire;
        boolean pareil = image.codes[k] == couleur.getCode() && (vu == null || vu[3 * k] == (float) couleur.r
                && vu[3 * k + 1] == (float) couleur.v && vu[3 * k + 2] == (float) couleur.b);
        String dessine = String.format("#%06X", image.codes[k] & 0xFFFFFF);
        if (pareil) {
            return "Au bit près, la couleur du pixel dessiné : " + dessine;
        }
        return "Différent du pixel dessiné, qui est " + dessine
                + (vu == null ? "" : " = " + vu[3 * k] + " " + vu[3 * k + 1] + " " + vu[3 * k + 2]);
    }
}
