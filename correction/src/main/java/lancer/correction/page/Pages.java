package lancer.correction.page;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.Eleve;
import lancer.correction.isolement.Confinement;
import lancer.correction.jugement.Grille;
import lancer.correction.jugement.Image;
import lancer.correction.jugement.Reference;
import lancer.correction.note.Bareme;
import lancer.correction.note.Note;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVPrinter;

/** Les pages d'une classe : celle de chacun, celle de tous, et le tableau à part. */
public final class Pages {

    private static final int REMARQUES_MONTREES = 3;

    private final Grille grille;
    private final Bareme bareme;
    private final Reference reference;
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
        try (Stream<Path> anciennes = Files.list(etudiants)) {
            for (Path ancienne : (Iterable<Path>) anciennes.filter(f -> f.toString().endsWith(".html"))::iterator) {
                Files.delete(ancienne);
            }
        }
        for (Eleve eleve : eleves) {
            ecrire(etudiants.resolve(eleve.page), new PageEleve(grille, bareme, reference, eleve).ecrire());
        }
        ecrire(dossier.resolve("index.html"), classe(eleves, avis));
        tableau(dossier.resolve("classe.csv"), eleves);
    }

    private static void ecrire(Path fichier, String texte) throws IOException {
        Files.write(fichier, texte.getBytes(StandardCharsets.UTF_8));
    }

    private void tableau(Path fichier, List<Eleve> eleves) throws IOException {
        List<String> titres = new ArrayList<>(List.of("identifiant", "nom", "note", "sur", "étape atteinte",
                "image identique", "refus", "à regarder"));
        grille.getEtapes().forEach(e -> titres.add(e.nom));
        titres.addAll(bareme.getLibres());
        try (BufferedWriter texte = Files.newBufferedWriter(fichier, StandardCharsets.UTF_8);
                CSVPrinter csv = new CSVPrinter(texte, CSVFormat.DEFAULT)) {
            csv.printRecord(titres);
            for (Eleve e : eleves) {
                // ce qui n'a pu être jugé n'a pas zéro : rien
                boolean juge = !e.illisible();
                List<Object> ligne = new ArrayList<>(List.of(sansFormule(e.rendu.getId()),
                        sansFormule(e.rendu.getNom()), juge ? nombre(e.note.total()) : "", nombre(bareme.total()),
                        juge ? e.note.getAtteinte() : "", !juge ? ""
                        : e.note.part(Grille.IMAGE).complete() ? "oui" : "non",
                        sansFormule(String.join(" ; ", e.resultat.refus)),
                        sansFormule(String.join(" ; ", e.aRegarder))));
                e.note.getParts().values().forEach(part -> ligne.add(juge ? PageEleve.combien(part) : ""));
                csv.printRecord(ligne);
            }
        }
    }

    /** Un tableur prendrait pour une formule un texte qui commence ainsi. */
    private static String sansFormule(String texte) {
        return texte.matches("(?s)[=+@\\-\\t].*") ? "'" + texte : texte;
    }

    private static String nombre(double x) {
        return String.format(Locale.ROOT, "%.2f", x);
    }

    private String classe(List<Eleve> eleves, List<String> avis) {
        Html html = new Html();
        List<Eleve> lisibles = eleves.stream().filter(e -> !e.illisible()).collect(Collectors.toList());
        html.element("h1", "La classe").brut("<p>").dire(eleves.size() + (eleves.size() > 1 ? " rendus" : " rendu"))
                .dire(lisibles.size() < eleves.size() ? ", dont " + (eleves.size() - lisibles.size())
                + " que l'on n'a pas pu juger" : "");
        if (!lisibles.isEmpty()) {
            html.dire(" ; moyenne " + (lisibles.size() < eleves.size() ? "des autres " : "")
                    + Html.nombre(lisibles.stream().mapToDouble(e -> e.note.total()).average().orElse(0)) + " sur "
                    + Html.nombre(bareme.total()));
        }
        html.brut("</p>\n");
        avis.forEach(a -> html.element("p class=\"avis\"", a));
        if (!confinement.estConfine()) {
            html.element("p class=\"avis\"", "Le code des étudiants a été exécuté sans confinement : "
                    + confinement.getManque()
                    + ". Il a pu lire et écrire les fichiers de cette machine, ces résultats compris.");
        }
        aRegarder(html, eleves);
        html.element("h2", "Où la classe s'arrête").brut(graphique(lisibles));
        quiAFini(html, lisibles);
        html.brut("<h2>Les rendus</h2>\n<table class=\"classe\">\n<tr><th class=\"vignette\">")
                .brut(vignette(reference.getImage("scene1", false), "l'image du corrigé")).brut("celle du corrigé"
                + "<th>nom<th class=\"n\">note sur ").dire(Html.nombre(bareme.total())).brut("<th>étape atteinte");
        for (Grille.Etape etape : grille.getEtapes()) {
            html.brut("<th class=\"debout\"><span>").dire(etape.court()).brut("</span>");
        }
        bareme.getLibres().forEach(l -> html.brut("<th class=\"debout\"><span>").dire(l).brut("</span>"));
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
        html.brut("<a href=\"etudiants/").dire(eleve.page).brut("\">").dire(eleve.rendu.getNom()).brut("</a>");
    }

    /** Ce que le programme ne peut décider seul, d'abord. */
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

    /** Étape par étape, qui l'a finie, et qui s'y est arrêté. */
    private void quiAFini(Html html, List<Eleve> eleves) {
        html.brut("<details><summary>Qui a fini quoi</summary><table>\n<tr><th>étape<th>finie par<th>s'y arrêtent</tr>\n");
        for (Grille.Etape etape : grille.getEtapes()) {
            html.brut("<tr><td>").dire(etape.court());
            for (boolean finie : new boolean[] {true, false}) {
                html.brut("<td class=\"petit\">");
                eleves.stream().filter(e -> finie ? e.note.part(etape.nom).complete()
                        : e.note.getArret().equals(etape.nom)).forEach(e -> {
                    nommer(html, e);
                    html.brut(" ; ");
                });
            }
            html.brut("</tr>\n");
        }
        html.brut("</table></details>\n");
    }

    private void ligne(Html html, Eleve eleve) {
        html.brut("<tr><td class=\"vignette\" rowspan=\"2\">");
        Image image = eleve.resultat.images.get("scene1");
        if (image != null) {
            html.brut(vignette(image, "son image"));
        }
        html.brut("<td>");
        nommer(html, eleve);
        html.brut("<br><span class=\"petit gris\">").dire(eleve.rendu.getId()).brut("</span>");
        int colonnes = grille.getEtapes().size() + bareme.getLibres().size();
        if (eleve.illisible()) {
            html.brut("<td class=\"n\">–<td colspan=\"" + (colonnes + 1) + "\">")
                    .dire("non corrigé : " + String.join(" ; ", eleve.resultat.refus));
        } else {
            html.brut("<td class=\"n\">").dire(String.format(Locale.FRANCE, "%.2f", eleve.note.total()))
                    .brut("<td class=\"petit\">").dire(eleve.note.getAtteinte());
            eleve.note.getParts().values().forEach(part -> html.brut("<td class=\"c\">").brut(PageEleve.pastille(part)));
        }
        html.brut("</tr>\n<tr><td class=\"petit\" colspan=\"" + (colonnes + 3) + "\">");
        if (!eleve.illisible()) {
            PageEleve.aReprendre(grille, bareme, eleve, html, "à reprendre d'abord : ", " ");
        }
        List<String> remarques = eleve.resultat.remarques;
        html.element("span class=\"gris\"", remarques.stream().limit(REMARQUES_MONTREES).collect(Collectors.joining(" ; "))
                + (remarques.size() > REMARQUES_MONTREES ? " ; …" : "")).brut("</tr>\n");
    }

    private static String vignette(Image image, String legende) {
        return Html.image(image.largeur / 2, image.hauteur / 2, (x, y) -> image.code(2 * x, 2 * y), legende);
    }

    /** Pour chaque étape, combien des rendus jugés ont tout, une partie, rien ; et combien s'y sont arrêtés. */
    private String graphique(List<Eleve> eleves) {
        int pas = 26;
        int gauche = 260;
        double large = 560.0 / Math.max(1, eleves.size());
        List<Grille.Etape> etapes = grille.getEtapes();
        StringBuilder svg = new StringBuilder("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"940\" height=\""
                + (etapes.size() * pas + 6)
                + "\" role=\"img\" aria-label=\"pour chaque étape, combien d'étudiants réussissent tout, une partie, "
                + "rien\">");
        long plus = 0;
        List<String> arretent = new ArrayList<>();
        for (int k = 0; k < etapes.size(); k++) {
            Grille.Etape etape = etapes.get(k);
            int[] n = new int[3];
            for (Eleve e : eleves) {
                Note.Part part = e.note.part(etape.nom);
                n[part.complete() ? 0 : part.reussis > 0 ? 1 : 2]++;
            }
            int y = k * pas + 3;
            svg.append("<text x=\"" + (gauche - 8) + "\" y=\"" + (y + 15) + "\" text-anchor=\"end\">"
                    + Html.echappe(etape.titre) + "</text>");
            double x = gauche;
            String[] couleurs = {"#8ec79b", "#f3cf85", "#d9dde2"};
            for (int c = 0; c < 3; c++) {
                svg.append(String.format(Locale.ROOT,
                        "<rect x=\"%.1f\" y=\"%d\" width=\"%.1f\" height=\"20\" fill=\"%s\"/>", x, y, n[c] * large,
                        couleurs[c]));
                if (n[c] > 0) {
                    svg.append(String.format(Locale.ROOT, "<text x=\"%.1f\" y=\"%d\">%d</text>", x + 5, y + 15, n[c]));
                }
                x += n[c] * large;
            }
            long ici = eleves.stream().filter(e -> e.note.getArret().equals(etape.nom)).count();
            if (ici > 0) {
                svg.append("<text x=\"830\" y=\"" + (y + 15) + "\">" + ici + (ici > 1 ? " s'y arrêtent" : " s'y arrête")
                        + "</text>");
            }
            if (bareme.poids(etape.nom) > 0 && ici >= Math.max(1, plus)) {
                if (ici > plus) {
                    arretent.clear();
                }
                plus = ici;
                arretent.add(etape.titre);
            }
        }
        return (plus > 0 ? "<p>" + (arretent.size() > 1 ? "Les étapes qui arrêtent" : "L'étape qui arrête")
                + " le plus d'étudiants : <strong>" + Html.echappe(String.join(", ", arretent))
                + "</strong> (" + plus + (arretent.size() > 1 ? " chacune" : "") + ").</p>\n" : "")
                + svg + "</svg>\n<p class=\"petit gris\">Vert : toute l'étape réussie ; jaune : une partie ; gris : "
                + "rien. À droite, combien s'y sont arrêtés : ils n'ont fini ni celle-là, ni aucune de celles qui la suivent."
                + "</p>\n";
    }
}
