package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.swing.JComboBox;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.fenetre.etat.Essai;
import lancer.fenetre.etat.Suite;
import org.junit.jupiter.api.Test;

/** La fenêtre, avec l'anticrénelage : les échantillons du pixel se voient, et celui du centre est expliqué. */
class VueAntialiasTest extends EssaiVue {

    @Test
    void lesEchantillonsSontDitsEtCeluiDuCentreEstExplique() {
        ouvrir(ROUGE + "[Antialias]\nn=3\nseuil=0\n", "--taille=160x120");
        faire("clic 80 55, achève");
        assertTrue(recit().contains("\nchaîne de l'échantillon 80.500 55.500\n"), recit());
        assertTrue(recit().contains("9 échantillons") && recit().contains("80.167 55.167 : "), recit());
        assertTrue(dit("verdict").startsWith("Au bit près"), dit("verdict"));
    }

    @Test
    void laMethodeSeChoisitParSonMotDansUneListe() {
        ouvrir(ROUGE + "[Antialias]\nn=3\n", "--taille=160x120");
        faire("F2");
        composant("Antialias.methode", JComboBox.class).selectWithKeyChar('p');
        faire("achève");
        assertArrayEquals(sansFenetre(ROUGE + "[Antialias]\nn=3\nmethode=partage\n"), etat.getImageEntiere().codes);
    }

    @Test
    void f3NommeLaMethodeDeChaqueImageEtMontreCelleQueLOnChoisit() {
        ouvrir(ROUGE, "--taille=160x120");
        faire("F3, achève");
        Essai voulu = etat.mesures.essais.values().stream().filter(essai -> essai.direLeReglage()
                .equals("[Antialias] n=2 methode=partage seuil=0.15, 1000 réflexions, seuil 1/128")).findFirst().get();
        arrive(suite -> suite.viser(voulu.reglages));
        arrive(Suite::prendre);
        faire("achève");
        assertTrue(dit("resume").contains(", 1000 réflexions, seuil 1/128, [Antialias] n=2 "), dit("resume"));
        assertArrayEquals(sansFenetre(ROUGE + "[Antialias]\nn=2\nmethode=partage\nseuil=0.15\n", "--reflets=1000", "--seuil=0.0078125"),
                etat.getImageEntiere().codes);
    }

    @Test
    void leResumeDUnReglageDeF3NeReduitPasLImage() {
        ouvrir(ROUGE, "--taille=640x480");
        Reglages presents = etat.demande.reglages;
        Variante antialias = presents.getEssayee();
        Section section = presents.getSectionEntiere(antialias).avec("n", "8", "").avec("methode", "partage", "").avec("seuil", "0.1", "");
        arrive(suite -> suite.regler(presents.avec(Option.REFLETS, 1000).avec(Option.SEUIL, 1.0 / 256).avecSection(antialias, section)));
        cadre.validate();
        assertEquals(640, panneau.getWidth());
        assertEquals(480, panneau.getHeight());
    }

    @Test
    void unEchecDUneClasseDuCoursEstSitueDansLeCoursEtNonDansLAnticrenelage() {
        apresLecture = lue -> lue.objets.get(0).setKd(null);
        ouvrir(ROUGE, "--taille=160x120");
        assertTrue(message().contains(" pixels n'ont pu être calculés") && message().contains(" (lancer.Objet3D.getColor, Objet3D.java:"),
                message());
    }
}
