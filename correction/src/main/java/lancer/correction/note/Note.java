package lancer.correction.note;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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

        /** Combien de critères sont réussis ; une extension peut l'être en partie. */
        public final double reussis;
        public final int comptent;
        /** Combien ne sont ni réussis, ni ratés. */
        public final int aFaire;
        private final int nonEvaluables;
        public final double points;
        /** Ce qu'elle peut rapporter au plus ; 0 pour les consignes, qui enlèvent des points. */
        public final double sur;
        /** Ce que l'enseignant a donné à la place, {@code null} s'il n'a rien donné. */
        public final Ajustements.Ligne ajustement;

        Part(double reussis, int comptent, int aFaire, int nonEvaluables, double points, double sur, Ajustements.Ligne ajustement) {
            this.reussis = reussis;
            this.comptent = comptent;
            this.aFaire = aFaire;
            this.nonEvaluables = nonEvaluables;
            this.sur = sur;
            this.ajustement = ajustement;
            this.points = ajustement == null ? points : ajustement.points;
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
            Part part = part(etape, resultat, bareme.poids(etape.nom), siens.get(etape.nom));
            parts.put(etape.nom, part);
            perdu += part.ajustement == null && part.comptent > 0 ? bareme.poids(etape.nom) * part.nonEvaluables / part.comptent : 0;
            if (etape.duCours && part.complete()) {
                derniere = etape.titre;
                avant.forEach(e -> manquent.add(e.titre));
                avant.clear();
            } else if (etape.duCours) {
                avant.add(etape);
            } else if (part.complete() && etape.extension) {
                extensions.add(etape.court());
            }
        }
        for (String libre : bareme.libres) {
            parts.put(libre, new Part(0, 0, 0, 0, 0, bareme.poids(libre), siens.get(libre)));
        }
        perduSansJuger = perdu;
        arret = avant.isEmpty() ? "" : avant.get(0).nom;
        atteinte = (derniere.isEmpty() ? total() > 0 ? "aucune en entier" : "aucune" : derniere)
                + (manquent.isEmpty() ? "" : ", mais reste à compléter : " + String.join(", ", manquent))
                + (extensions.isEmpty() ? "" : " ; extensions : " + String.join(", ", extensions));
    }

    private static Part part(Grille.Etape etape, Resultat resultat, double poids, Ajustements.Ligne ajustement) {
        double reussis = 0;
        int comptent = 0;
        int aFaire = 0;
        int nonEvaluables = 0;
        for (Grille.Critere critere : etape.criteres) {
            Verdict verdict = resultat.verdict(critere);
            // ce que le projet à compléter réussit ne rapporte rien, mais le perdre coûte
            if (critere.compte || verdict.etat == Verdict.Etat.RATE) {
                comptent++;
                reussis += verdict.part;
                aFaire += verdict.etat == Verdict.Etat.NON_COMMENCE ? 1 : 0;
                nonEvaluables += verdict.etat == Verdict.Etat.NON_EVALUABLE ? 1 : 0;
            }
        }
        double gagnes = comptent == 0 ? 0 : poids * reussis / comptent;
        boolean enleve = etape.nom.equals(Grille.CONSIGNES);
        return new Part(reussis, comptent, aFaire + nonEvaluables, nonEvaluables, enleve ? gagnes - poids : gagnes, enleve ? 0 : poids,
                ajustement);
    }

    /** @param critere une étape, ou une ligne libre du barème */
    public Part part(String critere) {
        return parts.get(critere);
    }

    /** Les points obtenus, sur {@link Bareme#total()} ; jamais moins que zéro. */
    public double total() {
        return Math.max(0, parts.values().stream().mapToDouble(p -> p.points).sum());
    }

}
