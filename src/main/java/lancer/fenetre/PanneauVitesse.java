package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import lancer.Couleur;
import lancer.auto.Auto;
import lancer.auto.Candidat;
import lancer.contrat.Section;
import lancer.contrat.Toile;
import lancer.contrat.Variante;
import lancer.dessin.Dessin;
import lancer.dessin.ReglagesDessin;
import lancer.fenetre.figures.GraphiqueVitesse;
import lancer.fils.Traceur;
import lancer.image.ImageMemoire;

/**
 * « Vitesse ou précision » : les réglages que {@code --auto} essaierait sur la scène montrée, chacun à son prix et à
 * son erreur attendue. Un fil à part les essaie, et le dit à mesure ; fermer l'arrête, changer de scène recommence.
 */
final class PanneauVitesse extends JDialog {

    private static final long serialVersionUID = 1;

    private static final int MARGE = 8;

    private final transient Atelier atelier;
    private final GraphiqueVitesse graphique = new GraphiqueVitesse(this::dessiner, this::atteindre);
    private final JLabel etat = new JLabel(" ");
    /** Le point où mènent la souris et les flèches, en mots. */
    private final JTextArea point = new JTextArea(2, 40);
    private final transient ExecutorService fil = Atelier.unFil("lancer-vitesse");
    private transient Future<?> essais;

    /** La scène essayée, telle que rien de ce panneau ne la change ; {@code null} s'il n'y en a pas. */
    private transient List<Object> essayee;

    /** Ses essais, une fois finis. */
    private transient Auto auto;

    /** Le point dessiné, s'il n'est pas encore mesuré. */
    private transient Candidat voulu;

    PanneauVitesse(JFrame cadre, Atelier atelier) {
        super(cadre, "Vitesse ou précision");
        setName("vitesse");
        this.atelier = atelier;
        JPanel bas = new JPanel(new BorderLayout());
        bas.setBorder(BorderFactory.createEmptyBorder(0, MARGE, MARGE, MARGE));
        etat.setName("vitesse.etat");
        point.setName("vitesse.point");
        point.setFont(etat.getFont());
        point.setOpaque(false);
        Bandeau.donnerALire(point);
        bas.add(point, BorderLayout.CENTER);
        bas.add(etat, BorderLayout.PAGE_END);
        graphique.setPreferredSize(new Dimension(560, 400));
        add(graphique, BorderLayout.CENTER);
        add(bas, BorderLayout.PAGE_END);
        pack();
        atelier.prevenir(this::suivre);
    }

    /** Montré, il essaie ce qui ne l'a pas été ; caché, plus rien. */
    @Override
    public void setVisible(boolean visible) {
        super.setVisible(visible);
        if (visible) {
            suivre();
        } else {
            abandonner();
        }
    }

    private void atteindre(String texte) {
        point.setText(texte);
        graphique.getAccessibleContext().setAccessibleDescription(texte);
    }

    private void abandonner() {
        if (essais != null) {
            essais.cancel(true);
        }
        essais = null;
        essayee = null;
        auto = null;
        voulu = null;
        graphique.vider();
    }

    /** Un dessin commence ou finit, ou une scène est lue. */
    private void suivre() {
        Dessin montre = atelier.getMontre();
        if (!isVisible() || montre == null) {
            etat.setText("Pas encore d'image : les essais commenceront avec elle.");
            return;
        }
        Traceur lancer = montre.traceur;
        ReglagesDessin reglages = montre.reglages;
        List<Object> scene = scene(lancer, reglages);
        if (!memes(scene, essayee)) {
            abandonner();
            essayee = scene;
            essayer(lancer, reglages);
        }
        String present = GraphiqueVitesse.cle(reglages.getReflets(), reglages.getSeuil(), section(reglages));
        graphique.setPresent(present);
        ImageMemoire image = atelier.getImageComplete();
        if (voulu != null && auto != null && image != null && image.getLineaire() != null
                && GraphiqueVitesse.cle(voulu).equals(present)) {
            if (atelier.direFautes() == null) {
                mesurer(auto, voulu, lancer, image);
            } else {
                etat.setText("Image non mesurée : " + atelier.direFautes() + ".");
            }
            voulu = null;
        }
    }

    /** Ce dont dépendent les essais : les objets, la taille, et les variantes qu'ils ne règlent pas. */
    private static List<Object> scene(Traceur lancer, ReglagesDessin reglages) {
        List<Object> scene = new ArrayList<>(Arrays.asList(lancer.getScene().getObjets(),
                lancer.getCamera().getLargeur(), lancer.getCamera().getHauteur()));
        for (Variante variante : reglages.getVariantes()) {
            if (reglages.estBranchee(variante) && !libres(reglages).contains(variante)) {
                scene.add(reglages.getSection(variante).toString());
            }
        }
        return scene;
    }

