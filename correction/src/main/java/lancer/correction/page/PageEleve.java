package lancer.correction.page;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import lancer.correction.Eleve;
import lancer.correction.jugement.Chemin;
import lancer.correction.jugement.Ecart;
import lancer.correction.jugement.Faute;
import lancer.correction.jugement.Grille;
import lancer.correction.jugement.Image;
import lancer.correction.jugement.Reference;
import lancer.correction.jugement.Resultat;
import lancer.correction.jugement.Verdict;
import lancer.correction.note.Bareme;
import lancer.correction.note.Note;

/** La page d'un rendu : où il en est, ce qui ne va pas, avec un exemple, et les images. */
final class PageEleve {

    private static final int FAUTES_MONTREES = 20;

    private final Grille grille;
    private final Bareme bareme;
    private final Reference reference;
    private final Eleve eleve;
    private final Html html = new Html();
    /** Ce qui explique le dernier échec montré : déplié là, pas aux suivants qui disent la même chose. */
    private String deplie = "";

    PageEleve(Grille grille, Bareme bareme, Reference reference, Eleve eleve) {
        this.grille = grille;
        this.bareme = bareme;
        this.reference = reference;
        this.eleve = eleve;
    }

    String ecrire() {
        Resultat resultat = eleve.resultat;
        html.element("h1", eleve.rendu.getNom());
        if (eleve.illisible()) {
            html.element("p class=\"avis\"", "Ce rendu n'a pas pu être jugé : " + String.join(" ; ", resultat.refus));
            remarques();
            return html.page(eleve.rendu.getNom());
        }
        html.brut("<p>").dire(Html.nombre(eleve.note.total()) + " points sur " + Html.nombre(bareme.total()))
                .dire(" ; étape atteinte : ").element("strong", eleve.note.getAtteinte()).brut("</p>\n");
        aReprendre(grille, bareme, eleve, html, "<p class=\"avis\">À reprendre d'abord : ", "</p>\n");
        remarques();
        fautes();
        etapes();
        images();
        chemins();
        return html.page(eleve.rendu.getNom());
    }

    /** La première chose à corriger, celle de l'étape la plus tôt. */
    static void aReprendre(Grille grille, Bareme bareme, Eleve eleve, Html html, String debut, String fin) {
        for (Grille.Etape etape : grille.getEtapes()) {
            for (Grille.Critere critere : etape.criteres) {
                Verdict verdict = eleve.resultat.verdicts.get(critere.id);
                if (verdict != null && verdict.etat == Verdict.Etat.RATE && bareme.poids(etape.nom) > 0) {
                    html.brut(debut).element("strong", etape.titre).dire(", " + critere.titre).brut("<br>")
                            .element("code", verdict.message).brut(fin);
                    return;
                }
            }
        }
    }

    private void remarques() {
        if (!eleve.resultat.remarques.isEmpty()) {
            html.brut("<h2>Remarques</h2>\n<ul>");
            eleve.resultat.remarques.forEach(r -> html.element("li", r));
            html.brut("</ul>\n");
        }
    }

    private void fautes() {
        List<Faute> fautes = eleve.resultat.fautes;
        if (!fautes.isEmpty()) {
            html.brut("<h2>").dire(fautes.size() == 1 ? "Une faute de compilation" : fautes.size()
                    + " fautes de compilation").brut("</h2>\n")
                    .element("p class=\"petit gris\"",
                    "Une faute ne coûte que la méthode où elle est, ou sa classe si elle n'est dans aucune.").brut("<ul>");
            for (Faute faute : fautes.stream().limit(FAUTES_MONTREES).collect(Collectors.toList())) {
                html.brut("<li>").element("code", faute).brut("</li>");
            }
            html.brut(fautes.size() > FAUTES_MONTREES ? "<li>…</li></ul>\n" : "</ul>\n");
        }
    }

    private void etapes() {
        html.brut("<h2>Étape par étape</h2>\n<table>\n<tr><th>étape<th class=\"n\">réussi<th "
                + "class=\"n\">points<th>détail</tr>\n");
        for (Grille.Etape etape : grille.getEtapes()) {
            Note.Part part = eleve.note.part(etape.nom);
            html.brut("<tr><td>").dire(etape.titre).brut("<td class=\"n\"><span class=\"e " + classe(part) + "\">"
                    + part.reussis + "/" + part.comptent
                    + "</span><td class=\"n\">").dire(Html.nombre(part.points) + " / " + Html.nombre(part.poids))
                    .brut("<td>");
            for (Grille.Critere critere : etape.criteres) {
                critere(critere);
            }
            html.brut("</tr>\n");
        }
        html.brut("</table>\n");
    }

