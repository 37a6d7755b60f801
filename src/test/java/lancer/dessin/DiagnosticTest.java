package lancer.dessin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Cause;
import lancer.contrat.Modele;
import lancer.contrat.PixelFautif;
import lancer.contrat.Releve;
import lancer.essai.Essai;
import lancer.essai.Modification;
import lancer.essai.Plan;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Un pixel qui échoue est situé dans la classe de la scène, ou de la variante, qui n'a pas tenu. */
class DiagnosticTest {

    private static final Camera CAMERA = new Camera(4, 3);

    /** Un mur en z = 8, et ce qu'on lui fait dire de faux. */
    private static class Mur extends Plan {

        Mur() {
            super(new Point(0, 0, 8), new Vecteur(0, 0, -1));
            setKd(new Couleur(0.5));
            setKs(new Couleur(0.5));
        }
    }

    /** Son erreur se voit dans une méthode de {@link Vecteur}. */
    private static final class Distrait extends Mur {
        @Override
        public Vecteur getNormale(Point contact) {
            return new Vecteur().normalized();
        }
    }

    private static final class SansNormale extends Mur {
        @Override
        public Vecteur getNormale(Point contact) {
            return null;
        }
    }

    private static Scene scene(Objet3D objet) {
        return new Scene(List.of(objet), List.of(new Lampe(new Point(0, 0, -5), new Couleur(1))));
    }

    /** Ce que dit l'échec d'un dessin, sans le nom de cette classe-ci ni le numéro de la ligne. */
    private static String dit(Objet3D objet, Consumer<Modele.Construction> variante) {
        Modele.Construction modele = new Modele.Construction();
        variante.accept(modele);
        Scene scene = scene(objet).avec(modele.construire());
        PixelFautif panne = assertThrows(PixelFautif.class, () -> new Lancer(scene, CAMERA).TracerImage((c, i, j) -> { }, 2, 1));
        return Cause.dire(panne).replace(DiagnosticTest.class.getName(), "")
                .replaceAll("java:\\d+", "java");
    }

    @Test
    void unePanneEstSitueeDansLaClasseDeLaScene() {
        assertEquals("java.lang.ArithmeticException: vecteur sans direction, impossible à normaliser : Vecteur(0.0, 0.0, 0.0) "
                + "($Distrait.getNormale, DiagnosticTest.java)", dit(new Distrait(), modele -> { }));
    }

    @Test
    void uneReponseNulleEstSitueeLaOuLeCoursSEnSert() {
        String dit = dit(new SansNormale(), modele -> { });
        assertTrue(dit.startsWith("java.lang.NullPointerException") && dit.endsWith("(lancer.Objet3D.getReflexion, Objet3D.java)"), dit);
        dit = dit(new Mur(), modele -> modele.setSpecularite((V, N, L, R, ns) -> Double.NaN));
        assertTrue(dit.startsWith("java.lang.ArithmeticException: ce n'est pas une couleur aux composantes finies : "), dit);
    }

    @Test
    void uneCouleurFausseDUnEchantillonnageNArrivePasALImageEtSaLigneEstDite() {
        for (Couleur fausse : new Couleur[] {null, new Couleur(1, Double.NaN, 1), new Couleur(1 / 0.0)}) {
            String dit = dit(new Mur(), modele -> modele.setEchantillonnage((pave, voulus, vue, toile) -> {
                PixelFautif.exigerFinie(fausse, 2.5, 1.5);
                return Releve.RIEN;
            }));
            assertTrue(dit.startsWith("java.lang.ArithmeticException: ce n'est pas une couleur aux composantes finies : " + fausse
                    + " (.lambda$"), dit);
        }
    }

    @Test
    void uneCouleurNulleQueRecoitUneImageEstSitueeLaOuElleEstDessinee() {
        String dit = dit(new Mur(), modele -> modele.setEchantillonnage((pave, voulus, vue, toile) -> {
            new ImageMemoire(4, 3, false).drawPixel(null, 2, 1);
            return Releve.RIEN;
        }));
        assertTrue(dit.contains(" : null (.lambda$"), dit);
    }

    @Test
    void unEchecDitSaPremiereCause() {
        PixelFautif panne = new PixelFautif(1.5, 1.5, new IllegalStateException("une fois"));
        String dit = Cause.dire(panne);
        assertTrue(dit.startsWith("java.lang.IllegalStateException: une fois (" + DiagnosticTest.class.getName()), dit);
    }

    @Test
    void leMessageNommeLePixelLaSceneLaCauseLaLigneEtLaCommande(@TempDir Path dossier) throws IOException {
        Path scene = Files.copy(Path.of("scenes/scene1.ini"), dossier.resolve("deux mots.ini"));
        try (Essai.Isole programme = Modification.de(dossier, "Lancer", "Rayon initial =",
                "if (xe > 20) { throw new IllegalStateException(\"pas encore écrit\"); } Rayon initial =")) {
            Essai essai = programme.executer("--taille=40x30", "--reflets=2", "--fils=1", "--image", dossier.resolve("i.png").toString(),
                    scene.toString());
            assertEquals(1, essai.code, essai.toString());
            Matcher pixel = Pattern.compile("lancer : pixel (\\d+), (\\d+) de .*deux mots.ini : java.lang.IllegalStateException: "
                    + "pas encore écrit \\(lancer.Lancer.getCouleurPixel, Lancer.java:\\d+\\) ; pour le revoir : .* --pixel (\\d+,\\d+) "
                    + "--taille 40x30 --reflets 2 '.*/deux mots.ini'").matcher(essai.erreur.trim());
            assertTrue(pixel.matches(), essai.erreur);
            assertTrue(Integer.parseInt(pixel.group(1)) >= 20, essai.erreur);
            assertEquals(pixel.group(1) + "," + pixel.group(2), pixel.group(3));
        }
    }
}
