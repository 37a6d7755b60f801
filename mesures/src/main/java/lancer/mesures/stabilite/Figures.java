package lancer.mesures.stabilite;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import lancer.mesures.trace.Damier;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Vignettes;
import lancer.mesures.trace.Volet;

/** Les cinq planches de la stabilité. */
final class Figures {

    private static final String ERREUR = "erreur relative de t, la pire";

    private final Bilan bilan;
    private final String note;

    Figures(Bilan bilan) {
        this.bilan = bilan;
        this.note = "Pire de " + Style.nombre(bilan.tires())
                + " rayons tirés au sort par abscisse, jugés sans arrondi (60 chiffres) ; ceux qu'un "
                + "arrondi de leur direction fait changer d'avis sont laissés. Un trait s'arrête là où plus d'un rayon sur dix est mal "
                + "classé. u = 2⁻⁵³. make mesures";
    }

    /** A : de loin. */
    Planche loin() {
        Volet erreur = new Volet("Manuel : une erreur comme |P − C| à la puissance " + Style.arrondi(bilan.pente())
                + ". Programme : jamais plus de " + Style.arrondi(bilan.unites(Mesures.LOIN)) + " unités", "Erreur de la distance",
                "|P − C| / r", "erreur de t, en unités de κ u t").repere(Cas.K, "K = 8, la borne promise");
        Volet genre = parts(Mesures.LOIN, "|P − C| / r", "À " + Style.puissance(bilan.leBout(Mesures.LOIN)) + " r, le manuel se trompe "
                + Style.arrondi(100 * bilan.partAuBout(Aspect.MANUEL, Mesures.LOIN)) + " fois sur cent, le programme "
                + fois(bilan.fauxAuBout(Aspect.PROGRAMME, Mesures.LOIN)));
        courbes(erreur, Mesures.LOIN, r -> Math.max(0.1, r.erreurEnUnites));
        return new Planche("De loin : le manuel se perd dès " + Style.puissance(bilan.perdu()) + " r, le programme "
                + (bilan.fauxDeLoin(Aspect.PROGRAMME) == 0 ? "jamais" : "se trompe " + fois(bilan.fauxDeLoin(Aspect.PROGRAMME))),
                note + ". κ u t = u (1 + r/h) t : ce qu'un arrondi de la direction change à t").volet(erreur, 1.2).volet(genre, 1);
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
                + bilan.chiffresJustes(Aspect.MANUEL) + " chiffres au manuel, "
                + bilan.chiffresJustes(Aspect.PROGRAMME) + " au programme", "Un œil à hauteur 1", "rayon du sol", ERREUR);
        courbes(sol, Mesures.SOL, r -> r.erreurRelative);
        Volet pose = new Volet("À 10⁻¹⁶ r, le manuel se trompe de côté " + fois(bilan.fauxAuRas(Aspect.MANUEL)) + ", le programme "
                + fois(bilan.fauxAuRas(Aspect.PROGRAMME)), "Un départ posé sur une surface", "hauteur du départ / rayon",
                ERREUR).versZero();
        courbes(pose, Mesures.POSE, r -> r.erreurRelative);
        int siens = bilan.chiffresJustes(Aspect.PROGRAMME);
        int autres = bilan.chiffresJustes(Aspect.PERPENDICULAIRE);
        return new Planche(siens > autres ? "Près d'une surface : " + siens + " chiffres justes au lieu de " + autres
                : "Près d'une surface, toutes les méthodes se valent : il reste " + siens + " chiffres", note).volet(sol, 1).volet(pose, 1);
    }

    /** D : qui touche, qui manque. */
    Planche carte() {
        Planche planche = new Planche("Toucher ou manquer : manuel faux à "
                + Style.arrondi(100 * bilan.part(Aspect.MANUEL, Mesures.CARTE))
                + " %, programme " + fois(bilan.faux(Aspect.PROGRAMME, Mesures.CARTE)),
                "Part des rayons mal classés, d'un côté de la tangente ou de l'autre ; blanc : aucun. Chaque case : "
                + bilan.parCase()
                + " rayons tirés au sort, jugés sans arrondi. Sans objet : un arrondi de la direction change la réponse. "
                + "make mesures");
        for (Aspect methode : Mesures.DE_LA_CARTE) {
            List<Exactitude> cases = bilan.de(Mesures.CARTE, methode);
            double pas = bilan.pasDeLaCarte();
            Damier damier = new Damier(Style.nombre(bilan.faux(methode, Mesures.CARTE)) + " faux sur "
                    + Style.nombre(bilan.essais(methode, Mesures.CARTE)), methode.nom, "|P − C| / r",
                    "|1 − l/r| : plus haut, plus près de la tangente", pas);
            cases.forEach(c -> damier.caseEn(c.x, c.y, c.part()));
            planche.volet(damier, 1);
        }
        return planche;
    }

    /** E : les défauts, en images. */
    Planche defauts(List<Defauts.Defaut> images) {
        List<Exactitude> naifs = bilan.defauts();
        Vignettes vignettes = new Vignettes(3);
        for (Exactitude r : naifs) {
            Defauts.Defaut defaut = images.stream().filter(d -> d.cle.equals(r.formule)).findFirst().get();
            vignettes.image(defaut.image(), defaut.nom, pixels(r.faux));
        }
        int faux = bilan.faux(Aspect.PROGRAMME, Defauts.FIGURE);
        return new Planche(naifs.size() + " défauts courants : de " + Style.nombre(naifs.get(naifs.size() - 1).faux) + " à "
                + pixels(naifs.get(0).faux) + " ; le programme, " + (faux == 0 ? "aucun" : Style.nombre(faux)),
                "À gauche ce que dessine le programme, au milieu ce que donne le défaut, à droite les pixels faux : plus d'un demi-pas de "
                + "l'écran d'écart à ce que donne la géométrie. Images de " + Style.nombre(naifs.get(0).essais) + " pixels. make mesures")
                .taille(Style.LARGEUR, 1480).volet(vignettes, 1);
    }

    private static String pixels(int faux) {
        return Style.nombre(faux) + (faux > 1 ? " pixels faux" : " pixel faux");
    }

    private Volet parts(String figure, String nomX, String constat) {
        Volet volet = new Volet(constat, "Rayons mal classés", nomX, "rayons mal classés, en %").plancher(0.05);
        for (Aspect methode : Mesures.DES_COURBES) {
            List<Marque> marques = bilan.de(figure, methode).stream().map(r -> Marque.en(r.x, 100 * r.part()))
                    .collect(Collectors.toList());
            volet.serie(new Serie(methode.nom, methode.couleur, methode.forme, true, marques));
        }
        return volet;
    }

    /** L'erreur de chaque méthode, jusqu'où elle touche et manque encore comme il faut. */
    private void courbes(Volet volet, String figure, ToDoubleFunction<Exactitude> erreur) {
        for (Aspect methode : Mesures.DES_COURBES) {
            List<Marque> marques = bilan.de(figure, methode).stream().filter(Bilan::estClasse)
                    .map(r -> Marque.en(r.x, Math.max(Double.MIN_NORMAL, erreur.applyAsDouble(r)))).collect(Collectors.toList());
            volet.serie(new Serie(methode.nom, methode.couleur, methode.forme, true, marques));
        }
    }

    private Serie guide(String nom, Color couleur, String figure, double facteur) {
        List<Marque> marques = new ArrayList<>();
        for (Exactitude r : bilan.de(figure, Aspect.PROGRAMME)) {
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
