package lancer.fenetre;

import java.awt.event.KeyEvent;
import java.io.File;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Objects;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import lancer.commande.Etape;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.texte.Texte;

/** Les commandes de la fenêtre, dans ses menus ou seulement au clavier. Aucune touche n'est un chiffre. */
final class Commandes {

    private static final NavigableSet<Integer> REFLEXIONS = new TreeSet<>(Arrays.asList(0, 1, 2, 5, 10));
    private static final int SCENES_MAX = 40;

    private final Fenetre f;
    private final Controleur c;
    private final List<Commande> toutes = new ArrayList<>();
    private final BooleanSupplier toujours = () -> true;
    private final BooleanSupplier scene;
    private final BooleanSupplier pixel;

    /** Donne à cette fenêtre ses menus et ses touches. */
    Commandes(Fenetre fenetre) {
        f = fenetre;
        c = fenetre.controleur;
        scene = () -> c.getEtat().demande != null;
        pixel = () -> f.pixel() != null;
        JMenuBar barre = new JMenuBar();
        barre.add(fichier());
        barre.add(affichage());
        barre.add(dessin());
        barre.add(scenes());
        JMenu aide = barre.add(menu("Aide", commande("Touches", "F1", toujours, this::direTouches)));
        // A est la lettre d'Affichage
        aide.setMnemonic(KeyEvent.VK_I);
        f.cadre.setJMenuBar(barre);
        auClavier();
        c.prevenir(etat -> toutes.forEach(Commande::ajuster));
    }

    private Commande commande(String nom, String touche, BooleanSupplier possible, Runnable effet) {
        Commande nouvelle = new Commande(nom, touche, possible, effet);
        toutes.add(nouvelle);
        return nouvelle;
    }

    private JMenu fichier() {
        return menu("Fichier",
                commande("Ouvrir une scène…", "ctrl O", toujours, f::choisirScene),
                commande("Relire la scène et redessiner", "F5", () -> c.getEtat().source.fichier != null,
                        () -> f.enregistrement.apres(c::relire)),
                commande("Écrire dans la scène", "ctrl E", () -> c.getEtat().estDeplace(),
                        () -> f.enregistrement.ecrireLaScene(() -> { })),
                commande("Enregistrer l'image…", "ctrl S", scene, f.enregistrement::enregistrer),
                commande("Copier l'image", "ctrl C", scene, f.enregistrement::copier),
                commande("Copier les réglages", "ctrl shift C", scene, f.enregistrement::copierReglages),
                commande("Copier le récit du pixel", "ctrl T", pixel, () -> f.pixel().copier()),
                commande("Quitter", "ctrl Q", toujours, f::quitter));
    }

    private JMenu affichage() {
        JMenu menu = menu("Affichage",
                commande("Réglages", "F2", scene, () -> f.onglets.montrer(Onglets.REGLAGES).transferFocus()),
                commande("Vitesse ou précision", "F3", scene, f::mesurer),
                commande("Remplir la fenêtre", "ctrl R", toujours, f::remplir).cochee(() -> f.remplie),
                commande("Loupe, plus près", "ctrl UP", scene, () -> f.panneau.approcher(true)),
                commande("Loupe, plus loin", "ctrl DOWN", scene, () -> f.panneau.approcher(false)));
        menu.addSeparator();
        Stream.concat(Stream.of("image"), Option.VUES.stream()).forEach(nom -> {
            String vue = nom.equals("image") ? null : nom;
            menu.add(commande("Vue : " + nom, null, scene, () -> c.voir(vue))
                    .cochee(() -> scene.getAsBoolean() && Objects.equals(vue, c.getEtat().demande.vue)).article());
        });
        return menu;
    }

    private JMenu dessin() {
        return menu("Dessin",
                commande("Arrêter le dessin, sinon fermer le panneau", "ESCAPE", f::peutEchapper, f::echapper),
                commande("Défaire le déplacement", "ctrl Z", f.prise::peutDefaire, f.prise::defaire));
    }

