package lancer.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
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
import lancer.contrat.Variante;
import lancer.scene.Origines.Origine;
import lancer.texte.ErreurSysteme;
import lancer.texte.Pile;
import lancer.texte.Texte;
import org.ini4j.Config;
import org.ini4j.InvalidFileFormatException;
import org.ini4j.spi.IniHandler;
import org.ini4j.spi.IniParser;

/** Lecture d'un fichier INI. ini4j ne fait que le découper en lignes, sans ses substitutions (CVE-2022-41404). */
public final class LecteurScene {

    private static final double LUMIERE_MAX = 1e6;
    private static final double NS_MAX = 1e9;

    /** Nombre maximal de couleurs dans la palette. */
    private static final int PALETTE_MAX = 256;

    /** Les clés de la matière, permises dans la section de toute forme. */
    public static final List<String> CLES_MATIERE =
            Collections.unmodifiableList(Arrays.asList("Kd", "Ks", "Kr", "ns"));

    private final Path chemin;
    /** Le nom demandé de la scène, ou le chemin où elle a été trouvée. */
    private final String fichier;
    private final Services services;
    private final SceneLue lue = new SceneLue();
    /** Les sections de variantes, par type, et les clés de chaque type d'objets. */
    private final Map<String, SectionLue> sectionsVariantes = new HashMap<>();
    private final Map<String, List<String>> cles = new HashMap<>();
    /** L'origine de chaque section, par son nom ; le type y a son écriture ordinaire. */
    private final Map<String, Origine> noms = new HashMap<>();
    /** Couleurs déjà lues, à partager : une scène d'un million de sphères n'en a que quelques-unes. */
    private final Map<Couleur, Couleur> palette = new HashMap<>();
    private Lignes lignes;
    private SectionLue courante;
    private Origine origine;
    /** La forme de la section en cours ; {@code null} si la section n'est pas celle d'un objet. */
    private Forme forme;
    private boolean lampe;

    private LecteurScene(String nomFichier) {
        chemin = FichierScene.trouver(nomFichier);
        fichier = chemin.equals(Paths.get(nomFichier)) ? nomFichier : chemin.toString();
        services = new Services();
        cles.put("lampe", Arrays.asList("position", "couleur"));
    }

    /**
     * @param nomFichier voir {@link FichierScene#trouver}
     * @param suivi reçoit la part lue du fichier, de 0 à 1
     * @throws SceneFautive si le fichier ne peut être utilisé
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     */
    public static SceneLue lire(String nomFichier, DoubleConsumer suivi) {
        return new LecteurScene(nomFichier).lire(suivi);
    }

    private SceneLue lire(DoubleConsumer suivi) {
        try (InputStream entree = FichierScene.ouvrir(chemin)) {
            lignes = new Lignes(entree, chemin.toFile().length(), suivi);
            Decoupage decoupage = new Decoupage();
            decoupage.parse(lignes, decoupage);
        } catch (InvalidFileFormatException e) {
            throw illisible(lignes.getTexte().trim());
        } catch (CharacterCodingException e) {
            throw refus(lignes.autreCodage() != null ? "fichier en " + lignes.autreCodage()
                    : "octets qui ne sont pas de l'UTF-8 : " + Texte.cite(lignes.getTexte().trim()),
                    "un fichier enregistré en UTF-8");
        } catch (Lignes.LigneTropLongue e) {
            throw new SceneFautive(SectionLue.message(fichier, lignes.getNumero(), null, null, "ligne trop longue",
                    "au plus " + (Lignes.LIGNE_MAX >> 20) + " Mo par ligne"), e);
        } catch (IOException e) {
            throw FichierScene.inutilisable(fichier,
                    FichierScene.pourquoi(e, "lecture impossible (" + ErreurSysteme.raison(e) + ")"), e);
        }
        for (Map.Entry<String, Variante> presente : services.variantes.entrySet()) {
            SectionLue donnee = sectionsVariantes.get(presente.getKey());
            lue.variantes.put(presente.getValue(), donnee != null ? donnee
                    : new SectionLue(fichier, presente.getValue().getSection(), 0, null));
        }
        return lue;
    }

    /** Découpage par ini4j, sans échappements, et traitement de chaque ligne. */
    private final class Decoupage extends IniParser implements IniHandler {

        /** Configure ini4j sans sa recherche de services. */
        Decoupage() {
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
            forme = services.formes.get(type);
            boolean variante = !lampe && forme == null;
            courante = new SectionLue(fichier, nom, ligne, cles(type));
            boolean presente = !variante || services.variantes.containsKey(type);
            if (!presente && !Services.varianteConnue(type)) {
                throw courante.fautive(ligne, null, "type de section inconnu", services.types());
            }
            origine = new Origine(nom, ligne);
            String ordinaire = forme == null ? type : forme.getSection();
            Origine deja = noms.putIfAbsent(
                    mot.equals(ordinaire) ? nom : ordinaire + nom.substring(mot.length()), origine);
            if (deja != null) {
                throw courante.fautive(ligne, null, "deux sections de ce nom, la première ligne " + deja.ligne,
                        "un nom différent pour chaque section");
            }
            SectionLue premiere = variante ? sectionsVariantes.put(type, courante) : null;
            if (premiere != null) {
                throw courante.fautive(ligne, null, "deuxième section de ce type, la première ligne "
                        + premiere.ligne, "une seule section " + mot);
            }
            if (!presente) {
                lue.avertissements.add(SectionLue.message(fichier, ligne, nom, null, "section laissée de côté",
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
                lue.lampes.add(new Lampe(courante.point("position"), courante.couleur("couleur", LUMIERE_MAX)));
                lue.origines.ajouter(lue.lampes.get(lue.lampes.size() - 1), origine);
            } else if (forme != null) {
                Objet3D objet = lireForme();
                lireMatiere(objet);
                lue.objets.add(objet);
                lue.origines.ajouter(objet, origine);
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

    private List<String> cles(String type) {
        if (forme != null && !cles.containsKey(type)) {
            List<String> siennes = new ArrayList<>(Arrays.asList(Objects.requireNonNull(forme.getCles(),
                    forme.getClass().getName() + ".getCles a rendu null")));
            siennes.addAll(CLES_MATIERE);
            cles.put(type, siennes);
        }
        return cles.get(type);
    }

    /** Lit l'objet de la section, sans sa matière. Une exception de la forme devient un refus de la section. */
    private Objet3D lireForme() {
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
                    + (refus ? Texte.cite(e.getMessage()) : Pile.cause(e, Pattern.quote(classe) + ".*")),
                    "des valeurs qui lui conviennent");
        }
    }

    /** Lit la matière d'un objet. Une clé absente garde la valeur que l'objet a reçue à sa création. */
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

    /** Refus d'une ligne qu'ini4j rejette : le message d'ini4j est en anglais et sans raison. */
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

    /** Refuse la ligne en cours. Elle appartient à la section en cours, sauf si elle en commence une autre. */
    private SceneFautive refus(String faute, String attendu) {
        String nom = courante == null || lignes.getTexte().trim().startsWith("[") ? null : courante.nom;
        return new SceneFautive(SectionLue.message(fichier, lignes.getNumero(), nom, null, faute, attendu));
    }
}
