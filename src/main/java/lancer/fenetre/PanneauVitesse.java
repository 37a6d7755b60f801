package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
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
import lancer.commande.Option;
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
    private static final int LIGNES = 5;

    private final Controleur controleur;
    private final GraphiqueVitesse graphique = new GraphiqueVitesse();
    private final JTextArea texte = Bandeau.etiquette("vitesse.etat");
    /** Ce que demande l'échelle mesurée : tout, sauf le réglage ; {@code null} avant la première. */
    private Demande base;
    private Map<Reglages, Essai> essais = new LinkedHashMap<>();
    private Mesureur mesureur;
    /** Le dernier dessin dont la mesure est arrêtée, ou {@code null}, et pourquoi elle l'est. */
    private Dessin arrete;
    private String arret;
    /** Le réglage que désignent la souris ou les flèches, ou {@code null}. */
    private Reglages vise;

    PanneauVitesse(Controleur controleur) {
        super(new BorderLayout());
        setName("vitesse");
        this.controleur = controleur;
        // la place du texte est fixe : le graphique ne bouge pas sous la souris
        texte.setRows(LIGNES);
        texte.setPreferredSize(texte.getPreferredSize());
        add(graphique, BorderLayout.CENTER);
        add(texte, BorderLayout.PAGE_END);
        MouseAdapter souris = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                viser(graphique.sous(e.getPoint()));
            }

            @Override
            public void mousePressed(MouseEvent e) {
                viser(graphique.sous(e.getPoint()));
                prendre();
            }
        };
        graphique.addMouseListener(souris);
        graphique.addMouseMotionListener(souris);
        new Commande(null, "LEFT", () -> true, () -> viser(graphique.voisin(vise, -1))).lier(graphique, WHEN_FOCUSED);
        new Commande(null, "RIGHT", () -> true, () -> viser(graphique.voisin(vise, 1))).lier(graphique, WHEN_FOCUSED);
        new Commande(null, "ENTER", () -> true, this::prendre).lier(graphique, WHEN_FOCUSED);
        controleur.prevenir(this::suivre);
    }

    private void viser(Essai celui) {
        vise = celui == null ? null : celui.reglages;
        montrer();
    }

    /** Prend le réglage désigné : son image se dessine, et F2 le montre. */
    private void prendre() {
        if (vise != null) {
            controleur.regler(vise);
        }
    }

    /** Dessine les réglages à tour de rôle, donc dans les mêmes conditions, et publie leurs essais. */
    private final class Mesureur extends SwingWorker<Void, Essai> {

        private final Dessin montre = controleur.getEtat().montre.dessin;
        private final Map<Reglages, Essai> siens = new LinkedHashMap<>(essais);

        @Override
        protected Void doInBackground() {
            Dessin prepare = Dessin.preparer(montre.demande.avecVue(null));
            // les bords se cherchent dans l'image, et non dans une vue
            IntFunction<Couleur> dessinee = montre.demande.vue == null ? montre.image::getCouleur
                    : rang -> Constantes.CIEL;
            int fils = montre.demande.reglages.get(Option.FILS);
            Echantillon echantillon = new Echantillon(prepare.lancer, fils, dessinee, VOULUE, Long.MAX_VALUE,
                    Integer.MAX_VALUE, new SplittableRandom(1));
            Essai moins = suivant();
            while (!moins.suffit()) {
                long dureeNs = prepare.tracer(moins.reglages, prepare.image);
                Mesure mesure = echantillon.mesurer(prepare.image::getCouleur);
                Essai fait = new Essai(moins.reglages, moins.durees.avec(dureeNs), mesure.erreur, mesure.incertitude);
                siens.put(fait.reglages, fait);
                publish(fait);
                moins = suivant();
            }
            return null;
        }

        /** Celui qui a été dessiné le moins souvent, de ceux qui ne l'ont pas été assez. */
        private Essai suivant() {
            return siens.values().stream().min(Comparator.comparing(Essai::suffit)
                    .thenComparing(essai -> essai.durees.getNombre())).get();
        }

        @Override
        protected void process(List<Essai> faits) {
            if (this == mesureur) {
                faits.forEach(fait -> essais.put(fait.reglages, fait));
                montrer();
            }
        }

        @Override
        protected void done() {
            try {
                get();
                montrer();
            } catch (ExecutionException e) {
                arreter(montre, "Mesure impossible : " + Messages.message(e.getCause()));
            } catch (InterruptedException | CancellationException e) {
                // un dessin a commencé, ou l'onglet est caché : la mesure reprendra
            }
        }
    }

    /** Arrête la mesure, jusqu'à un autre dessin. @return faux si rien ne se mesure */
    boolean arreter() {
        if (mesureur == null || mesureur.isDone()) {
            return false;
        }
        long vus = essais.values().stream().filter(Essai::estFait).count();
        arreter(mesureur.montre, "arrêtée : " + vus + (vus > 1 ? " réglages mesurés" : " réglage mesuré")
                + " ; F3 reprend");
        return true;
    }

    private void arreter(Dessin dessin, String pourquoi) {
        arrete = dessin;
        arret = pourquoi;
        suivre(controleur.getEtat());
    }

    /** Reprend la mesure qui est arrêtée. Le clavier est au graphique. */
    void reprendre() {
        graphique.requestFocusInWindow();
        arrete = null;
        suivre(controleur.getEtat());
    }

    /** Commence, continue ou interrompt les mesures. */
    private void suivre(Etat etat) {
        boolean libre = isShowing() && direLEmpechement(etat) == null;
        if (mesureur != null && !libre) {
            mesureur.cancel(true);
            mesureur = null;
        }
        if (libre && mesureur == null) {
            choisir(etat.montre.dessin.demande.avecVue(null));
            mesureur = new Mesureur();
            mesureur.execute();
        }
        montrer();
    }

    /** Choisit les réglages à mesurer : l'échelle, et celui de l'image. Les essais d'une même échelle restent. */
    private void choisir(Demande demande) {
        Set<Reglages> echelle = new LinkedHashSet<>(Echelle.de(demande.reglages, false, false));
        Demande celle = demande.avecReglages(echelle.iterator().next());
        Map<Reglages, Essai> connus = celle.equals(base) ? essais : Collections.emptyMap();
        base = celle;
        echelle.add(demande.reglages);
        essais = new LinkedHashMap<>();
        echelle.forEach(voulu -> essais.put(voulu,
                connus.getOrDefault(voulu, new Essai(voulu, new Durees(), 0, 0))));
    }

    /** Montre les essais, et dit où en est leur mesure, puis celui qui est désigné. */
    private void montrer() {
        Etat etat = controleur.getEtat();
        graphique.montrer(essais.values(), etat.demande.reglages, vise);
        String dit = direLEmpechement(etat);
        if (dit == null) {
            dit = direLaMesure();
        }
        Essai designe = essais.get(vise);
        if (designe != null && designe.estFait()) {
            dit += "\n" + Echelle.dire(vise) + " : " + designe.dire();
        }
        texte.setText(dit);
        graphique.getAccessibleContext().setAccessibleDescription(dit);
    }

    /** Ce qui empêche de mesurer l'image, en mots ; {@code null} si rien. */
    private String direLEmpechement(Etat etat) {
        if (etat.enCours) {
            return "Les mesures reprendront après ce dessin.";
        }
        if (!etat.montre.entier) {
            return "Pas d'image achevée à mesurer ; F5 la dessine.";
        }
        if (etat.montre.direFautes() != null) {
            return "Image non mesurée : " + etat.montre.direFautes() + ".";
        }
        return etat.montre.dessin == arrete ? arret : null;
    }

    private String direLaMesure() {
        if (!essais.values().stream().allMatch(Essai::suffit)) {
            int faits = essais.values().stream().mapToInt(essai -> essai.durees.getNombre()).sum();
            int voulus = essais.values().stream()
                    .mapToInt(essai -> Math.max(essai.durees.getNombre(), essai.getVoulus())).sum();
            return "mesure en cours : " + faits + (faits > 1 ? " dessins sur " : " dessin sur ") + voulus;
        }
        return essais.values().stream().anyMatch(Essai::varie)
                ? "La machine est occupée : des temps y varient de plus de 30 %."
                : "Les flèches ou la souris désignent un point ; Entrée ou un clic dessine son image.";
    }
}
