package lancer.scene;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.StringTokenizer;
import lancer.SceneFautive;
import lancer.contrat.Section;
import lancer.texte.Nombre;
import lancer.texte.Ressemblance;
import lancer.texte.Texte;

/**
 * Une section lue ligne après ligne. Une clé inconnue d'un objet ou d'une lampe est refusée dès sa lecture. Une clé de
 * variante que rien n'a demandée est refusée à la fin ({@link #verifierCles}).
 */
public final class SectionLue extends Section {

    /** Nombre maximal de clés, qu'aucune section utile n'atteint. Au-delà, chercher les doublons serait long. */
    private static final int CLES_MAX = 64;

    private final String fichier;
    /** Les clés permises ou, pour une variante, les clés déjà demandées. */
    final List<String> connues;
    private final boolean ouverte;
    private final List<Entree> entrees = new ArrayList<>(5);

    private static final class Entree {
        final String cle;
        final String valeur;
        final int ligne;

        Entree(String cle, String valeur, int ligne) {
            this.cle = cle;
            this.valeur = valeur;
            this.ligne = ligne;
        }
    }

    /** @param connues les seules clés permises ; {@code null} : celles qui seront demandées */
    SectionLue(String fichier, String nom, int ligne, List<String> connues) {
        super(nom, ligne);
        this.fichier = fichier;
        ouverte = connues == null;
        this.connues = ouverte ? new ArrayList<>() : connues;
    }

    /** Une section de ce type, qui n'est dans aucun fichier : une clé, sa valeur, une autre clé, sa valeur… */
    public SectionLue(String type, String... clesEtValeurs) {
        this("réglage", type, 0, null);
        for (int k = 0; k + 1 < clesEtValeurs.length; k += 2) {
            ajouter(clesEtValeurs[k], clesEtValeurs[k + 1], 0);
        }
    }

    /** Les clés que son type lit, dans leur ordre ; de Ks et de son synonyme Kr, celle qui y est écrite, ou Ks. */
    public List<String> getCles() {
        List<String> cles = new ArrayList<>(connues);
        cles.remove(entree("Kr") == null ? "Kr" : "Ks");
        return cles;
    }

    /** Les valeurs données, par clé, comme dans le fichier. */
    public Map<String, String> getValeurs() {
        Map<String, String> valeurs = new LinkedHashMap<>();
        entrees.forEach(entree -> valeurs.put(entree.cle, entree.valeur));
        return valeurs;
    }

    /** Cette section, à la même place du fichier, où cette clé a cette valeur. */
    SectionLue changee(String cle, String valeur) {
        SectionLue autre = new SectionLue(fichier, nom, ligne, connues);
        boolean donnee = entree(cle) != null;
        entrees.forEach(entree -> autre.ajouter(entree.cle, pareilles(entree.cle, cle) ? valeur : entree.valeur,
                entree.ligne));
        if (!donnee) {
            autre.ajouter(cle, valeur, ligne);
        }
        return autre;
    }

    @Override
    public Section sansFichier(String... clesEtValeurs) {
        return new SectionLue(nom, clesEtValeurs);
    }

    void ajouter(String cle, String valeur, int ligneCle) {
        Entree deja = entree(cle);
        if (deja != null) {
            throw fautive(ligneCle, cle, "clé donnée deux fois, déjà ligne " + deja.ligne, "une seule fois chaque clé");
        }
        if (!ouverte && !estConnue(cle)) {
            throw inconnue(ligneCle, cle);
        }
        if (entrees.size() == CLES_MAX) {
            throw fautive(ligneCle, cle, "trop de clés", "au plus " + CLES_MAX + " clés dans une section");
        }
        entrees.add(new Entree(cle, valeur, ligneCle));
    }

    private SceneFautive inconnue(int ligneCle, String cle) {
        return fautive(ligneCle, cle, "clé inconnue" + Ressemblance.dire(cle),
                connues.isEmpty() ? "aucune clé" : String.join(", ", connues));
    }

    private Entree entree(String cle) {
        for (Entree entree : entrees) {
            if (pareilles(entree.cle, cle)) {
                return entree;
            }
        }
        return null;
    }

    private boolean estConnue(String cle) {
        for (String connue : connues) {
            if (pareilles(connue, cle)) {
                return true;
            }
        }
        return false;
    }

    /** Dit si ces clés sont égales, à la casse près. Le signe kelvin, de trois octets, n'est pas un K. */
    static boolean pareilles(String cle, String autre) {
        return cle.equals(autre) || cle.equalsIgnoreCase(autre) && cle.getBytes(StandardCharsets.UTF_8).length
                == autre.getBytes(StandardCharsets.UTF_8).length;
    }

    private Entree demander(String cle) {
        if (!estConnue(cle)) {
            if (!ouverte) {
                throw new IllegalStateException("getCles ne nomme pas la clé " + cle);
            }
            connues.add(cle);
        }
        return entree(cle);
    }