    /** Les commandes sans article : celles de l'image demandent qu'elle ait le clavier. */
    private void auClavier() {
        JComponent cadre = f.cadre.getRootPane();
        for (Etape etape : Etape.values()) {
            commande("Étape du cours : Lambert, Phong, ombres, reflets", "F" + (6 + etape.ordinal()), scene,
                    () -> c.regler(reglages().avec(Option.ETAPE, etape))).lier(cadre,
                            JComponent.WHEN_IN_FOCUSED_WINDOW);
        }
        reflexions("Plus de réflexions : 1, 2, 5, 10", '+', REFLEXIONS::higher);
        reflexions("Moins de réflexions", '-', REFLEXIONS::lower);
        surLImage("Les rayons du pixel sous la souris, ou au milieu", "ENTER", scene, f::inspecter);
        surLImage("Tout le détail du pixel, ou l'essentiel", "typed d", pixel, () -> f.pixel().deplier());
        surLImage("Tenue, l'image d'avant", "SPACE", () -> c.getEtat().montre.avant != null, () -> f.tenir(true));
        surLImage(null, "released SPACE", toujours, () -> f.tenir(false));
        for (int pas : new int[] {1, 10}) {
            String nom = pas == 1 ? "Le pixel voisin" : "Dix pixels plus loin";
            String avec = pas == 1 ? "" : "shift ";
            surLImage(nom, avec + "LEFT", pixel, () -> f.pixel().aller(-pas, 0));
            surLImage(nom, avec + "RIGHT", pixel, () -> f.pixel().aller(pas, 0));
            surLImage(nom, avec + "UP", pixel, () -> f.pixel().aller(0, -pas));
            surLImage(nom, avec + "DOWN", pixel, () -> f.pixel().aller(0, pas));
        }
    }

    private Reglages reglages() {
        return c.getEtat().demande.reglages;
    }

    /** Cette touche, frappée avec ou sans Maj : les claviers diffèrent. */
    private void reflexions(String nom, char touche, UnaryOperator<Integer> autre) {
        // une étape sans reflets n'a pas de réflexions à compter
        BooleanSupplier possible = () -> scene.getAsBoolean() && reglages().get(Option.ETAPE) == Etape.REFLETS
                && autre.apply(reglages().get(Option.REFLETS)) != null;
        for (String avec : new String[] {"", "shift "}) {
            commande(nom, avec + "typed " + touche, possible,
                    () -> c.regler(reglages().avec(Option.REFLETS, autre.apply(reglages().get(Option.REFLETS)))))
                    .lier(f.cadre.getRootPane(), JComponent.WHEN_IN_FOCUSED_WINDOW);
        }
    }

    private void surLImage(String nom, String touche, BooleanSupplier possible, Runnable effet) {
        commande(nom, touche, possible, effet).lier(f.panneau, JComponent.WHEN_FOCUSED);
    }

    private void direTouches() {
        Map<String, String> touches = new LinkedHashMap<>();
        toutes.stream().filter(commande -> commande.getNom() != null && commande.getTouche() != null)
                .forEach(commande -> touches.merge(commande.getNom(), commande.direTouche(),
                        (une, autre) -> une.equals(autre) ? une : une + ", " + autre));
        touches.put("Tirer une sphère, ou l'étoile d'une lampe", "Maj et la souris");
        touches.put("Oublie aussi ce qui a été tiré sans être écrit", "F5");
        touches.put("Dans Vitesse, un réglage, puis son image", "Gauche, Droite, Entrée");
        Dialogues.direTouches(f.cadre, touches.entrySet().stream()
                .map(e -> "<tr><td>" + e.getValue() + "&nbsp;<td>" + e.getKey()).collect(Collectors.joining()));
    }

    private JMenu menu(String nom, Commande... siennes) {
        JMenu menu = new JMenu(nom);
        menu.addChangeListener(e -> toutes.forEach(Commande::ajuster));
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
                String ouverte = c.getEtat().source.fichier;
                File dossier = Dialogues.dossierDesScenes(ouverte);
                String[] scenes = dossier.list((ici, nom) -> Texte.minuscules(nom).endsWith(".ini"));
                Arrays.stream(scenes == null ? new String[0] : scenes).sorted().limit(SCENES_MAX).forEach(nom ->
                        menu.add(new Commande(Texte.echappe(nom), null, toujours,
                                () -> f.ouvrir(new File(dossier, nom).getPath()))
                                .cochee(() -> ouverte != null && nom.equals(new File(ouverte).getName())).article()));
            }
        });
        return menu;
    }
}
