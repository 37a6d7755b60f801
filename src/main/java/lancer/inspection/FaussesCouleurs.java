package lancer.inspection;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.function.DoubleFunction;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.PointContact;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Releve;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import lancer.image.ImageMemoire;
import lancer.image.ImageMemoire.Teinte;
import lancer.texte.Nombre;

/** Vues d'une scène en fausses couleurs ({@code --vue}), chacune avec sa légende. Le ciel y est noir. */
public final class FaussesCouleurs {

    /** Les teintes des nombres de rayons, du noir au blanc, de plus en plus claires. */
    private static final int[] ECHELLE = {0x000000, 0x2C115F, 0x721F81, 0xB73779, 0xF1605D, 0xFEB078, 0xFFFFFF};

    /** Déplacements d'un rayon, relatifs, du plus grand au plus petit : 10 puissance moins ces nombres. */
    private static final int PREMIER = 6;
    private static final int DERNIER = 16;

    /** Nombre de rayons déplacés au hasard, pour chaque déplacement. */
    private static final int TIRAGES = 3;

    /** Rang, dans l'échelle, de la teinte de chaque marge, de 0 à 11 décimales. */
    private static final int[] MARGES = {6, 6, 6, 5, 5, 4, 4, 4, 2, 2, 2, 0};

    /** Les nombres d'un pixel où rien n'est vu : ni une normale, ni une distance, ni un compte. Sa teinte est noire. */
    private static final Couleur CIEL = new Couleur(-1);
    private static final Couleur NOIR = new Couleur();

    private final Lancer lancer;
    private final Camera camera;
    private final ImageMemoire image;
    private final int profondeur;
    private final int fils;

    /**
     * @param lancer celui de la scène préparée
     * @param image reçoit les teintes et, si elle en garde, les nombres que montrent ces teintes
     * @param profondeur nombre de réflexions permises
     */
    public FaussesCouleurs(Lancer lancer, ImageMemoire image, int profondeur, int fils) {
        this.lancer = lancer;
        this.image = image;
        this.profondeur = profondeur;
        this.fils = fils;
        camera = lancer.getCamera();
    }

    /** Dessine une vue. @param nom une de celles d'{@link lancer.commande.Option#VUE} */
    public void dessiner(String nom) {
        Map<String, Runnable> vues = new HashMap<>();
        vues.put("normales", this::dessinerLesNormales);
        vues.put("distance", this::dessinerLesDistances);
        vues.put("lampes", this::dessinerLesLampes);
        vues.put("rayons", this::dessinerLesRayons);
        vues.put("marge", this::dessinerLesMarges);
        vues.get(nom).run();
    }

    private void dessinerLesNormales() {
        image.teintes = Arrays.asList(new Teinte("x", new Couleur(1, 0.5, 0.5)),
                new Teinte("y", new Couleur(0.5, 1, 0.5)), new Teinte("z", new Couleur(0.5, 0.5, 1)),
                new Teinte("ciel", NOIR));
        legender("N = %.4f %.4f %.4f", "vue normales : (N + 1)/2 : x en rouge, y en vert, z en bleu ; ciel noir");
        tracer(parContact((scene, contact) -> {
            Vecteur N = contact.objet.getNormale(contact);
            return new Couleur(N.x, N.y, N.z);
        }), (N, x, y) -> image.drawPixel(N.add(new Couleur(1)).div(2), N, x, y));
    }

    private void dessinerLesLampes() {
        int toutes = lancer.getScene().getLampes().size();
        image.teintes = Arrays.asList(new Teinte("0", NOIR), new Teinte("", new Couleur(0.5)),
                new Teinte("" + toutes, new Couleur(1)));
        legender("lampes : %.0f", "vue lampes : lampes qui éclairent, noir : aucune, blanc : " + toutes + " sur "
                + toutes + " ; ciel noir");
        tracer(parContact(FaussesCouleurs::compterLesLampes),
                (n, x, y) -> image.drawPixel(n.div(Math.max(1, toutes)), n, x, y));
    }

    /** Du blanc au gris sombre, selon le rang de la distance : un horizon n'éclaircit pas le reste. */
    private void dessinerLesDistances() {
        double[] distances = nombrer(parContact((scene, contact) -> new Couleur(contact.distance)));
        double[] contacts = Arrays.stream(distances).filter(d -> d > 0).distinct().sorted().toArray();
        int dernier = contacts.length - 1;
        if (dernier >= 0) {
            image.teintes = Arrays.asList(new Teinte(Nombre.arrondir(contacts[0]), new Couleur(1)),
                    new Teinte(Nombre.arrondir(contacts[contacts.length / 2]), new Couleur(0.55)),
                    new Teinte(Nombre.arrondir(contacts[dernier]), new Couleur(0.1)), new Teinte("ciel", NOIR));
        }
        legender("d = %.5f", "vue distance : " + (dernier < 0 ? "aucun contact" : "d = "
                + Nombre.arrondir(contacts[0]) + " en blanc, " + Nombre.arrondir(contacts[contacts.length / 2])
                + " au milieu, " + Nombre.arrondir(contacts[dernier]) + " en gris sombre") + " ; ciel noir");
        // le contact le plus lointain n'est pas noir comme le ciel
        peindre(distances, d -> d > 0
                ? new Couleur(1 - 0.9 * Arrays.binarySearch(contacts, d) / Math.max(1, dernier)) : CIEL);
    }

