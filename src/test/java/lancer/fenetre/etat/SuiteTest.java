package lancer.fenetre.etat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import lancer.commande.Etape;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.scene.Surveillance;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ce qui suit de ce qui arrive : l'état, et ce qu'il fait faire. */
class SuiteTest extends EssaiSuite {

    private void fait(String... ordres) {
        assertEquals(Arrays.asList(ordres), journal);
        journal.clear();
    }

    @Test
    void unReglageDePlusFaitUnSeulDessinEtCeQuiNeChangeRienNeFaitPasDEtat() {
        montrerLaBoule();
        Etat demande = arrive(suite -> suite.reflechir(true));
        fait("dessiner");
        assertEquals(10, demande.demande.reglages.get(Option.REFLETS));
        executer();
        assertTrue(etat.montre.entier);
        assertEquals(etat.demande, etat.montre.dessin.demande);
        assertSame(etat, arrive(suite -> suite.placer(32, 24)), "une taille qui ne change pas");
        assertSame(etat, arrive(suite -> suite.tenir(false)));
        fait();
    }

    @Test
    void unReglageDePlusNePublieQueLaDemandeLeBrouillonLImageEtLExplicationFaiteUneFois() {
        montrerLaBoule();
        arrive(suite -> suite.expliquer(new Pixel(16, 11)));
        executer();
        journal.clear();
        publies = 0;
        arrive(suite -> suite.reflechir(true));
        executer();
        fait("dessiner", "expliquer 16 11");
        assertEquals(4, publies);
    }

    @Test
    void laReponseDUnOrdreRemplaceNeChangeRien() {
        montrerLaBoule();
        arrive(suite -> suite.reflechir(true));
        int ancien = dernier;
        Runnable attendu = attendus.remove(ancien);
        arrive(Suite::relire);
        fait("dessiner", "arreter", "lire boule.ini");
        Etat avant = etat;
        attendu.run();
        assertSame(avant, etat);
    }

    /** 1.1 : ni écriture, ni geste, tant que le fichier se relit ; un geste commencé s'achève avant. */
    @Test
    void aucunGesteSurLaScenePendantUneLectureNiUneEcriture() throws IOException {
        montrerLaBoule();
        tirer();
        executer();
        String tiree = section("centre");
        arrive(Suite::relire);
        journal.clear();
        for (Suite.Evenement geste : Arrays.<Suite.Evenement>asList(Suite::ecrire, Suite::defaire,
                suite -> suite.saisir(16, 11, 2), suite -> suite.changer("Sphere 1", "rayon", "2", false))) {
            arrive(geste);
            assertEquals("lecture du fichier : la scène ne se change pas encore", etat.avis.texte);
            assertEquals(tiree, section("centre"));
        }
        assertTrue(etat.estDeplace());
        fait();
        executer();
        assertEquals("0 0.2 6", section("centre"), "F5 le veut");
        assertEquals(ROUGE, lu(boule));
        tirer();
        executer();
        journal.clear();
        arrive(Suite::ecrire);
        arrive(suite -> suite.saisir(16, 11, 2));
        assertNull(etat.geste);
        assertEquals("écriture du fichier : la scène ne se change pas encore", etat.avis.texte);
        executer();
        assertFalse(etat.estDeplace());
        assertTrue(lu(boule).contains("centre=" + section("centre") + "\n"));
        observer(boule);
        fait("ecrire");
    }

