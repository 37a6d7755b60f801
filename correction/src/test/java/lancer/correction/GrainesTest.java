package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.correction.modele.SourcesDuCours;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Des valeurs que personne ne connaît d'avance : les vérifications et les scènes, tirées d'un nombre. */
class GrainesTest {

    private static final String GEANTE = "Sphere.uneSphereGeanteEstToucheeSansGrain";

    @TempDir
    static Path dossier;

    /** Des graines, autant qu'il le faut ici ou, si l'on demande les tests longs, cent. */
    private static long[] graines(int combien) {
        return LongStream.rangeClosed(1, Boolean.getBoolean("tests.longs") ? 100 : combien).toArray();
    }

    @Test
    void leCorrigePasseToutQuelleQueSoitLaGraine() {
        Map<Long, Map<String, String>> rates = new Programme(dossier).rates(graines(6));
        rates.values().removeIf(Map::isEmpty);
        assertEquals(Map.of(), rates);
        assertEquals(Map.of(), new Programme(dossier).rates(0));
    }

    /** Le corrigé, chaque nombre arrondi à un {@code float}. */
    private static Programme enFloat() {
        Programme programme = new Programme(dossier);
        for (String champ : List.of("x", "y", "z")) {
            programme.changer("Tuple", "this." + champ + " = ", "this." + champ + " = (float) ");
        }
        for (String champ : List.of("r", "v", "b")) {
            programme.changer("Couleur", "this." + champ + " = ", "this." + champ + " = (float) ");
        }
        return programme.changer("Vecteur", "x * v.x + y * v.y + z * v.z",
                "(float) x * (float) v.x + (float) y * (float) v.y + (float) z * (float) v.z")
                .changer("Vecteur", "return Math.sqrt", "return (float) Math.sqrt")
                .changer("Sphere", "double b = 2 * CP", "float b = 2 * (float) CP")
                .changer("Sphere", "double c = CP.norme2() - rayon * rayon",
                        "float c = (float) CP.norme2() - (float) rayon * (float) rayon")
                .changer("Sphere", "double delta", "float delta").changer("Sphere", "double racine = ", "float racine = (float) ")
                .changer("Camera", "double focale = ", "double focale = (float) ")
                .changer("Objet3D", "double cosinus = ", "float cosinus = (float) ").changer("Objet3D", "double eclat = ",
                        "float eclat = (float) ");
    }

    /** En double et en float, où le contact retrouve la boule elle-même, ou non : une seule vérification est chargée de le dire. */
    @ParameterizedTest
    @CsvSource({"'new Rayon(contact, lampe.getPosition())', null, this", "'new Rayon(lampe.getPosition(), contact)', null, this",
        "'new Rayon(lampe.getPosition(), contact)', this, null", "'new Rayon(contact, lampe.getPosition())', null, null",
        "'new Rayon(lampe.getPosition(), contact)', this, this"})
    void ceQuiDependDesArrondisCouteLesMemesVerificationsQuelleQueSoitLaGraine(String rayon, String ombre, String reflet) {
        Set<String> attendus = new TreeSet<>();
        if (ombre.equals("null")) {
            attendus.add("Objet3D.uneBouleNeSeCachePasElleMeme");
        }
        if (reflet.equals("null")) {
            attendus.add("Objet3D.uneBouleNeSeRefletePasElleMeme");
        }
        for (boolean arrondi : new boolean[] {false, true}) {
            Map<Long, Map<String, String>> tous = (arrondi ? enFloat() : new Programme(dossier))
                    .changer("Objet3D", "new Rayon(lampe.getPosition(), contact)", rayon)
                    .changer("Objet3D", "(rayon, (Sphere) this)", "(rayon, (Sphere) " + ombre + ")")
                    .changer("Objet3D", "(reflechi, (Sphere) this)", "(reflechi, (Sphere) " + reflet + ")").rates(graines(3));
            long grain = tous.values().stream().filter(r -> r.remove(GEANTE) != null).count();
            assertEquals(arrondi, grain > 0.6 * tous.size(), "il y a du grain");
            // elle nomme la classe donnée qui a changé, et ne rapporte rien
            tous.values().forEach(r -> assertEquals(arrondi, r.remove("Tuple.unTripletGardeSesCoordonnees") != null));
            tous.forEach((graine, rates) -> assertEquals(attendus, rates.keySet(), "graine " + graine));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"Lancer", "Camera"})
    void viserUnDemiPixelPlusLoinNEstPasUneFauteDePlusQueSansGraine(String classe) {
        Programme decale = classe.equals("Lancer") ? new Programme(dossier).changer("Lancer", "(xe, ye)", "(xe + 0.5, ye + 0.5)")
                : new Programme(dossier).changer("Camera", "(xe - ", "(xe + 0.5 - ").changer("Camera", "2.0 - ye)", "2.0 - ye - 0.5)");
        Set<String> sans = decale.rates(0).keySet();
        assertEquals(classe.equals("Lancer") ? Set.of() : Set.of("Camera.leCoinEnHautAGaucheEstAMoinsUn"), sans);
        decale.rates(graines(3)).forEach((graine, rates) -> assertEquals(sans, rates.keySet(), "graine " + graine));
    }

