package lancer.mesures.vitesse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.mesures.Circonstances;
import lancer.mesures.FichierCsv;
import lancer.mesures.Lancement;
import lancer.mesures.Nombres;
import lancer.mesures.scenes.Scenes;
import lancer.rapide.Preparation;

/**
 * À partir de combien d'objets et de rayons les structures de {@link Preparation} coûtent-elles moins que les boucles du cours ? Chaque
 * ligne est une scène dessinée un certain nombre de fois par un processus entier, à un fil : le moindre temps de processeur de chaque
 * façon, à tour de rôle.
 */
public final class MesureRecherche {

    private static final String COLONNES = "objets,lampes,images,boucles_s,structures_s,commit,date";

    private static final List<String> SCENES = Arrays.asList("foule-20", "diffus", "foule-40");
    private static final int[] IMAGES = {1, 2, 4, 8};
    private static final int FOIS = 3;

    private static final double NS_PAR_S = 1e9;

    private MesureRecherche() {
    }

    /** @param args le fichier à écrire ; ou, dans un des processus mesurés, une scène, le nombre d'images et la façon de chercher */
    public static void main(String[] args) throws IOException {
        if (args.length == 1) {
            mesurer(Paths.get(args[0]));
        } else {
            dessiner(Scenes.lire(Paths.get(args[0])), Integer.parseInt(args[1]), Boolean.parseBoolean(args[2]));
        }
    }

    private static void dessiner(Scene scene, int images, boolean structures) {
        Camera camera = scene.getCamera(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);
        Lancer lancer = new Lancer(Preparation.preparer(scene, camera, structures ? Long.MAX_VALUE : 0), camera);
        for (int k = 0; k < images; k++) {
            lancer.TracerImage((couleur, xe, ye) -> { }, Constantes.MAX_REFLETS, 1);
        }
    }

    private static void mesurer(Path csv) throws IOException {
        Circonstances ici = new Circonstances();
        Path dossier = Files.createTempDirectory("recherche");
        List<String> lignes = new ArrayList<>(Arrays.asList(COLONNES));
        for (String nom : SCENES) {
            Path fichier = Scenes.fichier(nom, dossier);
            Scene scene = Scenes.lire(fichier);
            for (int images : IMAGES) {
                double[] moindres = {Constantes.INFINI, Constantes.INFINI};
                for (int k = 0; k < 2 * FOIS; k++) {
                    Lancement un = new Lancement(dossier.resolve("cout"), Lancement.JAVA, "-XX:+UseSerialGC", "-Xmn16m", "-cp",
                            System.getProperty("java.class.path"), MesureRecherche.class.getName(), fichier, images, k % 2 == 1).reussi();
                    moindres[k % 2] = Math.min(moindres[k % 2], un.pris[1] / NS_PAR_S);
                }
                lignes.add(FichierCsv.ligne(scene.getObjets().size(), scene.getLampes().size(), images, Nombres.champ(moindres[0]),
                        Nombres.champ(moindres[1]), ici.commit, ici.date));
                System.out.println(lignes.get(lignes.size() - 1));
            }
        }
        Files.write(csv, lignes);
    }
}
