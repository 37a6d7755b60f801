package lancer.auto;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import lancer.Camera;
import lancer.Lancer;
import lancer.contrat.Barreau;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Section;
import lancer.contrat.Toile;
import lancer.contrat.Variante;

/**
 * {@code --auto} : choisit le réglage le moins cher qui tient l'erreur voulue, en montant une échelle essayée sur
 * quelques pixels, et contrôle l'image sur d'autres. Le choix ne dépend que de la scène, de la taille et du souhait.
 */
public final class Auto {

    /** Rayons permis aux essais, contrôle compris : tant, ou près de la moitié de ceux du dessin, qui sont estimés. */
    private static final double PLANCHER = 600_000;
    private static final double PART = 0.45;

    /** Part qui en est dépensée une fois semé, les limites essayées, les références faites, et le choix. */
    private static final double SEMER = 0.15;
    private static final double LIMITER = 0.22;
    private static final double TIRER = 0.42;
    private static final double CHOISIR = 0.82;

    /** Dispersion du carré d'une erreur, d'un barreau à l'autre, d'une scène à l'autre. */
    private static final double DISPERSION = 0.35;
    private static final double DIVERSITE = 2;

    /** Un échantillonnage dont on ne sait rien, et une erreur qui n'est pas mesurée : elle est de 0 à 255. */
    private static final Barreau ORDINAIRE = new Barreau(null, 7, 1);
    private static final Estimation INCONNUE = new Estimation(0, 255.0 * 255 * 255 * 255 / 4);

    private final double voulue;
    private final Essais essais;
    private final Echantillonnage deLaScene;
    private final Semis semis;
    private final Limite[] limites;
    private final Tirage tirage;
    private final Map<Barreau, Echantillonnage> echelle = new LinkedHashMap<>();

    /** Les candidats essayés, avec ce qui en est attendu, du moins cher au plus juste à peu près. */
    public final List<Candidat> essayes = new ArrayList<>();

    /** Le candidat choisi, et de quoi dessiner la scène comme lui, à la profondeur qu'il dit. */
    public final Candidat choisi;
    public final Lancer lancer;
    private Tirage controle;

    /**
     * @param prepare la scène, prête à être dessinée
     * @param voulue l'erreur, en niveaux ; 0 : aucune en particulier, tous les réglages sont essayés
     * @param reflets leur nombre, {@code null} s'il est à choisir ; de même leur seuil
     * @param variantes celles dont les réglages sont permis, chacune avec sa section
     * @param suivi appelé dans ce fil après chaque essai
     * @throws lancer.SceneFautive si une variante propose un réglage fautif
     * @throws java.util.concurrent.CancellationException si ce fil est interrompu
     */
    public Auto(Lancer prepare, double voulue, Integer reflets, Double seuil, int fils,
            Map<Variante, Section> variantes, Consumer<Auto> suivi) {
        this.voulue = voulue;
        limites = Limite.permises(reflets, seuil);
        essais = new Essais(prepare, fils);
        deLaScene = prepare.getScene().getModele().getEchantillonnage();
        variantes.forEach((variante, sienne) -> {
            for (Barreau barreau : Objects.requireNonNull(variante.getEchelle(sienne),
                    variante.getClass().getName() + ".getEchelle a rendu null")) {
                Modele modele = new Modele();
                variante.installer(barreau.section, modele);
                barreau.section.verifierCles();
                echelle.put(barreau, modele.getEchantillonnage());
            }
        });
        if (echelle.isEmpty()) {
            echelle.put(ORDINAIRE, deLaScene);
        }
        semis = new Semis(essais, reste(SEMER, 1));
        for (Limite limite : limites) {
            limite.essayer(essais, semis, reste(LIMITER, semis.prix) / limites.length);
        }
        tirage = new Tirage(essais, semis, 0, voulue, reste(TIRER, semis.prix));
        choisi = monter(suivi);
        Modele modele = prepare.getScene().getModele().avec(choisi.echantillonnage, choisi.seuil);
        lancer = new Lancer(prepare.getScene().avec(modele), prepare.getCamera());
    }

    /** Les rayons qui restent à cette part des essais, si le dessin est à ce prix par pixel. */
    private double reste(double part, double prixDuDessin) {
        Camera camera = essais.prepare.getCamera();
        double dessin = prixDuDessin * camera.getLargeur() * camera.getHauteur();
        return voulue == 0 ? Double.MAX_VALUE : part * Math.max(PLANCHER, PART * dessin) - essais.rayons.get();
    }

