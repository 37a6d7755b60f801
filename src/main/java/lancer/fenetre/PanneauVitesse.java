package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import lancer.Couleur;
import lancer.auto.Echantillon;
import lancer.auto.Echelle;
import lancer.auto.Mesure;
import lancer.commande.Reglages;
import lancer.contrat.Section;
import lancer.dessin.Dessin;
import lancer.fenetre.figures.GraphiqueVitesse;

/** L'échelle des réglages de la scène montrée, dessinée si cet onglet est visible et qu'aucun dessin n'est en cours. */
@SuppressWarnings("serial")
final class PanneauVitesse extends JPanel {

    /** Nombre de pixels au-delà duquel l'échelle est dessinée en plus petit. */
    private static final double PIXELS = 2_000_000;
    /** Nombre de pixels de toutes les images gardées, de 16 octets par pixel : 64 Mo. */
    private static final int PIXELS_GARDES = 4 << 20;
    /** Temps de dessin après lequel une image n'est plus dessinée de nouveau, en nanosecondes. */
    private static final long DUREE_NS = 300_000_000;
    /** Temps de dessin de plus du premier échelon, puis du premier anticrénelage : Java compile d'abord leur code. */
    private static final long AVANT_NS = 1_000_000_000;
    /** Erreur, en niveaux, dont dépend le nombre de rayons d'une référence. */
    private static final double VOULUE = 0.125;
    private static final int MARGE = 8;
    private static final int LIGNES = 7;

    private final Controleur controleur;
    private final JTextArea etat = Bandeau.etiquette("vitesse.etat");
    /** Texte du point que désignent la souris ou les flèches. */
    private final JTextArea point = Bandeau.etiquette("vitesse.point");
    final GraphiqueVitesse graphique = new GraphiqueVitesse(this::montrerChoisi, point::setText);
    private final ExecutorService fil = Controleur.unFil("lancer-vitesse");
    private Mesures mesures = new Mesures(null);
    private Future<?> travail;

    PanneauVitesse(Controleur controleur) {
        super(new BorderLayout());
        setName("vitesse");
        this.controleur = controleur;
        JPanel bas = new JPanel(new BorderLayout());
        bas.setBorder(BorderFactory.createEmptyBorder(0, MARGE, MARGE, MARGE));
        bas.add(point, BorderLayout.CENTER);
        bas.add(etat, BorderLayout.PAGE_END);
        // la place du texte est fixe : le graphique ne bouge pas sous la souris
        bas.setPreferredSize(new Dimension(0, LIGNES * point.getFontMetrics(point.getFont()).getHeight() + MARGE));
        add(graphique, BorderLayout.CENTER);
        add(bas, BorderLayout.PAGE_END);
        controleur.prevenir(this::suivre);
        addHierarchyListener(e -> suivre());
    }

    /** Un échelon dessiné, et son dessin, ou {@code null} si son image n'est plus gardée. */
    private static final class Dessine extends GraphiqueVitesse.Reglage {

        final Reglages reglages;
        volatile Dessin dessin;

        Dessine(Dessin dessin, long dureeNs, Mesure mesure) {
            super(nom(dessin.demande.reglages), Echelle.dire(dessin.demande.reglages),
                    dureeNs / 1e9, mesure.erreur, mesure.incertitude);
            reglages = dessin.demande.reglages;
            this.dessin = dessin;
        }

        private static String nom(Reglages echelon) {
            int reflets = echelon.getProfondeur();
            if (echelon.getEssayee() == null) {
                return reflets + (reflets > 1 ? " réflexions" : " réflexion");
            }
            Section section = echelon.getSectionEntiere(echelon.getEssayee());
            return "1".equals(section.valeur("n")) ? "un rayon" : section.toString()
                    .replaceFirst("\\[.*] ", "").replaceFirst("(.*)methode=(\\S+) ?(.*)", "$2 $1$3").trim();
        }
    }

    /** Les mesures d'une scène, faites dans le fil des mesures, et lues dans celui des événements. */
    private final class Mesures {

        final List<Object> cle;
        volatile String texte = "";
        final List<Dessine> dessines = new CopyOnWriteArrayList<>();
        volatile Dessine ici;
        private Dessin prepare;
        private List<Reglages> echelle;
        private Echantillon echantillon;

        Mesures(List<Object> cle) {
            this.cle = cle;
        }

        private void dire(String nouveau) {
            texte = nouveau;
            EventQueue.invokeLater(PanneauVitesse.this::suivre);
        }

