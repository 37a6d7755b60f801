package lancer.inspection;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;

/**
 * Un rayon, puis son contact et les termes de sa couleur, ou le ciel. Les équations de {@link Objet3D#getColor} sont
 * écrites ici une seconde fois : l'explication peut ainsi contredire le programme.
 */
public final class Segment {

    /** Rang du rayon, depuis 1 ; son contact, {@code null} pour le ciel. */
    public final int numero;
    public final Rayon rayon;
    public final PointContact contact;
    final double distance;
    private final Objet3D depart;
    final int profondeur;

    /** Un terme pour chaque lampe de la scène, dans leur ordre. */
    public final List<Eclairage> eclairages = new ArrayList<>();

    /** Normale, direction réfléchie, couleur de diffusion ; {@code null} si elles ne sont pas connues. */
    Vecteur N;
    Vecteur R;
    Couleur Kd;

    /** Produit des Ks, contact compris ; segment que voit le rayon réfléchi, {@code null} s'il n'est pas lancé. */
    Couleur poids = new Couleur();
    Segment suite;

    /** Contacts des deux autres objets les plus proches du départ. */
    List<PointContact> rivaux = Collections.emptyList();

    /** Terme du rayon réfléchi ; {@code null} s'il n'est pas lancé, ou si sa couleur n'est pas connue. */
    Couleur reflet;

    /** Couleur rendue par {@code getColor}, ou du ciel ; la même à travers l'air ; {@code null} si le calcul échoue. */
    Couleur somme;
    Couleur vue;

    /** Ce que les termes n'expliquent pas dans la somme ; noir si elle est la leur au bit près. */
    Couleur autre = new Couleur();

    Segment(int numero, Rayon rayon, Objet3D depart, int profondeur, Scene scene) {
        this.numero = numero;
        this.rayon = rayon;
        this.depart = depart;
        this.profondeur = profondeur;
        contact = scene.getClosestIntersection(rayon, depart);
        distance = contact == null ? Constantes.INFINI : contact.distance;
    }

    /** Calcule les termes des lampes, comme {@link Objet3D#getColor}, et cherche les rivaux. */
    void eclairer(Scene scene) {
        if (contact == null) {
            return;
        }
        poids = rayon.getProduitKs().mul(contact.objet.getKs());
        N = contact.objet.getNormale(contact);
        R = contact.objet.getReflexion(rayon.getV(), N);
        Kd = contact.objet.getKd(contact);
        for (Lampe lampe : scene.getLampes()) {
            eclairages.add(new Eclairage(lampe, this, scene));
        }
        Rayon libre = Rayon.unitaire(rayon.getP(), rayon.getV());
        rivaux = scene.getObjets().stream().filter(objet -> objet != contact.objet && objet != depart).map(objet -> {
            libre.setContact(objet, objet.getIntersectionDistance(libre));
            return libre.calcContact();
        }).filter(Objects::nonNull).sorted(Comparator.comparingDouble(rival -> rival.distance)).limit(2)
                .collect(Collectors.toList());
    }

    /** Lance le rayon réfléchi. @return {@code null} si les équations du cours n'en lancent pas */
    Segment reflechir(Scene scene) {
        if (contact != null && profondeur > 0 && !contact.objet.getKs().estNoire()
                && poids.max() >= scene.getModele().getSeuil()) {
            suite = new Segment(numero + 1, Rayon.reflechi(contact, R, poids), contact.objet, profondeur - 1, scene);
        }
        return suite;
    }

    /** Demande sa couleur au contact, et la compare à la somme des termes, ajoutés dans le même ordre. */
    void sommer(Scene scene) {
        Couleur connue = new Couleur();
        for (Eclairage eclairage : eclairages) {
            connue = eclairage.eclaire() ? ajouter(connue, eclairage.apport) : connue;
        }
        if (suite != null && suite.vue != null) {
            reflet = contact.objet.getKs().mul(suite.vue);
            connue = ajouter(connue, reflet);
        }
        Couleur rendue = contact == null ? rayon.getSkyColor()
                : contact.objet.getColor(scene, rayon, contact, profondeur);
        vue = scene.getModele().getAtmosphere().traverser(rendue, distance);
        somme = rendue;
        autre = contact == null ? autre : retrancher(somme, connue);
    }

    /** Ajoute nombre par nombre : un changement de {@link Couleur#add} se voit. */
    static Couleur ajouter(Couleur c, Couleur d) {
        return new Couleur(c.r + d.r, c.v + d.v, c.b + d.b);
    }

    /** Retranche nombre par nombre. */
    static Couleur retrancher(Couleur c, Couleur d) {
        return new Couleur(c.r - d.r, c.v - d.v, c.b - d.b);
    }

    /** Le terme d'une lampe dans la couleur d'un contact, par les équations du cours. */
    public static final class Eclairage {

        public final Lampe lampe;

        /** N·(lampe − contact) ; s'il est négatif ou nul, la lampe est dans le dos et ce qui suit est nul. */
        final double devant;

        /** Direction de la lampe, de longueur 1 ; N·L ; les deux parts de l'apport, et leur somme. */
        final Vecteur L;
        final double cosinus;
        final Couleur diffus;
        final Couleur reflet;
        final Couleur apport;

        /** Dit si un objet cache la lampe, cherchée seulement si elle apporte quelque chose. */
        final boolean cachee;

        /** Le premier contact du rayon d'ombre ; {@code null} si rien ne la cache, ou si le récit ne sait par quoi. */
        public final PointContact obstacle;

        Eclairage(Lampe lampe, Segment segment, Scene scene) {
            this.lampe = lampe;
            Objet3D objet = segment.contact.objet;
            Vecteur versLampe = new Vecteur(segment.contact, lampe.getPosition());
            devant = segment.N.dot(versLampe);
            L = devant > 0 ? versLampe.normalized() : new Vecteur();
            cosinus = Math.min(1, segment.N.dot(L));
            diffus = segment.Kd.mul(lampe.getCouleur()).mul(cosinus);
            double eclat = !(devant > 0) || objet.getKs().estNoire() ? 0 : scene.getModele().getSpecularite()
                    .eclat(segment.rayon.getV(), segment.N, L, segment.R, objet.getNs());
            reflet = objet.getKs().mul(lampe.getCouleur()).mul(eclat);
            apport = ajouter(diffus, reflet);
            cachee = !apport.estNoire() && scene.estCachee(lampe, segment.contact, L, versLampe.norme(), objet);
            obstacle = cachee ? chercherLObstacle(segment.contact, versLampe.norme(), scene) : null;
        }

        /** Dit si la lampe éclaire le contact. */
        public boolean eclaire() {
            return !cachee && !apport.estNoire();
        }

        /** Demandé de la lampe ou, si elle est lointaine, du contact : les arrondis sont plus petits. */
        private PointContact chercherLObstacle(PointContact contact, double distance, Scene scene) {
            Rayon ombre = Scene.estLointaine(lampe, contact) ? Rayon.unitaire(contact, L)
                    : Rayon.unitaire(lampe.getPosition(), L.neg());
            PointContact premier = scene.getClosestIntersection(ombre, contact.objet);
            return ombre.getDistance() < distance ? premier : null;
        }
    }
}
