package lancer.mesures.vitesse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.auto.Auto;
import lancer.auto.Echelle;
import lancer.auto.Mesure;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.dessin.Dessin;
import lancer.mesures.Circonstances;
import lancer.mesures.FichierCsv;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Intervalle;
import lancer.mesures.Nombres;
import lancer.mesures.scenes.Scenes;
import lancer.scene.SectionLue;

/**
 * Mesure de {@code --auto erreur=E} : l'erreur annoncée est-elle juste, l'erreur voulue est-elle tenue, et à quel prix ? Les scènes sont
 * les scènes livrées, des foules, et celles où quelques pixels portent l'erreur. Les échelons sont dessinés en entier : le prix de la
 * commande, en rayons, est comparé à celui du moins cher de ceux qui tiennent l'erreur.
 */
public final class MesureAuto {

    private static final String COLONNES =
            "scene,taille,voulue,reglage,vraie,mesuree,incertitude,verdict,rayons,essais,moins_cher,commit,date";

    private static final Taille TAILLE = new Taille(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);

    /** Un pixel de chaque carré de ce côté est mesuré, ou tous, là où quelques-uns portent l'erreur ; rayons de chacun, deux fois. */
    private static final int PAS = 3;
    private static final int COTE = 8;
    private static final int COTE_DE_TOUS = 5;

    /** Au-dessous de cette erreur, en niveaux, les échelons suivants ne sont pas dessinés : ils tiennent toutes celles qui sont voulues. */
    private static final double ASSEZ = 0.25;

    private static final double[] VOULUES = {0.5, 1, 2, 4};

    /** Erreur, en niveaux, au-dessus de laquelle la demi-largeur de l'intervalle est comparée à l'erreur. */
    private static final double SENSIBLE = 0.3;

    /** Une demande, et ce qui en est su, en une ligne ; des rayons par pixel. NaN s'il n'y a pas d'intervalle, ou d'échelon qui tienne. */
    static final class Reponse {

        final String ligne;
        final String sorte;
        final String verdict;
        final String quand;
        private final String[] champs;

        /** @param champs un par colonne */
        Reponse(String... champs) {
            this.champs = champs;
            ligne = FichierCsv.ligne((Object[]) champs);
            sorte = sorte(champs[0]);
            verdict = champs[7];
            quand = champs[11] + " " + champs[12];
        }

        double nombre(String colonne) {
            return Nombres.champ(champs[Arrays.asList(COLONNES.split(",")).indexOf(colonne)]);
        }

        boolean aUnIntervalle() {
            return !Double.isNaN(nombre("incertitude"));
        }
    }

    private MesureAuto() {
    }

    /** @param args le fichier, écrit à la fin ; puis les scènes, toutes si aucune n'est nommée */
    public static void main(String[] args) throws IOException {
        Path csv = Paths.get(args[0]);
        List<String> lignes = new ArrayList<>(Collections.singletonList(COLONNES));
        Path dossier = Files.createTempDirectory("mesure-auto");
        List<String> noms = new ArrayList<>(Arrays.asList(args).subList(1, args.length));
        if (noms.isEmpty()) {
            noms.addAll(Catalogue.livrees());
            noms.addAll(Arrays.asList("foule-300", "ombres-fines", "poussiere"));
            noms.addAll(Scenes.RARES);
        }
        for (String nom : noms) {
            for (Reponse reponse : repondre(nom, Scenes.lire(Scenes.fichier(nom, dossier)), TAILLE, VOULUES)) {
                lignes.add(reponse.ligne);
                System.out.println(reponse.ligne);
            }
        }
        Files.write(csv, lignes);
        System.out.println(tableau(FichierCsv.lire(csv)).trim());
    }

