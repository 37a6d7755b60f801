package lancer.auto;

import java.util.List;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/** De quoi essayer une scène préparée sur quelques blocs, avec tous les fils ; rien ne dépend de leur nombre. */
final class Essais {

    /** Une toile dont personne ne regarde l'image. */
    static final Toile AVEUGLE = (couleur, xe, ye) -> { };

    /** Ce qu'on fait de chaque bloc, dans un ordre quelconque et par plusieurs fils. */
    interface Essai {
        /** @param rang du bloc dans la liste */
        void faire(int rang, Bloc bloc, Pave pave, Vue vue);
    }

    private final Lancer prepare;
    private final Scene scene;
    private final Camera camera;
    private final int fils;

    Essais(Lancer prepare, int fils) {
        this.prepare = prepare;
        scene = prepare.getScene();
        camera = prepare.getCamera();
        this.fils = fils;
    }

    Camera getCamera() {
        return camera;
    }

    /** De la moyenne des blocs à celle de l'image : les blocs du bord ont parfois moins de pixels. */
    double facteur() {
        double pixels = (double) camera.getLargeur() * camera.getHauteur();
        return Bloc.PIXELS * Bloc.nombre(camera.getLargeur(), camera.getHauteur()) / pixels;
    }

    /** La scène, dessinée ainsi. */
    Lancer lancer(Echantillonnage echantillonnage, double seuil) {
        return prepare.avec(echantillonnage, seuil);
    }

    /** Fait un essai sur chaque bloc. */
    Compteurs passer(List<Bloc> blocs, int reflets, double seuil, Essai essai) {
        Lancer lancer = prepare.avec(scene.getEchantillonnage(), seuil);
        lancer.parcourir(new Passe(blocs, essai), AVEUGLE, reflets, fils);
        return lancer.getCompteurs();
    }

    /** Les couleurs au centre de chaque bloc, et dans {@code total} ce qu'elles ont coûté. */
    Couleur[] centres(List<Bloc> blocs, int reflets, double seuil, Compteurs total) {
        Couleur[] couleurs = new Couleur[blocs.size()];
        total.ajouter(passer(blocs, reflets, seuil, (rang, bloc, pave, vue) ->
                couleurs[rang] = vue.couleur((bloc.i0 + bloc.i1) / 2.0, (bloc.j0 + bloc.j1) / 2.0)));
        return couleurs;
    }

    /** Les essais sur les blocs d'un pavé, à la place de ses pixels. */
    private static final class Passe implements Echantillonnage {

        private final List<Bloc> blocs;
        private final Essai essai;

        Passe(List<Bloc> blocs, Essai essai) {
            this.blocs = blocs;
            this.essai = essai;
        }

        @Override
        public int tracer(Pave pave, Vue vue, Toile toile) {
            for (int k = 0; k < blocs.size(); k++) {
                if (blocs.get(k).estDans(pave)) {
                    essai.faire(k, blocs.get(k), pave, vue);
                }
            }
            return 0;
        }
    }
}
