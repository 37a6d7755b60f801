package lancer.mesures.vitesse;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.mesures.Gabarit;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/** Des mesures aux courbes. */
final class Planches {

    private static final Comparator<Releve> PAR_PRIX = Comparator.comparingDouble(Releve::rayons);

    /** Tant de points ont leur nom, au plus : ce qu'un regard retient. */
    private static final int NOMMES = 10;

    private final Constats constats;
    private final String note;

    Planches(Constats constats) {
        this.constats = constats;
        note = constats.circonstances() + ". make mesures";
    }

    // ---- la courbe d'une scène

    /** L'erreur, et au-dessous la part de ce qui se voit, selon le prix en rayons. */
    Planche scene(String scene) {
        Releves siens = constats.methodes(scene);
        List<Releve> front = siens.front();
        Volet erreur = new Volet("", "", "", "erreur, en niveaux").part(2.3)
                .zone(Constats.ARRONDI, "sous l'arrondi de l'écran")
                .front(escalier(front.stream().map(r -> Marque.en(constats.prix(r), r.erreur().valeur)).collect(Collectors.toList())));
        double pixels = siens.get().get(0).nombre("largeur") * siens.get().get(0).nombre("hauteur");
        Volet visible = new Volet("", "", "prix : rayons de toutes sortes, un rayon par pixel valant 1", "visiblement faux, en %")
                .repere(50 / pixels, "aucun");
        List<Releve> nommes = nommes(siens, front, constats.choix(scene));
        for (Object[] s : Noms.METHODES) {
            List<Marque> erreurs = new ArrayList<>();
            List<Marque> parts = new ArrayList<>();
            siens.methode((String) s[0]).get().stream().sorted(PAR_PRIX).forEach(r -> {
                Marque m = new Marque(Intervalle.exact(constats.prix(r)), r.erreur());
                m = nommes.contains(r) ? m.nommee(nom(r)) : m;
                m = front.contains(r) || s[0].equals(Catalogue.AUTO) ? m : m.creuse();
                erreurs.add(estParDefaut(r) ? m.cerclee() : m);
                parts.add(Marque.en(constats.prix(r), 100 * Math.max(0.5 / pixels, r.nombre("visibles"))));
            });
            boolean suite = !((String) s[1]).isEmpty();
            // une méthode dont le prix se règle d'un bout à l'autre, à partir d'un rayon par pixel, a une pente
            String bout = s[0].equals(Catalogue.PROFONDEUR) || erreurs.size() < 2 ? "" : s[1] + (s[0].equals(Catalogue.ENSEMBLE) ? ""
                    : " : pente " + Style.arrondi(constats.pente(scene, (String) s[0])));
            erreur.serie(new Serie("", (Color) s[4], (FormeDePoint) s[5], suite, erreurs).auBout(suite ? bout : ""));
            visible.serie(new Serie("", (Color) s[4], (FormeDePoint) s[5], suite, parts));
        }
        return new Planche(constats.titre(scene),
                "À choisir : le plus bas que l'on veut bien payer sur l'escalier gris, dont chaque marche "
                + "se trompe moins, à coup sûr, que tout ce qui est moins cher ; en creux, le reste ; cerclés, les défauts. Pente : une "
                + "erreur 10^pente fois plus grande pour dix fois plus de rayons. Erreur : racine du carré moyen des écarts à la moyenne "
                + "de chaque pixel, sans limite de reflets ; barres : 19 fois sur 20. Visiblement faux : plus de " + Gabarit.VISIBLE
                + " niveaux sur une composante. " + siens.get().get(0).texte("largeur") + " × " + siens.get().get(0).texte("hauteur")
                + ". Temps : au temps d'un rayon. " + note)
                .colonnes(1).taille(Style.LARGEUR, 1500).volet(erreur).volet(visible);
    }

    private static String nom(Releve r) {
        String temps = Noms.temps(r);
        return Noms.etiquette(r) + (estParDefaut(r) ? " (défaut)" : "") + (temps.isEmpty() ? "" : "\n" + temps);
    }

    /** Les défauts, ce que dit le titre, le moins cher de chaque méthode, --auto, POV-Ray, puis le front. */
    private static List<Releve> nommes(Releves siens, List<Releve> front, Releve choisi) {
        Stream<Releve> premiers = Stream.of(Catalogue.GRILLE, Catalogue.PARTAGE, Catalogue.ENSEMBLE)
                .flatMap(nom -> siens.methode(nom).get().stream().sorted(PAR_PRIX).limit(1));
        return Stream.of(siens.get().stream().filter(Planches::estParDefaut), Stream.of(choisi), premiers,
                siens.methode(Catalogue.AUTO, Catalogue.POVRAY).get().stream(), front.stream())
                .flatMap(s -> s).distinct().limit(NOMMES).collect(Collectors.toList());
    }

    /** Des marches : de l'une à l'autre, il n'y a pas de réglage. */
    private static List<Marque> escalier(List<Marque> marques) {
        List<Marque> marches = new ArrayList<>();
        for (Marque m : marques) {
            if (!marches.isEmpty()) {
                marches.add(new Marque(m.x, marches.get(marches.size() - 1).y));
            }
            marches.add(m);
        }
        return marches;
    }

    /** Réglage du programme, ou du module antialias, quand on ne lui demande rien. */
    private static boolean estParDefaut(Releve r) {
        return r.methode.equals(Catalogue.UN_RAYON) || r.methode.equals(Catalogue.COINS) && r.parametres.equals(Catalogue.COINS_DEFAUT);
    }

    // ---- le nombre de sphères

    Planche spheres() {
        Volet volet = new Volet("", "", "nombre de sphères", "de la commande au PNG écrit, en secondes");
        Object[][] series = {{Catalogue.BOUCLES, "les boucles du cours", Style.BLEU, FormeDePoint.CARRE},
            {Catalogue.POVRAY, "POV-Ray", Style.CIEL, FormeDePoint.TRIANGLE},
            {Catalogue.EMBREE, "Embree, en C++", Style.VERT, FormeDePoint.POINTE},
            {Catalogue.PROGRAMME, "le programme", Style.VERMILLON, FormeDePoint.ROND}};
        for (Object[] s : series) {
            List<Marque> marques = new ArrayList<>();
            for (Releve r : constats.spheres((String) s[0]).get()) {
                Intervalle t = r.rapport().fois(r.nombre("reference_ms") / 1000);
                // d'une seule manche, on ne montre que le temps
                t = Double.isInfinite(t.max) ? Intervalle.exact(t.valeur) : t;
                marques.add(new Marque(Intervalle.exact(r.nombre("spheres")), t).nommee(Style.nombre(t.valeur)));
            }
            volet.serie(new Serie((String) s[1], (Color) s[2], (FormeDePoint) s[3], true, marques));
        }
        return new Planche(constats.pages().get("spheres.titre"), "Démarrage de Java, lecture, préparation, dessin, écriture, à froid."
                + " Au-delà de 10 000 sphères, les boucles ne sont plus mesurées. " + note).volet(volet);
    }
}
