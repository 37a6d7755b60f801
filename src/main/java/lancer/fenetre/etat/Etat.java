package lancer.fenetre.etat;

import java.io.File;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.Lampe;
import lancer.commande.Couple;
import lancer.contrat.PixelFautif;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.image.ImageMemoire;
import lancer.inspection.Segment;
import lancer.scene.SceneLue;
import lancer.scene.Surveillance;
import lancer.scene.TexteScene;
import lancer.texte.Texte;

/** Tout ce que la fenêtre montre, et tout ce qui s'y perdrait. Immuable : {@link Suite} en fait un autre. */
public final class Etat {

    /** Le plus grand nombre de pixels d'une image « avant » gardée. */
    private static final int PIXELS_GARDES = 16_000_000;

    private static final boolean MAC = Texte.minuscules(System.getProperty("os.name", "")).startsWith("mac");

    public final Source source;
    /** Ce qui est demandé de la scène montrée, changements compris ; {@code null} avant la première. */
    public final Demande demande;
    /** Ce que contient le fichier de la scène montrée ; {@code null} avant la première. */
    public final Ecrite ecrite;
    /** Le dernier travail commencé, ou {@code null}. */
    public final Travail travail;
    public final Montre montre;
    /** L'écriture en cours, ou {@code null}. */
    final Ecriture ecriture;
    /** Ce qui se fera une fois dit que faire des changements ; {@code null} si rien n'est demandé. */
    final Apres question;
    /** Ce qui est tiré, ou {@code null}. */
    public final Geste geste;
    /** Les changements à défaire, le dernier en tête, ou {@code null}. */
    final Pile annulables;
    public final Avis avis;
    public final Ecran ecran;
    public final Explication explication;
    public final Mesures mesures;
    /** Celui du dernier ordre. */
    final int numero;

    private Etat(Changement c) {
        source = c.source;
        demande = c.demande;
        ecrite = c.ecrite;
        travail = c.travail;
        montre = c.montre;
        ecriture = c.ecriture;
        question = c.question;
        geste = c.geste;
        annulables = c.annulables;
        avis = c.avis;
        ecran = c.ecran;
        explication = c.explication;
        mesures = c.mesures;
        numero = c.numero;
    }

    /** Celui d'une fenêtre sans scène. @param police taille des textes, en points */
    public static Etat vide(int largeur, int hauteur, int police) {
        return new Etat(new Changement() { }.vider(new Ecran(null, null, null, false, false,
                new Loupe(largeur, hauteur), police), largeur, hauteur));
    }

    /** Un état que l'on change : chaque champ y a le sens qu'il a dans {@link Etat}. */
    abstract static class Changement {

        Source source;
        Demande demande;
        Ecrite ecrite;
        Travail travail;
        Montre montre;
        Ecriture ecriture;
        Apres question;
        Geste geste;
        Pile annulables;
        Avis avis;
        Ecran ecran;
        Explication explication;
        Mesures mesures;
        int numero;

        Changement vider(Ecran vide, int largeur, int hauteur) {
            source = new Source(null, null, null, null, null);
            montre = new Montre(null, false, null, false, new Couple(largeur, hauteur));
            avis = Avis.AUCUN;
            ecran = vide;
            explication = Explication.AUCUNE;
            mesures = Mesures.AUCUNES;
            return this;
        }

        void copier(Etat e) {
            source = e.source;
            demande = e.demande;
            ecrite = e.ecrite;
            travail = e.travail;
            montre = e.montre;
            ecriture = e.ecriture;
            question = e.question;
            geste = e.geste;
            annulables = e.annulables;
            avis = e.avis;
            ecran = e.ecran;
            explication = e.explication;
            mesures = e.mesures;
            numero = e.numero;
        }

        /** L'état ainsi changé. */
        Etat etat() {
            return new Etat(this);
        }
    }

    /** Dit si rien ne les distingue. */
    boolean estComme(Etat autre) {
        return Arrays.equals(parties(), autre.parties());
    }

