package lancer.essai;

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
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.texte.Nombre;

/**
 * Ce que dit {@code --pixel}, refait à part sur des triplets de nombres : chaque terme par les équations de l'énoncé, chaque somme
 * au bit près.
 */
public final class EssaiRecit extends LectureRecit {

    private static final double[] BLANC = {1, 1, 1};

    private final Scene scene;
    private final Function<Object, String> origines;
    private final int largeur;
    private final int hauteur;
    private final int reflets;

    /** La part de l'air selon la distance, et sa couleur ; {@code null} s'il n'y a pas de brume. */
    private final DoubleUnaryOperator k;
    private final double[] air;

    /** Ce qui multiplie ns dans le reflet de Blinn ; 0 pour Phong. */
    private final double blinn;
    private final Map<String, Object> parNom = new HashMap<>();

    private double[] P;
    private double[] V;
    private double[] produit;

    /** Les pixels dont la somme est pesée, les contacts dits, les lampes éclairées, les cachées, et les raisons de s'arrêter. */
    public int pesees;
    public int contacts;
    public int eclairees;
    public int cachees;
    public final Map<String, Integer> arrets = new HashMap<>();

    public EssaiRecit(Scene scene, Function<Object, String> origines, int largeur, int hauteur, int reflets, DoubleUnaryOperator k,
            double[] air, double blinn) {
        this.scene = scene;
        this.origines = origines;
        this.largeur = largeur;
        this.hauteur = hauteur;
        this.reflets = reflets;
        this.k = k;
        this.air = air;
        this.blinn = blinn;
        scene.getObjets().forEach(o -> parNom.put(origines.apply(o), o));
        scene.getLampes().forEach(l -> parNom.put(origines.apply(l), l));
    }

    public void verifier(int x, int y, String sortie) {
        ouvrir(sortie);
        assertEquals("pixel " + x + ", " + y, lignes.get(suivante++));
        double xe = x + 0.5;
        double ye = y + 0.5;
        double[] moyenne = null;
        if (actuelle().matches("\\d+ échantillons?.*")) {
            moyenne = moyenne();
            double[] point = nombres(lignes.get(suivante++).replace(",", ""));
            xe = point[0];
            ye = point[1];
        }
        Rayon rayon = new Camera(largeur, hauteur).getRayon(xe, ye);
        P = t(rayon.getP());
        V = t(rayon.getV());
        produit = BLANC;
        double[] vue = etape(1, null);
        assertEquals(lignes.size() - 1, suivante, "une ligne de trop : " + actuelle());
        assertTrue(actuelle().matches("somme \\S+ \\S+ \\S+ = #[0-9A-F]{6}"), actuelle());
        double[] somme = nombres(actuelle().replaceAll("=.*", ""));
        assertArrayEquals(moyenne == null ? vue : moyenne, somme, actuelle());
        assertTrue(actuelle().endsWith(String.format("#%06X", new Couleur(somme[0], somme[1], somme[2]).getCode() & 0xFFFFFF)), actuelle());
    }

    private double[] moyenne() {
        int n = Arrays.stream(lignes.get(suivante++).replaceAll("[^0-9 ]", "").trim().split(" +")).mapToInt(Integer::parseInt).sum();
        Map<String, double[]> echantillons = new LinkedHashMap<>();
        for (int e = 0; e < n; e++) {
            String[] mots = lignes.get(suivante++).split("( \\(partagé\\))? : ");
            echantillons.put(mots[0].trim(), nombres(mots[1]));
        }
        double[] somme = new double[3];
        double aire = n;
        if (actuelle().matches("\\d+ termes")) {
            int termes = Integer.parseInt(lignes.get(suivante++).replaceAll("\\D.*", ""));
            double poids = 0;
            for (int t = 0; t < termes; t++) {
                String[] mots = lignes.get(suivante++).trim().split(" × | = ");
                double sien = nombres(mots[0])[0];
                double[] terme = nombres(mots[2]);
                assertArrayEquals(fois(gris(sien), echantillons.get(mots[1])), terme, mots[1]);
                ajouter(somme, terme);
                poids += sien;
            }
            pesees++;
            aire = Math.rint(poids);
            assertEquals(aire, poids, 1e-9);
        } else {
            echantillons.values().forEach(vue -> ajouter(somme, vue));
        }
        String[] fin = lignes.get(suivante++).split("leur somme = |, divisée par | pour le pixel");
        assertArrayEquals(somme, nombres(fin[1]), "la somme des termes");
        assertArrayEquals(new double[] {aire}, nombres(fin[2]));
        for (int c = 0; c < 3; c++) {
            somme[c] /= aire;
        }
        return somme;
    }

