package lancer.correction.note;

import java.util.LinkedHashMap;
import java.util.Map;
import lancer.correction.jugement.Grille;
import lancer.correction.jugement.Resultat;
import lancer.correction.jugement.Verdict;

/**
 * La note d'un rendu : par étape, la part des critères réussis. Ce qui n'est pas évaluable ne rapporte rien, et n'est
 * pas une faute.
 */
public final class Note {

    /** Une étape notée. */
    public static final class Part {

        public final int reussis;
        public final int comptent;
        public final int nonEvaluables;
        public final int nonCommences;
        public final double points;
        public final double poids;

        Part(int reussis, int comptent, int nonEvaluables, int nonCommences, double poids) {
            this.reussis = reussis;
            this.comptent = comptent;
            this.nonEvaluables = nonEvaluables;
            this.nonCommences = nonCommences;
            this.poids = poids;
            this.points = comptent == 0 ? 0 : poids * reussis / comptent;
        }

        public boolean complete() {
            return reussis == comptent;
        }
    }

    private final Map<String, Part> parts = new LinkedHashMap<>();
    private final String atteinte;
    private final double total;

    public Note(Grille grille, Resultat resultat, Bareme bareme) {
        String derniere = "aucune";
        boolean suite = true;
        for (Grille.Etape etape : grille.getEtapes()) {
            int reussis = 0;
            int comptent = 0;
            int nonEvaluables = 0;
            int nonCommences = 0;
            for (Grille.Critere critere : etape.criteres) {
                Verdict verdict = resultat.verdicts.get(critere.id);
                if (critere.compte) {
                    comptent++;
                    reussis += verdict != null && verdict.compte() ? 1 : 0;
                    nonEvaluables += verdict != null && verdict.etat == Verdict.Etat.NON_EVALUABLE ? 1 : 0;
                    nonCommences += verdict == null || verdict.etat == Verdict.Etat.NON_COMMENCE ? 1 : 0;
                }
            }
            Part part = new Part(reussis, comptent, nonEvaluables, nonCommences, bareme.poids(etape.nom));
            parts.put(etape.nom, part);
            suite &= part.complete();
            derniere = suite && !etape.nom.equals("image") ? etape.titre : derniere;
        }
        atteinte = derniere;
        total = parts.values().stream().mapToDouble(p -> p.points).sum();
    }

    public Part part(String etape) {
        return parts.get(etape);
    }

    /** Les points obtenus, sur {@link Bareme#total()}. */
    public double total() {
        return total;
    }

    /** La dernière étape dont tout réussit, et tout ce qui précède avec elle. */
    public String getAtteinte() {
        return atteinte;
    }
}
