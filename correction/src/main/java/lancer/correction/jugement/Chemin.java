package lancer.correction.jugement;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Réponses intermédiaires, pour un pixel, des méthodes du corrigé et de celles de l'étudiant, et la première réponse différente. */
public final class Chemin {

    private static final double PRES = 1e-6;

    public static final class Pas {

        public final String nom;
        public final String attendu;
        public final String obtenu;
        public final boolean pareil;

        Pas(Object nom, Map<?, ?> attendus, Map<?, ?> siens) {
            this.nom = nom.toString();
            attendu = Objects.toString(attendus.get(nom), "(pas de réponse)");
            obtenu = Objects.toString(siens.get(nom), "(pas de réponse)");
            pareil = pareil(attendu, obtenu);
        }
    }

    public final int x;
    public final int y;
    public final List<Pas> pas;

    /** @param corrige réponses de la sonde avec le corrigé : des noms, chacun suivi de sa valeur ; @param rendu avec le rendu */
    Chemin(int x, int y, List<?> corrige, List<?> rendu) {
        Map<?, ?> attendus = parNom(corrige);
        Map<?, ?> siens = parNom(rendu);
        this.x = x;
        this.y = y;
        pas = Stream.concat(attendus.keySet().stream(), siens.keySet().stream()).distinct()
                .map(nom -> new Pas(nom, attendus, siens)).collect(Collectors.toList());
    }

    private static Map<Object, Object> parNom(List<?> reponses) {
        Map<Object, Object> noms = new LinkedHashMap<>();
        for (int k = 0; k + 1 < reponses.size(); k += 2) {
            noms.put(reponses.get(k), reponses.get(k + 1));
        }
        return noms;
    }

    /** La première réponse différente, {@code null} s'il n'y en a pas. */
    public Pas getPremierEcart() {
        return pas.stream().filter(p -> !p.pareil).findFirst().orElse(null);
    }

    /** Nombre de réponses avant la première différente. */
    int rangDuPremierEcart() {
        return getPremierEcart() == null ? Integer.MAX_VALUE : pas.indexOf(getPremierEcart());
    }

    private static boolean pareil(String a, String b) {
        String[] x = a.split(" ");
        String[] y = b.split(" ");
        try {
            return x.length == y.length && IntStream.range(0, x.length).allMatch(k -> {
                double u = Double.parseDouble(x[k]);
                double v = Double.parseDouble(y[k]);
                return u == v || Math.abs(u - v) <= PRES * (1 + Math.abs(u));
            });
        } catch (NumberFormatException e) {
            return a.equals(b);
        }
    }
}
