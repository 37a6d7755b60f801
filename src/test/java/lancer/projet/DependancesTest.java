package lancer.projet;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.util.TreeSet;
import java.util.stream.Collectors;
import lancer.Main;
import lancer.essai.Essai;
import org.junit.jupiter.api.Test;

/** Ce qui dépend de quoi, lu dans les classes compilées. */
class DependancesTest {

    private static final JavaClasses CLASSES = new ClassFileImporter().importPath(Essai.origine(Main.class));

    private static final String JAVA = "java\\.(?!awt).*";
    private static final String COURS = JAVA + "|lancer\\.[A-Z].*|";

    /** Le nom de la classe du fichier où celle-ci est écrite. */
    private static String nom(JavaClass classe) {
        return classe.getBaseComponentType().getName().replaceFirst("\\$.*", "");
    }

    private static String paquet(String nom) {
        return nom.substring(0, Math.max(0, nom.lastIndexOf('.')));
    }

    /** Les classes dont le nom est {@code classes} ne se servent que de leurs voisines et de celles dont le nom est {@code permis}. */
    private static void verifier(String classes, String permis) {
        assertEquals(new TreeSet<>(), CLASSES.stream().filter(c -> nom(c).matches(classes))
                .flatMap(c -> c.getDirectDependenciesFromSelf().stream().map(d -> nom(d.getTargetClass()))
                        .filter(n -> n.contains(".") && !paquet(n).equals(paquet(nom(c))) && !n.matches(permis))
                        .map(n -> nom(c) + " nomme " + n))
                .collect(Collectors.toCollection(TreeSet::new)));
    }

    @Test
    void lesClassesDuCoursNeDependentQueDesContratsEtDeLaPrecision() {
        String permis = JAVA + "|lancer\\.(contrat|precision)\\..*";
        verifier("lancer\\.(?!Main|Scene|Lancer)\\w+|lancer\\.SceneFautive", permis);
        verifier("lancer\\.Lancer", permis + "|lancer\\.fils\\..*");
        verifier("lancer\\.Scene", permis + "|lancer\\.scene\\.(LecteurScene|SceneLue)");
    }

    @Test
    void lesContratsNeDependentQueDuCoursEtDesTextes() {
        verifier("lancer\\.contrat\\..*", COURS + "lancer\\.texte\\..*");
        verifier("lancer\\.precision\\..*", COURS);
        verifier("lancer\\.texte\\..*", JAVA);
        verifier("lancer\\.systeme\\..*", JAVA + "|lancer\\.texte\\..*");
        verifier("lancer\\.fils\\..*", COURS + "lancer\\.(contrat|texte)\\..*");
    }

    @Test
    void laCommandeNeDependQueDesContratsEtDesTextes() {
        verifier("lancer\\.commande\\..*", JAVA + "|lancer\\.(Constantes|SceneFautive)|lancer\\.(contrat|texte|systeme)\\..*");
    }

    @Test
    void laRechercheRapideNeSaitRienDesSortiesNiDeLaCommande() {
        verifier("lancer\\.rapide\\..*", COURS + "lancer\\.(contrat|precision|fils)\\..*");
    }

    @Test
    void leChoixDesReglagesNeSaitRienDesSortiesNiDesVariantes() {
        verifier("lancer\\.auto\\..*",
                COURS + "lancer\\.contrat\\..*|lancer\\.fils\\.Atelier|lancer\\.commande\\.(Reglages|Option|Etape)");
        String saufCeuxQuiLeDemandent = "(?!Main|dessin\\.(Dessin|Rapport)|fenetre\\.).*";
        verifier("lancer\\." + saufCeuxQuiLeDemandent, "(?!lancer\\.auto\\.).*");
    }

    @Test
    void seuleLaFenetreConnaitAwtEtImageIoNeLitQueLesImagesAComparer() {
        String sansAwt = "(?!java\\.awt|javax\\.|sun\\.|com\\.).*";
        verifier("lancer\\.(?!fenetre\\.|image\\.LectureImage).*", sansAwt);
        verifier("lancer\\.image\\.LectureImage", sansAwt + "|java\\.awt\\.image\\..*|javax\\.imageio\\..*");
        verifier("lancer\\.(?!fenetre\\.|Main).*", "(?!lancer\\.fenetre\\.).*");
    }

    @Test
    void lEtatDeLaFenetreSePasseDAwtEtLaVueEtLeMoteurNeSeConnaissentPas() {
        verifier("lancer\\.fenetre\\.etat\\..*", "(?!java\\.awt|javax\\.|lancer\\.fenetre\\.(moteur|vue)).*");
        verifier("lancer\\.fenetre\\.moteur\\..*", "(?!lancer\\.fenetre\\.vue).*");
        verifier("lancer\\.fenetre\\.vue\\..*", "(?!lancer\\.fenetre\\.moteur).*");
    }

    @Test
    void seuleLaLectureConnaitIni4jEtNEnPrendQueLeDecoupage() {
        verifier("lancer\\.(?!scene\\.).*", "(?!org\\.ini4j).*");
        verifier(".*", "(?!org\\.).*|org\\.ini4j\\.(Config|InvalidFileFormatException|spi\\.IniHandler|spi\\.IniParser)");
        // la CVE-2022-41404 passe par ces méthodes-là
        noClasses().should().callMethodWhere(describe("fetch, to, as ou from d'ini4j", appel -> appel.getTargetOwner().getName()
                .startsWith("org.ini4j") && appel.getName().matches("fetch\\w*|to|as|from"))).check(CLASSES);
    }

    @Test
    void laLectureEtLesSortiesNeSeConnaissentPas() {
        verifier("lancer\\.scene\\..*", COURS + "lancer\\.(contrat|texte|systeme)\\..*|org\\.ini4j\\..*");
        verifier("lancer\\.image\\.(?!LectureImage).*", COURS + "lancer\\.(contrat|texte|systeme)\\..*");
    }

    /** Celui du cours lui-même mis à part : il se sert de tous. */
    @Test
    void aucunCercleNeRelieLesPaquets() {
        slices().matching("lancer.(**)").should().beFreeOfCycles().check(CLASSES);
    }

    /**
     * Ceux du cours : une scène a des objets, qui se colorent dans une scène, par des contrats qui parlent d'objets ; un rayon retient
     * l'objet qu'il touche.
     */
    @Test
    void aucunCercleNeRelieLesClassesQueCeuxDuCours() {
        SliceAssignment chacune = new SliceAssignment() {
            @Override
            public SliceIdentifier getIdentifierOf(JavaClass classe) {
                return SliceIdentifier.of(nom(classe));
            }

            @Override
            public String getDescription() {
                return "chaque classe";
            }
        };
        DescribedPredicate<JavaClass> duCours = describe("d'un cercle du cours", classe -> nom(classe)
                .matches("lancer\\.(Camera|Objet3D|Point|PointContact|Rayon|Scene|Sphere|Vecteur)"));
        slices().assignedFrom(chacune).should().beFreeOfCycles()
                .ignoreDependency(duCours.or(resideInAPackage("lancer.contrat")), duCours).check(CLASSES);
    }
}
