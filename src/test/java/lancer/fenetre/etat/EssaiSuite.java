package lancer.fenetre.etat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.awt.image.BufferedImage;
import java.io.File;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import lancer.Main;
import lancer.commande.Etape;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.essai.Essai;
import lancer.image.ImageMemoire;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.scene.EcritureScene;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;
import lancer.scene.Surveillance;
import lancer.scene.TexteScene;
import lancer.texte.Nombre;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/**
 * Une fenêtre sans écran ni fil : des événements, l'état qui suit, et des ordres, dont l'essai fait venir les réponses une à une.
 * Ce qui arrive a un nom, que suit parfois une valeur : « F5 », « clic 16 11 », « fichier ns=41 ».
 */
public abstract class EssaiSuite {

    public static final String ROUGE = "[Sphere 1]\ncentre=0 0.2 6\nrayon=1\nKd=0.9 0.15 0.1\nKs=0.3 0.3 0.3\nns=40\n"
            + "[Lampe 1]\nposition=-4 6 -3\ncouleur=0.9 0.9 0.85\n";

    @TempDir
    public Path dossier;
    protected Path boule;
    protected Reglages options;
    protected Etat etat;
    /** Les ordres donnés, en mots, dans leur ordre ; ceux à qui il reste à répondre, par numéro. */
    protected final List<String> journal = new ArrayList<>();
    protected final TreeMap<Integer, Iterator<Suite.Evenement>> attendus = new TreeMap<>();
    /** Combien d'états ont suivi un autre, et le remplacent. */
    protected int publies;
    /** Ce qui est copié : un texte, ou une image ; et la scène lue change ainsi. */
    protected Object copie;
    protected Consumer<SceneLue> apresLecture = lue -> { };
    private Avancement avancement;

    /** Ce qui peut arriver, par son nom. */
    protected final Map<String, Consumer<String>> arrivees = new LinkedHashMap<>();

    {
        geste("Ctrl+E", Suite::ecrire);
        geste("Ctrl+Z", Suite::defaire);
        geste("Échap", Suite::echapper);
        geste("+", suite -> suite.reflechir(true));
        geste("-", suite -> suite.reflechir(false));
        geste("Espace", suite -> suite.tenir(true));
        geste("F2", suite -> suite.montrer(Onglet.REGLAGES));
        geste("F3", Suite::mesurer);
        geste("Ctrl+R", Suite::remplir);
        geste("Ctrl+Haut", suite -> suite.approcher(true));
        geste("ferme le message", Suite::fermerLeMessage);
        geste("écrire sous", Suite::demanderOuEcrire);
        geste("saisit", suite -> suite.saisir(16, 11, 2));
        geste("tire", suite -> suite.tirer(18, 11));
        geste("lâche", Suite::lacher);
        geste("droite", suite -> suite.aller(1, 0));
        // au-delà, ce que le hasard ne tire pas
        geste("F5", Suite::relire);
        geste("lâche Espace", suite -> suite.tenir(false));
        geste("Ctrl+Bas", suite -> suite.approcher(false));
        geste("Ctrl+Q", Suite::quitter);
        geste("Ctrl+S", Suite::enregistrer);
        geste("Ctrl+C", Suite::copierLImage);
        geste("Ctrl+Maj+C", Suite::copierLesReglages);
        geste("répond Écrire", Suite::accepterDEcrire);
        geste("répond Oublier", suite -> suite.oublier());
        geste("répond Rester", Suite::rester);
        geste("ne s'enregistre pas", suite -> suite.annoncer("disque plein", true));
        geste("échoue", suite -> suite.echouer(null, new IllegalStateException("boum")));
        geste("textes", (suite, points) -> suite.agrandir(Integer.parseInt(points)));
        geste("vue", (suite, nom) -> suite.voir(nom.equals("image") ? null : nom));
        geste("étape", (suite, nom) -> suite.choisirLEtape(Etape.valueOf(nom)));
        geste("clic", (suite, ou) -> suite.expliquer(new Pixel(deux(ou)[0], deux(ou)[1])));
        geste("va", (suite, pas) -> suite.aller(deux(pas)[0], deux(pas)[1]));
        geste("place", (suite, taille) -> suite.placer(deux(taille)[0], deux(taille)[1]));
        geste("vise", (suite, ou) -> suite.saisir(deux(ou)[0], deux(ou)[1], 2));
        geste("tape", (suite, valeur) -> suite.changer("Sphere 1", valeur.split("=")[0], valeur.split("=")[1], false));
        geste("flèche", (suite, valeur) -> suite.changer("Sphere 1", valeur.split("=")[0], valeur.split("=")[1], true));
        geste("ouvre", (suite, nom) -> suite.ouvrir(dossier.resolve(nom).toString()));
        geste("répond", (suite, nom) -> suite.ecrireSous(dossier.resolve(nom).toString()));
        arrivees.put("suite", rien -> repondre(attendus.lastKey()));
        arrivees.put("achève", rien -> executer());
        arrivees.put("compte", rien -> publies = 0);
        arrivees.put("lit", cent -> avancement.lire(Integer.parseInt(cent) / 100.0));
        arrivees.put("observe", nom -> observer(nom.isEmpty() ? boule : dossier.resolve(nom)));
        arrivees.put("fichier", valeur -> {
            fichier("boule.ini", ROUGE.replaceFirst("\n" + valeur.split("=")[0] + "=.*", "\n" + valeur));
            observer(boule);
        });
        arrivees.put("corrige", nom -> {
            fichier(nom, ROUGE);
            observer(dossier.resolve(nom));
        });
        arrivees.put("efface", rien -> {
            faire(() -> Files.deleteIfExists(boule));
            observer(boule);
        });
        arrivees.put("sans scène", rien -> etat = Etat.vide(32, 24, 12));
        // un ordre que rien n'attend plus : sa réponse ne change rien
        arrivees.put("l'ancien répond", rien -> {
            Etat avant = etat;
            repondre(attendus.firstKey());
            assertSame(avant, etat);
        });
    }

