package lancer.inspection;

import static lancer.essai.Triplets.ajouter;
import static lancer.essai.Triplets.dot;
import static lancer.essai.Triplets.fois;
import static lancer.essai.Triplets.gris;
import static lancer.essai.Triplets.moins;
import static lancer.essai.Triplets.plus;
import static lancer.essai.Triplets.t;
import static lancer.essai.Triplets.unite;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.DoubleUnaryOperator;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.essai.TraceurPlat;
import lancer.inspection.Segment.Eclairage;
import lancer.texte.Nombre;

/** Les nombres de l'explication d'un pixel, refaits par les équations de l'énoncé ; chaque somme se ferme au bit près. */
public final class EssaiSegments extends TraceurPlat {

    private final Scene scene;
    private final int reflets;

    /** La part de l'air selon la distance, et sa couleur ; {@code null} s'il n'y a pas de brume. */
    private final DoubleUnaryOperator k;
    private final double[] air;

    /** Ce qui multiplie ns dans le reflet de Blinn ; 0 pour Phong. */
    private final double blinn;

    /** Les contacts vérifiés, les lampes qui les éclairent, les cachées, et les raisons de s'arrêter. */
    public int contacts;
    public int eclairees;
    public int cachees;
    public final Set<String> arrets = new HashSet<>();

    public EssaiSegments(Scene scene, int reflets, DoubleUnaryOperator k, double[] air, double blinn) {
        super(scene.getObjets(), scene.getLampes(), 1, 1, reflets);
        this.scene = scene;
        this.reflets = reflets;
        this.k = k;
        this.air = air;
        this.blinn = blinn;
    }

    @Override
    protected double eclat(double[] V, double[] N, double[] L, double[] R, double ns) {
        return blinn == 0 ? super.eclat(V, N, L, R, ns) : Math.pow(Math.max(0, dot(N, unite(moins(L, V)))), blinn * ns);
    }

    /** @return les lignes de ce récit */
    public List<String> verifier(Inspection pixel) {
        List<String> lignes = new Recit(pixel, Double::toString, Double::toString).raconter().lignes();
        Rayon rayon = pixel.camera.getRayon(pixel.choisi.x, pixel.choisi.y);
        double[] P = t(rayon.getP());
        double[] V = t(rayon.getV());
        double[] produit = {1, 1, 1};
        Sphere depart = null;
        List<Segment> segments = pixel.getSegments();
        for (Segment segment : segments) {
            Sphere boule = premiere(P, V, depart);
            assertSame(boule, segment.contact == null ? null : segment.contact.objet);
            double d = boule == null ? Double.POSITIVE_INFINITY : distance(P, V, boule);
            traverser(segment, d);
            if (boule == null) {
                proche(ciel(V), t(segment.somme));
                arret(lignes, "ciel", "ciel");
                assertSame(segment, segments.get(segments.size() - 1));
                continue;
            }
            contacts++;
            proche(gris(d), gris(segment.distance));
            double[] X = t(segment.contact);
            proche(plus(P, d, V), X);
            double[] N = t(segment.N);
            proche(unite(moins(X, t(boule.getCentre()))), N);
            double[] R = plus(V, -2 * dot(V, N), N);
            proche(R, t(segment.R));
            rivaux(segment, P, V, boule, depart);
            double[] somme = new double[3];
            for (Eclairage eclairage : segment.eclairages) {
                eclairer(eclairage, boule, X, V, N, R);
                ajouter(somme, eclairage.eclaire() ? t(eclairage.apport) : gris(0));
            }
            produit = fois(produit, t(boule.getKs()));
            double poids = Math.max(produit[0], Math.max(produit[1], produit[2]));
            boolean suivi = segment.numero <= reflets && poids > 0 && poids >= scene.getModele().getSeuil();
            assertEquals(suivi, segment != segments.get(segments.size() - 1));
            proche(produit, t(segment.poids));
            if (suivi) {
                assertArrayEquals(fois(t(boule.getKs()), t(segment.suite.vue)), t(segment.reflet));
                ajouter(somme, t(segment.reflet));
            } else if (boule.getKs().equals(new Couleur())) {
                arret(lignes, "Ks nul", "Ks nul");
            } else if (segment.numero > reflets) {
                arret(lignes, "réflexion", reflets + (reflets > 1 ? " réflexions" : " réflexion"));
            } else {
                arret(lignes, "poids", "poids " + segment.poids.max() + " < seuil " + Nombre.ecrire(scene.getModele().getSeuil()));
            }
            assertArrayEquals(t(segment.somme), somme);
            assertEquals(new Couleur(), segment.autre);
            P = X;
            V = unite(R);
            depart = boule;
        }
        assertEquals(new Couleur(), pixel.autre);
        return lignes;
    }

    private void arret(List<String> lignes, String raison, String dite) {
        arrets.add(raison);
        assertTrue(lignes.contains("  arrêt : " + dite), lignes + " : " + dite);
    }

    private void traverser(Segment segment, double d) {
        double[] somme = t(segment.somme);
        double part = k == null ? 0 : d == Double.POSITIVE_INFINITY ? 1 : k.applyAsDouble(d);
        proche(k == null ? somme : plus(fois(gris(part), air), 1 - part, somme), t(segment.vue));
    }

    private void rivaux(Segment segment, double[] P, double[] V, Sphere boule, Objet3D depart) {
        double[] distances = scene.getObjets().stream().filter(o -> o != boule && o != depart)
                .mapToDouble(o -> distance(P, V, (Sphere) o)).filter(d -> d < Double.POSITIVE_INFINITY).sorted().limit(2).toArray();
        proche(distances, segment.rivaux.stream().mapToDouble(rival -> rival.distance).toArray());
    }

    private void eclairer(Eclairage dit, Sphere boule, double[] X, double[] V, double[] N, double[] R) {
        double[] versLampe = moins(t(dit.lampe.getPosition()), X);
        proche(gris(dot(N, versLampe)), gris(dit.devant));
        if (dot(N, versLampe) <= 0) {
            assertEquals(new Couleur(), dit.apport);
            return;
        }
        double[] L = unite(versLampe);
        proche(L, t(dit.L));
        proche(gris(dot(N, L)), gris(dit.cosinus));
        proche(diffus(boule, dit.lampe, N, L), t(dit.diffus));
        proche(reflet(boule, dit.lampe, eclat(V, N, L, R, boule.getNs())), t(dit.reflet));
        double[] apport = t(dit.diffus);
        ajouter(apport, t(dit.reflet));
        assertArrayEquals(apport, t(dit.apport));
        if (!dit.apport.equals(new Couleur())) {
            Sphere obstacle = cache(dit.lampe, X, boule);
            assertEquals(obstacle != null, dit.cachee);
            assertSame(obstacle, dit.obstacle == null ? null : dit.obstacle.objet);
            cachees += dit.cachee ? 1 : 0;
            eclairees += dit.eclaire() ? 1 : 0;
        }
    }

    /** Aux arrondis près, qui grandissent d'un reflet au suivant. */
    private static void proche(double[] attendu, double[] dit) {
        assertEquals(attendu.length, dit.length);
        for (int c = 0; c < attendu.length; c++) {
            assertEquals(attendu[c], dit[c], 1e-7 * (1 + Math.abs(attendu[c])));
        }
    }
}