    /** Choix, mesure et verdict du programme pour chaque erreur voulue ; l'erreur vraie ; le moins cher des échelons qui la tiennent. */
    static List<Reponse> repondre(String nom, Scene scene, Taille taille, double... voulues) {
        boolean tous = Scenes.RARES.contains(nom);
        int pas = tous ? 1 : PAS;
        Gabarit gabarit = new Gabarit(scene, taille.largeur, taille.hauteur, pas, tous ? COTE_DE_TOUS : COTE, (i, j) -> true);
        Lancer prepare = Dessin.lancer(scene, taille.largeur, taille.hauteur, false);
        List<Reglages> echelle = Echelle.de(Options.lire().pour(Collections.singletonMap(new Antialias(),
                new SectionLue("Antialias"))),
                false, false);
        // le prix du moins cher des échelons qui tiennent chaque erreur
        NavigableMap<Double, Double> prix = new TreeMap<>();
        for (int rang = 0; rang < echelle.size() && (prix.isEmpty() || prix.firstKey() > ASSEZ); rang++) {
            Lancer lancer = prepare.avec(echelle.get(rang).getModele());
            double vraie = erreur(ImageLineaire.de(lancer, echelle.get(rang).getProfondeur(), taille.fils), gabarit);
            prix.put(vraie, (double) lancer.getAtelier().getCompteurs().rayons() / taille.pixels());
        }
        Circonstances c = new Circonstances();
        List<Reponse> reponses = new ArrayList<>();
        for (double voulue : voulues) {
            ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
            Auto auto = new Auto(prepare, echelle, voulue, taille.fils);
            do {
                auto.getLancer().TracerImage(image, auto.getChoisi().getProfondeur(), taille.fils);
            } while (!auto.controler(image::getCouleur));
            Mesure mesure = auto.getMesure();
            reponses.add(new Reponse(nom, taille.toString(), String.valueOf(voulue), Echelle.dire(auto.getChoisi()).replace(',', ' '),
                    Nombres.champ(erreur(image, gabarit)), Nombres.champ(mesure.erreur),
                    mesure.aUnIntervalle ? Nombres.champ(mesure.incertitude) : "",
                    mesure.aUnIntervalle ? auto.getVerdict().replace("erreur voulue ", "") : "rien vu",
                    Nombres.champ((double) auto.getLancer().getAtelier().getCompteurs().rayons() / taille.pixels()),
                    Nombres.champ((double) auto.getRayonsDesEssais() / taille.pixels()),
                    Nombres.champ(prix.headMap(voulue, true).values().stream().mapToDouble(p -> p).min().orElse(Double.NaN)),
                    c.commit, c.date.replaceFirst("T.*", "")));
        }
        return reponses;
    }

    private static double erreur(ImageLineaire image, Gabarit gabarit) {
        return Intervalle.deLaRacine(gabarit.carres(image)).valeur;
    }

    private static String sorte(String scene) {
        if (Scenes.RARES.contains(scene) || scene.startsWith("poussiere")) {
            return "détails rares";
        }
        return scene.startsWith(Scenes.FOULE) || Scenes.DIFFICILES.contains(scene) ? "foules, ombres fines" : "scènes communes";
    }

    /** Tableau de la page : une ligne par sorte de scène. */
    static String tableau(List<String[]> lues) {
        List<Reponse> reponses = lues.stream().map(Reponse::new).collect(Collectors.toList());
        List<String> titres = Arrays.asList("", "l'intervalle contient l'erreur vraie", "dites « tenue »", "à tort",
                "dites « dépassée » ou « incertaine »", "rien vu", "demi-largeur plus petite que l'erreur", "rayons, médiane",
                "rayons, au pire");
        return Tableaux.table(titres, reponses.stream().map(r -> r.sorte).distinct().map(sorte -> bilan(sorte,
                reponses.stream().filter(r -> r.sorte.equals(sorte)).collect(Collectors.toList()))).collect(Collectors.toList()))
                + Tableaux.source(reponses.stream().map(r -> r.quand).min(Comparator.comparing(q -> q.replaceFirst(".* ", ""))).orElse(""));
    }

    private static List<String> bilan(String sorte, List<Reponse> reponses) {
        double[] prix = reponses.stream().mapToDouble(r -> (r.nombre("rayons") + r.nombre("essais")) / r.nombre("moins_cher"))
                .filter(p -> !Double.isNaN(p)).toArray();
        double pire = Arrays.stream(prix).max().orElse(Double.NaN);
        return Arrays.asList(sorte,
                compte(reponses, Reponse::aUnIntervalle, r -> Math.abs(r.nombre("mesuree") - r.nombre("vraie")) <= r.nombre("incertitude")),
                compte(reponses, r -> true, r -> r.verdict.equals("tenue")),
                compte(reponses, r -> r.verdict.equals("tenue"), r -> r.nombre("vraie") > r.nombre("voulue")),
                compte(reponses, r -> true, r -> r.verdict.matches("dépassée|incertaine")),
                compte(reponses, r -> true, r -> !r.aUnIntervalle()),
                compte(reponses, r -> r.aUnIntervalle() && r.nombre("vraie") > SENSIBLE,
                        r -> r.nombre("incertitude") < r.nombre("mesuree")),
                "× " + Nombres.nombre(Intervalle.mediane(prix)), "× " + Nombres.nombre(pire));
    }

    private static String compte(List<Reponse> reponses, Predicate<Reponse> parmi, Predicate<Reponse> condition) {
        return reponses.stream().filter(parmi).filter(condition).count() + " fois sur " + reponses.stream().filter(parmi).count();
    }
}
