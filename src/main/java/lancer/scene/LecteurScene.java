package lancer.scene;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.HashMap;
import java.util.Map;
import java.util.StringTokenizer;
import java.util.function.DoubleConsumer;
import java.util.function.UnaryOperator;
import lancer.SceneFautive;
import lancer.contrat.Variante;
import lancer.systeme.ErreurSysteme;
import lancer.texte.Ressemblance;
import lancer.texte.Texte;
import org.ini4j.Config;
import org.ini4j.InvalidFileFormatException;
import org.ini4j.spi.IniHandler;
import org.ini4j.spi.IniParser;

/** Lecture d'un fichier INI. ini4j ne fait que le découper en lignes, sans ses substitutions (CVE-2022-41404). */
public final class LecteurScene {

    /** Nombre de dossiers parents où une scène est aussi cherchée. */
    private static final int DOSSIERS_AU_DESSUS = 4;

    private final String fichier;
    private final LecteurSections sections = LecteurSections.getUnique();
    private final SceneLue lue;
    /** La ligne de chaque section, par son nom, où le type a son écriture ordinaire ; par son type, s'il est unique. */
    private final Map<String, Integer> noms = new HashMap<>();
    private Lignes lignes;
    private LecteurSections.Type type;
    private SectionLue courante;

    private LecteurScene(String nom, Path chemin) {
        fichier = chemin.toString();
        lue = new SceneLue(nom, chemin);
        for (Variante variante : sections.variantes) {
            lue.variantes.put(variante, new SectionLue(fichier, variante.getSection(), 0, null));
        }
    }

    /**
     * Le chemin de la scène. Un chemin relatif qui n'existe pas ici est cherché dans les quatre dossiers parents, du
     * plus proche au plus lointain.
     *
     * @throws SceneFautive s'il ne mène à aucun fichier
     */
    public static Path trouver(String fichier) {
        Path chemin;
        try {
            chemin = Paths.get(fichier);
        } catch (InvalidPathException e) {
            throw inutilisable(fichier, "nom de fichier impossible" + ErreurSysteme.horsLangue(fichier), e);
        }
        Path trouve = chemin;
        for (int k = 0; k < DOSSIERS_AU_DESSUS && !Files.exists(trouve); k++) {
            trouve = Paths.get("..").resolve(trouve);
        }
        if (!Files.exists(trouve)) {
            String ici = Paths.get("").toAbsolutePath().toString();
            String ou = " dans " + Texte.echappe(ici) + " et les " + DOSSIERS_AU_DESSUS + " dossiers au-dessus"
                    + ErreurSysteme.horsLangue(ici);
            throw inutilisable(fichier, "fichier introuvable" + (chemin.isAbsolute() ? "" : ou), null);
        }
        if (Files.isDirectory(trouve)) {
            throw inutilisable(trouve.toString(), "c'est un dossier", null);
        }
        return trouve;
    }

    static SceneFautive inutilisable(String fichier, String faute, Exception cause) {
        return new SceneFautive(SectionLue.message(fichier, 0, null, null, faute, "un fichier de scène"), cause);
    }

    /**
     * @param nomFichier voir {@link #trouver}
     * @param suivi reçoit la part lue du fichier, de 0 à 1
     * @throws SceneFautive si le fichier ne peut être utilisé
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     */
    public static SceneLue lire(String nomFichier, DoubleConsumer suivi) {
        return lire(nomFichier, suivi, entree -> entree);
    }

    /** Lit comme {@link #lire} une scène qui pourra être changée : son texte est gardé. */
    public static SceneLue lireEtGarder(String nomFichier, DoubleConsumer suivi) {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        SceneLue lue = lire(nomFichier, suivi, entree -> new FilterInputStream(entree) {
            @Override
            public int read(byte[] tampon, int debut, int nombre) throws IOException {
                int lus = super.read(tampon, debut, nombre);
                octets.write(tampon, debut, Math.max(0, lus));
                return lus;
            }
        });
        lue.texte = new TexteScene(octets.toByteArray());
        return lue;
    }

