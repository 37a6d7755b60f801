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
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
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
 * Ce que dit {@code --pixel}, refait à part sur des triplets de nombres : chaque terme par les équations de l'énoncé ; {@link Sommes}
 * referme chaque somme au bit près.
 */
public final class EssaiRecit {

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

    /** Le récit : ce qui précède la chaîne, puis chaque étape, de la dernière à la première. */
    private String[] etapes;
    private double[] P;
    private double[] V;
    private double[] produit;

    /** Les pixels qui pèsent leurs échantillons, les contacts dits, les lampes éclairées, les cachées, et les raisons de s'arrêter. */
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
    }

    public void verifier(int x, int y, String sortie) {
        etapes = sortie.split("(?m)^(?=\\d+  )");
        String[] debut = etapes[0].split("\\R");
        assertEquals("pixel " + x + ", " + y, debut[0]);
        List<double[]> autres = Sommes.de(sortie);
        autres.forEach(autre -> assertNull(autre, sortie));
        contacts += autres.size();
        double[] point = {x + 0.5, y + 0.5};
        String fin = sortie.substring(sortie.lastIndexOf("somme "));
        double[] pixel = vue(1);
        if (debut.length > 1) {
            pixel = moyenne(debut, Arrays.copyOf(nombres(fin), 3));
            point = nombres(debut[debut.length - 1]);
            pesees += debut[debut.length - 2].startsWith("leur moyenne") ? 1 : 0;
        }
        Rayon rayon = new Camera(largeur, hauteur).getRayon(point[0], point[1]);
        P = t(rayon.getP());
        V = t(rayon.getV());
        produit = BLANC;
        Objet3D depart = null;
        for (int numero = 1; numero < etapes.length; numero++) {
            depart = etape(numero, etapes[etapes.length - numero], depart);
        }
        assertArrayEquals(pixel, Arrays.copyOf(nombres(fin), 3), fin);
        assertTrue(fin.trim().endsWith(String.format("#%06X", new Couleur(pixel[0], pixel[1], pixel[2]).getCode() & 0xFFFFFF)), fin);
    }

    /** La moyenne des échantillons ; s'ils sont pesés autrement, la couleur dite, entre les extrêmes de chaque composante. */
    private static double[] moyenne(String[] lignes, double[] dite) {
        double[] somme = new double[3];
        double[] min = Triplets.gris(Double.POSITIVE_INFINITY);
        double[] max = Triplets.gris(Double.NEGATIVE_INFINITY);
        int nombre = 0;
        for (String ligne : lignes) {
            if (ligne.matches("  \\S+ \\S+( \\(partagé\\))? : .*")) {
                double[] vue = nombres(ligne.replaceFirst(".* : ", ""));
                ajouter(somme, vue);
                nombre++;
                Arrays.setAll(min, c -> Math.min(min[c], vue[c]));
                Arrays.setAll(max, c -> Math.max(max[c], vue[c]));
            }
        }
        double aire = nombre;
        double[] moyenne = Arrays.stream(somme).map(c -> c / aire).toArray();
        String bilan = lignes[lignes.length - 2];
        if (!bilan.startsWith("leur moyenne = ")) {
            assertEquals("leur somme = " + somme[0] + " " + somme[1] + " " + somme[2] + ", divisée par " + nombre + " pour le pixel",
                    bilan);
            return moyenne;
        }
        assertArrayEquals(moyenne, nombres(bilan), bilan);
        assertFalse(Arrays.equals(moyenne, dite), bilan);
        for (int c = 0; c < 3; c++) {
            assertTrue(dite[c] >= min[c] - 1e-12 && dite[c] <= max[c] + 1e-12, Arrays.toString(dite));
        }
        return dite;
    }

    /** Ce que le récit dit que voit le rayon de cette étape. */
    private double[] vue(int numero) {
        String texte = etapes[etapes.length - numero];
        return k == null ? somme(texte) : lire(texte, "vue " + numero + " = ");
    }

    private static double[] somme(String texte) {
        return nombres(texte.split("\\R")[0].replaceFirst("^.*?  .*?  ", "").split(" = | : ")[0]);
    }

    /** @return l'objet que ce rayon rencontre */
    private Sphere etape(int numero, String texte, Objet3D sauf) {
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
        assertTrue(texte.startsWith(debut), texte + " au lieu de " + debut);
        traverser(numero, texte, d);
        if (proche == null) {
            proche(t(new Rayon(new Point(), new Vecteur(V[0], V[1], V[2])).getSkyColor()), somme(texte), texte);
            arret(texte, "ciel");
            return null;
        }
        double[] X = lire(texte, "contact = ");
        double[] N = lire(texte, "N = ");
        details(texte, proche, sauf, d, X, N);
        double[] R = plus(V, -2 * dot(V, N), N);
        int avant = eclairees;
        for (Lampe lampe : scene.getLampes()) {
            lampe(texte, lampe, proche, X, N, R);
        }
        double[] ks = t(proche.getKs());
        produit = fois(produit, ks);
        double poids = Math.max(produit[0], Math.max(produit[1], produit[2]));
        boolean suivi = numero <= reflets && poids > 0 && poids >= scene.getModele().getSeuil();
        assertEquals(suivi, numero + 1 < etapes.length, texte);
        assertEquals(eclairees == avant && !suivi, texte.contains(" : rien ne l'éclaire"), texte);
        if (suivi) {
            String nom = "⊗ " + (k == null ? "somme " : "vue ") + (numero + 1);
            assertArrayEquals(fois(ks, vue(numero + 1)), nombres(texte.replaceFirst("(?s).*" + nom + " = (.*?)\\R.*", "$1")), texte);
            proche(R, lire(texte, "R = "), texte);
            proche(produit, lire(texte, "poids, produit des Ks = "), texte);
        } else if (new Couleur().equals(proche.getKs())) {
            arret(texte, "Ks nul");
        } else {
            arret(texte, numero > reflets ? reflets + (reflets > 1 ? " réflexions" : " réflexion")
                    : "poids " + lire(texte, "arrêt : poids ")[0] + " < seuil " + Nombre.ecrire(scene.getModele().getSeuil()));
        }
        P = X;
        V = unite(R);
        return proche;
    }

    /** Le contact et les rivaux du plus proche. */
    private void details(String texte, Sphere objet, Objet3D sauf, double d, double[] X, double[] N) {
        proche(new double[] {d}, lire(texte, "d = "), texte);
        proche(plus(P, d, V), X, texte);
        proche(unite(moins(X, t(objet.getCentre()))), N, texte);
        double[] rivaux = scene.getObjets().stream().filter(o -> o != objet && o != sauf)
                .mapToDouble(o -> distance(P, V, (Sphere) o)).filter(di -> di < Double.POSITIVE_INFINITY).sorted().limit(2).toArray();
        proche(rivaux, Arrays.stream(texte.split("\\R")).filter(ligne -> ligne.startsWith("    rival ["))
                .mapToDouble(ligne -> nombres(ligne.replaceAll(".* d = ", ""))[0]).toArray(), texte);
    }

    private void arret(String texte, String raison) {
        assertTrue(Pattern.compile("(?m)^  arrêt : " + Pattern.quote(raison) + "$").matcher(texte).find(), texte + " : " + raison);
        arrets.merge(raison.replaceAll("^\\d+|s?\\d.*|s$", ""), 1, Integer::sum);
    }

    private void traverser(int numero, String texte, double d) {
        if (k != null) {
            double dite = lire(texte, "air : k = ")[0];
            proche(new double[] {d == Double.POSITIVE_INFINITY ? 1 : k.applyAsDouble(d)}, new double[] {dite}, texte);
            double[] deLAir = lire(texte, "k · air = ");
            double[] reste = lire(texte, "(1 − k) · somme " + numero + " = ");
            assertArrayEquals(fois(gris(dite), air), deLAir, texte);
            assertArrayEquals(fois(gris(1 - dite), somme(texte)), reste, texte);
            ajouter(deLAir, reste);
            assertArrayEquals(deLAir, vue(numero), texte);
        }
    }

    private void lampe(String etape, Lampe lampe, Sphere objet, double[] X, double[] N, double[] R) {
        String nom = origines.apply(lampe) + "  ";
        assertTrue(etape.contains("  " + nom), nom + " : " + etape);
        // ce qui suit son nom : sa ligne, puis ses facteurs
        String texte = etape.substring(etape.indexOf("  " + nom) + 2 + nom.length());
        String titre = texte.split("\\R")[0];
        double[] S = t(lampe.getPosition());
        double[] versLampe = moins(S, X);
        double[] L = unite(versLampe);
        double dit = nombres(titre.replaceFirst("^.*?= ", "").replaceAll(" .*", ""))[0];
        proche(new double[] {dot(N, versLampe) > 0 ? dot(N, L) : dot(N, versLampe)}, new double[] {dit}, titre);
        if (dot(N, versLampe) <= 0) {
            assertTrue(titre.endsWith("dans le dos : pas de rayon d'ombre"), titre);
            return;
        }
        Objet3D cache = null;
        double auPlus = Math.sqrt(dot(versLampe, versLampe));
        for (Objet3D autre : scene.getObjets()) {
            double d = autre == objet ? auPlus : distance(S, fois(L, gris(-1)), (Sphere) autre);
            if (d < auPlus) {
                auPlus = d;
                cache = autre;
            }
        }
        if (cache != null) {
            cachees++;
            assertTrue(titre.endsWith("cachée par " + origines.apply(cache)), titre);
            proche(L, lire(texte, "L = "), titre);
            return;
        }
        double[] kl = t(lampe.getCouleur());
        double[] diffus = fois(fois(t(objet.getKd()), kl), gris(dot(N, L)));
        double angle = blinn == 0 ? dot(R, L) : dot(N, unite(moins(L, V)));
        double eclat = Math.pow(Math.max(0, angle), (blinn == 0 ? 1 : blinn) * objet.getNs());
        double[] reflet = fois(fois(t(objet.getKs()), kl), gris(eclat));
        if (titre.contains("sans effet")) {
            proche(gris(0), plus(diffus, 1, reflet), titre);
            return;
        }
        eclairees++;
        double[] dits = produit(texte, "diffus = Kd", objet.getKd(), lampe, "N·L \\S+", diffus);
        ajouter(dits, produit(texte, "reflet = Ks", objet.getKs(), lampe,
                "(\\(%s [^-]\\S*|max\\(0, %s -\\S+)\\)\\^\\S+".replace("%s", blinn == 0 ? "R·L" : "N·H"), reflet));
        assertArrayEquals(dits, nombres(titre.replaceFirst(".*  éclairée : diffus \\+ reflet = ", "")), titre);
        proche(L, lire(texte, "L = "), titre);
    }

    /** Un terme et ses facteurs, dont le produit est lui. */
    private static double[] produit(String texte, String debut, Couleur matiere, Lampe lampe, String reste, double[] attendu) {
        Matcher ligne = Pattern.compile("(?m)^ +" + debut + " \\(([^)]*)\\) ⊗ lampe \\(([^)]*)\\) × (" + reste + ") = (\\S+ \\S+ \\S+)$")
                .matcher(texte);
        assertTrue(ligne.find(), debut + " : " + texte);
        assertArrayEquals(t(matiere), nombres(ligne.group(1)), texte);
        assertArrayEquals(t(lampe.getCouleur()), nombres(ligne.group(2)), texte);
        double[] part = nombres(ligne.group(3).replace("max(0, ", "").replaceAll("[()^]", " "));
        double facteur = part.length == 1 ? part[0] : Math.pow(Math.max(0, Math.min(1, part[0])), part[1]);
        double[] terme = nombres(ligne.group(ligne.groupCount()));
        proche(fois(fois(t(matiere), t(lampe.getCouleur())), gris(facteur)), terme, texte);
        proche(attendu, terme, texte);
        return terme;
    }

    private static double distance(double[] P, double[] V, Sphere sphere) {
        double[] f = moins(t(sphere.getCentre()), P);
        double b = dot(f, V);
        double delta = sphere.getRayon() * sphere.getRayon() - dot(plus(f, -b, V), plus(f, -b, V));
        double h = Math.sqrt(delta);
        return !(delta >= 0) || b + h <= 0 ? Double.POSITIVE_INFINITY : b - h > 0 ? b - h : b + h;
    }

    /** Les nombres de la première ligne de ce texte qui commence ainsi. */
    private static double[] lire(String texte, String debut) {
        Matcher ligne = Pattern.compile("(?m)^ *" + Pattern.quote(debut) + "(.*)$").matcher(texte);
        assertTrue(ligne.find(), debut + " : " + texte);
        return nombres(ligne.group(1));
    }

    private static double[] nombres(String texte) {
        return Arrays.stream(texte.trim().split("[ ,]+")).filter(mot -> mot.matches("-?[\\d.]+([eE]-?\\d+)?"))
                .mapToDouble(Double::parseDouble).toArray();
    }

    /** Aux arrondis près, qui grandissent d'un reflet au suivant. */
    private static void proche(double[] attendu, double[] dit, String texte) {
        assertEquals(attendu.length, dit.length, texte);
        for (int c = 0; c < attendu.length; c++) {
            assertEquals(attendu[c], dit[c], 1e-7 * (1 + Math.abs(attendu[c])), texte);
        }
    }
}
