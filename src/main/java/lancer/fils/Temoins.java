package lancer.fils;

import java.io.IOException;
import java.io.InputStream;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.function.IntConsumer;
import java.util.zip.CRC32;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Tuple;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.PixelFautif;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;

/**
 * Les pixels témoins, dessinés par les boucles du cours et par la recherche d'une scène : leurs deux couleurs sont
 * comparées au bit près. Ils jugent ce à quoi elle répond autrement que par les méthodes du cours. Une faute qui change
 * une part p des pixels est vue avec une probabilité d'au moins 1 − (1 − p)^N, N étant tirés au hasard, un dans chacune
 * de N parts égales de l'image ; le tirage suit la scène, la taille, la profondeur et les classes du cours, pour que ce
 * qu'une scène cache, la suivante ou la retouche suivante ne le cache pas.
 *
 * <p>Leur nombre est fixé d'avance, par des comptes. Un témoin trop long pour ce qui reste est coupé : les deux
 * recherches n'y répondent plus, après autant de questions ; il se compare encore, et ne compte pas dans N.
 */
public final class Temoins implements IntConsumer {

    /** Pixels tirés au hasard, au plus. */
    private static final int NOMBRE = 64;

    /** Examens de tous les témoins, au plus : cinq millisecondes, une fois compilés. */
    private static final long EXAMENS = 800_000;

    /** Un examen pour tant de ceux du dessin, si c'est plus. */
    private static final long PART_DU_DESSIN = 20;

    /** Part du plus petit de ces nombres qui va aux sondes ; à un témoin, au plus, celle de ce qui reste. */
    private static final long PART_DES_SONDES = 4;
    private static final int PART_D_UN_TEMOIN = 4;
    private static final long INFINIMENT = Long.MAX_VALUE / 2;

    /** Objets et lampes dont se tire le hasard, au plus. */
    private static final int CONTENU = 500;

    private static final Class<?>[] COURS = {Camera.class, Constantes.class, Couleur.class, Lampe.class, Lancer.class,
        Objet3D.class, Point.class, PointContact.class, Rayon.class, Scene.class, Sphere.class, Tuple.class,
        Vecteur.class};
    private static final long CLASSES = classes();

    private final Scene scene;
    private final Camera camera;
    final int profondeur;
    private final long pixels;
    private final Equipe equipe = new Equipe("temoins");
    private int nombre;
    private String ecart;
    private final Fautes fautes;

    /**
     * @param profondeur nombre de réflexions permises
     * @param fautes celles d'un dessin qui continue malgré les pixels qui échouent, à qui dire s'il en est qui
     *     réussissent ; {@code null} : un témoin qui échoue l'arrête
     */
    public Temoins(Scene scene, Camera camera, int profondeur, Fautes fautes) {
        this.scene = scene;
        this.camera = camera;
        this.profondeur = profondeur;
        this.fautes = fautes;
        pixels = (long) camera.getLargeur() * camera.getHauteur();
    }

    /**
     * Juge la recherche de la scène, dans un fil dont la pile suffit aux réflexions permises.
     *
     * @throws lancer.contrat.PixelFautif si un témoin ne peut être calculé
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     */
    public void juger() {
        equipe.faire(1, Collections.singletonList(this));
    }

    /** Le nombre N de pixels dessinés tout entiers des deux façons. */
    public int getNombre() {
        return nombre;
    }

    /** Le premier écart, en une phrase qui nomme le pixel ; {@code null} s'il n'y en a pas. */
    public String getEcart() {
        return ecart;
    }

    @Override
    public void accept(int rang) {
        Random hasard = new Random(graine());
        int sondes = (int) Math.min(NOMBRE, pixels);
        long[] tires = new long[sondes];
        Couleur[] reponses = new Couleur[sondes];
        Bornee rapide = new Bornee(scene.getModele().getRecherche());
        for (int k = 0; k < sondes; k++) {
            long debut = k * pixels / sondes;
            tires[k] = debut + hasard.nextInt((int) ((k + 1) * pixels / sondes - debut));
            Couleur vue = rapide.voir(tires[k], EXAMENS / PART_DES_SONDES / sondes, INFINIMENT);
            reponses[k] = rapide.coupee ? null : vue;
        }
        long permis = Math.max(EXAMENS, pixels * rapide.examens() / sondes / PART_DU_DESSIN);
        // ce que coûte un témoin aux boucles, au plus
        long prix = Math.max(1, rapide.questions * scene.getObjets().size() / sondes);
        int voulus = (int) Math.max(1, Math.min(sondes, (permis - rapide.examens()) / prix));
        Bornee boucles = new Bornee(new RechercheSimple(scene.getObjets(), new Compteurs()));
        for (int k = 0; k < voulus && ecart == null; k++) {
            int debut = k * sondes / voulus;
            int s = debut + hasard.nextInt((k + 1) * sondes / voulus - debut);
            long reste = permis - rapide.examens() - boucles.examens();
            Couleur attendue = boucles.voir(tires[s], reste / Math.min(PART_D_UN_TEMOIN, voulus - k), INFINIMENT);
            Couleur reponse = boucles.coupee || reponses[s] == null
                    ? rapide.voir(tires[s], INFINIMENT, boucles.posees) : reponses[s];
            if (!Objects.equals(reponse, attendue)) {
                ecart = "au pixel " + x(tires[s]) + ", " + y(tires[s]) + ", la recherche rapide ne répond pas comme "
                        + "les classes du cours : ce sont leurs boucles qui dessinent";
            }
            nombre += boucles.coupee ? 0 : 1;
        }
    }