    /** @return ce que voit le rayon (P, V) */
    private double[] etape(int numero, Objet3D sauf) {
        String titre = lignes.get(suivante++);
        Sphere proche = null;
        double d = Double.POSITIVE_INFINITY;
        for (Objet3D o : scene.getObjets()) {
            double di = o == sauf ? Double.POSITIVE_INFINITY : distance(P, V, (Sphere) o);
            if (di < d) {
                proche = (Sphere) o;
                d = di;
            }
        }
        String debut = numero + "  " + (proche == null ? "ciel" : origines.apply(proche)) + "  ";
        assertTrue(titre.startsWith(debut), titre + " au lieu de " + debut);
        String[] dits = titre.substring(debut.length()).split(" = | : ", 2);
        double[] somme = nombres(dits[0]);
        if (proche == null) {
            assertEquals(1, dits.length, titre);
            proche(t(new Rayon(new Point(), new Vecteur(V[0], V[1], V[2])).getSkyColor()), somme);
            if (scene.getObjets().isEmpty()) {
                assertEquals("  aucun objet dans la scène", lignes.get(suivante++));
            }
            return arret(numero, null, 0, traverser(numero, somme, d));
        }
        contacts++;
        double[] X = chercher("    contact = ");
        double[] N = chercher("    N = ");
        double[] R = plus(V, -2 * dot(V, N), N);
        double[] ks = t(proche.getKs());
        double[] total = new double[3];
        int avant = eclairees;
        for (Lampe lampe : scene.getLampes()) {
            ajouter(total, lampe(lampe, proche, X, N, R));
        }
        produit = fois(produit, ks);
        double poids = Math.max(produit[0], Math.max(produit[1], produit[2]));
        double[] reflet = null;
        String suite = "(somme|vue) " + (numero + 1);
        if (actuelle().matches("  Ks \\([^)]*\\) ⊗ " + suite + " = .*")) {
            assertTrue(numero <= reflets && poids >= scene.getModele().getSeuil());
            assertTrue(dits[1].matches(".* ⊗ " + suite), titre);
            reflet = nombres(lignes.get(suivante++).replaceAll(".*=", ""));
            ajouter(total, reflet);
            proche(R, lire("    R = "));
            proche(produit, lire("    poids, produit des Ks = "));
        }
        assertEquals(eclairees == avant && reflet == null, dits[1].equals("rien ne l'éclaire"), titre);
        assertArrayEquals(total, somme, titre);
        details(proche, sauf, d, X, N);
        double[] vue = traverser(numero, somme, d);
        if (reflet == null) {
            return arret(numero, proche, poids, vue);
        }
        P = X;
        V = unite(R);
        assertArrayEquals(fois(ks, etape(numero + 1, proche)), reflet, titre);
        return vue;
    }

    /** Le contact, la demi-corde et les rivaux du plus proche. */
    private void details(Sphere proche, Objet3D sauf, double d, double[] X, double[] N) {
        assertEquals("  contact, normale et rivaux", lignes.get(suivante++));
        proche(new double[] {d}, lire("    d = "));
        proche(plus(P, d, V), lire("    contact = "));
        proche(unite(moins(X, t(proche.getCentre()))), lire("    N = "));
        double[] f = moins(t(proche.getCentre()), P);
        double delta = proche.getRayon() * proche.getRayon() - dot(plus(f, -dot(f, V), V), plus(f, -dot(f, V), V));
        proche(new double[] {Math.sqrt(delta)}, lire("    demi-corde h = "));
        double[] rivaux = scene.getObjets().stream().filter(o -> o != proche && o != sauf)
                .mapToDouble(o -> distance(P, V, (Sphere) o)).filter(di -> di < Double.POSITIVE_INFINITY).sorted().limit(2).toArray();
        for (double rival : rivaux) {
            assertTrue(actuelle().startsWith("    rival ["), actuelle());
            proche(new double[] {rival}, nombres(lignes.get(suivante++).replaceAll(".* d = ", "")));
        }
    }

    private double[] arret(int numero, Sphere objet, double poids, double[] vue) {
        String raison = lignes.get(suivante++).replaceFirst("  arrêt : ", "");
        boolean noir = objet != null && new Couleur().equals(objet.getKs());
        assertEquals(objet == null ? "ciel" : noir ? "Ks nul" : numero > reflets ? reflets + (reflets > 1 ? " réflexions" : " réflexion")
                : "poids " + nombres(raison + " ")[0] + " < seuil " + Nombre.ecrire(scene.getModele().getSeuil()), raison);
        if (raison.startsWith("poids")) {
            proche(new double[] {poids}, Arrays.copyOf(nombres(raison), 1));
            assertTrue(poids < scene.getModele().getSeuil());
        }
        arrets.merge(raison.replaceAll("^\\d+|s?\\d.*|s$", ""), 1, Integer::sum);
        return vue;
    }

    private double[] traverser(int numero, double[] somme, double d) {
        if (k == null) {
            return somme;
        }
        double part = d == Double.POSITIVE_INFINITY ? 1 : k.applyAsDouble(d);
        double[] vue = lire("  vue " + numero + " = ");
        double dite = lire("    air : k = ")[0];
        proche(new double[] {part}, new double[] {dite});
        double[] deLAir = lire("    k · air = ");
        double[] reste = lire("    (1 − k) · somme " + numero + " = ");
        for (int c = 0; c < 3; c++) {
            assertEquals(dite * air[c], deLAir[c]);
            assertEquals((1 - dite) * somme[c], reste[c]);
        }
        ajouter(deLAir, reste);
        assertArrayEquals(deLAir, vue);
        return vue;
    }