    /** 1.2 : un point de F3 est de la scène où il a été mesuré. */
    @Test
    void unPointMesureSurUneSceneNeSePrendPasPourUneAutre() throws IOException {
        montrerLaBoule();
        arrive(Suite::mesurer);
        executer();
        Reglages premier = etat.mesures.essais.keySet().iterator().next();
        Path autre = fichier("autre.ini", ROUGE.replace("rayon=1", "rayon=2"));
        arrive(suite -> suite.ouvrir(autre.toString()));
        arrive(suite -> suite.prendre(premier));
        assertEquals(5, etat.demande.reglages.get(Option.REFLETS), "elle se lit");
        executer();
        assertEquals("lancer — autre.ini", etat.getTitre("lancer"));
        arrive(suite -> suite.expliquer(new Pixel(3, 3)));
        arrive(suite -> suite.choisirLEtape(Etape.PHONG));
        arrive(suite -> suite.prendre(premier.avec(Option.REFLETS, 3)));
        assertEquals(Etape.PHONG, etat.demande.reglages.get(Option.ETAPE));
    }

    /** 1.4 et 2.2 : un fichier qui change pendant qu'un changement n'est pas écrit. */
    @Test
    void unFichierQuiChangeNEstPasLuTantQuUnChangementNEstPasEcrit() throws IOException {
        montrerLaBoule();
        tirer();
        executer();
        journal.clear();
        Files.write(boule, Files.readAllBytes(boule));
        observer(boule);
        assertEquals("", etat.getAlerte(), "les mêmes octets ne sont pas un changement");
        fichier("boule.ini", ROUGE.replace("ns=40", "ns=41"));
        observer(boule);
        assertEquals("boule.ini a changé sur le disque ; F5 le relit et oublie ce que vous avez changé, Ctrl+E l'écrit dans le "
                + "nouveau fichier", etat.getAlerte());
        arrive(Suite::fermerLeMessage);
        assertFalse(etat.getAlerte().isEmpty(), "un clic ne l'efface pas");
        fait();
        String tiree = section("centre");
        arrive(Suite::ecrire);
        executer();
        fait("ecrire", "lire boule.ini");
        assertEquals(ROUGE.replace("ns=40", "ns=41").replace("0 0.2 6", tiree), lu(boule));
        assertEquals("41", section("ns"));
        assertEquals("", etat.getAlerte());
        assertFalse(etat.estDeplace());
    }

    @Test
    void ctrlZQuiNeLaisseRienAEcrireFaitLireLeFichierQuiAChange() throws IOException {
        montrerLaBoule();
        tirer();
        executer();
        fichier("boule.ini", ROUGE.replace("ns=40", "ns=41"));
        observer(boule);
        journal.clear();
        arrive(Suite::defaire);
        executer();
        fait("lire boule.ini");
        assertEquals("41", section("ns"));
        fichier("boule.ini", ROUGE);
        observer(boule);
        executer();
        assertEquals("40", section("ns"), "sans changement, il se lit");
    }

    @Test
    void unFichierQuiRevientTelQuIlEtaitNApprendRien() throws IOException {
        montrerLaBoule();
        tirer();
        executer();
        Files.delete(boule);
        observer(boule);
        assertTrue(etat.getAlerte().startsWith("boule.ini n'est plus sur le disque"), etat.getAlerte());
        fichier("boule.ini", ROUGE);
        observer(boule);
        assertEquals("", etat.getAlerte());
        assertTrue(etat.estDeplace());
    }

    @ParameterizedTest
    @CsvSource({"ns=40, ns=-1, hors limites", "[Sphere 1], [Sphere 2], section absente", "ROUGE, , fichier"})
    void unFichierQuiNePeutRecevoirLeChangementEnFaitProposerUnAutre(String avant, String apres, String faute) throws IOException {
        montrerLaBoule();
        tirer();
        executer();
        if (apres == null) {
            Files.delete(boule);
        } else {
            fichier("boule.ini", ROUGE.replace(avant, apres));
        }
        journal.clear();
        arrive(Suite::ecrire);
        executer();
        assertTrue(journal.get(1).startsWith("proposer après") && journal.get(1).contains(faute), journal.toString());
        assertTrue(etat.estDeplace());
        journal.clear();
        Path ailleurs = dossier.resolve("ailleurs.ini");
        arrive(suite -> suite.ecrireSous(ailleurs.toString()));
        executer();
        fait("ecrire sous ailleurs.ini", "surveiller ailleurs.ini", "lire ailleurs.ini");
        assertEquals("lancer — ailleurs.ini", etat.getTitre("lancer"));
        assertEquals(ROUGE.replace("0 0.2 6", section("centre")), lu(ailleurs));
    }

