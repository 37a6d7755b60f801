package lancer.scene;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.StringTokenizer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.CRC32;
import lancer.SceneFautive;
import lancer.texte.Texte;

/**
 * Les octets d'un fichier de scène. Une valeur s'y change, une clé s'y ajoute ou s'en ôte, et aucun autre octet ne
 * change. Immuable.
 */
public final class TexteScene {

    private static final Pattern LIGNE = Pattern.compile("[^\r\n]*(?:\r\n|\r|\n|\\z)");
    /** Une clé et son signe, sa valeur, puis les blancs et la fin de la ligne. */
    private static final Pattern CLE = Pattern.compile(
            "([ \t]*([^\r\n=:]*?)[ \t]*[=:][ \t]*)([^\r\n]*?)([ \t]*[\r\n]*)");

    private final byte[] octets;

    /** @param octets ne changeront plus */
    public TexteScene(byte[] octets) {
        this.octets = octets;
    }

    /** Les lignes, fins comprises. Un octet, un caractère : ceux que rien ne change restent les mêmes. */
    private List<String> getLignes() {
        List<String> lignes = new ArrayList<>();
        Matcher ligne = LIGNE.matcher(new String(octets, StandardCharsets.ISO_8859_1));
        while (ligne.find() && ligne.end() > ligne.start()) {
            lignes.add(ligne.group());
        }
        return lignes;
    }

    /** Les octets, à ne pas changer. */
    public byte[] getOctets() {
        return octets;
    }

    /** Ce que deux fichiers de mêmes octets ont en commun. */
    public String getVersion() {
        return version(octets);
    }

    static String version(byte[] octets) {
        CRC32 somme = new CRC32();
        somme.update(octets);
        return octets.length + " " + somme.getValue();
    }

    /** Le nom d'une section : son type, quelle que soit sa casse, puis ses mots, chacun après un blanc. */
    static String normaliser(String nom) {
        StringTokenizer mots = new StringTokenizer(nom, " \t");
        String normal = mots.hasMoreTokens() ? Texte.minuscules(mots.nextToken()) : "";
        while (mots.hasMoreTokens()) {
            normal += " " + mots.nextToken();
        }
        return normal;
    }

    /** Le nom de la section qu'ouvre cette ligne ; {@code null} si elle n'en ouvre pas. */
    private static String nomOuvert(String ligne) {
        if (ligne.indexOf('[') < 0) {
            return null;
        }
        String mots = utf8(ligne).replaceFirst("^\uFEFF", "").trim();
        return mots.startsWith("[") && mots.endsWith("]") ? normaliser(mots.substring(1, mots.length() - 1)) : null;
    }

    /** Le rang de la ligne qui ouvre cette section. @throws SceneFautive si elle n'est pas là une fois */
    private static int trouver(List<String> lignes, String nom, String fichier) {
        int trouve = -1;
        int fois = 0;
        for (int k = 0; k < lignes.size(); k++) {
            if (normaliser(nom).equals(nomOuvert(lignes.get(k)))) {
                trouve = k;
                fois++;
            }
        }
        if (fois != 1) {
            throw pasUneFois(fois, nom, fichier);
        }
        return trouve;
    }

    /** Ce qui se dit d'une section qui est là tant de fois, et non une. */
    static SceneFautive pasUneFois(int fois, String nom, String fichier) {
        return new SceneFautive(SectionLue.message(fichier, 0, nom, null, fois == 0 ? "section absente du fichier"
                : "section donnée " + fois + " fois", "une section de ce nom"));
    }

    /** Ajoute à cette section, ouverte à sa ligne, les clés qu'elle a dans ce texte. @return la même section */
    SectionLue lire(SectionLue vide) {
        List<String> lignes = getLignes();
        for (int k = vide.ligne; k < lignes.size() && nomOuvert(lignes.get(k)) == null; k++) {
            Matcher cle = cle(lignes.get(k));
            if (cle != null) {
                vide.ajouter(utf8(cle.group(2)), utf8(cle.group(3)), k + 1);
            }
        }
        return vide;
    }

    private static String utf8(String octets) {
        return new String(octets.getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
    }

    private static Matcher cle(String ligne) {
        Matcher cle = CLE.matcher(ligne);
        String mots = ligne.trim();
        return mots.startsWith(";") || mots.startsWith("#") || !cle.matches() ? null : cle;
    }

    /**
     * Le même texte, où les clés de cette section ont ces valeurs.
     *
     * @param valeurs une valeur {@code null} ôte sa clé
     * @param fichier son nom, pour le message
     * @throws SceneFautive si cette section n'est pas là une fois
     */
    TexteScene avec(String nom, Map<String, String> valeurs, String fichier) {
        List<String> lignes = getLignes();
        int rang = trouver(lignes, nom, fichier);
        valeurs.forEach((cle, valeur) -> changer(lignes, rang, cle, valeur));
        return new TexteScene(String.join("", lignes).getBytes(StandardCharsets.ISO_8859_1));
    }

    private static void changer(List<String> lignes, int section, String cle, String valeur) {
        int derniere = section;
        for (int k = section + 1; k < lignes.size() && nomOuvert(lignes.get(k)) == null; k++) {
            Matcher ecrite = cle(lignes.get(k));
            if (ecrite != null && SectionLue.pareilles(utf8(ecrite.group(2)), cle)) {
                if (valeur == null) {
                    lignes.remove(k);
                } else {
                    lignes.set(k, ecrite.group(1) + octets(valeur) + ecrite.group(4));
                }
                return;
            }
            derniere = ecrite == null ? derniere : k;
        }
        if (valeur != null) {
            String fin = lignes.get(derniere).replaceFirst("^[^\r\n]*", "");
            if (fin.isEmpty()) {
                // la dernière ligne d'un fichier n'a parfois pas de fin : elle prend celle de la première
                fin = lignes.size() > 1 ? lignes.get(0).replaceFirst("^[^\r\n]*", "") : "\n";
                lignes.set(derniere, lignes.get(derniere) + fin);
                fin = "";
            }
            lignes.add(derniere + 1, octets(cle + "=" + valeur) + fin);
        }
    }

    private static String octets(String texte) {
        return new String(texte.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
    }
}
