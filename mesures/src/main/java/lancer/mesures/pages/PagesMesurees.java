package lancer.mesures.pages;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Les nombres d'une page Markdown qui viennent des mesures. Chacun est écrit entre deux commentaires, que GitHub ne montre pas :
 * {@code <!--v:nom-->2,1<!--/v-->}.
 */
public final class PagesMesurees {

    private static final Pattern VALEUR = Pattern.compile("<!--v:([^>]*?)-->.*?<!--/v-->", Pattern.DOTALL);

    /** Espaces à rendre insécables dans un nombre et autour de sa ponctuation. */
    private static final Pattern ESPACE_INSECABLE = Pattern.compile(" (?=[;:%»])|(?<=[×«±+−]) ");

    private PagesMesurees() {
    }

    /** Réécrit les nombres de cette page, s'ils changent. */
    public static void reecrire(Path page, Map<String, String> valeurs) throws IOException {
        String avant = new String(Files.readAllBytes(page), StandardCharsets.UTF_8);
        String apres = remplacer(avant, valeurs);
        if (!apres.equals(avant)) {
            Files.write(page, apres.getBytes(StandardCharsets.UTF_8));
        }
    }

    /** @throws IllegalArgumentException si la page demande un nombre qui n'a pas été mesuré */
    public static String remplacer(String texte, Map<String, String> valeurs) {
        Matcher m = VALEUR.matcher(texte);
        StringBuffer s = new StringBuffer();
        while (m.find()) {
            String valeur = valeurs.get(m.group(1));
            if (valeur == null) {
                throw new IllegalArgumentException("aucune mesure ne donne « " + m.group(1) + " »");
            }
            m.appendReplacement(s, Matcher.quoteReplacement("<!--v:" + m.group(1) + "-->"
                    + ESPACE_INSECABLE.matcher(valeur).replaceAll("\u00a0") + "<!--/v-->"));
        }
        return m.appendTail(s).toString();
    }
}
