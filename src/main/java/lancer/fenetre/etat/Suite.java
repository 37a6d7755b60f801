package lancer.fenetre.etat;

import java.io.File;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.NavigableSet;
import java.util.Objects;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import lancer.Lancer;
import lancer.Point;
import lancer.SceneFautive;
import lancer.commande.Etape;
import lancer.commande.Messages;
import lancer.commande.Couple;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.contrat.Parametre;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.fenetre.etat.Etat.Apres;
import lancer.fenetre.etat.Etat.Avis.Sorte;
import lancer.fenetre.etat.Etat.Ecrite;
import lancer.fenetre.etat.Etat.Ecriture;
import lancer.fenetre.etat.Etat.Geste;
import lancer.fenetre.etat.Etat.Pile;
import lancer.fenetre.etat.Etat.Source;
import lancer.fenetre.etat.Travail.Fin;
import lancer.image.ImageMemoire;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.scene.SceneLue;
import lancer.scene.TexteScene;
import lancer.texte.Texte;

/**
 * L'état qui suit un événement, et ses ordres : la seule façon de changer d'état. Chaque méthode publique est ce qui
 * arrive : une touche, un geste, une réponse du moteur. Une suite sert une fois ; {@link #apres} la fait.
 */
public final class Suite extends Etat.Changement {

    private static final NavigableSet<Integer> REFLEXIONS = new TreeSet<>(Arrays.asList(0, 1, 2, 5, 10));
    private static final int POLICE_MIN = 10;
    private static final int POLICE_MAX = 32;

    private final Etat avant;
    private final List<Ordre> ordres = new ArrayList<>();

    private Suite(Etat avant) {
        this.avant = avant;
        copier(avant);
    }

    /** Ce qui arrive à la fenêtre. */
    public interface Evenement {
        void arriver(Suite suite);
    }

    /** Ce qui suit cet événement. Le même état et le même événement donnent toujours la même suite. */
    public static Suite apres(Etat avant, Evenement evenement) {
        Suite suite = new Suite(avant);
        evenement.arriver(suite);
        suite.accorder();
        return suite;
    }

    /** Une réponse du moteur. Celle d'un ordre qui n'est plus le présent est laissée. */
    public static Evenement reponse(int numero, Evenement reponse) {
        return suite -> {
            if (suite.attend(numero)) {
                reponse.arriver(suite);
            }
        };
    }

    private boolean attend(int celui) {
        return travail != null && travail.enCours() && celui == travail.numero
                || ecriture != null && celui == ecriture.numero
                || celui == explication.numero || celui == mesures.numero;
    }

    /** L'état qui suit ; le même si rien n'a changé. */
    public Etat getEtat() {
        Etat suivant = etat();
        return suivant.estComme(avant) ? avant : suivant;
    }

    public List<Ordre> getOrdres() {
        return ordres;
    }

    private void dire(String texte, Sorte sorte) {
        avis = avis.dire(texte, sorte);
    }

    private void dire(String texte) {
        dire(texte, Sorte.PASSAGER);
    }

    // ce qui se lit et se dessine

    /** La première scène, déjà lue, s'ouvre. */
    public void montrerLaPremiere(Demande lue) {
        source = new Source(lue.lue.nom, lue.lue.getTexte().getVersion(), null, null, null);
        adopter(lue);
        ordres.add((moteur, vue) -> moteur.surveiller(lue.lue.nom));
    }

    /** Demande quelle scène ouvrir. */
    public void choisirUneScene() {
        String presente = source.fichier;
        ordres.add((moteur, vue) -> vue.choisirUneScene(presente));
    }

    /** Ouvre cette scène, une fois que les changements de celle-ci sont écrits, ou que l'on y renonce. */
    public void ouvrir(String fichier) {
        sansRienPerdre(new Apres(fichier));
    }

    public void quitter() {
        sansRienPerdre(Apres.QUITTER);
    }

    private void sansRienPerdre(Apres ensuite) {
        if (question != null) {
            return;
        }
        if (ecriture != null) {
            ecriture = new Ecriture(ecriture.numero, ecriture.voulue, ensuite);
            return;
        }
        lacherLeGeste();
        if (etat().estDeplace()) {
            question = ensuite;
            String nom = etat().getNom();
            ordres.add((moteur, vue) -> vue.demanderDEcrire(nom));
        } else {
            faire(ensuite);
        }
    }

