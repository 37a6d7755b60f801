package lancer.correction.page;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.Locale;
import java.util.stream.Collectors;
import lancer.correction.enfant.Echange;
import lancer.correction.jugement.GrilleDeNotation;
import lancer.correction.jugement.Image;
import lancer.correction.jugement.Resultat;
import lancer.correction.jugement.Verdict;
import lancer.correction.jugement.Verification;
import lancer.correction.note.Bareme;
import lancer.correction.note.Eleve;

/** Les pages d'une classe : celle de chaque rendu, celle de tous, et le tableau. */
public final class Pages {

    private static final int REMARQUES_MONTREES = 3;

    final GrilleDeNotation grille;
    final Bareme bareme;

    public Pages(GrilleDeNotation grille, Bareme bareme) {
        this.grille = grille;
        this.bareme = bareme;
    }

    /**
     * Écrit {@code index.html}, {@code classe.csv} et {@code etudiants/}.
     *
     * @param avis messages à montrer en tête
     */
    public void ecrire(Path dossier, List<Eleve> eleves, List<String> avis) throws IOException {
        Path etudiants = Files.createDirectories(dossier.resolve("etudiants"));
        try (DirectoryStream<Path> anciennes = Files.newDirectoryStream(etudiants, "[0-9][0-9][0-9]*-*.html")) {
            for (Path ancienne : anciennes) {
                Files.delete(ancienne);
            }
        }
        Map<Eleve, String> rangees = new LinkedHashMap<>();
        for (Eleve eleve : eleves) {
            Html rangee = new Html();
            try {
                ligne(rangee, eleve);
                rangees.put(eleve, rangee.toString());
                Files.writeString(etudiants.resolve(eleve.page), new PageEleve(this, eleve).ecrire());
            } catch (IOException | RuntimeException | Error e) {
                String raison = "sa page n'a pas pu être écrite (" + Echange.protege(e.toString()) + ")";
                eleve.aRegarder.add(raison);
                rangees.put(eleve, nommer(new Html().brut("<tr><td class=\"vignette\"><td>"), eleve).brut("<td class=\"n\">")
                        .dire(noteDe(eleve)).brut("<td colspan=\"" + (grille.etapes.size() + 1) + "\">").dire(raison).brut("</tr>\n")
                        .toString());
                Files.writeString(etudiants.resolve(eleve.page), new Html().element("h1", eleve.resultat.nom)
                        .element("p class=\"avis\"", raison).page(eleve.resultat.nom));
            }
        }
        Files.writeString(dossier.resolve("index.html"), classe(rangees, avis));
        tableau(dossier.resolve("classe.csv"), eleves);
    }

    private void tableau(Path fichier, List<Eleve> eleves) throws IOException {
        List<String> titres = new ArrayList<>(List.of("identifiant", "nom", "note", "sur", "étape atteinte",
                "image identique", "refus", "à regarder"));
        grille.etapes.forEach(e -> titres.add(e.nom));
        List<List<?>> lignes = new ArrayList<>(List.of(titres));
        for (Eleve e : eleves) {
            // un rendu qui n'a pu être jugé n'a pas de note
            boolean juge = !e.illisible();
            List<String> ligne = new ArrayList<>(List.of(e.resultat.id, e.resultat.nom,
                    juge ? String.format(Locale.ROOT, "%.2f", e.note) : "", String.format(Locale.ROOT, "%.2f", bareme.total),
                    juge ? e.atteinte : "", !juge ? "" : e.parts.get(GrilleDeNotation.IMAGE).complete() ? "oui" : "non",
                    String.join(" ; ", e.resultat.refus), String.join(" ; ", e.aRegarder)));
            e.parts.values().forEach(part -> ligne.add(juge ? PageEleve.combien(part) : ""));
            ligne.replaceAll(Echange::sansFormule);
            lignes.add(ligne);
        }
        Resultat.ecrire(fichier, lignes);
    }

