package lancer.contrat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.texte.Nombre;

/** Une clé de variante que la fenêtre règle dans un intervalle utile. Un fichier accepte d'autres valeurs. Immuable. */
public final class Parametre {

    /** La clé, sa valeur par défaut comme dans un fichier, et la clé incompatible avec elle, ou {@code null}. */
    public final String cle;
    public final String defaut;
    public final String autre;

    /** Les valeurs à choisir, comme dans un fichier : des mots, ou des nombres croissants ; vide pour une couleur. */
    public final List<String> valeurs;

    private Parametre(String cle, String defaut, List<String> valeurs, String autre) {
        this.cle = cle;
        this.defaut = defaut;
        this.valeurs = valeurs;
        this.autre = autre;
    }

    /** Un nombre de {@code min} à {@code max} par {@code pas} ; {@code defaut} peut être {@code null}. */
    public static Parametre nombre(String cle, Double defaut, double min, double max, double pas) {
        return new Parametre(cle, defaut == null ? null : Nombre.ecrire(defaut),
                IntStream.rangeClosed(0, (int) Math.round((max - min) / pas)).mapToObj(cran -> Nombre.ecrire(
                        BigDecimal.valueOf(pas).multiply(BigDecimal.valueOf(cran)).add(BigDecimal.valueOf(min))
                                .doubleValue())).collect(Collectors.toList()), null);
    }

    /** Un mot parmi ceux-ci ; le premier est la valeur par défaut. */
    public static Parametre mot(String cle, String... mots) {
        return new Parametre(cle, mots[0], Arrays.asList(mots), null);
    }

    /** Une couleur, trois composantes de 0 à 1. @param defaut comme dans un fichier de scène */
    public static Parametre couleur(String cle, String defaut) {
        return new Parametre(cle, defaut, Collections.emptyList(), null);
    }

    /** Paramètre identique, incompatible avec cette autre clé. */
    public Parametre sans(String autreCle) {
        return new Parametre(cle, defaut, valeurs, autreCle);
    }

    public boolean estUneCouleur() {
        return valeurs.isEmpty();
    }

    public boolean estUnNombre() {
        return !estUneCouleur() && !Double.isNaN(Nombre.lire(valeurs.get(0)));
    }

    /** Le rang, parmi {@link #valeurs}, du nombre le plus proche de celui-ci. */
    public int getRang(String nombre) {
        return IntStream.range(0, valeurs.size()).boxed().min(Comparator.comparingDouble(
                k -> Math.abs(Nombre.lire(valeurs.get(k)) - Nombre.lire(nombre)))).get();
    }
}
