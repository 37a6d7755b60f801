package lancer.fenetre.etat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import lancer.scene.SceneLue;
import lancer.scene.Surveillance;
import org.junit.jupiter.api.Test;

/** Mille suites d'événements tirés au hasard : ce qui est vrai après chacun, quel que soit le moment. */
class SuitesAuHasardTest extends EssaiSuite {

    private static final int SUITES = 1000;
    private static final int LONGUEUR = 25;
    /** Les premières arrivées, celles qui ne demandent ni valeur, ni question. */
    private static final int DU_HASARD = 16;

    private final SplittableRandom hasard = new SplittableRandom(77);
    /** La scène que F5, ou une réponse, a voulu oublier en dernier. */
    private SceneLue oubliee;

    private String geste() {
        List<String> noms = new ArrayList<>(arrivees.keySet());
        String[] autres = {"tape ns=" + hasard.nextInt(50), "flèche ns=" + hasard.nextInt(50), "tape rayon=-1", "clic 16 11", "place 10 7",
            "vue normales", "vue image"};
        int rang = hasard.nextInt(DU_HASARD + autres.length);
        return rang < DU_HASARD ? noms.get(rang) : autres[rang - DU_HASARD];
    }

    private void unPas(List<String> fichiers) {
        int tirage = hasard.nextInt(30);
        Etat avant = etat;
        if (etat.question != null) {
            repondreALaQuestion(tirage);
        } else if (tirage < 18) {
            faire(geste());
        } else if (tirage < 24 && !attendus.isEmpty()) {
            repondre(new ArrayList<>(attendus.keySet()).get(hasard.nextInt(attendus.size())));
        } else if (tirage < 26) {
            fichier(fichiers.get(hasard.nextInt(2)), hasard.nextInt(5) == 0 ? "fautif" : ROUGE.replace("40", "" + hasard.nextInt(99)));
        } else if (tirage < 28) {
            fichiers.forEach(nom -> observer(dossier.resolve(nom)));
        } else if (tirage == 28) {
            oubliee = etat.demande.lue;
            arrive(Suite::relire);
        } else {
            arrive(suite -> suite.ouvrir(dossier.resolve(fichiers.get(hasard.nextInt(2))).toString()));
        }
        verifier(avant);
    }

    private void repondreALaQuestion(int tirage) {
        boolean sous = journal.stream().reduce((a, b) -> b.matches("(demanderDE|proposer).*") ? b : a).get().startsWith("proposer");
        if (sous) {
            arrive(tirage < 15 ? Suite::rester : suite -> suite.ecrireSous(dossier.resolve("sous.ini").toString()));
        } else if (tirage < 10) {
            oubliee = etat.demande.lue;
            arrive(Suite::oublier);
        } else {
            arrive(tirage < 20 ? Suite::rester : Suite::accepterDEcrire);
        }
    }

    private void verifier(Etat avant) {
        if (etat.demande == null) {
            return;
        }
        if (avant.estDeplace() && !etat.estDeplace()) {
            boolean defait = etat.demande.lue == avant.ecrite.lue;
            boolean ecrit = avant.getOccupation() != null && avant.getOccupation().equals("écriture");
            assertTrue(defait || ecrit || avant.demande.lue == oubliee, "perdu sans question : " + journal);
        }
        assertTrue(etat.montre.dessin == null || !etat.montre.entier || etat.enCours()
                || etat.montreUneAutre() || etat.montre.dessin.demande.equals(etat.demande) || etat.travail.fin
                != Travail.Fin.ACHEVE, "l'image est celle qui est demandée");
        assertTrue(etat.getOccupation() == null || etat.geste == null, "rien ne se tire pendant une lecture");
        assertTrue(!etat.seLit() || etat.ecriture == null, "rien ne s'écrit pendant une lecture");
        // aucun ordre pour rien : le même état n'en donne pas
        int ordres = journal.size();
        Etat present = etat;
        arrive(suite -> { });
        assertEquals(ordres, journal.size(), journal.toString());
        assertTrue(present == etat, "sans événement, le même état");
    }

    @Test
    void rienNeSePerdSansEtreDemandeEtLeTitreLImageEtLeFichierSAccordent() {
        for (int suite = 0; suite < SUITES; suite++) {
            List<String> fichiers = Arrays.asList("boule.ini", "autre.ini");
            for (String nom : fichiers) {
                fichier(nom, ROUGE);
            }
            ouvrir();
            attendus.clear();
            montrerLaBoule();
            for (int pas = 0; pas < LONGUEUR; pas++) {
                unPas(fichiers);
            }
            if (etat.question != null) {
                arrive(Suite::rester);
            }
            arrive(Suite::lacher);
            executer();
            observer(Paths.get(etat.source.fichier));
            executer();
            if (!etat.estDeplace() && etat.travail.fin == Travail.Fin.ACHEVE && etat.question == null) {
                assertEquals(Surveillance.version(etat.source.fichier), etat.source.version, "au repos, le fichier est lu");
            }
        }
    }
}
