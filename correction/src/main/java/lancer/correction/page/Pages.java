package lancer.correction.page;

import freemarker.core.HTMLOutputFormat;
import freemarker.template.Configuration;
import freemarker.template.DefaultObjectWrapperBuilder;
import freemarker.template.TemplateException;
import freemarker.template.TemplateExceptionHandler;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.BiPredicate;
import lancer.correction.enfant.Texte;
import lancer.correction.jugement.GrilleDeNotation;
import lancer.correction.jugement.Reference;
import lancer.correction.jugement.Verdict;
import lancer.correction.jugement.Verification;
import lancer.correction.note.Ajustements;
import lancer.correction.note.Bareme;
import lancer.correction.note.Eleve;
import lancer.correction.note.Sorties;

/**
 * Les pages d'une classe, d'après les gabarits de {@code resources/pages} : celle de chaque rendu, celle de tous ; et le tableau. Les
 * gabarits échappent tout texte, et lisent cet objet sous le nom {@code pages}.
 */
public final class Pages {

    /** Longueur de ce qui est dit d'une page qui échoue. */
    private static final int PANNE_MAX = 300;

    private final Configuration gabarits = new Configuration(Configuration.VERSION_2_3_34);
    private final GrilleDeNotation grille;
    private final Bareme bareme;
    /** Messages et méthodes déjà montrés ouverts sur la page en cours. */
    private final Set<String> deplies = new HashSet<>();

    public Pages(GrilleDeNotation grille, Bareme bareme) {
        this.grille = grille;
        this.bareme = bareme;
        gabarits.setClassForTemplateLoading(Pages.class, "/pages");
        gabarits.setDefaultEncoding("UTF-8");
        gabarits.setURLEscapingCharset("UTF-8");
        gabarits.setLocale(Locale.FRANCE);
        gabarits.setNumberFormat("0.##;; roundingMode=halfUp");
        gabarits.setTemplateExceptionHandler(TemplateExceptionHandler.RETHROW_HANDLER);
        gabarits.setLogTemplateExceptions(false);
        DefaultObjectWrapperBuilder objets = new DefaultObjectWrapperBuilder(Configuration.VERSION_2_3_34);
        objets.setExposeFields(true);
        gabarits.setObjectWrapper(objets.build());
    }

    /**
     * Écrit {@code index.html}, {@code classe.csv} et {@code etudiants/}. Une page ou une rangée qui échoue ne coûte qu'elle.
     *
     * @param compte nombres d'entrées et de lignes ; @param avis messages à montrer en tête, et qui reçoit ces échecs
     * @return les rendus dont la page ou la rangée a échoué
     */
    public List<Eleve> ecrire(Path dossier, List<Eleve> eleves, String compte, List<String> avis, Sorties sorties)
            throws IOException {
        Path etudiants = Files.createDirectories(dossier.resolve("etudiants"));
        List<String> rangees = new ArrayList<>();
        List<Eleve> manques = new ArrayList<>();
        for (Eleve eleve : eleves) {
            Map<String, Object> donnees = new HashMap<>(Map.of("eleve", eleve));
            String page;
            String rangee;
            try {
                page = remplir("eleve", donnees);
                rangee = remplir("rangee", donnees);
            } catch (TemplateException e) {
                manques.add(eleve);
                avis.add("la page de " + eleve.resultat.qui() + " n'a pu être écrite : " + Texte.protege(e.getMessage(), PANNE_MAX));
                page = vide("eleve", donnees);
                rangee = vide("rangee", donnees);
            }
            Files.writeString(etudiants.resolve(eleve.page), page);
            rangees.add(rangee);
        }
        try {
            Files.writeString(dossier.resolve("index.html"), remplir("classe", Map.of("eleves", eleves, "avis", avis, "compte", compte,
                    "rangees", HTMLOutputFormat.INSTANCE.fromMarkup(String.join("", rangees)))));
        } catch (TemplateException e) {
            throw new IOException(e);
        }
        tableau(dossier.resolve("classe.csv"), eleves, sorties);
        return manques;
    }

    /** La page ou la rangée, réduites au nom et à la note. */
    private String vide(String gabarit, Map<String, Object> donnees) throws IOException {
        donnees.put("panne", true);
        try {
            return remplir(gabarit, donnees);
        } catch (TemplateException e) {
            throw new IOException(e);
        }
    }

    private String remplir(String gabarit, Map<String, ?> donnees) throws IOException, TemplateException {
        deplies.clear();
        Map<String, Object> toutes = new HashMap<>(donnees);
        toutes.putAll(Map.of("pages", this, "grille", grille, "bareme", bareme, "scenes", new ArrayList<>(Reference.SCENES.keySet())));
        StringWriter page = new StringWriter();
        gabarits.getTemplate(gabarit + ".ftlh").process(toutes, page);
        return Texte.NUISIBLES.matcher(page.toString()).replaceAll("�");
    }

