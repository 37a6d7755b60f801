package lancer.fils;

import java.util.List;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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
            equipe.faire(travaux(echantillonnage,
                    vuesDesFils.stream().map(Vue::seconde).collect(Collectors.toList()), toile));
        }
        Compteurs comptes = new Compteurs();
        vuesDesFils.forEach(vue -> comptes.ajouter(vue.compteurs()));
        comptes.pixelsRaffines = relevesFaits().mapToLong(releve -> releve.raffines).sum();
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
        return Stream.generate(vues).limit(Math.min(fils, paves.size())).collect(Collectors.toList());
    }

    /** Le travail de chaque fil : dessiner les pavés qu'il prend, ou ceux que sa seconde vue revoit. */
    private List<Runnable> travaux(Echantillonnage echantillonnage, List<Vue> vues, Toile toile) {
        boolean seconde = vues.get(0).estSeconde();
        AtomicReferenceArray<Releve> relevesDuRegard = seconde ? releves : new AtomicReferenceArray<>(paves.size());
        releves = relevesDuRegard;
        int[] rangs = IntStream.range(0, paves.size())
                .filter(k -> !seconde || relevesDuRegard.get(k).aRevoir).toArray();
        return vues.stream().map(vue -> (Runnable) () -> {
            for (int tache = equipe.prendre(); tache < rangs.length; tache = equipe.prendre()) {
                Pave pave = paves.get(rangs[tache]);
                relevesDuRegard.set(rangs[tache], echantillonnage.tracer(pave, pave, vue, toile));
                fautes.peindre(pave, toile);
            }
        }).collect(Collectors.toList());
    }

    private Stream<Releve> relevesFaits() {
        AtomicReferenceArray<Releve> relevesConnus = releves;
        return IntStream.range(0, relevesConnus.length()).mapToObj(relevesConnus::get).filter(Objects::nonNull);
    }

    /** Dit si ce qui est dessiné laisse craindre des détails que personne n'a vus ({@link Releve#soupcon}). */
    public boolean seRegardeDeuxFois() {
        return relevesFaits().mapToDouble(releve -> releve.soupcon).sum() > 0;
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
        double entier = seRegardeDeuxFois() ? 0.5 : 1;
        return relevesFaits().mapToDouble(releve -> releve.aRevoir ? entier : 1).sum() / releves.length();
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
