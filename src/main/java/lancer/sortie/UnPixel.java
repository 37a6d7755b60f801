package lancer.sortie;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.commande.Echec;
import lancer.commande.Pannes;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.RechercheSimple;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Un pixel de l'image, dessiné par les boucles du cours et comme le veut l'échantillonnage de la scène : sans les
 * autres, ou avec ceux de son pavé s'il leur doit des points.
 */
public final class UnPixel implements Echantillonnage, Toile {

    private final Echantillonnage entier;
    private final int xe;
    private final int ye;
    private Couleur couleur;

    private UnPixel(Echantillonnage entier, int xe, int ye) {
        this.entier = entier;
        this.xe = xe;
        this.ye = ye;
    }

    /**
     * @param profondeur nombre de réflexions permises
     * @param xe colonne, de 0 à largeur − 1
     * @param ye ligne, de 0 (en haut) à hauteur − 1
     */
    public static UnPixel dessiner(Scene scene, Camera camera, int profondeur, int xe, int ye) {
        UnPixel pixel = new UnPixel(scene.getEchantillonnage(), xe, ye);
        Scene seul = scene.avec(pixel, scene.getSeuil());
        seul.setRecherche(new RechercheSimple(seul.getObjets(), seul.getCompteurs()));
        new Lancer(seul, camera).TracerPixels(pixel, profondeur, 1);
        return pixel;
    }

    @Override
    public int tracer(Pave pave, Vue vue, Toile toile) {
        if (xe < pave.i0 || xe >= pave.i1 || ye < pave.j0 || ye >= pave.j1) {
            return 0;
        }
        return entier.tracer(entier.parPixel() ? new Pave(xe, ye, xe + 1, ye + 1) : pave, vue, toile);
    }

    @Override
    public void drawPixel(Couleur coul, int i, int j) {
        if (i == xe && j == ye) {
            couleur = coul;
        }
    }

    /** L'écrit en UTF-8, que la console en soit ou non. @throws Echec si elle n'a pu l'être */
    public void ecrire(PrintStream sortie) {
        byte[] octets = (this + System.lineSeparator()).getBytes(StandardCharsets.UTF_8);
        sortie.write(octets, 0, octets.length);
        Pannes.verifier(sortie);
    }

    /** Sa couleur non limitée, et celle de l'écran : {@code somme R V B = #RRGGBB}. */
    @Override
    public String toString() {
        return "somme " + couleur.r + " " + couleur.v + " " + couleur.b
                + String.format(Locale.ROOT, " = #%06X", couleur.getCode() & 0xFFFFFF);
    }
}
