package lancer.contrat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.texte.Nombre;

/** Un réglage, tel que la fenêtre le nomme et le change. Un fichier accepte d'autres valeurs. Immuable. */
public final class Parametre {

    /** La clé, sa valeur par défaut comme dans un fichier, et la clé incompatible avec elle, ou {@code null}. */
    public final String cle;
    public final String defaut;
    public final String cleIncompatible;

    /** Les valeurs à choisir, comme dans un fichier : des mots, ou des nombres croissants ; vide pour un texte. */
    public final List<String> valeurs;

    /** Ce que la fenêtre accepte, en mots ; {@code null} pour une valeur à choisir qui se comprend seule. */
    public final String attendu;
    private final Predicate<String> possible;

    private Parametre(String cle, String defaut, List<String> valeurs, String cleIncompatible, String attendu,
            Predicate<String> possible) {
        this.cle = cle;
        this.defaut = defaut;
        this.valeurs = valeurs;
        this.cleIncompatible = cleIncompatible;
        this.attendu = attendu;
        this.possible = possible;
    }

    /** Un nombre de {@code min} à {@code max} par {@code pas} ; {@code defaut} peut être {@code null}. */
    public static Parametre nombre(String cle, Double defaut, double min, double max, double pas) {
        return new Parametre(cle, defaut == null ? null : Nombre.ecrire(defaut),
                IntStream.rangeClosed(0, (int) Math.round((max - min) / pas)).mapToObj(cran -> Nombre.ecrire(
                        BigDecimal.valueOf(pas).multiply(BigDecimal.valueOf(cran)).add(BigDecimal.valueOf(min))
                                .doubleValue())).collect(Collectors.toList()), null, null, valeur -> true);
    }

    /** Un mot parmi ceux-ci ; le premier est la valeur par défaut. */
    public static Parametre mot(String cle, String... mots) {
        return new Parametre(cle, mots[0], Arrays.asList(mots), null, null, valeur -> true);
    }

    /** Une couleur, trois composantes de 0 à 1. @param defaut comme dans un fichier de scène */
    public static Parametre couleur(String cle, String defaut) {
        return new Parametre(cle, defaut, Collections.emptyList(), null, "trois nombres de 0 à 1",
                Parametre::estUneCouleur);
    }

    /**
     * Un texte, ou un de ces mots s'il y en a.
     *
     * @param titre son nom dans la fenêtre
     * @param attendu ce qui est accepté, en mots
     * @param possible dit si un texte est accepté
     */
    public static Parametre texte(String titre, String attendu, Predicate<String> possible, Object... mots) {
        return new Parametre(titre, null, Arrays.stream(mots).map(Object::toString).collect(Collectors.toList()), null,
                attendu, possible);
    }

    /** Paramètre identique, incompatible avec cette autre clé. */
    public Parametre sans(String incompatible) {
        return new Parametre(cle, defaut, valeurs, incompatible, attendu, possible);
    }

    /** Le nom du réglage dans la fenêtre. */
    public String getTitre() {
        return cle;
    }

    /** Dit si ce texte, tapé dans la fenêtre, est une valeur. */
    public boolean accepte(String texte) {
        return possible.test(texte);
    }

    private static boolean estUneCouleur(String texte) {
        String[] composantes = texte.split("[ \t]+");
        return composantes.length == 3 && Arrays.stream(composantes).mapToDouble(Nombre::lire)
                .allMatch(composante -> composante >= 0 && composante <= 1);
    }

    /** Dit si la valeur se tape, au lieu de se choisir. */
    public boolean estUnTexte() {
        return valeurs.isEmpty();
    }

    public boolean estUnNombre() {
        return !estUnTexte() && !Double.isNaN(Nombre.lire(valeurs.get(0)));
    }

    /** Le rang, parmi {@link #valeurs}, du nombre le plus proche de celui-ci. */
    public int getRang(String nombre) {
        return IntStream.range(0, valeurs.size()).boxed().min(Comparator.comparingDouble(
                k -> Math.abs(Nombre.lire(valeurs.get(k)) - Nombre.lire(nombre)))).get();
    }
}
