package lancer.temoins;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
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
import lancer.contrat.PixelFautif;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.contrat.Temoignage;
import lancer.rapide.RechercheRapide;

/**
 * Les pixels témoins : quelques-uns sont dessinés par les boucles du cours aussi, et comparés au bit près. Ils jugent
 * ce à quoi une recherche répond autrement que par les méthodes du cours. Une faute qui change une part p des pixels
 * est vue avec une probabilité d'au moins 1 − (1 − p)^N, N étant tirés au hasard avant l'image, un dans chacune de N
 * parts égales. Quelques autres sont choisis après elle. Leur nombre ne dépend que de comptes, jamais d'une horloge. Là
 * où les boucles mettraient trop de temps à un seul pixel (cent mille sphères), on ne leur pose que ses premières
 * questions.
 */
final class Temoins {

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

    private final Camera camera;
    private final int profondeur;
    private final RechercheRapide jugee;
    private final Recherche boucles;
    private final Lancer rapide;
    private final Lancer cours;
    private final Random hasard = new Random(GRAINE);
    private final int objets;
    private final long pixels;
    private long reste;

    /** @param lancer celui qui dessine, par cette recherche */
    Temoins(RechercheRapide recherche, Lancer lancer, int profondeur) {
        this.profondeur = profondeur;
        camera = lancer.getCamera();
        pixels = (long) camera.getLargeur() * camera.getHauteur();
        objets = lancer.getScene().getObjets().size();
        jugee = recherche;
        Scene scene = lancer.getScene().pourUnFil();
        rapide = new Lancer(scene, camera);
        scene = scene.pourUnFil();
        boucles = new RechercheSimple(scene.getObjets(), new Compteurs());
        scene.setRecherche(recherche.remplacee(boucles));
        cours = new Lancer(scene, camera);
    }

    /** Des pixels tirés au hasard, un dans chacune d'autant de parts égales de l'image. */
    Temoignage auHasard() {
        int sondes = (int) Math.min(NOMBRE, pixels);
        long[] tires = new long[sondes];
        Couleur[] couleurs = new Couleur[sondes];
        for (int k = 0; k < sondes; k++) {
            tires[k] = tirer(k, sondes);
            couleurs[k] = voir(rapide, tires[k]);
        }
        long rayons = rapide.getScene().getCompteurs().rayons();
        reste = Math.max(EXAMENS, pixels * rayons / sondes / RAYONS_PAR_EXAMEN);
        int nombre = (int) Math.min(sondes, reste / Math.max(1, rayons * objets / sondes));
        if (nombre == 0) {
            return new Temoignage(1, questionner(tirer(0, 1)));
        }
        for (int k = 0; k < nombre; k++) {
            if (nombre < sondes) {
                tires[k] = tirer(k, nombre);
                couleurs[k] = voir(rapide, tires[k]);
            }
            if (!couleurs[k].equals(voir(cours, tires[k]))) {
                return new Temoignage(nombre, ecart(tires[k]));
            }
        }
        reste -= nombre * (rayons * objets / sondes);
        return new Temoignage(nombre, null);
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
    Temoignage choisis() {
        Set<List<Object>> vu = new HashSet<>();
        Compteurs comptes = rapide.getScene().getCompteurs();
        int choisis = 0;
        int sondes = (int) Math.min(SONDES, pixels);
        for (int k = 0; k < sondes && choisis < NOMBRE; k++) {
            long pixel = tirer(k, sondes);
            Objet3D voisin = premier(Math.min(pixel + 1, pixels - 1)).getObjet();
            Rayon rayon = premier(pixel);
            Objet3D objet = rayon.getObjet();
            long ombres = comptes.ombre;
            long reflechis = comptes.reflechis;
            Couleur couleur = voir(rapide, pixel);
            ombres = comptes.ombre - ombres;
            reflechis = comptes.reflechis - reflechis;
            long cout = (1 + ombres + reflechis) * objets;
            boolean dedans = objet != null && objet.getNormale(rayon.calcContact()).dot(rayon.getV()) > 0;
            if (cout <= reste && vu.add(Arrays.<Object>asList(objet, dedans, objet == voisin, ombres, reflechis))) {
                choisis++;
                reste -= cout;
                if (!couleur.equals(voir(cours, pixel))) {
                    return new Temoignage(choisis, ecart(pixel));
                }
            }
        }
        return new Temoignage(choisis, null);
    }

    /** Le rayon de ce pixel, et l'objet qu'il rencontre d'abord. */
    private Rayon premier(long pixel) {
        Rayon rayon = camera.getRayon(x(pixel) + 0.5, y(pixel) + 0.5);
        rapide.getScene().getClosestIntersection(rayon);
        return rayon;
    }

    /** L'écart des boucles du cours sur les premières questions d'un pixel, là où une seule coûte presque tout. */
    private String questionner(long pixel) {
        Confrontation confrontation = new Confrontation();
        rapide.getScene().setRecherche(jugee.remplacee(confrontation));
        voir(rapide, pixel);
        return confrontation.ecart ? ecart(pixel) : null;
    }

    /** La recherche jugée, et tant qu'il en reste les moyens, les boucles du cours après elle. */
    private final class Confrontation implements Recherche {

        private final Recherche sienne = jugee.pourUnFil(new Compteurs());
        private boolean ecart;
        private int posees;

        /** La première question l'est toujours. */
        private boolean permise() {
            reste -= objets;
            return posees++ == 0 || reste >= 0;
        }

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            sienne.plusProche(incident, saufLui);
            Objet3D objet = incident.getObjet();
            double distance = incident.getDistance();
            if (permise()) {
                boucles.plusProche(incident, saufLui);
                ecart |= incident.getObjet() != objet || Double.compare(incident.getDistance(), distance) != 0;
            }
        }

        @Override
        public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
            boolean cachee = sienne.estCachee(lampe, P, V, distance, objet);
            if (permise()) {
                ecart |= boucles.estCachee(lampe, P, V, distance, objet) != cachee;
            }
            return cachee;
        }

        @Override
        public Recherche pourUnFil(Compteurs compteurs) {
            return sienne.pourUnFil(compteurs);
        }
    }

    private Couleur voir(Lancer lancer, long pixel) {
        return lancer.voir(x(pixel) + 0.5, y(pixel) + 0.5, profondeur);
    }

    private String ecart(long pixel) {
        return "au pixel " + x(pixel) + ", " + y(pixel) + ", la recherche rapide ne répond pas "
                + "comme les classes du cours : ce sont leurs boucles qui dessinent";
    }

    private int x(long pixel) {
        return (int) (pixel % camera.getLargeur());
    }

    private int y(long pixel) {
        return (int) (pixel / camera.getLargeur());
    }
}