    /** La liste des objets est la même, ou ce n'est plus la même scène ; le reste se compare. */
    private static boolean memes(List<Object> une, List<Object> autre) {
        return autre != null && une.get(0) == autre.get(0)
                && une.subList(1, une.size()).equals(autre.subList(1, autre.size()));
    }

    /** Les variantes branchées que les essais règlent : le fichier n'en dit rien. */
    private static List<Variante> libres(ReglagesDessin reglages) {
        List<Variante> libres = new ArrayList<>(reglages.initiaux().getVariantesLibres());
        libres.removeIf(variante -> variante.getEchelle().isEmpty() || !reglages.estBranchee(variante));
        return libres;
    }

    /** La section qui règle l'échantillonnage ; {@code null} si c'est la scène. */
    private static Section section(ReglagesDessin reglages) {
        return libres(reglages).stream().map(reglages::getSection).findFirst().orElse(null);
    }

    private void essayer(Traceur lancer, ReglagesDessin reglages) {
        List<Object> scene = essayee;
        List<Variante> libres = libres(reglages);
        int fils = atelier.fils;
        etat.setText("premiers essais…");
        essais = Atelier.confier(fil, () -> {
            Auto fait = Auto.choisir(lancer, 0, null, null, fils, libres, enCours ->
                    montrer(scene, enCours, "d'autres réglages à essayer…", null));
            Candidat present = fait.evaluer(reglages.getReflets(), reglages.getSeuil());
            montrer(scene, fait, "Un clic sur un point dessine l'image avec ses réglages"
                    + " (ou flèches, et Entrée).", present);
        }, panne -> etat.setText("Essais impossibles : " + panne));
    }

    /** Du fil des essais : ce qu'ils disent, si personne n'a changé de scène entre-temps. */
    private void montrer(List<Object> scene, Auto enCours, String texte, Candidat present) {
        List<GraphiqueVitesse.Point> points = new ArrayList<>();
        for (Candidat reglage : enCours.getEssayes()) {
            points.add(new GraphiqueVitesse.Point(reglage, enCours.getEssayes().stream()
                    .noneMatch(autre -> autre.prix < reglage.prix && autre.erreur <= reglage.erreur)));
        }
        GraphiqueVitesse.Point ici = present == null ? null : new GraphiqueVitesse.Point(present, false);
        EventQueue.invokeLater(() -> {
            if (scene == essayee) {
                etat.setText(texte);
                graphique.montrer(points, ici);
                auto = present == null ? null : enCours;
                suivre();
            }
        });
    }

    private void dessiner(Candidat reglage) {
        ReglagesDessin reglages = atelier.getReglages().avec(reglage.reflets, reglage.seuil);
        if (reglage.section != null) {
            Variante variante = reglages.getVariante(reglage.section.getNom());
            reglages = reglages.avec(variante, reglage.section);
        }
        voulu = reglage;
        atelier.dessiner(reglages, false);
    }

    private void mesurer(Auto fait, Candidat reglage, Traceur lancer, ImageMemoire image) {
        List<Object> scene = essayee;
        double rayons = lancer.getCompteurs().rayons() / (double) image.getCodes().length;
        etat.setText("mesure de l'image…");
        essais = Atelier.confier(fil, () -> {
            Toile controle = fait.surveiller((couleur, i, j) -> { });
            float[] lineaire = image.getLineaire();
            for (int k = 0; k < lineaire.length / 3; k++) {
                controle.drawPixel(new Couleur(lineaire[3 * k], lineaire[3 * k + 1], lineaire[3 * k + 2]),
                        k % image.getLargeur(), k / image.getLargeur());
            }
            double erreur = fait.getErreurMesuree();
            double incertitude = fait.getIncertitude();
            EventQueue.invokeLater(() -> {
                if (scene == essayee) {
                    etat.setText(String.format(Locale.FRANCE, "Mesuré : %.2f ± %.2f (attendu : de %.2f à %.2f), "
                            + "%.1f rayons par pixel", erreur, incertitude, reglage.auMoins,
                            reglage.auPlus, rayons));
                    graphique.ajouterMesure(rayons, erreur, incertitude);
                }
            });
        }, panne -> etat.setText("Mesure impossible : " + panne));
    }
}
