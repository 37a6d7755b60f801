package lancer.commande;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/**
 * Ce qu'un texte vaut pour une option, et l'écriture d'une valeur, qu'elle relit.
 *
 * @param <T> ce qui est lu
 */
final class Lecture<T> {

    private final Function<String, T> lire;
    private final Function<T, String> ecrire;

    /** @param lire rend {@code null} si le texte n'est pas une valeur */
    private Lecture(Function<String, T> lire, Function<T, String> ecrire) {
        this.lire = lire;
        this.ecrire = ecrire;
    }

    /** La valeur que dit ce texte ; {@code null} s'il n'en dit pas. */
    T lire(String texte) {
        return lire.apply(texte);
    }

    String ecrire(T valeur) {
        return ecrire.apply(valeur);
    }

    /** Une option sans valeur : sa présence la dit vraie. */
    static Lecture<Boolean> presence() {
        return new Lecture<>(texte -> texte.isEmpty() ? true : null, presente -> "");
    }

    /** Un nom de fichier, celui qui est donné et non celui où mène un lien. @param fins comment il peut finir */
    static Lecture<String> fichier(String... fins) {
        return new Lecture<>(texte -> Arrays.asList(fins).contains(
                Texte.minuscules(texte.substring(Math.max(0, texte.lastIndexOf('.'))))) ? texte : null, nom -> nom);
    }

    /** Une de ces valeurs, par son texte. */
    static <V> Lecture<V> parmi(List<V> valeurs) {
        return new Lecture<>(texte -> valeurs.stream().filter(valeur -> valeur.toString().equals(texte)).findFirst()
                .orElse(null), Object::toString);
    }

    /** Des noms séparés par une virgule, quelle que soit leur casse. */
    static Lecture<Set<String>> noms() {
        return new Lecture<>(texte -> {
            Set<String> noms = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
            Collections.addAll(noms, texte.split(",", -1));
            return noms.contains("") ? null : Collections.unmodifiableSet(noms);
        }, noms -> noms.stream().map(Texte::minuscules).collect(Collectors.joining(",")));
    }

    static Lecture<Integer> entier(int min, int max) {
        return new Lecture<>(texte -> {
            double n = Nombre.lireEntier(texte);
            return n >= min && n <= max ? (int) n : null;
        }, n -> Integer.toString(n));
    }

    /** @param debut ce qui précède le nombre */
    static Lecture<Double> nombre(String debut, double min, double max) {
        return new Lecture<>(texte -> texte.startsWith(debut)
                ? borner(Nombre.lire(texte.substring(debut.length())), min, max) : null, n -> debut + Nombre.ecrire(n));
    }

    /** Une part, de 0 à 1 ou de 0% à 100%. */
    static Lecture<Double> part() {
        return new Lecture<>(texte -> {
            boolean pourCent = texte.endsWith("%");
            double n = Nombre.lire(pourCent ? texte.substring(0, texte.length() - 1) : texte);
            // une division arrondirait : 0.7 % doit donner exactement 0.007
            return borner(pourCent && n <= 100 ? BigDecimal.valueOf(n).movePointLeft(2).doubleValue() : n, 0, 1);
        }, Nombre::ecrire);
    }

    /** Deux entiers de {@code min} à {@code max}, dont le produit est limité. */
    static Lecture<Couple> couple(String separateur, int min, int max, int produitMax) {
        return new Lecture<>(texte -> {
            String[] nombres = texte.split(separateur, 2);
            double x = Nombre.lireEntier(nombres[0]);
            double y = Nombre.lireEntier(nombres[nombres.length - 1]);
            boolean estPermis = nombres.length == 2 && Math.min(x, y) >= min && Math.max(x, y) <= max;
            return estPermis && x * y <= produitMax ? new Couple((int) x, (int) y) : null;
        }, couple -> couple.x + separateur + couple.y);
    }

    private static Double borner(double n, double min, double max) {
        return n >= min && n <= max ? n : null;
    }
}