    /** 1.5 : la touche tenue qui perd son relâchement. */
    @Test
    void lImageDAvantNeResteQueTantQueSaToucheEstTenue() {
        montrerLaBoule();
        arrive(suite -> suite.reflechir(false));
        executer();
        for (Suite.Evenement ailleurs : Arrays.<Suite.Evenement>asList(suite -> suite.montrer(Onglet.REGLAGES), Suite::mesurer,
                suite -> suite.tenir(false), suite -> suite.expliquer(new Pixel(1, 1)))) {
            arrive(suite -> suite.tenir(true));
            assertSame(etat.montre.avant, etat.getVisible());
            arrive(ailleurs);
            assertSame(etat.montre.dessin, etat.getVisible());
        }
    }

    /** 1.6 : deux fermetures pendant une écriture lente n'en font qu'une, et ne demandent rien. */
    @Test
    void fermerDeuxFoisPendantUneEcritureFermeUneFoisEcrit() throws IOException {
        montrerLaBoule();
        tirer();
        executer();
        journal.clear();
        arrive(Suite::ecrire);
        arrive(Suite::quitter);
        arrive(Suite::quitter);
        fait("ecrire");
        executer();
        fait("fermer", "terminer");
        assertTrue(lu(boule).contains(section("centre")));
    }

    @Test
    void fermerSansEcrireDemandeUneFoisEtEcrireFermeUneFoisEcrit() throws IOException {
        montrerLaBoule();
        tirer();
        executer();
        journal.clear();
        arrive(Suite::quitter);
        arrive(Suite::quitter);
        arrive(Suite::ecrire);
        fait("demander boule.ini");
        arrive(Suite::rester);
        arrive(Suite::quitter);
        fichier("boule.ini", ROUGE.replace("ns=40", "ns=41"));
        observer(boule);
        arrive(Suite::accepterDEcrire);
        executer();
        fait("demander boule.ini", "ecrire", "fermer", "terminer");
        assertEquals(ROUGE.replace("ns=40", "ns=41").replace("0 0.2 6", section("centre")), lu(boule));
    }

    @Test
    void ouvrirUneAutreSceneQueCelleQuiEstChangeeAttendLaReponse() throws IOException {
        montrerLaBoule();
        tirer();
        executer();
        Path fautive = fichier("fautive.ini", ROUGE.replace("rayon=1", "rayon=-1"));
        arrive(suite -> suite.ouvrir(fautive.toString()));
        arrive(Suite::oublier);
        executer();
        assertEquals("lancer — fautive.ini (boule.ini •)", etat.getTitre("lancer"));
        assertTrue(etat.getFautesALire().get(0).contains("rayon"), etat.getFautesALire().toString());
        assertEquals("l'image qui reste est celle de boule.ini", etat.getFautesALire().get(1));
        journal.clear();
        arrive(Suite::ecrire);
        executer();
        fait("ecrire");
        assertEquals("lancer — fautive.ini", etat.getTitre("lancer"));
        assertTrue(etat.getFautesALire().get(0).contains("rayon"), "la faute se lit toujours");
        arrive(Suite::fermerLeMessage);
        assertEquals(Collections.emptyList(), etat.getFautesALire());
        arrive(Suite::relire);
        executer();
        assertEquals(2, etat.getFautesALire().size(), "relue, elle se dit de nouveau");
    }

