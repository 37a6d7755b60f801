package lancer.contrat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.texte.Nombre;

/** Une clé de variante que la fenêtre règle dans un intervalle utile. Un fichier accepte d'autres valeurs. Immuable. */
public final class Parametre {

    /** La clé, sa valeur par défaut comme dans un fichier, et la clé incompatible avec elle, ou {@code null}. */
    public final String cle;
    public final String defaut;
    public final String autre;

    /** Les mots à choisir, vide pour un nombre ou une couleur ; le nombre de pas de l'intervalle d'un nombre. */
    public final List<String> mots;
    public final int crans;
    private final BigDecimal min;
    private final BigDecimal pas;

    private Parametre(String cle, String defaut, BigDecimal min, BigDecimal pas, int crans, List<String> mots,
            String autre) {
        this.cle = cle;
        this.defaut = defaut;
        this.min = min;
        this.pas = pas;
        this.crans = crans;
        this.mots = mots;
        this.autre = autre;
    }

    /** Un nombre de {@code min} à {@code max} par {@code pas} ; {@code defaut} peut être {@code null}. */
    public static Parametre nombre(String cle, Double defaut, double min, double max, double pas) {
        return new Parametre(cle, defaut == null ? null : Nombre.ecrire(defaut), BigDecimal.valueOf(min),
                BigDecimal.valueOf(pas), (int) Math.round((max - min) / pas), Collections.emptyList(), null);
    }

    /** Un mot parmi ceux-ci ; le premier est la valeur par défaut. */
    public static Parametre mot(String cle, String... mots) {
        return new Parametre(cle, mots[0], null, null, 0, Arrays.asList(mots), null);
    }

    /** Une couleur, trois composantes de 0 à 1. @param defaut comme dans un fichier de scène */
    public static Parametre couleur(String cle, String defaut) {
        return new Parametre(cle, defaut, null, null, 0, Collections.emptyList(), null);
    }

    /** Paramètre identique, incompatible avec cette autre clé. */
    public Parametre sans(String autreCle) {
        return new Parametre(cle, defaut, min, pas, crans, mots, autreCle);
    }

    public boolean estUneCouleur() {
        return min == null && mots.isEmpty();
    }

    /** La valeur du cran, de 0 à {@link #crans}, comme dans un fichier de scène. */
    public String getValeur(int cran) {
        return Nombre.ecrire(min.add(pas.multiply(BigDecimal.valueOf(cran))).doubleValue());
    }

    /** Le cran le plus proche de cette valeur. */
    public int getCran(String valeur) {
        double cran = (Nombre.lire(valeur) - min.doubleValue()) / pas.doubleValue();
        return (int) Math.round(Math.max(0, Math.min(crans, cran)));
    }
}
