package lancer.auto;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/** De quoi essayer une scène préparée sur quelques blocs, avec tous les fils ; rien ne dépend de leur nombre. */
final class Essais {

    /** Côté d'un bloc, en pixels ; celui d'un pavé en est un nombre entier. Les blocs du bord sont plus petits. */
    static final int COTE = 2;

    /**
     * Ce qu'un échantillonnage peut regarder avant et après un pixel pour en décider. Un qui regarderait plus loin
     * serait jugé à peu près, comme au bord d'un pavé.
     */
    private static final int AVANT = 1;
    private static final int APRES = 2;

    /** Ce qu'on fait de chaque bloc, dans un ordre quelconque et par plusieurs fils. */
    interface Essai {
        /** @param rang du bloc dans la liste */
        void faire(int rang, Pave bloc, Pave pave, Vue vue);
    }

    private static final long GRAINE = 1;
    private static final double NS_PAR_S = 1e9;

    final Camera camera;
    private final int fils;
    private final Lancer prepare;
    private long rayons;
    private double parRayon = Double.POSITIVE_INFINITY;

    Essais(Lancer prepare, int fils) {
        this.prepare = prepare;
        this.fils = fils;
        camera = prepare.getCamera();
    }

    /** Les rayons de toutes sortes lancés jusqu'ici. */
    long rayons() {
        return rayons;
    }

    /** Secondes que demande un rayon, dans la passe la plus rapide. */
    double parRayon() {
        return parRayon;
    }

    /** Vrai si un objet au moins reflète, ne serait-ce qu'un pixel. */
    boolean reflechit() {
        return scene().getObjets().stream().anyMatch(objet -> !objet.getKs().equals(new Couleur()));
    }

    Scene scene() {
        return prepare.getScene();
    }

    double pixels() {
        return (double) camera.getLargeur() * camera.getHauteur();
    }

    /** De la moyenne des blocs à celle de l'image : les blocs du bord ont parfois moins de pixels. */
    double facteur() {
        return COTE * COTE * Pave.nombre(camera.getLargeur(), camera.getHauteur(), COTE) / pixels();
    }

    /**
     * Des blocs semés également, toujours les mêmes pour une taille : l'image est coupée en tranches, dans l'ordre de
     * la lecture, et chacune donne un bloc au hasard.
     *
     * @param combien au plus ; la moitié des blocs de l'image suffit
     * @param autres vrai pour d'autres blocs des mêmes tranches, ceux d'une tranche d'un seul bloc ôtés
     */
    List<Pave> semer(int combien, boolean autres) {
        int nombre = Pave.nombre(camera.getLargeur(), camera.getHauteur(), COTE);
        int tranches = Math.max(1, Math.min(combien, nombre / 2));
        Random hasard = new Random(GRAINE);
        List<Pave> semes = new ArrayList<>();
        for (int k = 0; k < tranches; k++) {
            int debut = (int) ((long) k * nombre / tranches);
            int taille = (int) ((k + 1L) * nombre / tranches) - debut;
            int rang = hasard.nextInt(taille);
            int autre = taille == 1 ? rang : (rang + 1 + hasard.nextInt(taille - 1)) % taille;
            if (!autres || autre != rang) {
                semes.add(Pave.deRang(debut + (autres ? autre : rang), camera.getLargeur(), camera.getHauteur(), COTE));
            }
        }
        return semes;
    }

    /** La scène, dessinée ainsi. */
    Lancer lancer(Echantillonnage echantillonnage, double seuil) {
        return prepare.avec(echantillonnage, seuil);
    }

    /** Fait un essai sur chaque bloc, à la place des pixels de l'image. */
    void passer(List<Pave> blocs, LimitesDesReflets limites, Essai essai) {
        Map<Integer, List<Integer>> rangs = new HashMap<>();
        for (int k = 0; k < blocs.size(); k++) {
            rangs.computeIfAbsent(pave(blocs.get(k)), pave -> new ArrayList<>()).add(k);
        }
        Lancer lancer = lancer(scene().getEchantillonnage(), limites.seuil);
        lancer.parcourir((pave, vue, toile) -> {
            for (int k : rangs.getOrDefault(pave(pave), Collections.<Integer>emptyList())) {
                essai.faire(k, blocs.get(k), pave, vue);
            }
            return 0;
        }, null, limites.reflets, fils);
        rayons += lancer.getCompteurs().rayons();
        // le temps d'une passe qui démarre, ou que l'on dérange, n'apprend rien
        parRayon = Math.min(parRayon, lancer.getDureeNs() / NS_PAR_S / Math.max(1, lancer.getCompteurs().rayons()));
    }

    /** De quel pavé de l'image sont ces pixels. */
    private int pave(Pave pixels) {
        return pixels.j0 / Pave.COTE * camera.getLargeur() + pixels.i0 / Pave.COTE;
    }

    /** Le bloc et ce qui l'entoure, sans sortir du pavé : de quoi y dessiner ses pixels comme dans l'image. */
    static Pave entoure(Pave bloc, Pave pave, Echantillonnage echantillonnage) {
        return echantillonnage.parPixel() ? bloc
                : new Pave(Math.max(pave.i0, bloc.i0 - AVANT), Math.max(pave.j0, bloc.j0 - AVANT),
                        Math.min(pave.i1, bloc.i1 + APRES), Math.min(pave.j1, bloc.j1 + APRES));
    }
}
