package lancer.correction.depot;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.correction.modele.Modele;

/**
 * Un fichier source : son texte, quel que soit son codage, dans le paquet {@code lancer}, même si l'étudiant l'a changé
 * ou oublié.
 */
public final class Source {

    private static final Pattern PAQUET = Pattern.compile("(?m)^[ \\t]*+package\\s++([\\w.]++)\\s*+;");
    /** Motif de ce dont on peut faire un nom de fichier : rien qui sorte de son dossier, et rien de trop long. */
    private static final Pattern NOM_DE_PAQUET = Pattern.compile("(?!.{201})(?:\\w++(?:\\.\\w++)*+)?");
    private static final Pattern NOM_DE_CLASSE = Pattern.compile("[\\p{L}_$][\\p{L}\\p{N}_$]{0,99}+");
    private static final int CLASSES_MAX = 200;
    private static final Pattern DECLARATION = Pattern.compile("\\b(?:class|interface|enum|record)\\s+(\\w+)");
    /** Une méthode telle que le squelette les écrit : la marge de son accolade fermante est celle des membres. */
    private static final Pattern METHODE =
            Pattern.compile("(?ms)^    \\w[^;{}=]*?(\\w+)\\([^()]*\\) \\{\n(.*?)^    \\}");
    private static final Pattern RESERVES = Pattern.compile("(javax?|jdk|sun|com\\.sun|lancer\\.correction|"
            + "org\\.(junit|opentest4j|apiguardian|ini4j|eclipse))(\\..*)?");
    /** Un commentaire, un texte, un caractère. Possessif : sans quoi un long texte épuise la pile. */
    private static final Pattern HORS_CODE = Pattern.compile("/\\*.*?(?:\\*/|\\z)|//[^\n]*"
            + "|\"(?:\\\\.|[^\"\\\\\n])*+\"|'(?:\\\\.|[^'\\\\\n])*+'", Pattern.DOTALL);

    /** Les mots du corrigé : les autres sont ceux que chacun choisit. */
    private static final Set<String> DU_COURS = Modele.classes().stream().flatMap(c -> Pattern.compile("\\W+")
            .splitAsStream(Modele.corrige(c))).collect(Collectors.toSet());
    private static final int METHODES_MAX = 3000;

    final String chemin;
    final String classe;
    /** Le dossier où commencent les paquets. */
    final String racine;
    final String paquet;
    final String texte;
    /** Remarque sur ce qu'il a fallu arranger, {@code null} si rien. */
    final String remarque;

    private Source(String chemin, String classe, String racine, String paquet, String texte, String remarque) {
        this.chemin = chemin;
        this.classe = classe;
        this.racine = racine;
        this.paquet = paquet;
        this.texte = texte;
        this.remarque = remarque;
    }

    /** Une source pour chaque classe de ce fichier, à leurs lignes, si plusieurs, dont une du cours, s'y partagent la place. */
    static List<Source> lire(String chemin, byte[] octets) {
        Source tout = entier(chemin, octets);
        String dehors = dehors(tout.texte);
        List<String> noms = DECLARATION.matcher(dehors).results().limit(CLASSES_MAX + 1).map(d -> d.group(1))
                .collect(Collectors.toList());
        if (noms.size() < 2 || noms.size() > CLASSES_MAX || noms.stream().noneMatch(Modele.classes()::contains)) {
            return List.of(tout);
        }
        boolean autres = noms.stream().anyMatch(n -> Modele.classes().contains(n) && !n.equals(tout.classe));
        String remarque = tout.remarque == null && autres ? "contient plusieurs classes (" + String.join(", ", noms)
                + ") : jugées à part" : tout.remarque;
        List<Source> sources = new ArrayList<>();
        Matcher premiere = DECLARATION.matcher(dehors);
        int entete = premiere.find() ? dehors.lastIndexOf(';', premiere.start()) + 1 : 0;
        int debut = entete;
        for (String nom : noms) {
            int fin = dehors.indexOf('}', debut) + 1;
            Matcher declaration = DECLARATION.matcher(dehors.substring(debut, Math.max(debut, fin)));
            if (!declaration.find() || !declaration.group(1).equals(nom)) {
                return List.of(tout);
            }
            sources.add(new Source(chemin, nom, tout.racine, tout.paquet, tout.texte.substring(0, entete)
                    + blancs(tout.texte.substring(entete, debut)) + tout.texte.substring(debut, fin),
                    debut == entete ? remarque : null));
            debut = fin;
        }
        return dehors.substring(debut).isBlank() ? sources : List.of(tout);
    }