    @Test
    void leProjetACompleterNeReussitRienDePlusAvecUneGraine() {
        Programme squelette = new Programme(dossier);
        SourcesDuCours.A_COMPLETER.forEach(classe -> squelette.ecrire(classe, SourcesDuCours.squelette(classe)));
        assertEquals(squelette.rates(0).keySet(), squelette.rates(7).keySet());
    }

    /** Cette méthode ne dit plus que ce que la table sait ; ce qu'elle calculait remplit la table. */
    private static void reciter(Programme programme, String classe, String methode, String question) {
        String arguments = methode.substring(methode.indexOf('(') + 1, methode.length() - 1).replaceAll("\\w+ (\\w+)", "$1");
        programme.changer(classe, methode + " {", methode + " {\n        return Table." + question + ", () -> calculer(" + arguments
                + "));\n    }\n\n    private " + methode.replaceFirst("public (\\w+) \\w+", "$1 calculer") + " {");
    }

    @Test
    void recopierLesReponsesAuxValeursPubliquesNeRapporteRien() throws IOException {
        Programme copie = new Programme(dossier).ecrire("Table", Files.readString(ClasseEssai.RENDUS.resolve("table.txt")));
        reciter(copie, "Sphere", "public double getIntersectionDistance(Rayon incident)", "distance(this, incident");
        reciter(copie, "Camera", "public Rayon getRayon(double xe, double ye)", "rayon(xe, ye, largeur, hauteur");
        reciter(copie, "Objet3D", "public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur)",
                "couleur(this, scene, incident, contact, profondeur");
        Map<String, double[]> table = new HashMap<>();
        System.getProperties().put("table", table);
        try {
            Map<Long, Map<String, String>> ignorant = copie.rates(1, 2);
            System.setProperty("table.apprend", "true");
            assertEquals(Map.of(), copie.rates(0));
            System.clearProperty("table.apprend");
            assertTrue(table.size() > 100, table.size() + " réponses");
            assertEquals(Map.of(), copie.rates(0), "récitée, la table passe tout ce qui est public");
            Map<Long, Map<String, String>> savant = copie.rates(1, 2);
            savant.forEach((graine, rates) -> assertEquals(ignorant.get(graine).keySet(), rates.keySet(), "graine " + graine));
        } finally {
            System.getProperties().remove("table");
            System.clearProperty("table.apprend");
        }
    }

    private static Scene lire(String texte) throws IOException {
        Path fichier = Files.writeString(Files.createTempFile(dossier, "scene", ".ini"), texte);
        Scene lue = new Scene(fichier.toString());
        // sans les variantes, que les tests de ce module ont dans leur chemin
        return new Scene(lue.getObjets(), lue.getLampes());
    }