    private void tableau(Path fichier, List<Eleve> eleves, Sorties sorties) throws IOException {
        List<String> titres = new ArrayList<>(List.of("identifiant", "nom", "note", "sur", "étape atteinte",
                "image identique", "refus", "à regarder"));
        grille.etapes.forEach(e -> titres.add(e.nom));
        List<List<?>> lignes = new ArrayList<>(List.of(titres));
        for (Eleve e : eleves) {
            // un rendu qui n'a pu être jugé n'a pas de note
            String note = "";
            String atteinte = "";
            String identique = "";
            if (!e.illisible()) {
                note = String.format(Locale.ROOT, "%.2f", e.note);
                atteinte = e.atteinte;
                identique = e.parts.get(GrilleDeNotation.IMAGE).complete() ? "oui" : "non";
            }
            List<String> ligne = new ArrayList<>(List.of(e.resultat.id, e.resultat.nom, note,
                    String.format(Locale.ROOT, "%.2f", bareme.total), atteinte, identique,
                    String.join(" ; ", e.resultat.refus), String.join(" ; ", e.aRegarder)));
            e.parts.values().forEach(part -> ligne.add(e.illisible() ? "" : combien(part)));
            ligne.replaceAll(Texte::sansFormule);
            lignes.add(ligne);
        }
        Ajustements.ecrire(fichier, lignes, sorties);
    }

    /** « 5/8 » ; pour une extension ou une ligne libre, les points, ou « à noter » ; rien pour un bonus que l'on n'a pas. */
    public String combien(Eleve.Part part) {
        if (part.aNoter) {
            return "à noter";
        } else if (part.ajustement != null) {
            return nombre(part.points) + (part.sur > 0 ? "/" + nombre(part.sur) : "");
        }
        return part.comptent == 0 ? "" : part.reussis + "/" + part.comptent;
    }

    private static String nombre(double x) {
        return String.format(Locale.FRANCE, "%.2f", x).replaceFirst(",?0+$", "");
    }

    /** La sorte d'une part : sa couleur, dans {@code commun.ftlh}. */
    public String sorte(Eleve.Part part) {
        if (part.aNoter || part.vide()) {
            return part.aNoter ? "a_noter" : "vide";
        } else if (part.complete()) {
            return "complet";
        }
        return part.reussis > 0 || part.points > 0 ? "partiel" : "rate";
    }

    public double moyenne(List<Eleve> eleves) {
        return eleves.stream().mapToDouble(e -> e.note).average().orElse(0);
    }

    public double mediane(List<Eleve> eleves) {
        double[] notes = eleves.stream().mapToDouble(e -> e.note).sorted().toArray();
        return (notes[notes.length / 2] + notes[(notes.length - 1) / 2]) / 2;
    }

    /** Nombre de notes de chaque dixième de la note maximale, du plus bas au plus haut. */
    public int[] histogramme(List<Eleve> eleves) {
        int[] nombres = new int[10];
        eleves.forEach(e -> nombres[(int) Math.min(9, 10 * e.note / bareme.total)]++);
        return nombres;
    }

    /** Vrai la première fois que la page en cours demande ce texte. */
    public boolean nouveau(String texte) {
        return deplies.add(texte);
    }

    /**
     * La première faute à corriger, dans l'ordre des étapes ou, si rien de commencé n'est faux, ce qui est à commencer : quoi faire,
     * l'étape, le critère et le verdict ; {@code null} s'il n'y a rien à faire.
     */
    public List<?> aFaire(Eleve eleve) {
        List<?> faute = premier(eleve, (etape, verdict) -> verdict.rate() && bareme.poids(etape.nom) != 0, "à reprendre d'abord");
        if (faute != null && ((GrilleDeNotation.Etape) faute.get(1)).duCours()) {
            return faute;
        }
        List<?> suivante = premier(eleve, (etape, verdict) -> etape.duCours() && bareme.poids(etape.nom) != 0
                && verdict.etat == Verdict.Etat.NON_COMMENCE, "à commencer");
        return suivante == null ? faute : suivante;
    }

    private List<?> premier(Eleve eleve, BiPredicate<GrilleDeNotation.Etape, Verdict> lequel, String quoi) {
        for (GrilleDeNotation.Etape etape : grille.etapes) {
            for (Verification critere : etape.criteres) {
                Verdict verdict = eleve.resultat.verdict(critere);
                if (lequel.test(etape, verdict)) {
                    return List.of(quoi, etape, critere, verdict);
                }
            }
        }
        return null;
    }
}
