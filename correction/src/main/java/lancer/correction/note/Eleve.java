package lancer.correction.note;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.correction.jugement.GrilleDeNotation;
import lancer.correction.jugement.Resultat;
import lancer.correction.jugement.Verdict;
import lancer.correction.jugement.Verification;
import lancer.correction.modele.SourcesDuCours;

/**
 * Une ligne de la classe : ce qu'on a trouvé d'un rendu, et sa note. Chaque étape rapporte la part de ses critères réussis, ou ce que
 * l'enseignant a donné lui-même. Les points d'une extension, et ceux d'une ligne libre du barème, ne viennent que de l'enseignant. Ce
 * qui n'est pas évaluable n'est pas une faute, mais ne rapporte rien : {@link #perdus} dit combien.
 */
public final class Eleve {

    /** Nombre de méthodes pareilles à partir duquel deux rendus sont dits pareils. */
    private static final int PAREILLES = 3;

    /** Une étape notée, ou une ligne libre du barème. */
    public static final class Part {

        public final long reussis;
        public final int comptent;
        /** Vrai si ses points n'ont pas encore été donnés, et que seul l'enseignant les donne. */
        public final boolean aNoter;
        public final double points;
        /** Points qu'elle peut rapporter au plus ; 0 pour les consignes, qui enlèvent des points. */
        public final double sur;
        /** Points que l'enseignant a donnés, {@code null} s'il n'a rien donné. */
        public final Ajustements.Ligne ajustement;
        private final List<Verdict> verdicts;

        Part(List<Verification> criteres, Resultat resultat, double poids, boolean enleve, Ajustements.Ligne ajustement) {
            // ce que le projet à compléter réussit ne rapporte rien, mais le perdre coûte
            verdicts = criteres.stream().filter(c -> c.compte || resultat.verdict(c).rate()).map(resultat::verdict)
                    .collect(Collectors.toList());
            comptent = verdicts.size();
            reussis = verdicts.stream().filter(Verdict::compte).count();
            aNoter = ajustement == null && poids > 0 && (criteres.isEmpty() || nombre(Verdict.Etat.A_NOTER) > 0);
            sur = enleve ? 0 : poids;
            this.ajustement = ajustement;
            points = ajustement != null ? ajustement.points : (comptent == 0 ? 0 : poids * reussis / comptent) - (enleve ? poids : 0);
        }

        private long nombre(Verdict.Etat etat) {
            return verdicts.stream().filter(v -> v.etat == etat).count();
        }

        /** Points que ces verdicts coûtent ; aucun si l'enseignant en a donné. */
        private double perdus(Verdict.Etat etat) {
            return ajustement != null || comptent == 0 ? 0 : sur * nombre(etat) / comptent;
        }

        /** Vrai si tout y est réussi, ou si l'enseignant en a donné tous les points. */
        public boolean complete() {
            return comptent > 0 && reussis == comptent || ajustement != null && points >= sur;
        }

        /** Vrai si rien n'y est réussi, ni raté, ni à noter. */
        public boolean vide() {
            return ajustement == null && nombre(Verdict.Etat.NON_COMMENCE) + nombre(Verdict.Etat.NON_EVALUABLE) == comptent;
        }
    }

    public final Resultat resultat;
    /** Le nom de sa page. */
    public final String page;
    /** Raisons pour lesquelles l'enseignant doit regarder ce rendu lui-même ; vide si rien ne le demande. */
    public final List<String> aRegarder;
    /** Tout ce qui fait la note, par étape ou ligne libre du barème. */
    public final Map<String, Part> parts = new LinkedHashMap<>();
    /** La dernière étape dont tout réussit, celles d'avant où il manque quelque chose, et les extensions rendues. */
    public final String atteinte;
    /** Le nom de l'étape du cours après laquelle aucune n'est finie, vide si la dernière l'est. */
    public final String arret;
    /** Le maximum : celui du barème, et les lignes libres dont les points sont donnés. */
    public final double sur;

