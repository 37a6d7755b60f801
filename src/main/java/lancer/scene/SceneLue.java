package lancer.scene;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.contrat.Modele;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.systeme.Ecriture;
import lancer.texte.Nombre;

/** Le contenu d'un fichier de scène. */
public final class SceneLue {

    /** Une ligne : ce qui précède sa valeur, sa valeur, puis les blancs et la fin de la ligne. */
    private static final String LIGNE = "([^\r\n=:]*[=:][ \t]*)?[^\r\n]*?([ \t]*(?:\r\n|\r|\n|\\z))";

    public final List<Objet3D> objets = new ArrayList<>();
    public final List<Lampe> lampes = new ArrayList<>();

    /** Les variantes présentes, chacune avec sa section ; la ligne est 0 si le fichier n'a pas cette section. */
    public final Map<Variante, Section> variantes = new LinkedHashMap<>();

    /** Avertissements : une ligne pour chaque section que la lecture a ignorée. */
    public final List<String> avertissements = new ArrayList<>();

    /** La caméra, selon la largeur et la hauteur de l'image. */
    BiFunction<Integer, Integer, Camera> cadrage = Camera::new;

    /** Le nom du fichier, tel qu'il est demandé. */
    public final String nom;
    final Path chemin;
    /** La {@link #version} du fichier avant sa lecture. */
    String version;
    long dureeNs;
    /** Les objets et les lampes, dans l'ordre du fichier. */
    private final List<Origine> origines = new ArrayList<>();

    /** Un objet ou une lampe, le nom de sa section, sa ligne, et celle de sa place. */
    private static final class Origine {
        final Object chose;
        final String nom;
        final int ligne;
        final int lignePlace;

        Origine(Object chose, String nom, int ligne, int lignePlace) {
            this.chose = chose;
            this.nom = nom;
            this.ligne = ligne;
            this.lignePlace = lignePlace;
        }
    }

    SceneLue(String nom, Path chemin) {
        this.nom = nom;
        this.chemin = chemin;
    }

    /** L'heure et la taille d'un fichier. */
    static String version(Path chemin) throws IOException {
        BasicFileAttributes a = Files.readAttributes(chemin, BasicFileAttributes.class);
        return a.lastModifiedTime() + " " + a.size();
    }

    /** Ajoute un objet ou une lampe. @param cle celle de sa place */
    void ajouter(Object chose, SectionLue section, String cle) {
        ajouter(new Origine(chose, section.nom, section.ligne, section.getLigne(cle)));
    }

    private void ajouter(Origine lue) {
        if (lue.chose instanceof Lampe) {
            lampes.add((Lampe) lue.chose);
        } else {
            objets.add((Objet3D) lue.chose);
        }
        origines.add(lue);
    }

    /** Texte de la forme {@code [Sphere ambre] ligne 52} ; {@code null} si cette chose ne vient pas du fichier. */
    public String getOrigine(Object chose) {
        return origines.stream().filter(lue -> lue.chose == chose).findFirst()
                .map(lue -> "[" + lue.nom + "] ligne " + lue.ligne).orElse(null);
    }

    /** La position de cette lampe, ou le centre de cette sphère. */
    public static Point place(Object chose) {
        return chose instanceof Lampe ? ((Lampe) chose).getPosition() : ((Sphere) chose).getCentre();
    }

    /** La même scène, où cette lampe, ou cette sphère qui n'est pas d'une autre classe, a cette place. */
    public SceneLue avec(Object chose, Point place) {
        SceneLue faite = new SceneLue(nom, chemin);
        faite.version = version;
        faite.dureeNs = dureeNs;
        faite.cadrage = cadrage;
        faite.variantes.putAll(variantes);
        faite.avertissements.addAll(avertissements);
        for (Origine lue : origines) {
            faite.ajouter(lue.chose != chose ? lue
                    : new Origine(deplacee(chose, place), lue.nom, lue.ligne, lue.lignePlace));
        }
        return faite;
    }

    private static Object deplacee(Object chose, Point place) {
        if (chose instanceof Lampe) {
            return new Lampe(place, ((Lampe) chose).getCouleur());
        }
        Sphere sphere = new Sphere(place, ((Sphere) chose).getRayon());
        sphere.setMatiere((Sphere) chose);
        return sphere;
    }

    /** Le temps de la lecture, en nanosecondes. */
    public long getDureeNs() {
        return dureeNs;
    }

    public BiFunction<Integer, Integer, Camera> getCadrage() {
        return cadrage;
    }

    /** Cette place, comme dans un fichier. */
    public static String ecrire(Point p) {
        return Nombre.ecrire(p.x) + " " + Nombre.ecrire(p.y) + " " + Nombre.ecrire(p.z);
    }

    /** Modèle où chaque variante est installée. @throws SceneFautive si une section est refusée */
    public Modele getModele() {
        Modele.Construction modele = new Modele.Construction();
        variantes.forEach((variante, section) -> {
            variante.installer(section, modele);
            section.verifierCles();
        });
        return modele.construire();
    }

    /** L'heure et la taille du fichier qui contient cette scène, ou la scène dont elle vient. */
    public String getVersion() {
        return version;
    }

    /**
     * Remplace le fichier de cette scène par celui de la scène {@code deplacee}, qui en vient, et lui donne sa version.
     * Seule la valeur des lignes {@code centre} ou {@code position} de ce qui a bougé change.
     *
     * @throws SceneFautive si le fichier a changé depuis sa lecture
     * @throws lancer.systeme.Echec s'il ne peut être lu ou écrit
     */
    public void remplacer(SceneLue deplacee) {
        byte[][] ecrit = new byte[1][];
        new Ecriture<byte[][]>(chemin.toString(), (octets, sortie) -> {
            octets[0] = deplacer(deplacee);
            sortie.write(octets[0]);
        }).remplacer(ecrit);
        try {
            String nouvelle = version(chemin);
            deplacee.version = Arrays.equals(ecrit[0], Files.readAllBytes(chemin)) ? nouvelle : version;
        } catch (IOException e) {
            // un autre programme a pu écrire entre-temps, ou effacer le fichier : sa version est à lire
            deplacee.version = version;
        }
    }

    /** Les octets du fichier de cette scène, avec les places de l'autre. */
    byte[] deplacer(SceneLue deplacee) throws IOException {
        if (!Files.isRegularFile(chemin) || !version.equals(version(chemin))) {
            throw new SceneFautive(SectionLue.message(chemin.toString(), 0, null, null,
                    "le fichier a changé depuis sa lecture", "le fichier relu, puis le déplacement refait"));
        }
        Map<Integer, Point> places = new HashMap<>();
        for (int k = 0; k < origines.size(); k++) {
            Object chose = deplacee.origines.get(k).chose;
            if (chose != origines.get(k).chose) {
                places.put(origines.get(k).lignePlace, place(chose));
            }
        }
        // un octet, un caractère : ceux que rien ne change restent les mêmes
        String texte = new String(Files.readAllBytes(chemin), StandardCharsets.ISO_8859_1);
        Matcher ligne = Pattern.compile(LIGNE).matcher(texte);
        StringBuffer ecrit = new StringBuffer();
        for (int numero = 1; ligne.find(); numero++) {
            if (places.containsKey(numero)) {
                ligne.appendReplacement(ecrit, "$1" + ecrire(places.get(numero)) + "$2");
            }
        }
        return ligne.appendTail(ecrit).toString().getBytes(StandardCharsets.ISO_8859_1);
    }
}
