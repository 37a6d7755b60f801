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
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.ReglagePropose;
import lancer.contrat.Section;
import lancer.contrat.Toile;
import lancer.contrat.Variante;

/**
 * {@code --auto} : choisit le réglage le moins cher dont l'erreur ne dépasse pas l'erreur voulue, d'après des essais
 * sur quelques pixels. L'erreur de l'image dessinée est ensuite mesurée sur d'autres pixels. Le choix ne dépend que de
 * la scène, de la taille et de l'erreur voulue.
 */
public final class Auto {

    /** Nombre de rayons permis aux essais et au contrôle : le plus grand de ces trois nombres. */
    private static final double RAYONS_MIN = 200_000;
    private static final double RAYONS_PAR_PIXEL = 4;
    private static final double PART_DU_DESSIN = 0.45;
    /** Part de ces rayons qui peut être dépensée à la fin de chaque étape. */
    private static final double PILOTE = 0.25;
    private static final double LIMITES = 0.35;
    private static final double REFERENCES = 0.55;
    private static final double CHOIX = 0.85;
    /** Écart type relatif du carré d'une erreur : d'un réglage au suivant, puis d'une scène à l'autre. */
    private static final double DISPERSION = 0.35;
    private static final double DIVERSITE = 2;
    /** L'essai est inutile si l'erreur attendue, moins ce nombre d'écarts types, dépasse l'erreur voulue. */
    private static final double SANS_ESSAI = 0.3;
    /** Un essai chronométré est répété jusqu'à ce nombre de fois ou de rayons. */
    private static final int REPETITIONS = 50;
    private static final int RAYONS_CHRONOMETRES = 300_000;
    /** Réglage d'une scène dont aucune variante ne propose de réglages. */
    private static final ReglagePropose ORDINAIRE = new ReglagePropose(null, 7, 1);

    private final double voulue;
    private final Essais essais;
    private final EchantillonPilote pilote;
    private final Limite[] limites;
    private final PixelsDEssai pixels;
    private final Map<ReglagePropose, Echantillonnage> proposes = new LinkedHashMap<>();
    /** Les candidats essayés, à peu près du moins cher au plus juste. */
    public final List<Candidat> essayes = new ArrayList<>();
    /** Le candidat choisi, et le lancer qui dessine la scène avec lui, à sa profondeur. */
    public final Candidat choisi;
    public final Lancer lancer;
    private Candidat dessine;
    private PixelsDEssai controle;

    /**
     * @param prepare la scène, prête à être dessinée
     * @param voulue l'erreur voulue, en niveaux ; 0 pour essayer tous les réglages
     * @param reflets nombre de réflexions ; {@code null} s'il est à choisir ; de même le seuil
     * @param variantes celles dont les réglages sont essayés, chacune avec sa section
     * @param suivi appelé dans ce fil après chaque essai
     * @throws lancer.SceneFautive si une variante propose un réglage fautif
     * @throws java.util.concurrent.CancellationException si ce fil est interrompu
     */
    public Auto(Lancer prepare, double voulue, Integer reflets, Double seuil, int fils,
            Map<Variante, Section> variantes, Consumer<Auto> suivi) {
        this.voulue = voulue;
        // une erreur se mesure sur des couleurs justes
        prepare.sonder();
        limites = Limite.permises(reflets, seuil);
        essais = new Essais(prepare, fils);
        variantes.forEach((variante, sienne) -> {
            for (ReglagePropose propose : Objects.requireNonNull(variante.getReglagesProposes(sienne),
                    variante.getClass().getName() + ".getReglagesProposes a rendu null")) {
                Modele modele = new Modele();
                variante.installer(propose.section, modele);
                propose.section.verifierCles();
                proposes.put(propose, modele.getEchantillonnage());
            }
        });
        if (proposes.isEmpty()) {
            proposes.put(ORDINAIRE, prepare.getScene().getModele().getEchantillonnage());
        }
        pilote = new EchantillonPilote(essais, reste(PILOTE, 1));
        for (Limite limite : limites) {
            limite.essayer(essais, pilote, reste(LIMITES, pilote.prix) / limites.length);
        }
        pixels = new PixelsDEssai(essais, pilote, 0, voulue, reste(REFERENCES, pilote.prix));
        choisi = choisir(suivi);
        Modele modele = prepare.getScene().getModele().avec(choisi.echantillonnage, choisi.seuil);
        lancer = new Lancer(prepare.getScene().avec(modele), prepare.getCamera());
    }

    /** Nombre de rayons encore permis pour cette part des essais, si le dessin a ce prix par pixel. */
    private double reste(double part, double prixDuDessin) {
        Camera camera = essais.prepare.getCamera();
        double parPixel = Math.max(RAYONS_PAR_PIXEL, PART_DU_DESSIN * prixDuDessin);
        double permis = Math.max(RAYONS_MIN, parPixel * camera.getLargeur() * camera.getHauteur());
        return voulue == 0 ? Double.MAX_VALUE : part * permis - essais.rayons.get();
    }

