package lancer.correction.page;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Locale;
import java.util.stream.Collectors;
import lancer.correction.Eleve;
import lancer.correction.isolement.Confinement;
import lancer.correction.jugement.Grille;
import lancer.correction.jugement.Image;
import lancer.correction.jugement.Reference;
import lancer.correction.jugement.Verdict;
import lancer.correction.note.Bareme;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVPrinter;

/** Les pages d'une classe : celle de chacun, celle de tous, et le tableau à part. */
public final class Pages {

    private static final int REMARQUES_MONTREES = 3;

    final Grille grille;
    final Bareme bareme;
    final Reference reference;
    private final Confinement confinement;

    public Pages(Grille grille, Bareme bareme, Reference reference, Confinement confinement) {
        this.grille = grille;
        this.bareme = bareme;
        this.reference = reference;
        this.confinement = confinement;
    }

    /**
     * Écrit {@code index.html}, {@code classe.csv} et {@code etudiants/}.
     *
     * @param avis ce qu'il faut dire avant tout de cette classe
     */
    public void ecrire(Path dossier, List<Eleve> eleves, List<String> avis) throws IOException {
        Path etudiants = Files.createDirectories(dossier.resolve("etudiants"));
        try (DirectoryStream<Path> anciennes = Files.newDirectoryStream(etudiants, "*.html")) {
            for (Path ancienne : anciennes) {
                Files.delete(ancienne);
            }
        }
        for (Eleve eleve : eleves) {
            Files.writeString(etudiants.resolve(eleve.page), new PageEleve(this, eleve).ecrire());
        }
        Files.writeString(dossier.resolve("index.html"), classe(eleves, avis));
        tableau(dossier.resolve("classe.csv"), eleves);
    }

    private void tableau(Path fichier, List<Eleve> eleves) throws IOException {
        List<String> titres = new ArrayList<>(List.of("identifiant", "nom", "note", "sur", "étape atteinte",
                "image identique", "refus", "à regarder"));
        grille.etapes.forEach(e -> titres.add(e.nom));
        titres.addAll(bareme.libres);
        try (BufferedWriter texte = Files.newBufferedWriter(fichier, StandardCharsets.UTF_8);
                CSVPrinter csv = new CSVPrinter(texte, CSVFormat.DEFAULT)) {
            csv.printRecord(titres);
            for (Eleve e : eleves) {
                // ce qui n'a pu être jugé n'a pas zéro : rien
                boolean juge = !e.illisible();
                List<Object> ligne = new ArrayList<>(List.of(sansFormule(e.rendu.id),
                        sansFormule(e.rendu.nom), juge ? String.format(Locale.ROOT, "%.2f", e.note.total()) : "",
                        String.format(Locale.ROOT, "%.2f", bareme.total()),
                        juge ? e.note.atteinte : "", !juge ? ""
                        : e.note.parts.get(Grille.IMAGE).complete() ? "oui" : "non",
                        sansFormule(String.join(" ; ", e.resultat.refus)),
                        sansFormule(String.join(" ; ", e.aRegarder))));
                e.note.parts.values().forEach(part -> ligne.add(juge ? PageEleve.combien(part) : ""));
                csv.printRecord(ligne);
            }
        }
    }

    /** Un tableur prendrait pour une formule un texte qui commence ainsi. */
    private static String sansFormule(String texte) {
        return texte.matches("(?s)[=+@\\-\\t].*") ? "'" + texte : texte;
    }

