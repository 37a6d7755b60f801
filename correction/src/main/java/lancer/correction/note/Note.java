package lancer.correction.note;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
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
        /** Combien ne sont ni réussis, ni ratés. */
        public final int aFaire;
        public final double points;
        public final double poids;

        Part(int reussis, int comptent, int aFaire, double poids) {
            this.reussis = reussis;
            this.comptent = comptent;
            this.aFaire = aFaire;
            this.poids = poids;
            this.points = comptent == 0 ? 0 : poids * reussis / comptent;
        }

        public boolean complete() {
            return reussis == comptent;
        }
    }

    private final Map<String, Part> parts = new LinkedHashMap<>();
    private final String atteinte;

    public Note(Grille grille, Resultat resultat, Bareme bareme) {
        String derniere = "";
        List<String> avant = new ArrayList<>();
        List<String> manquent = new ArrayList<>();
        List<String> extensions = new ArrayList<>();
        for (Grille.Etape etape : grille.getEtapes()) {
            int reussis = 0;
            int comptent = 0;
            int aFaire = 0;
            for (Grille.Critere critere : etape.criteres) {
                Verdict verdict = resultat.verdicts.get(critere.id);
                if (critere.compte) {
                    comptent++;
                    reussis += verdict != null && verdict.compte() ? 1 : 0;
                    aFaire += verdict == null || verdict.etat == Verdict.Etat.NON_COMMENCE
                            || verdict.etat == Verdict.Etat.NON_EVALUABLE ? 1 : 0;
                }
            }
            Part part = new Part(reussis, comptent, aFaire, bareme.poids(etape.nom));
            parts.put(etape.nom, part);
            if (etape.duCours && part.complete()) {
                derniere = etape.titre;
                manquent.addAll(avant);
                avant.clear();
            } else if (etape.duCours) {
                avant.add(etape.titre);
            } else if (part.complete() && etape.extension) {
                extensions.add(etape.court());
            }
        }
        atteinte = (derniere.isEmpty() ? total() > 0 ? "aucune en entier" : "aucune" : derniere)
                + (manquent.isEmpty() ? "" : ", mais reste à compléter : " + String.join(", ", manquent))
                + (extensions.isEmpty() ? "" : " ; extensions : " + String.join(", ", extensions));
    }

    public Part part(String etape) {
        return parts.get(etape);
    }

    /** Les points obtenus, sur {@link Bareme#total()}. */
    public double total() {
        return parts.values().stream().mapToDouble(p -> p.points).sum();
    }

    /** La dernière étape dont tout réussit, celles d'avant où il manque quelque chose, et les extensions réussies. */
    public String getAtteinte() {
        return atteinte;
    }
}