    /** Réponse à ce qui est demandé des changements : les écrire. */
    public void accepterDEcrire() {
        Apres ensuite = question;
        question = null;
        if (etat().seLit()) {
            arreter();
        }
        if (etat().estDeplace()) {
            commencerLEcriture(ensuite);
        } else {
            faire(ensuite);
        }
    }

    /** De même : les oublier. */
    public void oublier() {
        Apres ensuite = question;
        question = null;
        faire(ensuite);
    }

    /** De même : rester. */
    public void rester() {
        question = null;
    }

    private void faire(Apres ensuite) {
        if (ensuite == Apres.QUITTER) {
            fermer();
        } else if (ensuite != Apres.RIEN) {
            source = new Source(ensuite.fichier, null, null, null, demande == null ? null : demande.lue);
            ordres.add((moteur, vue) -> moteur.surveiller(ensuite.fichier));
            lire();
        }
    }

    /** Ferme la fenêtre, quoi qui n'y soit pas écrit. */
    public void fermer() {
        if (etat().enCours()) {
            arreter();
        }
        ordres.add((moteur, vue) -> vue.fermer());
        ordres.add((moteur, vue) -> moteur.terminer());
    }

    /** F5 : relit le fichier, et oublie ce qui n'est pas écrit. */
    public void relire() {
        if (source.fichier == null) {
            return;
        }
        lacherLeGeste();
        if (ecriture != null) {
            ecriture = new Ecriture(ecriture.numero, ecriture.voulue, new Apres(source.fichier));
        } else {
            lire();
        }
    }

    /** Lit le fichier demandé ; ce qui en était dit le reste jusqu'à la fin de la lecture. */
    private void lire() {
        lacherLeGeste();
        source = source.lue(null, source.faute);
        montre = montre.retenu();
        avis = new Etat.Avis(avis.texte, avis.sorte, Collections.emptyList());
        String fichier = source.fichier;
        Demande present = demande;
        Travail nouveau = remplacer(new Travail(++numero, fichier, null));
        ordres.add((moteur, vue) -> moteur.lire(nouveau.numero, fichier, present, nouveau.avancement));
    }

    /** Ce travail remplace celui d'avant, qui s'arrête. */
    private Travail remplacer(Travail nouveau) {
        if (travail != null && travail.enCours()) {
            int ancien = travail.numero;
            ordres.add((moteur, vue) -> moteur.arreter(ancien));
        }
        travail = nouveau;
        return nouveau;
    }

    /** Réponse : la scène est lue, et se prépare ; elle n'a plus de faute, même si elle n'est pas encore montrée. */
    public void lue(String version, Demande celle) {
        source = source.lue(version, null);
        travail = travail.lue(celle);
    }

    /** Réponse : ce dessin est préparé, et son brouillon commence. Sans image, il se montre aussitôt. */
    public void preparer(Dessin dessin) {
        if (montre.dessin == null) {
            montrer(dessin, false);
        }
    }

    /** Réponse : chaque pixel de ce dessin a une couleur. */
    public void ebaucher(Dessin dessin) {
        travail = travail.avec(dessin, Fin.AUCUNE);
        montrer(dessin, false);
    }

    /** Réponse : ce dessin est achevé. */
    public void achever(Dessin dessin) {
        travail = travail.avec(dessin, Fin.ACHEVE);
        montrer(dessin, true);
        if (dessin.ecart != null) {
            dire(dessin.ecart);
        }
    }

    /** Réponse : le travail a échoué. @param version celle du fichier, s'il se lisait */
    public void echouer(String version, Throwable echec) {
        String faute = Messages.message(echec);
        boolean enLisant = travail.demande == null;
        if (enLisant) {
            source = source.lue(version, faute);
        }
        travail = travail.echoue(enLisant ? null : faute);
    }

    private void montrer(Dessin dessin, boolean entier) {
        if (travail.aLire != null) {
            if (avant.estDeplace()) {
                dire("ce qui était changé dans " + avant.getNom() + " sans être écrit est oublié");
            }
            adopter(travail.demande);
            travail = travail.montree();
        }
        montre = montre.avec(dessin, entier);
    }