    @Test
    void ceQuOnARenonceAEcrireLaissePlaceALaSceneDemandeeDesQuElleEstCorrigee() throws IOException {
        montrerLaBoule();
        tirer();
        Path fautive = fichier("fautive.ini", "fautif");
        arrive(suite -> suite.ouvrir(fautive.toString()));
        arrive(Suite::oublier);
        executer();
        fichier("fautive.ini", ROUGE);
        observer(fautive);
        executer();
        assertEquals("lancer — fautive.ini", etat.getTitre("lancer"));
        assertEquals(ROUGE, lu(boule));
    }

    @Test
    void unChangementDeLImageQuiResteNeSePerdPasQuandLeFichierDemandeSeCorrige() throws IOException {
        montrerLaBoule();
        Path fautive = fichier("fautive.ini", "fautif");
        arrive(suite -> suite.ouvrir(fautive.toString()));
        executer();
        tirer();
        String tiree = section("centre");
        fichier("fautive.ini", ROUGE);
        observer(fautive);
        executer();
        assertEquals("fautive.ini a changé sur le disque ; F5 le relit et oublie ce que vous avez changé dans boule.ini, Ctrl+E l'y "
                + "écrit d'abord", etat.getAlerte());
        arrive(Suite::ecrire);
        executer();
        assertEquals(ROUGE.replace("0 0.2 6", tiree), lu(boule));
        assertEquals("lancer — fautive.ini", etat.getTitre("lancer"));
        assertFalse(etat.montreUneAutre());
    }

    /** 2.3 : une valeur qui se tape, des flèches, et leur suite qui se défait d'un coup. */
    @Test
    void unNombreSeTapeSeRefuseEtSeDefait() throws IOException {
        montrerLaBoule();
        arrive(suite -> suite.changer("Sphere 1", "rayon", "-1", false));
        assertTrue(etat.avis.texte.matches(".*boule.ini, ligne 3, \\[Sphere 1], rayon : hors limites : « -1 » ; attendu : .*"),
                etat.avis.texte);
        arrive(suite -> suite.changer("Sphere 1", "rayon", "1.5", false));
        assertEquals("", etat.avis.texte, "une valeur possible ôte le refus");
        for (String rayon : new String[] {"1.6", "1.7", "1.8"}) {
            arrive(suite -> suite.changer("Sphere 1", "rayon", rayon, true));
        }
        arrive(suite -> suite.changer("Lampe 1", "couleur", "1 1 1", true));
        arrive(Suite::defaire);
        assertEquals("1.8", section("rayon"));
        arrive(Suite::defaire);
        assertEquals("1.5", section("rayon"));
        arrive(Suite::defaire);
        assertEquals("1", section("rayon"));
        assertFalse(etat.estDeplace());
        arrive(suite -> suite.changer("Sphere 1", "Ks", "1 1 1", false));
        arrive(suite -> suite.changer("Lampe 1", "couleur", "2 2 2", false));
        executer();
        arrive(Suite::ecrire);
        executer();
        assertEquals(ROUGE.replace("0.3 0.3 0.3", "1 1 1").replace("0.9 0.9 0.85", "2 2 2"), lu(boule));
    }

    @Test
    void ceQuiEstPrisSansEtreTireMontreSesNombres() {
        montrerLaBoule();
        double[] etoile = {16, 11};
        arrive(suite -> suite.saisir(etoile[0], etoile[1], 2));
        arrive(Suite::lacher);
        executer();
        assertEquals("Sphere 1", etat.getSectionChoisie());
        assertFalse(etat.estDeplace());
        arrive(suite -> suite.expliquer(new Pixel(0, 0)));
        executer();
        assertNull(etat.getSectionChoisie(), "le ciel n'a pas de section");
        arrive(suite -> suite.expliquer(new Pixel(16, 11)));
        executer();
        assertEquals("Sphere 1", etat.getSectionChoisie());
        arrive(suite -> suite.changer("Sphere 1", "rayon", "1.5", true));
        assertEquals("Sphere 1", etat.getSectionChoisie(), "pendant que l'image suit");
        executer();
        assertEquals("Sphere 1", etat.getSectionChoisie());
    }

