package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import lancer.Couleur;
import lancer.Lancer;
import lancer.auto.Auto;
import lancer.auto.Candidat;
import lancer.contrat.Toile;
import lancer.dessin.Dessin;
import lancer.dessin.ReglagesDessin;
import lancer.fenetre.figures.GraphiqueVitesse;
import lancer.image.ImageMemoire;

/** Les réglages que {@code --auto} essaierait sur la scène montrée, essayés tant que cet onglet est visible. */
@SuppressWarnings("serial")
final class PanneauVitesse extends JPanel {

    private static final int MARGE = 8;

    private final Controleur controleur;
    private final JTextArea etat = Bandeau.etiquette("vitesse.etat");
    /** Texte du point que désignent la souris ou les flèches. */
    private final JTextArea point = Bandeau.etiquette("vitesse.point");
    private final GraphiqueVitesse graphique = new GraphiqueVitesse(this::dessiner, point::setText, this::estPresent);
    private final ExecutorService fil = Controleur.unFil("lancer-vitesse");
    private Future<?> essais;
    /** Ce dont dépendent les essais en cours ; {@code null} sans essai. */
    private List<Object> essayee;
    private Auto auto;
    /** Le réglage dessiné, tant que son erreur n'est pas mesurée. */
    private Candidat voulu;

    PanneauVitesse(Controleur controleur) {
        super(new BorderLayout());
        setName("vitesse");
        this.controleur = controleur;
        JPanel bas = new JPanel(new BorderLayout());
        bas.setBorder(BorderFactory.createEmptyBorder(0, MARGE, MARGE, MARGE));
        point.setRows(2);
        bas.add(point, BorderLayout.CENTER);
        bas.add(etat, BorderLayout.PAGE_END);
        add(graphique, BorderLayout.CENTER);
        add(bas, BorderLayout.PAGE_END);
        controleur.prevenir(this::suivre);
        // aucun essai quand l'onglet est caché
        addHierarchyListener(e -> suivre());
    }

    private void abandonner() {
        if (essais != null) {
            essais.cancel(true);
        }
        essayee = null;
        auto = null;
        voulu = null;
        graphique.vider();
    }

    private void suivre() {
        Dessin montre = controleur.etat.montre;
        if (!isShowing()) {
            abandonner();
            return;
        }
        if (montre == null) {
            etat.setText("Pas encore d'image : les essais commenceront avec elle.");
            return;
        }
        List<Object> scene = scene(montre);
        if (!scene.equals(essayee)) {
            abandonner();
            essayee = scene;
            essayer(montre);
        }
        graphique.repaint();
        if (auto != null && !graphique.aUnPresent()) {
            // les réglages ont été changés ailleurs que dans ce graphique
            List<Object> memeScene = essayee;
            Auto fait = auto;
            auto = null;
            essais = Controleur.confier(fil, () -> evaluer(memeScene, fait, montre), etat::setText);
        }
        ImageMemoire image = controleur.getImageComplete();
        if (voulu != null && auto != null && image != null && image.lineaire != null
                && image.sens.equals(ImageMemoire.COULEUR) && estPresent(voulu)) {
            if (controleur.direFautes() == null) {
                mesurer(montre.getLancer(), image);
            } else {
                etat.setText("Image non mesurée : " + controleur.direFautes() + ".");
            }
            voulu = null;
        }
    }

    /** Ce dont dépendent les essais : les objets, la taille, et les variantes qu'ils ne règlent pas. */
    private List<Object> scene(Dessin dessin) {
        ReglagesDessin reglages = dessin.getReglages();
        // un fichier relu sans changement garde les essais
        List<Object> scene = new ArrayList<>(Arrays.asList(controleur.etat.estDeplace() ? dessin.getScene().getObjets()
                : dessin.fichier + " " + controleur.etat.lecture.version,
                dessin.getImage().largeur, dessin.getImage().hauteur));
        reglages.getVariantes().stream().filter(reglages::estBranchee).forEach(variante -> scene.add(
                reglages.getEssayees().containsKey(variante) ? variante.getSection()
                : reglages.getSection(variante).toString()));
        return scene;
    }

