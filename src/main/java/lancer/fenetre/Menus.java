package lancer.fenetre;

import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.NavigableSet;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JScrollPane;
import lancer.commande.Etape;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.contrat.Variante;

/** Les lignes de la table des actions, menu par menu, puis celles qui n'ont pas d'article. */
final class Menus {

    private static final NavigableSet<Integer> REFLEXIONS = new TreeSet<>(Arrays.asList(0, 1, 2, 5, 10));
    private static final String[] FLECHES = {"LEFT", "RIGHT", "UP", "DOWN"};
    private static final int[][] SENS = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};

    private final Actions actions = new Actions();
    private final Fenetre f;
    private final Controleur c;
    private final BooleanSupplier toujours = () -> true;
    private final BooleanSupplier scene;
    private final BooleanSupplier pixel;
    /** Le tableau de F1, créé à la première demande. */
    private JScrollPane touches;

    /** Donne à cette fenêtre ses menus et ses touches. */
    Menus(Fenetre fenetre, List<String> variantes) {
        f = fenetre;
        c = fenetre.controleur;
        scene = () -> reglages() != null;
        pixel = () -> f.pixel() != null;
        // ces lignes passent avant celles des menus qui ont la même touche
        actions.ligne("depuis le récit, le copier", () -> pixel.getAsBoolean() && f.pixel().aLeClavier(),
                () -> f.pixel().copier(), "menu C");
        actions.ligne("faire défiler ce tableau", () -> estTableauVisible()
                && touches.getVerticalScrollBar().isVisible(), rang -> Actions.defiler(touches, rang),
                "PAGE_UP", "PAGE_DOWN");
        actions.ligne("faire défiler le récit du pixel", pixel, rang -> f.pixel().defiler(rang),
                "PAGE_UP", "PAGE_DOWN");
        BooleanSupplier points = () -> f.vitesse() != null && f.vitesse().graphique.isFocusOwner();
        actions.ligne("dans la figure de F3, le réglage voisin", points,
                rang -> f.vitesse().graphique.aller(2 * rang - 1), "LEFT", "RIGHT");
        actions.ligne("dans la figure de F3, l'image du réglage choisi", () -> points.getAsBoolean()
                && f.vitesse().graphique.getChoisi() != null, () -> f.vitesse().montrerChoisi(), "ENTER");
        JMenuBar barre = new JMenuBar();
        barre.add(fichier());
        barre.add(affichage());
        barre.add(dessin(variantes));
        barre.add(new MenuScenes(c, actions).menu);
        sansArticle(f.prise);
        JMenu aide = barre.add(actions.menu("Aide", actions.ligne("Touches : ce tableau, qui reste ouvert", toujours,
                this::montrerTouches, "F1")));
        // A est la lettre d'Affichage
        aide.setMnemonic(KeyEvent.VK_I);
        actions.montrer();
        c.prevenir(actions::montrer);
        f.cadre.setJMenuBar(barre);
        actions.lier(f.cadre);
    }

    private void montrerTouches() {
        if (touches == null) {
            Map<String, String> dites = actions.dire();
            dites.put("Maj et la souris", "prendre un objet ou une lampe (son étoile) et le déplacer");
            dites.put("Maj et la molette", "éloigner ou approcher ce qui est pris");
            touches = Dialogues.touches(f.cadre, dites);
        }
        touches.getTopLevelAncestor().setVisible(true);
    }

    private boolean estTableauVisible() {
        return touches != null && touches.isShowing();
    }

    private JMenu fichier() {
        return actions.menu("Fichier",
                actions.ligne("Ouvrir une scène… : déposer son fichier sur la fenêtre l'ouvre aussi", toujours,
                        f::choisirScene, "menu O"),
                actions.ligne("Enregistrer l'image…", scene, f.enregistrement::enregistrer, "menu S"),
                actions.ligne("Copier l'image", scene, f.enregistrement::copier, "menu C"),
                actions.ligne("Copier le message", f.panneau.bandeau::isVisible, f.panneau.bandeau::copier),
                null,
                actions.ligne("Quitter", toujours, f::fermer, "menu Q"));
    }

    private JMenu affichage() {
        String[] vues = Stream.concat(Stream.of("l'image"), Options.VUES.stream()).toArray(String[]::new);
        return actions.menu("Affichage",
                actions.ligne("Taille demandée : celle de --taille", toujours, () -> f.remplir(false), "menu 1")
                        .coche(rang -> !f.remplie),
                actions.ligne("Remplir la fenêtre", toujours, () -> f.remplir(true), "menu 0").coche(rang -> f.remplie),
                actions.ligne("Plein écran", toujours, f::basculer, "F11").coche(rang -> f.estEnPleinEcran()),
                null,
                actions.ligne("Loupe, plus près : comme la molette ; la tirer la déplace", toujours,
                        () -> f.panneau.approcher(true), "menu UP"),
                actions.ligne("Loupe, plus loin", toujours, () -> f.panneau.approcher(false), "menu DOWN"),
                null,
                actions.ligne("Vue", scene, rang -> c.choisir(
                        c.etat.choix.avec(rang == 0 ? null : vues[rang])))
                        .coche(rang -> scene.getAsBoolean()
                                && vues[rang].equals(c.etat.choix.vue == null ? vues[0] : c.etat.choix.vue), vues),
                actions.ligne("Rayons d'un pixel : comme un clic", scene, f::inspecter, "ENTER"),
                onglet(1, "Réglages : l'étape, les réflexions, le seuil, les variantes"),
                onglet(2, "Vitesse ou précision : ce que coûte chaque réglage"),
                onglet(3, "Scène : les objets, les lampes et leurs valeurs"),
                null,
                actions.ligne("Apparence sombre", toujours, () -> Apparence.changer(!Apparence.estSombre()))
                        .coche(rang -> Apparence.estSombre()));
    }

    private Actions.Ligne onglet(int rang, String texte) {
        return actions.ligne(texte, scene, () -> f.onglets.montrer(rang).transferFocus(), "F" + (rang + 1));
    }

    private JMenu dessin(List<String> variantes) {
        List<Actions.Ligne> contenu = new ArrayList<>(Arrays.asList(
                actions.ligne("Relire la scène et redessiner : l'enregistrer dans un éditeur le fait aussi",
                        () -> c.etat.demande != null, c::relire, "F5"),
                actions.ligne("Arrêter le dessin", () -> c.etat.enCours, c::arreter, "ESCAPE"),
                null,
                reflexions("Plus de réflexions : 1, 2, 5, 10", REFLEXIONS::higher, "PLUS"),
                reflexions("Moins de réflexions", REFLEXIONS::lower, "MINUS"),
                actions.ligne("Étapes du cours : Lambert, Phong, ombres, reflets", scene,
                        rang -> c.dessiner(reglages().avecEtape(Etape.values()[rang])),
                        "ctrl alt 1", "ctrl alt 2", "ctrl alt 3", "ctrl alt 4")
                        .coche(rang -> scene.getAsBoolean() && reglages().getEtape().ordinal() == rang,
                                "Lambert", "+ Phong", "+ ombres", "+ reflets")));
        variantes.forEach(nom -> contenu.add(actions.ligne(nom, scene, () -> brancher(nom))
                .coche(rang -> scene.getAsBoolean() && reglages().estBranchee(reglages().getVariante(nom)))));
        contenu.addAll(Arrays.asList(
                null,
                actions.ligne("Revenir à la scène et aux réglages du fichier", scene, () -> c.choisir(
                        c.etat.choix.avec(c.etat.choix.lue).avec(c.etat.lecture.initiale.reglages))),
                actions.ligne("Défaire : un déplacement, un réglage, une vue", () -> c.etat.peutRevenir(-1),
                        () -> c.revenir(-1), "menu Z"),
                actions.ligne("Refaire", () -> c.etat.peutRevenir(1), () -> c.revenir(1), "menu shift Z"),
                actions.ligne("Copier ces réglages : les sections changées, et la commande", scene,
                        f.enregistrement::copierReglages, "menu shift C")));
        return actions.menu("Dessin", contenu.toArray(new Actions.Ligne[0]));
    }

    private Reglages reglages() {
        return c.etat.getReglages();
    }

    private void brancher(String nom) {
        Variante variante = reglages().getVariante(nom);
        c.dessiner(reglages().avecVariante(variante, !reglages().estBranchee(variante)));
    }

    private Actions.Ligne reflexions(String texte, UnaryOperator<Integer> autre, String touche) {
        return actions.ligne(texte, () -> scene.getAsBoolean() && autre.apply(reglages().getReflets()) != null,
                () -> c.dessiner(reglages().avecReflets(autre.apply(reglages().getReflets()))),
                touche);
    }

    private void sansArticle(Prise prise) {
        actions.ligne("lâcher ce qui est pris", prise::estPris, prise::lacher, "ESCAPE");
        actions.ligne("fermer ce tableau", this::estTableauVisible,
                () -> touches.getTopLevelAncestor().setVisible(false), "ESCAPE");
        actions.ligne("fermer le panneau", f.onglets::estOuvert, f.onglets::fermer, "ESCAPE");
        actions.ligne("quitter le plein écran", f::estEnPleinEcran, f::basculer, "ESCAPE");
        actions.ligne("tenue, l'image d'avant", () -> c.etat.avant != null, () -> f.tenir(true), "SPACE");
        actions.ligne(null, toujours, () -> f.tenir(false), "released SPACE");
        String[] avecMaj = Arrays.stream(FLECHES).map("shift "::concat).toArray(String[]::new);
        actions.ligne("pousser d'un pixel ce qui est pris", prise::estMobile,
                rang -> prise.pousser(SENS[rang][0], SENS[rang][1]), avecMaj);
        actions.ligne("le pixel voisin", pixel, rang -> f.pixel().aller(SENS[rang][0], SENS[rang][1]), FLECHES);
        actions.ligne("dix pixels plus loin", pixel,
                rang -> f.pixel().aller(10 * SENS[rang][0], 10 * SENS[rang][1]), avecMaj);
        actions.ligne("un autre échantillon du pixel", pixel, rang -> f.pixel().echantillonner(2 * rang - 1),
                "menu PAGE_UP", "menu PAGE_DOWN");
        actions.ligne("un rebond seul dans les figures, 0 pour tous ; ou un clic sur son numéro", pixel,
                rang -> f.pixel().isoler(rang), "0 1 2 3 4 5 6 7 8 9".split(" "));
        actions.ligne("déplier ou replier le détail du pixel", pixel, () -> f.pixel().deplier(), "D");
    }
}
