package lancer.mesures.vitesse;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.dessin.Dessin;
import lancer.image.ImageMemoire;
import lancer.mesures.FichierCsv;
import lancer.mesures.Gabarit;
import lancer.mesures.scenes.Scenes;

/** Besoins d'une scène : les rayons, les lampes et les réflexions qui changent son image. Tout est compté, rien n'est chronométré. */
final class Besoin {

    static final List<String> COLONNES = Arrays.asList("scene", "largeur", "hauteur", "spheres", "lampes", "lampes_utiles",
            "profondeur_utile", "tests_par_rayon", "rayons", "rayons_utiles", "ombres_inutiles", "structures");

    private final Taille taille;
    private final String nom;
    private final Scene scene;
    private final Compteurs compteurs;
    private final int[] codes;

    /** Recherche qui a dessiné l'image, avec les structures qu'elle a construites. */
    private final Recherche recherche;

    /** Nombre de rayons d'ombre dont la réponse contraire ne change aucun code de pixel. */
    private long ombresInutiles;

    Besoin(Path fichier, Taille taille) {
        this.taille = taille;
        nom = fichier.getFileName().toString().replace(".ini", "");
        scene = Scenes.lire(fichier);
        Lancer lancer = preparer(scene.avec(scene.getModele()), Constantes.SEUIL);
        codes = codes(lancer, Constantes.MAX_REFLETS);
        compteurs = lancer.getCompteurs();
        recherche = lancer.getScene().getModele().getRecherche();
    }

    String ligne() {
        long utiles = rayonsUtiles();
        return FichierCsv.ligne(nom, taille.largeur, taille.hauteur, scene.getObjets().size(), scene.getLampes().size(),
                lampesUtiles(), profondeurUtile(), Releve.reel((double) compteurs.testsSpheres / compteurs.rayons()),
                compteurs.rayons(), utiles, ombresInutiles, recherche == null ? "boucles" : recherche);
    }

    private Lancer preparer(Scene copie, double seuil) {
        copie.getModele().setSeuil(seuil);
        return Dessin.lancer(copie, taille.largeur, taille.hauteur, false);
    }

    private int[] codes(Lancer lancer, int profondeur) {
        ImageMemoire image = new ImageMemoire(taille.largeur, taille.hauteur, false);
        lancer.TracerPixels(image, profondeur, taille.fils);
        return image.codes;
    }

    /**
     * La plus petite profondeur qui donne les mêmes codes de pixels que mille réflexions, sans seuil. Chaque réflexion ajoute de la
     * lumière : l'image ne devient pas moins juste quand la profondeur augmente, et la recherche est dichotomique.
     */
    int profondeurUtile() {
        Lancer lancer = preparer(scene.avec(scene.getModele()), 0);
        int[] limite = codes(lancer, Gabarit.PROFONDEUR);
        int bas = 0;
        int haut = Gabarit.PROFONDEUR;
        while (bas < haut) {
            int milieu = (bas + haut) / 2;
            if (Arrays.equals(codes(lancer, milieu), limite)) {
                haut = milieu;
            } else {
                bas = milieu + 1;
            }
        }
        return bas;
    }

    /** Nombre de lampes qui changent le code d'au moins un pixel. */
    int lampesUtiles() {
        int utiles = 0;
        for (Lampe lampe : scene.getLampes()) {
            List<Lampe> autres = new ArrayList<>(scene.getLampes());
            autres.remove(lampe);
            int[] sans = codes(preparer(new Scene(scene.getObjets(), autres), Constantes.SEUIL), Constantes.MAX_REFLETS);
            utiles += Arrays.equals(sans, codes) ? 0 : 1;
        }
        return utiles;
    }

    /**
     * Nombre de rayons utiles : ceux de chaque pixel, jusqu'à la dernière réflexion qui change son code, moins les rayons d'ombre inutiles.
     * Pour les trouver, la réponse de chaque rayon d'ombre est inversée à son tour.
     */
    long rayonsUtiles() {
        Lancer lancer = preparer(scene.avec(scene.getModele()), Constantes.SEUIL);
        Retournee ombres = new Retournee(lancer.getScene().avec(lancer.getScene().getModele()));
        lancer.getScene().getModele().setRecherche(ombres);
        ombresInutiles = 0;
        Compteurs siens = lancer.getScene().getCompteurs();
        long utiles = 0;
        for (int k = 0; k < codes.length; k++) {
            long avant;
            int code;
            int reflets = 0;
            do {
                avant = siens.rayons();
                ombres.aRetourner(Integer.MAX_VALUE);
                code = lancer.getCouleurPixel(k % taille.largeur + 0.5, k / taille.largeur + 0.5, reflets++).getCode();
            } while (code != codes[k]);
            utiles += siens.rayons() - avant;
            for (int o = ombres.demandees - 1; o >= 0; o--) {
                ombres.aRetourner(o);
                code = lancer.getCouleurPixel(k % taille.largeur + 0.5, k / taille.largeur + 0.5, reflets - 1).getCode();
                ombresInutiles += code == codes[k] ? 1 : 0;
            }
        }
        return utiles - ombresInutiles;
    }

    /** Une recherche qui inverse la réponse d'un seul rayon d'ombre. */
    private static final class Retournee implements Recherche {

        /** La même scène, sans inversion. */
        private final Scene vraie;
        private int rang;

        /** Nombre de rayons d'ombre demandés depuis le début du pixel. */
        private int demandees;

        Retournee(Scene vraie) {
            this.vraie = vraie;
        }

        /** Commence un pixel, où la réponse du rayon d'ombre de ce rang sera inversée. */
        void aRetourner(int celle) {
            rang = celle;
            demandees = 0;
        }

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            vraie.getClosestIntersection(incident, saufLui);
        }

        @Override
        public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
            Rayon ombre = Rayon.dOmbre(P, V);
            vraie.getClosestIntersection(ombre, objet);
            return ombre.getDistance() < distance != (demandees++ == rang);
        }

        @Override
        public Recherche pourUnFil(Compteurs compteurs) {
            return this;
        }
    }
}
