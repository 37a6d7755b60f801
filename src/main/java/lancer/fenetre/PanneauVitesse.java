package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingWorker;
import lancer.Lancer;
import lancer.auto.Echantillon;
import lancer.auto.Echelle;
import lancer.auto.Mesure;
import lancer.commande.Messages;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Durees;
import lancer.fenetre.figures.Essai;
import lancer.fenetre.figures.GraphiqueVitesse;
import lancer.image.ImageMemoire;

/** Le temps et l'erreur de chaque réglage de l'échelle, mesurés si cet onglet est visible et que rien ne se dessine. */
@SuppressWarnings("serial")
final class PanneauVitesse extends JPanel {

    /** Nombre de pixels au-delà duquel l'échelle est dessinée en plus petit. */
    private static final double PIXELS = 2_000_000;
    /** Erreur, en niveaux, dont dépend le nombre de rayons d'une référence. */
    private static final double VOULUE = 0.125;
    private static final int MARGE = 8;
    private static final int LIGNES = 4;

    private final Controleur controleur;
    final GraphiqueVitesse graphique = new GraphiqueVitesse();
    private final JTextArea texte = Bandeau.etiquette("vitesse.etat");
    /** Le premier dessin de l'échelle mesurée : tout, sauf le réglage ; {@code null} avant la première image. */
    private Demande premier;
    private List<Essai> essais = new ArrayList<>();
    private Mesureur mesureur;
    /** Pourquoi la mesure a échoué ; vide si elle continue. */
    private String panne = "";

    PanneauVitesse(Controleur controleur) {
        super(new BorderLayout());
        setName("vitesse");
        this.controleur = controleur;
        texte.setBorder(BorderFactory.createEmptyBorder(0, MARGE, MARGE, MARGE));
        // la place du texte est fixe : le graphique ne bouge pas sous la souris
        texte.setRows(LIGNES);
        add(graphique, BorderLayout.CENTER);
        add(texte, BorderLayout.PAGE_END);
        MouseAdapter souris = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                dire(graphique.sous(e.getPoint()));
            }

            @Override
            public void mousePressed(MouseEvent e) {
                Essai choisi = graphique.sous(e.getPoint());
                if (choisi != null) {
                    // son image se dessine, et F2 montre ce réglage
                    controleur.regler(choisi.reglages);
                }
            }
        };
        graphique.addMouseListener(souris);
        graphique.addMouseMotionListener(souris);
        controleur.prevenir(this::suivre);
        addHierarchyListener(e -> suivre());
    }

    /** Dessine l'échelle et le réglage présent à tour de rôle, donc tous dans les mêmes conditions. */
    private final class Mesureur extends SwingWorker<Void, List<Essai>> {

        private final Demande demande;
        /** L'image de cette demande, dont l'échantillon cherche les bords ; {@code null} si une vue est montrée. */
        private final ImageMemoire montree;
        private final List<Essai> siens = new ArrayList<>(essais);

        Mesureur(Demande demande, ImageMemoire montree) {
            this.demande = demande;
            this.montree = montree;
        }

        @Override
        protected Void doInBackground() {
            double part = Math.min(1, Math.sqrt(PIXELS / demande.largeur / demande.hauteur));
            Dessin prepare = new Dessin(demande.avecTaille((int) Math.ceil(part * demande.largeur),
                    (int) Math.ceil(part * demande.hauteur)));
            boolean enEntier = prepare.image.largeur == demande.largeur && montree != null;
            Echantillon echantillon = new Echantillon(prepare.lancer, controleur.getFils(),
                    enEntier ? montree::getCouleur : null, VOULUE, Long.MAX_VALUE, new SplittableRandom(1));
            Essai moins = suivant();
            while (!moins.suffit()) {
                Lancer lancer = prepare.lancer.avec(moins.reglages.getModele());
                lancer.TracerPixels((couleur, xe, ye) -> {
                    prepare.image.drawPixel(couleur, xe, ye);
                    echantillon.drawPixel(couleur, xe, ye);
                }, moins.reglages.getProfondeur(), controleur.getFils());
                Mesure mesure = echantillon.mesurer();
                siens.set(siens.indexOf(moins), new Essai(moins.reglages, moins.durees.avec(lancer.getDureeNs()),
                        mesure.erreur, mesure.incertitude));
                publish(new ArrayList<>(siens));
                moins = suivant();
            }
            return null;
        }

        /** Celui qui a été dessiné le moins souvent, de ceux qui ne l'ont pas été assez. */
        private Essai suivant() {
            return siens.stream().min(Comparator.comparing(Essai::suffit)
                    .thenComparing(essai -> essai.durees.getNombre())).get();
        }

        @Override
        protected void process(List<List<Essai>> publies) {
            if (this == mesureur) {
                essais = publies.get(publies.size() - 1);
                graphique.montrer(essais, demande.reglages);
                dire(null);
            }
        }

        @Override
        protected void done() {
            try {
                get();
            } catch (ExecutionException e) {
                panne = "Mesure impossible : " + Messages.message(e.getCause());
                dire(null);
            } catch (InterruptedException | CancellationException e) {
                // un dessin a commencé, ou l'onglet est caché : la mesure reprendra
            }
        }
    }

    /** Commence, continue ou interrompt les mesures. */
    private void suivre() {
        boolean libre = isShowing() && controleur.getImageEntiere() != null && !controleur.enCours;
        if (mesureur != null && !libre) {
            mesureur.cancel(true);
            mesureur = null;
        }
        if (libre && mesureur == null && controleur.direFautes() == null) {
            Demande demande = controleur.montre.demande.avecVue(null);
            List<Reglages> echelle = Echelle.de(demande.reglages, false, false);
            Demande autre = demande.avecReglages(echelle.get(0));
            if (!autre.equals(premier)) {
                premier = autre;
                essais.clear();
                echelle.forEach(reglages -> essais.add(nouveau(reglages)));
            }
            essais.removeIf(essai -> !echelle.contains(essai.reglages));
            if (!echelle.contains(demande.reglages)) {
                essais.add(nouveau(demande.reglages));
            }
            panne = "";
            Dessin montre = controleur.montre;
            mesureur = new Mesureur(demande, montre.demande.equals(demande) ? montre.image : null);
            mesureur.execute();
        }
        dire(null);
    }

    private static Essai nouveau(Reglages reglages) {
        return new Essai(reglages, new Durees(), 0, 0);
    }

    /** @param vise le réglage sous la souris, ou {@code null} */
    private void dire(Essai vise) {
        long faits = essais.stream().filter(Essai::suffit).count();
        String etat = faits > 0 && faits == essais.size() ? "La souris dit un point, et un clic montre son image."
                : "mesure en cours : " + faits + " réglages sur " + essais.size() + "…";
        if (vise != null) {
            etat = Echelle.dire(vise.reglages) + " : " + vise.dire();
        } else if (controleur.enCours) {
            etat = "Les mesures reprendront après ce dessin.";
        }
        texte.setText(panne.isEmpty() ? etat : panne);
    }
}
