package lancer.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
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
public class LecteurScene {

    private static final double LUMIERE_MAX = 1e6;
    private static final double NS_MAX = 1e9;

    /** Nombre de couleurs retenues à la fois : au-delà, elles ne se répètent pas. */
    private static final int PALETTE_MAX = 256;

    private static final String[] CLES_LAMPE = {"position", "couleur"};
    private static final String[] CLES_MATIERE = {"Kd", "Ks", "Kr", "ns"};

    /** La scène comme on l'a nommée, ou le chemin où elle a été trouvée s'il est autre. */
    private String fichier;
    private final Services services = new Services();
    private final List<Objet3D> objets = new ArrayList<>();
    private final List<Lampe> lampes = new ArrayList<>();
    private final Origines origines = new Origines();
    private final List<String> avertissements = new ArrayList<>();
    private final Map<String, Section> sectionsVariantes = new HashMap<>();
    /** Chaque nom de section, et sa ligne. */
    private final Map<String, Integer> noms = new HashMap<>();
    /** Toutes les clés des sections d'une forme, celles de la matière comprises. */
    private final Map<Forme, String[]> cles = new IdentityHashMap<>();
    /** Les couleurs déjà lues : une scène d'un million de sphères n'en a que quelques-unes. */
    private final Map<Couleur, Couleur> palette = new HashMap<>();
    private Modele modele;
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
        try (InputStream entree = FichierScene.ouvrir(chemin)) {
            // une classe, car la première lambda d'un programme coûte cher à son démarrage
            lignes = new Lignes(entree, chemin.toFile().length(), new DoubleConsumer() {
                @Override
                public void accept(double part) {
                    avancer(part);
                }
            });
            new Decoupeur().parse(lignes, new Sections());
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
        for (Map.Entry<String, Variante> presente : services.variantes().entrySet()) {
            Section donnee = sectionsVariantes.get(presente.getKey());
            variantes.put(presente.getValue(), donnee != null ? donnee
                    : new Section(fichier, presente.getValue().getSection(), 0));
        }
        modele = installer(variantes);
        return this;
    }

    /** Appelé à mesure de la lecture, avec la part lue du fichier, de 0 à 1. */
    public void avancer(double part) {
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

    public List<Objet3D> getObjets() {
        return objets;
    }

    public List<Lampe> getLampes() {
        return lampes;
    }

    /** Origines des objets et des lampes lus. */
    public Origines getOrigines() {
        return origines;
    }

    /** Modèle de cette scène, qu'a rendu {@link #installer}. */
    public Modele getModele() {
        return modele;
    }

    /** Avertissements : une ligne pour chaque section que la lecture a laissée de côté. */
    public List<String> getAvertissements() {
        return avertissements;
    }

    /** Découpage d'ini4j, sans ses échappements ; le constructeur évite la recherche de services. */
    private static final class Decoupeur extends IniParser {
        Decoupeur() {
            Config config = new Config();
            config.setInclude(false);
            config.setEscape(false);
            config.setEscapeNewline(false);
            setConfig(config);
        }
    }

    /** Suite donnée à chaque ligne que découpe ini4j. */
    private final class Sections implements IniHandler {

        /** La forme que décrit la section en cours, {@code null} si ce n'est pas un objet. */
        private Forme forme;
        private boolean lampe;

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
            forme = lampe ? null : services.forme(type);
            courante = new Section(fichier, nom, ligne, lampe ? CLES_LAMPE : forme == null ? null : cles(forme));
            boolean presente = lampe || forme != null || services.variantes().containsKey(type);
            if (!presente && !Services.varianteConnue(type)) {
                throw courante.fautive(ligne, null, "type de section inconnu",
                        services.types());
            }
            Integer deja = noms.putIfAbsent(type + nom.substring(mot.length()), ligne);
            if (deja != null) {
                throw courante.fautive(ligne, null, "deux sections de ce nom, la première ligne " + deja,
                        "un nom différent pour chaque section");
            }
            Section premiere = lampe || forme != null ? null : sectionsVariantes.put(type, courante);
            if (premiere != null) {
                throw courante.fautive(ligne, null, "deuxième section de ce type, la première ligne "
                        + premiere.getLigne(), "une seule section " + mot);
            }
            if (!presente) {
                avertissements.add(Section.message(fichier, ligne, nom, null, "section laissée de côté",
                        "la variante qui la lit, java -jar " + type + "/target/" + type + ".jar"));
            }
        }

        @Override
        public void handleOption(String cle, String valeur) {
            courante.ajouter(cle, valeur, lignes.getNumero());
        }

        @Override
        public void endSection() {
            if (lampe) {
                Lampe lue = new Lampe(courante.point("position"), courante.couleur("couleur", LUMIERE_MAX));
                lampes.add(lue);
                origines.ajouter(lue, courante.getNom(), courante.getLigne());
            } else if (forme != null) {
                Objet3D lu = lireForme(forme);
                lireMatiere(lu);
                objets.add(lu);
                origines.ajouter(lu, courante.getNom(), courante.getLigne());
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

    private String[] cles(Forme forme) {
        String[] toutes = cles.get(forme);
        if (toutes == null) {
            String[] siennes = Objects.requireNonNull(forme.getCles(),
                    forme.getClass().getName() + ".getCles a rendu null");
            toutes = Arrays.copyOf(siennes, siennes.length + CLES_MATIERE.length);
            System.arraycopy(CLES_MATIERE, 0, toutes, siennes.length, CLES_MATIERE.length);
            cles.put(forme, toutes);
        }
        return toutes;
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
            throw courante.fautive(courante.getLigne(), null, "section que " + classe + " ne sait pas lire : "
                    + (refus ? Texte.cite(e.getMessage()) : Texte.cause(e, Pattern.quote(classe) + ".*")),
                    "des valeurs qui lui conviennent");
        }
    }

    /** La matière se lit de même pour tout objet ; ce que la section n'en dit pas reste tel que l'objet est né. */
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

    /** Le message d'ini4j est anglais, et ne dit pas pourquoi. */
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
        String nom = courante == null || lignes.getTexte().trim().startsWith("[") ? null : courante.getNom();
        return new SceneFautive(Section.message(fichier, lignes.getNumero(), nom, null, faute, attendu));
    }
}