    /** @return ce que cette lampe ajoute */
    private double[] lampe(Lampe lampe, Sphere objet, double[] X, double[] N, double[] R) {
        String titre = lignes.get(suivante++);
        String nom = origines.apply(lampe) + "  ";
        if (titre.matches("  \\d+ lampes .*")) {
            // les pareilles sont dessous
            titre = lignes.get(suivante++);
        }
        titre = titre.trim();
        assertTrue(titre.startsWith(nom), titre);
        double[] S = t(lampe.getPosition());
        double[] versLampe = moins(S, X);
        double devant = dot(N, versLampe);
        if (devant <= 0) {
            assertTrue(titre.endsWith("dans le dos : pas de rayon d'ombre"), titre);
            proche(new double[] {devant}, nombres(titre.replaceFirst("^.*?= ", "").replaceAll(" .*", "")));
            return new double[3];
        }
        double[] L = unite(versLampe);
        proche(new double[] {dot(N, L)}, nombres(titre.replaceFirst("^.*?= ", "").replaceAll(" .*", "")));
        Objet3D cache = null;
        double auPlus = Math.sqrt(dot(versLampe, versLampe));
        for (Objet3D autre : scene.getObjets()) {
            double d = autre == objet ? auPlus : distance(S, fois(L, new double[] {-1, -1, -1}), (Sphere) autre);
            if (d < auPlus) {
                auPlus = d;
                cache = autre;
            }
        }
        if (cache != null) {
            cachees++;
            assertTrue(titre.endsWith("cachée par " + origines.apply(cache)), titre);
            proche(L, nombres(lignes.get(suivante++).trim().replaceFirst("^L = ", "")));
            return new double[3];
        }
        double[] kl = t(lampe.getCouleur());
        double[] diffus = fois(fois(t(objet.getKd()), kl), gris(dot(N, L)));
        double[] H = unite(moins(L, V));
        double eclat = Math.pow(Math.max(0, blinn == 0 ? dot(R, L) : dot(N, H)), (blinn == 0 ? 1 : blinn) * objet.getNs());
        double[] reflet = fois(fois(t(objet.getKs()), kl), gris(eclat));
        if (titre.contains("sans effet")) {
            proche(new double[6], new double[] {diffus[0], diffus[1], diffus[2], reflet[0], reflet[1], reflet[2]});
            return new double[3];
        }
        eclairees++;
        assertTrue(titre.contains("  éclairée : diffus + reflet = "), titre);
        proche(L, lire("    L = "));
        double[] ditDiffus = produit("diffus = Kd", objet.getKd(), lampe, "N·L \\S+");
        proche(diffus, ditDiffus);
        double[] dit = produit("reflet = Ks", objet.getKs(), lampe,
                "(\\(%s [^-]\\S*|max\\(0, %s -\\S+)\\)\\^\\S+".replace("%s", blinn == 0 ? "R·L" : "N·H"));
        proche(reflet, dit);
        ajouter(ditDiffus, dit);
        assertArrayEquals(ditDiffus, nombres(titre.replaceAll(".* = ", "")), titre);
        return ditDiffus;
    }

    /** Un terme et ses facteurs, dont le produit est lui, au bit près pour le diffus. */
    private double[] produit(String debut, Couleur matiere, Lampe lampe, String reste) {
        String ligne = lignes.get(suivante++);
        assertTrue(ligne.matches("    " + debut + " \\([^)]*\\) ⊗ lampe \\([^)]*\\) × " + reste + " = \\S+ \\S+ \\S+"), ligne);
        double[] dits = nombres(ligne.replace("max(0, ", "").replaceAll("[()^]", " ").replaceAll(" = \\S+ \\S+ \\S+$", ""));
        assertArrayEquals(t(matiere), Arrays.copyOf(dits, 3), ligne);
        assertArrayEquals(t(lampe.getCouleur()), Arrays.copyOfRange(dits, 3, 6), ligne);
        double part = dits.length == 7 ? dits[6] : Math.pow(Math.max(0, Math.min(1, dits[6])), dits[7]);
        double[] terme = nombres(ligne.replaceAll(".* = ", ""));
        proche(fois(fois(t(matiere), t(lampe.getCouleur())), gris(part)), terme);
        return terme;
    }

    private static double distance(double[] P, double[] V, Sphere sphere) {
        double[] f = moins(t(sphere.getCentre()), P);
        double b = dot(f, V);
        double delta = sphere.getRayon() * sphere.getRayon() - dot(plus(f, -b, V), plus(f, -b, V));
        double h = Math.sqrt(delta);
        return !(delta >= 0) || b + h <= 0 ? Double.POSITIVE_INFINITY : b - h > 0 ? b - h : b + h;
    }
}
