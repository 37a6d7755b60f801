package lancer.temoins;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.IntConsumer;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.fils.Equipe;
import lancer.fils.Regard;
import lancer.rapide.RechercheRapide;

/**
 * Les pixels témoins : chaque question de leurs rayons est posée aux boucles du cours aussi, et les deux réponses sont
 * comparées au bit près. Ils jugent ce à quoi une recherche répond autrement que par les méthodes du cours. Une faute
 * qui change une part p des pixels est vue avec une probabilité d'au moins 1 − (1 − p)^N, N étant tirés au hasard avant
 * l'image, un dans chacune de N parts égales. Quelques autres sont choisis après elle. Leur nombre ne dépend que de
 * comptes, jamais d'une horloge. Là où les boucles mettraient trop de temps à un seul pixel (cent mille sphères), elles
 * n'ont que ses premières questions.
 */
final class Temoins implements IntConsumer {

    /** Pixels tirés au hasard, au plus ; autant peuvent être choisis en plus. */
    private static final int NOMBRE = 64;

    /** Pixels parmi lesquels se choisissent ceux qui montrent du rare. */
    private static final int SONDES = 128;

    /**
     * Sphères que les boucles du cours examinent pour tous les témoins, au plus : en cinq millisecondes, une fois
     * compilées.
     */
    private static final long EXAMENS = 800_000;

    /** Ou bien une sphère pour tant de rayons de l'image, si c'est plus : moins d'un cinquantième de son temps. */
    private static final long RAYONS_PAR_EXAMEN = 3;

    private static final long GRAINE = 20;

    final Equipe equipe = new Equipe("temoins");
    private final Camera camera;
    private final int profondeur;
    private final int objets;
    private final long pixels;
    private final Lancer rapide;
    private final Lancer confronte;
    private final Recherche jugee;
    private final Recherche boucles;
    private final Confrontation confrontation = new Confrontation();
    private final Random hasard = new Random(GRAINE);
    private long reste;

    /** Combien ont été tirés au hasard ; 0 tant qu'aucun ne l'a été. */
    int nombre;

    /** Le premier écart, en une phrase qui nomme le pixel ; {@code null} s'il n'y en a pas. */
    String ecart;

    /** @param lancer celui qui dessine, par cette recherche */
    Temoins(RechercheRapide recherche, Lancer lancer, int profondeur) {
        this.profondeur = profondeur;
        camera = lancer.getCamera();
        pixels = (long) camera.getLargeur() * camera.getHauteur();
        objets = lancer.getScene().getObjets().size();
        rapide = new Lancer(lancer.getScene().avec(lancer.getScene().getModele()), camera);
        Scene scene = lancer.getScene().avec(lancer.getScene().getModele());
        jugee = scene.getModele().getRecherche();
        boucles = new RechercheSimple(scene.getObjets(), new Compteurs());
        scene.getModele().setRecherche(recherche.remplacee(confrontation));
        confronte = new Lancer(scene, camera);
    }

    /** Juge : d'abord par des pixels tirés au hasard, la fois d'après par d'autres, choisis. */
    @Override
    public void accept(int rang) {
        if (nombre == 0) {
            auHasard();
        } else {
            choisis();
        }
    }

    /** Des pixels tirés au hasard, un dans chacune d'autant de parts égales de l'image. */
    private void auHasard() {
        int sondes = (int) Math.min(NOMBRE, pixels);
        for (int k = 0; k < sondes; k++) {
            voir(rapide, tirer(k, sondes));
        }
        long rayons = rapide.getScene().getCompteurs().rayons();
        reste = Math.max(EXAMENS, pixels * rayons / sondes / RAYONS_PAR_EXAMEN);
        long prix = Math.max(1, rayons * objets / sondes);
        nombre = (int) Math.max(1, Math.min(sondes, reste / prix));
        for (int k = 0; k < nombre && ecart == null; k++) {
            confronter(tirer(k, nombre), reste < prix ? Math.max(objets, reste) : Long.MAX_VALUE);
        }
        reste -= nombre * prix;
    }

    /** Un pixel de la k-ième des n parts de l'image, dans l'ordre de la lecture. */
    private long tirer(int k, int n) {
        long debut = k * pixels / n;
        return debut + hasard.nextInt((int) ((k + 1) * pixels / n - debut));
    }

    /**
     * Ceux qui montrent ce qu'aucun n'a encore montré : un objet, du dehors ou du dedans, un bord, un autre nombre de
     * lampes ou de reflets.
     */
    private void choisis() {
        Set<List<Object>> vu = new HashSet<>();
        Compteurs comptes = rapide.getScene().getCompteurs();
        int sondes = (int) Math.min(SONDES, pixels);
        for (int k = 0; k < sondes && vu.size() < NOMBRE && ecart == null; k++) {
            long pixel = tirer(k, sondes);
            Objet3D voisin = premier(Math.min(pixel + 1, pixels - 1)).getObjet();
            Rayon rayon = premier(pixel);
            Objet3D objet = rayon.getObjet();
            long ombres = comptes.ombre;
            long reflechis = comptes.reflechis;
            voir(rapide, pixel);
            ombres = comptes.ombre - ombres;
            reflechis = comptes.reflechis - reflechis;
            long cout = (1 + ombres + reflechis) * objets;
            boolean dedans = objet != null && objet.getNormale(rayon.calcContact()).dot(rayon.getV()) > 0;
            if (cout <= reste && vu.add(Arrays.<Object>asList(objet, dedans, objet == voisin, ombres, reflechis))) {
                reste -= cout;
                confronter(pixel, Long.MAX_VALUE);
            }
        }
    }

    /** Le rayon de ce pixel, et l'objet qu'il rencontre d'abord. */
    private Rayon premier(long pixel) {
        Rayon rayon = camera.getRayon(x(pixel) + 0.5, y(pixel) + 0.5);
        rapide.getScene().getClosestIntersection(rayon);
        return rayon;
    }

    /** @param examens nombre de sphères que les boucles peuvent examiner : au-delà, elles ne répondent plus */
    private void confronter(long pixel, long examens) {
        confrontation.examens = examens;
        voir(confronte, pixel);
        if (confrontation.differe) {
            ecart = "au pixel " + x(pixel) + ", " + y(pixel) + ", la recherche rapide ne répond pas "
                    + "comme les classes du cours : ce sont leurs boucles qui dessinent";
        }
    }

    /** La recherche jugée, et tant qu'elles en ont les moyens, les boucles du cours après elle. */
    private final class Confrontation implements Recherche {

        private long examens;
        private boolean differe;

        private boolean permise() {
            examens -= objets;
            return examens >= 0;
        }

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            jugee.plusProche(incident, saufLui);
            Objet3D objet = incident.getObjet();
            double distance = incident.getDistance();
            if (permise()) {
                boucles.plusProche(incident, saufLui);
                differe |= incident.getObjet() != objet || Double.compare(incident.getDistance(), distance) != 0;
            }
        }

        @Override
        public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
            boolean cachee = jugee.estCachee(lampe, P, V, distance, objet);
            if (permise()) {
                differe |= boucles.estCachee(lampe, P, V, distance, objet) != cachee;
            }
            return cachee;
        }

        @Override
        public Recherche pourUnFil(Compteurs compteurs) {
            return this;
        }
    }

    private Couleur voir(Lancer lancer, long pixel) {
        return new Regard(equipe, lancer, profondeur).couleur(x(pixel) + 0.5, y(pixel) + 0.5);
    }

    private int x(long pixel) {
        return (int) (pixel % camera.getLargeur());
    }

    private int y(long pixel) {
        return (int) (pixel / camera.getLargeur());
    }
}
