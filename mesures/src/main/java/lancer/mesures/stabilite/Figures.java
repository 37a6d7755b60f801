package lancer.mesures.stabilite;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import lancer.mesures.trace.Barres;
import lancer.mesures.trace.Damier;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/** Les cinq planches de la stabilité. */
final class Figures {

    /** Ce que {@link Defauts} appelle d'un mot. */
    private static final String[][] NOMS = {
        {"acne", "une surface s'ombre elle-même"}, {"epsilon-court", "epsilon de 10⁻⁶, sol de rayon 3·10¹⁰"},
        {"epsilon-long", "epsilon de 10⁻⁴, boule à 5·10⁻⁵"}, {"voisin", "départ exclu par la distance"},
        {"jumelle", "sphère jumelle gardée"},
        {"au-dela", "ombre d'un objet derrière la lampe"}, {"lampe-lointaine", "b² − 4ac, lampe à 10⁹"},
        {"miroir", "un miroir se réfléchit lui-même"}, {"dedans", "première racine seule, vue du dedans"},
        {"dos", "ns = 0 sans regarder N·L"}, {"demi-pixel", "pixels vus en leur coin"}, {"limiter", "limiter avant de moyenner"},
        {"nan", "lampe posée sur une boule : 0/0"},
    };

    private static final String ERREUR = "erreur relative de t, la pire";

    private final Bilan bilan;
    private final String note;

    Figures(Bilan bilan) {
        this.bilan = bilan;
        this.note = "Pire de " + Style.nombre(bilan.tires())
                + " rayons tirés au sort par abscisse, jugés sans arrondi (70 chiffres) ; ceux qu'un "
                + "arrondi de leur direction fait changer d'avis sont laissés. Un trait s'arrête là où plus d'un rayon sur dix est mal "
                + "classé. u = 2⁻⁵³. make mesures";
    }

    /** A : de loin. */
    Planche loin() {
        Volet erreur = new Volet("Manuel : une erreur comme |P − C| à la puissance " + Style.arrondi(bilan.pente())
                + ". Programme : jamais plus de " + Style.arrondi(bilan.unites(Mesures.LOIN)) + " unités", "Erreur de la distance",
                "|P − C| / r", "erreur de t, en unités de κ u t").repere(Cas.K, "K = 8, la borne promise");
        Volet genre = parts(Mesures.LOIN, "|P − C| / r", "À " + Style.puissance(bilan.leBout(Mesures.LOIN)) + " r, le manuel se trompe "
                + Style.arrondi(100 * bilan.partAuBout(Formule.MANUEL, Mesures.LOIN)) + " fois sur cent, le programme "
                + fois(bilan.fauxAuBout(Formule.PROGRAMME, Mesures.LOIN)));
        courbes(erreur, Mesures.LOIN, r -> Math.max(0.1, r.erreurEnUnites));
        return new Planche("De loin : le manuel se perd dès " + Style.puissance(bilan.perdu()) + " r, le programme "
                + (bilan.fauxDeLoin(Formule.PROGRAMME) == 0 ? "jamais" : "se trompe " + fois(bilan.fauxDeLoin(Formule.PROGRAMME))),
                note
                + ". κ u t = u (1 + r/h)(|P − C| + r) : ce qu'un arrondi des données change à t").volet(erreur, 1.2).volet(genre, 1);
    }

    /** B : au ras. */
    Planche ras() {
        Volet pres = new Volet(rasant(Mesures.RAS), "À " + Style.nombre(Mesures.PRES) + " r du centre", "1 − l/r, vers la tangente", ERREUR)
                .versZero();
        Volet loin = new Volet(rasant(Mesures.RAS_LOIN), "À " + Style.nombre(Mesures.LOINTAIN) + " r du centre",
                "1 − l/r, vers la tangente",
                ERREUR).versZero();
        courbes(pres, Mesures.RAS, r -> r.erreurRelative);
        courbes(loin, Mesures.RAS_LOIN, r -> r.erreurRelative);
        for (Volet volet : Arrays.asList(pres, loin)) {
            String figure = volet == pres ? Mesures.RAS : Mesures.RAS_LOIN;
            volet.serie(guide("8 u (1 + r/h), la borne promise", Style.GRIS, figure, Cas.K));
            volet.serie(guide("u (1 + r/h), l'effet d'un arrondi", Style.FRONT, figure, 1));
        }
        double pire = Math.max(bilan.unites(Mesures.RAS), bilan.unites(Mesures.RAS_LOIN));
        return new Planche("Au ras : le programme, " + Style.arrondi(pire) + " fois l'effet d'un seul arrondi", note).volet(pres, 1)
                .volet(loin, 1);
    }

    private String rasant(String figure) {
        return "L'erreur du manuel est " + Style.arrondi(bilan.rapportDesErreurs(figure)) + " fois celle du programme";
    }

    /** C : le sol, et ce qui est posé dessus. */
    Planche sol() {
        Volet sol = new Volet("Sur un sol de " + Style.puissance(bilan.leBout(Mesures.SOL)) + ", il reste "
                + bilan.chiffresJustes(Formule.MANUEL) + " chiffres au manuel, "
                + bilan.chiffresJustes(Formule.PROGRAMME) + " au programme", "Un œil à hauteur 1", "rayon du sol", ERREUR);
        courbes(sol, Mesures.SOL, r -> r.erreurRelative);
        Volet pose = new Volet("À 10⁻¹⁶ r, le manuel se trompe de côté " + fois(bilan.fauxAuRas(Formule.MANUEL)) + ", le programme "
                + fois(bilan.fauxAuRas(Formule.PROGRAMME)), "Un départ posé sur une surface", "hauteur du départ / rayon",
                ERREUR).versZero();
        courbes(pose, Mesures.POSE, r -> r.erreurRelative);
        int siens = bilan.chiffresJustes(Formule.PROGRAMME);
        int autres = bilan.chiffresJustes(Formule.PERPENDICULAIRE);
        return new Planche(siens > autres ? "Près d'une surface : " + siens + " chiffres justes au lieu de " + autres
                : "Près d'une surface, toutes les méthodes se valent : il reste " + siens + " chiffres", note).volet(sol, 1).volet(pose, 1);
    }

