package lancer.auto;

import java.util.List;
import lancer.Camera;
import lancer.Lancer;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/** De quoi essayer une scène préparée sur quelques blocs, avec tous les fils ; rien ne dépend de leur nombre. */
final class Essais {

    /** Côté d'un bloc, en pixels ; celui d'un pavé en est un nombre entier. Les blocs du bord sont plus petits. */
    static final int COTE = 2;

    /** Une toile dont personne ne regarde l'image. */
    static final Toile AVEUGLE = (couleur, xe, ye) -> { };

    /**
     * Ce qu'un échantillonnage peut regarder avant et après un pixel pour en décider. Un qui regarderait plus loin
     * serait jugé à peu près, comme au bord d'un pavé.
     */
    private static final int AVANT = 1;
    private static final int APRES = 2;

    /** Ce qu'on fait de chaque bloc, dans un ordre quelconque et par plusieurs fils. */
    interface Essai {
        /** @param rang du bloc dans la liste */
        void faire(int rang, Pave bloc, Pave pave, Vue vue);
    }

    final Camera camera;
    final int fils;
    private final Lancer prepare;

    Essais(Lancer prepare, int fils) {
        this.prepare = prepare;
        this.fils = fils;
        camera = prepare.getCamera();
    }

    /** De la moyenne des blocs à celle de l'image : les blocs du bord ont parfois moins de pixels. */
    double facteur() {
        double pixels = (double) camera.getLargeur() * camera.getHauteur();
        return COTE * COTE * Pave.nombre(camera.getLargeur(), camera.getHauteur(), COTE) / pixels;
    }

    /** La scène, dessinée ainsi. */
    Lancer lancer(Echantillonnage echantillonnage, double seuil) {
        return prepare.avec(echantillonnage, seuil);
    }

    /** Fait un essai sur chaque bloc, à la place des pixels de l'image. */
    Compteurs passer(List<Pave> blocs, int reflets, double seuil, Essai essai) {
        Lancer lancer = lancer(prepare.getScene().getEchantillonnage(), seuil);
        lancer.parcourir((pave, vue, toile) -> {
            for (int k = 0; k < blocs.size(); k++) {
                if (pave.contient(blocs.get(k))) {
                    essai.faire(k, blocs.get(k), pave, vue);
                }
            }
            return 0;
        }, AVEUGLE, reflets, fils);
        return lancer.getCompteurs();
    }

    /** Le bloc et ce qui l'entoure, sans sortir du pavé : de quoi y dessiner ses pixels comme dans l'image. */
    static Pave entoure(Pave bloc, Pave pave) {
        return new Pave(Math.max(pave.i0, bloc.i0 - AVANT), Math.max(pave.j0, bloc.j0 - AVANT),
                Math.min(pave.i1, bloc.i1 + APRES), Math.min(pave.j1, bloc.j1 + APRES));
    }
}
