package lancer.correction.depot;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Une méthode du cours dont l'étudiant a changé les paramètres, leur ordre ou leur nombre : la forme attendue est ajoutée à
 * sa classe, et appelle la sienne. C'est dit une fois, et rien d'autre n'en souffre.
 */
final class Ponts {

    /** Une méthode du cours : sa classe, ce qu'elle rend, son nom, ses paramètres. */
    private static final class Forme {

        final String classe;
        final String rend;
        final String nom;
        final List<String> types;
        /** Le plus petit nombre de paramètres qui fasse encore la même chose. */
        final int moins;

        Forme(int moins, String classe, String rend, String nom, String... types) {
            this.moins = moins;
            this.classe = classe;
            this.rend = rend;
            this.nom = nom;
            this.types = List.of(types);
        }
    }

    private static final List<Forme> FORMES = List.of(
            new Forme(1, "Vecteur", "double", "dot", "Vecteur"),
            new Forme(1, "Objet3D", "double", "getIntersectionDistance", "Rayon"),
            new Forme(1, "Sphere", "double", "getIntersectionDistance", "Rayon"),
            new Forme(1, "Sphere", "Vecteur", "getNormale", "Point"),
            new Forme(2, "Objet3D", "Couleur", "getColor", "Scene", "Rayon", "PointContact", "int"),
            new Forme(2, "Scene", "PointContact", "getClosestIntersection", "Rayon", "Sphere"),
            new Forme(2, "Lancer", "Couleur", "getCouleurPixel", "double", "double", "int"),
            new Forme(2, "Camera", "Rayon", "getRayon", "double", "double"));

    private Ponts() {
    }

    /** Le texte de la classe, avec ce qu'il faut pour l'appeler ; chaque différence est dite dans {@code remarques}. */
    static String ajouter(String classe, String texte, List<String> remarques) {
        String resultat = texte;
        for (Forme forme : FORMES) {
            if (forme.classe.equals(classe)) {
                resultat = ajouter(forme, resultat, remarques);
            }
        }
        return resultat;
    }

    private static String ajouter(Forme forme, String texte, List<String> remarques) {
        Matcher m = Pattern.compile("\\b(?!return\\b|new\\b|else\\b)\\w++\\s++" + forme.nom
                + "\\s*+\\(([^()]*+)\\)\\s*+(?:throws[\\w\\s,.]++)?[{;]")
                .matcher(Source.sansCommentaires(texte));
        String pont = null;
        List<String> changes = null;
        while (m.find()) {
            List<String> types = types(m.group(1));
            if (accepte(types, forme.types)) {
                return texte;
            }
            if (pont == null && types.size() >= forme.moins) {
                pont = appel(types, forme);
                changes = types;
            }
        }
        if (pont != null) {
            remarques.add("signature : " + forme.classe + "." + forme.nom + "(" + String.join(", ", changes)
                    + ") au lieu de ("
                    + String.join(", ", forme.types) + ") ; jugée comme si elle avait celle du cours");
        }
        int fin = texte.lastIndexOf('}');
        return pont == null || fin < 0 ? texte : texte.substring(0, fin) + pont + texte.substring(fin);
    }

    private static List<String> types(String parametres) {
        List<String> types = new ArrayList<>();
        for (String parametre : parametres.split(",")) {
            String propre = parametre.replaceAll("\\bfinal\\b|@\\w+", "").trim();
            if (!propre.isEmpty()) {
                types.add(propre.replaceFirst("\\s+\\w+$", "").replaceAll("\\s", ""));
            }
        }
        return types;
    }

    /** Vrai si l'on peut appeler telle quelle la méthode de l'étudiant : un objet quelconque convient aussi. */
    private static boolean accepte(List<String> siens, List<String> attendus) {
        if (siens.size() != attendus.size()) {
            return false;
        }
        for (int k = 0; k < siens.size(); k++) {
            if (!siens.get(k).equals(attendus.get(k)) && !siens.get(k).equals("Objet3D")) {
                return false;
            }
        }
        return true;
    }

    private static boolean compatible(String sien, String attendu) {
        return sien.equals(attendu) || sien.equals("Objet3D") && attendu.equals("Sphere") || sien.equals("Sphere")
                && attendu.equals("Objet3D")
                || (sien.equals("int") || sien.equals("float")) && attendu.equals("double");
    }

    /**
     * La méthode attendue, qui appelle celle de l'étudiant avec les arguments qu'elle veut ; {@code null} s'il lui en
     * faut d'autres.
     */
    private static String appel(List<String> siens, Forme forme) {
        List<String> arguments = new ArrayList<>();
        boolean[] pris = new boolean[forme.types.size()];
        for (String sien : siens) {
            int k = 0;
            while (k < pris.length && (pris[k] || !compatible(sien, forme.types.get(k)))) {
                k++;
            }
            if (k == pris.length) {
                return null;
            }
            pris[k] = true;
            arguments.add((sien.equals(forme.types.get(k)) ? "" : "(" + sien + ") ") + "p" + k);
        }
        StringBuilder parametres = new StringBuilder();
        for (int k = 0; k < forme.types.size(); k++) {
            parametres.append(k > 0 ? ", " : "").append(forme.types.get(k)).append(" p").append(k);
        }
        return " public " + forme.rend + " " + forme.nom + "(" + parametres + ") { return " + forme.nom + "("
                + String.join(", ", arguments) + "); } ";
    }
}
