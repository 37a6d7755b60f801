package lancer.lecture;

import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.SceneFautive;
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
 * D'un fichier INI aux objets, aux lampes et aux sections des variantes. ini4j ne sert ici qu'à découper les lignes
 * ({@code IniParser}) ; ses substitutions, par où passe la CVE-2022-41404, ne sont jamais appelées.
 */
public final class LecteurScene {

    private static final double LUMIERE_MAX = 1e6;
    private static final double NS_MAX = 1e9;

    /** Nombre de dossiers au-dessus de celui d'où l'on part où une scène est cherchée aussi. */
    private static final int DOSSIERS_AU_DESSUS = 4;
    private static final String UNE_SCENE = "un fichier de scène";

    /** Nombre de couleurs retenues à la fois : au-delà, elles ne se répètent pas. */
    private static final int PALETTE_MAX = 256;

    private static final String[] CLES_LAMPE = {"position", "couleur"};

    /** La scène comme on l'a nommée, ou le chemin où elle a été trouvée s'il est autre. */
    private String fichier;
    private final Services services = new Services();
    private final List<Objet3D> objets = new ArrayList<>();
    private final List<Lampe> lampes = new ArrayList<>();
    private final List<String> avertissements = new ArrayList<>();
    private final Map<String, Section> sectionsVariantes = new HashMap<>();
    /** Chaque nom de section, et sa ligne. */
    private final Map<String, Integer> noms = new HashMap<>();
    /** Les couleurs déjà lues : une scène d'un million de sphères n'en a que quelques-unes. */
    private final Map<Couleur, Couleur> palette = new HashMap<>();
    private final Modele modele = new Modele();
    private final List<Variante> variantesLibres = new ArrayList<>();
    private Section courante;
    /** Ce que décrit la section en cours, {@code null} si ce n'est pas un objet. */
    private TypeObjet objet;

    private LecteurScene(String fichier) {
        this.fichier = fichier;
    }

    /**
     * Lit un fichier en entier, et installe les variantes présentes, chacune avec sa section.
     *
     * @throws SceneFautive si le fichier ne peut être utilisé, ou si deux variantes veulent le même contrat
     */
    public static LecteurScene lire(String fichier) {
        LecteurScene lecteur = new LecteurScene(fichier);
        lecteur.lire();
        lecteur.installer();
        return lecteur;
    }

    private void lire() {
        Lignes lignes = null;
        Path chemin = trouver(fichier);
        if (!chemin.equals(Paths.get(fichier))) {
            fichier = chemin.toString();
        }
        try (InputStream entree = ouvrir(chemin)) {
            lignes = new Lignes(entree);
            new Decoupeur().parse(lignes, new Sections(lignes));
        } catch (InvalidFileFormatException e) {
            throw illisible(lignes.getTexte().trim(), lignes.getNumero());
        } catch (CharacterCodingException e) {
            throw pasUtf8(lignes, e);
        } catch (Lignes.LigneTropLongue e) {
            throw refus(lignes.getNumero(), null, "ligne trop longue",
                    "au plus " + (Lignes.LIGNE_MAX >> 20) + " Mo par ligne", e);
        } catch (IOException e) {
            throw inutilisable(e);
        }
    }

    private void installer() {
        for (Variante variante : services.variantes()) {
            String type = variante.getSection();
            Section section = sectionsVariantes.get(Texte.minuscules(type));
            if (section == null) {
                section = new Section(fichier, type, 0);
                variantesLibres.add(variante);
            }
            variante.installer(section, modele);
            section.verifierCles();
        }
    }

    /** Par {@code java.io}, déjà chargé ; si cela échoue, par {@code java.nio}, qui dit pourquoi. */
    private static InputStream ouvrir(Path chemin) throws IOException {
        try {
            return new FileInputStream(chemin.toFile());
        } catch (FileNotFoundException e) {
            return Files.newInputStream(chemin);
        }
    }