    private Object[] parties() {
        return new Object[] {source, demande, ecrite, travail, montre, ecriture, question, geste, annulables, avis,
            ecran, explication, mesures, numero};
    }

    /** Le fichier de la scène demandée en dernier, même fautif : celui du titre, de F5 et de la surveillance. */
    static final class Source {

        final String fichier;
        /** La version qui a été lue, ou écrite par cette fenêtre ; {@code null} si elle n'est pas connue. */
        final String version;
        /** Ce qui a échoué avec cette version ; {@code null} si rien. */
        final String faute;
        /** Celle qui n'est pas lue, parce qu'un changement n'est pas écrit ; {@code null} s'il n'y en a pas. */
        final String nouvelle;
        /** La scène d'un autre fichier, que celle de ce fichier remplacera, changements compris ; ou {@code null}. */
        final SceneLue quittee;

        Source(String fichier, String version, String faute, String nouvelle, SceneLue quittee) {
            this.fichier = fichier;
            this.version = version;
            this.faute = faute;
            this.nouvelle = nouvelle;
            this.quittee = quittee;
        }

        Source nouvelle(String autre) {
            return new Source(fichier, version, faute, autre, quittee);
        }

        Source lue(String celle, String pourquoi) {
            return new Source(fichier, celle, pourquoi, null, quittee);
        }
    }

    /** Une scène, et le texte du fichier qui la contient. */
    static final class Ecrite {

        final SceneLue lue;
        final TexteScene texte;

        Ecrite(SceneLue lue, TexteScene texte) {
            this.lue = lue;
            this.texte = texte;
        }
    }

    /** L'image montrée. */
    public static final class Montre {

        /** Le dessin de l'image ou du brouillon, ou {@code null}, et vrai si cette image est achevée. */
        public final Dessin dessin;
        final boolean entier;
        /** Le dessin achevé avant le dernier changement ; {@code null} s'il n'y en a pas, ou s'il est trop grand. */
        public final Dessin avant;
        /** Vrai tant qu'est tenue la touche qui montre l'image d'avant. */
        public final boolean tenue;
        /** Celle que demande la ligne de commande. */
        final Couple taille;

        Montre(Dessin dessin, boolean entier, Dessin avant, boolean tenue, Couple taille) {
            this.dessin = dessin;
            this.entier = entier;
            this.avant = avant;
            this.tenue = tenue;
            this.taille = taille;
        }

        Montre avec(Dessin autre, boolean acheve) {
            return new Montre(autre, acheve, avant, tenue, taille);
        }

        Montre tenir(boolean pressee) {
            return pressee == tenue ? this : new Montre(dessin, entier, avant, pressee, taille);
        }

        /** L'image achevée devient celle d'avant, sauf si elle est trop grande ou si c'est une vue. */
        Montre retenu() {
            if (!entier || dessin.demande.vue != null || avant == dessin) {
                return this;
            }
            Dessin garde = dessin.image.codes.length <= PIXELS_GARDES ? dessin : null;
            return new Montre(dessin, true, garde, tenue && garde != null, taille);
        }

        /** Phrase qui donne le nombre de pixels fautifs ; {@code null} s'il n'y en a pas. */
        String direFautes() {
            return dessin == null ? null : dessin.lancer.getAtelier().getFautes().enMots();
        }
    }

    /** Ce qui se fait quand les changements sont écrits, ou oubliés. */
    static final class Apres {

        static final Apres RIEN = new Apres(null);
        static final Apres QUITTER = new Apres(null);

        /** Le fichier à lire, ou {@code null}. */
        final String fichier;

        Apres(String fichier) {
            this.fichier = fichier;
        }
    }

    /** Une écriture en cours : la scène que contiendra le fichier, et ce qui se fera ensuite. */
    static final class Ecriture {

        final int numero;
        final SceneLue voulue;
        final Apres ensuite;

        Ecriture(int numero, SceneLue voulue, Apres ensuite) {
            this.numero = numero;
            this.voulue = voulue;
            this.ensuite = ensuite;
        }
    }