    private static Source entier(String chemin, byte[] octets) {
        String nom = chemin.substring(chemin.lastIndexOf('/') + 1);
        String nu = nom.substring(0, nom.length() - ".java".length());
        String dossier = chemin.substring(0, chemin.length() - nom.length());
        String texte = decoder(octets);
        String remarque = codage(octets) == StandardCharsets.UTF_8 ? null : "n'est pas en UTF-8, lu en " + codage(octets).name();
        Matcher seule = DECLARATION.matcher(dehors(texte));
        // « Vecteur (1).java », « Copie de Vecteur.java » : ce qu'il déclare dit mieux ce qu'il est
        String classe = !NOM_DE_CLASSE.matcher(nu).matches() && seule.find() ? seule.group(1) : nu;
        Matcher m = PAQUET.matcher(sansCommentaires(texte));
        String paquet = m.find() ? m.group(1) : "";
        boolean duCours = Modele.classes().contains(classe) || classe.equals("Tests")
                || DECLARATION.matcher(dehors(texte)).results().anyMatch(d -> Modele.classes().contains(d.group(1)));
        String suffixe = paquet.isEmpty() ? "lancer/" : paquet.replace('.', '/') + "/";
        String racine = dossier.endsWith(suffixe) ? dossier.substring(0, dossier.length() - suffixe.length()) : dossier;
        if (duCours && !paquet.equals("lancer")) {
            if (paquet.isEmpty()) {
                // sur la première ligne : les numéros des autres restent ceux de l'étudiant
                texte = "package lancer; " + texte;
                remarque = "la ligne « package lancer; » manque";
            } else {
                texte = texte.replaceFirst("package\\s+" + Pattern.quote(paquet) + "\\s*;", "package lancer;")
                        .replace("import " + paquet + ".", "import lancer.")
                        .replace("import static " + paquet + ".", "import static lancer.");
                remarque = "le paquet est « " + paquet + " » au lieu de « lancer »";
            }
            paquet = "lancer";
        }
        return new Source(chemin, classe, racine, paquet, texte, remarque);
    }

    /** Le même texte, les commentaires remplacés par autant de blancs. */
    public static String sansCommentaires(String texte) {
        return HORS_CODE.matcher(texte).replaceAll(m -> m.group().startsWith("/") ? blancs(m.group())
                : Matcher.quoteReplacement(m.group()));
    }

    private static String blancs(String texte) {
        return texte.replaceAll("[^\n]", " ");
    }

    /** Le même texte, où il n'y a plus que ce qui n'est dans aucune classe, et les accolades de celles-ci. */
    private static String dehors(String texte) {
        char[] lettres = HORS_CODE.matcher(texte).replaceAll(m -> blancs(m.group())).toCharArray();
        int niveau = 0;
        for (int k = 0; k < lettres.length; k++) {
            int avant = niveau;
            niveau = Math.max(0, niveau + (lettres[k] == '{' ? 1 : lettres[k] == '}' ? -1 : 0));
            if (avant > 0 && niveau > 0) {
                lettres[k] = ' ';
            }
        }
        return new String(lettres);
    }

