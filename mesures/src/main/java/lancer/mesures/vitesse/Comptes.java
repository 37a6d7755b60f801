package lancer.mesures.vitesse;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.Scene;
import lancer.Sphere;
import lancer.auto.Auto;
import lancer.contrat.Compteurs;
import lancer.mesures.Circonstances;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Intervalle;
import lancer.mesures.juge.PovRay;
import lancer.mesures.juge.SceneJugee;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Style;

/** Les rayons et l'erreur de chaque réglage. Rien n'est chronométré : la charge de la machine n'a pas d'effet. */
final class Comptes {

    static final String CSV = "erreurs.csv";

    static final List<String> COLONNES = Arrays.asList("famille", "scene", "methode", "parametres", "largeur", "hauteur",
            "primaires", "ombre", "reflechis", "rayons", "erreur", "erreur_min", "erreur_max", "visibles", "commit", "date");

    /** Figure d'une même image par deux programmes, si POV-Ray est installé. */
    static final String PROGRAMMES = "stabilite-programmes.png";

    /** Nombre de reflets pour lequel la précision d'un double ne suffit plus. */
    private static final int REFLETS = 15;

    /** Nombre maximal de rayons d'une référence. */
    private static final double VERITE = 1.5e8;

    private final Taille taille;
    private final PovRay povray;
    private final Path dossier;
    private final PrintStream sortie;
    private final Circonstances circonstances = new Circonstances();

    /** @param povray {@code null} s'il n'est pas installé */
    Comptes(Taille taille, PovRay povray, Path dossier, PrintStream sortie) {
        this.taille = taille;
        this.povray = povray;
        this.dossier = dossier;
        this.sortie = sortie;
    }

    /** Écrit {@link #CSV}. */
    void ecrire(List<Catalogue.Groupe> groupes) throws IOException {
        List<String> lignes = new ArrayList<>();
        lignes.add(String.join(",", COLONNES));
        for (Catalogue.Groupe groupe : groupes) {
            sortie.println("erreurs et rayons de " + groupe.scene);
            Path fichier = Scenes.fichier(groupe.scene, dossier);
            Gabarit gabarit = new Gabarit(Scenes.lire(fichier), taille.largeur, taille.hauteur, pas(fichier));
            for (Methode methode : groupe.methodes) {
                if (povray != null || !methode.povray) {
                    lignes.add(new Releve(compter(groupe.scene, fichier, methode, gabarit)).ligne(COLONNES));
                }
            }
        }
        Files.write(dossier.resolve(CSV), lignes, StandardCharsets.UTF_8);
    }

    /** Côté des carrés dont un pixel est tiré, pour que la référence ne dépasse pas son nombre de rayons. */
    private int pas(Path fichier) {
        long rayons = new Methode("", "").limitee(Gabarit.PROFONDEUR, 0)
                .new ScenePrete(Scenes.lire(fichier), taille.largeur, taille.hauteur).faire((couleur, i, j) -> { }, taille.fils).rayons();
        return (int) Math.ceil(Math.sqrt(Gabarit.RAYONS * rayons / VERITE));
    }

    private Map<String, String> compter(String nom, Path fichier, Methode methode, Gabarit gabarit) throws IOException {
        ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
        Map<String, String> champs = Releve.champs("famille", Catalogue.METHODES, "scene", nom, "methode", methode.nom, "parametres",
                methode.parametres, "largeur", taille.largeur, "hauteur", taille.hauteur, "commit", circonstances.commit, "date",
                circonstances.date);
        Scene scene = Scenes.lire(fichier);
        if (methode.povray) {
            SceneJugee jugee = new SceneJugee(povray, nom, scene, Constantes.MAX_REFLETS, taille.largeur, taille.hauteur);
            image = jugee.image(methode.options);
            champs.put("rayons", String.valueOf(povray.rayons()));
        } else {
            Auto auto = methode.nom.equals(Catalogue.AUTO) ? MesureAuto.dessiner(scene, taille, 1, image) : null;
            Compteurs c = auto == null ? methode.new ScenePrete(scene, taille.largeur, taille.hauteur).faire(image, taille.fils)
                    : auto.getLancer().getCompteurs();
            champs.putAll(Releve.champs("primaires", c.primaires, "ombre", c.ombre, "reflechis", c.reflechis, "rayons", c.rayons()
                    + (auto == null ? 0 : auto.getRayonsDesEssais())));
        }
        Intervalle erreur = Intervalle.deLaRacine(gabarit.carres(image));
        champs.putAll(Releve.champs("erreur", Releve.reel(erreur.valeur), "erreur_min", Releve.reel(erreur.min),
                "erreur_max", Releve.reel(erreur.max), "visibles", Releve.reel(gabarit.visibles(image))));
        return champs;
    }

    // ---- deux programmes

    /** Compare les images de deux programmes justes, celui-ci et POV-Ray, sur de petites sphères parfaitement réfléchissantes. */
    void comparer() throws IOException {
        Taille petite = new Taille(200, 150);
        List<Sphere> miroirs = new ArrayList<>();
        for (Objet3D objet : Scenes.lire(Scenes.fichier(Scenes.FOULE + "-10000", dossier)).getObjets()) {
            miroirs.add(new Sphere(((Sphere) objet).getCentre(), ((Sphere) objet).getRayon()));
            miroirs.get(miroirs.size() - 1).setKs(new Couleur(1));
        }
        Planche planche = new Planche("Deux programmes justes, en double, ne donnent pas la même image", "10 000 petites boules, toutes "
                + "des miroirs parfaits, sans lampe : chaque pixel est le ciel vu au bout de la chaîne. " + petite + ". make mesures")
                .colonnes(3).taille(Style.LARGEUR, 1000);
        for (int reflets : new int[] {Constantes.MAX_REFLETS, REFLETS}) {
            SceneJugee jugee = new SceneJugee(povray, "miroirs-parfaits", new Scene(miroirs, Collections.emptyList()), reflets,
                    petite.largeur, petite.hauteur);
            ImageLineaire notre = ImageLineaire.de(jugee.lancer, reflets, taille.fils);
            ImageLineaire sienne = jugee.image();
            BufferedImage ecart = new BufferedImage(petite.largeur, petite.hauteur, BufferedImage.TYPE_INT_RGB);
            double part = 0;
            for (int p = 0; p < petite.pixels(); p++) {
                boolean autre = IntStream.range(3 * p, 3 * p + 3).anyMatch(c -> Math.abs(Math.min(1, notre.getComposantes()[c])
                        - Math.min(1, sienne.getComposantes()[c])) > Gabarit.VISIBLE / 255.0);
                part += autre ? 100.0 / petite.pixels() : 0;
                ecart.setRGB(p % petite.largeur, p / petite.largeur, (autre ? Style.VERMILLON : Style.BANDE).getRGB());
            }
            planche.vignette(image(notre, petite), "lancer, " + reflets + " reflets", "")
                    .vignette(image(sienne, petite), "POV-Ray, " + reflets + " reflets", "")
                    .vignette(ecart, "où ils diffèrent de plus de " + Gabarit.VISIBLE + " niveaux", Style.arrondi(part) + " % des pixels");
        }
        planche.ecrire(dossier.resolve(PROGRAMMES));
    }

    static BufferedImage image(ImageLineaire lineaire, Taille taille) {
        BufferedImage image = new BufferedImage(taille.largeur, taille.hauteur, BufferedImage.TYPE_INT_RGB);
        for (int k = 0; k < taille.pixels(); k++) {
            image.setRGB(k % taille.largeur, k / taille.largeur, lineaire.getCouleur(k).getCode());
        }
        return image;
    }
}