    /** Essaie les réglages du moins cher au plus juste, jusqu'au premier dont l'erreur maximale convient. */
    private Candidat choisir(Consumer<Auto> suivi) {
        ReglagePropose avant = proposes.keySet().iterator().next();
        double carre = avant.erreur * avant.erreur;
        Estimation ici = new Estimation(carre, DIVERSITE * DIVERSITE * carre * carre);
        int restants = proposes.size();
        for (ReglagePropose propose : proposes.keySet()) {
            restants--;
            if (propose != avant) {
                ici = ici.prolongee(propose.erreur / avant.erreur, DISPERSION);
                avant = propose;
                if (restants > 0 && voulue > 0 && ici.plus(-SANS_ESSAI) > voulue) {
                    continue;
                }
            }
            Candidat essaye = essayer(propose, proposes.get(propose), ici,
                    Limite.pour(voulue > 0 ? voulue : ici.plus(0), limites), 1);
            ici = essaye.estimation;
            essayes.add(essaye);
            suivi.accept(this);
            if (essaye.auPlus <= voulue) {
                return essaye;
            }
        }
        return essayes.stream().min(Comparator.comparingDouble(essaye -> essaye.erreur)).get();
    }

    /** Candidat de ce réglage. S'il ne reste pas assez de rayons pour l'essayer, son erreur est celle attendue. */
    private Candidat essayer(ReglagePropose propose, Echantillonnage echantillonnage, Estimation attendue,
            Limite limite, int repetitions) {
        double promis = propose.prix * limite.rayons;
        double ns = chronometrer(echantillonnage, limite, reste(CHOIX, promis), repetitions);
        return new Candidat(propose.section, echantillonnage, limite, attendue.corrigee(pixels.erreur()),
                pixels.mesure() ? pixels.prix() : promis, ns);
    }

    /** Dessine les pixels d'essai, et rend la durée moyenne d'un rayon dans un fil, en nanosecondes. */
    private double chronometrer(Echantillonnage echantillonnage, Limite limite, double permis, int repetitions) {
        double rayons = essais.rayons.get();
        double duree = essais.dureeNs.get();
        for (int k = 0; k < repetitions && essais.rayons.get() - rayons < RAYONS_CHRONOMETRES; k++) {
            pixels.dessiner(echantillonnage, limite, permis);
        }
        return (essais.dureeNs.get() - duree) / (essais.rayons.get() - rayons);
    }

    /** Refait les essais une fois leur code compilé, les plus courts en dernier. Seules les durées changent. */
    public void chronometrer() {
        for (int k = essayes.size() - 1; k >= 0; k--) {
            Candidat e = essayes.get(k);
            essayes.set(k, new Candidat(e.section, e.echantillonnage, e.limite, e.estimation, e.prix,
                    chronometrer(e.echantillonnage, e.limite, Double.MAX_VALUE, REPETITIONS)));
        }
    }

    /** Candidat de ce dessin de la scène, avec cette section et ce nombre de réflexions. À appeler après le choix. */
    public Candidat evaluer(Section section, Lancer dessin, int reflets) {
        Modele modele = dessin.getScene().getModele();
        Limite presente = Limite.permises(reflets, modele.getSeuil())[0];
        presente.essayer(essais, pilote, Double.MAX_VALUE);
        return essayer(new ReglagePropose(section, ORDINAIRE.erreur, ORDINAIRE.prix), modele.getEchantillonnage(),
                Estimation.INCONNUE, presente, REPETITIONS);
    }

    public long getRayonsDesEssais() {
        return essais.rayons.get();
    }

    /** Toile qui dessine sur {@code toile}, et retient les pixels qui contrôlent l'image du candidat. */
    public Toile surveiller(Toile toile, Candidat candidat) {
        dessine = candidat;
        controle = new PixelsDEssai(essais, pilote, 0.5, voulue, reste(1, candidat.prix));
        return (couleur, xe, ye) -> {
            toile.drawPixel(couleur, xe, ye);
            controle.retenir(couleur, xe, ye);
        };
    }

    /** Moyenne de l'erreur attendue et de l'erreur du contrôle, mesurées sur des pixels différents. */
    private Estimation mesuree() {
        return dessine.estimation.moyenne(controle.erreur());
    }

    /** L'erreur de l'image, en niveaux, estimée sur les pixels d'essai et de contrôle. */
    public double getErreurMesuree() {
        return mesuree().plus(0);
    }

    /** Demi-largeur de l'intervalle de confiance à 95 % de cette erreur, en niveaux ; au moins 0,01. */
    public double getIncertitude() {
        return Math.max(0.01, mesuree().plus(2) - mesuree().plus(0));
    }

    /** Verdict à un écart type près : l'erreur voulue est tenue, dépassée ou incertaine. Un conseil suit. */
    public String getVerdict() {
        return mesuree().plus(1) <= voulue ? "erreur voulue tenue"
                : "erreur voulue " + (mesuree().plus(-1) > voulue ? "dépassée : " : "incertaine : ")
                + (choisi.echantillonnage == null
                ? "il faudrait l'anticrénelage, celui d'antialias/target/antialias.jar"
                : choisi.auPlus > voulue ? "il faudrait une grille plus fine, n=64 et seuil=0 au plus"
                : "demander deux fois moins d'erreur aiderait");
    }
}