    private static List<Sphere> boules(Scene scene) {
        return scene.getObjets().stream().map(objet -> (Sphere) objet).collect(Collectors.toList());
    }

    private static double ecart(Point p, Point q) {
        return new Vecteur(p, q).norme();
    }

    @ParameterizedTest
    @ValueSource(strings = {"scene1", "ombres", "miroirs", "bowling", "brume"})
    void uneSceneTireeResteUneSceneValideEtSemblable(String nom) throws IOException {
        List<Sphere> avant = boules(lire(SourcesDuCours.scene(nom)));
        List<Lampe> lampes = lire(SourcesDuCours.scene(nom)).getLampes();
        assertEquals(SourcesDuCours.scene(nom, 3), SourcesDuCours.scene(nom, 3));
        assertNotEquals(SourcesDuCours.scene(nom, 3), SourcesDuCours.scene(nom, 4));
        for (long graine : graines(5)) {
            Scene tiree = lire(SourcesDuCours.scene(nom, graine));
            List<Sphere> apres = boules(tiree);
            assertEquals(avant.size(), apres.size());
            assertEquals(lampes.size(), tiree.getLampes().size());
            for (int k = 0; k < avant.size(); k++) {
                Sphere a = avant.get(k);
                Sphere b = apres.get(k);
                assertEquals(a.getRayon(), b.getRayon());
                double permis = a.getRayon() < 100 ? 0.22 * a.getRayon() : 0;
                assertTrue(ecart(a.getCentre(), b.getCentre()) <= permis, a + " " + b);
                assertTrue(a.getRayon() >= 100 || ecart(b.getCentre(), Camera.OEIL) > b.getRayon(), b + " : l'œil y est");
                for (Objet3D autre : apres.subList(0, k)) {
                    double jeu = ecart(b.getCentre(), ((Sphere) autre).getCentre()) - b.getRayon() - ((Sphere) autre).getRayon();
                    assertTrue(jeu > -0.4 * Math.min(b.getRayon(), ((Sphere) autre).getRayon()), b + " est dans " + autre);
                }
            }
            for (int k = 0; k < lampes.size(); k++) {
                double bouge = ecart(lampes.get(k).getPosition(), tiree.getLampes().get(k).getPosition());
                assertTrue(bouge <= 0.09 * ecart(new Point(), lampes.get(k).getPosition()), nom + " : " + bouge);
            }
        }
    }

    /** La part des pixels, parmi ceux qui ne sont pas du ciel, qui ne sont plus les mêmes. */
    private static double changes(Scene avant, Scene apres) {
        Camera camera = new Camera(40, 30);
        int vus = 0;
        int changes = 0;
        for (int p = 0; p < 1200; p++) {
            double xe = p % 40 + 0.5;
            double ye = p / 40 + 0.5;
            if (apres.getClosestIntersection(camera.getRayon(xe, ye), null) != null) {
                vus++;
                Couleur a = new Lancer(avant, camera).getCouleurPixel(xe, ye, 5);
                Couleur b = new Lancer(apres, camera).getCouleurPixel(xe, ye, 5);
                changes += Math.max(Math.abs(a.r - b.r), Math.max(Math.abs(a.v - b.v), Math.abs(a.b - b.b))) > 2 / 255.0 ? 1 : 0;
            }
        }
        return changes / (double) vus;
    }

    @ParameterizedTest
    @ValueSource(strings = {"scene1", "ombres", "miroirs"})
    void lImageDUneSceneTireeNEstPasCelleQueLOnConnait(String nom) throws IOException {
        for (long graine : graines(2)) {
            double part = changes(lire(SourcesDuCours.scene(nom)), lire(SourcesDuCours.scene(nom, graine)));
            assertTrue(part > 0.85, nom + ", graine " + graine + " : " + part);
        }
    }
}
