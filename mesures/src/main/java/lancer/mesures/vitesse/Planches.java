package lancer.mesures.vitesse;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.atelier.Scenes;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/** Des mesures aux courbes. */
final class Planches {

    private static final int LARGEUR_VIGNETTE = 940;
    private static final int HAUTEUR_VIGNETTE = 620;

    /** Ce que montre une barre, au plus : tant de fois plus, et moins. */
    private static final double BARRE = 3;

    private final Constats constats;
    private final List<Map<String, String>> besoins;
    private final String note;

    Planches(Constats constats) {
        this.constats = constats;
        besoins = constats.besoins;
        Releve r = constats.releves.get().get(0);
        note = r.texte("largeur") + " × " + r.texte("hauteur") + ", " + r.texte("fils") + " fils. " + r.circonstances() + ". make mesures";
    }

    // ---- la courbe principale d'une scène

    /** @param vignette vrai pour une image plus petite, de mêmes caractères, sans légende, dont les points n'ont pas tous leur nom */
    Planche scene(String scene, boolean vignette) {
        Releves siens = constats.methodes(scene);
        double reference = siens.referenceMs();
        List<Releve> front = siens.front();
        Volet volet = new Volet("", "", "temps d'un dessin à chaud, en ms", "erreur, en pas d'écran")
                .zone(Constats.ARRONDI, "sous l'arrondi de l'écran, en moyenne quadratique")
                .front(front.stream().map(r -> marque(r, reference, true)).collect(Collectors.toList()));
        for (Object[] s : Noms.METHODES) {
            List<Marque> marques = new ArrayList<>();
            for (Releve r : siens.methode((String) s[0]).get()) {
                Marque m = marque(r, reference, front.contains(r));
                boolean nommee = !vignette || front.contains(r) || estParDefaut(r) || r.methode.equals(Catalogue.GRILLE);
                m = nommee ? m.nommee(Noms.etiquette(r)) : m;
                marques.add(estParDefaut(r) ? m.cerclee() : m);
            }
            volet.serie(new Serie((String) s[1], (Color) s[3], (FormeDePoint) s[4],
                    s[0].equals(Catalogue.PROFONDEUR) || s[0].equals(Catalogue.GRILLE), marques));
        }
        if (vignette) {
            return new Planche(constats.titre(scene), "").taille(LARGEUR_VIGNETTE, HAUTEUR_VIGNETTE).sansLegende().volet(volet);
        }
        return new Planche(constats.titre(scene), "Plus bas, plus juste ; plus à gauche, plus vite ; en creux, ce que le front bat."
                + " Erreur : contre la moyenne de chaque pixel sans limite de réflexions. Barres : 19 fois sur 20. Temps : le rapport à un"
                + " rayon, fois " + Style.nombre(reference) + " ms. " + note).volet(volet);
    }

    private static Marque marque(Releve r, double reference, boolean pleine) {
        Marque m = new Marque(borne(r.rapport().fois(reference)), borne(r.erreur()));
        return pleine ? m : m.creuse();
    }

    /** D'une seule manche, on ne montre que le temps ; une barre n'écrase pas la courbe. */
    private static Intervalle borne(Intervalle i) {
        return Double.isInfinite(i.max) ? Intervalle.exact(i.valeur)
                : new Intervalle(i.valeur, Math.max(i.min, i.valeur / BARRE), Math.min(i.max, i.valeur * BARRE));
    }

    /** Ce que fait le programme, ou le module antialias, quand on ne lui demande rien. */
    private static boolean estParDefaut(Releve r) {
        return r.methode.equals(Catalogue.UN_RAYON) || r.methode.equals(Catalogue.COINS) && r.parametres.equals(Catalogue.COINS_DEFAUT);
    }

    // ---- ce que coûte chaque demande

    private static final String[][] DEMANDES = {{"lampe une de plus", "une lampe de plus"},
        {"reflets aucun", "aucun reflet"}, {"brume", "la brume"}, {"Blinn", "Blinn pour Phong"},
        {"telle quelle", "la même, ailleurs"}, {"partage n=4 seuil=0.1", "« partage » (4 ; 0,1)"},
        {"coins n=3 seuil=0.05", "« coins » (3 ; 0,05)"}, {"boucles du cours", "les boucles du cours"}};

    Planche demandes() {
        Releves siens = constats.demandes();
        Releve base = siens.le(Catalogue.TELLE_QUELLE, "");
        List<String> noms = new ArrayList<>();
        List<Marque> temps = new ArrayList<>();
        List<Marque> rayons = new ArrayList<>();
        for (String[] nom : DEMANDES) {
            siens.get().stream().filter(r -> r.nom().equals(nom[0])).forEach(r -> {
                Intervalle i = borne(r.rapport());
                temps.add(new Marque(i, Intervalle.exact(noms.size())).nommee("× " + Style.nombre(i.valeur)));
                rayons.add(Marque.en(r.rayons() / base.rayons(), noms.size()));
                noms.add(nom[1]);
            });
        }
        Volet volet = Volet.rangees("", "fois autant que la scène du cours telle quelle", noms, 1)
                .serie(new Serie("rayons, comptés", Style.BLEU, FormeDePoint.CARRE, false, rayons))
                .serie(new Serie("temps, 19 fois sur 20", Style.VERMILLON, FormeDePoint.ROND, false, temps));
        return new Planche(constats.pages().get("demandes.titre"), "« La même, ailleurs » : la même scène dans d'autres machines"
                + " virtuelles, ce qui ne devrait rien changer. " + note).volet(volet);
    }

