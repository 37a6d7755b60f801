package lancer.mesures;

import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.atelier.FichierCsv;
import lancer.auto.Auto;
import lancer.auto.Souhait;
import lancer.contrat.Variante;
import lancer.temoins.LancerSurveille;

/** Ce que {@code --auto erreur=E} a promis pour une scène, et ce qu'il en est contre la vérité. */
final class PromesseAuto {

    static final String COLONNES = "scene,erreur_voulue,reglage,promise,erreur_attendue,erreur_au_plus,erreur,tenue,rayons_attendus,"
            + "rayons,rayons_des_essais,part_des_essais";

    /** Un prix annoncé à tant près est juste. */
    private static final double JUSTE = 0.1;
    private static final double RAYONS_PERMIS = 600_000;

    private final String scene;
    private final double voulue;
    private final Auto auto;

    /** Vrai si le programme s'attendait à tenir l'erreur voulue. */
    final boolean promise;

    /** L'erreur de l'image choisie, en niveaux. */
    private final double erreur;

    /** Les rayons du dessin, et ceux des essais, contrôle compris, par pixel. */
    private final double rayons;
    private final double essais;
    private final int pixels;

    PromesseAuto(String nom, Scene scene, int largeur, int hauteur, Gabarit gabarit, double voulue) {
        this.scene = nom;
        this.voulue = voulue;
        auto = Auto.choisir(LancerSurveille.preparer(scene, largeur, hauteur, false), Souhait.erreur(voulue),
                Runtime.getRuntime().availableProcessors(), Collections.<Variante>singletonList(new Antialias()), enCours -> { });
        promise = auto.estTenable();
        ImageLineaire image = new ImageLineaire(largeur, hauteur);
        Lancer lancer = auto.getLancer();
        lancer.TracerPixels(auto.surveiller(image, auto.getChoisi()), auto.getChoisi().reflets, Runtime.getRuntime().availableProcessors());
        auto.controler();
        pixels = largeur * hauteur;
        rayons = (double) lancer.getCompteurs().rayons() / pixels;
        essais = (double) auto.getRayonsDesEssais() / pixels;
        erreur = Intervalle.deLaRacine(gabarit.carres(image)).valeur;
    }

    boolean estTenue() {
        return erreur <= voulue;
    }

    /** Ce que coûtent les essais, rapporté à ce qui leur est permis : la moitié du dessin, ou ce qui se lance en 0,2 s. */
    private double partDuPermis() {
        return essais / Math.max(RAYONS_PERMIS / pixels, rayons / 2);
    }

    String csv() {
        return FichierCsv.ligne(scene, voulue, auto.getChoisi(), promise ? "oui" : "non", nombre(auto.getChoisi().erreur),
                nombre(auto.getChoisi().erreurAuPlus), nombre(erreur), estTenue() ? "oui" : "non",
                nombre(auto.getChoisi().prix), nombre(rayons), nombre(essais), nombre(essais / rayons));
    }

    private static String nombre(double x) {
        return String.format(Locale.ROOT, "%.3f", x);
    }

    /** Une ligne sur toutes ces promesses. */
    static String bilan(List<PromesseAuto> promesses) {
        return String.format(Locale.ROOT, "erreur voulue tenue %d fois sur %d ; promise %d fois, dont tenue %d, et au pire dépassée %.2f "
                + "fois ; prix annoncé à 10 %% près %d fois ; erreur faite : %.2f fois la voulue (médiane) ; essais : %.2f fois les "
                + "rayons du dessin (médiane ; neuf sur dix sous %.2f), et au pire %.2f fois ce qui leur est permis",
                promesses.stream().filter(PromesseAuto::estTenue).count(), promesses.size(),
                promesses.stream().filter(p -> p.promise).count(),
                promesses.stream().filter(p -> p.promise && p.estTenue()).count(),
                promesses.stream().filter(p -> p.promise).mapToDouble(p -> p.erreur / p.voulue).max().orElse(0),
                promesses.stream().filter(p -> Math.abs(p.auto.getChoisi().prix / p.rayons - 1) <= JUSTE).count(),
                rang(promesses, p -> p.erreur / p.voulue, 0.5), rang(promesses, p -> p.essais / p.rayons, 0.5),
                rang(promesses, p -> p.essais / p.rayons, 0.9), rang(promesses, PromesseAuto::partDuPermis, 1));
    }

    private static double rang(List<PromesseAuto> promesses, ToDoubleFunction<PromesseAuto> quoi, double part) {
        double[] tries = promesses.stream().mapToDouble(quoi).sorted().toArray();
        return tries[(int) (part * (tries.length - 1))];
    }
}