    /** Ce que tire la souris : sa section, sa clé, la scène d'avant, et le point de l'image d'où il est tiré. */
    public static final class Geste {

        final String section;
        final SceneLue avant;
        final double xe;
        final double ye;
        /** Sa nouvelle place, en mots. */
        public final String place;

        Geste(String section, SceneLue avant, double xe, double ye, String place) {
            this.section = section;
            this.avant = avant;
            this.xe = xe;
            this.ye = ye;
            this.place = place;
        }

        Object getChose() {
            return avant.getChose(section);
        }

        String getCle() {
            return getChose() instanceof Lampe ? "position" : "centre";
        }
    }

    /** Les scènes d'avant chaque changement. */
    static final class Pile {

        final SceneLue scene;
        /** Le champ dont les flèches ont fait ce changement, ou {@code null}. */
        final String champ;
        final Pile reste;

        Pile(SceneLue scene, String champ, Pile reste) {
            this.scene = scene;
            this.champ = champ;
            this.reste = reste;
        }
    }

    /** Ce que dit le bandeau, outre les fautes. */
    public static final class Avis {

        /** Combien de temps il se lit. */
        enum Sorte { PASSAGER, RETENU, REFUS }

        static final Avis AUCUN = new Avis("", Sorte.PASSAGER, Collections.emptyList());

        /** D'une ou de plusieurs lignes ; vide s'il n'y en a pas. */
        public final String texte;
        final Sorte sorte;
        /** Les fautes dont un clic a fermé le message. */
        final List<String> lues;

        Avis(String texte, Sorte sorte, List<String> lues) {
            this.texte = texte;
            this.sorte = sorte;
            this.lues = lues;
        }

        Avis dire(String autre, Sorte comment) {
            return new Avis(autre, comment, lues);
        }

        /** Dit s'il s'efface de lui-même. */
        public boolean passe() {
            return sorte != Sorte.RETENU;
        }
    }

    /** Ce qui est ouvert, choisi et grossi. */
    public static final class Ecran {

        /** L'onglet ouvert, ou {@code null}. */
        public final Onglet onglet;
        /** Le pixel expliqué, ou {@code null}. */
        public final Pixel pixel;
        /** La section choisie par son étoile ; {@code null} pour celle du pixel. */
        final String choisie;
        /** Vrai si tout le détail du pixel est déplié. */
        public final boolean tout;
        /** Vrai si l'image remplit sa place. */
        public final boolean remplie;
        public final Loupe loupe;
        /** La taille des textes, en points. */
        public final int police;

        Ecran(Onglet onglet, Pixel pixel, String choisie, boolean tout, boolean remplie, Loupe loupe, int police) {
            this.onglet = onglet;
            this.pixel = pixel;
            this.choisie = choisie;
            this.tout = tout;
            this.remplie = remplie;
            this.loupe = loupe;
            this.police = police;
        }

        Ecran montrer(Onglet autre) {
            return autre == onglet ? this : new Ecran(autre, pixel, choisie, tout, remplie, loupe, police);
        }

        Ecran expliquer(Pixel autre) {
            return new Ecran(Onglet.PIXEL, autre, null, tout, remplie, loupe, police);
        }

        Ecran choisir(String section) {
            return new Ecran(onglet, pixel, section, tout, remplie, loupe, police);
        }

        Ecran deplier() {
            return new Ecran(onglet, pixel, choisie, !tout, remplie, loupe, police);
        }

        Ecran remplir() {
            return new Ecran(onglet, pixel, choisie, tout, !remplie, loupe, police);
        }

        Ecran avec(Loupe autre) {
            return autre == loupe ? this : new Ecran(onglet, pixel, choisie, tout, remplie, autre, police);
        }

        Ecran avecPolice(int taille) {
            return new Ecran(onglet, pixel, choisie, tout, remplie, loupe, taille);
        }
    }

    /** Une touche de commande, comme cette machine l'appelle : « Ctrl+E ». */
    public static String ctrl(String touche) {
        return (MAC ? "⌘" : "Ctrl+") + touche;
    }

