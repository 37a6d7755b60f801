package lancer.correction.note;

import java.util.ArrayList;
import java.util.Collections;
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
        public final double points;
        public final double poids;
        /** Ce que l'enseignant a donné à la place, {@code null} s'il n'a rien donné. */
        public final Ajustements.Ligne ajustement;

        Part(double reussis, int comptent, int aFaire, double points, double poids, Ajustements.Ligne ajustement) {
            this.reussis = reussis;
            this.comptent = comptent;
            this.aFaire = aFaire;
            this.poids = poids;
            this.ajustement = ajustement;
            this.points = ajustement == null ? points : ajustement.points;
        }

        public boolean complete() {
            return reussis == comptent;
        }
    }

    private final Map<String, Part> parts = new LinkedHashMap<>();
    private final String atteinte;
    private String arret = "";
    private double perduSansJuger;

    /** @param siens ce que l'enseignant a donné à cet étudiant */
    public Note(Grille grille, Resultat resultat, Bareme bareme, Map<String, Ajustements.Ligne> siens) {
        String derniere = "";
        List<String> avant = new ArrayList<>();
        List<String> manquent = new ArrayList<>();
        List<String> extensions = new ArrayList<>();
        for (Grille.Etape etape : grille.getEtapes()) {
            double poids = bareme.poids(etape.nom);
            Part part = part(etape, resultat, poids, siens.get(etape.nom));
            parts.put(etape.nom, part);
            if (etape.duCours && part.complete()) {
                derniere = etape.titre;
                manquent.addAll(avant);
                avant.clear();
                arret = "";
            } else if (etape.duCours) {
                avant.add(etape.titre);
                arret = arret.isEmpty() ? etape.nom : arret;
            } else if (part.complete() && etape.extension) {
                extensions.add(etape.court());
            }
        }
        for (String libre : bareme.getLibres()) {
            parts.put(libre, new Part(0, 0, 0, 0, bareme.poids(libre), siens.get(libre)));
        }
        atteinte = (derniere.isEmpty() ? total() > 0 ? "aucune en entier" : "aucune" : derniere)
                + (manquent.isEmpty() ? "" : ", mais reste à compléter : " + String.join(", ", manquent))
                + (extensions.isEmpty() ? "" : " ; extensions : " + String.join(", ", extensions));
    }

    private Part part(Grille.Etape etape, Resultat resultat, double poids, Ajustements.Ligne ajustement) {
        double reussis = 0;
        int comptent = 0;
        int aFaire = 0;
        int nonEvaluables = 0;
        for (Grille.Critere critere : etape.criteres) {
            Verdict verdict = resultat.verdicts.get(critere.id);
            Verdict.Etat etat = verdict == null ? Verdict.Etat.NON_COMMENCE : verdict.etat;
            // ce que le projet à compléter réussit ne rapporte rien, mais le perdre coûte
            if (critere.compte || etat == Verdict.Etat.RATE) {
                comptent++;
                reussis += verdict == null ? 0 : verdict.part();
                aFaire += etat == Verdict.Etat.NON_COMMENCE || etat == Verdict.Etat.NON_EVALUABLE ? 1 : 0;
                nonEvaluables += etat == Verdict.Etat.NON_EVALUABLE ? 1 : 0;
            }
        }
        double gagnes = comptent == 0 ? 0 : poids * reussis / comptent;
        perduSansJuger += nonEvaluables == 0 || ajustement != null ? 0 : poids * nonEvaluables / comptent;
        return new Part(reussis, comptent, aFaire, etape.nom.equals(Grille.CONSIGNES) ? gagnes - poids : gagnes, poids,
                ajustement);
    }

    /** @param critere une étape, ou une ligne libre du barème */
    public Part part(String critere) {
        return parts.get(critere);
    }

    /** Tout ce qui fait la note, par étape ou ligne libre du barème. */
    public Map<String, Part> getParts() {
        return Collections.unmodifiableMap(parts);
    }

    /** Les points obtenus, sur {@link Bareme#total()} ; jamais moins que zéro. */
    public double total() {
        return Math.max(0, parts.values().stream().mapToDouble(p -> p.points).sum());
    }

    /** Les points que coûte ce qui n'a pu être jugé. */
    public double getPerduSansJuger() {
        return perduSansJuger;
    }

    /** La dernière étape dont tout réussit, celles d'avant où il manque quelque chose, et les extensions réussies. */
    public String getAtteinte() {
        return atteinte;
    }

    /** Le nom de l'étape du cours après laquelle aucune n'est finie, vide si la dernière l'est. */
    public String getArret() {
        return arret;
    }
}
