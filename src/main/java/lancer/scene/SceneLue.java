package lancer.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.contrat.Modele;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.texte.Nombre;

/** Le contenu d'un fichier de scène. */
public final class SceneLue {

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
    /** Le texte lu ; {@code null} si la lecture ne l'a pas gardé. */
    TexteScene texte;
    long dureeNs;
    /** Les objets et les lampes, dans l'ordre du fichier. */
    private final List<Origine> origines = new ArrayList<>();

    /** Les sections qui ne sont plus celles du texte lu, par leur nom. */
    private final Map<String, SectionLue> changees = new LinkedHashMap<>();
    /** Celles du texte lu qui ont été demandées. */
    private final Map<String, SectionLue> relues = new HashMap<>();

    /** Un objet ou une lampe, sa section, sans ses valeurs, et ce qui lit une telle section. */
    private static final class Origine {
        final Object chose;
        final String nom;
        final int ligne;
        final List<String> cles;
        final BiConsumer<SectionLue, SceneLue> lecture;

        Origine(Object chose, String nom, int ligne, List<String> cles, BiConsumer<SectionLue, SceneLue> lecture) {
            this.chose = chose;
            this.nom = nom;
            this.ligne = ligne;
            this.cles = cles;
            this.lecture = lecture;
        }
    }

    SceneLue(String nom, Path chemin) {
        this.nom = nom;
        this.chemin = chemin;
    }

    /** Ajoute l'objet ou la lampe de cette section. @param lecture ce qui lit une section de ce type */
    void ajouter(Object chose, SectionLue section, BiConsumer<SectionLue, SceneLue> lecture) {
        ajouter(new Origine(chose, section.nom, section.ligne, section.connues, lecture));
    }

    private void ajouter(Origine lue) {
        if (lue.chose instanceof Lampe) {
            lampes.add((Lampe) lue.chose);
        } else {
            objets.add((Objet3D) lue.chose);
        }
        origines.add(lue);
    }

    private Origine origine(Predicate<Origine> voulue) {
        return origines.stream().filter(voulue).findFirst().orElse(null);
    }

    /** Texte de la forme {@code [Sphere ambre] ligne 52} ; {@code null} si cette chose ne vient pas du fichier. */
    public String getOrigine(Object chose) {
        Origine lue = origine(celle -> celle.chose == chose);
        return lue == null ? null : "[" + lue.nom + "] ligne " + lue.ligne;
    }

    /** Le nom de la section de cette chose ; {@code null} si elle ne vient pas du fichier. */
    public String getNomDeSection(Object chose) {
        Origine lue = origine(celle -> celle.chose == chose);
        return lue == null ? null : lue.nom;
    }

    /** L'objet ou la lampe de la section de ce nom ; {@code null} s'il n'y en a pas. */
    public Object getChose(String section) {
        Origine lue = origine(celle -> celle.nom.equals(section));
        return lue == null ? null : lue.chose;
    }

    /** La section de ce nom ; {@code null} si elle n'est celle d'aucun objet ni d'aucune lampe du texte lu. */
    public SectionLue getSection(String section) {
        Origine lue = origine(celle -> celle.nom.equals(section));
        if (lue == null || texte == null) {
            return null;
        }
        return changees.containsKey(section) ? changees.get(section) : relues.computeIfAbsent(section,
                nouvelle -> texte.lire(new SectionLue(chemin.toString(), section, lue.ligne, lue.cles)));
    }

    /** Les valeurs de cette section, par clé : les écrites ou, à défaut, celles qui servent ; vide sans section. */
    public Map<String, String> getValeurs(String section) {
        Map<String, String> valeurs = new LinkedHashMap<>();
        SectionLue lue = getSection(section);
        if (lue != null) {
            Map<String, String> servent = new HashMap<>();
            if (getChose(section) instanceof Objet3D) {
                Objet3D objet = (Objet3D) getChose(section);
                servent.put("Kd", ecrire(objet.getKd()));
                servent.put("Ks", ecrire(objet.getKs()));
                servent.put("ns", Nombre.ecrire(objet.getNs()));
            }
            lue.getCles().forEach(cle -> valeurs.put(cle, lue.mot(cle, servent.getOrDefault(cle, ""))));
        }
        return valeurs;
    }

    /** La position de cette lampe, ou le centre de cette sphère. */
    public static Point place(Object chose) {
        return chose instanceof Lampe ? ((Lampe) chose).getPosition() : ((Sphere) chose).getCentre();
    }

    /**
     * La même scène, où cette clé d'un objet ou d'une lampe a cette valeur.
     *
     * @throws SceneFautive si cette valeur est refusée, avec le message que ferait la lecture du fichier, ou si cette
     *         section n'y est plus
     */
    public SceneLue avec(String section, String cle, String valeur) {
        if (getChose(section) == null) {
            throw TexteScene.pasUneFois(0, section, chemin.toString());
        }
        SectionLue changee = getSection(section).changee(cle, valeur);
        SceneLue seule = new SceneLue(nom, chemin);
        origine(lue -> lue.nom.equals(section)).lecture.accept(changee, seule);
        SceneLue faite = new SceneLue(nom, chemin);
        faite.texte = texte;
        faite.dureeNs = dureeNs;
        faite.cadrage = cadrage;
        faite.variantes.putAll(variantes);
        faite.avertissements.addAll(avertissements);
        faite.changees.putAll(changees);
        faite.changees.put(section, changee);
        origines.forEach(lue -> faite.ajouter(lue.nom.equals(section)
                ? new Origine(seule.origines.get(0).chose, lue.nom, lue.ligne, lue.cles, lue.lecture) : lue));
        return faite;
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

    private static String ecrire(Couleur c) {
        return Nombre.ecrire(c.r) + " " + Nombre.ecrire(c.v) + " " + Nombre.ecrire(c.b);
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

    /** Le texte lu ; {@code null} si la lecture ne l'a pas gardé. Les changements n'y sont pas. */
    public TexteScene getTexte() {
        return texte;
    }

    /**
     * Ce texte, où les clés qui diffèrent de celles de {@code avant} ont les valeurs de cette scène.
     *
     * @param avant la scène que contient ce texte, à ce que d'autres ont changé près
     * @throws SceneFautive si une section changée n'y est pas une fois
     */
    public TexteScene ecrireDans(TexteScene present, SceneLue avant) {
        Set<String> noms = new LinkedHashSet<>(changees.keySet());
        noms.addAll(avant.changees.keySet());
        TexteScene ecrit = present;
        for (String section : noms) {
            Map<String, String> valeurs = new LinkedHashMap<>();
            Map<String, String> voulues = getSection(section).getValeurs();
            Map<String, String> anciennes = avant.getSection(section).getValeurs();
            anciennes.keySet().stream().filter(cle -> !voulues.containsKey(cle)).forEach(cle -> valeurs.put(cle, null));
            voulues.forEach((cle, valeur) -> {
                if (!valeur.equals(anciennes.get(cle))) {
                    valeurs.put(cle, valeur);
                }
            });
            ecrit = ecrit.avec(section, valeurs, chemin.toString());
        }
        return ecrit;
    }
}