    /** Raison pour laquelle ce fichier est à laisser de côté : ce qu'il déclare cacherait ce qui ne lui appartient pas. */
    String intrusion() {
        if (!NOM_DE_PAQUET.matcher(paquet).matches() || !NOM_DE_CLASSE.matcher(classe).matches()) {
            return "« " + paquet + " », « " + classe + " » : ce ne sont pas des noms de paquet et de classe";
        }
        if (RESERVES.matcher(paquet).matches()) {
            return "le paquet « " + paquet + " » n'est pas à vous";
        }
        Matcher m = DECLARATION.matcher(dehors(texte));
        for (int n = 0; m.find(); n++) {
            if (n == CLASSES_MAX) {
                return "il déclare plus de " + CLASSES_MAX + " classes";
            }
            if (!paquet.equals("lancer")) {
                continue;
            }
            if (List.of("Appels", "Sonde").contains(m.group(1))) {
                return "il déclare une classe " + m.group(1) + " qui cacherait celle de la correction";
            }
            try {
                Class.forName("java.lang." + m.group(1), false, null);
                return "il déclare une classe " + m.group(1) + " qui cacherait celle de Java";
            } catch (ClassNotFoundException | LinkageError e) {
                // ce nom-là est libre
            }
        }
        return null;
    }

    /** Vrai si deux textes ne diffèrent que par leurs commentaires et leurs blancs. */
    public static boolean memeCode(String a, String b) {
        return serre(a).equals(serre(b));
    }

    private static String serre(String texte) {
        return sansCommentaires(texte).replaceAll("\\s+", "");
    }

    /** Empreinte de ce qu'un texte a à lui : ni commentaires, ni blancs, ni les noms que le cours n'emploie pas. */
    public static String empreinte(String texte) {
        String masque = Pattern.compile("\\b[A-Za-z_]\\w*\\b").matcher(sansCommentaires(texte)).replaceAll(m ->
                DU_COURS.contains(m.group()) ? m.group() : "_");
        return Integer.toHexString(serre(masque).hashCode()) + "-" + masque.length();
    }

    /** Les déclarations de cette méthode, ou de ce constructeur, telles qu'elles sont écrites. */
    public static String methode(String texte, String nom) {
        String nu = HORS_CODE.matcher(texte).replaceAll(m -> blancs(m.group()));
        Matcher m = Pattern.compile("(?m)^[ \\t]*\\w[^;{}=()\n]*\\b" + nom + "[ \\t]*\\([^()]*\\)[^;{}()]*\\{").matcher(nu);
        StringBuilder trouvees = new StringBuilder();
        while (m.find() && trouvees.length() < METHODES_MAX) {
            int fin = m.end();
            for (int niveau = 1; niveau > 0 && fin < nu.length(); fin++) {
                niveau += nu.charAt(fin) == '{' ? 1 : nu.charAt(fin) == '}' ? -1 : 0;
            }
            trouvees.append(texte, m.start(), Math.min(fin, m.start() + METHODES_MAX)).append('\n');
        }
        return trouvees.toString();
    }

    /** Les noms des méthodes du squelette qui ont un {@code FIXME} ; faux pour celles que ce texte n'a pas changées. */
    public static Map<String, Boolean> commencees(String texte, String squelette) {
        Map<String, Boolean> noms = new TreeMap<>();
        Matcher methode = METHODE.matcher(squelette);
        while (methode.find()) {
            if (methode.group(2).contains("// FIXME")) {
                noms.merge(methode.group(1), !serre(texte).contains(serre(methode.group())), Boolean::logicalAnd);
            }
        }
        return noms;
    }

    /** Le texte, quel qu'en soit le codage, sans marque d'ordre des octets, et ses lignes finies par {@code \n}. */
    public static String decoder(byte[] octets) {
        return new String(octets, codage(octets)).replace("\uFEFF", "").replace("\r\n", "\n").replace('\r', '\n');
    }

    private static Charset codage(byte[] octets) {
        if (octets.length >= 2 && (octets[0] == (byte) 0xFE && octets[1] == (byte) 0xFF || octets[0] == (byte) 0xFF
                && octets[1] == (byte) 0xFE)) {
            return StandardCharsets.UTF_16;
        }
        try {
            StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(octets));
            return StandardCharsets.UTF_8;
        } catch (CharacterCodingException e) {
            return Charset.isSupported("windows-1252") ? Charset.forName("windows-1252") : StandardCharsets.ISO_8859_1;
        }
    }
}