    /** La scène montrée est désormais celle qui vient d'être lue. Les réglages changés pendant la lecture restent. */
    private void adopter(Demande lue) {
        List<String> avertissements = lue.lue.avertissements;
        if (!avertissements.isEmpty()) {
            dire(String.join("\n", avertissements) + (avis.texte.isEmpty() ? "" : "\n" + avis.texte));
        }
        try {
            demande = demande == null ? lue : demande.avecLecture(lue.lue);
        } catch (SceneFautive e) {
            demande = lue;
            dire(e.getMessage());
        }
        ecrite = new Ecrite(lue.lue, lue.lue.getTexte());
        annulables = null;
        geste = null;
    }

    /** Le fichier de ce nom est à cette version. Celle que cette fenêtre a lue ou écrite ne lui apprend rien. */
    public void voirLeFichier(String fichier, String version) {
        if (!fichier.equals(source.fichier) || etat().getOccupation() != null) {
            return;
        }
        if (source.version == null || version.equals(source.version)) {
            // d'une lecture arrêtée, la version n'est pas connue ; ou le fichier est revenu tel qu'il était
            boolean connue = source.version != null && source.nouvelle == null;
            source = connue ? source : source.lue(version, source.faute);
        } else if (!version.equals(source.nouvelle)) {
            source = source.nouvelle(version);
        }
    }

    /** Échap : lâche ce qui est tiré ou, à défaut, arrête le dessin ou la mesure ou, à défaut, ferme le panneau. */
    public void echapper() {
        if (geste != null) {
            defaire();
        } else if (etat().enCours()) {
            arreter();
        } else if (mesures.numero != 0) {
            interrompre(mesures.direLArret());
        } else {
            ecran = ecran.montrer(null);
        }
    }

    private void arreter() {
        int numeroArrete = travail.numero;
        ordres.add((moteur, vue) -> moteur.arreter(numeroArrete));
        travail = travail.arrete(demande);
    }

    // ce qui se règle

    /** Dessine la scène avec ces réglages ; s'ils sont impossibles, un avis le dit. */
    public void regler(Reglages voulus) {
        if (!voulus.equals(demande.reglages)) {
            try {
                demande = demande.avecReglages(voulus);
                montre = montre.retenu();
                oublierLeRefus();
            } catch (SceneFautive e) {
                refuser(e.getMessage());
            }
        }
    }

    /** Change ainsi les réglages. */
    public void regler(UnaryOperator<Reglages> changement) {
        regler(changement.apply(demande.reglages));
    }

    /** De même, si cette valeur de ce réglage est possible. */
    public void regler(Parametre reglage, String valeur, UnaryOperator<Reglages> changement) {
        if (reglage.accepte(valeur)) {
            oublierLeRefus();
            regler(changement);
        } else {
            String faute = valeur.isEmpty() ? "aucune valeur" : "valeur impossible, " + Texte.cite(valeur);
            refuser(reglage.getTitre() + " : " + faute + " ; attendu : " + reglage.attendu);
        }
    }

    /** Une valeur impossible a été écrite. */
    private void refuser(String message) {
        dire(message, Sorte.REFUS);
    }

    /** Une valeur possible remplace celle qui était refusée. */
    public void oublierLeRefus() {
        if (avis.sorte == Sorte.REFUS) {
            dire("");
        }
    }

    /** Montre cette vue. @param vue {@code null} pour l'image */
    public void voir(String vue) {
        demande = demande.avecVue(vue);
    }

    public void choisirLEtape(Etape etape) {
        regler(demande.reglages.avec(Option.ETAPE, etape));
    }

    /** Le nombre de réflexions suivant ; {@code null} s'il n'y en a pas, ou si l'étape n'a pas de reflets. */
    static Integer reflexions(Etat etat, boolean plus) {
        if (etat.demande == null || etat.demande.reglages.get(Option.ETAPE) != Etape.REFLETS) {
            return null;
        }
        int present = etat.demande.reglages.get(Option.REFLETS);
        return plus ? REFLEXIONS.higher(present) : REFLEXIONS.lower(present);
    }

    public static boolean peutReflechir(Etat etat, boolean plus) {
        return reflexions(etat, plus) != null;
    }

    public void reflechir(boolean plus) {
        Integer voulues = reflexions(etat(), plus);
        if (voulues != null) {
            regler(demande.reglages.avec(Option.REFLETS, voulues));
        }
    }

    // ce qui change dans la scène

    /** Dit pourquoi la scène ne peut être changée, si elle ne peut l'être. */
    private boolean refuseDeChanger() {
        String occupation = etat().getOccupation();
        if (occupation != null) {
            refuser(occupation + " du fichier : la scène ne se change pas encore");
        }
        return occupation != null || demande == null;
    }

