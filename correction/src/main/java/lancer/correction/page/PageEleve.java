package lancer.correction.page;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import lancer.correction.jugement.Chemin;
import lancer.correction.jugement.GrilleDeNotation;
import lancer.correction.jugement.Image;
import lancer.correction.jugement.Reference;
import lancer.correction.jugement.Resultat;
import lancer.correction.jugement.Verdict;
import lancer.correction.jugement.Verification;
import lancer.correction.note.Eleve;

/** La page d'un rendu : son avancement, ses fautes avec un exemple, et ses images. */
final class PageEleve {

    private final Pages classe;
    private final Eleve eleve;
    private final Html html = new Html();
    /** Messages et méthodes déjà montrés ouverts. */
    private final Set<String> deplies = new HashSet<>();

    PageEleve(Pages classe, Eleve eleve) {
        this.classe = classe;
        this.eleve = eleve;
    }

    String ecrire() {
        Resultat resultat = eleve.resultat;
        html.element("h1", resultat.nom);
        if (eleve.illisible()) {
            html.element("p class=\"avis\"", "Ce rendu n'a pas pu être jugé : " + String.join(" ; ", resultat.refus));
            html.liste("Remarques", resultat.remarques);
            return html.page(resultat.nom);
        }
        double perdus = eleve.perdus(Verdict.Etat.NON_EVALUABLE);
        List<String> aNoter = eleve.aNoter();
        html.brut("<p>").dire(Html.nombre(eleve.note) + " points sur " + Html.nombre(classe.bareme.total))
                .dire(perdus > 0 ? " (dont " + Html.nombre(perdus) + " perdus par ce qui n'a pu être évalué, et ne rapporte rien)" : "")
                .dire(aNoter.isEmpty() ? "" : ", sans ce que l'enseignant n'a pas encore noté : " + String.join(", ", aNoter))
                .dire(" ; étape atteinte : ").element("strong", eleve.atteinte).brut("</p>\n");
        classe.aReprendre(eleve, html, "<p class=\"avis\">À reprendre d'abord : ", "</p>\n");
        html.liste("Remarques", resultat.remarques);
        html.liste("Fautes de compilation : chacune ne coûte que la méthode où elle est, ou sa classe si elle n'est dans aucune",
                resultat.fautes);
        etapes();
        images();
        chemin();
        return html.page(resultat.nom);
    }

    private void etapes() {
        html.brut("<h2>Étape par étape</h2>\n<table class=\"etapes\">\n<tr><th>étape<th class=\"n\">réussi<th "
                + "class=\"n\">points<th>détail</tr>\n");
        for (GrilleDeNotation.Etape etape : classe.grille.etapes) {
            Eleve.Part part = eleve.parts.get(etape.nom);
            if (etape.libre() && part.ajustement == null && !part.aNoter) {
                continue;
            }
            html.brut("<tr><td>").dire(etape.titre).brut("<td class=\"n\">" + pastille(part) + "<td class=\"n\">")
                    .dire(Html.nombre(part.points) + " / " + Html.nombre(part.sur)).brut("<td>");
            if (part.ajustement != null) {
                html.element("p class=\"avis\"", "Donné par l'enseignant"
                        + (part.ajustement.commentaire.isEmpty() ? "" : " : " + part.ajustement.commentaire));
            }
            etape.criteres.forEach(this::critere);
        }
        html.brut("</table>\n");
    }

    /** « 5/8 » ; pour une extension ou une ligne libre, les points, ou « à noter » ; rien pour un bonus que l'on n'a pas. */
    static String combien(Eleve.Part part) {
        return part.aNoter ? "à noter" : part.ajustement != null ? Html.nombre(part.points) + (part.sur > 0 ? "/" + Html.nombre(part.sur)
                : "") : part.comptent == 0 ? "" : part.reussis + "/" + part.comptent;
    }

    static String pastille(Eleve.Part part) {
        return "<span class=\"e " + classe(part) + "\">" + combien(part) + (part.ajustement != null ? " *" : "") + "</span>";
    }

    private void critere(Verification critere) {
        Verdict verdict = eleve.resultat.verdict(critere);
        Verdict.Etat etat = verdict.etat;
        boolean muet = verdict.message.isEmpty();
        boolean ouvert = verdict.rate() && !muet && deplies.add(verdict.message);
        String methode = eleve.resultat.methodes.get(critere.id());
        html.brut(muet ? "<div>" : "<details" + (ouvert ? " open" : "") + "><summary>")
                .element("span class=\"e " + etat.name().toLowerCase(Locale.ROOT) + "\"", etat.texte).dire(" " + critere.titre)
                .dire(critere.compte ? "" : " (ne compte pas : déjà dans le projet à compléter)");
        if (!muet) {
            html.brut("</summary>").element("code", verdict.message);
            html.brut(methode != null && ouvert && deplies.add(methode) ? "<pre>" + Html.echappe(methode) + "</pre>" : "");
        }
        html.brut(muet ? "</div>" : "</details>");
    }

    static String classe(Eleve.Part part) {
        return part.aNoter ? "a_noter" : part.vide() ? "vide" : part.complete() ? "complet"
                : part.reussis > 0 || part.points > 0 ? "partiel" : "rate";
    }

    private void images() {
        Resultat resultat = eleve.resultat;
        html.brut("<h2>Les images</h2>\n");
        if (!resultat.classesFautives.isEmpty()) {
            html.brut("<p>").dire("Ce qui diffère vient de ").element("strong", String.join(", ", resultat.classesFautives))
                    .dire(" (une classe est en cause si, seule parmi celles du corrigé, elle change l'image).").brut("</p>\n");
        }
        if (resultat.centre) {
            html.element("p", "Vos rayons passent un demi-pixel plus loin que (xe, ye), au centre du pixel : ici, ceux du corrigé aussi.");
        }
        for (String scene : Reference.SCENES.keySet()) {
            Verdict verdict = resultat.verdicts.get(GrilleDeNotation.IMAGE + "." + scene);
            html.element("p", "« " + scene + " », " + verdict.etat.texte + " : " + verdict.message);
            Image lui = resultat.images.get(scene);
            if (lui == null) {
                continue;
            }
            Image nous = classe.grille.getImage(scene, resultat.centre);
            html.figure(lui, 1, "la vôtre");
            html.figure(nous, 1, "celle du corrigé");
            html.figure(lui.difference(nous), 1, "leur différence, quatre fois plus forte");
        }
        classe.extensions(eleve, html, 1);
    }

    private void chemin() {
        Chemin chemin = eleve.resultat.chemin;
        if (chemin == null) {
            return;
        }
        Chemin.Pas premier = chemin.getPremierEcart();
        html.element("h2", "Un pixel faux, où l'on voit d'où vient la faute : (" + chemin.x + ", " + chemin.y + ")")
                .element("p", "Ce que répondent, en chemin, les méthodes du cours. " + (premier == null
                ? "Aucune ne s'écarte : la faute est dans ce qui les appelle (getCouleurPixel)."
                : "La première réponse qui s'écarte : " + premier.nom + "."))
                .brut("\n<table><tr><th>réponse<th>corrigé<th>rendu</tr>\n");
        for (Chemin.Pas pas : chemin.pas) {
            html.brut(pas == premier ? "<tr class=\"ecart\"><td>" : "<tr><td>").dire(pas.nom).brut("<td>")
                    .element("code", pas.attendu).brut("<td>")
                    .element(pas.pareil ? "span class=\"gris\"" : "code", pas.pareil ? "la même" : pas.obtenu).brut("</tr>\n");
        }
        html.brut("</table>\n");
    }
}
