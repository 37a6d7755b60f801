package lancer.inspection;

import java.util.ArrayList;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.PointContact;
import lancer.Vecteur;

/** Le chemin de la lumière jusqu'à un point de l'écran. Une valeur qui n'a pas été calculée reste {@code null}. */
public final class Chemin {

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

    private Terme terme() {
        return enCours.termes.get(enCours.termes.size() - 1);
    }

    public void rayon(Vecteur V, PointContact contact) {
        if (enCours == null) {
            segments.clear();
        }
        enCours = new Segment(segments.size() + 1, V, contact, enCours);
        segments.add(enCours);
    }

    public void normale(Vecteur N, Vecteur R) {
        enCours.N = N;
        enCours.R = R;
    }

    public void lampe(Lampe lampe, double devant) {
        enCours.lampes.add(new Terme(lampe, null, devant));
        enCours.termes.add(enCours.lampes.get(enCours.lampes.size() - 1));
    }

    public void apport(double cosinus, double eclat, Couleur diffus, Couleur reflet) {
        Terme lampe = terme();
        lampe.cosinus = cosinus;
        lampe.eclat = eclat;
        lampe.diffus = diffus;
        lampe.reflet = reflet;
        lampe.produit = diffus.add(reflet);
    }

    public void ombre(Vecteur L, double distance) {
        terme().L = L;
        terme().distance = distance;
    }

    public void poids(Couleur produitKs) {
        enCours.poids = produitKs;
    }

    public void ajouter(Couleur c) {
        terme().ajouts.add(c);
    }

    public void vue(Couleur somme, Couleur vue) {
        Segment segment = enCours;
        segment.somme = somme;
        segment.vue = vue;
        enCours = segment.avant;
        if (enCours != null) {
            Couleur Ks = enCours.contact.objet.getKs();
            enCours.termes.add(new Terme(null, segment, 0));
            terme().produit = Ks.mul(vue);
        }
    }
}