    /**
     * Le chemin de la scène : tel quel, ou s'il est relatif et n'existe pas ici, depuis le plus proche des quatre
     * dossiers au-dessus d'où il mène à quelque chose.
     *
     * @throws SceneFautive s'il n'existe pas, ou n'est pas un fichier
     */
    public static Path trouver(String fichier) {
        Path chemin;
        try {
            chemin = Paths.get(fichier);
        } catch (InvalidPathException e) {
            String faute = "nom de fichier impossible" + Texte.horsLangue(fichier);
            throw new SceneFautive(Section.message(fichier, 0, null, null, faute, UNE_SCENE), e);
        }
        Path trouve = chemin;
        for (int k = 0; k < DOSSIERS_AU_DESSUS && !chemin.isAbsolute() && !Files.exists(trouve); k++) {
            trouve = Paths.get("..").resolve(trouve);
        }
        if (!Files.exists(trouve)) {
            throw new SceneFautive(Section.message(fichier, 0, null, null, absente(chemin), UNE_SCENE));
        }
        if (Files.isDirectory(trouve)) {
            String dossier = trouve.equals(chemin) ? fichier : trouve.toString();
            throw new SceneFautive(Section.message(dossier, 0, null, null, "c'est un dossier", UNE_SCENE));
        }
        return trouve;
    }

    /** Pourquoi ce chemin ne mène à rien, et d'où il a été suivi. */
    private static String absente(Path chemin) {
        try {
            chemin.toRealPath();
        } catch (NoSuchFileException e) {
            // dit plus bas
        } catch (IOException e) {
            return e instanceof AccessDeniedException ? "lecture interdite" : Texte.panne(e);
        }
        Path ici = Paths.get("").toAbsolutePath();
        int plusHaut = Math.min(DOSSIERS_AU_DESSUS, ici.getNameCount());
        return "fichier introuvable" + (chemin.isAbsolute() ? "" : " dans " + Texte.echappe(ici.toString())
                + (plusHaut == 0 ? "" : plusHaut == 1 ? " et le dossier au-dessus"
                        : " et les " + plusHaut + " dossiers au-dessus")
                + Texte.horsLangue(ici.toString()));
    }

    public List<Objet3D> getObjets() {
        return objets;
    }

    public List<Lampe> getLampes() {
        return lampes;
    }

    /** Ce que les variantes présentes ont changé. */
    public Modele getModele() {
        return modele;
    }

    /** Ce que la lecture a laissé de côté, une ligne chacun. */
    public List<String> getAvertissements() {
        return avertissements;
    }

    /** Les variantes présentes dont le fichier n'a pas la section. */
    public List<Variante> getVariantesLibres() {
        return variantesLibres;
    }

    /**
     * Ini4j sans rien de ce qu'un fichier inconnu pourrait détourner ; le constructeur évite la recherche de services.
     */
    private static final class Decoupeur extends IniParser {
        Decoupeur() {
            Config config = new Config();
            config.setEscape(false);
            config.setEscapeNewline(false);
            config.setInclude(false);
            config.setTree(false);
            config.setGlobalSection(false);
            config.setUnnamedSection(false);
            config.setEmptyOption(false);
            config.setEmptySection(true);
            config.setLowerCaseOption(false);
            config.setLowerCaseSection(false);
            setConfig(config);
        }
    }

    /** Ce qu'ini4j appelle à chaque ligne. */
    private final class Sections implements IniHandler {

        private final Lignes lignes;

        Sections(Lignes lignes) {
            this.lignes = lignes;
        }

        @Override
        public void startSection(String nom) {
            commencer(nom, lignes.getNumero());
        }

        @Override
        public void handleOption(String cle, String valeur) {
            courante.ajouter(cle, valeur, lignes.getNumero());
        }

