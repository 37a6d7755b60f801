package lancer.fenetre;

import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import lancer.commande.Etape;
import lancer.commande.Options;
import lancer.contrat.Variante;
import lancer.dessin.ReglagesDessin;

/** Les lignes de la table des actions, menu par menu, puis celles qui n'ont pas d'article. */
final class Menus {

    private static final int[] REFLEXIONS = {0, 1, 2, 5, 10};
    private static final String[] FLECHES = {"LEFT", "RIGHT", "UP", "DOWN"};
    private static final int[][] SENS = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    private static final int SAUT = 10;

    private final Actions actions = new Actions();
    private final JMenuBar barre = new JMenuBar();
    private final Fenetre f;
    private final Controleur c;
    private final BooleanSupplier toujours = () -> true;
    private final BooleanSupplier scene;
    private final BooleanSupplier pixel;
    /** Le tableau de F1, créé à la première demande. */
    private JDialog touches;

    /** Donne à cette fenêtre ses menus et ses touches. */
    Menus(Fenetre fenetre, List<String> variantes) {
        f = fenetre;
        c = fenetre.controleur;
        scene = () -> reglages() != null;
        pixel = () -> f.pixel() != null;
        // ces lignes passent avant celles des menus qui ont la même touche
        actions.ligne(null, "depuis le récit, le copier", () -> pixel.getAsBoolean() && f.pixel().aLeClavier(),
                () -> f.pixel().copier(), "menu C");
        actions.ligne(null, "faire défiler ce tableau", this::estTableauLong,
                rang -> Actions.defiler(Dialogues.ascenseur(touches), rang), "PAGE_UP", "PAGE_DOWN");
        actions.ligne(null, "faire défiler le récit du pixel", pixel, rang -> f.pixel().defiler(rang), "PAGE_UP",
                "PAGE_DOWN");
        barre.add(fichier(f.enregistrement));
        barre.add(affichage());
        barre.add(dessin(f.enregistrement, variantes));
        MenuScenes scenes = new MenuScenes(c);
        barre.add(scenes.remplir(actions.menu("Scènes",
                actions.ligne("Scène suivante", "la scène suivante du dossier", () -> scenes.existe(1),
                        () -> scenes.ouvrir(1), "PAGE_DOWN"),
                actions.ligne("Scène précédente", "la scène précédente", () -> scenes.existe(-1),
                        () -> scenes.ouvrir(-1), "PAGE_UP"))));
        sansArticle(f.prise);
        JMenu aide = barre.add(actions.menu("Aide", actions.ligne("Touches", "ce tableau, qui reste ouvert", toujours,
                this::montrerTouches, "F1")));
        // A est la lettre d'Affichage
        aide.setMnemonic(KeyEvent.VK_I);
        actions.montrer();
        c.prevenir(actions::montrer);
        f.cadre.setJMenuBar(barre);
        actions.lier((JComponent) f.cadre.getContentPane());
    }

    private void montrerTouches() {
        touches = touches == null ? Dialogues.touches(f.cadre, actions.dire()) : touches;
        touches.setVisible(true);
    }

    private boolean estTableauVisible() {
        return touches != null && touches.isVisible();
    }

    private boolean estTableauLong() {
        return estTableauVisible() && Dialogues.ascenseur(touches).getVerticalScrollBar().isVisible();
    }

    private JMenu fichier(Enregistrement enregistrement) {
        return actions.menu("Fichier",
                actions.ligne("Ouvrir une scène…", "ouvrir une scène ; ou déposer son fichier sur la fenêtre", toujours,
                        f::choisirScene, "menu O"),
                actions.ligne("Enregistrer l'image…", "enregistrer l'image", scene, enregistrement::enregistrer,
                        "menu S"),
                actions.ligne("Copier l'image", "copier l'image", scene, enregistrement::copier, "menu C"),
                f.panneau.bandeau.copie,
                null,
                actions.ligne("Quitter", "quitter", toujours, f::fermer, "menu Q"));
    }

    private JMenu affichage() {
        String taille = f.demandee.width + " × " + f.demandee.height;
        String[] vues = Stream.concat(Stream.of("l'image"), Options.VUES.stream()).toArray(String[]::new);
        return actions.menu("Affichage",
                actions.ligne("Taille demandée, " + taille, "l'image à la taille demandée", toujours,
                        () -> f.remplir(false), "menu 1").coche(rang -> !f.remplie),
                actions.ligne("Remplir la fenêtre", "l'image dans toute la fenêtre", toujours, () -> f.remplir(true),
                        "menu 0").coche(rang -> f.remplie),
                actions.ligne("Plein écran", "plein écran", toujours, f::basculer, "F11")
                        .coche(rang -> f.estEnPleinEcran()),
                null,
                actions.ligne("Loupe : plus près", "loupe, comme la molette ; la tirer la déplace", toujours,
                        () -> f.panneau.approcher(true), "menu UP"),
                actions.ligne("Loupe : plus loin", "loupe, plus loin", toujours, () -> f.panneau.approcher(false),
                        "menu DOWN"),
                null,
                actions.ligne("Vue", null, scene, rang -> c.voir(rang == 0 ? null : vues[rang])).choix(vues)
                        .coche(rang -> c.etat.choix != null
                                && vues[rang].equals(c.etat.choix.vue == null ? vues[0] : c.etat.choix.vue)),
                actions.ligne("Rayons d'un pixel", "onglet Pixel : les rayons du pixel, comme un clic", scene,
                        f::inspecter, "ENTER"),
                actions.ligne("Réglages", "onglet Réglages : étape, réflexions, variantes", scene,
                        () -> f.onglets.montrer(1).transferFocus(), "F2"),
                actions.ligne("Vitesse ou précision", "onglet Vitesse : ce que coûte chaque réglage", scene,
                        () -> f.onglets.montrer(2).transferFocus(), "F3"),
                actions.ligne("Objets et lampes", "onglet Scène : objets, lampes et leurs valeurs", scene,
                        () -> f.onglets.montrer(3).transferFocus(), "F4"),
                null,
                actions.ligne("Apparence sombre", null, toujours, () -> Apparence.changer(!Apparence.estSombre()))
                        .coche(rang -> Apparence.estSombre()));
    }

