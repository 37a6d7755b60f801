package lancer.scene;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.zip.CRC32;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.contrat.Modele;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.texte.ErreurSysteme;
import lancer.texte.Nombre;

/** Le contenu d'un fichier de scène. */
public final class SceneLue {

    /** Les sphères par centre et rayon ; + 0.0 : −0.0 et 0.0 désignent la même position. */
    private static final Comparator<Sphere> PAR_PLACE = Comparator
            .<Sphere>comparingDouble(s -> s.getCentre().x + 0.0).thenComparingDouble(s -> s.getCentre().y + 0.0)
            .thenComparingDouble(s -> s.getCentre().z + 0.0).thenComparingDouble(Sphere::getRayon);

    /** Une ligne avec sa fin, puis la ligne d'une place : ce qui précède la valeur, et ce qui la suit. */
    private static final String LIGNE = "[^\r\n]*(\r\n|\r|\n)|[^\r\n]+";
    private static final String PLACE =
            "(?i)([ \t]*(?:centre|position)[ \t]*[=:][ \t]*)[^\r\n]*[^ \t\r\n]([ \t\r\n]*)";

    public final List<Objet3D> objets = new ArrayList<>();
    public final List<Lampe> lampes = new ArrayList<>();
    public final Origines origines;

    /** Les variantes présentes, chacune avec sa section ; la ligne est 0 si le fichier n'a pas cette section. */
    public final Map<Variante, Section> variantes = new LinkedHashMap<>();

    /** Avertissements : une ligne pour chaque section que la lecture a ignorée. */
    public final List<String> avertissements = new ArrayList<>();

    final Path chemin;
    /** Le contrôle CRC-32 des octets lus. */
    long somme;

    SceneLue(Path chemin, Origines origines) {
        this.chemin = chemin;
        this.origines = origines;
    }

    /** La même scène, où cette lampe a cette place. */
    public SceneLue avec(Lampe lampe, Point place) {
        return remplacer(lampe, new Lampe(place, lampe.getCouleur()));
    }

    /** La même scène, où cette sphère, qui n'est pas d'une autre classe, a ce centre. */
    public SceneLue avec(Sphere sphere, Point centre) {
        Sphere deplacee = new Sphere(centre, sphere.getRayon());
        deplacee.setKd(sphere.getKd());
        deplacee.setKs(sphere.getKs());
        deplacee.setNs(sphere.getNs());
        return remplacer(sphere, deplacee);
    }

    private SceneLue remplacer(Object ancienne, Object nouvelle) {
        SceneLue faite = new SceneLue(chemin, origines.remplacer(ancienne, nouvelle));
        faite.somme = somme;
        objets.forEach(objet -> faite.objets.add(objet == ancienne ? (Objet3D) nouvelle : objet));
        lampes.forEach(lampe -> faite.lampes.add(lampe == ancienne ? (Lampe) nouvelle : lampe));
        faite.variantes.putAll(variantes);
        faite.avertissements.addAll(avertissements);
        return faite;
    }

    /** Les octets du fichier de cette scène, où les places sont celles de la scène {@code deplacee} qui en vient. */
    public byte[] deplacer(SceneLue deplacee) {
        Map<Object, String> places = new IdentityHashMap<>();
        IntStream.range(0, objets.size()).filter(k -> objets.get(k) != deplacee.objets.get(k))
                .forEach(k -> places.put(objets.get(k), ecrire(((Sphere) deplacee.objets.get(k)).getCentre())));
        IntStream.range(0, lampes.size()).filter(k -> lampes.get(k) != deplacee.lampes.get(k))
                .forEach(k -> places.put(lampes.get(k), ecrire(deplacee.lampes.get(k).getPosition())));
        return deplacer(places);
    }

    /** Cette place, comme dans un fichier. */
    public static String ecrire(Point p) {
        return Nombre.ecrire(p.x) + " " + Nombre.ecrire(p.y) + " " + Nombre.ecrire(p.z);
    }

    void ajouter(Object chose, SectionLue section) {
        if (chose instanceof Lampe) {
            lampes.add((Lampe) chose);
        } else {
            objets.add((Objet3D) chose);
        }
        origines.ajouter(chose, section);
    }

    /** Les objets, dans le même ordre, sans les sphères de mêmes centre et rayon qu'une précédente. */
    public static List<Objet3D> sansConfondues(List<? extends Objet3D> objets) {
        List<Objet3D> gardes = new ArrayList<>(objets.size());
        Set<Sphere> vues = new TreeSet<>(PAR_PLACE);
        for (Objet3D objet : objets) {
            if (objet.getClass() != Sphere.class || vues.add((Sphere) objet)) {
                gardes.add(objet);
            }
        }
        return gardes;
    }

    /** Modèle où chaque variante est installée. @throws SceneFautive si une section est refusée */
    public Modele getModele() {
        Modele modele = new Modele();
        variantes.forEach((variante, section) -> {
            variante.installer(section, modele);
            section.verifierCles();
        });
        return modele;
    }

    /**
     * Les octets du fichier, où des objets et des lampes ont une autre place. Seule la valeur de leur ligne
     * {@code centre} ou {@code position} change.
     *
     * @param places pour chaque objet ou lampe de cette scène, trois nombres comme dans un fichier
     * @throws SceneFautive si le fichier a changé depuis sa lecture, ou si une section n'a pas cette ligne
     */
    public byte[] deplacer(Map<?, String> places) {
        Map<Integer, String> parLigne = new HashMap<>();
        places.forEach((chose, place) -> parLigne.put(origines.getLigne(chose), place));
        // un octet, un caractère : ceux que rien ne change restent les mêmes
        Matcher ligne = Pattern.compile(LIGNE).matcher(new String(relire(), StandardCharsets.ISO_8859_1));
        Pattern ligneDePlace = Pattern.compile(PLACE);
        StringBuilder ecrit = new StringBuilder();
        String voulue = null;
        int faites = 0;
        for (int numero = 1; ligne.find(); numero++) {
            Matcher place = ligneDePlace.matcher(ligne.group());
            if (parLigne.containsKey(numero) || ligne.group().trim().startsWith("[")) {
                voulue = parLigne.get(numero);
            }
            if (voulue != null && place.matches()) {
                ecrit.append(place.group(1)).append(voulue).append(place.group(2));
                voulue = null;
                faites++;
            } else {
                ecrit.append(ligne.group());
            }
        }
        if (faites < places.size()) {
            throw FichierScene.inutilisable(chemin.toString(), "une section déplacée n'a ni centre, ni position", null);
        }
        return ecrit.toString().getBytes(StandardCharsets.ISO_8859_1);
    }

    /** Les octets du fichier, les mêmes qu'à sa lecture. */
    private byte[] relire() {
        try {
            byte[] octets = Files.isRegularFile(chemin) ? Files.readAllBytes(chemin) : new byte[0];
            CRC32 lus = new CRC32();
            lus.update(octets);
            if (lus.getValue() == somme) {
                return octets;
            }
        } catch (IOException e) {
            throw FichierScene.inutilisable(chemin.toString(), ErreurSysteme.raison(e), e);
        }
        throw new SceneFautive(SectionLue.message(chemin.toString(), 0, null, null,
                "le fichier a changé depuis sa lecture", "le fichier relu, puis le déplacement refait"));
    }
}
