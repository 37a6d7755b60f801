package lancer.fenetre.vue;

import java.awt.event.InputEvent;
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
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.KeyStroke;
import lancer.commande.Etape;
import lancer.commande.Option;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Onglet;
import lancer.fenetre.etat.Suite;
import lancer.inspection.Recit;
import lancer.texte.Texte;

/** Les commandes de la fenêtre, dans ses menus ou seulement au clavier. */
final class Commandes implements Vue {

    private static final int SCENES_MAX = 40;

    private final JFrame cadre;
    private final Runnable choisirScene;
    private final Consumer<Onglet> donnerLeClavier;
    private final PanneauImage image;
    private final Consumer<Suite.Evenement> recevoir;
    private final List<Commande> toutes = new ArrayList<>();
    private final Predicate<Etat> toujours = etat -> true;
    private final Predicate<Etat> scene = Etat::aUneScene;
    private final Predicate<Etat> pixel = etat -> etat.ecran.onglet == Onglet.PIXEL;
    private Etat etat;

    /**
     * Donne à ce cadre ses menus et ses touches.
     *
     * @param choisirScene demande quelle scène ouvrir
     * @param donnerLeClavier donne le clavier à un onglet
     */
    Commandes(JFrame cadre, PanneauImage image, Runnable choisirScene, Consumer<Onglet> donnerLeClavier,
            Consumer<Suite.Evenement> recevoir) {
        this.cadre = cadre;
        this.choisirScene = choisirScene;
        this.donnerLeClavier = donnerLeClavier;
        this.image = image;
        this.recevoir = recevoir;
        JMenuBar barre = new JMenuBar();
        barre.add(fichier());
        barre.add(affichage());
        barre.add(dessin());
        barre.add(scenes());
        JMenu aide = barre.add(menu("Aide", commande("Touches", "F1", toujours, this::direTouches)));
        // A est la lettre d'Affichage
        aide.setMnemonic(KeyEvent.VK_I);
        cadre.setJMenuBar(barre);
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

    private Commande commande(String nom, String touche, Predicate<Etat> possible, Runnable effet) {
        return ajouter(new Commande(nom, touche, possible, null, effet));
    }

    private Commande evenement(String nom, String touche, Predicate<Etat> possible, Suite.Evenement effet) {
        return commande(nom, touche, possible, () -> recevoir.accept(effet));
    }

    private Commande cochee(String nom, String touche, Predicate<Etat> possible, Predicate<Etat> cochee,
            Suite.Evenement effet) {
        return ajouter(new Commande(nom, touche, possible, cochee, () -> recevoir.accept(effet)));
    }

    private JMenu fichier() {
        return menu("Fichier",
                commande("Ouvrir une scène…", "ctrl O", toujours, choisirScene),
                evenement("Relire la scène et redessiner", "F5", e -> e.getFichier() != null, Suite::relire),
                evenement("Écrire dans la scène", "ctrl E", Etat::estDeplace, Suite::ecrire),
                evenement("Écrire la scène sous…", null, scene, Suite::demanderOuEcrire),
                evenement("Enregistrer l'image…", "ctrl S", scene, Suite::enregistrer),
                evenement("Copier l'image", "ctrl C", scene, Suite::copierLImage),
                evenement("Copier les réglages", "ctrl shift C", scene, Suite::copierLesReglages),
                commande("Copier le récit du pixel", "ctrl T", pixel, this::copierLeRecit),
                evenement("Quitter", "ctrl Q", toujours, Suite::quitter));
    }

    private JMenu affichage() {
        Commande ordinaires = evenement("Textes à leur taille", "ctrl 0", toujours,
                suite -> suite.prendreLaPolice(Apparence.getOrdinaire()));
        lierAussi("NUMPAD0", ordinaires);
        // sur un clavier français, la touche à/0, avec ou sans Maj
        int sansZero = KeyEvent.getExtendedKeyCodeForChar('à');
        for (int code : new int[] {KeyEvent.VK_0, sansZero}) {
            for (int maj : new int[] {0, InputEvent.SHIFT_DOWN_MASK}) {
                lierAussi(KeyStroke.getKeyStroke(code, ordinaires.getTouche().getModifiers() | maj), ordinaires);
            }
        }
        Commande grands = evenement("Textes plus grands", "ctrl PLUS", toujours, suite -> suite.agrandir(1));
        Commande petits = evenement("Textes plus petits", "ctrl MINUS", toujours, suite -> suite.agrandir(-1));
        // le même signe est sur plusieurs touches, avec ou sans Maj selon le clavier
        Stream.of("ADD", "shift PLUS", "EQUALS", "shift EQUALS").forEach(touche -> lierAussi(touche, grands));
        Stream.of("SUBTRACT", "shift MINUS").forEach(touche -> lierAussi(touche, petits));
        JMenu menu = menu("Affichage",
                commande("Réglages", "F2", scene, () -> {
                    recevoir.accept(suite -> suite.montrer(Onglet.REGLAGES));
                    donnerLeClavier.accept(Onglet.REGLAGES);
                }),
                commande("Vitesse ou précision", "F3", scene, () -> {
                    recevoir.accept(Suite::mesurer);
                    donnerLeClavier.accept(Onglet.VITESSE);
                }),
                cochee("Remplir la fenêtre", "ctrl R", toujours, e -> e.ecran.remplie, Suite::remplir),
                evenement("Loupe, plus près", "ctrl UP", scene, suite -> suite.approcher(true)),
                evenement("Loupe, plus loin", "ctrl DOWN", scene, suite -> suite.approcher(false)),
                grands, petits,
                ordinaires);
        menu.addSeparator();
        Stream.concat(Stream.of("image"), Option.VUES.stream()).forEach(nom -> {
            String vue = nom.equals("image") ? null : nom;
            menu.add(cochee("Vue : " + nom, null, scene, e -> e.aUneScene() && Objects.equals(vue, e.demande.vue),
                    suite -> suite.voir(vue)).article());
        });
        return menu;
    }

    private JMenu dessin() {
        Commande echapper = evenement("Arrêter le dessin, sinon fermer le panneau", "ESCAPE", Etat::peutEchapper,
                Suite::echapper);
        // ce qui est tiré l'est avec Maj
        lierAussi(KeyStroke.getKeyStroke("shift ESCAPE"), echapper);
        return menu("Dessin", echapper,
                evenement("Défaire le changement", "ctrl Z", Etat::peutDefaire, Suite::defaire));
    }

    /** Les commandes sans article : celles de l'image demandent qu'elle ait le clavier. */
    private void auClavier() {
        for (Etape etape : Etape.values()) {
            partout(evenement("Étape du cours : Lambert, Phong, ombres, reflets", "F" + (6 + etape.ordinal()), scene,
                    suite -> suite.choisirLEtape(etape)));
        }
        reflexions("Plus de réflexions : 1, 2, 5, 10", "+", true);
        reflexions("Moins de réflexions", "-", false);
        surLImage(commande("Les rayons du pixel sous la souris, ou au milieu", "ENTER", scene, image::expliquer));
        surLImage(evenement("Tout le détail du pixel, ou l'essentiel", "D", pixel, Suite::deplier));
        surLImage(evenement("Tenue, l'image d'avant", "SPACE", e -> e.montre.avant != null,
                suite -> suite.tenir(true)));
        surLImage(evenement(null, "released SPACE", toujours, suite -> suite.tenir(false)));
        for (int pas : new int[] {1, 10}) {
            String avec = pas == 1 ? "" : "shift ";
            surLImage(evenement(null, avec + "LEFT", pixel, suite -> suite.aller(-pas, 0)));
            surLImage(evenement(null, avec + "RIGHT", pixel, suite -> suite.aller(pas, 0)));
            surLImage(evenement(null, avec + "UP", pixel, suite -> suite.aller(0, -pas)));
            surLImage(evenement(null, avec + "DOWN", pixel, suite -> suite.aller(0, pas)));
        }
    }

    /** Cette touche, avec Ctrl, fait aussi cette commande. */
    private void lierAussi(String touche, Commande commande) {
        lierAussi(new Commande(null, "ctrl " + touche, toujours, null, () -> { }).getTouche(), commande);
    }

    private void lierAussi(KeyStroke touche, Commande commande) {
        cadre.getRootPane().getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(touche, commande);
        cadre.getRootPane().getActionMap().put(commande, commande);
    }

    private void partout(Commande commande) {
        commande.lier(cadre.getRootPane(), JComponent.WHEN_IN_FOCUSED_WINDOW);
    }

    private void surLImage(Commande commande) {
        commande.lier(image, JComponent.WHEN_FOCUSED);
    }

    /** Ce signe, frappé avec ou sans Maj : les claviers diffèrent. */
    private void reflexions(String nom, String signe, boolean plus) {
        for (String avec : new String[] {"", "shift "}) {
            partout(evenement(nom, avec + "typed " + signe, e -> Suite.peutReflechir(e, plus),
                    suite -> suite.reflechir(plus)));
        }
    }

    /** Copie le récit, tous les chiffres écrits. */
    private void copierLeRecit() {
        if (etat.explication.faite != null && etat.explication.faite.inspection != null) {
            List<String> lignes = new Recit(etat.explication.faite.inspection, Double::toString, Double::toString)
                    .raconter().lignes();
            recevoir.accept(suite -> suite.copierLeRecit(lignes));
        }
    }

    private void direTouches() {
        Map<String, String> touches = new LinkedHashMap<>();
        toutes.stream().filter(commande -> commande.getNom() != null && commande.getTouche() != null)
                .forEach(commande -> touches.merge(commande.getNom(), commande.direTouche(),
                        (une, autre) -> une.equals(autre) ? une : une + ", " + autre));
        touches.put("Le pixel voisin ou, avec Maj, dix pixels plus loin", "Flèches");
        touches.put("Tirer une sphère, ou l'étoile d'une lampe ; d'un clic, montrer ses nombres", "Maj, souris");
        touches.put("Dans un nombre de l'onglet Pixel, un pas de plus ou de moins ; dix avec Maj", "Haut, Bas");
        touches.put("Oublie aussi ce qui a été changé sans être écrit", "F5");
        touches.put("Dans Vitesse, un réglage, puis son image", "Flèches, Entrée");
        Dialogues.direTouches(cadre, touches.entrySet().stream()
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
                    Commande celle = new Commande(Texte.echappe(nom), null, toujours,
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
