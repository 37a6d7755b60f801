package lancer.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.HashMap;
import java.util.Map;
import java.util.StringJoiner;
import java.util.StringTokenizer;
import java.util.function.DoubleConsumer;
import java.util.zip.CRC32;
import java.util.zip.CheckedInputStream;
import lancer.Lampe;
import lancer.SceneFautive;
import lancer.contrat.Forme;
import lancer.contrat.Variante;
import lancer.texte.ErreurSysteme;
import lancer.texte.Texte;
import org.ini4j.Config;
import org.ini4j.InvalidFileFormatException;
import org.ini4j.spi.IniHandler;
import org.ini4j.spi.IniParser;

/** Lecture d'un fichier INI. ini4j ne fait que le découper en lignes, sans ses substitutions (CVE-2022-41404). */
public final class LecteurScene {

    private final Path chemin;
    /** Le nom demandé de la scène, ou le chemin où elle a été trouvée. */
    private final String fichier;
    private final LecteurSections sections = new LecteurSections();
    private final SceneLue lue;
    /** Les sections de variantes, et celle de la caméra, par type. */
    private final Map<String, SectionLue> uniques = new HashMap<>();
    /** La ligne de chaque section, par son nom ; le type y a son écriture ordinaire. */
    private final Map<String, Integer> noms = new HashMap<>();
    private Lignes lignes;
    private SectionLue courante;
    /** Vrai si la section en cours est celle d'une variante, ou celle de la caméra. */
    private boolean variante;
    private boolean camera;

    private LecteurScene(String nomFichier) {
        chemin = FichierScene.trouver(nomFichier);
        fichier = chemin.equals(Paths.get(nomFichier)) ? nomFichier : chemin.toString();
        lue = new SceneLue(chemin);
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
        CRC32 somme = new CRC32();
        try (InputStream entree = new CheckedInputStream(FichierScene.ouvrir(chemin), somme)) {
            lignes = new Lignes(entree, chemin.toFile().length(), suivi);
            Decoupage decoupage = new Decoupage();
            decoupage.parse(lignes, decoupage);
        } catch (InvalidFileFormatException e) {
            throw illisible(lignes.getTexte().trim());
        } catch (CharacterCodingException e) {
            throw refus("octets qui ne sont pas de l'UTF-8 : " + Texte.cite(lignes.getTexte().trim()),
                    "un fichier enregistré en UTF-8");
        } catch (Lignes.LigneTropLongue e) {
            throw refus("ligne trop longue", "au plus " + (Lignes.LIGNE_MAX >> 20) + " Mo par ligne");
        } catch (IOException e) {
            throw FichierScene.inutilisable(fichier, "lecture impossible (" + ErreurSysteme.raison(e) + ")", e);
        }
        for (Map.Entry<String, Variante> presente : sections.variantes.entrySet()) {
            SectionLue donnee = uniques.get(presente.getKey());
            lue.variantes.put(presente.getValue(), donnee != null ? donnee
                    : new SectionLue(fichier, presente.getValue().getSection(), 0, null));
        }
        lue.somme = somme.getValue();
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
            StringJoiner nom = new StringJoiner(" ");
            for (StringTokenizer mots = new StringTokenizer(nomEcrit, " \t"); mots.hasMoreTokens();) {
                nom.add(mots.nextToken());
            }
            commencer(nom.toString());
        }

        @Override
        public void handleOption(String cle, String valeur) {
            courante.ajouter(cle, valeur, lignes.getNumero());
        }

        @Override
        public void endSection() {
            if (camera) {
                lue.cadrage = LecteurSections.lireCamera(courante);
            } else if (!variante) {
                Object chose = sections.lire(courante);
                lue.ajouter(chose, courante.nom, courante.ligne,
                        courante.getLigne(chose instanceof Lampe ? "position" : "centre"));
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

    private void commencer(String nom) {
        String mot = LecteurSections.mot(nom);
        String type = Texte.minuscules(mot);
        int ligne = lignes.getNumero();
        Forme forme = sections.formes.get(type);
        variante = !sections.cles.containsKey(type);
        camera = type.equals(LecteurSections.CAMERA);
        courante = new SectionLue(fichier, nom, ligne, sections.cles.get(type));
        boolean presente = !variante || sections.variantes.containsKey(type);
        if (!presente && !LecteurSections.varianteConnue(type)) {
            throw courante.fautive(ligne, null, "type de section inconnu", sections.types());
        }
        String ordinaire = forme == null ? type : forme.getSection();
        Integer deja = noms.putIfAbsent(
                mot.equals(ordinaire) ? nom : ordinaire + nom.substring(mot.length()), ligne);
        if (deja != null) {
            throw courante.fautive(ligne, null, "deux sections de ce nom, la première ligne " + deja,
                    "un nom différent pour chaque section");
        }
        SectionLue premiere = variante || camera ? uniques.put(type, courante) : null;
        if (premiere != null) {
            throw courante.fautive(ligne, null, "deuxième section de ce type, la première ligne " + premiere.ligne,
                    "une seule section " + mot);
        }
        if (!presente) {
            lue.avertissements.add(SectionLue.message(fichier, ligne, nom, null, "section laissée de côté",
                    "la variante qui la lit, java -jar " + type + "/target/" + type + ".jar"));
        }
    }

    /** Refus d'une ligne qu'ini4j rejette : le message d'ini4j est en anglais et sans raison. */
    private SceneFautive illisible(String texte) {
        String cite = " : " + Texte.cite(texte);
        if (texte.startsWith("[")) {
            return refus("section illisible" + cite, "par exemple [Sphere 1], seule sur sa ligne");
        }
        return courante == null ? refus("texte avant toute section" + cite,
                "d'abord une section, par exemple [Sphere 1]") : refus("ligne illisible" + cite,
                "clé=valeur, [Section], ou un commentaire seul sur sa ligne, après ; ou #");
    }

    /** Refuse la ligne en cours. Elle appartient à la section en cours, sauf si elle en commence une autre. */
    private SceneFautive refus(String faute, String attendu) {
        String nom = courante == null || lignes.getTexte().trim().startsWith("[") ? null : courante.nom;
        return new SceneFautive(SectionLue.message(fichier, lignes.getNumero(), nom, null, faute, attendu));
    }
}
