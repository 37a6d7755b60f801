package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import lancer.mesures.ImageFausse;
import lancer.mesures.ImageLineaire;

/**
 * Refait par les boucles du cours autant de pixels que le budget le permet, et les compare au bit près : des rectangles au
 * hasard dans les pavés, toujours les mêmes ; des pavés entiers là où un pixel dépend de ses voisins.
 */
final class Controle {

    /** Pixels refaits quoi qu'il en coûte. */
    private static final int PIXELS_MIN = 16;

    /** Ce que coûte un rayon des boucles du cours avant sa première sphère, en sphères. */
    private static final int SOCLE = 20;

    private final Taille taille;
    private final double budget;

    /** @param budget en intersections de sphères, à peu près */
    Controle(Taille taille, double budget) {
        this.taille = taille;
        this.budget = budget;
    }

    /**
     * @param compteurs ce qu'a compté le dessin de toute l'image
     * @return le nombre de pixels refaits
     * @throws ImageFausse si l'un d'eux n'est pas le même
     */
    int verifier(Methode methode, Scene scene, ImageLineaire image, Compteurs compteurs) {
        double cout = (double) compteurs.rayons() * (scene.getObjets().size() + SOCLE);
        List<Pave> paves = choisir(methode, Math.min(1, budget / cout));
        ImageLineaire juste = new ImageLineaire(taille.largeur, taille.hauteur);
        juste.effacer();
        Echantillonnage partiel = new Partiel(methode.getEchantillonnage(), paves);
        Lancer lancer = methode.preparerLisible(scene, taille.largeur, taille.hauteur, partiel);
        methode.dessiner(lancer, juste, Runtime.getRuntime().availableProcessors());
        int verifies = comparer(image, juste);
        int attendus = methode.estBrouillon() ? taille.pixels() : paves.stream().mapToInt(Controle::aire).sum();
        if (verifies != attendus) {
            throw new ImageFausse(verifies + " pixels refaits au lieu de " + attendus);
        }
        return verifies;
    }

    private int comparer(ImageLineaire image, ImageLineaire juste) {
        int verifies = 0;
        for (int k = 0; k < taille.pixels(); k++) {
            boolean refait = false;
            for (int c = 3 * k; c < 3 * k + 3; c++) {
                double attendue = juste.getComposantes()[c];
                refait |= !Double.isNaN(attendue);
                if (refait && Double.doubleToRawLongBits(attendue) != Double.doubleToRawLongBits(image.getComposantes()[c])) {
                    throw new ImageFausse("le pixel (" + k % taille.largeur + ", " + k / taille.largeur + ") est "
                            + image.getCouleur(k) + " au lieu de " + juste.getCouleur(k));
                }
            }
            verifies += refait ? 1 : 0;
        }
        return verifies;
    }

    private List<Pave> choisir(Methode methode, double part) {
        List<Pave> tous = new ArrayList<>();
        for (int k = 0; k < Pave.nombre(taille.largeur, taille.hauteur); k++) {
            tous.add(Pave.deRang(k, taille.largeur, taille.hauteur));
        }
        Random hasard = new Random(methode.cle().hashCode());
        Collections.shuffle(tous, hasard);
        if (!methode.pixelParPixel() || part == 1) {
            return tous.subList(0, Math.max(1, (int) (part * tous.size())));
        }
        int pixels = Math.max(PIXELS_MIN, (int) (part * taille.pixels()));
        int nombre = Math.min(tous.size(), pixels);
        int cote = Math.max(1, (int) Math.sqrt((double) pixels / nombre));
        List<Pave> choisis = new ArrayList<>();
        for (Pave pave : tous.subList(0, nombre)) {
            int largeur = Math.min(cote, pave.i1 - pave.i0);
            int hauteur = Math.min(cote, pave.j1 - pave.j0);
            int i = pave.i0 + hasard.nextInt(pave.i1 - pave.i0 - largeur + 1);
            int j = pave.j0 + hasard.nextInt(pave.j1 - pave.j0 - hauteur + 1);
            choisis.add(new Pave(i, j, i + largeur, j + hauteur));
        }
        return choisis;
    }

    private static int aire(Pave pave) {
        return (pave.i1 - pave.i0) * (pave.j1 - pave.j0);
    }

    /** Ne dessine que ces rectangles. */
    private static final class Partiel implements Echantillonnage {

        private final Echantillonnage entier;
        private final List<Pave> choisis;

        Partiel(Echantillonnage entier, List<Pave> choisis) {
            this.entier = entier;
            this.choisis = choisis;
        }

        @Override
        public int tracer(Pave pave, Vue vue, Toile toile) {
            int raffines = 0;
            for (Pave p : choisis) {
                if (p.i0 >= pave.i0 && p.i1 <= pave.i1 && p.j0 >= pave.j0 && p.j1 <= pave.j1) {
                    raffines += entier.tracer(p, vue, toile);
                }
            }
            return raffines;
        }
    }
}
