package lancer.fils;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.Supplier;
import lancer.Couleur;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Releve;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Les fils qui se partagent les pavés d'une image, avec leurs compteurs, leurs fautes et leur durée. Un atelier dessine
 * une image à la fois.
 */
public final class Atelier {

    private final List<Pave> paves;
    private final Equipe equipe = new Equipe();
    private final Fautes fautes;
    /** Le dernier relevé de chaque pavé, du dessin en cours ou du dernier ; {@code null} s'il n'est pas encore vu. */
    private volatile AtomicReferenceArray<Releve> releves = new AtomicReferenceArray<>(1);
    private Compteurs compteurs = new Compteurs();
    private long dureeNs;

    /** @param largeur celle de l'image, en pixels ; de même sa hauteur */
    public Atelier(int largeur, int hauteur) {
        paves = Pave.battus(largeur, hauteur);
        fautes = new Fautes(largeur);
    }

    /**
     * Dessine tous les pixels de l'image. Si elle se regarde deux fois, dessine de nouveau les pavés qu'il faut revoir.
     *
     * @param vues rend la vue de chaque fil
     * @param fils nombre de fils d'exécution, au moins 1
     * @throws CancellationException si le fil appelant est interrompu
     * @throws PixelFautif si un pixel ne peut être calculé
     */
    public void dessiner(Echantillonnage echantillonnage, Supplier<Vue> vues, Toile toile, int fils) {
        long debut = System.nanoTime();
        List<Vue> vuesDesFils = creer(vues, fils);
        equipe.faire(travaux(echantillonnage, vuesDesFils, toile));
        if (seRegardeDeuxFois()) {
            List<Vue> secondes = new ArrayList<>();
            for (Vue vue : vuesDesFils) {
                secondes.add(vue.seconde());
            }
            equipe.faire(travaux(echantillonnage, secondes, toile));
        }
        Compteurs comptes = new Compteurs();
        for (Vue vue : vuesDesFils) {
            comptes.ajouter(vue.compteurs());
        }
        comptes.pixelsRaffines = 0;
        for (Releve releve : relevesFaits()) {
            comptes.pixelsRaffines += releve.raffines;
        }
        compteurs = comptes;
        dureeNs = System.nanoTime() - debut;
    }

    /**
     * Regarde l'image une première fois, sans rien peindre.
     *
     * @return {@link #seRegardeDeuxFois}
     */
    public boolean regarder(Echantillonnage echantillonnage, Supplier<Vue> vues, int fils) {
        equipe.faire(travaux(echantillonnage, creer(vues, fils), (couleur, i, j) -> { }));
        return seRegardeDeuxFois();
    }

    /** Une vue par fil, et pas plus de fils que de pavés. */
    private List<Vue> creer(Supplier<Vue> vues, int fils) {
        List<Vue> vuesDesFils = new ArrayList<>();
        for (int fil = 0; fil < Math.min(fils, paves.size()); fil++) {
            vuesDesFils.add(vues.get());
        }
        return vuesDesFils;
    }

    /** Le travail de chaque fil : dessiner les pavés qu'il prend, ou ceux que sa seconde vue revoit. */
    private List<Runnable> travaux(Echantillonnage echantillonnage, List<Vue> vues, Toile toile) {
        boolean seconde = vues.get(0).estSeconde();
        AtomicReferenceArray<Releve> relevesDuRegard = seconde ? releves : new AtomicReferenceArray<>(paves.size());
        releves = relevesDuRegard;
        List<Integer> rangs = new ArrayList<>();
        for (int k = 0; k < paves.size(); k++) {
            if (!seconde || relevesDuRegard.get(k).aRevoir) {
                rangs.add(k);
            }
        }
        List<Runnable> travaux = new ArrayList<>();
        for (Vue vue : vues) {
            travaux.add(() -> {
                for (int tache = equipe.prendre(); tache < rangs.size(); tache = equipe.prendre()) {
                    Pave pave = paves.get(rangs.get(tache));
                    relevesDuRegard.set(rangs.get(tache), echantillonnage.tracer(pave, pave, vue, toile));
                    fautes.peindre(pave, toile);
                }
            });
        }
        return travaux;
    }

    private List<Releve> relevesFaits() {
        AtomicReferenceArray<Releve> relevesDuRegard = releves;
        List<Releve> faits = new ArrayList<>();
        for (int k = 0; k < relevesDuRegard.length(); k++) {
            if (relevesDuRegard.get(k) != null) {
                faits.add(relevesDuRegard.get(k));
            }
        }
        return faits;
    }

    /** Dit si ce qui est dessiné laisse craindre des détails que personne n'a vus ({@link Releve#soupcon}). */
    public boolean seRegardeDeuxFois() {
        double soupcon = 0;
        for (Releve releve : relevesFaits()) {
            soupcon += releve.soupcon;
        }
        return soupcon > 0;
    }

    /**
     * Rend la couleur calculée d'un point de l'écran.
     *
     * @throws PixelFautif si elle n'est pas finie
     * @throws CancellationException si le dessin est arrêté
     */
    public Couleur verifier(Couleur couleur, double xe, double ye) {
        equipe.obeir();
        return PixelFautif.exigerFinie(couleur, xe, ye);
    }

    /** Lève de nouveau cet échec d'un point de l'écran ou, s'il est toléré, rend une couleur à sa place. */
    public Couleur relever(Throwable echec, double xe, double ye) {
        // ni un arrêt ni le manque de mémoire n'est un échec du pixel
        if (echec instanceof CancellationException) {
            throw (CancellationException) echec;
        }
        if (echec instanceof OutOfMemoryError) {
            throw (OutOfMemoryError) echec;
        }
        return fautes.noter(echec, xe, ye);
    }

    /** La part dessinée de l'image ou du brouillon en cours, de 0 à 1 ; un pavé à revoir ne compte que pour moitié. */
    public double getAvancement() {
        double aRevoir = seRegardeDeuxFois() ? 0.5 : 1;
        double faits = 0;
        for (Releve releve : relevesFaits()) {
            faits += releve.aRevoir ? aRevoir : 1;
        }
        return faits / releves.length();
    }

    /** Les pixels dont le calcul a échoué, s'ils sont tolérés. */
    public Fautes getFautes() {
        return fautes;
    }

    /** Compteurs du dernier dessin achevé, sommés sur tous les fils. */
    public Compteurs getCompteurs() {
        return compteurs;
    }

    /** Le temps du dernier dessin achevé, en nanosecondes. */
    public long getDureeNs() {
        return dureeNs;
    }
}