    private String classe(Map<Eleve, String> rangees, List<String> avis) {
        Html html = new Html();
        Set<Eleve> eleves = rangees.keySet();
        List<Eleve> lisibles = eleves.stream().filter(e -> !e.illisible()).collect(Collectors.toList());
        int autres = eleves.size() - lisibles.size();
        html.element("h1", "La classe").element("p", eleves.size() + (eleves.size() > 1 ? " rendus" : " rendu")
                + (autres > 0 ? ", dont " + autres + " que l'on n'a pas pu juger" : "") + (lisibles.isEmpty() ? ""
                : " ; moyenne " + (autres > 0 ? "des autres " : "") + Html.nombre(lisibles.stream()
                .mapToDouble(e -> e.note).average().orElse(0)) + " sur " + Html.nombre(bareme.total)) + (bareme.total == bareme.somme ? ""
                : " ; les notes et les points sont sur " + Html.nombre(bareme.total) + ", la note maximale de la feuille ; dans bareme.ini "
                + "et ajustements.csv, ils sont sur " + Html.nombre(bareme.somme)));
        avis.forEach(a -> html.element("p class=\"avis\"", a));
        if (!grille.sansConfinement().isEmpty()) {
            html.element("p class=\"avis\"", "Le code des étudiants a été exécuté sans confinement : " + grille.sansConfinement()
                    + ". Il a pu lire et écrire les fichiers de cette machine, ces résultats compris.");
        }
        aRegarder(html, eleves);
        html.element("h2", "Où la classe s'arrête");
        ouLaClasseSArrete(html, lisibles);
        html.brut("<h2>Les rendus</h2>\n<table class=\"classe\">\n<tr><th class=\"vignette\">")
                .image(grille.getImage("scene1", false), 2, "l'image du corrigé").brut("celle du corrigé"
                + "<th>nom<th class=\"n\">note sur ").dire(Html.nombre(bareme.total)).brut("<th>étape atteinte");
        grille.etapes.forEach(e -> html.brut("<th class=\"debout\">").element("span", e.court));
        html.brut("</tr>\n");
        rangees.values().forEach(html::brut);
        html.brut("</table>\n<p class=\"petit gris\">")
                .dire("Dans chaque case, les vérifications réussies, toutes les classes ensemble ou chacune seule "
                + "parmi celles du corrigé. Vert : tout ; jaune : une partie ; rouge : rien ; bleu : à noter ; gris : pas commencé, "
                + "ou non évaluable, ce qui ne rapporte rien ; un astérisque : des points donnés à la main. Les points de "
                + "chaque étape sont dans bareme.ini, ceux que l'on donne à la main dans ajustements.csv : après les avoir "
                + "changés, make noter refait les notes et les pages.").brut("</p>\n");
        return html.page("La classe");
    }

    private static Html nommer(Html html, Eleve eleve) {
        return html.brut("<a href=\"etudiants/").dire(eleve.page).brut("\">").dire(eleve.resultat.nom).brut("</a>");
    }

    /** Liste de ce que l'enseignant doit décider. */
    private void aRegarder(Html html, Collection<Eleve> eleves) {
        List<Eleve> siens = eleves.stream().filter(e -> !e.aRegarder.isEmpty()).collect(Collectors.toList());
        html.element("h2", "À regarder").brut(siens.isEmpty()
                ? "<p>Aucun rendu : partout, l'image et les étapes disent la même chose.</p>\n" : "<table>\n");
        for (Eleve eleve : siens) {
            nommer(html.brut("<tr><td>"), eleve).brut("<td class=\"n\">").dire(noteDe(eleve))
                    .brut("<td class=\"petit\">");
            eleve.aRegarder.forEach(raison -> html.element("div", raison));
            html.brut("</tr>\n");
        }
        html.brut(siens.isEmpty() ? "" : "</table>\n");
    }

    /** La première faute à corriger, dans l'ordre des étapes. */
    void aReprendre(Eleve eleve, Html html, String debut, String fin) {
        for (GrilleDeNotation.Etape etape : grille.etapes) {
            for (Verification critere : etape.criteres) {
                Verdict verdict = eleve.resultat.verdict(critere);
                if (verdict.rate() && bareme.poids(etape.nom) != 0) {
                    html.brut(debut).element("strong", etape.titre)
                            .dire((critere.classe.isEmpty() ? ", " : ", classe " + critere.classe + " : ") + critere.titre).brut("<br>")
                            .element("code", verdict.message).brut(fin);
                    return;
                }
            }
        }
    }

