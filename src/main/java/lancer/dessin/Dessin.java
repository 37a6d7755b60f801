package lancer.dessin;

import java.text.NumberFormat;
import java.util.Locale;
import lancer.fils.Traceur;
import lancer.image.ImageMemoire;
import lancer.scene.Origines;

/** Une image, et ce dont elle est l'image : la scène préparée, ses réglages, ce qui l'a dessinée ou la dessine. */
public final class Dessin {

    /** Le fichier de la scène. */
    public final String fichier;

    /** Origines, dans ce fichier, des objets et des lampes de la scène. */
    public final Origines origines;
    public final ReglagesDessin reglages;
    public final ImageMemoire image;

    /** Traceur de l'image, avec la scène réglée et la caméra. */
    public final Traceur traceur;

    /** @param image {@code null}, comme {@code traceur}, tant que la scène n'est que lue */
    Dessin(String fichier, Origines origines, ReglagesDessin reglages, ImageMemoire image, Traceur traceur) {
        this.fichier = fichier;
        this.origines = origines;
        this.reglages = reglages;
        this.image = image;
        this.traceur = traceur;
    }

    /** Les rayons et le temps de ce dessin achevé. */
    public String getCout() {
        // l'espace fine des nombres français manque à bien des polices
        String rayons = NumberFormat.getIntegerInstance(Locale.FRANCE).format(traceur.getCompteurs().rayons())
                .replace('\u202F', '\u00A0');
        return rayons + String.format(Locale.FRANCE, " rayons en %.2f s", traceur.getDureeNs() / 1e9);
    }
}