    /** Maj et la souris prennent ce qui est là. @param portee la distance, en pixels, où se prend une étoile */
    public void saisir(double xe, double ye, double portee) {
        if (montre.dessin == null || geste != null || refuseDeChanger()) {
            return;
        }
        // un message cacherait le bas de l'image
        dire("");
        try {
            String section = Prise.viser(montre.dessin, demande.lue, xe, ye, portee);
            if (section == null) {
                dire("rien ne se tire ici ; se tirent une sphère du fichier, moins large que l'image, et "
                        + "l'étoile d'une lampe");
            } else {
                geste = new Geste(section, demande.lue, xe, ye, "");
            }
        } catch (RuntimeException panne) {
            dire(Messages.message(panne));
        }
    }

    /** La souris tire jusque-là ce qui est pris. */
    public void tirer(double xe, double ye) {
        if (geste != null) {
            Point ou = Prise.deplacer(montre.dessin.lancer.getCamera(), SceneLue.place(geste.getChose()), geste.xe,
                    geste.ye, xe, ye);
            String valeur = SceneLue.ecrire(ou);
            demande = demande.avecLecture(geste.avant.avec(geste.section, geste.getCle(), valeur));
            montre = montre.retenu();
            geste = new Geste(geste.section, geste.avant, geste.xe, geste.ye,
                    geste.avant.getOrigine(geste.getChose()) + " : " + geste.getCle() + "=" + valeur);
        }
    }

    /** La souris lâche ce qui est pris. Ce qu'elle n'a pas tiré est choisi : ses nombres se montrent. */
    public void lacher() {
        if (geste != null && geste.place.isEmpty()) {
            ecran = ecran.choisir(geste.section).montrer(Onglet.PIXEL);
            montre = montre.tenir(false);
        } else if (geste != null) {
            dire(geste.place + " ; " + Etat.ctrl("E") + " l'écrit dans " + etat().getNom());
        }
        lacherLeGeste();
    }

    private void lacherLeGeste() {
        if (geste != null && !geste.place.isEmpty()) {
            annulables = new Pile(geste.avant, null, annulables);
        }
        geste = null;
    }

    /** Rend sa place d'avant à ce qui est tiré ou, à défaut, sa valeur à ce qui a changé en dernier. */
    public void defaire() {
        if (geste == null && (annulables == null || refuseDeChanger())) {
            return;
        }
        SceneLue revenue = geste == null ? annulables.scene : geste.avant;
        annulables = geste == null ? annulables.reste : annulables;
        geste = null;
        dire("");
        if (revenue != demande.lue) {
            demande = demande.avecLecture(revenue);
            montre = montre.retenu();
        }
    }

    /** Donne cette valeur à cette clé. @param parFleche vrai si c'est d'une flèche : sa suite se défait d'un coup */
    public void changer(String section, String cle, String valeur, boolean parFleche) {
        if (refuseDeChanger()) {
            return;
        }
        lacherLeGeste();
        try {
            String champ = parFleche ? section + " " + cle : null;
            Demande voulue = demande.avecLecture(demande.lue.avec(section, cle, valeur));
            if (champ == null || annulables == null || !champ.equals(annulables.champ)) {
                annulables = new Pile(demande.lue, champ, annulables);
            }
            demande = voulue;
            montre = montre.retenu();
            // ses nombres restent, même si le pixel ne la voit plus
            ecran = ecran.choisir(section);
            oublierLeRefus();
        } catch (SceneFautive e) {
            refuser(e.getMessage());
        }
    }

    /** Ctrl+E : écrit les changements dans le fichier de leur scène. */
    public void ecrire() {
        if (etat().estDeplace() && question == null && !refuseDeChanger()) {
            commencerLEcriture(Apres.RIEN);
        }
    }

    private void commencerLEcriture(Apres ensuite) {
        lacherLeGeste();
        SceneLue voulue = demande.lue;
        Ecrite contenue = ecrite;
        ecriture = new Ecriture(++numero, voulue, ensuite);
        int celui = numero;
        ordres.add((moteur, vue) -> moteur.ecrire(celui, voulue, contenue.lue, contenue.texte));
    }