    private void critere(Grille.Critere critere) {
        Verdict verdict = eleve.resultat.verdicts.get(critere.id);
        Verdict.Etat etat = verdict == null ? Verdict.Etat.NON_COMMENCE : verdict.etat;
        String css = etat == Verdict.Etat.REUSSI ? "reussi" : etat == Verdict.Etat.CACHE ? "cache"
                : etat == Verdict.Etat.RATE ? "rate" : "vide";
        boolean muet = verdict == null || verdict.message.isEmpty();
        boolean ouvert = etat == Verdict.Etat.RATE && !muet && !verdict.message.equals(deplie);
        deplie = ouvert ? verdict.message : deplie;
        html.brut(muet ? "<div>" : "<details" + (ouvert ? " open" : "") + "><summary>")
                .brut("<span class=\"e " + css + "\">").dire(etat.texte).brut("</span> ").dire(critere.titre)
                .dire(critere.compte ? "" : " (ne compte pas : déjà dans le projet à compléter)");
        if (muet) {
            html.brut("</div>");
        } else {
            html.brut("</summary>").element("code", verdict.message).brut("</details>");
        }
    }

    static String classe(Note.Part part) {
        return part.complete() ? "complet" : part.reussis > 0 ? "partiel"
                : part.aFaire == part.comptent ? "vide" : "rate";
    }

    private void images() {
        Resultat resultat = eleve.resultat;
        html.brut("<h2>L'image</h2>\n");
        if (resultat.image == null) {
            html.element("p", "Le rendu n'a pas pu dessiner la scène du cours : " + resultat.sansImage);
            return;
        }
        Image lui = resultat.image;
        Image nous = reference.getImage(resultat.centre);
        Ecart ecart = resultat.ecart;
        html.brut("<p>").dire(ecart.memeImage() ? "La même image que celle du corrigé"
                : "Une autre image que celle du corrigé")
                .dire(String.format(Locale.FRANCE,
                " : écart quadratique moyen %.2f niveaux sur 255, %s sur %d (plus de 2 niveaux)",
                        ecart.rmse, ecart.combien(), ecart.pixels))
                .dire(resultat.centre ? ". Votre getCouleurPixel vise un demi-pixel plus loin que (xe, ye), au centre "
                + "du pixel : le corrigé aussi, ici." : ".");
        if (!resultat.classesFautives.isEmpty()) {
            html.dire(" Cela vient de ").element("strong", String.join(", ", resultat.classesFautives))
                    .dire(" (une classe est en cause si, seule parmi celles du corrigé, elle change l'image).");
        }
        html.brut("</p>\n");
        figure("la vôtre", Html.image(lui.largeur, lui.hauteur, lui::code, "l'image du rendu"));
        figure("celle du corrigé", Html.image(nous.largeur, nous.hauteur, nous::code, "l'image du corrigé"));
        figure("leur différence, quatre fois plus forte", Html.image(lui.largeur, lui.hauteur,
                (x, y) -> difference(lui.code(x, y), nous.code(x, y)),
                "la différence des deux images"));
    }

    private void figure(String legende, String image) {
        html.brut("<figure>" + image).element("figcaption", legende).brut("</figure>\n");
    }

    private static int difference(int a, int b) {
        int d = 0;
        for (int k = 16; k >= 0; k -= 8) {
            d = d << 8 | Math.min(255, 4 * Math.abs((a >> k & 255) - (b >> k & 255)));
        }
        return d;
    }

    private void chemins() {
        if (eleve.resultat.chemin != null) {
            chemin("Le pixel le plus faux", eleve.resultat.chemin);
        }
        if (eleve.resultat.cheminPlusTot != null) {
            chemin("Un pixel où l'on voit mieux d'où vient la faute", eleve.resultat.cheminPlusTot);
        }
    }

    private void chemin(String titre, Chemin chemin) {
        Chemin.Pas premier = chemin.getPremierEcart();
        html.element("h2", titre + " : (" + chemin.x + ", " + chemin.y + ")").brut("<p>")
                .dire("Ce que répondent, en chemin, les méthodes du cours. ");
        if (premier == null) {
            html.dire("Aucune ne s'écarte : la faute est dans ce qui les appelle (getCouleurPixel).");
        } else {
            html.dire("La première réponse qui s'écarte : ").element("strong", premier.nom).dire(".");
        }
        html.brut("</p>\n<table><tr><th>réponse<th>corrigé<th>rendu</tr>\n");
        for (Chemin.Pas pas : chemin.getPas()) {
            html.brut(pas == premier ? "<tr class=\"ecart\"><td>" : "<tr><td>").dire(pas.nom).brut("<td>")
                    .element("code", abrege(pas.attendu)).brut("<td>");
            if (pas.pareil) {
                html.element("span class=\"gris\"", "la même");
            } else {
                html.element("code", abrege(pas.obtenu));
            }
            html.brut("</tr>\n");
        }
        html.brut("</table>\n");
    }

    /** Les nombres à six chiffres : on les compare à l'œil. */
    private static String abrege(String nombres) {
        StringBuilder texte = new StringBuilder();
        for (String mot : nombres.split(" ")) {
            try {
                texte.append(texte.length() > 0 ? "  " : "").append(String.format(Locale.ROOT, "%.6g",
                        Double.parseDouble(mot)));
            } catch (NumberFormatException e) {
                return nombres;
            }
        }
        return texte.toString();
    }
}
