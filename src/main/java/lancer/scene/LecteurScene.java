package lancer.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.DoubleConsumer;
import java.util.regex.Pattern;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.SceneFautive;
import lancer.contrat.Forme;
import lancer.contrat.Modele;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.texte.Nombre;
import lancer.texte.Texte;
import org.ini4j.Config;
import org.ini4j.InvalidFileFormatException;
import org.ini4j.spi.IniHandler;
import org.ini4j.spi.IniParser;

/**
 * Lecture d'un fichier INI : objets, lampes, sections des variantes. ini4j ne sert ici qu'à découper les lignes
 * ({@code IniParser}) ; ses substitutions, par où passe la CVE-2022-41404, ne sont jamais appelées.
 */
public class LecteurScene implements DoubleConsumer {

    private static final double LUMIERE_MAX = 1e6;
    private static final double NS_MAX = 1e9;

    /** Nombre de couleurs retenues à la fois : au-delà, elles ne se répètent pas. */
    private static final int PALETTE_MAX = 256;

    private static final String[] CLES_LAMPE = {"position", "couleur"};
    private static final List<String> CLES_MATIERE = Arrays.asList("Kd", "Ks", "Kr", "ns");

    public final List<Objet3D> objets = new ArrayList<>();
    public final List<Lampe> lampes = new ArrayList<>();
    public final Origines origines = new Origines();

    /** Avertissements : une ligne pour chaque section que la lecture a laissée de côté. */
    public final List<String> avertissements = new ArrayList<>();

    /** Modèle de la scène lue, qu'a rendu {@link #installer}. */
    public Modele modele;

    /** La scène comme on l'a nommée, ou le chemin où elle a été trouvée s'il est autre. */
    private String fichier;
    private Services services;
    private final Map<String, Section> sectionsVariantes = new HashMap<>();
    /** Chaque nom de section, et sa ligne. */
    private final Map<String, Integer> noms = new HashMap<>();
    /** Les couleurs déjà lues : une scène d'un million de sphères n'en a que quelques-unes. */
    private final Map<Couleur, Couleur> palette = new HashMap<>();
    private Lignes lignes;
    private Section courante;

    /**
     * Lit un fichier en entier. Un lecteur ne lit qu'une scène.
     *
     * @return ce lecteur
     * @throws SceneFautive si le fichier ne peut être utilisé
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     */
    public LecteurScene lire(String nomFichier) {
        fichier = nomFichier;
        Path chemin = FichierScene.trouver(fichier);
        if (!chemin.equals(Paths.get(fichier))) {
            fichier = chemin.toString();
        }
        services = new Services();
        try (InputStream entree = FichierScene.ouvrir(chemin)) {
            lignes = new Lignes(entree, chemin.toFile().length(), this);
            Sections sections = new Sections();
            sections.parse(lignes, sections);
        } catch (InvalidFileFormatException e) {
            throw illisible(lignes.getTexte().trim());
        } catch (CharacterCodingException e) {
            throw refus(lignes.autreCodage() != null ? "fichier en " + lignes.autreCodage()
                    : "octets qui ne sont pas de l'UTF-8 : " + Texte.cite(lignes.getTexte().trim()),
                    "un fichier enregistré en UTF-8");
        } catch (Lignes.LigneTropLongue e) {
            throw new SceneFautive(Section.message(fichier, lignes.getNumero(), null, null, "ligne trop longue",
                    "au plus " + (Lignes.LIGNE_MAX >> 20) + " Mo par ligne"), e);
        } catch (IOException e) {
            throw FichierScene.inutilisable(fichier,
                    FichierScene.pourquoi(e, "lecture impossible (" + Texte.panne(e) + ")"), e);
        }
        Map<Variante, Section> variantes = new LinkedHashMap<>();
        for (Map.Entry<String, Variante> presente : services.variantes.entrySet()) {
            Section donnee = sectionsVariantes.get(presente.getKey());
            variantes.put(presente.getValue(), donnee != null ? donnee
                    : new Section(fichier, presente.getValue().getSection(), 0));
        }
        modele = installer(variantes);
        return this;
    }

    /** Appelé à mesure de la lecture, avec la part lue du fichier, de 0 à 1. */
    @Override
    public void accept(double part) {
    }

    /**
     * Installe les variantes présentes, chacune avec sa section, de ligne 0 si le fichier ne l'a pas.
     *
     * @throws SceneFautive si une section ne va pas, ou si deux variantes veulent le même contrat
     */
    protected Modele installer(Map<Variante, Section> variantes) {
        Modele modele = new Modele();
        for (Map.Entry<Variante, Section> presente : variantes.entrySet()) {
            presente.getKey().installer(presente.getValue(), modele);
            presente.getValue().verifierCles();
        }
        return modele;
    }

    /** Découpage d'ini4j, sans ses échappements, et suite donnée à chaque ligne. */
    private final class Sections extends IniParser implements IniHandler {

        /** La forme que décrit la section en cours, {@code null} si ce n'est pas un objet. */
        private Forme forme;
        private boolean lampe;

        /** Évite la recherche de services que fait ini4j. */
        Sections() {
            Config config = new Config();
            config.setInclude(false);
            config.setEscape(false);
            config.setEscapeNewline(false);
            setConfig(config);
        }