    /** Demande dans quel autre fichier écrire la scène. */
    public void demanderOuEcrire() {
        if (!refuseDeChanger() && question == null) {
            proposerUnAutreFichier(null, Apres.RIEN);
        }
    }

    private void proposerUnAutreFichier(String pourquoi, Apres ensuite) {
        question = ensuite;
        String fichier = demande.lue.nom;
        ordres.add((moteur, vue) -> vue.proposerEcrireSous(pourquoi, fichier));
    }

    /** Écrit la scène dans un autre fichier, qui s'ouvre. */
    public void ecrireSous(String fichier) {
        Apres ensuite = question;
        question = null;
        if (refuseDeChanger()) {
            return;
        }
        lacherLeGeste();
        TexteScene texte = demande.lue.ecrireDans(ecrite.texte, ecrite.lue);
        ecriture = new Ecriture(++numero, demande.lue, ensuite == Apres.RIEN ? new Apres(fichier) : ensuite);
        int celui = numero;
        ordres.add((moteur, vue) -> moteur.ecrireSous(celui, texte, fichier));
    }

    /** Réponse : la scène est écrite. @param texte ce que contient le fichier @param sous vrai si c'est un autre */
    public void ecrit(TexteScene texte, String fichier, boolean sous) {
        Ecriture faite = ecriture;
        ecriture = null;
        boolean fusion = !sous && !texte.getVersion().equals(
                faite.voulue.ecrireDans(ecrite.texte, ecrite.lue).getVersion());
        ecrite = new Ecrite(faite.voulue, texte);
        if (!sous && faite.voulue.nom.equals(source.fichier)) {
            source = source.lue(texte.getVersion(), null);
        }
        dire("écrit dans " + Texte.echappe(new File(fichier).getName()));
        faire(faite.ensuite);
        if (fusion && faite.ensuite == Apres.RIEN) {
            lire();
        }
    }

    /** Réponse : la scène n'a pu être écrite ; un autre fichier est proposé. */
    public void refuserDEcrire(String faute) {
        Apres ensuite = ecriture.ensuite;
        ecriture = null;
        dire(faute);
        proposerUnAutreFichier(faute, ensuite);
    }

    // ce qui se montre

    public void montrer(Onglet onglet) {
        montre = montre.tenir(false);
        if (demande != null || onglet == null) {
            ecran = ecran.montrer(onglet);
        }
    }

    /** F3 : montre les mesures, et les reprend si elles sont arrêtées. */
    public void mesurer() {
        montrer(Onglet.VITESSE);
        mesures = mesures.arret == null ? mesures : mesures.arretees(null);
    }

    /** Montre les rayons de ce pixel. */
    public void expliquer(Pixel pixel) {
        montre = montre.tenir(false);
        if (montre.dessin != null) {
            ImageMemoire image = montre.dessin.image;
            Pixel celui = pixel.dans(image.largeur, image.hauteur);
            ecran = ecran.expliquer(celui).avec(ecran.loupe.suivre(image, celui));
        }
    }

    /** Va au pixel situé à cette distance de celui qui est expliqué. */
    public void aller(int dx, int dy) {
        if (ecran.pixel != null) {
            expliquer(new Pixel(ecran.pixel.x + dx, ecran.pixel.y + dy));
        }
    }

    public void deplier() {
        ecran = ecran.deplier();
    }

    /** La touche qui montre l'image d'avant est tenue, ou non. */
    public void tenir(boolean pressee) {
        montre = montre.tenir(pressee && montre.avant != null);
    }

    /** Agrandit ou réduit deux fois autour de ce point de la place de l'image, en pixels de l'écran. */
    public void grossir(boolean plus, double x, double y) {
        if (etat().getVisible() != null) {
            ecran = ecran.avec(ecran.loupe.grossir(etat().getVisible().image, plus, x, y));
        }
    }

    /** De même, autour du pixel expliqué ou, à défaut, du milieu. */
    public void approcher(boolean plus) {
        Point ou = new Point(ecran.loupe.largeur / 2.0, ecran.loupe.hauteur / 2.0, 0);
        if (ecran.onglet == Onglet.PIXEL && ecran.pixel != null && montre.dessin != null) {
            ou = ecran.loupe.placeDe(montre.dessin.image, ecran.pixel.x + 0.5, ecran.pixel.y + 0.5);
        }
        grossir(plus, ou.x, ou.y);
    }

