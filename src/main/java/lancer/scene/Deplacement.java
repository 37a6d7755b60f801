package lancer.scene;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.SceneFautive;
import lancer.scene.Origines.Origine;
import lancer.texte.Nombre;

/** Ce que la fenêtre change à une scène lue : les valeurs de ses sections, et d'abord leur place. */
public final class Deplacement {

    /** Les clés qui donnent une place, par préférence. */
    public static final List<String> CLES = Arrays.asList("centre", "position");

    /** Écart permis entre la position voulue et la position écrite, en pixels. */
    private static final double ECART = 0.1;

    /** Début du refus d'une valeur qui n'est dans aucun fichier. */
    private static final String REFUS = "valeur refusée";

    private Deplacement() {
    }

    /** La place que donne cette section, sous l'une des {@link #CLES} ; {@code null} si elle n'en donne pas. */
    public static Point place(SectionLue section) {
        try {
            String cle = cle(section);
            return cle == null ? null : section.point(cle);
        } catch (SceneFautive e) {
            // une forme a pu donner un autre sens à cette clé
            return null;
        }
    }

    /** Celle des {@link #CLES} que donne cette section, ou {@code null}. */
    public static String cle(SectionLue section) {
        return CLES.stream().filter(cle -> section.valeur(cle) != null).findFirst().orElse(null);
    }

    /** Cette position, comme dans un fichier, à un dixième de pixel. @param pixels nombre de pixels d'une unité */
    public static String ecrire(Point p, double pixels) {
        return ecrire(p.x, pixels) + " " + ecrire(p.y, pixels) + " " + ecrire(p.z, pixels);
    }

    private static String ecrire(double x, double pixels) {
        BigDecimal exact = new BigDecimal(x);
        double arrondi = IntStream.rangeClosed(-(int) Math.log10(1 + Math.abs(x)), 17)
                .mapToDouble(decimales -> exact.setScale(decimales, RoundingMode.HALF_EVEN).doubleValue())
                .filter(proche -> Math.abs(proche - x) * pixels <= ECART).findFirst().orElse(x);
        return Nombre.ecrire(arrondi);
    }

    /** Le texte d'une section, une ligne par clé. */
    private static byte[] texte(SectionLue section) {
        return section.ecrire("\n").getBytes(StandardCharsets.UTF_8);
    }

    /** La section de ce rang, avec ses changements. */
    public static SectionLue section(Origines origines, int rang) {
        Origine lue = origines.lues.get(rang);
        String[] lignes = new String(lue.texte, StandardCharsets.UTF_8).split("\n");
        SectionLue section = new SectionLue(REFUS, lue.nom, 0, origines.lecteur.cles(lue.nom));
        for (int k = 1; k < lignes.length; k++) {
            int egal = lignes[k].indexOf('=');
            section.ajouter(lignes[k].substring(0, egal), lignes[k].substring(egal + 1), 0);
        }
        return section;
    }

    /** Les clés permises dans les sections des types présents. */
    public static Stream<String> cles(Origines origines) {
        return Stream.concat(Stream.of("Lampe"), origines.lues.stream().map(lue -> lue.nom)).map(origines.lecteur::cles)
                .distinct().flatMap(List::stream).distinct();
    }

    /**
     * La même scène, où une section est lue de nouveau avec une autre valeur.
     *
     * @param rang celui de la section, dans {@link SceneLue#origines}
     * @throws SceneFautive si la lecture d'un fichier refuserait cette valeur
     */
    public static SceneLue avec(SceneLue lue, int rang, String cle, String valeur) {
        SectionLue section = section(lue.origines, rang).avec(cle, valeur, null);
        Object ancienne = lue.origines.getChose(rang);
        Object nouvelle = lue.origines.lecteur.lire(section);
        SceneLue autre = new SceneLue(lue.chemin, new Origines(lue.origines.lecteur, true));
        autre.somme = lue.somme;
        autre.origines.lues.addAll(lue.origines.lues);
        autre.origines.lues.set(rang,
                new Origine(nouvelle, section.nom, lue.origines.lues.get(rang).ligne, texte(section)));
        autre.objets.addAll(lue.objets);
        autre.lampes.addAll(lue.lampes);
        autre.objets.replaceAll(objet -> objet == ancienne ? (Objet3D) nouvelle : objet);
        autre.lampes.replaceAll(lampe -> lampe == ancienne ? (Lampe) nouvelle : lampe);
        autre.variantes.putAll(lue.variantes);
        autre.avertissements.addAll(lue.avertissements);
        return autre;
    }

    /** Les rangs des sections qui diffèrent de celles de {@code avant}. */
    private static IntStream rangsChanges(Origines origines, Origines avant) {
        return IntStream.range(0, origines.lues.size()).filter(k -> origines.lues.get(k) != avant.lues.get(k)
                && !Arrays.equals(origines.lues.get(k).texte, avant.lues.get(k).texte));
    }

    /** Les sections qui diffèrent de celles de {@code avant}, à copier dans le fichier. */
    public static String getChanges(SceneLue lue, SceneLue avant) {
        return rangsChanges(lue.origines, avant.origines)
                .mapToObj(k -> section(lue.origines, k).ecrire("\n") + "\n\n").collect(Collectors.joining());
    }

    /**
     * La scène {@code lue}, avec les changements faits de {@code avant} à {@code changee}. Une valeur que le fichier a
     * changée reste, sauf si {@code malgreLui} est vrai ; une section que le fichier n'a plus est oubliée.
     */
    public static SceneLue reporter(SceneLue lue, SceneLue avant, SceneLue changee, boolean malgreLui) {
        SceneLue faite = lue;
        for (int k : rangsChanges(changee.origines, avant.origines).toArray()) {
            SectionLue ancienne = section(avant.origines, k);
            SectionLue voulue = section(changee.origines, k);
            int ici = rangDuNom(lue.origines, voulue.nom, k);
            for (String cle : ici < 0 ? Collections.<String>emptyList() : lue.origines.lecteur.cles(voulue.nom)) {
                String valeur = voulue.valeur(cle);
                String sienne = section(lue.origines, ici).valeur(cle);
                if (valeur != null && !valeur.equals(ancienne.valeur(cle)) && !valeur.equals(sienne)
                        && (malgreLui || Objects.equals(sienne, ancienne.valeur(cle)))) {
                    try {
                        faite = avec(faite, ici, cle, valeur);
                    } catch (SceneFautive e) {
                        // le fichier a changé cette section au point que la valeur n'y convient plus
                    }
                }
            }
        }
        return faite;
    }

    /** Le rang de la section de ce nom, cherchée d'abord à ce rang-là ; −1 s'il n'y en a pas. */
    private static int rangDuNom(Origines origines, String nom, int probable) {
        int n = origines.lues.size();
        return IntStream.concat(IntStream.of(Math.min(probable, n - 1)), IntStream.range(0, n))
                .filter(k -> k >= 0 && origines.lues.get(k).nom.equals(nom)).findFirst().orElse(-1);
    }
}