    /** @param siens ce que l'enseignant a donné à cet étudiant */
    public Eleve(Resultat resultat, String page, GrilleDeNotation grille, Bareme bareme, Map<String, Ajustements.Ligne> siens) {
        this.resultat = resultat;
        this.page = page;
        aRegarder = new ArrayList<>(illisible() ? resultat.refus : resultat.aRegarder);
        String derniere = "";
        List<GrilleDeNotation.Etape> avant = new ArrayList<>();
        List<String> manquent = new ArrayList<>();
        List<String> extensions = new ArrayList<>();
        List<String> aNoter = new ArrayList<>();
        double maximum = bareme.total;
        for (GrilleDeNotation.Etape etape : grille.etapes) {
            Part part = new Part(etape.criteres, resultat, bareme.poids(etape.nom), etape.nom.equals(GrilleDeNotation.CONSIGNES),
                    siens.get(etape.nom));
            parts.put(etape.nom, part);
            maximum += etape.libre() && part.ajustement != null ? part.sur : 0;
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
        sur = maximum;
        arret = avant.isEmpty() ? "" : avant.get(0).nom;
        atteinte = (derniere.isEmpty() ? total() > 0 ? "aucune en entier" : "aucune" : derniere)
                + (manquent.isEmpty() ? "" : ", mais reste à compléter : " + String.join(", ", manquent))
                + (extensions.isEmpty() ? "" : " ; extensions : " + String.join(", ", extensions))
                + (aNoter.isEmpty() ? "" : " ; extensions à noter : " + String.join(", ", aNoter));
        dire("coûtés par ce qui ne se compile pas : ", Verdict.Etat.NE_SE_COMPILE_PAS, resultat.fautes);
        dire("perdus par ce qui n'a pu être évalué", Verdict.Etat.NON_EVALUABLE, List.of());
    }

    /** Les points obtenus, sur {@link #sur} ; jamais moins que zéro. */
    public double total() {
        return Math.max(0, parts.values().stream().mapToDouble(p -> p.points).sum());
    }

    /** Noms des extensions rendues et des lignes libres dont les points ne sont pas encore donnés. */
    public List<String> aNoter() {
        return parts.entrySet().stream().filter(p -> p.getValue().aNoter).map(Map.Entry::getKey).collect(Collectors.toList());
    }

    /** Points que coûtent les critères de cet état. */
    public double perdus(Verdict.Etat etat) {
        return parts.values().stream().mapToDouble(p -> p.perdus(etat)).sum();
    }

    private void dire(String cause, Verdict.Etat etat, List<String> fautes) {
        double perdus = perdus(etat);
        if (perdus > 0) {
            aRegarder.add(fautes.isEmpty() ? aRegarder.size() : 0, String.format(Locale.FRANCE, "%.2f points %s%s", perdus, cause,
                    fautes.isEmpty() ? "" : fautes.get(0)));
        }
    }

    /** Vrai si rien n'a pu être jugé. */
    public boolean illisible() {
        return !resultat.refus.isEmpty();
    }

    /** Ajoute à ce qu'il faut regarder ce qu'on ne voit qu'en comparant : des méthodes pareilles, une classe donnée que l'un a changée. */
    public static void comparer(List<Eleve> eleves) {
        Map<String, Integer> nombres = new HashMap<>();
        eleves.forEach(e -> e.resultat.arbres.values().stream().distinct().forEach(a -> nombres.merge(a, 1, Integer::sum)));
        // celle de presque tous vient du cours, et non d'un voisin
        nombres.values().removeIf(n -> n > 2 && 4 * n > 3 * eleves.size());
        for (Eleve e : eleves) {
            for (Eleve autre : eleves) {
                List<String> pareilles = e == autre ? List.of() : e.resultat.arbres.entrySet().stream()
                        .filter(m -> nombres.containsKey(m.getValue()) && autre.resultat.arbres.containsValue(m.getValue()))
                        .map(Map.Entry::getKey).collect(Collectors.toList());
                if (pareilles.size() >= PAREILLES) {
                    e.aRegarder.add("pareil à " + autre.resultat.nom + ", aux noms des variables et à la présentation près : "
                            + String.join(", ", pareilles));
                }
            }
        }
        for (String classe : SourcesDuCours.DONNEES) {
            Map<String, List<Eleve>> textes = eleves.stream().filter(e -> !classe.equals("Main")
                    && e.resultat.empreintes.containsKey(classe))
                    .collect(Collectors.groupingBy(e -> e.resultat.empreintes.get(classe)));
            // celle que presque tous ont rendue est celle qu'on leur a donnée
            textes.values().stream().filter(t -> t.size() < 3 || 2 * t.size() < eleves.size()).forEach(t -> t.forEach(e ->
                    e.aRegarder.add("la classe donnée " + classe + " a été changée")));
        }
    }
}