    private void ligne(Html html, Eleve eleve) {
        html.brut("<tr><td class=\"vignette\" rowspan=\"2\">").image(eleve.resultat.images.get("scene1"), 2, "son image");
        nommer(html.brut("<td>"), eleve).brut("<br>").element("span class=\"petit gris\"",
                eleve.resultat.id.equals(eleve.resultat.nom) ? "" : eleve.resultat.id);
        int colonnes = grille.etapes.size();
        if (eleve.illisible()) {
            html.brut("<td class=\"n\">–<td colspan=\"" + (colonnes + 1) + "\">")
                    .dire("sans note : " + String.join(" ; ", eleve.resultat.refus));
        } else {
            html.brut("<td class=\"n\">").dire(noteDe(eleve)).brut("<td class=\"petit\">").dire(eleve.atteinte);
            eleve.parts.values().forEach(part -> html.brut("<td class=\"c\">").brut(PageEleve.pastille(part)));
        }
        html.brut("</tr>\n<tr><td class=\"petit\" colspan=\"" + (colonnes + 3) + "\">");
        if (!eleve.illisible()) {
            aReprendre(eleve, html, "à reprendre d'abord : ", " ");
        }
        List<String> remarques = eleve.resultat.remarques;
        html.element("span class=\"gris\"", remarques.stream().limit(REMARQUES_MONTREES).collect(Collectors.joining(" ; "))
                + (remarques.size() > REMARQUES_MONTREES ? " ; …" : ""));
        extensions(eleve, html, 4);
        html.brut("</tr>\n");
    }

    private static String noteDe(Eleve eleve) {
        return eleve.illisible() ? "sans note" : String.format(Locale.FRANCE, "%.2f", eleve.note);
    }

    /** Pour chaque extension rendue : son image, celle de la base du même étudiant, celle du corrigé. */
    void extensions(Eleve eleve, Html html, int reduction) {
        Map<String, Image> images = eleve.resultat.images;
        grille.etapes.stream().filter(e -> e.extension && images.containsKey(e.nom)).forEach(e -> {
            html.brut("<div class=\"extension\">");
            html.figure(images.get(e.nom), reduction, e.court);
            html.figure(images.get(e.nom + GrilleDeNotation.BASE), reduction, "la base");
            html.figure(grille.getImage(e.nom, false), reduction, "le corrigé");
            html.brut("</div>\n");
        });
    }

    /** Tableau, par étape, du nombre de rendus complets, partiels ou nuls, et des étudiants qui l'ont finie ou s'y sont arrêtés. */
    private void ouLaClasseSArrete(Html html, List<Eleve> eleves) {
        Map<GrilleDeNotation.Etape, Long> arrets = new LinkedHashMap<>();
        grille.etapes.stream().filter(e -> !e.libre()).forEach(etape -> arrets.put(etape, bareme.poids(etape.nom) == 0 ? 0
                : eleves.stream().filter(e -> e.arret.equals(etape.nom)).count()));
        long plus = Collections.max(arrets.values());
        if (plus > 0) {
            html.brut("<p>L'étape qui arrête le plus d'étudiants : ").element("strong", arrets.keySet().stream()
                    .filter(e -> arrets.get(e) == plus).map(e -> e.titre).collect(Collectors.joining(", ")))
                    .brut(" (" + plus + ")</p>\n");
        }
        html.brut("<table class=\"barres\">\n<tr><th>étape<th>vert, tout ; jaune, une partie ; rouge, rien ; bleu, à noter ; gris, "
                + "pas commencé<th>finie par<th>n'ont fini ni celle-là, ni aucune de celles qui la suivent</tr>\n");
        for (GrilleDeNotation.Etape etape : arrets.keySet()) {
            html.brut("<tr><td>").dire(etape.titre).brut("<td><div class=\"barre\">");
            for (String sorte : List.of("complet", "partiel", "rate", "a_noter", "vide")) {
                long n = eleves.stream().filter(e -> sorte.equals(PageEleve.classe(e.parts.get(etape.nom)))).count();
                html.brut(n == 0 ? "" : "<span class=\"e " + sorte + "\" style=\"flex:" + n + "\">" + n + "</span>");
            }
            html.brut("</div>");
            for (boolean finie : new boolean[] {true, false}) {
                List<Eleve> siens = eleves.stream().filter(e -> finie ? e.parts.get(etape.nom).complete()
                        : e.arret.equals(etape.nom)).collect(Collectors.toList());
                html.brut("<td class=\"petit\">").brut(siens.isEmpty() ? "" : "<details><summary>" + siens.size() + "</summary>");
                siens.forEach(e -> nommer(html.brut("<br>"), e));
                html.brut(siens.isEmpty() ? "" : "</details>");
            }
            html.brut("</tr>\n");
        }
        html.brut("</table>\n");
    }
}
