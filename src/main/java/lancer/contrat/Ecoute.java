package lancer.contrat;

import java.util.ArrayList;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.PointContact;
import lancer.Vecteur;

/**
 * Détail du calcul d'un point de l'écran, que les classes du cours notent pour l'inspecteur. Pendant un dessin,
 * {@code e} est {@code null}. Un rayon note dans l'ordre son contact, les lampes, le rayon réfléchi en entier, puis la
 * couleur qu'il voit. Une valeur qui n'a pas été calculée reste {@code null}.
 */
public final class Ecoute {

    /** Segments du chemin de la lumière, dans l'ordre du départ de leurs rayons. */
    public final List<Segment> segments = new ArrayList<>();
    private Segment enCours;

    /** Un segment du chemin : un rayon, puis son contact et ses lampes, ou le ciel. */
    public static final class Segment {

        /** Rang du rayon, depuis 1 ; direction ; contact, {@code null} pour le ciel ; longueur, +∞ pour le ciel. */
        public final int numero;
        public final Vecteur V;
        public final PointContact contact;
        public final double distance;
        private final Segment avant;

        public final List<Terme> lampes = new ArrayList<>();

        /** Termes dans l'ordre : un avant les lampes, un par lampe, celui du rayon réfléchi. */
        public final List<Terme> termes = new ArrayList<>();

        /** Normale, direction réfléchie, produit des Ks ; {@code null} si l'objet ne les a pas notés. */
        public Vecteur N;
        public Vecteur R;
        public Couleur poids;

        /** Couleur du contact ou du ciel, puis la même à travers l'air. */
        public Couleur somme;
        public Couleur vue;

        Segment(int numero, Vecteur V, PointContact contact, Segment avant) {
            this.numero = numero;
            this.V = V;
            this.contact = contact;
            this.avant = avant;
            distance = contact == null ? Constantes.INFINI : contact.distance;
            termes.add(new Terme(null, null, 0));
        }
    }

    /** Un terme de la somme : une lampe ou le rayon réfléchi, avec les couleurs ajoutées jusqu'au terme suivant. */
    public static final class Terme {

        /** La lampe, ou le rayon réfléchi ; {@code null} tous deux au début. {@code devant} est N·(lampe − contact). */
        public final Lampe lampe;
        public final Segment suite;
        public final double devant;

        public double cosinus;
        public double eclat;
        public Couleur diffus;
        public Couleur reflet;

        /** Direction et distance de la lampe, si un rayon d'ombre a été lancé. */
        public Vecteur L;
        public double distance;

        /** Apport attendu du terme, s'il est noté ; couleurs ajoutées, apport compris si la lampe est visible. */
        public Couleur produit;
        public final List<Couleur> ajouts = new ArrayList<>();

        /** Contact de l'objet qui cache la lampe, si l'inspecteur l'a cherché. */
        public PointContact cache;

        Terme(Lampe lampe, Segment suite, double devant) {
            this.lampe = lampe;
            this.suite = suite;
            this.devant = devant;
        }
    }

    /** Le segment en cours. */
    public Segment segment() {
        return enCours;
    }

    /** Le terme en cours : les ajouts suivants lui appartiennent. */
    public Terme terme() {
        return enCours.termes.get(enCours.termes.size() - 1);
    }

    /** Passe au terme de cette lampe. @param devant N·(lampe − contact) */
    public void lampe(Lampe lampe, double devant) {
        enCours.lampes.add(new Terme(lampe, null, devant));
        enCours.termes.add(enCours.lampes.get(enCours.lampes.size() - 1));
    }

    /** Note un rayon de direction V et son contact, {@code null} pour le ciel. */
    public static void rayon(Ecoute e, Vecteur V, PointContact contact) {
        if (e != null) {
            if (e.enCours == null) {
                e.segments.clear();
            }
            e.enCours = new Segment(e.segments.size() + 1, new Vecteur(V.x, V.y, V.z), contact, e.enCours);
            e.segments.add(e.enCours);
        }
    }

    /** Note un rayon d'ombre. {@code L} va du contact à la lampe. */
    public static void ombre(Ecoute e, Vecteur L, double distance) {
        if (e != null) {
            Terme lampe = e.terme();
            lampe.L = new Vecteur(L.x, L.y, L.z);
            lampe.distance = distance;
        }
    }

    /** Note la couleur que voit le rayon : celle du contact ou du ciel, puis la même à travers l'air. */
    public static void vue(Ecoute e, Couleur somme, Couleur vue) {
        if (e != null) {
            Segment segment = e.enCours;
            segment.somme = new Couleur(somme.r, somme.v, somme.b);
            segment.vue = new Couleur(vue.r, vue.v, vue.b);
            e.enCours = segment.avant;
            if (e.enCours != null) {
                Couleur Ks = e.enCours.contact.objet.getKs();
                e.enCours.termes.add(new Terme(null, segment, 0));
                e.terme().produit = Ks.mul(segment.vue);
            }
        }
    }
}
