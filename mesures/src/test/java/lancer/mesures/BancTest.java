package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.temoins.LancerSurveille;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Le banc d'essai : ce qu'il mesure, ce qu'il refuse de mesurer, et ce qu'il écrit. */
class BancTest {

    private static final List<String> PETITES = Arrays.asList("scene1", "flocon-91", "foule-10", "foule-100");

    @TempDir
    Path dossier;

    private final ByteArrayOutputStream sortie = new ByteArrayOutputStream();
    private final ByteArrayOutputStream erreurs = new ByteArrayOutputStream();

    private Path csv() {
        return dossier.resolve("resultats").resolve("banc.csv");
    }

    private int banc(Function<Reglages, Banc.Essai> essai, String... options) throws IOException {
        String[] args = Arrays.copyOf(options, options.length + 2);
        args[options.length] = "--csv";
        args[options.length + 1] = csv().toString();
        return Banc.executer(args, new PrintStream(sortie, true, "UTF-8"), new PrintStream(erreurs, true, "UTF-8"), essai);
    }

    /** Mesure ici même, avec cette recherche au lieu de celle du programme ; la plus petite image, le temps le plus court. */
    private static Function<Reglages, Banc.Essai> avec(UnaryOperator<Recherche> autre) {
        Chronometre.Preparation preparation = (scene, largeur, hauteur) -> {
            Lancer lancer = LancerSurveille.preparer(scene, largeur, hauteur, true);
            scene.setRecherche(autre.apply(scene.getRecherche()));
            return lancer;
        };
        return reglages -> fichier -> new Chronometre(preparation, new Reglages(40, 30, 1, 1, Long.MAX_VALUE)).mesurer(fichier);
    }

    private List<String> lignes() throws IOException {
        return Arrays.asList(sortie.toString("UTF-8").split("\\R"));
    }

    private String ligneDe(String scene) throws IOException {
        List<String> siennes = lignes().stream().filter(l -> l.startsWith(scene + " ")).collect(Collectors.toList());
        assertEquals(1, siennes.size(), () -> scene + " dans :\n" + sortie);
        return siennes.get(0);
    }

    private List<String> lignesDuCsv() throws IOException {
        return Files.readAllLines(csv(), StandardCharsets.UTF_8);
    }

    @Test
    void chaquePetiteSceneASesChiffresSaMachineVirtuelleEtSaLigneDuCsv() throws IOException {
        assertEquals(0, banc(MachineSeparee::new, "--petit", "--secondes", "1"), () -> sortie + "\n" + erreurs);
        assertEquals("", erreurs.toString("UTF-8"));
        List<String> csv = lignesDuCsv();
        assertEquals(String.join(",", FichierCsv.COLONNES), csv.get(0));
        assertEquals(1 + PETITES.size(), csv.size());
        for (int k = 0; k < PETITES.size(); k++) {
            String[] mots = ligneDe(PETITES.get(k)).trim().split(" +");
            assertEquals(PETITES.get(k).equals("foule-100") ? 13 : 12, mots.length, String.join(" ", mots));
            String[] champs = csv.get(k + 1).split(",");
            assertEquals(FichierCsv.COLONNES.size(), champs.length, csv.get(k + 1));
            assertEquals(PETITES.get(k), champs[FichierCsv.COLONNES.indexOf("scene")]);
            assertEquals(mots[1], champs[FichierCsv.COLONNES.indexOf("spheres")]);
            assertEquals("19200", champs[FichierCsv.COLONNES.indexOf("primaires")]);
            for (String colonne : FichierCsv.COLONNES.subList(FichierCsv.COLONNES.indexOf("ombre"), FichierCsv.COLONNES.size())) {
                String valeur = champs[FichierCsv.COLONNES.indexOf(colonne)];
                assertTrue(Double.parseDouble(valeur) >= 0, colonne + " : " + valeur);
            }
        }
    }

    @Test
    void leCsvGranditSansQueSonEnTeteSeRepete() throws IOException {
        for (int k = 0; k < 2; k++) {
            assertEquals(0, banc(avec(r -> r), "--petit", "--scenes", "foule-10"), () -> sortie + "\n" + erreurs);
        }
        assertEquals(3, lignesDuCsv().size());
        assertEquals(1, lignesDuCsv().stream().filter(l -> l.startsWith("date,")).count());
    }

    @Test
    void uneVirguleOuUnGuillemetNeCoupePasUnChampDuCsv() {
        assertEquals("a b,\"c, d\",\"e \"\"f\"\"\",1", FichierCsv.ligne("a b", "c, d", "e \"f\"", 1));
    }

    @Test
    void uneRechercheQuiOublieUneSphereNAPasDeTempsEtLeStatutLeDit() throws IOException {
        assertEquals(1, banc(avec(Oublieuse::new), "--petit", "--scenes", "foule-10"));
        String ligne = ligneDe("foule-10");
        assertTrue(ligne.contains("PAS DE TEMPS, image fausse : le pixel ("), ligne);
        assertFalse(Files.exists(csv()), "rien à noter");
    }

    @Test
    void uneImageJusteLaPremiereFoisSeulementEstUneImageFausse() throws IOException {
        assertEquals(1, banc(avec(Changeante::new), "--petit", "--scenes", "foule-10"));
        String ligne = ligneDe("foule-10");
        assertTrue(ligne.contains("PAS DE TEMPS, image fausse : deux dessins"), ligne);
    }

    @Test
    void uneSceneFausseNEmpechePasDeMesurerLesAutres() throws IOException {
        assertEquals(1, banc(reglages -> fichier -> avec(r -> fichier.endsWith("foule-10.ini") ? new Oublieuse(r) : r)
                .apply(reglages).mesurer(fichier), "--petit"), () -> sortie + "\n" + erreurs);
        assertEquals(1 + PETITES.size() - 1, lignesDuCsv().size());
    }

