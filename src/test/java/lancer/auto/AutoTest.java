package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.commande.Etape;
import lancer.commande.Option;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.contrat.Modele;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.dessin.Dessin;
import lancer.essai.Plan;
import lancer.essai.Ressources;
import lancer.scene.SectionLue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Ce que choisit {@code --auto} là où l'on sait d'avance ce qu'il faut, et ce qu'il dit de l'image. */
class AutoTest {

    /** Paire, l'horizon passe entre deux lignes de pixels. */
    private static final int HAUTEUR = 30;
    private static final int LARGEUR = 40;

    private static final Scene CIEL = new Scene(List.of(), List.of());
    private static final Map<Variante, Section> SANS = Map.of();
    private static final Map<Variante, Section> GRILLES = GrilleDEssai.seule("1", "2", "4", "16");

    private static Reglages reglages(Map<Variante, Section> variantes) {
        return Options.lire().pour(variantes);
    }

    private static List<Reglages> echelle(Map<Variante, Section> variantes) {
        return Echelle.de(reglages(variantes), false, false);
    }

    private static String dire(Auto auto) {
        return Echelle.dire(auto.getChoisi());
    }

    private static Auto auto(Scene scene, int largeur, int hauteur, Map<Variante, Section> variantes, double voulue) {
        Lancer prepare = Dessin.lancer(scene, largeur, hauteur, false);
        return new Auto(prepare, echelle(variantes), voulue, 2);
    }

    /** Dessine, contrôle, et reprend au besoin. @return les couleurs de la dernière image, ligne par ligne */
    private static Couleur[] dessiner(Auto auto) {
        int largeur = auto.getLancer().getCamera().getLargeur();
        Couleur[] image = new Couleur[largeur * auto.getLancer().getCamera().getHauteur()];
        do {
            auto.getLancer().TracerImage((couleur, i, j) -> image[j * largeur + i] = couleur, auto.getChoisi().getProfondeur(), 2);
        } while (!auto.controler(rang -> image[rang]));
        return image;
    }

    private static Scene scene(Objet3D... objets) {
        return new Scene(List.of(objets), List.of(new Lampe(new Point(-3, 5, -5), new Couleur(0.8))));
    }

    private static Sphere boule(double x, double y, double z, double rayon, double ks) {
        return Ressources.boule(x, y, z, rayon, 0.5, ks, 1);
    }

    private static Scene quelquesBoules() {
        return scene(boule(-1, 0, 8, 1.2, 0.5), boule(1.2, 0.4, 7, 0.7, 0.8), boule(0, -1001.5, 8, 1000, 0.3));
    }

    /** Un mur sans fin qui luit et reflète : entre deux, un rayon ne s'arrête jamais. */
    private static final class Mur extends Plan {

        private final double lueur;

        Mur(double z, double ks, double lueur) {
            super(new Point(0, 0, z), new Vecteur(0, 0, -Math.signum(z)));
            this.lueur = lueur;
            setKs(new Couleur(ks));
        }