    /** Le nom, sans dossier, du fichier de la scène montrée. */
    public String getNom() {
        return Texte.echappe(new File(demande.lue.nom).getName());
    }

    /** Le fichier demandé, ou {@code null}. */
    public String getFichier() {
        return source.fichier;
    }

    /** Le titre du cadre. @param programme le nom du programme et de ses variantes */
    public String getTitre(String programme) {
        String titre = source.fichier == null ? programme : programme + " — " + new File(source.fichier).getName();
        String deplace = montreUneAutre() ? " (" + getNom() + " •)" : " •";
        return estDeplace() ? titre + deplace : titre;
    }

    /** Dit si l'image montrée est d'une autre scène que celle qui est demandée. */
    public boolean montreUneAutre() {
        return demande != null && !demande.lue.nom.equals(source.fichier);
    }

    /** Dit si un changement n'est pas dans le fichier de la scène montrée. */
    public boolean estDeplace() {
        return demande != null && demande.lue != ecrite.lue;
    }

    public boolean aUneScene() {
        return demande != null;
    }

    public boolean enCours() {
        return travail != null && travail.enCours();
    }

    /** Dit si le fichier se lit : sa scène n'est pas encore montrée. */
    boolean seLit() {
        return enCours() && travail.aLire != null;
    }

    /** Ce qui interdit de changer la scène, en un mot ; {@code null} si rien. */
    public String getOccupation() {
        String lecture = seLit() ? "lecture" : null;
        return ecriture != null ? "écriture" : lecture;
    }

    public boolean peutDefaire() {
        return geste != null || annulables != null;
    }

    /** Dit si Échap a quelque chose à lâcher, à arrêter ou à fermer. */
    public boolean peutEchapper() {
        return enCours() || geste != null || ecran.onglet != null;
    }

    /** Le dessin dont se voit l'image : celui d'avant, tant que sa touche est tenue ; {@code null} avant le premier. */
    public Dessin getVisible() {
        return montre.tenue ? montre.avant : montre.dessin;
    }

    /** L'image montrée si elle est achevée, même si un autre dessin est commencé ; {@code null} sinon. */
    public ImageMemoire getImageEntiere() {
        return montre.entier ? montre.dessin.image : null;
    }

    /** Dit si les couleurs de l'image visible ne sont pas définitives. */
    public boolean estUnBrouillon() {
        return !montre.tenue && !montre.entier;
    }

    /** Les nombres de ce pixel de l'image visible ; vide dans le brouillon d'une vue, qui n'a pas les siens. */
    public String direLePixel(int k) {
        return estUnBrouillon() && getVisible().demande.vue != null ? "" : getVisible().image.dire(k);
    }

    /** La section choisie ou, à défaut, du premier contact du pixel expliqué ; {@code null} s'il n'y en a pas. */
    public String getSectionChoisie() {
        if (demande == null || demande.lue.getChose(ecran.choisie) != null) {
            return demande == null ? null : ecran.choisie;
        }
        List<Segment> segments = explication.faite == null || explication.faite.inspection == null
                ? Collections.emptyList() : explication.faite.inspection.getSegments();
        boolean touche = !segments.isEmpty() && segments.get(0).contact != null;
        String nom = !touche ? null
                : explication.faite.dessin.demande.lue.getNomDeSection(segments.get(0).contact.objet);
        return nom == null || demande.lue.getChose(nom) == null ? null : nom;
    }

    /** Ce qui a changé sur le disque et n'est pas lu, en une phrase ; vide si rien. */
    public String getAlerte() {
        if (source.nouvelle == null) {
            return "";
        }
        String change = Texte.echappe(new File(source.fichier).getName())
                + " a changé sur le disque ; F5 le relit et oublie ce que vous avez changé";
        if (montreUneAutre()) {
            return change + " dans " + getNom() + ", " + ctrl("E") + " l'y écrit d'abord";
        }
        return source.nouvelle.equals(Surveillance.ABSENT)
                ? getNom() + " n'est plus sur le disque ; " + ctrl("E") + " écrit la scène dans un autre fichier"
                : change + ", " + ctrl("E") + " l'écrit dans le nouveau fichier";
    }

