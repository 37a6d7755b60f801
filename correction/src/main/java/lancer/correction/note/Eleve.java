package lancer.correction.note;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lancer.correction.jugement.GrilleDeNotation;
import lancer.correction.jugement.Resultat;
import lancer.correction.jugement.Verdict;

/**
 * Un rendu jugé et sa note. Chaque étape rapporte la part de ses critères réussis, ou les points que donne l'enseignant. Seul l'enseignant
 * donne les points d'une extension ou d'une ligne libre du barème. Un critère non évaluable n'est pas une faute, mais ne rapporte rien :
 * {@link #nonEvaluables} donne les points perdus.
 */
public final class Eleve {

    /** Une étape notée, ou une ligne libre du barème. */
    public static final class Part {

        public final long reussis;
        public final int comptent;
        /** Vrai si l'enseignant doit encore donner les points. */
        public final boolean aNoter;
        public final double points;
        /** Nombre maximal de points ; 0 pour une ligne hors du total. */
        public final double sur;
        /** Points que l'enseignant a donnés, ou {@code null}. */
        public final Ajustements.Ligne ajustement;
        private final List<Verdict> verdicts;

        Part(GrilleDeNotation.Etape etape, Resultat resultat, Bareme bareme, Ajustements.Ligne ajustement) {
            // un critère que le projet à compléter réussit ne rapporte rien, mais le rater coûte
            verdicts = etape.criteres.stream().filter(c -> c.compte || resultat.verdict(c).rate()).map(resultat::verdict)
                    .collect(Collectors.toList());
            comptent = verdicts.size();
            reussis = verdicts.stream().filter(Verdict::compte).count();
            double poids = bareme.poids(etape.nom);
            boolean hors = bareme.horsTotal(etape.nom);
            aNoter = ajustement == null && !hors && poids > 0 && (etape.libre() || nombre(Verdict.Etat.A_NOTER) > 0);
            sur = hors ? 0 : poids;
            this.ajustement = ajustement;
            points = ajustement != null ? bareme.ramener(ajustement.points) : gagnes(poids, hors);
        }

        /** Les points des critères réussis ; pour une ligne hors du total, ceux que coûtent les critères ratés. */
        private double gagnes(double poids, boolean hors) {
            long payes = hors ? comptent - reussis : reussis;
            return payes == 0 ? 0 : poids * payes / comptent;
        }

        private long nombre(Verdict.Etat etat) {
            return verdicts.stream().filter(v -> v.etat == etat).count();
        }

        /** Points perdus par ces critères ; aucun si l'enseignant a donné les points. */
        private double perdus(Predicate<Verdict> lesquels) {
            return ajustement != null || comptent == 0 ? 0 : sur * verdicts.stream().filter(lesquels).count() / comptent;
        }

        /** Dit si tout est réussi, ou si l'enseignant a donné tous les points. */
        public boolean complete() {
            return comptent > 0 && reussis == comptent || ajustement != null && points >= sur;
        }

        /** Dit si aucun critère n'est réussi, raté ou à noter. */
        public boolean vide() {
            return ajustement == null && nombre(Verdict.Etat.NON_COMMENCE) + nombre(Verdict.Etat.NON_EVALUABLE) == comptent;
        }
    }

    public final Resultat resultat;
    public final String page;
    /** Raisons pour lesquelles l'enseignant doit examiner ce rendu. */
    public final List<String> aRegarder;
    /** Les parts de la note, par étape ou ligne libre du barème. */
    public final Map<String, Part> parts = new LinkedHashMap<>();
    /** La dernière étape complète, les étapes précédentes incomplètes, et les extensions rendues. */
    public final String atteinte;
    /** La première étape du cours incomplète après laquelle aucune n'est complète ; vide si la dernière l'est. */
    public final String arret;
    /** Ce que la feuille de Moodle dit de ce rendu : remis, en retard de deux jours ; vide sans feuille. */
    public String statut = "";
    /** La note que donnent les parts, au centième, de 0 à {@link Bareme#total}. */
    public final double calculee;
    /** La note de l'étudiant : celle-là, ou celle que l'enseignant a mise dans la feuille. */
    public double note;

    /** @param siens points que l'enseignant a donnés à cet étudiant */
    public Eleve(Resultat resultat, String page, GrilleDeNotation grille, Bareme bareme, Map<String, Ajustements.Ligne> siens) {
        this.resultat = resultat;
        this.page = page;
        aRegarder = new ArrayList<>(illisible() ? resultat.refus : resultat.aRegarder);
        String derniere = "";
        List<GrilleDeNotation.Etape> avant = new ArrayList<>();
        List<String> manquent = new ArrayList<>();
        List<String> extensions = new ArrayList<>();
        List<String> aNoter = new ArrayList<>();
        for (GrilleDeNotation.Etape etape : grille.etapes) {
            Part part = new Part(etape, resultat, bareme, siens.get(etape.nom));
            parts.put(etape.nom, part);
            if (etape.duCours() && part.complete()) {
                derniere = etape.titre;
                avant.forEach(e -> manquent.add(e.titre));
                avant.clear();
            } else if (etape.duCours()) {
                avant.add(etape);
            } else if (etape.extension && !part.vide()) {
                (part.aNoter ? aNoter : extensions).add(etape.court);
            }
        }
        // arrondie une fois : toutes les pages et les feuilles écrivent la même
        calculee = Math.round(100 * Math.max(0, Math.min(bareme.total, parts.values().stream().mapToDouble(p -> p.points).sum()))) / 100.0;
        note = calculee;
        arret = avant.isEmpty() ? "" : avant.get(0).nom;
        String aucune = note > 0 ? "aucune en entier" : "aucune";
        atteinte = (derniere.isEmpty() ? aucune : derniere) + suite(", mais reste à compléter : ", manquent)
                + suite(" ; extensions : ", extensions) + suite(" ; extensions à noter : ", aNoter);
        direPerdus(nonEvaluables(), "ce qui n'a pu être évalué");
        direPerdus(perdus(Verdict::neSeCompilePas), "ce qui ne se compile pas");
    }

    private static String suite(String debut, List<String> titres) {
        return titres.isEmpty() ? "" : debut + String.join(", ", titres);
    }

    /** Noms des extensions rendues et des lignes libres dont les points ne sont pas encore donnés. */
    public List<String> aNoter() {
        return parts.entrySet().stream().filter(p -> p.getValue().aNoter).map(Map.Entry::getKey).collect(Collectors.toList());
    }

    /** Points perdus par ce qui n'a pu être évalué. */
    public double nonEvaluables() {
        return perdus(v -> v.etat == Verdict.Etat.NON_EVALUABLE);
    }

    private double perdus(Predicate<Verdict> lesquels) {
        return parts.values().stream().mapToDouble(p -> p.perdus(lesquels)).sum();
    }

    private void direPerdus(double points, String pourquoi) {
        if (points > 0) {
            aRegarder.add(String.format(Locale.FRANCE, "%.2f %s par %s", points, points < 2 ? "point perdu" : "points perdus", pourquoi));
        }
    }

    public boolean illisible() {
        return !resultat.refus.isEmpty();
    }
}