        @Override
        public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
            return super.getColor(scene, incident, contact, profondeur).add(new Couleur(lueur));
        }
    }

    /**
     * La couleur vue est la somme d'une série géométrique, de limite 0,9. Après r reflets, il y manque 255 × 0,9 × ks^(r + 1) niveaux : le
     * premier échelon qui convient est connu.
     */
    @ParameterizedTest
    @CsvSource({"0.5, 140, 0", "0.5, 70, 1", "0.5, 60, 2", "0.5, 5, 5", "0.5, 4, 1000", "0.2, 12, 1", "0.8, 100, 5"})
    void entreDeuxMiroirsLesRefletsSontCeuxDeLaSerie(double ks, double erreur, int reflets) {
        double lueur = 0.9 * (1 - ks);
        Auto auto = auto(new Scene(List.of(new Mur(10, ks, lueur), new Mur(-10, ks, lueur)), List.of()), 16, 12, SANS, erreur);
        assertEquals(reflets, auto.getChoisi().getProfondeur());
        dessiner(auto);
        // sous le seuil 1/1024, un reflet n'est plus suivi
        double manque = 255 * 0.9 * Math.pow(ks, Math.min(reflets, 10) + 1);
        assertEquals(manque, auto.getMesure().erreur, 0.02 * manque);
        assertEquals(manque > 0.5, auto.getMesure().aUnIntervalle);
        assertEquals("erreur voulue tenue", auto.getVerdict());
    }

    @Test
    void ceQuiEstFixeResteEtLeResteSeChoisit() {
        assertEquals(List.of("un rayon par pixel, --reflets 7 --seuil 0.0009765625"),
                dites(Echelle.de(reglages(SANS).avec(Option.REFLETS, 7).avec(Option.SEUIL, 0.5), true, false)));
        List<Reglages> echelle = Echelle.de(reglages(SANS).avec(Option.SEUIL, 0.25), false, true);
        assertEquals("[0, 1, 2, 5, 1000]", echelle.stream().map(e -> e.get(Option.REFLETS)).collect(Collectors.toList()).toString());
        assertTrue(echelle.stream().allMatch(e -> e.get(Option.SEUIL) == 0.25));
        assertEquals(List.of("[Grille] n=2, --reflets 3 --seuil 0.125"),
                dites(Echelle.de(reglages(GrilleDEssai.seule("2")).avec(Option.REFLETS, 3).avec(Option.SEUIL, 0.125), true, true)));
        assertEquals(List.of("un rayon par pixel, --reflets 0 --seuil 0.0009765625"),
                dites(Echelle.de(reglages(SANS).avec(Option.ETAPE, Etape.OMBRES), false, false)), "une étape sans reflets n'en essaie pas");
    }

    private static List<String> dites(List<Reglages> echelle) {
        return echelle.stream().map(Echelle::dire).collect(Collectors.toList());
    }

    @Test
    void leCielNeDemandeQuUnRayonParPixel() {
        Auto auto = auto(CIEL, 80, 60, GRILLES, 0.1);
        assertTrue(dire(auto).startsWith("[Grille] n=1, "), dire(auto));
        dessiner(auto);
        assertTrue(!auto.getMesure().aUnIntervalle, "" + auto.getMesure().erreur);
        String dit = auto.getMesure().enMots();
        assertTrue(dit.matches("aucun écart sur (1[5-9]|2[0-4]). pixels ; "
                + "pixels tirés au hasard : un détail plus petit que 1/[3-8]. de l'image a pu échapper"), dit);
    }

    @Test
    void desBoulesPlusPetitesQuUnPixelDemandentPlusieursRayons() {
        String fin = ", --reflets 1000 --seuil 0.0";
        assertEquals("[Grille] n=16" + fin, dire(auto(damier(), LARGEUR, HAUTEUR, GRILLES, 1)));
        assertEquals("[Grille] n=1" + fin, dire(auto(damier(), LARGEUR, HAUTEUR, GRILLES, 100)));
    }

    /** Juste sur les pixels essayés, faux sur un pavé entier : seule l'image dessinée le montre. */
    @Test
    void uneImagePlusFausseQueLesEssaisEstRepriseUneFois() {
        Lancer prepare = Dessin.lancer(CIEL, 100, 80, false);
        Variante trompeuse = new GrilleDEssai(null) {
            @Override
            public void installer(Section valeurs, Modele.Construction modele) {
                modele.setEchantillonnage((pave, voulus, vue, toile) -> {
                    Couleur ecart = new Couleur(voulus == pave ? 0.1 : 0);
                    return grille(1).tracer(pave, voulus, (xe, ye) -> vue.couleur(xe, ye).add(ecart), toile);
                });
            }
        };
        Reglages faux = reglages(Map.of(trompeuse, new SectionLue("Grille")));
        Reglages juste = faux.avecVariante(trompeuse, false);
        Auto repris = new Auto(prepare, List.of(faux, juste, juste), 1, 2);
        dessiner(repris);
        assertEquals(juste, repris.getChoisi());
        assertTrue(!repris.getMesure().aUnIntervalle, "le réglage juste l'est partout");
        // l'image remplacée, un essai et deux contrôles de deux cents pixels, de cinquante rayons chacun, et les pavés de l'essai
        assertEquals(2 * 8000 + 3 * 200 * 50, repris.getRayonsDesEssais(), 6000);
        Auto depasse = new Auto(prepare, List.of(faux, faux), 1, 2);
        dessiner(depasse);
        assertEquals(faux, depasse.getChoisi());
        assertEquals("erreur voulue dépassée", depasse.getVerdict());
    }

    private static Echantillon echantillon(Lancer prepare, IntFunction<Couleur> dessinee, long graine) {
        return new Echantillon(prepare, 2, dessinee, 1, 1_000_000, Integer.MAX_VALUE, new SplittableRandom(graine));
    }

    /** À un demi d'une composante, dans [0, 1], quel que soit le ciel. */
    private static double loin(double composante) {
        return composante > 0.5 ? composante - 0.5 : composante + 0.5;
    }

    /** Mille pixels sont tirés, de trente mille : le pixel faux, qui se voit, a toutes les chances d'en être. */
    @Test
    void unSeulPixelFauxParmiTrenteMilleEstVu() {
        Lancer prepare = Dessin.lancer(CIEL, 200, 150, false);
        Couleur[] image = new Couleur[200 * 150];
        prepare.TracerImage((couleur, i, j) -> image[j * 200 + i] = couleur, 0, 2);
        Couleur juste = image[12_345];
        image[12_345] = new Couleur(loin(juste.r), loin(juste.v), loin(juste.b));
        Mesure mesure = echantillon(prepare, rang -> image[rang], 1).mesurer(rang -> image[rang]);
        assertEquals(0.5 * 255 / Math.sqrt(image.length), mesure.erreur, 0.1);
        assertTrue(mesure.aUnIntervalle);
    }

    @Test
    void deuxDemandesNeRegardentPasLesMemesPixels() {
        Lancer prepare = Dessin.lancer(quelquesBoules(), 80, 60, false);
        IntFunction<Couleur> image = rang -> new Couleur(rang % 7 / 7.0);
        assertTrue(echantillon(prepare, image, 1).mesurer(image).erreur != echantillon(prepare, image, 2).mesurer(image).erreur);
    }

    /** À une taille ordinaire, tout ce qui n'est pas l'image coûte moins qu'elle. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 2, 4})
    void lesEssaisCoutentMoinsQueLImage(double voulue) {
        Auto auto = auto(quelquesBoules(), 200, 150, GRILLES, voulue);
        dessiner(auto);
        assertTrue(auto.getRayonsDesEssais() < auto.getLancer().getAtelier().getCompteurs().rayons(), "" + auto.getRayonsDesEssais());
    }

    /** Des boules d'un quart de pixel, un pixel sur deux. */
    private static Scene damier() {
        double pixel = Constantes.ECHELLE / LARGEUR;
        int colonnes = LARGEUR / 2;
        Objet3D[] boules = new Objet3D[colonnes * HAUTEUR / 2];
        for (int k = 0; k < boules.length; k++) {
            // presque sur l'écran, où la perspective ne change rien
            boules[k] = boule((2 * (k % colonnes) + 0.4 - colonnes) * pixel, (2 * (k / colonnes) + 0.4 - HAUTEUR / 2) * pixel, 0.01,
                    pixel / 2, 0);
        }
        return scene(boules);
    }

    /** Des boules de ce rayon, en pixels, au hasard dans l'image. */
    private static Scene petites(int combien, double rayon, double ks, long graine, int largeur) {
        SplittableRandom hasard = new SplittableRandom(graine);
        List<Sphere> boules = new ArrayList<>();
        for (int k = 0; k < combien; k++) {
            double z = 6 + hasard.nextDouble(2);
            double champ = (z + Camera.FOCALE) / Camera.FOCALE;
            boules.add(boule(hasard.nextDouble(-1, 1) * champ, hasard.nextDouble(-0.75, 0.75) * champ, z,
                    rayon * Constantes.ECHELLE / largeur * champ, ks));
        }
        return scene(boules.toArray(new Objet3D[0]));
    }

    private static double[] niveaux(Couleur couleur) {
        return Arrays.stream(new double[] {couleur.r, couleur.v, couleur.b}).map(c -> 255 * Math.max(0, Math.min(1, c))).toArray();
    }

    /** L'erreur vraie, sans biais ni limite : chaque pixel contre deux fois 25 rayons, chacun au hasard dans une case du pixel. */
    private static double vraie(Lancer dessine, Couleur[] image) {
        Lancer lancer = dessine.avec(dessine.getScene().getModele().avecSeuil(0));
        int largeur = lancer.getCamera().getLargeur();
        SplittableRandom hasard = new SplittableRandom(9);
        double somme = 0;
        for (int p = 0; p < image.length; p++) {
            double[][] justes = new double[2][];
            for (int r = 0; r < 2; r++) {
                Couleur moyenne = new Couleur();
                for (int k = 0; k < 25; k++) {
                    moyenne = moyenne.add(lancer.getCouleurPixel(p % largeur + (k % 5 + hasard.nextDouble()) / 5,
                            p / largeur + (k / 5 + hasard.nextDouble()) / 5, 60));
                }
                justes[r] = niveaux(moyenne.div(25));
            }
            double[] x = niveaux(image[p]);
            for (int c = 0; c < 3; c++) {
                somme += (x[c] - justes[0][c]) * (x[c] - justes[1][c]) / 3;
            }
        }
        return Math.sqrt(Math.max(0, somme / image.length));
    }

    /** Petites boules brillantes, mates ou nombreuses : l'intervalle annoncé contient l'erreur vraie. */
    @Test
    void lIntervalleContientLErreurVraiePresqueToujours() {
        int contenues = 0;
        List<String> dits = new ArrayList<>();
        for (int graine = 1; graine <= 12; graine++) {
            Auto auto = auto(petites(30 + 20 * graine, 0.5 + graine % 3, graine % 2 * 0.7, graine, 64), 64, 48, GRILLES, 1 + graine % 3);
            Couleur[] image = dessiner(auto);
            double vraie = vraie(auto.getLancer(), image);
            // là où rien n'est vu, aucun intervalle n'est annoncé
            Mesure mesure = auto.getMesure();
            contenues += !mesure.aUnIntervalle || Math.abs(mesure.erreur - vraie) <= mesure.incertitude ? 1 : 0;
            dits.add(vraie + " : " + auto.getMesure().erreur + " ± " + auto.getMesure().incertitude);
        }
        assertTrue(contenues >= 11, dits.toString());
    }

    @Test
    void leChoixEtLaMesureNeDependentPasDesFils() {
        for (double erreur : new double[] {1, 3}) {
            Set<String> choix = new HashSet<>();
            for (int fils : new int[] {1, 2, 7}) {
                Lancer prepare = Dessin.lancer(quelquesBoules(), 64, 40, false);
                Auto auto = new Auto(prepare, echelle(GRILLES), erreur, fils);
                dessiner(auto);
                choix.add(auto.getChoisi() + " " + auto.getMesure().erreur + " " + auto.getMesure().incertitude + " "
                        + auto.getRayonsDesEssais());
            }
            assertEquals(1, choix.size(), choix.toString());
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 7", "2, 2", "3, 1", "1, 300", "33, 65", "201, 151"})
    void touteTailleDImageConvient(int largeur, int hauteur) {
        Auto auto = auto(scene(boule(0, 0, 8, 2, 0.5)), largeur, hauteur, GRILLES, 1);
        dessiner(auto);
        assertTrue(auto.getMesure().erreur < 10, auto.getChoisi() + " " + auto.getVerdict());
    }

    @Test
    void unFilInterrompuAbandonneLesEssais() {
        Thread.currentThread().interrupt();
        try {
            assertThrows(CancellationException.class, () -> auto(quelquesBoules(), 80, 60, GRILLES, 1));
        } finally {
            assertTrue(Thread.interrupted(), "l'interruption reste à voir");
        }
    }

    @Test
    void unReglageFautifEstRefuseCommeUneSection() {
        Map<Variante, Section> fautive = GrilleDEssai.avec(Map.of(new SectionLue("Grille", "m", "3"), 0.0));
        SceneFautive e = assertThrows(SceneFautive.class, () -> auto(CIEL, 4, 3, fautive, 1));
        assertEquals("réglage, [Grille], m : clé inconnue ; attendu : n", e.getMessage());
    }
}
