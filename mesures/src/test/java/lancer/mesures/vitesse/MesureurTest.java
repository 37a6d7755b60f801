package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import lancer.Couleur;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.contrat.Echantillonnage;
import lancer.mesures.ImageFausse;
import lancer.mesures.Scenes;
import org.junit.jupiter.api.Test;

/** Mesurer une méthode. */
class MesureurTest {

    private static final Taille TAILLE = new Taille(70, 50, 2);

    private final Scene scene = Scenes.lire(Paths.get("scenes/scene1.ini"));
    private final Mesureur mesureur = new Mesureur(TAILLE, true);

    private static Methode methode(Echantillonnage echantillonnage) {
        return Methode.de(Famille.ECHANTILLONNAGE, "essai", "").echantillonnee(echantillonnage);
    }

    private Mesureur.Mesure mesurer(Methode methode) {
        return mesureur.mesurer(scene, Collections.singletonList(methode)).get(0);
    }

    @Test
    void uneMesureASeptTempsAuMoinsEtLesComptesDUneSeuleImage() {
        Mesureur.Mesure mesure = mesurer(methode(Antialias.coins(2, 0)));
        assertTrue(mesure.temps().nombre() >= Mesureur.REPETITIONS_MIN);
        assertEquals(4 * TAILLE.pixels(), mesure.compteurs.primaires);
        assertEquals(TAILLE.pixels(), mesure.verifies);
    }

    @Test
    void deChaqueMethodeDuCatalogueTousLesPixelsSontVerifiesOuCeQuePermetLeBudget() {
        Catalogue catalogue = new Catalogue(true);
        for (List<Methode> methodes : Arrays.asList(catalogue.echantillonnages(), catalogue.reflets(), catalogue.demandes())) {
            for (Mesureur.Mesure mesure : mesureur.mesurer(scene, methodes)) {
                assertTrue(mesure.verifies >= 16, mesure.methode.cle() + " : " + mesure.verifies + " pixels");
            }
        }
    }

    @Test
    void quandTousCouteraientTropQuelquesPixelsSeulementSontRefaits() {
        Methode methode = methode(Echantillonnage.CENTRE);
        Mesureur.Mesure mesure = mesurer(methode);
        int verifies = new Controle(TAILLE, 1).verifier(methode, scene, mesure.image, mesure.compteurs);
        assertTrue(verifies >= 6 && verifies <= 16, verifies + " pixels, un par pavé");
    }

    @Test
    void uneImageDontUnPixelNEstPasCeluiDesBouclesDuCoursEstRefusee() {
        Methode methode = methode(Echantillonnage.CENTRE);
        Mesureur.Mesure mesure = mesurer(methode);
        Couleur juste = mesure.image.getCouleur(33 * TAILLE.largeur + 41);
        mesure.image.drawPixel(new Couleur(Math.nextUp(juste.r), juste.v, juste.b), 41, 33);
        ImageFausse faute = assertThrows(ImageFausse.class,
                () -> new Controle(TAILLE, 1e12).verifier(methode, scene, mesure.image, mesure.compteurs));
        assertTrue(faute.getMessage().contains("(41, 33)"), faute.getMessage());
    }

    @Test
    void uneImageQuiChangeDUnDessinALAutreEstRefusee() {
        AtomicInteger paves = new AtomicInteger();
        int parImage = 3 * 2;
        // la première fois, et celle de la vérification, elle est juste
        Methode changeante = methode((pave, vue, toile) -> {
            boolean fausse = paves.getAndIncrement() >= 2 * parImage;
            return Echantillonnage.CENTRE.tracer(pave, (xe, ye) -> new Couleur(fausse ? 0.5 : 0.25), toile);
        });
        ImageFausse faute = assertThrows(ImageFausse.class, () -> new Mesureur(TAILLE, false).mesurer(scene,
                Collections.singletonList(changeante)));
        assertTrue(faute.getMessage().contains("diffèrent"), faute.getMessage());
    }

    @Test
    void uneMethodeQuiPartageDesRayonsEntrePixelsSansLeDireEstRefusee() {
        Echantillonnage partage = Antialias.partage(4, 0.1);
        Scene tournesol = Scenes.lire(Paths.get("scenes/tournesol.ini"));
        assertThrows(ImageFausse.class, () -> mesureur.mesurer(tournesol, Collections.singletonList(methode(partage))));
        Methode dite = Methode.de(Famille.ECHANTILLONNAGE, "essai", "").partagee(partage);
        assertTrue(mesureur.mesurer(tournesol, Collections.singletonList(dite)).get(0).verifies >= 100);
    }

    @Test
    void lesComptesNeDependentPasDuNombreDeFils() {
        Methode methode = Methode.de(Famille.ECHANTILLONNAGE, "essai", "").partagee(Antialias.partage(8, 0.06));
        Mesureur.Mesure deux = mesurer(methode);
        Mesureur.Mesure un = new Mesureur(new Taille(70, 50, 1), true).mesurer(scene, Collections.singletonList(methode)).get(0);
        assertEquals(un.compteurs.rayons(), deux.compteurs.rayons());
        assertEquals(un.compteurs.testsSpheres, deux.compteurs.testsSpheres);
        assertTrue(un.image.memesBits(deux.image));
    }
}
