package lancer.fenetre.vue;

import java.awt.event.KeyEvent;
import java.io.File;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JRootPane;
import lancer.commande.Etape;
import lancer.commande.Option;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Onglet;
import lancer.fenetre.etat.Suite;
import lancer.texte.Texte;

/** Les commandes de la fenêtre, dans ses menus ou seulement au clavier. */
final class Commandes implements Vue {

    private static final int SCENES_MAX = 40;

    private final JRootPane racine;
    private final PanneauImage image;
    private final Runnable donnerLeClavier;
    private final Consumer<String> direTouches;
    private final Consumer<Suite.Evenement> recevoir;
    private final List<Commande> toutes = new ArrayList<>();
    private final Predicate<Etat> toujours = etat -> true;
    private final Predicate<Etat> scene = Etat::aUneScene;
    private final Predicate<Etat> pixel = etat -> etat.ecran.onglet == Onglet.PIXEL;
    private Etat etat;

    /**
     * Donne à un cadre ses menus et ses touches.
     *
     * @param donnerLeClavier donne le clavier à l'onglet qui se voit
     * @param direTouches montre ces lignes d'un tableau
     */
    Commandes(JRootPane racine, PanneauImage image, Runnable donnerLeClavier, Consumer<String> direTouches,
            Consumer<Suite.Evenement> recevoir) {
        this.racine = racine;
        this.image = image;
        this.donnerLeClavier = donnerLeClavier;
        this.direTouches = direTouches;
        this.recevoir = recevoir;
        JMenuBar barre = new JMenuBar();
        barre.add(fichier());
        barre.add(affichage());
        barre.add(dessin());
        barre.add(scenes());
        JMenu aide = barre.add(menu("Aide", commande("Touches", "F1", toujours, this::direTouches)));
        // A est la lettre d'Affichage
        aide.setMnemonic(KeyEvent.VK_I);
        racine.setJMenuBar(barre);
        auClavier();
    }

    @Override
    public void montrer(Etat nouveau) {
        etat = nouveau;
        toutes.forEach(commande -> commande.montrer(nouveau));
    }

    private Commande ajouter(Commande nouvelle) {
        toutes.add(nouvelle);
        return nouvelle;
    }

    private Commande commande(String nom, String touches, Predicate<Etat> possible, Runnable effet) {
        return ajouter(new Commande(nom, touches, possible, null, effet));
    }

    private Commande evenement(String nom, String touches, Predicate<Etat> possible, Suite.Evenement effet) {
        return commande(nom, touches, possible, () -> recevoir.accept(effet));
    }

    private Commande cochee(String nom, String touches, Predicate<Etat> possible, Predicate<Etat> cochee,
            Suite.Evenement effet) {
        return ajouter(new Commande(nom, touches, possible, cochee, () -> recevoir.accept(effet)));
    }

    /** Ouvre un onglet, et lui donne le clavier. */
    private Commande onglet(String nom, String touche, Suite.Evenement ouverture) {
        return commande(nom, touche, scene, () -> {
            recevoir.accept(ouverture);
            donnerLeClavier.run();
        });
    }

    private JMenu fichier() {
        return menu("Fichier",
                evenement("Ouvrir une scène…", "ctrl O", toujours, Suite::choisirUneScene),
                evenement("Relire la scène et redessiner", "F5", e -> e.getFichier() != null, Suite::relire),
                evenement("Écrire dans la scène", "ctrl E", Etat::estDeplace, Suite::ecrire),
                evenement("Écrire la scène sous…", "", scene, Suite::demanderOuEcrire),
                evenement("Enregistrer l'image…", "ctrl S", scene, Suite::enregistrer),
                evenement("Copier l'image", "ctrl C", scene, Suite::copierLImage),
                evenement("Copier les réglages", "ctrl shift C", scene, Suite::copierLesReglages),
                evenement("Copier le récit du pixel", "ctrl T", pixel, Suite::copierLeRecit),
                evenement("Quitter", "ctrl Q", toujours, Suite::quitter));
    }

    private JMenu affichage() {
        // le même signe est sur plusieurs touches, avec ou sans Maj selon le clavier
        JMenu menu = menu("Affichage",
                onglet("Réglages", "F2", suite -> suite.montrer(Onglet.REGLAGES)),
                onglet("Vitesse ou précision", "F3", Suite::mesurer),
                cochee("Remplir la fenêtre", "ctrl R", toujours, e -> e.ecran.remplie, Suite::remplir),
                evenement("Loupe, plus près", "ctrl UP", scene, suite -> suite.approcher(true)),
                evenement("Loupe, plus loin", "ctrl DOWN", scene, suite -> suite.approcher(false)),
                // sur un clavier suisse, + est Maj+1
                partout(evenement("Textes plus grands", "ctrl PLUS, ctrl ADD, ctrl shift PLUS, ctrl EQUALS, "
                        + "ctrl shift EQUALS, ctrl shift 1", toujours, suite -> suite.agrandir(1))),
                partout(evenement("Textes plus petits", "ctrl MINUS, ctrl SUBTRACT, ctrl shift MINUS", toujours,
                        suite -> suite.agrandir(-1))),
                partout(evenement("Textes à leur taille", "ctrl 0, ctrl NUMPAD0, ctrl shift 0, ctrl AGRAVE, "
                        + "ctrl shift AGRAVE", toujours, suite -> suite.prendreLaPolice(Apparence.getOrdinaire()))));
        menu.addSeparator();
        Stream.concat(Stream.of("image"), Option.VUES.stream()).forEach(nom -> {
            String vue = nom.equals("image") ? null : nom;
            menu.add(cochee("Vue : " + nom, "", scene, e -> e.aUneScene() && Objects.equals(vue, e.demande.vue),
                    suite -> suite.voir(vue)).article());
        });
        return menu;
    }