    /** Selon le logarithme du nombre de rayons, de 1 au plus grand de cette image. */
    private void dessinerLesRayons() {
        double[] rayons = nombrer(this::compterLesRayons);
        double max = Arrays.stream(rayons).max().getAsDouble();
        image.teintes = Arrays.asList(new Teinte("1", NOIR), new Teinte("", teinte(0.25)),
                new Teinte(String.format("%.0f", Math.sqrt(max)), teinte(0.5)), new Teinte("", teinte(0.75)),
                new Teinte(String.format("%.0f", max), new Couleur(1)));
        legender("rayons : %.0f",
                String.format("vue rayons : noir : 1 rayon, rose : %.0f, blanc : %.0f", Math.sqrt(max), max));
        peindre(rayons, n -> teinte(Math.log(n) / Math.log(Math.max(2, max))));
    }

    private void dessinerLesMarges() {
        legender("marge : %.0f décimales (" + (DERNIER - PREMIER + 1) + " : rien ne change)",
                "vue marge : décimales que peut perdre le rayon avant que la couleur change d'un niveau, d'après "
                + TIRAGES + " rayons au hasard pour chacune ; noir : rien ne change, violet : 8 à 10, rouge : 5 à 7, "
                + "orange : 3 et 4, blanc : l'arrondi suffit");
        image.teintes = Arrays.asList(new Teinte("" + (DERNIER - PREMIER + 1), new Couleur(0.7)),
                new Teinte("8 à 10", teinteDeMarge(8)),
                new Teinte("5 à 7", teinteDeMarge(5)), new Teinte("3 et 4", teinteDeMarge(3)),
                new Teinte("0 à 2", teinteDeMarge(0)));
        int[] gris = new int[image.largeur * image.hauteur];
        tracer((pave, voulus, vue, toile) ->
                Lancer.TracerPave(pave, voulus, (xe, ye) -> new Couleur(marge(xe, ye, vue, gris)), toile),
                (m, x, y) -> image.drawPixel(teinteDeMarge((int) m.r), m, x, y));
        image.aLEcran = grossir(gris);
    }

    /** @param format celui du texte des nombres d'un pixel @param legende une ligne */
    private void legender(String format, String legende) {
        image.sens = n -> n.equals(CIEL) ? "ciel" : String.format(Locale.ROOT, format, n.r, n.v, n.b);
        image.echelle = legende;
    }

    private void tracer(Echantillonnage echantillonnage, Toile toile) {
        lancer.getAtelier().dessiner(echantillonnage, lancer.getVues(profondeur), toile, fils);
    }

    /** Le nombre que cet échantillonnage donne à chaque pixel comme couleur ; la somme, s'il est vu deux fois. */
    private double[] nombrer(Echantillonnage echantillonnage) {
        double[] nombres = new double[image.largeur * image.hauteur];
        tracer(echantillonnage, (n, x, y) -> nombres[y * image.largeur + x] += n.r);
        return nombres;
    }

    private void peindre(double[] nombres, DoubleFunction<Couleur> teinte) {
        for (int k = 0; k < nombres.length; k++) {
            image.drawPixel(teinte.apply(nombres[k]), new Couleur(nombres[k]), k % image.largeur, k / image.largeur);
        }
    }

    /** Donne à chaque pixel les nombres du premier contact vu en son centre, ou {@link #CIEL}. */
    private Echantillonnage parContact(BiFunction<Scene, PointContact, Couleur> nombres) {
        return (pave, voulus, vue, toile) -> {
            Scene scene = lancer.getScene().pourUnFil();
            Lancer.TracerPave(pave, voulus, (xe, ye) -> {
                try {
                    PointContact contact = scene.getClosestIntersection(camera.getRayon(xe, ye));
                    return contact == null ? CIEL : nombres.apply(scene, contact);
                } catch (RuntimeException | Error e) {
                    return lancer.getAtelier().relever(e, xe, ye);
                }
            }, toile);
            vue.compteurs().ajouter(scene.getCompteurs());
            return Releve.RIEN;
        };
    }

