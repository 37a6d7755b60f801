package lancer.auto;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import lancer.commande.Options;

/** Ce que {@code --auto} dit : ce qui est choisi, ce qui en était attendu, ce qui est mesuré ensuite. */
public final class Rapport {

    private static final double NS_PAR_S = 1e9;
    private static final double NS_PAR_MS = 1e6;

    private final Options options;
    private final Reglage choisi;
    private final int possibles;
    private final int pixelsEssayes;
    private final double tempsAttendu;
    private long essaisNs;
    private Estimation mesuree;
    private int pixelsControles;
    private boolean autres;
    private double dessin;

    /**
     * @param possibles nombre de réglages entre lesquels choisir
     * @param tempsAttendu en secondes ; 0 si aucun n'est voulu
     */
    Rapport(Options options, Reglage choisi, int possibles, int pixelsEssayes, double tempsAttendu, long essaisNs) {
        this.options = options;
        this.choisi = choisi;
        this.possibles = possibles;
        this.pixelsEssayes = pixelsEssayes;
        this.tempsAttendu = tempsAttendu;
        this.essaisNs = essaisNs;
    }

    /** @param autresQueDuChoix faux si l'image est trop petite pour avoir d'autres pixels que ceux du choix */
    void controler(Estimation erreur, int pixels, boolean autresQueDuChoix, long dessinNs, long controleNs) {
        mesuree = erreur;
        pixelsControles = pixels;
        autres = autresQueDuChoix;
        dessin = dessinNs / NS_PAR_S;
        essaisNs += controleNs;
    }

    /** Vrai si ce qui est voulu devrait être tenu. */
    public boolean estTenable() {
        return options.erreurVoulue > 0 ? choisi.getErreurAuPlus() <= options.erreurVoulue
                : tempsAttendu <= options.tempsVoulu;
    }

    /** L'erreur de l'image, mesurée sur quelques pixels, en niveaux. */
    public double getErreurMesuree() {
        return mesuree.erreur();
    }

    /** Trois lignes : le choix, pourquoi, et ce qu'il en est. */
    public List<String> getLignes() {
        return Arrays.asList("auto, choisi : " + choisi, "auto, attendu : " + attente(),
                "auto, mesuré : " + controle());
    }

    private String attente() {
        return "erreur de " + nombre(choisi.getErreur()) + ", au plus " + nombre(choisi.getErreurAuPlus()) + " ; "
                + nombre(choisi.getRayons()) + " rayons de l'écran par pixel, " + nombre(choisi.getPrix())
                + " avec les ombres et les reflets"
                + (tempsAttendu > 0 ? " ; " + secondes(tempsAttendu) + " de dessin" : "")
                + " ; " + raison();
    }

    private String raison() {
        boolean erreur = options.erreurVoulue > 0;
        String voulu = erreur ? "une erreur de " + nombre(options.erreurVoulue)
                : secondes(options.tempsVoulu) + " de dessin";
        if (possibles == 1) {
            return "seul réglage permis, qui " + (estTenable() ? "promet " : "ne promet pas ") + voulu;
        }
        return estTenable()
                ? (erreur ? "le moins cher" : "le plus juste") + " de " + possibles + " réglages pour " + voulu
                : "aucun de " + possibles + " réglages ne promet " + voulu + ", voici le plus "
                + (erreur ? "juste" : "rapide");
    }

    private String controle() {
        boolean erreur = options.erreurVoulue > 0;
        boolean tenu = erreur ? mesuree.erreur() <= options.erreurVoulue : dessin <= options.tempsVoulu;
        return "erreur de " + nombre(mesuree.erreur()) + " ± " + nombre(mesuree.ecartType()) + " sur " + controles()
                + " ; dessin en " + secondes(dessin) + ", essais en " + secondes(essaisNs / NS_PAR_S) + " ; "
                + (erreur ? "erreur voulue " : "temps voulu ") + (tenu ? "tenu" : "dépassé") + (erreur ? "e" : "");
    }

    private String controles() {
        boolean un = pixelsControles == 1;
        if (!autres) {
            return un ? "le seul pixel de l'image, celui du choix"
                    : "les " + pixelsControles + " pixels de l'image, ceux du choix";
        }
        return pixelsControles + (un ? " pixel de l'image, autre" : " pixels de l'image, autres") + " que "
                + (pixelsEssayes == 1 ? "celui" : "les " + pixelsEssayes) + " du choix";
    }

    /** Des lignes de plus pour {@code --statistiques}. */
    public String getStatistiques() {
        return "auto.erreur.attendue: " + nombre(choisi.getErreur())
                + System.lineSeparator() + "auto.erreur.mesuree: " + nombre(mesuree.erreur())
                + System.lineSeparator() + "auto.essais.ms: "
                + String.format(Locale.ROOT, "%.3f", essaisNs / NS_PAR_MS);
    }

    private static String secondes(double s) {
        return String.format(Locale.ROOT, "%.3f s", s);
    }

    /** Deux décimales, toujours avec un point. */
    private static String nombre(double x) {
        return String.format(Locale.ROOT, "%.2f", x);
    }
}