        @Override
        public void endSection() {
            terminer();
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

    private void commencer(String nomEcrit, int ligne) {
        if (nomEcrit.indexOf(']') >= 0) {
            throw illisible("[" + nomEcrit + "]", ligne);
        }
        String nom = unSeulBlanc(nomEcrit);
        String type = Section.type(nom);
        boolean lampe = Texte.memeMot(type, "Lampe");
        objet = lampe ? null : services.objet(type);
        boolean variante = !lampe && objet == null;
        String cle = Texte.minuscules(type);
        courante = new Section(fichier, nom, ligne, lampe ? CLES_LAMPE : variante ? null : objet.getCles());
        if (variante && !services.variantePresente(type) && !Services.varianteConnue(type)) {
            throw courante.fautive(ligne, null, "type de section inconnu" + Texte.imitations(type), services.types());
        }
        Integer deja = noms.putIfAbsent(cle + nom.substring(type.length()), ligne);
        if (deja != null) {
            throw courante.fautive(ligne, null, "deux sections de ce nom, la première ligne " + deja,
                    "un nom différent pour chaque section");
        }
        Section premiere = variante ? sectionsVariantes.put(cle, courante) : null;
        if (premiere != null) {
            throw courante.fautive(ligne, null, "deuxième section de ce type, la première ligne " + premiere.getLigne(),
                    "une seule section " + type);
        }
        if (variante && !services.variantePresente(type)) {
            avertissements.add(Section.message(fichier, ligne, nom, null, "section laissée de côté",
                    "la variante qui la lit, java -jar " + cle + "/target/" + cle + ".jar"));
        }
    }

    private void terminer() {
        if (objet != null) {
            Objet3D lu = objet.lire(courante);
            lireMatiere(lu);
            objets.add(lu);
        } else if (Texte.memeMot(courante.getType(), "Lampe")) {
            lampes.add(new Lampe(courante.point("position"), courante.couleur("couleur", LUMIERE_MAX)));
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

    private static String unSeulBlanc(String nom) {
        StringBuilder s = new StringBuilder(nom.length());
        for (int i = 0; i < nom.length(); i++) {
            char c = nom.charAt(i);
            if (!Section.blanc(c)) {
                s.append(c);
            } else if (!Section.blanc(nom.charAt(i - 1))) {
                s.append(' ');
            }
        }
        return s.toString();
    }

    /** Le message d'ini4j est anglais, et ne dit pas pourquoi. */
    private SceneFautive illisible(String texte, int ligne) {
        String cite = " : " + Texte.cite(texte);
        if (texte.startsWith("[")) {
            int crochet = texte.indexOf(']');
            return crochet < 0 ? refus(ligne, null, "crochet non fermé" + cite, "par exemple [Sphere 1]", null)
                    : crochet < texte.length() - 1 ? refus(ligne, null, "du texte après le crochet" + cite,
                            "[Section] seule sur sa ligne, un commentaire sur la sienne", null)
                    : refus(ligne, null, "section sans nom" + cite, "par exemple [Sphere 1]", null);
        }
        if (courante == null) {
            return refus(ligne, null, (texte.indexOf('=') > 0 ? "clé" : "texte") + " avant toute section" + cite,
                    "d'abord une section, par exemple [Sphere 1]", null);
        }
        return refus(ligne, courante.getNom(), "ligne illisible" + cite,
                "clé=valeur, [Section], ou un commentaire seul sur sa ligne, après ; ou #", null);
    }

    private SceneFautive pasUtf8(Lignes lignes, IOException cause) {
        String attendu = "un fichier enregistré en UTF-8";
        if (lignes.estUtf16()) {
            return refus(lignes.getNumero(), null, "fichier en UTF-16", attendu, cause);
        }
        String texte = lignes.getTexte().trim();
        boolean dansSection = courante != null && !texte.startsWith("[");
        return refus(lignes.getNumero(), dansSection ? courante.getNom() : null,
                "octets qui ne sont pas de l'UTF-8 : " + Texte.cite(texte), attendu, cause);
    }

    private SceneFautive refus(int ligne, String nom, String faute, String attendu, Throwable cause) {
        return new SceneFautive(Section.message(fichier, ligne, nom, null, faute, attendu), cause);
    }

    private SceneFautive inutilisable(IOException e) {
        String faute = e instanceof NoSuchFileException || e instanceof FileNotFoundException ? "fichier introuvable"
                : e instanceof AccessDeniedException ? "lecture interdite"
                : "lecture impossible (" + Texte.panne(e) + ")";
        return refus(0, null, faute, UNE_SCENE, e);
    }
}
