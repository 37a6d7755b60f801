package lancer.mesures.noyaux;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import org.junit.jupiter.api.Test;
import org.openjdk.jmh.runner.options.CommandLineOptions;

/** Les noyaux. */
class NoyauxTest {

    @Test
    void jmhLesMesureTousChacunAvecSonErreur() throws Exception {
        ByteArrayOutputStream sortie = new ByteArrayOutputStream();
        Noyaux.mesurer(new CommandLineOptions("-f", "0", "-wi", "0", "-i", "2", "-r", "5ms"), new PrintStream(sortie, true, "UTF-8"));
        String texte = sortie.toString("UTF-8");
        assertEquals(9, texte.split("\\R").length - 2, texte);
        for (String noyau : new String[] {"NoyauIntersection.distance +cas=touche", "NoyauIntersection.distance +cas=manque",
            "NoyauIntersection.distance +cas=dedans", "NoyauRecherche.plusProche +recherche=simple",
            "NoyauRecherche.plusProche +recherche=programme", "NoyauRecherche.estCachee +recherche=simple",
            "NoyauRecherche.estCachee +recherche=programme", "NoyauContact.couleur +ns=40 ", "NoyauContact.couleur +ns=40.5"}) {
            assertTrue(texte.matches("(?s).*\n" + noyau + " +[0-9.]+ +± [0-9.?]+ +ns/op.*"), noyau + " dans :\n" + texte);
        }
    }

    @Test
    void leRayonToucheManqueOuPartDeLInterieurCommeLeNomDuCasLeDit() {
        for (String cas : new String[] {"touche", "manque", "dedans"}) {
            NoyauIntersection noyau = new NoyauIntersection();
            noyau.cas = cas;
            noyau.semer();
            assertEquals(cas.equals("manque") ? 0 : NoyauIntersection.SPHERES, noyau.touchees(), cas);
            assertEquals(cas.equals("dedans") ? NoyauIntersection.SPHERES : 0, noyau.autourDuDepart(), cas);
            assertEquals(cas.equals("manque"), Double.isInfinite(noyau.distance()), cas);
        }
    }

    @Test
    void lesDeuxRecherchesRepondentLaMemeChose() throws IOException {
        NoyauRecherche simple = new NoyauRecherche();
        simple.recherche = "simple";
        simple.preparer();
        NoyauRecherche programme = new NoyauRecherche();
        programme.recherche = "programme";
        programme.preparer();
        assertEquals(simple.estCachee(), programme.estCachee());
        assertTrue(simple.estCachee() > 0 && simple.estCachee() < NoyauRecherche.RAYONS, "ombres et lumières");
        assertEquals(simple.plusProche(), programme.plusProche());
    }

    @Test
    void uneRechercheQuiSeTrompeNEstPasMesuree() {
        NoyauRecherche noyau = new NoyauRecherche();
        noyau.recherche = "programme";
        IllegalStateException refus = assertThrows(IllegalStateException.class, () -> noyau.preparer(SansOmbre::new));
        assertTrue(refus.getMessage().contains("aucun temps"), refus.getMessage());
    }

    /** Juste, sauf que rien n'y cache jamais rien. */
    private static final class SansOmbre implements Recherche {

        private final Recherche autre;

        SansOmbre(Recherche autre) {
            this.autre = autre;
        }

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            autre.plusProche(incident, saufLui);
        }

        @Override
        public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
            return false;
        }

        @Override
        public Recherche pourUnFil(Compteurs compteurs) {
            return new SansOmbre(autre.pourUnFil(compteurs));
        }
    }

    @Test
    void chaqueContactEstEclaireEtPasDeuxPareillement() {
        NoyauContact noyau = new NoyauContact();
        noyau.ns = 40;
        noyau.preparer();
        for (int k = 0; k < NoyauContact.CONTACTS; k++) {
            assertNotEquals(new Couleur(), noyau.couleur(k), "contact " + k);
        }
        assertNotEquals(noyau.couleur(0), noyau.couleur(1));
    }
}