    /** Ce qui a échoué et dont un clic n'a pas fermé le message, une ligne chacun. */
    public List<String> getFautesALire() {
        return getFautes().equals(avis.lues) ? Collections.emptyList() : getFautes();
    }

    /** Ce qui a échoué, une ligne chacun : du fichier demandé, puis du dessin. */
    List<String> getFautes() {
        List<String> fautes = new ArrayList<>();
        if (source.faute != null) {
            fautes.add(source.faute);
            if (montreUneAutre()) {
                fautes.add("l'image qui reste est celle de " + getNom());
            }
        }
        if (travail != null && travail.faute != null) {
            fautes.add(travail.faute);
        } else if (montre.direFautes() != null && (montre.entier || !enCours())) {
            PixelFautif premier = montre.dessin.lancer.getAtelier().getFautes().getPremiere();
            fautes.add(montre.direFautes() + " ; le premier : "
                    + montre.dessin.demande.nommer(premier).getMessage());
        }
        return fautes;
    }

    /** Ce qui empêche de mesurer l'image, en mots ; {@code null} si rien. */
    String direLEmpechement() {
        if (enCours()) {
            return "Les mesures reprendront après ce dessin.";
        }
        if (!montre.entier || montre.dessin.demande.lue != demande.lue) {
            return "Pas d'image achevée à mesurer ; F5 la dessine.";
        }
        if (montre.direFautes() != null) {
            return "Image non mesurée : " + montre.direFautes() + ".";
        }
        return montre.dessin == mesures.dessin ? mesures.arret : null;
    }

    /** Où en sont les mesures, ou ce qui les empêche ; puis celle du réglage désigné. */
    public String direLesMesures() {
        String empechement = direLEmpechement();
        Essai designe = mesures.essais.get(mesures.vise);
        return (empechement == null ? mesures.dire() : empechement) + (designe == null || !designe.estFait() ? ""
                : "\n" + designe.direLeReglage() + " : " + designe.dire());
    }

    /** Ce qui se tire, où en est le travail ou, s'il est achevé, ce qu'est l'image. */
    public String getResume() {
        if (geste != null) {
            return geste.place;
        }
        if (montre.tenue) {
            return "avant : " + resumer(montre.avant);
        }
        if (ecriture != null) {
            return "écriture";
        }
        if (montre.entier && !enCours()) {
            return resumer(montre.dessin);
        }
        return travail == null ? "" : travail.getTexte();
    }

    /** Les sections changées, à mettre dans le fichier de scène, et la commande, qui donnent cette image. */
    public String direLesReglages() {
        StringBuilder texte = new StringBuilder();
        demande.reglages.getSectionsChangees().forEach(section -> texte.append(section.ecrire("\n")).append("\n\n"));
        return texte + "; " + demande.getCommande("");
    }

    /** La taille de l'image, son coût, ses réglages, ses fautes. */
    private String resumer(Dessin dessin) {
        ImageMemoire image = dessin.image;
        double reduction = ecran.loupe.getReduction(image);
        String texte = (dessin.demande.vue == null ? "" : "vue " + dessin.demande.vue + ", ") + image.largeur + " × "
                + image.hauteur + " pixels";
        if (reduction < 1) {
            texte += " montrés à " + (int) (100 * reduction) + " %";
        } else if (reduction > 1) {
            texte += " à la loupe × " + Math.round(reduction);
        }
        String fautes = dessin.lancer.getAtelier().getFautes().enMots();
        return texte + ", " + dessin.getCout() + ", " + dessin.demande.reglages + (fautes == null ? "" : ", " + fautes);
    }

    /** La taille à dessiner : celle que demande la ligne de commande ou, si elle la remplit, de la place de l'image. */
    Couple getTaille() {
        return ecran.remplie ? ecran.loupe.remplir(montre.taille) : montre.taille;
    }
}
