package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.Timer;
import javax.swing.TransferHandler;
import javax.swing.WindowConstants;
import lancer.fenetre.Bandeau.Sujet;
import lancer.image.ImageMemoire;

/**
 * La fenêtre : cadre, taille, touches, menus, et affichage du dessin que dirige {@link Controleur}. Le fil des
 * événements ne fait ni calcul, ni lecture, ni écriture, ni attente : une horloge lui fait lire l'état du dessin.
 */
@SuppressWarnings("serial")
public final class Fenetre {

    /** Temps entre deux lectures de l'état du dessin, et temps sans changement de taille avant de redessiner. */
    private static final int PERIODE_MS = 33;
    private static final int REPOS_MS = 200;

    final JFrame cadre = new JFrame();
    final Controleur controleur;
    private final String programme;
    /** La taille de l'image demandée par la ligne de commande. */
    final Dimension demandee;
    final PanneauImage panneau;
    final Onglets onglets;
    private final Runnable fin;
    private final BarreEtat barre;
    final Enregistrement enregistrement;
    private final Timer retaille;
    private final Timer horloge = new Timer(PERIODE_MS, e -> observer());
    final Prise prise;
    /** Vrai si l'image remplit la fenêtre. */
    boolean remplie;
    /** Position du cadre avant le plein écran ; {@code null} hors du plein écran. */
    private Rectangle place;

    Fenetre(Tracage.Moteur moteur, List<String> variantes, ExecutorService dessins, Runnable fin) {
        programme = variantes.isEmpty() ? "lancer" : "lancer (" + String.join(", ", variantes) + ")";
        this.fin = fin;
        demandee = new Dimension(moteur.options.largeur, moteur.options.hauteur);
        panneau = new PanneauImage(demandee, this::decrire, this::inspecter);
        barre = new BarreEtat();
        controleur = new Controleur(moteur, dessins, panneau, this::getTaille);
        controleur.prevenir(this::suivre);
        retaille = new Timer(REPOS_MS, e -> controleur.ajuster());
        enregistrement = new Enregistrement(controleur, panneau.bandeau);
        prise = new Prise(controleur, panneau);
        Map<String, Supplier<JComponent>> contenus = new LinkedHashMap<>();
        contenus.put("Pixel", () -> new Inspecteur(controleur, panneau));
        contenus.put("Réglages", () -> new PanneauReglages(controleur));
        contenus.put("Vitesse", () -> new PanneauVitesse(controleur));
        contenus.put("Scène", () -> new PanneauScene(controleur, prise, panneau));
        onglets = new Onglets(cadre, panneau, contenus);
    }

    /** @param premier le dessin déjà commencé, ou {@code null} */
    void commencer(Tracage premier) {
        cadre.add(onglets, BorderLayout.CENTER);
        cadre.add(barre, BorderLayout.PAGE_END);
        cadre.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        Rectangle ecran = Dialogues.ecran();
        // les bords du cadre sont alors connus ; réduit après coup, il reprend parfois sa taille d'avant
        cadre.addNotify();
        cadre.setPreferredSize(new Rectangle(cadre.getPreferredSize())
                .intersection(new Rectangle(ecran.getSize())).getSize());
        cadre.pack();
        // les panneaux s'ouvrent à droite de l'image
        cadre.setLocation(ecran.x + Math.max(0, (ecran.width - cadre.getWidth() - Onglets.getLargeurMax()) / 2),
                ecran.y + Math.max(0, (ecran.height - cadre.getHeight()) / 2));
        ecouter();
        titrer();
        if (premier == null) {
            panneau.dire("Ctrl+O pour ouvrir une scène, ou déposer ici un fichier .ini");
            EventQueue.invokeLater(this::choisirScene);
        } else {
            controleur.commencer(premier);
        }
        cadre.setVisible(true);
    }

    private void ecouter() {
        cadre.getRootPane().setTransferHandler(new Depot());
        cadre.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                fermer();
            }