    private int x(long pixel) {
        return (int) (pixel % camera.getLargeur());
    }

    private int y(long pixel) {
        return (int) (pixel / camera.getLargeur());
    }

    /** Graine dont se tirent les pixels : la scène, la taille, la profondeur, et les classes du cours. */
    private long graine() {
        long graine = CLASSES << Integer.SIZE ^ Objects.hash(camera.getLargeur(), camera.getHauteur(), profondeur);
        List<Objet3D> objets = scene.getObjets();
        for (int k = 0; k < objets.size(); k += 1 + objets.size() / CONTENU) {
            Objet3D o = objets.get(k);
            graine = 31 * graine + Objects.hash(o.getClass().getName(), o.getKd(), o.getKs(), o.getNs());
            if (o instanceof Sphere) {
                graine = 31 * graine + Objects.hash(((Sphere) o).getCentre(), ((Sphere) o).getRayon());
            }
        }
        List<Lampe> lampes = scene.getLampes();
        for (int k = 0; k < lampes.size(); k += 1 + lampes.size() / CONTENU) {
            graine = 31 * graine + Objects.hash(lampes.get(k).getPosition(), lampes.get(k).getCouleur());
        }
        return graine;
    }

    /** La somme des octets des classes du cours : une retouche la change. */
    private static long classes() {
        CRC32 somme = new CRC32();
        byte[] octets = new byte[1 << 14];
        for (Class<?> classe : COURS) {
            try (InputStream lue = classe.getResourceAsStream(classe.getSimpleName() + ".class")) {
                for (int n = 0; lue != null && n >= 0; n = lue.read(octets)) {
                    somme.update(octets, 0, n);
                }
            } catch (IOException e) {
                // une classe qui ne se relit pas : le reste suffit à tirer
            }
        }
        return somme.getValue();
    }

    /**
     * Une recherche qui ne répond plus passé tant d'examens, ou tant de questions : le ciel partout, et toute lampe
     * cachée.
     */
    private final class Bornee implements Recherche {

        private final Compteurs compteurs = new Compteurs();
        private final Recherche recherche;
        private final Regard regard;
        private long examensPermis;
        private long questionsPermises;
        /** Questions de tous les pixels, et du dernier. */
        long questions;
        long posees;
        boolean coupee;

        Bornee(Recherche bornee) {
            recherche = bornee.pourUnFil(compteurs);
            Scene vue = scene.avec(scene.getModele());
            vue.getModele().setRecherche(scene.getModele().getRecherche().remplacee(this));
            regard = new Regard(equipe, new Lancer(vue, camera), profondeur, null);
        }

        long examens() {
            return questions + compteurs.examens();
        }

        /** La couleur de ce pixel, {@code null} s'il échoue et que le dessin le tolère. */
        Couleur voir(long pixel, long examensDePlus, long questionsDePlus) {
            long avant = questions;
            examensPermis = examens() + examensDePlus;
            questionsPermises = avant + questionsDePlus;
            coupee = false;
            try {
                Couleur vue = regard.couleur(x(pixel) + 0.5, y(pixel) + 0.5);
                if (fautes != null) {
                    fautes.reussir();
                }
                return vue;
            } catch (PixelFautif e) {
                if (fautes == null) {
                    throw e;
                }
                return null;
            } finally {
                posees = questions - avant;
            }
        }

        private boolean repond() {
            coupee |= questions >= questionsPermises || examens() >= examensPermis;
            questions += coupee ? 0 : 1;
            return !coupee;
        }

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            if (repond()) {
                recherche.plusProche(incident, saufLui);
            } else {
                incident.setContact(null, Constantes.INFINI);
            }
        }

        @Override
        public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
            return !repond() || recherche.estCachee(lampe, P, V, distance, objet);
        }

        @Override
        public Recherche pourUnFil(Compteurs autres) {
            return this;
        }
    }
}