    private String classe(List<Eleve> eleves, List<String> avis) {
        Html html = new Html();
        List<Eleve> lisibles = eleves.stream().filter(e -> !e.illisible()).collect(Collectors.toList());
        int autres = eleves.size() - lisibles.size();
        html.element("h1", "La classe").element("p", eleves.size() + (eleves.size() > 1 ? " rendus" : " rendu")
                + (autres > 0 ? ", dont " + autres + " que l'on n'a pas pu juger" : "") + (lisibles.isEmpty() ? ""
                : " ; moyenne " + (autres > 0 ? "des autres " : "") + Html.nombre(lisibles.stream().mapToDouble(e -> e.note.total())
                .average().orElse(0)) + " sur " + Html.nombre(bareme.total())));
        avis.forEach(a -> html.element("p class=\"avis\"", a));
        if (!confinement.confine) {
            html.element("p class=\"avis\"", "Le code des étudiants a été exécuté sans confinement : " + confinement.manque
                    + ". Il a pu lire et écrire les fichiers de cette machine, ces résultats compris.");
        }
        aRegarder(html, eleves);
        html.element("h2", "Où la classe s'arrête");
        ouLaClasseSArrete(html, lisibles);
        html.brut("<h2>Les rendus</h2>\n<table class=\"classe\">\n<tr><th class=\"vignette\">")
                .brut(vignette(reference.getImage("scene1", false), "l'image du corrigé")).brut("celle du corrigé"
                + "<th>nom<th class=\"n\">note sur ").dire(Html.nombre(bareme.total())).brut("<th>étape atteinte");
        for (Grille.Etape etape : grille.etapes) {
            html.brut("<th class=\"debout\"><span>").dire(etape.court).brut("</span>");
        }
        bareme.libres.forEach(l -> html.brut("<th class=\"debout\"><span>").dire(l).brut("</span>"));
        html.brut("</tr>\n");
        for (Eleve eleve : eleves) {
            ligne(html, eleve);
        }
        html.brut("</table>\n<p class=\"petit gris\">")
                .dire("Dans chaque case, les vérifications réussies, toutes les classes ensemble ou chacune seule "
                + "parmi celles du corrigé. Vert : tout ; jaune : une partie ; rouge : rien ; gris : pas commencé, "
                + "ou non évaluable, ce qui ne rapporte rien ; un astérisque : des points donnés à la main. Les points de "
                + "chaque étape sont dans bareme.ini, ceux que l'on donne à la main dans ajustements.csv : les changer et "
                + "relancer la même commande ne refait que les notes.").brut("</p>\n");
        return html.page("La classe");
    }

    private static void nommer(Html html, Eleve eleve) {
        html.brut("<a href=\"etudiants/").dire(eleve.page).brut("\">").dire(eleve.rendu.nom).brut("</a>");
    }

    /** Liste de ce que le programme ne peut décider seul, d'abord. */
    private static void aRegarder(Html html, List<Eleve> eleves) {
        List<Eleve> siens = eleves.stream().filter(e -> !e.aRegarder.isEmpty()).collect(Collectors.toList());
        html.element("h2", "À regarder").brut(siens.isEmpty()
                ? "<p>Aucun rendu : partout, l'image et les étapes disent la même chose.</p>\n" : "<table>\n");
        for (Eleve eleve : siens) {
            html.brut("<tr><td>");
            nommer(html, eleve);
            html.brut("<td class=\"n\">").dire(eleve.illisible() ? "non corrigé"
                    : String.format(Locale.FRANCE, "%.2f", eleve.note.total())).brut("<td class=\"petit\">");
            eleve.aRegarder.forEach(raison -> html.element("div", raison));
            html.brut("</tr>\n");
        }
        html.brut(siens.isEmpty() ? "" : "</table>\n");
    }

    /** La première chose à corriger, celle de l'étape la plus tôt. */
    void aReprendre(Eleve eleve, Html html, String debut, String fin) {
        for (Grille.Etape etape : grille.etapes) {
            for (Grille.Critere critere : etape.criteres) {
                Verdict verdict = eleve.resultat.verdict(critere);
                if (verdict.rate() && bareme.poids(etape.nom) > 0) {
                    html.brut(debut).element("strong", etape.titre)
                            .dire((critere.classe.isEmpty() ? ", " : ", classe " + critere.classe + " : ") + critere.titre).brut("<br>")
                            .element("code", verdict.message).brut(fin);
                    return;
                }
            }
        }
    }

