package lancer.commande;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Field;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.regex.Pattern;
import lancer.Constantes;
import lancer.systeme.Echec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** La ligne de commande : ce qu'elle demande, ou la ligne qui dit pourquoi non. */
class OptionsTest {

    private static final String FENETRE =
            "| --auto ne sert pas seule ; attendu : avec elle, --image FICHIER.png ou --lineaire FICHIER.pfm";
    private static final String SANS_SCENE = "| aucune scène à dessiner ; attendu : un fichier, par exemple scenes/scene1.ini";

    /** Les arguments, séparés par un blanc ; {@code ''} en est un, vide. */
    private static String[] arguments(String ligne) {
        String[] mots = ligne.split(" ");
        for (int k = 0; k < mots.length; k++) {
            mots[k] = mots[k].equals("''") ? "" : mots[k];
        }
        return mots;
    }

    private static void verifierRefus(String ligne, String message) {
        Echec e = assertThrows(Echec.class, () -> Options.lire(arguments(ligne)), ligne);
        assertEquals(Echec.DEMANDE, e.code);
        assertEquals(message, e.getMessage());
    }

    /** La console d'un Windows français, où « œ » n'existe pas. */
    @Test
    void lAideSEcritDansUneConsoleCp850() {
        assertTrue(Charset.forName("IBM850").newEncoder().canEncode(Options.getAide()));
    }

    @Test
    void sansOptionLesValeursSontCellesDuCours() {
        Reglages o = Options.lire();
        assertNull(o.scene);
        assertFalse(o.sansFenetre());
        assertEquals(Constantes.LARGEUR_IMAGE, o.get(Option.TAILLE).x);
        assertEquals(Constantes.HAUTEUR_IMAGE, o.get(Option.TAILLE).y);
        assertEquals(Constantes.MAX_REFLETS, o.get(Option.REFLETS));
        assertEquals(1.0 / 1024, o.get(Option.SEUIL));
        assertEquals(Math.min(1024, Runtime.getRuntime().availableProcessors()), o.get(Option.FILS));
        assertEquals(1, o.get(Option.REPETER));
        assertFalse(o.get(Option.STATISTIQUES) || o.estDonnee(Option.PIXEL) || o.estDonnee(Option.AUTO) || o.estDonnee(Option.REFLETS)
                || o.estDonnee(Option.SEUIL));
        o = Options.lire("--reflets", "5", "--seuil=0.0009765625");
        assertTrue(o.estDonnee(Option.REFLETS) && o.estDonnee(Option.SEUIL), "ce qui est fixé à la main se sait");
    }

    @Test
    void lOrdreEtLaFormeDesOptionsNImportentPas() {
        String[][] paires = {{"--image", "a.png"}, {"--lineaire", "b.pfm"}, {"--taille", "30x20"}, {"--reflets", "7"},
            {"--seuil", ".25"}, {"--fils", "3"}, {"--repeter", "2"}, {"--statistiques"}, {"s.ini"}};
        assertEquals("a=b.png", Options.lire("--image=a=b.png", "s.ini").get(Option.IMAGE), "le signe égal ne coupe qu'une fois");
        assertEquals("--x.png", Options.lire("--image=--x.png", "s.ini").get(Option.IMAGE));
        Random hasard = new Random(6);
        for (int essai = 0; essai < 200; essai++) {
            List<String[]> melange = new ArrayList<>(List.of(paires));
            Collections.shuffle(melange, hasard);
            List<String> arguments = new ArrayList<>();
            for (String[] paire : melange) {
                if (paire.length == 2 && hasard.nextBoolean()) {
                    arguments.add(paire[0] + "=" + paire[1]);
                } else {
                    arguments.addAll(List.of(paire));
                }
            }
            Reglages o = Options.lire(arguments.toArray(new String[0]));
            assertEquals(List.of("a.png", "b.pfm", 30, 20, 7, 0.25, 3, 2, true, "s.ini"), List.of(o.get(Option.IMAGE),
                    o.get(Option.LINEAIRE), o.get(Option.TAILLE).x, o.get(Option.TAILLE).y, o.get(Option.REFLETS), o.get(Option.SEUIL),
                    o.get(Option.FILS), o.get(Option.REPETER), o.get(Option.STATISTIQUES), o.scene), arguments.toString());
        }
    }