    private JMenu dessin(Enregistrement enregistrement, List<String> variantes) {
        List<Object> contenu = new ArrayList<>(Arrays.asList(
                actions.ligne("Relire la scène et redessiner", "relire la scène et redessiner ; l'enregistrer dans un "
                        + "éditeur le fait aussi", () -> c.etat.demande != null, c::relire, "F5"),
                actions.ligne("Arrêter", "arrêter le dessin", () -> c.etat.enCours, c::arreter, "ESCAPE"),
                null,
                actions.ligne("Plus de réflexions", "plus de réflexions : 1, 2, 5, 10", () -> autre(true) != null,
                        () -> reflechir(true), "+"),
                actions.ligne("Moins de réflexions", "moins de réflexions", () -> autre(false) != null,
                        () -> reflechir(false), "-"),
                actions.ligne("Étapes du cours", "étapes du cours : Lambert, Phong, ombres, reflets", scene,
                        rang -> c.dessiner(reglages().avec(Etape.values()[rang]), false),
                        "ctrl alt 1", "ctrl alt 2", "ctrl alt 3", "ctrl alt 4")
                        .choix("Lambert", "+ Phong", "+ ombres", "+ reflets")
                        .coche(rang -> reglages() != null && reglages().getEtape().ordinal() == rang)));
        variantes.forEach(nom -> contenu.add(actions.ligne(nom, null, scene, () -> brancher(nom))
                .coche(rang -> reglages() != null && reglages().estBranchee(reglages().getVariante(nom)))));
        contenu.addAll(Arrays.asList(
                null,
                actions.ligne("Revenir à la scène et aux réglages du fichier", null, scene, c::revenir),
                actions.ligne("Défaire", "défaire un déplacement, un réglage, une vue", () -> c.etat.peutRevenir(false),
                        () -> c.defaire(false), "menu Z"),
                actions.ligne("Refaire", "refaire ce qui est défait", () -> c.etat.peutRevenir(true),
                        () -> c.defaire(true), "menu shift Z"),
                actions.ligne("Copier ces réglages", "copier les réglages et ce qui est déplacé", scene,
                        enregistrement::copierReglages, "menu shift C")));
        return actions.menu("Dessin", contenu.toArray());
    }

    private ReglagesDessin reglages() {
        return c.etat.getReglages();
    }

    private void brancher(String nom) {
        Variante variante = reglages().getVariante(nom);
        c.dessiner(reglages().avec(variante, !reglages().estBranchee(variante)), false);
    }

    private Integer autre(boolean plus) {
        int actuel = reglages() == null ? 0 : reglages().getReflets();
        Stream<Integer> autres = IntStream.of(REFLEXIONS).filter(n -> plus ? n > actuel : n < actuel).boxed();
        return reglages() == null ? null : (plus ? autres.findFirst() : autres.reduce((a, b) -> b)).orElse(null);
    }

    private void reflechir(boolean plus) {
        c.dessiner(reglages().avec(autre(plus), reglages().getSeuil()), false);
    }

    private void sansArticle(Prise prise) {
        actions.ligne(null, "lâcher ce qui est pris", prise::estPris, prise::lacher, "ESCAPE");
        actions.ligne(null, "fermer ce tableau", this::estTableauVisible, () -> touches.setVisible(false), "ESCAPE");
        actions.ligne(null, "fermer le panneau", f.onglets::estOuvert, f.onglets::fermer, "ESCAPE");
        actions.ligne(null, "quitter le plein écran", f::estEnPleinEcran, f::basculer, "ESCAPE");
        actions.ligne(null, "tenue, l'image d'avant", () -> c.etat.avant != null, () -> f.tenir(true), "SPACE");
        actions.ligne(null, null, toujours, () -> f.tenir(false), "released SPACE");
        actions.souris("Maj et la souris", "prendre un objet ou une lampe (son étoile) et le déplacer");
        actions.souris("Maj et la molette", "éloigner ou approcher ce qui est pris");
        actions.ligne(null, "pousser d'un pixel ce qui est pris", prise::estMobile,
                rang -> prise.pousser(SENS[rang][0], SENS[rang][1]), avec("shift "));
        actions.ligne(null, "le pixel voisin", pixel, rang -> f.pixel().aller(SENS[rang][0], SENS[rang][1]), FLECHES);
        actions.ligne(null, "dix pixels plus loin", pixel,
                rang -> f.pixel().aller(SAUT * SENS[rang][0], SAUT * SENS[rang][1]), avec("shift "));
        actions.ligne(null, "un autre échantillon du pixel", pixel, rang -> f.pixel().echantillonner(2 * rang - 1),
                "menu PAGE_UP", "menu PAGE_DOWN");
        actions.ligne(null, "un rebond seul dans les figures, 0 pour tous ; ou un clic sur son numéro", pixel,
                rang -> f.pixel().isoler(rang), "0 1 2 3 4 5 6 7 8 9".split(" "));
        actions.ligne(null, "déplier ou replier le détail du pixel", pixel, () -> f.pixel().deplier(), "D");
    }

    private static String[] avec(String debut) {
        return Arrays.stream(FLECHES).map(fleche -> debut + fleche).toArray(String[]::new);
    }
}