    @Override
    public String mot(String cle, String defaut) {
        Entree entree = demander(cle);
        return entree == null ? defaut : entree.valeur;
    }

    @Override
    protected double[] nombres(String cle, int combien, double min, double max) {
        Entree entree = demander(cle);
        if (entree == null) {
            throw fautive(ligne, cle, "clé absente", attendu(combien, min, max));
        }
        StringTokenizer mots = new StringTokenizer(entree.valeur, " \t");
        double[] nombres = new double[mots.countTokens()];
        for (int k = 0; k < nombres.length; k++) {
            String mot = mots.nextToken();
            nombres[k] = Nombre.lire(mot);
            if (!(nombres[k] >= min && nombres[k] <= max)) {
                throw impossible(entree, mot, nombres[k], attendu(combien, min, max));
            }
        }
        if (nombres.length != combien) {
            throw fautive(entree.ligne, entree.cle, nombres.length + (nombres.length > 1 ? " nombres" : " nombre")
                    + " au lieu de " + combien + " : " + Texte.cite(entree.valeur), attendu(combien, min, max));
        }
        return nombres;
    }

    /** Refuse un mot. Les fautes les plus courantes ont leur propre message. */
    private SceneFautive impossible(Entree entree, String mot, double valeur, String attendu) {
        String faute = "n'est pas un nombre";
        if (mot.startsWith(";") || mot.startsWith("#")) {
            faute = "commentaire après une valeur, et non seul sur sa ligne";
        } else if (mot.indexOf(',') >= 0) {
            faute = "une virgule, au lieu d'un point ou d'un blanc";
        } else if (!Double.isNaN(valeur)) {
            faute = Double.isInfinite(valeur) ? "nombre trop grand" : "hors limites";
        }
        return fautive(entree.ligne, entree.cle, faute + " : " + Texte.cite(mot) + Ressemblance.dire(mot), attendu);
    }

    private static String attendu(int combien, double min, double max) {
        String nombres = combien == 1 ? "un nombre" : combien + " nombres séparés par des blancs, chacun";
        boolean borne = max < Double.MAX_VALUE;
        if (min == Double.MIN_VALUE) {
            return nombres + " plus grand que 0" + (borne ? ", au plus " + Nombre.ecrire(max) : "");
        }
        return nombres + (borne ? " de " + Nombre.ecrire(min) + " à " + Nombre.ecrire(max)
                : " d'au moins " + Nombre.ecrire(min));
    }

    @Override
    public void verifierCles() {
        for (Entree entree : entrees) {
            if (!estConnue(entree.cle)) {
                throw inconnue(entree.ligne, entree.cle);
            }
        }
    }

    @Override
    public SceneFautive fautive(String cle, String faute, String attendu) {
        return fautive(getLigne(cle), cle, faute, attendu);
    }

    /** La ligne de cette clé ou, si elle n'est pas donnée, celle de la section. */
    int getLigne(String cle) {
        Entree entree = entree(cle);
        return entree == null ? ligne : entree.ligne;
    }

    @Override
    public String ecrire(String separateur) {
        StringBuilder texte = new StringBuilder("[" + nom + "]");
        for (Entree entree : entrees) {
            texte.append(separateur).append(entree.cle).append('=').append(entree.valeur);
        }
        return texte.toString();
    }

    @Override
    public SectionLue avec(String cle, String valeur, String sans) {
        SectionLue autre = new SectionLue(nom);
        for (Entree entree : entrees) {
            if (pareilles(entree.cle, cle)) {
                autre.ajouter(entree.cle, valeur, 0);
            } else if (sans == null || !pareilles(entree.cle, sans)) {
                autre.ajouter(entree.cle, entree.valeur, 0);
            }
        }
        if (autre.entree(cle) == null) {
            autre.ajouter(cle, valeur, 0);
        }
        return autre;
    }

    SceneFautive fautive(int ligneFaute, String cle, String faute, String attendu) {
        return new SceneFautive(message(fichier, ligneFaute, nom, cle, faute, attendu));
    }

    /** Message d'une faute d'un fichier de scène. Sont inconnus {@code ligne} 0, {@code nom} et {@code cle} null. */
    static String message(String fichier, int ligne, String nom, String cle, String faute, String attendu) {
        StringBuilder message = new StringBuilder(Texte.echappe(fichier));
        if (ligne > 0) {
            message.append(", ligne ").append(ligne);
        }
        if (nom != null) {
            message.append(", [").append(Texte.abrege(nom)).append(']');
        }
        if (cle != null) {
            message.append(", ").append(Texte.abrege(cle));
        }
        return message.append(" : ").append(faute).append(" ; attendu : ").append(attendu).toString();
    }
}
