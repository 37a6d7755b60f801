package lancer.commande;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/**
 * Ce qu'un texte vaut pour une option, et l'écriture d'une valeur, qu'elle relit. Ce sont des classes sans nom : les
 * lambdas de la table retarderaient de trente millisecondes la première image.
 *
 * @param <T> ce qui est lu
 */
abstract class Lecture<T> {

    /** La valeur que dit ce texte ; {@code null} s'il n'en dit pas. */
    abstract T lire(String texte);

    String ecrire(T valeur) {
        return valeur.toString();
    }

    /** Une option sans valeur : sa présence la dit vraie. */
    static Lecture<Boolean> presence() {
        return new Lecture<Boolean>() {
            @Override
            Boolean lire(String texte) {
                return texte.isEmpty() ? true : null;
            }

            @Override
            String ecrire(Boolean presente) {
                return "";
            }
        };
    }

    /** Un nom de fichier, celui qui est donné et non celui où mène un lien. @param fins comment il peut finir */
    static Lecture<String> fichier(String... fins) {
        return new Lecture<String>() {
            @Override
            String lire(String texte) {
                String fin = Texte.minuscules(texte.substring(Math.max(0, texte.lastIndexOf('.'))));
                return Arrays.asList(fins).contains(fin) ? texte : null;
            }
        };
    }

    /** Une de ces valeurs, par son texte. */
    static <V> Lecture<V> parmi(List<V> valeurs) {
        return new Lecture<V>() {
            @Override
            V lire(String texte) {
                for (V valeur : valeurs) {
                    if (valeur.toString().equals(texte)) {
                        return valeur;
                    }
                }
                return null;
            }
        };
    }

    /** Des noms séparés par une virgule, quelle que soit leur casse. */
    static Lecture<Set<String>> noms() {
        return new Lecture<Set<String>>() {
            @Override
            Set<String> lire(String texte) {
                Set<String> noms = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
                Collections.addAll(noms, texte.split(",", -1));
                return noms.contains("") ? null : Collections.unmodifiableSet(noms);
            }

            @Override
            String ecrire(Set<String> noms) {
                return noms.stream().map(Texte::minuscules).collect(Collectors.joining(","));
            }
        };
    }

    static Lecture<Integer> entier(int min, int max) {
        return new Lecture<Integer>() {
            @Override
            Integer lire(String texte) {
                double n = Nombre.lireEntier(texte);
                return n >= min && n <= max ? (int) n : null;
            }
        };
    }

    /** @param debut ce qui précède le nombre */
    static Lecture<Double> nombre(String debut, double min, double max) {
        return new Lecture<Double>() {
            @Override
            Double lire(String texte) {
                double n = texte.startsWith(debut) ? Nombre.lire(texte.substring(debut.length())) : Double.NaN;
                return n >= min && n <= max ? n : null;
            }

            @Override
            String ecrire(Double n) {
                return debut + Nombre.ecrire(n);
            }
        };
    }

    /** Une part, de 0 à 1 ou de 0% à 100%. */
    static Lecture<Double> part() {
        return new Lecture<Double>() {
            @Override
            Double lire(String texte) {
                boolean pourCent = texte.endsWith("%");
                double max = pourCent ? 100 : 1;
                double n = Nombre.lire(texte.replaceFirst("%$", ""));
                if (!(n >= 0 && n <= max)) {
                    return null;
                }
                // une division arrondirait : 0.7 % doit donner exactement 0.007
                return pourCent ? BigDecimal.valueOf(n).movePointLeft(2).doubleValue() : n;
            }

            @Override
            String ecrire(Double n) {
                return Nombre.ecrire(n);
            }
        };
    }

    /** Deux entiers de {@code min} à {@code max}, dont le produit est limité. */
    static Lecture<Couple> couple(String separateur, int min, int max, int produitMax) {
        return new Lecture<Couple>() {
            @Override
            Couple lire(String texte) {
                String[] nombres = texte.split(separateur, 2);
                double x = Nombre.lireEntier(nombres[0]);
                double y = Nombre.lireEntier(nombres[nombres.length - 1]);
                boolean estPermis = nombres.length == 2 && Math.min(x, y) >= min && Math.max(x, y) <= max;
                return estPermis && x * y <= produitMax ? new Couple((int) x, (int) y) : null;
            }

            @Override
            String ecrire(Couple couple) {
                return couple.x + separateur + couple.y;
            }
        };
    }
}