    /** À la loupe, met là ce point de l'image. */
    public void amener(Point point, double x, double y) {
        if (ecran.loupe.fois > 0) {
            ecran = ecran.avec(ecran.loupe.amener(point, x, y));
        }
    }

    public void remplir() {
        ecran = ecran.remplir();
    }

    /** L'image a désormais cette place, en pixels de l'écran. */
    public void placer(int largeur, int hauteur) {
        ecran = ecran.avec(ecran.loupe.dans(Math.max(1, largeur), Math.max(1, hauteur)));
    }

    /** Change la taille des textes de tant de points. */
    public void agrandir(int points) {
        prendreLaPolice(ecran.police + points);
    }

    /** La taille des textes la plus proche, de 10 à 32 points. */
    public static int borner(int points) {
        return Math.max(POLICE_MIN, Math.min(POLICE_MAX, points));
    }

    /** Donne cette taille aux textes. */
    public void prendreLaPolice(int points) {
        int taille = borner(points);
        if (taille != ecran.police) {
            ecran = ecran.avecPolice(taille);
            ordres.add((moteur, vue) -> moteur.garderLaPolice(taille));
        }
    }

    /** Un clic ferme le message : ses fautes ne se lisent plus, jusqu'à d'autres, ou que le fichier se relise. */
    public void fermerLeMessage() {
        avis = new Etat.Avis("", Sorte.PASSAGER, etat().getFautes());
    }

    /** Cet avis a été lu assez longtemps. */
    public void oublier(Etat.Avis celui) {
        if (celui == avis) {
            dire("");
        }
    }

    /** L'image n'a pu être enregistrée, ou l'a été. */
    public void annoncer(String texte, boolean echec) {
        dire(texte, echec ? Sorte.RETENU : Sorte.PASSAGER);
    }

    // ce qui se mesure et s'explique

    /** La souris ou les flèches désignent ce réglage mesuré, ou {@code null}. */
    public void viser(Reglages mesure) {
        mesures = Objects.equals(mesure, mesures.vise) ? mesures : mesures.viser(mesure);
    }

    /** Dessine l'image du réglage désigné. Les points sont ceux de la scène montrée, ou il n'y en a pas. */
    public void prendre() {
        if (mesures.essais.containsKey(mesures.vise) && !refuseDeChanger()) {
            regler(mesures.vise);
        }
    }

    /** Réponse : ce réglage a été dessiné une fois de plus. */
    public void compter(Essai fait) {
        mesures = mesures.avec(fait);
    }

    /** Réponse : la mesure est finie. @param faute ce qui l'en a empêchée, ou {@code null} */
    public void finirLaMesure(String faute) {
        mesures = mesures.arretees(faute == null ? null : "Mesure impossible : " + faute);
    }

    /** Réponse : le pixel est expliqué. */
    public void raconter(Explication.Faite faite) {
        explication = new Explication(0, explication.dessin, explication.pixel, faite);
    }

    private void interrompre(String pourquoi) {
        int celui = mesures.numero;
        ordres.add((moteur, vue) -> moteur.arreter(celui));
        mesures = mesures.arretees(pourquoi);
    }

    // ce qui s'enregistre et se copie

    public void enregistrer() {
        ImageMemoire image = imageOuAvis("enregistrée");
        if (image != null) {
            String scene = montre.dessin.demande.lue.nom;
            ordres.add((moteur, vue) -> vue.demanderOuEnregistrer(image, scene));
        }
    }

    /** Enregistre cette image dans ce fichier. */
    public void enregistrerSous(ImageMemoire image, File cible, String scene) {
        ordres.add((moteur, vue) -> moteur.enregistrer(image, cible, scene));
    }

    public void copierLImage() {
        ImageMemoire image = imageOuAvis("copiée");
        if (image != null) {
            ordres.add((moteur, vue) -> vue.copier(image));
            dire("image copiée, " + image.largeur + " × " + image.hauteur + " pixels");
        }
    }

    /** L'image achevée ; à défaut, un avis dit pourquoi elle n'est pas enregistrée ou copiée. */
    private ImageMemoire imageOuAvis(String geste) {
        if (montre.direFautes() != null) {
            dire("Image non " + geste + " : " + montre.direFautes() + ".");
            return null;
        }
        if (!montre.entier) {
            dire(etat().enCours() ? "L'image se dessine encore : elle n'est pas " + geste + "."
                    : "Pas d'image achevée ; F5 pour la dessiner.");
        }
        return etat().getImageEntiere();
    }

