package lancer.fils;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import org.junit.jupiter.api.Test;

/** Les pixels qui échouent : comptés, peints en magenta, et le premier nommé. */
class FautesTest {

    private final Fautes fautes = new Fautes(10);

    /** Un échec tel que Java en fait mille fois au même endroit : une fois compilé, il n'a plus de pile. */
    private static final class Repete extends RuntimeException {
        private static final long serialVersionUID = 1;

        Repete(boolean pile) {
            super("boum", null, false, pile);
        }
    }

    @Test
    void laPremiereFauteEstCelleDeLaPremiereLigneParmiCellesQueJavaSitue() {
        fautes.tolerer();
        assertNull(fautes.enMots());
        fautes.noter(new Repete(true), 5.5, 5.5);
        assertEquals("un pixel n'a pu être calculé", fautes.enMots());
        fautes.noter(new Repete(false), 1.5, 1.5);
        assertEquals(5, fautes.getPremiere().y, "un échec sans pile ne dit pas où il est");
        fautes.noter(new Repete(true), 2.5, 1.5);
        fautes.noter(new Repete(true), 9.5, 3.5);
        assertEquals("2, 1", fautes.getPremiere().x + ", " + fautes.getPremiere().y);
        assertEquals("4 pixels n'ont pu être calculés", fautes.enMots());
    }

    @Test
    void unPixelFautifEstMagentaEtLuiSeulEstRepeint() {
        fautes.tolerer();
        assertEquals(new Couleur(1, 0, 1), fautes.noter(new Repete(true), 3.5, 2.5));
        fautes.noter(new Repete(true), 9.5, 9.5);
        List<String> peints = new ArrayList<>();
        fautes.peindre(new Pave(0, 0, 8, 8), (couleur, i, j) -> peints.add(couleur + " " + i + ", " + j));
        assertEquals("[" + new Couleur(1, 0, 1) + " 3, 2]", peints.toString());
    }

    @Test
    void unEchecQuiNEstPasTolereArreteLeDessin() {
        RuntimeException cause = new Repete(true);
        assertEquals(cause, assertThrows(PixelFautif.class, () -> fautes.noter(cause, 1.5, 1.5)).getCause());
        assertNull(fautes.getPremiere());
    }

    /** Même si les échecs sont tolérés. */
    @Test
    void niUnArretNiLeManqueDeMemoireNEstUnEchecDuPixel() {
        for (Throwable arret : new Throwable[] {new CancellationException(), new OutOfMemoryError()}) {
            Modele.Construction modele = new Modele.Construction();
            modele.setAtmosphere((vue, distance) -> {
                if (arret instanceof Error) {
                    throw (Error) arret;
                }
                throw (RuntimeException) arret;
            });
            Lancer lancer = new Lancer(new Scene(List.of(), List.of()).avec(modele.construire()),
                    new Camera(4, 3));
            lancer.getAtelier().getFautes().tolerer();
            assertSame(arret, assertThrows(arret.getClass(), () -> lancer.TracerImage((couleur, i, j) -> { }, 0, 2)));
            assertNull(lancer.getAtelier().getFautes().enMots());
        }
    }
}