    private boolean estPresent(Candidat reglage) {
        ReglagesDessin presents = controleur.etat.montre.getReglages();
        return reglage.reflets == presents.getReflets() && reglage.seuil == presents.getSeuil()
                && String.valueOf(reglage.section).equals(String.valueOf(presents.getSectionEssayee()));
    }

    private void essayer(Dessin montre) {
        List<Object> scene = essayee;
        etat.setText("premiers essais…");
        essais = Controleur.confier(fil, () -> {
            Auto fait = new Auto(montre.getLancer(), 0, null, null, controleur.fils,
                    montre.getReglages().getEssayees(),
                    enCours -> montrer(scene, enCours, "d'autres réglages à essayer…", null));
            fait.chronometrer();
            evaluer(scene, fait, montre);
        }, echec -> etat.setText("Essais impossibles : " + echec));
    }

    /** Ajoute au graphique, depuis le fil des essais, le point des réglages de ce dessin. */
    private void evaluer(List<Object> scene, Auto fait, Dessin montre) {
        montrer(scene, fait, "Un clic sur un point dessine l'image avec ses réglages (ou flèches, et Entrée)."
                + (montre.getReglages().getVariantes().isEmpty()
                ? "\nantialias.jar, mis à la place de lancer.jar, apporte d'autres réglages." : ""),
                fait.evaluer(montre.getReglages().getSectionEssayee(), montre.getLancer(),
                        montre.getReglages().getProfondeur()));
    }

    /** Montre, depuis le fil des essais, leurs résultats, si la scène n'a pas changé depuis. */
    private void montrer(List<Object> scene, Auto enCours, String texte, Candidat present) {
        List<Candidat> essayes = new ArrayList<>(enCours.essayes);
        EventQueue.invokeLater(() -> {
            if (scene == essayee) {
                etat.setText(texte);
                ImageMemoire image = controleur.etat.montre.getImage();
                graphique.montrer(essayes, present, (double) image.largeur * image.hauteur
                        / Math.min(controleur.fils, Runtime.getRuntime().availableProcessors()));
                auto = present == null ? null : enCours;
                suivre();
            }
        });
    }

    private void dessiner(Candidat reglage) {
        ReglagesDessin reglages = controleur.etat.getReglages().avec(reglage.reflets, reglage.seuil);
        if (reglage.section != null) {
            reglages = reglages.avec(reglages.getVariante(reglage.section.nom), reglage.section);
        }
        voulu = reglage;
        // ce texte compare aux réglages qui vont changer
        point.setText(" ");
        controleur.dessiner(reglages, false);
    }

    private void mesurer(Lancer lancer, ImageMemoire image) {
        List<Object> scene = essayee;
        Auto fait = auto;
        Candidat reglage = voulu;
        double temps = lancer.getDureeNs() / 1e9;
        etat.setText("mesure de l'image…");
        essais = Controleur.confier(fil, () -> {
            Toile controle = fait.surveiller((couleur, i, j) -> { }, reglage);
            float[] lineaire = image.lineaire;
            for (int k = 0; k < lineaire.length / 3; k++) {
                controle.drawPixel(new Couleur(lineaire[3 * k], lineaire[3 * k + 1], lineaire[3 * k + 2]),
                        k % image.largeur, k / image.largeur);
            }
            double erreur = fait.getErreurMesuree();
            double incertitude = fait.getIncertitude();
            EventQueue.invokeLater(() -> {
                if (scene == essayee) {
                    etat.setText(String.format(Locale.FRANCE, "Mesuré : %.2f ± %.2f (attendu : de %.2f à %.2f), "
                            + "%.2f s", erreur, incertitude, reglage.auMoins, reglage.auPlus, temps));
                    graphique.ajouterMesure(temps, erreur, incertitude);
                }
            });
        }, echec -> etat.setText("Mesure impossible : " + echec));
    }
}