        @Override
        public void startSection(String nomEcrit) {
            if (nomEcrit.indexOf(']') >= 0) {
                throw illisible("[" + nomEcrit + "]");
            }
            boolean unSeulBlanc = nomEcrit.indexOf('\t') < 0 && !nomEcrit.contains("  ");
            String nom = unSeulBlanc ? nomEcrit : nomEcrit.replaceAll("[ \t]+", " ");
            String mot = nom.indexOf(' ') < 0 ? nom : nom.substring(0, nom.indexOf(' '));
            String type = Texte.minuscules(mot);
            int ligne = lignes.getNumero();
            lampe = type.equals("lampe");
            forme = lampe ? null : services.formes.get(type);
            courante = new Section(fichier, nom, ligne, cles());
            boolean presente = lampe || forme != null || services.variantes.containsKey(type);
            if (!presente && !Services.varianteConnue(type)) {
                throw courante.fautive(ligne, null, "type de section inconnu", services.types());
            }
            Integer deja = noms.putIfAbsent(type + nom.substring(mot.length()), ligne);
            if (deja != null) {
                throw courante.fautive(ligne, null, "deux sections de ce nom, la première ligne " + deja,
                        "un nom différent pour chaque section");
            }
            Section premiere = lampe || forme != null ? null : sectionsVariantes.put(type, courante);
            if (premiere != null) {
                throw courante.fautive(ligne, null, "deuxième section de ce type, la première ligne "
                        + premiere.ligne, "une seule section " + mot);
            }
            if (!presente) {
                avertissements.add(Section.message(fichier, ligne, nom, null, "section laissée de côté",
                        "la variante qui la lit, java -jar " + type + "/target/" + type + ".jar"));
            }
        }

        private String[] cles() {
            if (forme == null) {
                return lampe ? CLES_LAMPE : new String[0];
            }
            List<String> siennes = new ArrayList<>(Arrays.asList(Objects.requireNonNull(forme.getCles(),
                    forme.getClass().getName() + ".getCles a rendu null")));
            siennes.addAll(CLES_MATIERE);
            return siennes.toArray(new String[0]);
        }

        @Override
        public void handleOption(String cle, String valeur) {
            courante.ajouter(cle, valeur, lignes.getNumero());
        }

        @Override
        public void endSection() {
            if (lampe) {
                lampes.add(new Lampe(courante.point("position"), courante.couleur("couleur", LUMIERE_MAX)));
                origines.ajouter(lampes.get(lampes.size() - 1), courante);
            } else if (forme != null) {
                objets.add(lireForme(forme));
                lireMatiere(objets.get(objets.size() - 1));
                origines.ajouter(objets.get(objets.size() - 1), courante);
            }
        }

        @Override
        public void startIni() {
        }

        @Override
        public void endIni() {
        }

        @Override
        public void handleComment(String commentaire) {
        }
    }

    /** L'objet de la section, encore sans matière. Une exception de la forme est une section refusée. */
    private Objet3D lireForme(Forme forme) {
        try {
            Objet3D objet = forme.lire(courante);
            if (objet == null || objet == forme) {
                throw new IllegalStateException("lire n'a pas rendu un objet neuf");
            }
            return objet;
        } catch (SceneFautive e) {
            throw e;
        } catch (RuntimeException e) {
            String classe = forme.getClass().getName();
            boolean refus = e.getMessage() != null
                    && (e instanceof IllegalArgumentException || e instanceof IllegalStateException);
            throw courante.fautive(courante.ligne, null, "section que " + classe + " ne sait pas lire : "
                    + (refus ? Texte.cite(e.getMessage()) : Texte.cause(e, Pattern.quote(classe) + ".*")),
                    "des valeurs qui lui conviennent");
        }
    }

    /** Lit la matière d'un objet ; ce que la section n'en dit pas reste tel que l'objet est né. */
    private void lireMatiere(Objet3D lu) {
        lu.setKd(commune(courante.couleur("Kd", lu.getKd(), 1)));
        if (courante.contient("Ks") && courante.contient("Kr")) {
            throw courante.ensemble("Ks", "Kr", "synonyme de", "Ks ou Kr, pas les deux");
        }
        lu.setKs(commune(courante.couleur(courante.contient("Kr") ? "Kr" : "Ks", lu.getKs(), 1)));
        lu.setNs(courante.reel("ns", lu.getNs(), 0, NS_MAX));
    }

    private Couleur commune(Couleur couleur) {
        if (palette.size() == PALETTE_MAX) {
            palette.clear();
        }
        Couleur deja = palette.putIfAbsent(couleur, couleur);
        return deja != null ? deja : couleur;
    }

    /** Refus d'une ligne qu'ini4j ne sait pas lire : son message est anglais, et ne dit pas pourquoi. */
    private SceneFautive illisible(String texte) {
        String cite = " : " + Texte.cite(texte);
        if (texte.startsWith("[")) {
            int crochet = texte.indexOf(']');
            return crochet < 0 ? refus("crochet non fermé" + cite, "par exemple [Sphere 1]")
                    : crochet < texte.length() - 1 ? refus("du texte après le crochet" + cite,
                            "[Section] seule sur sa ligne, un commentaire sur la sienne")
                    : refus("section sans nom" + cite, "par exemple [Sphere 1]");
        }
        return courante == null ? refus((texte.indexOf('=') > 0 ? "clé" : "texte") + " avant toute section" + cite,
                "d'abord une section, par exemple [Sphere 1]") : refus("ligne illisible" + cite,
                "clé=valeur, [Section], ou un commentaire seul sur sa ligne, après ; ou #");
    }

    /** Refuse la ligne en cours, qui est de la section en cours si elle n'en commence pas une autre. */
    private SceneFautive refus(String faute, String attendu) {
        String nom = courante == null || lignes.getTexte().trim().startsWith("[") ? null : courante.nom;
        return new SceneFautive(Section.message(fichier, lignes.getNumero(), nom, null, faute, attendu));
    }
}
