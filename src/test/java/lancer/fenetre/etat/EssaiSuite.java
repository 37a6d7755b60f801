package lancer.fenetre.etat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lancer.Main;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.image.ImageMemoire;
import lancer.inspection.Inspection;
import lancer.scene.EcritureScene;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;
import lancer.scene.Surveillance;
import lancer.scene.TexteScene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** Une fenêtre sans écran ni fil : des événements, l'état qui suit, et les ordres, que l'essai exécute quand il veut. */
abstract class EssaiSuite {

    static final String ROUGE = "[Sphere 1]\ncentre=0 0.2 6\nrayon=1\nKd=0.9 0.15 0.1\nKs=0.3 0.3 0.3\nns=40\n"
            + "[Lampe 1]\nposition=-4 6 -3\ncouleur=0.9 0.9 0.85\n";

    @TempDir
    Path dossier;
    Path boule;
    Reglages options;
    Etat etat;
    /** Les ordres donnés, en mots, dans leur ordre ; ceux que rien n'a encore exécutés, par numéro. */
    final List<String> journal = new ArrayList<>();
    final Map<Integer, Runnable> attendus = new HashMap<>();
    /** Le nombre d'états publiés. */
    int publies;
    /** Le sujet du dernier ordre de dessin, ou de lecture. */
    int dernier;

    /** Ce qu'un moteur ferait plus tard est noté, et fait quand l'essai le demande. */
    private final Executant moteur = new Executant() {

        @Override
        public void lire(int numero, String fichier, Demande avant, Avancement avancement) {
            journal.add("lire " + new File(fichier).getName());
            dernier = numero;
            attendus.put(numero, () -> lireEtDessiner(numero, fichier, avant));
        }

        @Override
        public void dessiner(int numero, Demande demande, Avancement avancement) {
            journal.add("dessiner");
            dernier = numero;
            attendus.put(numero, () -> EssaiSuite.this.dessiner(numero, demande));
        }

        @Override
        public void expliquer(int numero, Inspection inspection, Dessin dessin) {
            journal.add("expliquer " + inspection.x + " " + inspection.y);
            attendus.put(numero, () -> {
                inspection.faire(dessin::seRegardeDeuxFois);
                repondre(numero, suite -> suite.raconter(new Explication.Faite(dessin, inspection, null, null)));
            });
        }

        @Override
        public void mesurer(int numero, Dessin dessin, Map<Reglages, Essai> essais) {
            journal.add("mesurer");
            attendus.put(numero, () -> essais.values().forEach(essai -> {
                for (int k = 0; k < 3; k++) {
                    essais.computeIfPresent(essai.reglages, (r, e) -> new Essai(r, e.durees.avec(1_000_000_000), 1, 0.1));
                    repondre(numero, suite -> suite.compter(essais.get(essai.reglages)));
                }
            }));
        }

        @Override
        public void arreter(int numero) {
            journal.add("arreter");
        }

        @Override
        public void ecrire(int numero, SceneLue voulue, SceneLue avant, TexteScene connu) {
            journal.add("ecrire");
            attendus.put(numero, () -> ecriture(numero, () -> EcritureScene.remplacer(voulue, avant, connu), voulue.nom, false));
        }

        @Override
        public void ecrireSous(int numero, TexteScene texte, String fichier) {
            journal.add("ecrire sous " + new File(fichier).getName());
            attendus.put(numero, () -> ecriture(numero, () -> {
                EcritureScene.ecrire(texte, fichier);
                return texte;
            }, fichier, true));
        }

        @Override
        public void enregistrer(ImageMemoire image, File cible, String scene) {
            journal.add("enregistrer");
        }

        @Override
        public void surveiller(String fichier) {
            journal.add("surveiller " + new File(fichier).getName());
        }

        @Override
        public void garderLaPolice(int taille) {
            journal.add("police " + taille);
        }

        @Override
        public void terminer() {
            journal.add("terminer");
        }
    };