    private void ligne(Html html, Eleve eleve) {
        html.brut("<tr><td class=\"vignette\" rowspan=\"2\">");
        Image image = eleve.resultat.images.get("scene1");
        if (image != null) {
            html.brut(vignette(image, "son image"));
        }
        html.brut("<td>");
        nommer(html, eleve);
        html.brut("<br>").element("span class=\"petit gris\"", eleve.rendu.id.equals(eleve.rendu.nom) ? "" : eleve.rendu.id);
        int colonnes = grille.etapes.size() + bareme.libres.size();
        if (eleve.illisible()) {
            html.brut("<td class=\"n\">–<td colspan=\"" + (colonnes + 1) + "\">")
                    .dire("non corrigé : " + String.join(" ; ", eleve.resultat.refus));
        } else {
            html.brut("<td class=\"n\">").dire(String.format(Locale.FRANCE, "%.2f", eleve.note.total()))
                    .brut("<td class=\"petit\">").dire(eleve.note.atteinte);
            eleve.note.parts.values().forEach(part -> html.brut("<td class=\"c\">").brut(PageEleve.pastille(part)));
        }
        html.brut("</tr>\n<tr><td class=\"petit\" colspan=\"" + (colonnes + 3) + "\">");
        if (!eleve.illisible()) {
            aReprendre(eleve, html, "à reprendre d'abord : ", " ");
        }
        List<String> remarques = eleve.resultat.remarques;
        html.element("span class=\"gris\"", remarques.stream().limit(REMARQUES_MONTREES).collect(Collectors.joining(" ; "))
                + (remarques.size() > REMARQUES_MONTREES ? " ; …" : "")).brut("</tr>\n");
    }

    private static String vignette(Image image, String legende) {
        return Html.image(image.largeur / 2, image.hauteur / 2, (x, y) -> image.code(2 * x, 2 * y), legende);
    }

    /** Tableau : pour chaque étape, combien des rendus jugés en ont tout, une partie, rien ; qui l'a finie, et qui s'y est arrêté. */
    private void ouLaClasseSArrete(Html html, List<Eleve> eleves) {
        Map<Grille.Etape, Long> arrets = new LinkedHashMap<>();
        grille.etapes.forEach(etape -> arrets.put(etape, bareme.poids(etape.nom) == 0 ? 0
                : eleves.stream().filter(e -> e.note.arret.equals(etape.nom)).count()));
        long plus = Collections.max(arrets.values());
        if (plus > 0) {
            html.brut("<p>L'étape qui arrête le plus d'étudiants : ").element("strong", arrets.keySet().stream()
                    .filter(e -> arrets.get(e) == plus).map(e -> e.titre).collect(Collectors.joining(", ")))
                    .brut(" (" + plus + ")</p>\n");
        }
        html.brut("<table class=\"barres\">\n<tr><th>étape<th>vert, tout ; jaune, une partie ; rouge, rien ; gris, pas commencé"
                + "<th>finie par<th>n'ont fini ni celle-là, ni aucune de celles qui la suivent</tr>\n");
        for (Grille.Etape etape : grille.etapes) {
            html.brut("<tr><td>").dire(etape.titre).brut("<td><div class=\"barre\">");
            for (String sorte : List.of("complet", "partiel", "rate", "vide")) {
                long n = eleves.stream().filter(e -> sorte.equals(PageEleve.classe(e.note.parts.get(etape.nom)))).count();
                html.brut(n == 0 ? "" : "<span class=\"e " + sorte + "\" style=\"flex:" + n + "\">" + n + "</span>");
            }
            html.brut("</div>");
            for (boolean finie : new boolean[] {true, false}) {
                List<Eleve> siens = eleves.stream().filter(e -> finie ? e.note.parts.get(etape.nom).complete()
                        : e.note.arret.equals(etape.nom)).collect(Collectors.toList());
                html.brut("<td class=\"petit\">").brut(siens.isEmpty() ? "" : "<details><summary>" + siens.size() + "</summary>");
                siens.forEach(e -> nommer(html.brut("<br>"), e));
                html.brut(siens.isEmpty() ? "" : "</details>");
            }
            html.brut("</tr>\n");
        }
        html.brut("</table>\n");
    }
}