    /** D : qui touche, qui manque. */
    Planche carte() {
        Planche planche = new Planche("Toucher ou manquer : manuel faux à "
                + Style.arrondi(100 * bilan.part(Formule.MANUEL, Mesures.CARTE))
                + " %, programme " + fois(bilan.faux(Formule.PROGRAMME, Mesures.CARTE)),
                "Part des rayons mal classés, d'un côté de la tangente ou de l'autre ; blanc : aucun. Chaque case : "
                + bilan.parCase()
                + " rayons tirés au sort, jugés sans arrondi. Sans objet : un arrondi de la direction change la réponse. "
                + "make mesures");
        for (Formule formule : Mesures.DE_LA_CARTE) {
            List<Exactitude> cases = bilan.de(Mesures.CARTE, formule);
            double pas = bilan.pasDeLaCarte();
            Damier damier = new Damier(Style.nombre(bilan.faux(formule, Mesures.CARTE)) + " faux sur "
                    + Style.nombre(bilan.essais(formule, Mesures.CARTE)), formule.nom, "|P − C| / r", new double[] {1, 1e12}, pas,
                    "|1 − l/r| : plus haut, plus près de la tangente", new double[] {1e-14, 1}, pas);
            cases.forEach(c -> damier.caseEn(c.x, c.y, c.part()));
            planche.volet(damier, 1);
        }
        return planche;
    }

    /** E : les défauts et leurs pixels. */
    Planche defauts() {
        List<Exactitude> naifs = bilan.defauts(false);
        List<String> noms = naifs.stream().map(r -> nom(r.formule)).collect(Collectors.toList());
        List<Marque> barres = naifs.stream().map(r -> Marque.en(r.faux, 0).nommee(Style.nombre(r.faux))).collect(Collectors.toList());
        List<Marque> temoins = bilan.defauts(true).stream().map(r -> Marque.en(r.faux, 0)).collect(Collectors.toList());
        double max = naifs.stream().mapToDouble(r -> r.faux).max().orElse(1);
        int faux = bilan.faux(Formule.PROGRAMME, Defauts.FIGURE);
        return new Planche(noms.size() + " défauts courants, de " + Style.nombre(naifs.get(naifs.size() - 1).faux) + " à "
                + Style.nombre(max)
                + " pixels faux ; le programme, " + (faux == 0 ? "aucun" : Style.nombre(faux)),
                "Petites scènes dont la géométrie donne chaque couleur ; faux : plus d'un demi-pas de l'écran d'écart. make mesures")
                .volet(new Barres("Des images de " + Style.nombre(naifs.get(0).essais) + " pixels, et ce que chaque défaut y change",
                        "pixels faux", noms, new Serie("avec ce défaut", Style.BLEU, FormeDePoint.CARRE, false, barres),
                        new Serie("le programme", Style.VERMILLON, FormeDePoint.ROND, false, temoins), max), 1);
    }

    /** Ce défaut, en français. */
    static String nom(String cle) {
        return Arrays.stream(NOMS).filter(n -> n[0].equals(cle)).findFirst().orElseThrow(IllegalArgumentException::new)[1];
    }

    private Volet parts(String figure, String nomX, String constat) {
        Volet volet = new Volet(constat, "Rayons mal classés", nomX, "rayons mal classés, en %").plancher(0.05);
        for (Formule formule : Formule.values()) {
            List<Marque> marques = bilan.de(figure, formule).stream().map(r -> Marque.en(r.x, 100 * r.part()))
                    .collect(Collectors.toList());
            volet.serie(new Serie(formule.nom, formule.couleur, formule.forme, true, marques));
        }
        return volet;
    }

    /** L'erreur de chaque méthode, jusqu'où elle touche et manque encore comme il faut. */
    private void courbes(Volet volet, String figure, ToDoubleFunction<Exactitude> erreur) {
        for (Formule formule : Formule.values()) {
            List<Marque> marques = bilan.de(figure, formule).stream().filter(Bilan::estClasse)
                    .map(r -> Marque.en(r.x, Math.max(Double.MIN_NORMAL, erreur.applyAsDouble(r)))).collect(Collectors.toList());
            volet.serie(new Serie(formule.nom, formule.couleur, formule.forme, true, marques));
        }
    }

    private Serie guide(String nom, Color couleur, String figure, double facteur) {
        List<Marque> marques = new ArrayList<>();
        for (Exactitude r : bilan.de(figure, Formule.PROGRAMME)) {
            // h² = r² − l²
            marques.add(Marque.en(r.x, facteur * Cas.U * (1 + 1 / Math.sqrt(r.x * (2 - r.x)))));
        }
        return new Serie(nom, couleur, FormeDePoint.AUCUNE, true, marques);
    }

    /** « jamais », « 3 fois ». */
    static String fois(int faux) {
        return faux == 0 ? "jamais" : Style.nombre(faux) + " fois";
    }
}
