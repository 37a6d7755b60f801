package lancer.correction.note;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.correction.jugement.Grille;
import lancer.correction.jugement.Resultat;
import lancer.correction.jugement.Verdict;

/**
 * La note d'un rendu : par étape, la part des critères réussis, ou ce que l'enseignant a donné lui-même. Ce qui n'est
 * pas évaluable n'est pas une faute, mais ne rapporte rien : {@link #perduSansJuger} dit combien.
 */
public final class Note {

    /** Une étape notée, ou une ligne libre du barème. */
    public static final class Part {

        /** Nombre de critères réussis ; une extension peut l'être en partie. */
        public final double reussis;
        public final int comptent;
        /** Nombre de ceux qui ne sont ni réussis, ni ratés. */
        public final long aFaire;
        private final long nonEvaluables;
        public final double points;
        /** Points qu'elle peut rapporter au plus ; 0 pour les consignes, qui enlèvent des points. */
        public final double sur;
        /** Points que l'enseignant a donnés à la place, {@code null} s'il n'a rien donné. */
        public final Ajustements.Ligne ajustement;

        Part(List<Grille.Critere> criteres, Resultat resultat, double poids, boolean enleve, Ajustements.Ligne ajustement) {
            // ce que le projet à compléter réussit ne rapporte rien, mais le perdre coûte
            List<Verdict> verdicts = criteres.stream().filter(c -> c.compte || resultat.verdict(c).rate())
                    .map(resultat::verdict).collect(Collectors.toList());
            comptent = verdicts.size();
            reussis = verdicts.stream().mapToDouble(v -> v.part).sum();
            nonEvaluables = verdicts.stream().filter(v -> v.etat == Verdict.Etat.NON_EVALUABLE).count();
            aFaire = nonEvaluables + verdicts.stream().filter(v -> v.etat == Verdict.Etat.NON_COMMENCE).count();
            sur = enleve ? 0 : poids;
            this.ajustement = ajustement;
            points = ajustement != null ? ajustement.points : (comptent == 0 ? 0 : poids * reussis / comptent) - (enleve ? poids : 0);
        }

        public boolean complete() {
            return reussis == comptent;
        }
    }

    /** Tout ce qui fait la note, par étape ou ligne libre du barème. */
    public final Map<String, Part> parts = new LinkedHashMap<>();
    /** La dernière étape dont tout réussit, celles d'avant où il manque quelque chose, et les extensions réussies. */
    public final String atteinte;
    /** Le nom de l'étape du cours après laquelle aucune n'est finie, vide si la dernière l'est. */
    public final String arret;
    /** Les points que coûte ce qui n'a pu être jugé. */
    public final double perduSansJuger;

    /** @param siens ce que l'enseignant a donné à cet étudiant */
    public Note(Grille grille, Resultat resultat, Bareme bareme, Map<String, Ajustements.Ligne> siens) {
        String derniere = "";
        List<Grille.Etape> avant = new ArrayList<>();
        List<String> manquent = new ArrayList<>();
        List<String> extensions = new ArrayList<>();
        double perdu = 0;
        for (Grille.Etape etape : grille.etapes) {
            Part part = new Part(etape.criteres, resultat, bareme.poids(etape.nom), etape.nom.equals(Grille.CONSIGNES),
                    siens.get(etape.nom));
            parts.put(etape.nom, part);
            perdu += part.ajustement == null && part.comptent > 0 ? bareme.poids(etape.nom) * part.nonEvaluables / part.comptent : 0;
            if (etape.duCours && part.complete()) {
                derniere = etape.titre;
                avant.forEach(e -> manquent.add(e.titre));
                avant.clear();
            } else if (etape.duCours) {
                avant.add(etape);
            } else if (part.complete() && etape.extension) {
                extensions.add(etape.court);
            }
        }
        for (String libre : bareme.libres) {
            parts.put(libre, new Part(List.of(), resultat, bareme.poids(libre), false, siens.get(libre)));
        }
        perduSansJuger = perdu;
        arret = avant.isEmpty() ? "" : avant.get(0).nom;
        atteinte = (derniere.isEmpty() ? total() > 0 ? "aucune en entier" : "aucune" : derniere)
                + (manquent.isEmpty() ? "" : ", mais reste à compléter : " + String.join(", ", manquent))
                + (extensions.isEmpty() ? "" : " ; extensions : " + String.join(", ", extensions));
    }

    /** Les points obtenus, sur {@link Bareme#total()} ; jamais moins que zéro. */
    public double total() {
        return Math.max(0, parts.values().stream().mapToDouble(p -> p.points).sum());
    }
}
