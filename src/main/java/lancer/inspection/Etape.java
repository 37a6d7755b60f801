package lancer.inspection;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.PointContact;
import lancer.Vecteur;

/** Vue d'un rayon de la chaîne : un contact et ses lampes, ou le ciel. Ce qui n'a pas été calculé est nul. */
public final class Etape {

    /** Rang dans la chaîne, 1 pour le rayon parti de l'écran. */
    public final int numero;

    /** Contact rencontré, {@code null} pour le ciel. */
    public final PointContact contact;

    /** Direction du rayon. */
    final Vecteur V;

    public final List<Eclairage> lampes = new ArrayList<>();

    /** Demi-corde de la sphère rencontrée, NaN si ce n'en est pas une. */
    double h = Double.NaN;

    /** Les deux plus proches des autres objets que les boucles du cours trouvent sur ce rayon, s'il y en a. */
    List<PointContact> rivaux = Collections.emptyList();
    Vecteur N;
    Vecteur R;

    /** Le produit des Ks, si un reflet était permis ; et ce reflet, Ks ⊗ ce que voit l'étape suivante. */
    Couleur poids;
    Couleur reflet;
    Couleur somme;

    /** Part de l'air, NaN s'il n'en dit rien. */
    double k = Double.NaN;
    Couleur vue;

    Etape(int numero, Vecteur V, PointContact contact) {
        this.numero = numero;
        this.V = V;
        this.contact = contact;
    }

    /** Longueur du rayon, +∞ si c'est le ciel. */
    double distance() {
        return contact == null ? Constantes.INFINI : contact.distance;
    }

    /** La direction du reflet, {@code null} s'il n'a pas été suivi. */
    public Vecteur getReflechi() {
        return reflet == null ? null : R;
    }

    /** Dit si ce que voit le rayon n'est pas la somme telle quelle. */
    boolean aTraversLAir() {
        return !Double.isNaN(k) || vue != null && !vue.equals(somme);
    }

    /** Le nom, dans le récit, de ce que voit ce rayon. */
    String nomDeLaVue() {
        return (aTraversLAir() ? "vue " : "somme ") + numero;
    }
}