    // ---- le nombre de sphères

    Planche spheres() {
        double reference = constats.releves.de(Catalogue.SPHERES).referenceMs();
        Volet volet = new Volet("", "", "nombre de sphères", "de la commande au PNG écrit, en secondes");
        Object[][] series = {{Scenes.FOULE, Catalogue.BOUCLES, "les boucles du cours", Style.BLEU, FormeDePoint.CARRE},
            {Scenes.FOULE, Catalogue.POVRAY, "POV-Ray", Style.CIEL, FormeDePoint.TRIANGLE},
            {Scenes.ETOILES, Catalogue.PROGRAMME, "le programme, neuf étoiles en plus", Style.POURPRE, FormeDePoint.LOSANGE},
            {Scenes.FOULE, Catalogue.PROGRAMME, "le programme", Style.VERMILLON, FormeDePoint.ROND}};
        for (Object[] s : series) {
            List<Marque> marques = new ArrayList<>();
            for (Releve r : constats.spheres((String) s[0], (String) s[1]).get()) {
                Intervalle t = borne(r.rapport().fois(reference / 1000));
                if (!Double.isNaN(t.valeur)) {
                    marques.add(new Marque(Intervalle.exact(r.nombre("spheres")), t).nommee(Style.nombre(t.valeur)));
                }
            }
            volet.serie(new Serie((String) s[2], (Color) s[3], (FormeDePoint) s[4], true, marques));
        }
        extrapoler(volet, reference);
        return new Planche(constats.pages().get("spheres.titre"), "Démarrage de Java, lecture, préparation, dessin, écriture, à froid."
                + " Au-delà de 10 000 sphères, le temps des boucles n'est pas mesuré : leurs examens sont comptés sur quelques pixels. "
                + note)
                .volet(volet);
    }

    /** Du dernier temps mesuré aux boucles dont seuls les examens sont comptés. */
    private void extrapoler(Volet volet, double reference) {
        List<Marque> marques = new ArrayList<>();
        double examen = 0;
        for (Releve r : constats.spheres(Scenes.FOULE, Catalogue.BOUCLES).get()) {
            double secondes = r.rapport().valeur * reference / 1000;
            if (!Double.isNaN(secondes)) {
                examen = secondes / r.nombre("tests");
                marques.clear();
                marques.add(Marque.en(r.nombre("spheres"), secondes));
            } else {
                secondes = examen * r.nombre("tests");
                marques.add(Marque.en(r.nombre("spheres"), secondes).creuse().nommee("≈ " + Style.arrondi(secondes / 60) + " min"));
            }
        }
        if (marques.size() > 1) {
            volet.serie(new Serie("les boucles, extrapolation", Style.BLEU, FormeDePoint.CARRE, true, marques).enPointille());
        }
    }

    // ---- la parcimonie

    Planche parcimonie() {
        List<String> noms = besoins.stream().map(b -> b.get("scene") + ", " + b.get("lampes_utiles") + " lampe"
                + (b.get("lampes_utiles").equals("1") ? "" : "s") + " sur " + b.get("lampes")).collect(Collectors.toList());
        Volet rayons = Volet.rangees("Des rayons par pixel", "rayons par pixel", noms, 0)
                .serie(rayons("rayons_utiles", "ceux qui peuvent changer un pixel", Style.VERT, FormeDePoint.LOSANGE))
                .serie(rayons("rayons", "ceux que lance le programme", Style.VERMILLON, FormeDePoint.ROND))
                .serie(rayons("rayons_sans_economie", "sans économie : tous les reflets, toutes les ombres", Style.GRIS,
                        FormeDePoint.CARRE));
        List<Marque> demandees = new ArrayList<>();
        for (int k = 0; k < besoins.size(); k++) {
            double reflets = Constats.nombre(besoins.get(k), "profondeur_utile");
            demandees.add(Marque.en(Math.max(0.5, reflets), k).nommee(reflets == 0 ? "aucun" : Style.nombre(reflets)));
        }
        Volet reflets = Volet.rangees("Des reflets qui comptent : le programme en suit " + Constantes.MAX_REFLETS, "reflets à la suite",
                besoins.stream().map(b -> b.get("scene")).collect(Collectors.toList()), Constantes.MAX_REFLETS)
                .serie(new Serie("ce qu'en demande l'écran", Style.BLEU, FormeDePoint.ROND, false, demandees));
        return new Planche(constats.titreDeLaParcimonie(), "Tout est compté, rien n'est chronométré ; un rayon par pixel, "
                + besoins.get(0).get("largeur") + " × " + besoins.get(0).get("hauteur") + ". make mesures")
                .volet(rayons).volet(reflets);
    }

    private Serie rayons(String colonne, String nom, Color couleur, FormeDePoint forme) {
        return new Serie(nom, couleur, forme, false, besoins.stream()
                .map(b -> Marque.en(Constats.nombre(b, colonne) / Constats.nombre(b, "largeur") / Constats.nombre(b, "hauteur"),
                        besoins.indexOf(b)))
                .collect(Collectors.toList()));
    }
}
