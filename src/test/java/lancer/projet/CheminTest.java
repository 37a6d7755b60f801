package lancer.projet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.Main;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les appels qui mènent de {@code main} à un pixel, lus dans les piles des fils pendant un dessin. */
class CheminTest {

    private static final String RAYON = "lancer.Lancer.getCouleurPixel";
    private static final int AU_PLUS = 14;

    /**
     * Les méthodes du programme qu'exécute ce fil, de la première appelée à la dernière, ou jusqu'à celle-ci. Le corps d'une lambda en
     * est une, et non la classe que Java en fait.
     */
    private static List<String> appels(StackTraceElement[] pile, String derniere) {
        List<String> appels = new ArrayList<>();
        for (StackTraceElement pas : pile) {
            String appel = pas.getClassName() + "." + pas.getMethodName();
            if (appel.equals(derniere)) {
                appels.clear();
            }
            if (appel.startsWith("lancer.") && !appel.matches(CheminTest.class.getName() + ".*|.*\\$\\$Lambda.*")) {
                appels.add(appel);
            }
        }
        Collections.reverse(appels);
        return appels;
    }

    private static boolean estAuPixel(StackTraceElement[] pile) {
        return Arrays.stream(pile).anyMatch(pas -> (pas.getClassName() + "." + pas.getMethodName()).equals(RAYON));
    }

    /** Les appels du fil principal jusqu'à ce qu'il confie l'image, puis ceux d'un fil qui la dessine. */
    private static List<String> duMainAuPixel(String... arguments) throws InterruptedException {
        Thread principal = new Thread(() -> Main.main(arguments));
        principal.start();
        List<String> chemin = List.of();
        while (principal.isAlive() && chemin.isEmpty()) {
            Map<Thread, StackTraceElement[]> piles = Thread.getAllStackTraces();
            Thread dessine = piles.keySet().stream().filter(fil -> estAuPixel(piles.get(fil))).findFirst().orElse(null);
            if (dessine != null) {
                chemin = appels(piles.getOrDefault(principal, new StackTraceElement[0]), "");
                chemin.addAll(appels(piles.get(dessine), RAYON));
            }
        }
        principal.join();
        return chemin;
    }

    @Test
    void deMainAuPixelIlYAUneDouzaineDAppelsEtLaPageLesNomme(@TempDir Path dossier) throws IOException, InterruptedException {
        List<String> chemin = duMainAuPixel("--image", dossier.resolve("i.png").toString(), "--taille", "400x400", "scenes/scene1.ini");
        assertEquals("lancer.Main.main", chemin.get(0), chemin.toString());
        assertEquals(RAYON, chemin.get(chemin.size() - 1), chemin.toString());
        assertTrue(chemin.size() <= AU_PLUS, chemin.size() + " appels : " + chemin);

        String page = Files.readString(Path.of("docs/etendre.md"));
        Matcher nomme = Pattern.compile("`(\\w+\\.\\w+)`").matcher(page.substring(0, page.indexOf("`Lancer.getCouleurPixel`") + 24));
        List<String> nommes = new ArrayList<>();
        while (nomme.find()) {
            nommes.add(nomme.group(1));
        }
        // une lambda est dite par la méthode où elle est écrite, une vue par son interface
        assertEquals(chemin.stream().map(appel -> appel.replaceFirst("Lancer\\$\\d+", "Vue")
                .replaceFirst(".*\\.(\\w+\\.)(lambda\\$)?(\\w+).*", "$1$3")).collect(Collectors.toList()), nommes);
    }
}