    /** Ce qu'un moteur ferait plus tard est noté, et fait quand l'essai le demande. */
    private final Executant moteur = new Executant() {

        @Override
        public void lire(int numero, String fichier, Demande avant, Avancement celui) {
            avancement = celui;
            attendre("lire " + new File(fichier).getName(), numero, () -> lireEtDessiner(fichier, avant, celui));
        }

        @Override
        public void dessiner(int numero, Demande demande, Avancement celui) {
            attendre("dessiner", numero, () -> EssaiSuite.this.dessiner(demande, celui));
        }

        @Override
        public void expliquer(int numero, Inspection inspection, Dessin dessin) {
            attendre("expliquer " + inspection.x + " " + inspection.y, numero, () -> {
                inspection.faire(dessin::seRegardeDeuxFois);
                Recit recit = new Recit(inspection, Nombre::arrondir, Nombre::arrondirComposante);
                return Arrays.asList(suite -> suite.raconter(new Explication.Faite(dessin, inspection, recit.raconter(), null)));
            });
        }

        @Override
        public void mesurer(int numero, Dessin dessin, Map<Reglages, lancer.fenetre.etat.Essai> essais) {
            attendre("mesurer", numero, () -> {
                List<Suite.Evenement> faits = new ArrayList<>();
                for (lancer.fenetre.etat.Essai essai : essais.values()) {
                    lancer.fenetre.etat.Essai fait = essai;
                    for (int k = 0; !fait.suffit(); k++) {
                        fait = new lancer.fenetre.etat.Essai(essai.reglages, fait.durees.avec(1_000_000_000L * (1 + faits.size())), 1, 0.1);
                        lancer.fenetre.etat.Essai celui = fait;
                        faits.add(suite -> suite.compter(celui));
                    }
                }
                faits.add(suite -> suite.finirLaMesure(null));
                return faits;
            });
        }

        @Override
        public void arreter(int numero) {
            journal.add("arreter");
        }

        @Override
        public void ecrire(int numero, SceneLue voulue, SceneLue avant, TexteScene connu) {
            attendre("ecrire", numero, () -> ecriture(() -> EcritureScene.remplacer(voulue, avant, connu), voulue.nom, false));
        }

        @Override
        public void ecrireSous(int numero, TexteScene texte, String fichier) {
            attendre("ecrire sous " + new File(fichier).getName(), numero, () -> ecriture(() -> {
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

    /** Ce que la fenêtre demande, ou copie, est noté par le nom de sa méthode, et le texte qu'elle reçoit. */
    private final Dialogue vue = (Dialogue) Proxy.newProxyInstance(Dialogue.class.getClassLoader(), new Class<?>[] {Dialogue.class},
            (celle, methode, valeurs) -> {
                boolean copier = methode.getName().equals("copier");
                boolean texte = !copier && valeurs != null && valeurs[0] instanceof String;
                journal.add(methode.getName() + (texte ? " " + ((String) valeurs[0]).replace(dossier + File.separator, "") : ""));
                copie = copier ? valeurs[0] : copie;
                return null;
            });

    @BeforeEach
    void ouvrir() {
        boule = fichier("boule.ini", ROUGE);
        options = Options.lire("--taille=32x24", "--fils=1", boule.toString());
        etat = Etat.vide(32, 24, 12);
    }

    private void geste(String nom, Suite.Evenement evenement) {
        arrivees.put(nom, rien -> arrive(evenement));
    }

    private void geste(String nom, BiConsumer<Suite, String> evenement) {
        arrivees.put(nom, valeur -> arrive(suite -> evenement.accept(suite, valeur)));
    }

    private static int[] deux(String nombres) {
        return Arrays.stream(nombres.split(" ")).mapToInt(Integer::parseInt).toArray();
    }

    /** Fait arriver ceci, dans cet ordre : des noms, séparés par des virgules, et leurs valeurs. */
    protected void faire(String gestes) {
        for (String geste : gestes.split(", ")) {
            String nom = geste;
            while (!arrivees.containsKey(nom)) {
                nom = nom.substring(0, nom.lastIndexOf(' '));
            }
            arrivees.get(nom).accept(geste.substring(nom.length()).trim());
        }
    }

    private static <T> T faire(Callable<T> lectureOuEcriture) {
        try {
            return lectureOuEcriture.call();
        } catch (RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    protected Path fichier(String nom, String texte) {
        return faire(() -> Files.writeString(dossier.resolve(nom), texte));
    }

    protected String lu(Path fichier) {
        return faire(() -> Files.readString(fichier));
    }

    /** Les codes de l'image que ces options donnent de cette scène, sans fenêtre. */
    protected int[] sansFenetre(String scene, String... autres) {
        Path png = dossier.resolve("image.png");
        List<String> args = new ArrayList<>(Arrays.asList("--image=" + png));
        args.add("--taille=" + etat.demande.largeur + "x" + etat.demande.hauteur);
        args.addAll(Arrays.asList(autres));
        args.add(fichier("sans-fenetre.ini", scene).toString());
        assertEquals("", Essai.executer(args.toArray(new String[0])).erreur);
        return codes(png);
    }

    protected static int[] codes(Path png) {
        BufferedImage image = faire(() -> ImageIO.read(png.toFile()));
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    /** Ouvre la scène, et achève son image. */
    protected void montrerLaBoule() {
        arrive(suite -> suite.montrerLaPremiere(new Demande(lire(boule.toString()), options)));
        executer();
        journal.clear();
    }

    private SceneLue lire(String fichier) {
        SceneLue lue = LecteurScene.lireEtGarder(fichier, part -> { });
        apresLecture.accept(lue);
        return lue;
    }

    /** Un autre état suit : une vue le montrerait. */
    protected void montrer() {
        // ici, rien ne le montre
    }

    /** Voici ce qui arrive. @return l'état qui suit */
    protected Etat arrive(Suite.Evenement evenement) {
        Suite suite = Suite.apres(etat, evenement);
        Etat avant = etat;
        etat = suite.getEtat();
        if (etat != avant) {
            publies++;
            montrer();
        }
        suite.getOrdres().forEach(ordre -> ordre.executer(moteur, vue));
        return etat;
    }

    /** Cet ordre attend ; son travail se fera quand sa première réponse se demandera. */
    private void attendre(String ordre, int numero, Callable<List<Suite.Evenement>> travail) {
        journal.add(ordre);
        attendus.put(numero, Stream.of(travail).flatMap(celui -> faire(celui).stream()).iterator());
    }

    /** L'ordre de ce numéro donne sa réponse suivante. */
    protected void repondre(int numero) {
        Suite.Evenement reponse = attendus.get(numero).next();
        if (!attendus.get(numero).hasNext()) {
            attendus.remove(numero);
        }
        arrive(Suite.reponse(numero, reponse));
    }

    /** Le travail de chaque ordre qui attend se fait, dans leur ordre, et ceux qu'il en suit. */
    protected void executer() {
        while (!attendus.isEmpty()) {
            repondre(attendus.firstKey());
        }
    }

    private List<Suite.Evenement> lireEtDessiner(String fichier, Demande avant, Avancement celui) {
        String version = Surveillance.version(fichier);
        try {
            SceneLue lue = lire(fichier);
            Demande demande = avant == null ? new Demande(lue, options) : avant.avecLecture(lue);
            List<Suite.Evenement> reponses = new ArrayList<>(Collections.singletonList(suite -> {
                celui.passer("préparation");
                suite.lue(version, demande);
            }));
            reponses.addAll(dessiner(demande, celui));
            return reponses;
        } catch (RuntimeException e) {
            return Arrays.asList(suite -> suite.echouer(version, e));
        }
    }

    private List<Suite.Evenement> dessiner(Demande demande, Avancement celui) {
        List<Dessin> dits = new ArrayList<>();
        new Main(demande, dessin -> {
            dessin.lancer.getAtelier().getFautes().tolerer();
            dits.add(dessin);
        }).doTracerImage(demande.largeur, demande.hauteur);
        Dessin dessin = dits.get(0);
        Essai.exigerLaRecherche(dessin.ecart);
        return Arrays.asList(suite -> {
            celui.passer("brouillon");
            suite.preparer(dessin);
        }, suite -> {
            celui.passer("dessin");
            suite.ebaucher(dessin);
        }, suite -> suite.achever(dessin));
    }

    private static List<Suite.Evenement> ecriture(Callable<TexteScene> ecriture, String fichier, boolean sous) {
        try {
            TexteScene texte = faire(ecriture);
            return Arrays.asList(suite -> suite.ecrit(texte, fichier, sous));
        } catch (RuntimeException e) {
            return Arrays.asList(suite -> suite.refuserDEcrire(e.getMessage()));
        }
    }

    /** L'observation de ce fichier, tel qu'il est. */
    protected void observer(Path celui) {
        arrive(suite -> suite.voirLeFichier(celui.toString(), Surveillance.version(celui.toString())));
    }

    protected String section(String cle) {
        return etat.demande.lue.getSection("Sphere 1").mot(cle, null);
    }
}