    @ParameterizedTest
    @CsvSource({
        "--taille 1x1", "--taille 16384x1", "--taille 1x16384", "--taille 10000x10000", "--taille 16384x6103", "--taille 0800x0600",
        "--reflets 0", "--reflets 1000", "--fils 1", "--fils 1024", "--repeter 1", "--repeter 100000",
        "--seuil 0", "--seuil 1e308", "--seuil 1e-400", "--seuil +.5E-3", "--seuil 5.", "--seuil -0", "--seuil 4.9e-324",
        "--image a=b.png s.ini", "--image=a=b.png s.ini", "--image=--x.png s.ini", "--image -x.png s.ini", "--image .png s.ini",
        "--image A.PNG --lineaire=a.Pfm s.ini", "a=b.ini", "s.ini --statistiques"})
    void uneValeurAuBordEstPermise(String ligne) {
        Options.lire(arguments(ligne));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--bidule", "-x", "-", "--", "--Image", "--imag", "--IMAGE=x", "-image", "--image-png",
        "--bidule=3", "--fils4"})
    void uneOptionInconnueEstRefusee(String option) {
        String nom = option.startsWith("--") ? option.replaceAll("=.*", "") : option;
        verifierRefus("s.ini " + option, "option inconnue : « " + nom + " » ; attendu : une de celles que montre --aide");
    }

    /** Une option, des valeurs impossibles, et ce qui est attendu d'elles et de l'option sans sa valeur. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "--image | a a.jpg a.pfm a.png/ png /dev/stdout /dev/fd/1 | un fichier dont le nom finit par .png",
        "--lineaire | a.png /dev/stdout a.pfm.gz | un fichier dont le nom finit par .pfm",
        "--taille | 0x1 1x0 16385x1 1x16385 10001x10000 16384x16384 800 800x x600 800X600 800*600 800x600x1 -1x5 +1x5 1.5x2 1e2x3 800,600 "
                + "99999999999999999999x1 axb 800×600 0x10x0 "
                + "| LARGEURxHAUTEUR, par exemple 800x600, de 1 à 16384 chacune, et au plus 100000000 pixels",
        "--reflets | -1 1001 5.0 cinq 4294967296 18446744073709551616 +5 | un entier de 0 à 1000",
        "--fils | 0 1025 -2 ٣ | un entier de 1 à 1024",
        "--repeter | 0 100001 1e3 | un entier de 1 à 100000",
        "--seuil | -1 -1e-300 1e400 NaN Infinity 0,5 0x1 1d un . | un nombre positif ou nul, par exemple 0.001",
        "--auto | 1 erreur erreur= erreur=0 erreur=0.001 erreur=256 erreur=-1 erreur=NaN erreur=1e400 erreur=0,5 erreur=1s Erreur=1 "
                + "erreur==1 temps=1s prix=3 erreur=1,temps=1s | erreur=E, de 0.01 à 255 niveaux, par exemple erreur=1",
        "--pixel | 1 1, ,1 , 1,2,3 -1,5 5,-1 +1,5 1.0,2 1;2 1x2 a,b 0x1,2 ٣,1 1e2,3 "
                + "99999999999999999999,1 4294967296,0 0,18446744073709551616 "
                + "| X,Y, colonne et ligne d'un pixel depuis le coin en haut à gauche, par exemple 421,426",
        "--sans | , Brume, ,Brume Brume,,Blinn | des noms de variantes séparés par une virgule, par exemple Brume,Blinn",
        "--etape | P | une étape du cours : lambert, phong, ombres ou reflets",
        "--vue | x | une vue : normales, distance, lampes, rayons ou marge"})
    void uneValeurImpossibleOuAbsenteEstRefusee(String nom, String valeurs, String attendu) {
        for (String sans : List.of("", "=", " ''", " --statistiques")) {
            verifierRefus("s.ini " + nom + sans, "option sans sa valeur : " + nom + " ; attendu : " + attendu);
        }
        for (String valeur : valeurs.split(" ")) {
            String message = "valeur impossible pour " + nom + " : « " + valeur + " » ; attendu : " + attendu;
            verifierRefus("s.ini " + nom + " " + valeur, message);
            verifierRefus(nom + "=" + valeur + " s.ini", message);
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "--vue rayons s.ini | --vue ne sert pas seule ; attendu : avec elle, --image FICHIER.png",
        "--vue rayons --image a.png s.ini --comparer b.png | --comparer ne va pas avec --vue ; attendu : l'une ou l'autre",
        "--auto erreur=1 " + FENETRE, "--auto erreur=1 s.ini " + FENETRE,
        "--pixel=800,0 s.ini | valeur impossible pour --pixel : « 800,0 » ; attendu : un pixel de l'image, de 0,0 à 799,599",
        "--pixel 7,7 --taille=9x7 s.ini | valeur impossible pour --pixel : « 7,7 » ; attendu : un pixel de l'image, de 0,0 à 8,6",
        "--pixel 1,1 " + SANS_SCENE, "--image a.png " + SANS_SCENE, "--lineaire=a.pfm " + SANS_SCENE,
        "--statistiques=oui | valeur impossible pour --statistiques : « oui » ; attendu : aucune valeur",
        "--aide=oui | valeur impossible pour --aide : « oui » ; attendu : aucune valeur",
        "--bidule --aide | option inconnue : « --bidule » ; attendu : une de celles que montre --aide",
        "a.ini --fils 2 b.ini | plusieurs scènes : « a.ini » et « b.ini » ; attendu : une seule",
        "--pixel 421 426 a.ini | plusieurs scènes : « 426 » et « a.ini » ; attendu : une seule, et entre guillemets, pour PowerShell, la "
            + "valeur de --pixel",
        "a.ini a.ini | plusieurs scènes : « a.ini » et « a.ini » ; attendu : une seule",
        "'' --image a.png " + SANS_SCENE})
    void uneDemandeImpossibleEstRefusee(String ligne, String message) {
        verifierRefus(ligne, message);
    }

    @ParameterizedTest
    @CsvSource({"--pixel 1;1, --image a.png", "--pixel 1;1, --image=a.png", "--pixel 1;1, --lineaire a.pfm", "--auto erreur=1, --pixel 1;1",
        "--pixel=1;1, --repeter 1", "--pixel 1;1, --repeter=3", "--vue rayons, --pixel 1;1",
        "--vue rayons --image a.png, --lineaire a.pfm", "--auto erreur=1 --image a.png, --vue rayons"})
    void deuxOptionsQuiNeVontPasEnsembleSontRefusees(String une, String autre) {
        String message = une.replaceAll("[ =].*", "") + " ne va pas avec " + autre.replaceAll("[ =].*", "")
                + " ; attendu : l'une ou l'autre";
        verifierRefus((une + " s.ini " + autre).replace(';', ','), message);
        verifierRefus((autre + " " + une).replace(';', ','), message);
    }

    @ParameterizedTest
    @CsvSource({"erreur=1, 1", "erreur=0.01, 0.01", "erreur=255, 255", "erreur=.5, 0.5"})
    void uneErreurPeutEtreVoulue(String souhait, double erreur) {
        assertEquals(erreur, Options.lire("--auto", souhait, "--image=a.png", "s.ini").get(Option.AUTO));
        assertEquals(erreur, Options.lire("--lineaire=a.pfm", "s.ini", "--auto=" + souhait).get(Option.AUTO));
    }

    @ParameterizedTest
    @CsvSource({"--pixel 421;426, 421, 426", "--pixel=0;0, 0, 0", "--pixel 799;599, 799, 599", "--pixel 30;40 --taille 31x41, 30, 40",
        "--taille=16384x1 --pixel=016383;0, 16383, 0"})
    void unPixelDeLImagePeutEtreDemande(String ligne, int x, int y) {
        Reglages o = Options.lire(arguments(ligne.replace(';', ',') + " s.ini"));
        assertEquals(List.of(x, y), List.of(o.get(Option.PIXEL).x, o.get(Option.PIXEL).y));
        assertTrue(o.estDonnee(Option.PIXEL) && o.sansFenetre());
    }

    @Test
    void laDemandeDAideLEmporteSurLaSuite() {
        for (String demande : new String[] {"--aide", "--help", "-h"}) {
            assertTrue(Options.lire("--image", "a.png", demande, "--bidule").get(Option.AIDE));
        }
        assertTrue(Options.lire("--version").get(Option.VERSION));
        assertTrue(Options.lire("--auto", "erreur=1", "--aide").get(Option.AIDE));
        assertTrue(Options.lire("--pixel", "9999,1", "--aide").get(Option.AIDE));
    }

    @Test
    void leTexteCiteEstCourtEtSansCaractereDeControle() {
        String message = assertThrows(Echec.class, () -> Options.lire("--fils", "\u001b" + "z".repeat(300))).getMessage();
        assertTrue(message.startsWith("valeur impossible pour --fils : « \\u001bzzz"), message);
        assertTrue(message.length() < 150, message);
    }

    @Test
    void chaqueOptionEstDansLAideEtDansSaPage() throws IOException {
        String page = Files.readString(Path.of("docs/options.md"));
        for (Option<?> option : Option.TABLE) {
            Pattern mot = Pattern.compile("(?<![\\w-])" + option.nom + "(?![\\w-])");
            assertTrue(mot.matcher(Options.getAide()).find(), option.nom + " n'est pas dans l'aide");
            assertTrue(mot.matcher(page).find(), option.nom + " n'est pas dans docs/options.md");
        }
        assertTrue(Option.TABLE.size() > 18, Option.TABLE.size() + " options");
    }

    @Test
    void touteOptionEstDansLaTable() throws IllegalAccessException {
        for (Field champ : Option.class.getFields()) {
            assertTrue(champ.getType() != Option.class || Option.TABLE.contains(champ.get(null)), champ.getName());
        }
    }

    private static <T> void relire(Option<T> option, String texte) {
        T valeur = option.lire(texte);
        assertEquals(valeur, option.lire(option.ecrire(valeur)), option.nom + " " + texte);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"--image | A b.PNG", "--lineaire | a.pfm", "--taille | 030x20", "--pixel | 3,4", "--etape | phong",
        "--vue | marge", "--reflets | 0007", "--seuil | +.123456789E-5", "--fils | 2", "--repeter | 9", "--sans | Blinn,brume",
        "--auto | erreur=.5", "--part | 0.7%", "--simple | ''", "--statistiques | ''"})
    void uneValeurEcriteSeRelitEtNeSeDonneQuUneFois(String nom, String texte) {
        relire(Option.TABLE.stream().filter(option -> option.nom.equals(nom)).findFirst().get(), texte);
        String[] deux = texte.isEmpty() ? new String[] {nom, nom} : new String[] {nom + "=" + texte, nom, texte};
        assertEquals("option donnée deux fois : " + nom + " ; attendu : une seule fois chaque option",
                assertThrows(Echec.class, () -> Options.lire(deux)).getMessage());
    }
}
