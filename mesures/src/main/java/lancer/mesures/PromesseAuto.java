package lancer.mesures;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.atelier.FichierCsv;
import lancer.auto.Auto;
import lancer.auto.Reglage;
import lancer.auto.Souhait;
import lancer.contrat.Variante;
import lancer.rapide.Preparation;

/** Ce que {@code --auto erreur=E} a promis pour une scène, et ce qu'il en est contre la vérité. */
final class PromesseAuto {

    static final String COLONNES = "scene,erreur_voulue,reglage,promise,erreur_attendue,erreur_au_plus,erreur,tenue,rayons_attendus,"
            + "rayons,reglage_suffisant,rayons_suffisants";

    /** On ne descend l'échelle des prix que par degrés qui comptent. */
    private static final double DEGRE = 0.95;

    private final String scene;
    private final double voulue;
    private final Auto auto;
    private final Gabarit gabarit;

    /** Vrai si le programme s'attendait à tenir l'erreur voulue. */
    final boolean promise;

    /** L'erreur de l'image choisie, en niveaux, et ce qu'elle a coûté, en rayons par pixel. */
    private final double erreur;
    private final double rayons;

    /** Le moins cher des réglages qui auraient tenu l'erreur voulue : celui qui est choisi, s'il la tient et qu'aucun autre n'y suffit. */
    private final Reglage suffisant;
    private final double rayonsSuffisants;

    private double derniersRayons;

    PromesseAuto(String nom, Scene scene, int largeur, int hauteur, Gabarit gabarit, double voulue) {
        this.scene = nom;
        this.voulue = voulue;
        this.gabarit = gabarit;
        auto = Auto.choisir(Preparation.preparer(scene, largeur, hauteur, false), Souhait.erreur(voulue),
                Runtime.getRuntime().availableProcessors(), Collections.<Variante>singletonList(new Antialias()));
        promise = auto.estTenable();
        erreur = dessiner(auto.getChoisi());
        rayons = derniersRayons;
        Reglage moindre = auto.getChoisi();
        double prix = rayons;
        Reglage suivant = estTenue() ? moinsCherQue(moindre) : null;
        while (suivant != null && dessiner(suivant) <= voulue) {
            moindre = suivant;
            prix = derniersRayons;
            suivant = moinsCherQue(moindre);
        }
        suffisant = moindre;
        rayonsSuffisants = prix;
    }

    /** Dessine, et rend l'erreur en niveaux : celle de {@code lancer.auto.Estimation}, sur tous les pixels. */
    private double dessiner(Reglage reglage) {
        Lancer lancer = auto.getLancer(reglage);
        ImageLineaire image = ImageLineaire.de(lancer, reglage.getReflets(), Runtime.getRuntime().availableProcessors());
        derniersRayons = 3.0 * lancer.getCompteurs().rayons() / image.getComposantes().length;
        return gabarit.erreur(image);
    }

    /** Le plus juste, d'après les essais, de ceux qui coûtent nettement moins ; {@code null} s'il n'y en a pas. */
    private Reglage moinsCherQue(Reglage reglage) {
        Reglage juste = null;
        for (Reglage r : auto.getEssayes()) {
            if (r.getPrix() <= DEGRE * reglage.getPrix() && (juste == null || r.getErreur() < juste.getErreur())) {
                juste = r;
            }
        }
        return juste;
    }

    boolean estTenue() {
        return erreur <= voulue;
    }

    String csv() {
        return FichierCsv.ligne(scene, voulue, auto.getChoisi(), promise ? "oui" : "non", nombre(auto.getChoisi().getErreur()),
                nombre(auto.getChoisi().getErreurAuPlus()), nombre(erreur), estTenue() ? "oui" : "non",
                nombre(auto.getChoisi().getPrix()), nombre(rayons), estTenue() ? suffisant : "",
                estTenue() ? nombre(rayonsSuffisants) : "");
    }

    private static String nombre(double x) {
        return String.format(Locale.ROOT, "%.3f", x);
    }

    /** Une ligne sur toutes ces promesses. */
    static String bilan(List<PromesseAuto> promesses) {
        int tenues = 0;
        int promises = 0;
        int promisesTenues = 0;
        int moinsCheres = 0;
        double pire = 0;
        List<Double> surcouts = new ArrayList<>();
        for (PromesseAuto p : promesses) {
            tenues += p.estTenue() ? 1 : 0;
            promises += p.promise ? 1 : 0;
            promisesTenues += p.promise && p.estTenue() ? 1 : 0;
            pire = Math.max(pire, p.promise ? p.erreur / p.voulue : 0);
            if (p.estTenue()) {
                moinsCheres += p.suffisant != p.auto.getChoisi() ? 1 : 0;
                surcouts.add(p.rayons / p.rayonsSuffisants);
            }
        }
        Collections.sort(surcouts);
        return String.format(Locale.ROOT, "erreur voulue tenue %d fois sur %d ; promise %d fois, dont tenue %d, et au pire dépassée %.2f "
                + "fois ; là où elle est tenue, un réglage moins cher aurait suffi %d fois, et le choix coûte %.2f fois le nécessaire "
                + "(médiane ; trois quarts sous %.2f)", tenues, promesses.size(), promises, promisesTenues, pire, moinsCheres,
                rang(surcouts, 2), rang(surcouts, 3));
    }

    /** Le quartile de ce rang. */
    private static double rang(List<Double> tries, int quart) {
        return tries.isEmpty() ? 1 : tries.get(quart * (tries.size() - 1) / 4);
    }
}
