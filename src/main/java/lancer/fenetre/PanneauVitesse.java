package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import lancer.Lancer;
import lancer.auto.Echantillon;
import lancer.auto.Echelon;
import lancer.auto.Mesure;
import lancer.commande.Etape;
import lancer.dessin.Dessin;
import lancer.dessin.ReglagesDessin;
import lancer.fenetre.figures.GraphiqueVitesse;
import lancer.image.ImageMemoire;

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
    /** Racine du nombre de rayons d'une référence. */
    private static final int COTE = 6;
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

        final ReglagesDessin reglages;
        volatile Dessin dessin;

        Dessine(Echelon echelon, Dessin dessin, Mesure mesure) {
            super(nom(echelon), echelon.toString(), dessin.getLancer().getDureeNs() / 1e9, mesure.erreur,
                    mesure.incertitude);
            reglages = dessin.getReglages();
            this.dessin = dessin;
        }

        private static String nom(Echelon echelon) {
            return echelon.section == null ? echelon.reflets + (echelon.reflets > 1 ? " réflexions" : " réflexion")
                    : "1".equals(echelon.section.valeur("n")) ? "un rayon" : echelon.section.toString()
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
        private List<Echelon> echelle;
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
                ReglagesDessin siens = montre.getReglages();
                Echelon present = new Echelon(siens.getSectionEssayee(),
                        montre.getScene().getModele().getEchantillonnage(), siens.getProfondeur(), siens.getSeuil());
                ici = new Dessine(present, montre, echantillon.essayer(present));
            }
            while (dessines.size() < echelle.size()) {
                dire("dessin de l'échelon " + (dessines.size() + 1) + " sur " + echelle.size() + "…");
                dessiner(echelle.get(dessines.size()), montre.getReglages());
            }
            dire("Un clic sur un point montre son image (ou flèches, et Entrée)."
                    + (prepare.largeur == montre.largeur ? ""
                    : " Images de " + prepare.largeur + " × " + prepare.hauteur + " pixels.")
                    + (echelle.get(0).section != null ? "" : " antialias.jar apporte d'autres réglages."));
        }

        private void preparer(Dessin montre) {
            prepare = montre;
            double part = Math.sqrt(PIXELS / montre.largeur / montre.hauteur);
            if (part < 1) {
                prepare = montre.avec((int) Math.ceil(part * montre.largeur), (int) Math.ceil(part * montre.hauteur));
                prepare.preparer(prepare.largeur, prepare.hauteur);
            }
            ReglagesDessin siens = montre.getReglages();
            echelle = Echelon.echelle(prepare.getScene().getModele(), siens.getEssayees(),
                    siens.getEtape() == Etape.REFLETS ? null : 0, null);
            echantillon = new Echantillon(prepare.getLancer(), controleur.fils, 2, COTE, new SplittableRandom(1),
                    new BitSet());
        }

        private void dessiner(Echelon echelon, ReglagesDessin presents) {
            ReglagesDessin voulus = presents.avec(echelon.reflets, echelon.seuil);
            if (echelon.section != null) {
                voulus = voulus.avec(voulus.getVariante(echelon.section.nom), echelon.section);
            }
            ImageMemoire image = new ImageMemoire(prepare.largeur, prepare.hauteur, true);
            List<Lancer> lancers = new ArrayList<>();
            for (long duree = dessines.size() < 2 ? -AVANT_NS : 0; duree < DUREE_NS;
                    duree += lancers.get(lancers.size() - 1).getDureeNs()) {
                lancers.add(echelon.lancer(prepare.getLancer()));
                lancers.get(lancers.size() - 1).TracerPixels((couleur, xe, ye) -> {
                    image.drawPixel(couleur, xe, ye);
                    echantillon.drawPixel(couleur, xe, ye);
                }, echelon.reflets, controleur.fils);
            }
            // comme --repeter : les premiers dessins ne comptent pas
            lancers.subList(0, lancers.size() / 2).clear();
            lancers.sort(Comparator.comparingLong(Lancer::getDureeNs));
            Dessin dessin = prepare.dessine(voulus, image, lancers.get((lancers.size() - 1) / 2));
            dessines.add(new Dessine(echelon, dessin, echantillon.mesurer()));
            // les premières images oubliées sont les plus rapides à dessiner de nouveau
            int gardes = Math.max(1, PIXELS_GARDES / image.codes.length);
            dessines.stream().limit(Math.max(0, dessines.size() - gardes)).forEach(d -> d.dessin = null);
        }
    }

    /** Ce dont dépendent les mesures : les objets, la taille, l'étape, et les variantes qu'elles ne règlent pas. */
    private List<Object> cle(Dessin montre) {
        ReglagesDessin reglages = montre.getReglages();
        // un fichier relu sans changement garde les mesures
        List<Object> cle = new ArrayList<>(Arrays.asList(controleur.etat.estDeplace() ? montre.getScene().getObjets()
                : montre.fichier + " " + controleur.etat.lecture.version, montre.largeur, montre.hauteur,
                reglages.getEtape()));
        reglages.getVariantes().stream().filter(reglages::estBranchee).forEach(variante -> cle.add(
                reglages.getEssayees().containsKey(variante) ? variante.getSection()
                : reglages.getSection(variante).toString()));
        return cle;
    }

    /** Montre les mesures, et les commence, les continue ou les interrompt. */
    private void suivre() {
        Dessin montre = controleur.etat.montre;
        boolean libre = isShowing() && montre != null && !controleur.etat.enCours
                && controleur.etat.getImageEntiere() == montre.getImage();
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
            boolean mesurable = montre.getVue() == null && controleur.direFautes() == null;
            travail = Controleur.confier(fil, () -> celles.continuer(montre, mesurable),
                    panne -> etat.setText("Mesure impossible : " + panne));
        }
    }

    /** Montre l'image du point choisi si elle est gardée ; sinon, la dessine. */
    void montrerChoisi() {
        Dessine voulu = (Dessine) graphique.getChoisi();
        Dessin dessin = voulu.dessin;
        if (dessin == null || dessin.largeur != controleur.etat.montre.largeur) {
            controleur.dessiner(voulu.reglages);
        } else {
            controleur.montrer(dessin);
        }
    }
}