    private static SceneLue lire(String nomFichier, DoubleConsumer suivi, UnaryOperator<InputStream> garde) {
        long debut = System.nanoTime();
        LecteurScene lecteur = new LecteurScene(nomFichier, trouver(nomFichier));
        lecteur.lire(() -> garde.apply(Files.newInputStream(lecteur.lue.chemin)), suivi);
        lecteur.lue.dureeNs = System.nanoTime() - debut;
        return lecteur.lue;
    }

    /** @throws SceneFautive si ce texte, qui est ou sera celui de ce fichier, n'est pas celui d'une scène */
    static void verifier(String nom, Path chemin, TexteScene texte) {
        new LecteurScene(nom, chemin).lire(() -> new ByteArrayInputStream(texte.getOctets()), part -> { });
    }

    /** Ce qui s'ouvre pour être lu. */
    private interface Ouverture {
        InputStream ouvrir() throws IOException;
    }

    private void lire(Ouverture ouverture, DoubleConsumer suivi) {
        try (InputStream entree = ouverture.ouvrir()) {
            lignes = new Lignes(entree, lue.chemin.toFile().length(), suivi);
            Decoupage decoupage = new Decoupage();
            decoupage.parse(lignes, decoupage);
        } catch (InvalidFileFormatException e) {
            throw illisible(lignes.getTexte().trim());
        } catch (CharacterCodingException e) {
            throw refus("octets qui ne sont pas de l'UTF-8 : " + Texte.cite(lignes.getTexte().trim()),
                    "un fichier enregistré en UTF-8");
        } catch (IOException e) {
            String faute = "lecture impossible (" + ErreurSysteme.raison(e, fichier) + ")";
            throw lignes == null ? inutilisable(fichier, faute, e) : refus(faute, "un fichier de scène");
        }
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
            StringTokenizer mots = new StringTokenizer(nomEcrit, " \t");
            String mot = mots.nextToken();
            String nom = mot;
            while (mots.hasMoreTokens()) {
                nom += " " + mots.nextToken();
            }
            int ligne = lignes.getNumero();
            type = sections.trouver(mot);
            courante = new SectionLue(fichier, nom, ligne, type == null ? null : type.cles);
            if (type == null) {
                throw courante.fautive(ligne, null, "type de section inconnu" + Ressemblance.dire(mot),
                        sections.noms());
            }
            String ordinaire = mot.equals(type.nom) ? nom : type.nom + nom.substring(mot.length());
            Integer deja = noms.putIfAbsent(type.unique ? type.nom : ordinaire, ligne);
            if (deja != null) {
                throw courante.fautive(ligne, null, "section déjà donnée, ligne " + deja,
                        type.unique ? "une seule section " + type.nom : "un nom différent pour chaque section");
            }
        }

        @Override
        public void handleOption(String cle, String valeur) {
            courante.ajouter(cle, valeur, lignes.getNumero());
        }

        @Override
        public void endSection() {
            type.lecture.accept(courante, lue);
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

    /** Refus d'une ligne qu'ini4j rejette : le message d'ini4j est en anglais et sans raison. */
    private SceneFautive illisible(String texte) {
        if (courante == null) {
            return refus("texte avant toute section : " + Texte.cite(texte) + Ressemblance.dire(texte),
                    "d'abord une section seule sur sa ligne, par exemple [Sphere 1]");
        }
        return refus("ligne illisible : " + Texte.cite(texte) + Ressemblance.dire(texte),
                "clé=valeur, [Section], ou un commentaire seul sur sa ligne, après ; ou #");
    }

    /** Refuse la ligne en cours. */
    private SceneFautive refus(String faute, String attendu) {
        return courante == null
                ? new SceneFautive(SectionLue.message(fichier, lignes.getNumero(), null, null, faute, attendu))
                : courante.fautive(lignes.getNumero(), null, faute, attendu);
    }
}