        /** Continue les mesures, d'abord celle de l'image montrée. @param mesurable vrai si c'en est une, sans faute */
        void continuer(Dessin montre, boolean mesurable) {
            if (echantillon == null) {
                dire("préparation…");
                preparer(montre);
            }
            if (ici == null || ici.dessin != montre) {
                ici = dessines.stream().filter(d -> d.dessin == montre).findFirst().orElse(null);
            }
            if (ici == null && mesurable) {
                ici = new Dessine(montre, montre.lancer.getDureeNs(), echantillon.essayer(montre.demande.reglages));
            }
            while (dessines.size() < echelle.size()) {
                dire("dessin de l'échelon " + (dessines.size() + 1) + " sur " + echelle.size() + "…");
                dessiner(echelle.get(dessines.size()));
            }
            dire("Un clic sur un point montre son image (ou flèches, et Entrée)."
                    + (prepare.image.largeur == montre.image.largeur ? ""
                    : " Images de " + prepare.image.largeur + " × " + prepare.image.hauteur + " pixels.")
                    + (echelle.get(0).getEssayee() != null ? "" : " antialias.jar apporte d'autres réglages."));
        }

        private void preparer(Dessin montre) {
            prepare = montre;
            double part = Math.sqrt(PIXELS / montre.image.largeur / montre.image.hauteur);
            if (part < 1) {
                prepare = new Dessin(montre.demande.avecTaille((int) Math.ceil(part * montre.image.largeur),
                        (int) Math.ceil(part * montre.image.hauteur)));
            }
            echelle = Echelle.de(montre.demande.reglages, false, false);
            echantillon = new Echantillon(prepare.lancer, controleur.fils,
                    prepare == montre ? rang -> couleur(montre.image.codes[rang]) : null, VOULUE, Long.MAX_VALUE,
                    new SplittableRandom(1), new BitSet());
        }

        private Couleur couleur(int code) {
            return new Couleur((code >> 16 & 0xFF) / 255.0, (code >> 8 & 0xFF) / 255.0, (code & 0xFF) / 255.0);
        }

        private void dessiner(Reglages echelon) {
            Dessin dessin = prepare.avecReglages(echelon);
            List<Long> durees = new ArrayList<>();
            for (long duree = dessines.size() < 2 ? -AVANT_NS : 0; duree < DUREE_NS;
                    duree += dessin.lancer.getDureeNs()) {
                dessin.lancer.TracerPixels((couleur, xe, ye) -> {
                    dessin.image.drawPixel(couleur, xe, ye);
                    echantillon.drawPixel(couleur, xe, ye);
                }, echelon.getProfondeur(), controleur.fils);
                durees.add(dessin.lancer.getDureeNs());
            }
            dessin.finirBrouillon();
            // comme --repeter : les premiers dessins ne comptent pas
            durees.subList(0, durees.size() / 2).clear();
            Collections.sort(durees);
            dessines.add(new Dessine(dessin, durees.get((durees.size() - 1) / 2), echantillon.mesurer()));
            // les premières images oubliées sont les plus rapides à dessiner de nouveau
            int gardes = Math.max(1, PIXELS_GARDES / dessin.image.codes.length);
            dessines.stream().limit(Math.max(0, dessines.size() - gardes)).forEach(d -> d.dessin = null);
        }
    }

    /** Ce dont dépendent les mesures : les objets, la taille, l'étape, et les variantes qu'elles ne règlent pas. */
    private List<Object> cle(Dessin montre) {
        Reglages reglages = montre.demande.reglages;
        // un fichier relu sans changement garde les mesures
        List<Object> cle = new ArrayList<>(Arrays.asList(controleur.etat.estDeplace()
                ? montre.demande.lecture.scene.getObjets()
                : montre.demande.lecture.fichier + " " + controleur.etat.lecture.version, montre.image.largeur,
                montre.image.hauteur, reglages.getEtape()));
        reglages.getVariantes().stream().filter(reglages::estBranchee).forEach(variante -> cle.add(
                variante.equals(reglages.getEssayee()) ? variante.getSection()
                : reglages.getSection(variante).toString()));
        return cle;
    }

    /** Montre les mesures, et les commence, les continue ou les interrompt. */
    private void suivre() {
        Dessin montre = controleur.etat.montre;
        boolean libre = isShowing() && montre != null && !controleur.etat.enCours
                && controleur.etat.getImageEntiere() == montre.image;
        if (travail != null && !libre) {
            travail.cancel(true);
            travail = null;
        }
        if (libre && !cle(montre).equals(mesures.cle)) {
            mesures = new Mesures(cle(montre));
        }
        graphique.montrer(mesures.dessines, mesures.ici);
        etat.setText(montre == null ? "Pas encore d'image : l'échelle commencera avec elle." : mesures.texte);
        if (libre && travail == null) {
            Mesures celles = mesures;
            boolean mesurable = montre.demande.vue == null && controleur.direFautes() == null;
            travail = Controleur.confier(fil, () -> celles.continuer(montre, mesurable),
                    panne -> etat.setText("Mesure impossible : " + panne));
        }
    }

    /** Montre l'image du point choisi si elle est gardée ; sinon, la dessine. */
    void montrerChoisi() {
        Dessine voulu = (Dessine) graphique.getChoisi();
        Dessin dessin = voulu.dessin;
        if (dessin == null || dessin.image.largeur != controleur.etat.montre.image.largeur) {
            controleur.dessiner(voulu.reglages);
        } else {
            controleur.montrer(dessin);
        }
    }
}