    private static Couleur teinteDeMarge(int decimales) {
        return couleur(ECHELLE[MARGES[decimales]]);
    }

    /** Les pixels qui ne sont pas noirs, trois fois plus larges et plus hauts, sur ces gris. */
    private int[] grossir(int[] gris) {
        int[] codes = gris.clone();
        for (int k = 0; k < codes.length; k++) {
            for (int v = 0; v < 9 && image.codes[k] != NOIR.getCode(); v++) {
                int x = k % image.largeur + v % 3 - 1;
                int y = k / image.largeur + v / 3 - 1;
                boolean dedans = x >= 0 && x < image.largeur && y >= 0 && y < image.hauteur;
                if (dedans && (v == 4 || image.codes[y * image.largeur + x] == NOIR.getCode())) {
                    codes[y * image.largeur + x] = image.codes[k];
                }
            }
        }
        return codes;
    }

    private static Couleur compterLesLampes(Scene scene, PointContact contact) {
        Vecteur N = contact.objet.getNormale(contact);
        int eclairent = 0;
        for (Lampe lampe : scene.getLampes()) {
            Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
            eclairent += N.dot(versLampe) > 0 && !scene.estCachee(lampe, contact, versLampe.normalized(),
                    versLampe.norme(), contact.objet) ? 1 : 0;
        }
        return new Couleur(eclairent);
    }

    /** Compte les rayons de toutes sortes de chaque pixel d'un pavé, dessiné selon l'échantillonnage de la scène. */
    private Releve compterLesRayons(Pave pave, Pave voulus, Vue vue, Toile toile) {
        int large = pave.i1 - pave.i0;
        long[] rayons = new long[large * (pave.j1 - pave.j0)];
        Vue comptee = (xe, ye) -> {
            long avant = vue.compteurs().rayons();
            Couleur couleur = vue.couleur(xe, ye);
            rayons[((int) ye - pave.j0) * large + (int) xe - pave.i0] += vue.compteurs().rayons() - avant;
            return couleur;
        };
        Releve releve = lancer.getEchantillonnage().tracer(pave, voulus, vue.estSeconde() ? comptee.seconde() : comptee,
                (c, i, j) -> { });
        for (int k = 0; k < rayons.length; k++) {
            toile.drawPixel(new Couleur(rayons[k]), pave.i0 + k % large, pave.j0 + k / large);
        }
        return releve;
    }

    /** Le nombre de décimales que peut perdre la direction du rayon de ce point, de 0 à 11. */
    private int marge(double xe, double ye, Vue vue, int[] gris) {
        SplittableRandom hasard = new SplittableRandom((long) ye * camera.getLargeur() + (long) xe);
        Couleur dessinee = vue.couleur(xe, ye);
        double clarte = 0.4 + 0.6 * Math.min(1, (dessinee.r + dessinee.v + dessinee.b) / 3);
        gris[(int) ye * image.largeur + (int) xe] = new Couleur(clarte).getCode();
        // le rayon passe par l'œil : le tourner, c'est déplacer son point de l'écran
        double tour = new Vecteur(camera.getOeil(), camera.getEcran(xe, ye)).norme()
                * camera.getLargeur() / Constantes.ECHELLE;
        int dernier = PREMIER - 1;
        // deux décimales de suite : le hasard redonne parfois la même couleur
        for (int k = PREMIER; k <= Math.min(DERNIER, dernier + 2); k++) {
            double pixels = tour * Math.pow(10, -k);
            for (int tirage = 0; tirage < TIRAGES && dernier < k; tirage++) {
                double angle = 2 * Math.PI * hasard.nextDouble();
                Couleur couleur = vue.couleur(xe + pixels * Math.cos(angle), ye + pixels * Math.sin(angle));
                dernier = different(dessinee, couleur) ? k : dernier;
            }
        }
        return DERNIER - dernier;
    }

    /** Dit si une composante, limitée à [0, 1], diffère de plus d'un niveau. */
    private static boolean different(Couleur a, Couleur b) {
        return Math.max(ecart(a.r, b.r), Math.max(ecart(a.v, b.v), ecart(a.b, b.b))) > 1;
    }

    private static double ecart(double a, double b) {
        return 255 * Math.abs(Math.max(0, Math.min(1, a)) - Math.max(0, Math.min(1, b)));
    }

    /** La teinte de cette part de l'échelle, de 0 à 1. */
    private static Couleur teinte(double part) {
        double place = part * (ECHELLE.length - 1);
        int k = Math.min(ECHELLE.length - 2, (int) place);
        return couleur(ECHELLE[k]).mul(k + 1 - place).add(couleur(ECHELLE[k + 1]).mul(place - k));
    }

    private static Couleur couleur(int code) {
        return new Couleur(code >> 16 & 255, code >> 8 & 255, code & 255).div(255);
    }
}
