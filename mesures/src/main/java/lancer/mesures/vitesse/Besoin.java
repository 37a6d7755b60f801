package lancer.mesures.vitesse;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.LongAdder;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Scene;
import lancer.Sphere;
import lancer.atelier.FichierCsv;
import lancer.atelier.Scenes;
import lancer.contrat.Compteurs;
import lancer.contrat.Modele;
import lancer.fils.Traceur;
import lancer.image.ImageMemoire;
import lancer.mesures.Gabarit;
import lancer.temoins.LancerSurveille;

/** Ce que demande une scène, et ce que le programme fait pour elle : rien n'est chronométré, tout est compté. */
final class Besoin {

    static final List<String> COLONNES = Arrays.asList("scene", "largeur", "hauteur", "spheres", "lampes", "lampes_utiles",
            "profondeur_utile", "tests_par_rayon", "rayons", "rayons_sans_economie", "rayons_utiles");

    /** Un Ks qui n'est pas nul, et qui ne se verra jamais. */
    private static final double INVISIBLE = 1e-300;

    private final Taille taille;
    private final String nom;
    private final Scene scene;
    private final Compteurs compteurs;
    private final int[] codes;

    Besoin(Path fichier, Taille taille) {
        this.taille = taille;
        nom = fichier.getFileName().toString().replace(".ini", "");
        scene = Scenes.lire(fichier);
        Traceur lancer = preparer(scene.avec(scene.getModele()), Constantes.SEUIL);
        codes = codes(lancer, Constantes.MAX_REFLETS);
        compteurs = lancer.getCompteurs();
    }

    String ligne() {
        return FichierCsv.ligne(nom, taille.largeur, taille.hauteur, scene.getObjets().size(), scene.getLampes().size(),
                lampesUtiles(), profondeurUtile(), Releve.reel((double) compteurs.testsSpheres / compteurs.rayons()),
                compteurs.rayons(), rayonsSansEconomie(), rayonsUtiles());
    }

    private Traceur preparer(Scene copie, double seuil) {
        copie.getModele().setSeuil(seuil);
        return LancerSurveille.preparer(copie, taille.largeur, taille.hauteur, false);
    }

    private int[] codes(Traceur lancer, int profondeur) {
        ImageMemoire image = new ImageMemoire(taille.largeur, taille.hauteur, false);
        // sans témoins : seuls se comptent les rayons de l'image
        lancer.parcourir(lancer.getScene().getModele().getEchantillonnage(), image, profondeur, taille.fils);
        return image.getCodes();
    }

    /**
     * La plus petite profondeur qui donne à l'écran la même image que mille réflexions, sans seuil. Chaque réflexion n'ajoute que
     * de la lumière : une profondeur de plus ne rend pas une image moins juste, et la recherche peut couper en deux.
     */
    int profondeurUtile() {
        Traceur lancer = preparer(scene.avec(scene.getModele()), 0);
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

    /** Combien de lampes changent au moins un pixel de l'écran. */
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

    /** Les rayons de chaque pixel, jusqu'à la dernière réflexion qui change sa couleur à l'écran. */
    long rayonsUtiles() {
        Traceur lancer = preparer(scene.avec(scene.getModele()), Constantes.SEUIL);
        Compteurs siens = lancer.getScene().getCompteurs();
        long utiles = 0;
        for (int k = 0; k < codes.length; k++) {
            long avant;
            int code;
            int reflets = 0;
            do {
                avant = siens.rayons();
                code = lancer.getLancer().getCouleurPixel(k % taille.largeur + 0.5, k / taille.largeur + 0.5, reflets++).getCode();
            } while (code != codes[k]);
            utiles += siens.rayons() - avant;
        }
        return utiles;
    }

    /**
     * Les rayons de qui suivrait partout les reflets jusqu'à la profondeur par défaut, Ks nul ou non, et demanderait à chaque
     * contact si chaque lampe y est cachée, même dans le dos de l'objet.
     */
    long rayonsSansEconomie() {
        LongAdder contacts = new LongAdder();
        Modele modele = new Modele();
        // un air qui ne change rien, et compte les rayons qui ont rencontré quelque chose
        modele.setAtmosphere((vue, distance) -> {
            contacts.add(distance == Constantes.INFINI ? 0 : 1);
            return vue;
        });
        List<Sphere> brillantes = new ArrayList<>();
        for (Objet3D objet : scene.getObjets()) {
            Sphere neuve = new Sphere(((Sphere) objet).getCentre(), ((Sphere) objet).getRayon());
            neuve.setKd(objet.getKd());
            neuve.setKs(objet.getKs().add(new Couleur(INVISIBLE)));
            neuve.setNs(objet.getNs());
            brillantes.add(neuve);
        }
        Scene naive = new Scene(brillantes, scene.getLampes()).avec(modele);
        Traceur lancer = preparer(naive, 0);
        codes(lancer, Constantes.MAX_REFLETS);
        Compteurs c = lancer.getCompteurs();
        return c.primaires + c.reflechis + contacts.sum() * scene.getLampes().size();
    }
}