    /** Essaie du moins cher au plus juste, jusqu'au premier qui devrait tenir ; ceux qui n'y iront pas sont passés. */
    private Candidat monter(Consumer<Auto> suivi) {
        Barreau avant = echelle.keySet().iterator().next();
        double carre = avant.erreur * avant.erreur;
        Estimation ici = new Estimation(carre, DIVERSITE * DIVERSITE * carre * carre);
        int restants = echelle.size();
        for (Barreau barreau : echelle.keySet()) {
            restants--;
            if (barreau != avant) {
                ici = ici.prolongee(barreau.erreur / avant.erreur, DISPERSION);
                avant = barreau;
                if (restants > 0 && voulue > 0 && ici.plus(-Candidat.PRUDENCE) > voulue) {
                    continue;
                }
            }
            double visee = voulue > 0 ? voulue : ici.plus(0);
            Candidat essaye = essayer(barreau, echelle.get(barreau), ici, Limite.pour(visee, limites));
            ici = essaye.estimation;
            essayes.add(essaye);
            suivi.accept(this);
            if (essaye.auPlus <= voulue) {
                return essaye;
            }
        }
        return essayes.stream().min(Comparator.comparingDouble(essaye -> essaye.erreur)).get();
    }

    /** Candidat de ce barreau ; là où les rayons permis ne suffisent pas à l'essayer, ce que promet l'échelle. */
    private Candidat essayer(Barreau barreau, Echantillonnage echantillonnage, Estimation attendue, Limite limite) {
        double promis = barreau.prix * limite.rayons;
        tirage.dessiner(echantillonnage, limite, reste(CHOISIR, promis));
        boolean mesure = tirage.mesure();
        return new Candidat(barreau.section, echantillonnage, limite,
                mesure ? attendue.corrigee(tirage.erreur()) : attendue, mesure ? tirage.prix() : promis);
    }

    /** Candidat que fait ce dessin de la scène, de cette section, à tant de réflexions ; une fois choisi. */
    public Candidat evaluer(Section section, Lancer dessin, int reflets) {
        Modele modele = dessin.getScene().getModele();
        Limite presente = Limite.permises(reflets, modele.getSeuil())[0];
        presente.essayer(essais, semis, Double.MAX_VALUE);
        return essayer(new Barreau(section, ORDINAIRE.erreur, ORDINAIRE.prix), modele.getEchantillonnage(), INCONNUE,
                presente);
    }

    public long getRayonsDesEssais() {
        return essais.rayons.get();
    }

    /** Toile qui voit l'image que l'on dessine sur cette toile, pour la contrôler en d'autres pixels s'il y en a. */
    public Toile surveiller(Toile toile) {
        controle = new Tirage(essais, semis, 0.5, voulue, reste(1, choisi.prix));
        return (couleur, xe, ye) -> {
            toile.drawPixel(couleur, xe, ye);
            controle.retenir(couleur, xe, ye);
        };
    }

    private Estimation mesuree() {
        return controle.mesure() ? controle.erreur() : INCONNUE;
    }

    /** L'erreur de l'image, dessinée, mesurée à peu près, en niveaux. */
    public double getErreurMesuree() {
        return mesuree().plus(0);
    }

    /** Écart possible de cette erreur, en niveaux, dix-neuf fois sur vingt ; jamais 0, et 255 si rien n'est mesuré. */
    public double getIncertitude() {
        return Math.max(0.01, mesuree().plus(2) - mesuree().plus(0));
    }

    /** Verdict : l'image tient-elle l'erreur voulue, d'après son contrôle seul ; sinon, ce qui aiderait. */
    public String getVerdict() {
        // un contrôle que trop peu de pixels portent ne dément pas des essais qui ne promettaient rien
        if (mesuree().plus(0) > voulue || mesuree().plus(-2) == 0 && choisi.auPlus > voulue) {
            return "erreur voulue dépassée" + (mesuree().plus(-2) > voulue ? "" : " sans doute")
                    + (echelle.size() == 1 && deLaScene == null
                    ? " : il faudrait l'anticrénelage, celui d'antialias/target/antialias.jar"
                    : choisi.auPlus > voulue ? " : il faudrait un échantillonnage plus fin, n=64 et seuil=0 au plus"
                    : " : demander deux fois moins d'erreur aiderait");
        }
        // son écart type passe la moitié de son carré
        if (mesuree().plus(-2) == 0) {
            return "on ne peut en dire plus : trop peu de pixels portent l'erreur mesurée, d'autres ont pu manquer";
        }
        return mesuree().plus(Candidat.PRUDENCE) <= voulue ? "erreur voulue tenue" : "erreur voulue atteinte, à ± près";
    }
}