    private final Dialogue vue = new Dialogue() {

        @Override
        public void demanderDEcrire(String nom) {
            journal.add("demander " + nom);
        }

        @Override
        public void proposerEcrireSous(String pourquoi, String fichier) {
            journal.add("proposer " + (pourquoi == null ? "" : "après " + pourquoi.replaceFirst("^[^ ]* : ", "")));
        }

        @Override
        public void demanderOuEnregistrer(ImageMemoire image, String scene) {
            journal.add("ou enregistrer");
        }

        @Override
        public void copier(String texte) {
            journal.add("copier");
        }

        @Override
        public void copier(ImageMemoire image) {
            journal.add("copier");
        }

        @Override
        public void fermer() {
            journal.add("fermer");
        }
    };

    @BeforeEach
    void ouvrir() throws IOException {
        boule = fichier("boule.ini", ROUGE);
        options = Options.lire("--taille=32x24", boule.toString());
        etat = Etat.vide(32, 24, 12);
    }

    Path fichier(String nom, String texte) throws IOException {
        return Files.write(dossier.resolve(nom), texte.getBytes(StandardCharsets.UTF_8));
    }

    String lu(Path fichier) throws IOException {
        return new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
    }

    /** Ouvre la scène, et achève son image. */
    void montrerLaBoule() {
        arrive(suite -> suite.montrerLaPremiere(
                new Demande(LecteurScene.lireEtGarder(boule.toString(), part -> { }), options)));
        executer();
        journal.clear();
    }

    /** Voici ce qui arrive. @return l'état qui suit */
    Etat arrive(Suite.Evenement evenement) {
        Suite suite = Suite.apres(etat, evenement);
        publies += suite.getEtat() == etat ? 0 : 1;
        etat = suite.getEtat();
        suite.getOrdres().forEach(ordre -> ordre.executer(moteur, vue));
        return etat;
    }

    void repondre(int numero, Suite.Evenement reponse) {
        arrive(Suite.reponse(numero, reponse));
    }

    /** Le travail de chaque ordre qui attend se fait, dans leur ordre, et ceux qu'il en suit. */
    void executer() {
        while (!attendus.isEmpty()) {
            int premier = attendus.keySet().stream().min(Integer::compare).get();
            attendus.remove(premier).run();
        }
    }

    private void lireEtDessiner(int numero, String fichier, Demande avant) {
        String version = Surveillance.version(fichier);
        try {
            SceneLue lue = LecteurScene.lireEtGarder(fichier, part -> { });
            Demande demande = avant == null ? new Demande(lue, options) : avant.avecLecture(lue);
            repondre(numero, suite -> suite.lue(version, demande));
            dessiner(numero, demande);
        } catch (RuntimeException e) {
            repondre(numero, suite -> suite.echouer(version, e));
        }
    }

    private void dessiner(int numero, Demande demande) {
        Dessin[] dit = new Dessin[1];
        new Main(demande, dessin -> {
            boolean ebauche = dit[0] != null;
            dit[0] = dessin;
            repondre(numero, suite -> {
                if (ebauche) {
                    suite.ebaucher(dessin);
                } else {
                    suite.preparer(dessin);
                }
            });
        }).doTracerImage(demande.largeur, demande.hauteur);
        repondre(numero, suite -> suite.achever(dit[0]));
    }

    private void ecriture(int numero, java.util.function.Supplier<TexteScene> ecriture, String fichier, boolean sous) {
        try {
            TexteScene texte = ecriture.get();
            repondre(numero, suite -> suite.ecrit(texte, fichier, sous));
        } catch (RuntimeException e) {
            repondre(numero, suite -> suite.refuserDEcrire(e.getMessage()));
        }
    }

    /** L'observation du fichier de ce nom, tel qu'il est. */
    void observer(Path celui) {
        arrive(suite -> suite.voirLeFichier(celui.toString(), Surveillance.version(celui.toString())));
    }

    /** Tire la boule vers la droite. */
    void tirer() {
        arrive(suite -> suite.saisir(16, 11, 2));
        arrive(suite -> suite.tirer(18, 11));
        arrive(Suite::lacher);
    }

    String section(String cle) {
        return etat.demande.lue.getSection("Sphere 1").mot(cle, null);
    }
}
