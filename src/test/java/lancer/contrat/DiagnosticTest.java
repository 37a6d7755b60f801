package lancer.contrat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.function.Consumer;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Main;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.commande.Options;
import lancer.texte.Texte;
import org.junit.jupiter.api.Test;

/** La classe de la scène qui ne tient pas ce qu'elle promet est nommée. */
class DiagnosticTest {

    private static final Camera CAMERA = new Camera(4, 3);

    private static final Lampe LAMPE = new Lampe(new Point(0, 0, -5), new Couleur(1));

    /** Un mur en z = 8, et ce qu'on lui fait dire de faux. */
    private static class Mur extends Objet3D {

        Mur() {
            setKd(new Couleur(0.5));
            setKs(new Couleur(0.5));
        }

        @Override
        public double getIntersectionDistance(Rayon incident) {
            double d = incident.getV().z > 0 ? (8 - incident.getP().z) / incident.getV().z : Double.POSITIVE_INFINITY;
            incident.setContact(this, d);
            return d;
        }

        @Override
        public Vecteur getNormale(Point contact) {
            return new Vecteur(0, 0, -1);
        }
    }

    /** Ce que dit l'échec d'un dessin, sans le nom de cette classe-ci ni le numéro de la ligne. */
    private static String dit(Objet3D objet, Lampe lampe, Consumer<Modele> variante) {
        Modele modele = new Modele();
        variante.accept(modele);
        Scene scene = new Scene(Collections.singletonList(objet), Collections.singletonList(lampe), modele);
        PixelFautif panne = assertThrows(PixelFautif.class, () -> new Lancer(scene, CAMERA).TracerPixels((c, i, j) -> { }, 2, 1));
        PixelFautif precise = Diagnostic.preciser(panne, scene, CAMERA, 2);
        assertEquals(panne.getMessage(), precise.getMessage());
        return Texte.cause(precise, "(?!java\\.).*").replace(DiagnosticTest.class.getName() + "$", "").replaceAll("java:\\d+", "java");
    }

    private static String dit(Objet3D objet) {
        return dit(objet, LAMPE, modele -> { });
    }

    private static final class SansNormale extends Mur {
        @Override
        public Vecteur getNormale(Point contact) {
            return null;
        }
    }

    private static final class SansSurface extends Mur {
        @Override
        public Point getPointDeSurface(Point contact) {
            return null;
        }
    }

    private static final class SansCouleur extends Mur {
        @Override
        public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
            return null;
        }
    }

    private static final class Tordu extends Mur {
        @Override
        public Vecteur getNormale(Point contact) {
            return new Vecteur(0, 0, Double.NaN);
        }
    }

    private static final class SansDistance extends Mur {
        @Override
        public double getIntersectionDistance(Rayon incident) {
            return Double.NaN;
        }
    }

    /** Son erreur se voit dans une méthode de {@link Vecteur}. */
    private static final class Distrait extends Mur {
        @Override
        public Vecteur getNormale(Point contact) {
            return new Vecteur().normalized();
        }
    }

    private static final class Eteinte extends Lampe {

        Eteinte() {
            super(null, new Couleur(1));
        }
    }

    private static final class Aveugle implements Atmosphere, Specularite {
        @Override
        public Couleur traverser(Couleur vue, double distance) {
            return null;
        }

        @Override
        public double eclat(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns) {
            return Double.NaN;
        }
    }

    @Test
    void uneFormeQuiRendNullOuUnNonNombreEstNommeeAvecSaMethode() {
        String faute = "java.lang.IllegalStateException: ";
        assertEquals(faute + "SansNormale.getNormale a rendu null", dit(new SansNormale()));
        assertEquals(faute + "SansSurface.getPointDeSurface a rendu null", dit(new SansSurface()));
        assertEquals(faute + "SansCouleur.getColor a rendu null", dit(new SansCouleur()));
        assertEquals(faute + "SansDistance.getIntersectionDistance a rendu NaN", dit(new SansDistance()));
        assertEquals(faute + "Tordu.getNormale a rendu Vecteur(0.0, 0.0, NaN)", dit(new Tordu()));
        Mur incolore = new Mur();
        incolore.setKd(null);
        assertEquals(faute + "Mur.getKd a rendu null", dit(incolore));
    }

    @Test
    void uneVarianteOuUneLampeAussi() {
        String faute = "java.lang.IllegalStateException: ";
        assertEquals(faute + "Aveugle.traverser a rendu null", dit(new Mur(), LAMPE, modele -> modele.setAtmosphere(new Aveugle())));
        assertEquals(faute + "Aveugle.eclat a rendu NaN", dit(new Mur(), LAMPE, modele -> modele.setSpecularite(new Aveugle())));
        assertEquals(faute + "Eteinte.getPosition a rendu null", dit(new Mur(), new Eteinte(), modele -> { }));
    }

    @Test
    void unePanneEstSitueeDansLaClasseDeLaScene() {
        assertEquals("java.lang.ArithmeticException: vecteur sans direction, impossible à normaliser : Vecteur(0.0, 0.0, 0.0) "
                + "(Distrait.getNormale, DiagnosticTest.java)", dit(new Distrait()));
    }

    @Test
    void uneCouleurFausseDUnEchantillonnageNArrivePasALImageEtSaLigneEstDite() {
        for (Couleur fausse : new Couleur[] {null, new Couleur(1, Double.NaN, 1), new Couleur(1 / 0.0)}) {
            Scene scene = new Scene(Collections.singletonList(new Mur()), Collections.singletonList(LAMPE))
                    .avec((pave, vue, toile) -> {
                        toile.drawPixel(fausse, 2, 1);
                        return 0;
                    }, 0);
            Main main = new Main(Options.lire(), System.out, System.err);
            PixelFautif panne = assertThrows(PixelFautif.class, () -> new Lancer(scene, CAMERA).TracerPixels(main, 2, 1));
            assertEquals("pixel 2, 1", panne.getMessage());
            String dit = Texte.cause(Diagnostic.preciser(panne, scene, CAMERA, 2), "(?!java\\.).*");
            assertTrue(dit.startsWith("java.lang.ArithmeticException: ce n'est pas une couleur aux composantes finies : " + fausse
                    + " (" + DiagnosticTest.class.getName() + ".lambda$"), dit);
        }
    }

    @Test
    void unEchecQuiNeSeReproduitPasResteCeluiQuiAEteVu() {
        Scene scene = new Scene(Collections.singletonList(new Mur()), Collections.singletonList(LAMPE));
        PixelFautif panne = new PixelFautif(1.5, 1.5, new IllegalStateException("une fois"));
        assertSame(panne.getCause(), Diagnostic.preciser(panne, scene, CAMERA, 2).getCause());
    }
}