    public void copierLesReglages() {
        String texte = etat().direLesReglages() + "\n";
        ordres.add((moteur, vue) -> vue.copier(texte));
        dire("réglages copiés : " + (texte.startsWith(";") ? "la commande" : "les sections changées et la commande"));
    }

    /** Copie le récit du pixel, tous les chiffres écrits. */
    public void copierLeRecit() {
        if (explication.faite != null && explication.faite.inspection != null) {
            List<String> lignes = new Recit(explication.faite.inspection, Double::toString, Double::toString)
                    .raconter().lignes();
            ordres.add((moteur, vue) -> vue.copier(String.join("\n", lignes)));
            dire("récit du pixel copié, " + lignes.size() + " lignes");
        }
    }

    // ce que l'état veut, et qui n'est pas encore commencé

    private void accorder() {
        accorderLeFichier();
        accorderLeDessin();
        accorderLExplication();
        accorderLaMesure();
    }

    /** Le fichier qui a changé se lit dès que rien n'est plus à écrire. */
    private void accorderLeFichier() {
        boolean aEcrire = etat().estDeplace() && demande.lue != source.quittee;
        if (source.nouvelle != null && geste == null && ecriture == null && question == null && !aEcrire) {
            lire();
        }
    }

    /** Ce qui est demandé se dessine, sauf si un travail s'en charge ou s'en est chargé, achevé, arrêté ou échoué. */
    private void accorderLeDessin() {
        if (demande == null) {
            return;
        }
        Couple taille = etat().getTaille();
        if (taille.x != demande.largeur || taille.y != demande.hauteur) {
            demande = demande.avecTaille(taille.x, taille.y);
        }
        boolean libre = travail == null || !travail.enCours() || travail.dessin != null;
        boolean charge = travail != null && demande.equals(travail.demande);
        boolean fait = (travail == null || !travail.enCours()) && montre.entier
                && demande.equals(montre.dessin.demande);
        if (libre && !charge && !fait) {
            Demande voulue = demande;
            Travail nouveau = remplacer(new Travail(++numero, null, voulue));
            ordres.add((moteur, vue) -> moteur.dessiner(nouveau.numero, voulue, nouveau.avancement));
        }
    }

    private void accorderLExplication() {
        Dessin dessin = montre.dessin;
        boolean voulue = ecran.onglet == Onglet.PIXEL && ecran.pixel != null && dessin != null;
        Pixel pixel = voulue ? ecran.pixel.dans(dessin.image.largeur, dessin.image.hauteur) : null;
        if (voulue && explication.est(dessin, pixel)) {
            return;
        }
        if (explication.enCours()) {
            int ancien = explication.numero;
            ordres.add((moteur, vue) -> moteur.arreter(ancien));
            explication = new Explication(0, null, null, explication.faite);
        }
        if (voulue) {
            Lancer lancer = dessin.lancer;
            Inspection inspection = new Inspection(lancer.getScene(), dessin.demande.lue::getOrigine,
                    lancer.getCamera(), dessin.demande.reglages.getProfondeur(), pixel.x, pixel.y);
            int celui = ++numero;
            explication = new Explication(celui, dessin, pixel, explication.faite);
            ordres.add((moteur, vue) -> moteur.expliquer(celui, inspection, dessin));
        }
    }

    /** L'échelle se mesure quand son onglet se voit, et que rien ne se dessine. */
    private void accorderLaMesure() {
        if (mesures.base != null && mesures.base.lue != demande.lue) {
            // les points d'une autre scène
            if (mesures.numero != 0) {
                interrompre(null);
            }
            mesures = Mesures.AUCUNES;
        }
        boolean libre = ecran.onglet == Onglet.VITESSE && demande != null && etat().direLEmpechement() == null;
        if (mesures.numero != 0 && (!libre || montre.dessin != mesures.dessin)) {
            interrompre(null);
        }
        if (libre && mesures.restentAFaire(montre.dessin)) {
            Mesures nouvelles = mesures.de(montre.dessin, 0);
            mesures = nouvelles;
            if (!nouvelles.sontFaites()) {
                int celui = ++numero;
                mesures = nouvelles.de(montre.dessin, celui);
                ordres.add((moteur, vue) -> moteur.mesurer(celui, nouvelles.dessin, nouvelles.essais));
            }
        }
    }
}
