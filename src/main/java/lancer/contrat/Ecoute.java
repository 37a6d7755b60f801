package lancer.contrat;

import java.util.ArrayList;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.PointContact;
import lancer.Vecteur;

/**
 * Récit d'un point de l'écran, que font les classes du cours en calculant sa couleur, à qui le demande ; d'ordinaire
 * personne, et {@code e} est {@code null}. Un rayon se dit dans l'ordre : son contact, les lampes, le reflet (donc le
 * rayon suivant, en entier), et enfin ce qu'il voit. Ce qui n'a pas été calculé reste {@code null}. Un récit ne garde
 * que des copies, et qui calcule ne nomme pas {@link Etape} dans ses signatures : ne pas écouter ne coûte rien.
 */
public final class Ecoute {

    /** Rayons, dans l'ordre où ils sont partis. */
    public final List<Etape> etapes = new ArrayList<>();
    private Etape enCours;

    /** Vue d'un rayon : un contact et ses lampes, ou le ciel. */
    public static final class Etape {

        /** Rang dans la chaîne, depuis 1 ; direction ; contact, {@code null} pour le ciel ; longueur, alors +∞. */
        public final int numero;
        public final Vecteur V;
        public final PointContact contact;
        public final double distance;
        private final Etape avant;

        public final List<Eclairage> lampes = new ArrayList<>();

        /** Ce qui précède les lampes, puis chacune, puis le reflet, dans l'ordre de la somme ; et celui qui se dit. */
        public final List<Eclairage> termes = new ArrayList<>();
        public Eclairage enCours = suivre(new Eclairage(null, null, 0));

        /** Normale, miroir du rayon, et produit des Ks si un reflet était permis ; une forme peut n'en rien dire. */
        public Vecteur N;
        public Vecteur R;
        public Couleur poids;

        /** Somme du contact, ou ciel ; et ce qu'en voit le rayon, à travers l'air. */
        public Couleur somme;
        public Couleur vue;

        Etape(int numero, Vecteur V, PointContact contact, Etape avant) {
            this.numero = numero;
            this.V = V;
            this.contact = contact;
            this.avant = avant;
            distance = contact == null ? Constantes.INFINI : contact.distance;
        }

        /** Passe à ce terme : ce qui s'ajoute désormais en est, ou le suit. */
        public Eclairage suivre(Eclairage terme) {
            enCours = terme;
            termes.add(terme);
            return terme;
        }

        /** Somme du contact, moins les termes dits, ajoutés dans l'ordre : noire si, au bit près, ils la donnent. */
        public Couleur inconnue() {
            Couleur connue = termes.stream().flatMap(terme -> terme.ajouts.stream()).reduce(new Couleur(),
                    (c, ajout) -> new Couleur(c.r + ajout.r, c.v + ajout.v, c.b + ajout.b));
            return N == null || somme == null ? new Couleur() : somme.sub(connue);
        }
    }

    /** Lampe vue d'un contact, ou reflet ; et ce qui s'ajoute, de la lampe à la suivante. */
    public static final class Eclairage {

        /** La lampe, ou ce que voit le reflet ; ni l'un ni l'autre au début. Et N·(lampe − contact), positif devant. */
        public final Lampe lampe;
        public final Etape suite;
        public final double devant;

        public double cosinus;
        public double eclat;
        public Couleur diffus;
        public Couleur reflet;

        /** Direction de la lampe, et sa distance, si un rayon d'ombre a été demandé. */
        public Vecteur L;
        public double distance;

        /** Produit de ses facteurs, s'ils sont dits ; et ce qui s'ajoute, produit compris si rien ne cache la lampe. */
        public Couleur produit;
        public final List<Couleur> ajouts = new ArrayList<>();

        /** Contact de l'objet le plus proche de la lampe qui la cache, si quelqu'un l'a cherché. */
        public PointContact cache;

        public Eclairage(Lampe lampe, Etape suite, double devant) {
            this.lampe = lampe;
            this.suite = suite;
            this.devant = devant;
        }

        /** Rang de l'apport dans ce qui s'ajoute : le produit, ou ce qui le remplace ; -1 si la lampe ne compte pas. */
        public int apport() {
            int rang = ajouts.indexOf(produit);
            boolean attendu = cache == null && produit != null && !produit.estNoire() && !ajouts.isEmpty();
            return attendu ? Math.max(0, rang) : rang;
        }

        /** Dit si la lampe compte dans la somme. */
        public boolean eclaire() {
            return apport() >= 0;
        }
    }

    public Etape enCours() {
        return enCours;
    }

    /** Dit un rayon de direction V, et ce qu'il rencontre d'abord : {@code null} si c'est le ciel. */
    public static void rayon(Ecoute e, Vecteur V, PointContact contact) {
        if (e != null) {
            if (e.enCours == null) {
                e.etapes.clear();
            }
            e.enCours = new Etape(e.etapes.size() + 1, new Vecteur(V.x, V.y, V.z), contact, e.enCours);
            e.etapes.add(e.enCours);
        }
    }

    /** Dit la question d'un rayon d'ombre. {@code L} va du contact à la lampe. */
    public static void ombre(Ecoute e, Vecteur L, double distance) {
        if (e != null) {
            Eclairage lampe = e.enCours.enCours;
            lampe.L = new Vecteur(L.x, L.y, L.z);
            lampe.distance = distance;
        }
    }

    /** Dit ce que voit enfin le rayon : la somme de son contact, ou le ciel, puis à travers l'air. */
    public static void vue(Ecoute e, Couleur somme, Couleur vue) {
        if (e != null) {
            Etape etape = e.enCours;
            etape.somme = new Couleur(somme.r, somme.v, somme.b);
            etape.vue = new Couleur(vue.r, vue.v, vue.b);
            e.enCours = etape.avant;
            if (e.enCours != null) {
                Couleur Ks = e.enCours.contact.objet.getKs();
                e.enCours.suivre(new Eclairage(null, etape, 0)).produit = Ks.mul(etape.vue);
            }
        }
    }
}