    @Test
    void uneSceneTropChereEstSauteeAvecLesPlusGrandesDeSaFamilleSansEtreUneFaute() throws IOException {
        Chronometre.Preparation lente = (scene, largeur, hauteur) -> {
            Lancer lancer = LancerSurveille.preparer(scene, largeur, hauteur, true);
            scene.setRecherche(new Lente(scene.getRecherche()));
            return lancer;
        };
        // dix millisecondes par rayon : 1200 pixels en demandent au moins douze secondes, bien plus que la limite
        Reglages reglages = new Reglages(40, 30, 1, 1, 500_000_000);
        assertEquals(0, banc(r -> new Chronometre(lente, reglages)::mesurer, "--petit", "--scenes", "foule"));
        assertTrue(ligneDe("foule-10").contains("sautée : une image prendrait "), ligneDe("foule-10"));
        assertTrue(ligneDe("foule-100").contains("sautée : plus chère"), ligneDe("foule-100"));
        assertFalse(Files.exists(csv()), "rien à noter");
    }

    @ParameterizedTest(name = "« {0} » est refusé")
    @ValueSource(strings = {"--vite", "--scenes", "--scenes nuage", "--scenes scene1,nuage", "--secondes 0", "--secondes x",
        "--fils 0", "--fils 2000"})
    void uneDemandeFausseTientEnUneLigne(String demande) throws IOException {
        assertEquals(2, Banc.executer(demande.split(" "), new PrintStream(sortie, true, "UTF-8"),
                new PrintStream(erreurs, true, "UTF-8"), MachineSeparee::new));
        assertEquals("", sortie.toString("UTF-8"));
        assertTrue(erreurs.toString("UTF-8").matches("Banc : .+\\R"), erreurs.toString("UTF-8"));
    }

    @Test
    void leGrandBancVaDeDixAUnMillionDeSpheres() {
        assertEquals("scene1 flocon-91 flocon-820 flocon-7381 flocon-66430 flocon-597871 "
                + "foule-10 foule-100 foule-1000 foule-10000 foule-100000 foule-1000000",
                OptionsBanc.lire().scenes.stream().map(s -> s.nom).collect(Collectors.joining(" ")));
        OptionsBanc choix = OptionsBanc.lire("--scenes", "foule-10,flocon-91,foule-10", "--secondes", "10", "--fils", "3");
        assertEquals("flocon-91 foule-10", choix.scenes.stream().map(s -> s.nom).collect(Collectors.joining(" ")));
        assertEquals(5_000_000_000L, choix.reglages.dureeNs);
        assertEquals(3, choix.reglages.fils);
    }

    @Test
    void laLangueDeLaMachineNeChangeNiVirguleNiChiffre() throws IOException {
        Locale avant = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
            assertEquals(0, banc(avec(r -> r), "--petit", "--scenes", "foule-10"), () -> sortie + "\n" + erreurs);
        } finally {
            Locale.setDefault(avant);
        }
        assertTrue(ligneDe("foule-10").matches("[ -~]+"), ligneDe("foule-10"));
        assertEquals(FichierCsv.COLONNES.size(), lignesDuCsv().get(1).split(",").length);
    }

    /** Une recherche qui en interroge une autre. */
    private static class Relais implements Recherche {

        final Recherche autre;

        Relais(Recherche autre) {
            this.autre = autre;
        }

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            autre.plusProche(incident, saufLui);
        }

        @Override
        public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
            return autre.estCachee(lampe, P, V, distance, objet);
        }

        @Override
        public Recherche pourUnFil(Compteurs compteurs) {
            throw new UnsupportedOperationException();
        }
    }

    /** Ne voit pas la première boule qu'on lui demande. */
    private static final class Oublieuse extends Relais {

        private final Objet3D[] oubliee;

        Oublieuse(Recherche autre) {
            this(autre, new Objet3D[1]);
        }

        private Oublieuse(Recherche autre, Objet3D[] oubliee) {
            super(autre);
            this.oubliee = oubliee;
        }

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            super.plusProche(incident, saufLui);
            if (oubliee[0] == null) {
                oubliee[0] = incident.getObjet();
            }
            if (incident.getObjet() == oubliee[0]) {
                incident.setContact(null, Double.POSITIVE_INFINITY);
            }
        }

        @Override
        public Recherche pourUnFil(Compteurs compteurs) {
            return new Oublieuse(autre.pourUnFil(compteurs), oubliee);
        }
    }

    /** Juste le temps d'un dessin : un fil par dessin, et seul le premier voit quelque chose. */
    private static final class Changeante extends Relais {

        private final int[] fils;
        private final int rang;

        Changeante(Recherche autre) {
            this(autre, new int[1]);
        }

        private Changeante(Recherche autre, int[] fils) {
            super(autre);
            this.fils = fils;
            this.rang = fils[0]++;
        }

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            super.plusProche(incident, saufLui);
            if (rang > 1) {
                incident.setContact(null, Double.POSITIVE_INFINITY);
            }
        }

        @Override
        public Recherche pourUnFil(Compteurs compteurs) {
            return new Changeante(autre.pourUnFil(compteurs), fils);
        }
    }

    /** Met dix millisecondes à répondre. */
    private static final class Lente extends Relais {

        Lente(Recherche autre) {
            super(autre);
        }

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            try {
                Thread.sleep(10);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            super.plusProche(incident, saufLui);
        }

        @Override
        public Recherche pourUnFil(Compteurs compteurs) {
            return new Lente(autre.pourUnFil(compteurs));
        }
    }
}
