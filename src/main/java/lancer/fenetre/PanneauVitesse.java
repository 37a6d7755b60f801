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
import java.util.function.IntFunction;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingWorker;
import lancer.Constantes;
import lancer.Couleur;
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

/** Le temps et l'erreur de chaque réglage de l'échelle, mesurés si cet onglet est visible et que rien ne se dessine. */
@SuppressWarnings("serial")
final class PanneauVitesse extends JPanel {

    /** Erreur, en niveaux, dont dépend le nombre de rayons d'une référence. */
    private static final double VOULUE = 0.125;

    private final Controleur controleur;
    private final GraphiqueVitesse graphique = new GraphiqueVitesse();
    private final JTextArea texte = Bandeau.etiquette("vitesse.etat");
    /** Ce que demande l'échelle mesurée : tout, sauf le réglage ; {@code null} avant la première. */
    private Demande base;
    private List<Essai> essais = new ArrayList<>();
    private Mesureur mesureur;

    PanneauVitesse(Controleur controleur) {
        super(new BorderLayout());
        setName("vitesse");
        this.controleur = controleur;
        // la place du texte est fixe : le graphique ne bouge pas sous la souris
        texte.setRows(4);
        add(graphique, BorderLayout.CENTER);
        add(texte, BorderLayout.PAGE_END);
        MouseAdapter souris = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                Essai vise = graphique.sous(e.getPoint());
                texte.setText(vise == null ? etat() : Echelle.dire(vise.reglages) + " : " + vise.dire());
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

    /** Dessine les réglages à tour de rôle, donc dans les mêmes conditions, et publie leurs essais. */
    private final class Mesureur extends SwingWorker<Void, List<Essai>> {

        private final Dessin montre = controleur.montre;
        private final Demande demande = montre.demande.avecVue(null);
        private final List<Essai> siens = new ArrayList<>(essais);

        @Override
        protected Void doInBackground() {
            Dessin prepare = new Dessin(demande);
            // les bords se cherchent dans l'image, et non dans une vue
            IntFunction<Couleur> dessinee = montre.demande.vue == null ? montre.image::getCouleur
                    : rang -> Constantes.CIEL;
            Echantillon echantillon = new Echantillon(prepare.lancer, controleur.getFils(), dessinee, VOULUE,
                    Long.MAX_VALUE, Integer.MAX_VALUE, new SplittableRandom(1));
            Essai moins = suivant();
            while (!moins.suffit()) {
                long dureeNs = prepare.tracer(moins.reglages, prepare.image);
                Mesure mesure = echantillon.mesurer(prepare.image::getCouleur);
                siens.set(siens.indexOf(moins), new Essai(moins.reglages, moins.durees.avec(dureeNs),
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
                texte.setText(etat());
            }
        }

        @Override
        protected void done() {
            try {
                get();
            } catch (ExecutionException e) {
                texte.setText("Mesure impossible : " + Messages.message(e.getCause()));
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
            choisir(controleur.montre.demande.avecVue(null));
            mesureur = new Mesureur();
            mesureur.execute();
        }
        texte.setText(etat());
    }

    /** Choisit les réglages à mesurer : l'échelle, et celui de l'image. Les essais d'une même échelle restent. */
    private void choisir(Demande demande) {
        List<Reglages> echelle = new ArrayList<>(Echelle.de(demande.reglages, false, false));
        Demande celle = demande.avecReglages(echelle.get(0));
        if (!celle.equals(base)) {
            base = celle;
            essais.clear();
        }
        echelle.add(demande.reglages);
        essais.removeIf(essai -> !echelle.contains(essai.reglages));
        echelle.stream().distinct().filter(voulu -> essais.stream().noneMatch(essai -> essai.reglages.equals(voulu)))
                .forEach(voulu -> essais.add(new Essai(voulu, new Durees(), 0, 0)));
    }

    private String etat() {
        if (controleur.enCours) {
            return "Les mesures reprendront après ce dessin.";
        }
        long faits = essais.stream().filter(Essai::suffit).count();
        return faits > 0 && faits == essais.size() ? "La souris dit un point, et un clic montre son image."
                : "mesure en cours : " + faits + " réglages sur " + essais.size() + "…";
    }
}