    /** 2.3 : des flèches poussent la boule hors du pixel qui la montrait. */
    @Test
    void lesNombresRestentCeuxDeLaSectionQueLOnChange() throws IOException {
        montrerLaBoule();
        arrive(suite -> suite.expliquer(new Pixel(16, 11)));
        executer();
        arrive(suite -> suite.changer("Sphere 1", "centre", "9 0.2 6", true));
        executer();
        assertEquals("Sphere 1", etat.getSectionChoisie());
        arrive(suite -> suite.montrer(Onglet.REGLAGES));
        arrive(suite -> suite.changer("Sphere 1", "ns", "41", false));
        assertEquals(Onglet.REGLAGES, etat.ecran.onglet, "un champ quitté pour un autre onglet ne rouvre pas le sien");
        fichier("boule.ini", ROUGE.replace("[Sphere 1]", "[Sphere 2]"));
        arrive(Suite::relire);
        arrive(suite -> suite.montrer(Onglet.PIXEL));
        executer();
        assertEquals("Sphere 2", etat.getSectionChoisie(), "à défaut, ceux de ce que voit le pixel");
        arrive(suite -> suite.changer("Sphere 1", "ns", "42", false));
        assertTrue(etat.avis.texte.contains("[Sphere 1] : section absente du fichier"), etat.avis.texte);
    }

    @Test
    void echapLacheCeQuiEstTirePuisArretePuisFerme() {
        montrerLaBoule();
        arrive(suite -> suite.expliquer(new Pixel(16, 11)));
        executer();
        arrive(suite -> suite.saisir(16, 11, 2));
        arrive(suite -> suite.tirer(20, 11));
        arrive(Suite::echapper);
        assertEquals("0 0.2 6", section("centre"));
        arrive(suite -> suite.tirer(25, 11));
        assertEquals("0 0.2 6", section("centre"), "lâché, il ne suit plus");
        arrive(Suite::echapper);
        assertFalse(etat.enCours());
        arrive(Suite::echapper);
        assertNull(etat.ecran.onglet);
        journal.clear();
        arrive(Suite::fermerLeMessage);
        observer(boule);
        fait();
    }

    @Test
    void uneLectureArreteeNeRecommencePasDElleMeme() throws IOException {
        montrerLaBoule();
        fichier("boule.ini", ROUGE.replace("ns=40", "ns=41"));
        observer(boule);
        arrive(Suite::echapper);
        fait("lire boule.ini", "arreter");
        observer(boule);
        fait();
        attendus.clear();
        fichier("boule.ini", ROUGE.replace("ns=40", "ns=42"));
        observer(boule);
        executer();
        assertEquals("42", section("ns"), "un autre changement se lit");
        assertEquals(Surveillance.version(boule.toString()), etat.source.version);
    }

    @Test
    void lesTextesOntDeDixATrenteDeuxPoints() {
        for (int k = 0; k < 40; k++) {
            arrive(suite -> suite.agrandir(1));
        }
        assertEquals(32, etat.ecran.police);
        arrive(suite -> suite.agrandir(-50));
        assertEquals(10, etat.ecran.police);
        journal.clear();
        arrive(suite -> suite.agrandir(-1));
        fait();
    }

    @ParameterizedTest
    @CsvSource({"0.50,0,1,0.51", "1,1,-1,0", "0.9 0.15 0.1,5,10,0.9 0.25 0.1", "0.9 0.15 0.1,12,-1,0.9 0.15 0.0", "40,0,10,50",
        "-4 6 -3,0,1,-3 6 -3", "1.5e-3,0,1,0.0016", "abc,0,1,", "'',0,1,", "5.,1,1,6", ".5,0,1,0.6"})
    void unPasEstUneUniteDuDernierChiffreEcrit(String texte, int place, int pas, String voulu) {
        assertEquals(voulu, Pas.changer(texte, place, pas));
    }
}