    private JMenu dessin() {
        return menu("Dessin",
                evenement("Arrêter le dessin, sinon fermer le panneau", "ESCAPE", Etat::peutEchapper, Suite::echapper),
                evenement("Défaire le changement", "ctrl Z", Etat::peutDefaire, Suite::defaire));
    }

    /** Les commandes sans article : celles de l'image demandent qu'elle ait le clavier. */
    private void auClavier() {
        for (Etape etape : Etape.values()) {
            partout(evenement("Étape du cours : Lambert, Phong, ombres, reflets", "F" + (6 + etape.ordinal()), scene,
                    suite -> suite.choisirLEtape(etape)));
        }
        partout(evenement("Plus de réflexions : 1, 2, 5, 10", "typed +", e -> Suite.peutReflechir(e, true),
                suite -> suite.reflechir(true)));
        partout(evenement("Moins de réflexions", "typed -", e -> Suite.peutReflechir(e, false),
                suite -> suite.reflechir(false)));
        surLImage(commande("Les rayons du pixel sous la souris, ou au milieu", "ENTER", scene, image::expliquer));
        surLImage(evenement("Tout le détail du pixel, ou l'essentiel", "D", pixel, Suite::deplier));
        surLImage(evenement("Tenue, l'image d'avant", "SPACE", e -> e.montre.avant != null,
                suite -> suite.tenir(true)));
        surLImage(evenement(null, "released SPACE", toujours, suite -> suite.tenir(false)));
        // Maj, qui tire, peut être tenue
        partout(evenement(null, "shift ESCAPE", Etat::peutEchapper, Suite::echapper));
        for (int pas : new int[] {1, 10}) {
            String avec = pas == 1 ? "" : "shift ";
            surLImage(evenement(null, avec + "LEFT", pixel, suite -> suite.aller(-pas, 0)));
            surLImage(evenement(null, avec + "RIGHT", pixel, suite -> suite.aller(pas, 0)));
            surLImage(evenement(null, avec + "UP", pixel, suite -> suite.aller(0, -pas)));
            surLImage(evenement(null, avec + "DOWN", pixel, suite -> suite.aller(0, pas)));
        }
    }

    private Commande partout(Commande commande) {
        return commande.lier(racine, JComponent.WHEN_IN_FOCUSED_WINDOW);
    }

    private void surLImage(Commande commande) {
        commande.lier(image, JComponent.WHEN_FOCUSED);
    }

    private void direTouches() {
        Map<String, String> touches = new LinkedHashMap<>();
        toutes.stream().filter(commande -> commande.getNom() != null && commande.getTouche() != null)
                .forEach(commande -> touches.merge(commande.getNom(), commande.direTouche(),
                        (une, autre) -> une + ", " + autre));
        touches.put("Le pixel voisin ou, avec Maj, dix pixels plus loin", "Flèches");
        touches.put("Tirer une sphère, ou l'étoile d'une lampe ; d'un clic, montrer ses nombres", "Maj, souris");
        touches.put("Dans un nombre de l'onglet Pixel, un pas de plus ou de moins ; dix avec Maj", "Haut, Bas");
        touches.put("Oublie aussi ce qui a été changé sans être écrit", "F5");
        touches.put("Dans Vitesse, un réglage, puis son image", "Flèches, Entrée");
        direTouches.accept(touches.entrySet().stream()
                .map(e -> "<tr><td>" + e.getValue() + "&nbsp;<td>" + e.getKey()).collect(Collectors.joining()));
    }

    private JMenu menu(String nom, Commande... siennes) {
        JMenu menu = new JMenu(nom);
        menu.setMnemonic(nom.charAt(0));
        Arrays.stream(siennes).forEach(commande -> menu.add(commande.article()));
        return menu;
    }

    /** Les scènes du dossier de celle qui est demandée, lues quand le menu s'ouvre. */
    private JMenu scenes() {
        JMenu menu = menu("Scènes");
        menu.addChangeListener(e -> {
            if (menu.isSelected()) {
                menu.removeAll();
                String ouverte = etat.getFichier();
                File dossier = Dialogues.dossierDesScenes(ouverte);
                String[] scenes = dossier.list((ici, nom) -> Texte.minuscules(nom).endsWith(".ini"));
                Arrays.stream(scenes == null ? new String[0] : scenes).sorted().limit(SCENES_MAX).forEach(nom -> {
                    Commande celle = new Commande(Texte.echappe(nom), "", toujours,
                            present -> ouverte != null && nom.equals(new File(ouverte).getName()),
                            () -> recevoir.accept(suite -> suite.ouvrir(new File(dossier, nom).getPath())));
                    celle.montrer(etat);
                    menu.add(celle.article());
                });
            }
        });
        return menu;
    }
}