            @Override
            public void windowDeactivated(WindowEvent e) {
                tenir(false);
            }
        });
        retaille.setRepeats(false);
        ComponentAdapter tailleEtPlace = new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                decrire();
                retaille.restart();
            }

            @Override
            public void componentMoved(ComponentEvent e) {
                panneau.perdreSouris();
            }
        };
        panneau.addComponentListener(tailleEtPlace);
        cadre.addComponentListener(tailleEtPlace);
    }

    private final class Depot extends TransferHandler {

        @Override
        public boolean canImport(TransferSupport depot) {
            return depot.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
        }

        @Override
        public boolean importData(TransferSupport depot) {
            try {
                List<?> fichiers = (List<?>) depot.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
                if (fichiers.size() == 1) {
                    controleur.ouvrir(((File) fichiers.get(0)).getPath());
                    return true;
                }
                panneau.bandeau.dire(Sujet.AVIS, "une scène à la fois : " + fichiers.size() + " fichiers déposés");
                return false;
            } catch (UnsupportedFlavorException | IOException e) {
                return false;
            }
        }
    }

    private Dimension getTaille() {
        return remplie || estEnPleinEcran() ? panneau.getTailleMax(demandee.width, demandee.height) : demandee;
    }

    void remplir(boolean voulue) {
        remplie = voulue;
        controleur.ajuster();
    }

    boolean estEnPleinEcran() {
        return place != null;
    }

    void basculer() {
        boolean entre = !estEnPleinEcran();
        Rectangle avant = entre ? cadre.getBounds() : place;
        place = entre ? avant : null;
        // la barre de titre ne peut être ôtée qu'à un cadre fermé
        cadre.dispose();
        cadre.setUndecorated(entre);
        cadre.getJMenuBar().setVisible(!entre);
        barre.setVisible(!entre);
        cadre.getGraphicsConfiguration().getDevice().setFullScreenWindow(entre ? cadre : null);
        cadre.setBounds(entre ? cadre.getBounds() : avant);
        cadre.setVisible(true);
        panneau.requestFocus();
        controleur.ajuster();
    }

    void choisirScene() {
        File choisi = Dialogues.choisirScene(panneau, controleur.etat.demande);
        if (choisi != null) {
            controleur.ouvrir(choisi.getPath());
        }
    }

    void inspecter() {
        Point pixel = panneau.getPixelVise();
        if (pixel != null) {
            ((Inspecteur) onglets.montrer(0)).montrer(pixel);
        }
    }

    void tenir(boolean tenue) {
        ImageMemoire voulue = tenue ? controleur.etat.avant : null;
        if (voulue != panneau.tenue) {
            panneau.tenue = voulue;
            panneau.dire(tenue ? "avant : " + panneau.legendes.get(voulue) : "");
            decrire();
        }
    }

    /** L'onglet Pixel s'il est visible, ou {@code null}. */
    Inspecteur pixel() {
        return onglets.getVisible(Inspecteur.class);
    }

    PanneauVitesse vitesse() {
        return onglets.getVisible(PanneauVitesse.class);
    }

    /** Arrête les dessins, ferme la fenêtre, et laisse finir les écritures en cours. */
    void fermer() {
        if (cadre.isDisplayable()) {
            abandonner();
            enregistrement.terminer(fin);
        }
    }

    /** Ferme la fenêtre sans finir le programme : la première scène est refusée. */
    void abandonner() {
        controleur.terminer();
        // fermer l'onglet arrête son calcul
        onglets.fermer();
        cadre.dispose();
        horloge.stop();
    }

    private void suivre() {
        if (controleur.etat.enCours) {
            horloge.start();
        } else {
            horloge.stop();
            if (cadre.getIconImages().isEmpty()) {
                // les icônes montrent la scène du cours ; outils/Makefile les refait
                cadre.setIconImages(Stream.of("16", "32", "48", "128").map(cote -> cadre.getToolkit().getImage(
                        Fenetre.class.getResource("icone-" + cote + ".png"))).collect(Collectors.toList()));
            }
        }
        titrer();
        avancer();
        decrire();
    }

    private void avancer() {
        Etat etat = controleur.etat;
        barre.avancer(etat.enCours ? etat.courant : null);
        String avancement = etat.courant == null ? "" : etat.courant.getEtat();
        if (etat.enCours || !etat.entiere) {
            barre.resumer(avancement);
        }
        if (estEnPleinEcran() && etat.courant != null) {
            panneau.dire(etat.entiere && !etat.enCours ? "" : cadre.getTitle() + " — " + avancement
                    + (etat.enCours ? "" : " ; F5 pour le reprendre"));
        }
    }

    private void observer() {
        controleur.observer();
        avancer();
        montrerPixel();
    }

    /** Affiche le coût de l'image montrée, si elle est achevée, et la couleur du pixel sous la souris. */
    private void decrire() {
        ImageMemoire image = panneau.tenue != null ? panneau.tenue
                : controleur.etat.enCours ? null : controleur.etat.getImageEntiere();
        String resume = image == null ? "" : BarreEtat.resume(image, panneau.getReduction(image))
                + ", " + panneau.legendes.get(image);
        if (image != null) {
            barre.resumer(resume);
        }
        panneau.getAccessibleContext().setAccessibleDescription(resume);
        montrerPixel();
    }

    private void montrerPixel() {
        ImageMemoire image = panneau.getVisible();
        Point pixel = image == panneau.apercu ? null : panneau.getPixelSouris(image);
        if (pixel == null || !prise.dire().isEmpty()) {
            barre.dire(prise.dire(), null);
        } else {
            barre.montrerPixel(pixel, image, !panneau.legendes.containsKey(image));
        }
    }

    private void titrer() {
        String fichier = controleur.etat.demande;
        cadre.setTitle(fichier == null ? programme : programme + " — " + new File(fichier).getName()
                + (controleur.etat.estDeplace() ? " •" : ""));
    }
}
