package lancer.fenetre;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import lancer.SceneFautive;
import lancer.commande.Messages;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Programme;
import lancer.fenetre.Etat.Montre;
import lancer.fenetre.Etat.Source;
import lancer.scene.SceneLue;
import lancer.scene.Surveillance;

/**
 * La suite des états de la fenêtre, et celle de ses dessins. Tout y est appelé dans le fil des événements ;
 * {@link Travail} calcule dans un autre. La scène montrée reste la même jusqu'au premier brouillon d'une autre.
 */
final class Controleur {

    final PanneauImage panneau;
    private final Programme programme;
    private final Reglages options;
    private final Supplier<Dimension> taille;
    private final Surveillance surveillance = new Surveillance((fichier, version) ->
            EventQueue.invokeLater(() -> observer(fichier, version)));
    private final List<Consumer<Etat>> prevenus = new ArrayList<>();
    private Etat etat = new Etat();

    /** @param taille donne la taille de l'image à dessiner */
    Controleur(Programme programme, Reglages options, PanneauImage panneau, Supplier<Dimension> taille) {
        this.programme = programme;
        this.options = options;
        this.panneau = panneau;
        this.taille = taille;
    }

    Etat getEtat() {
        return etat;
    }

    /** Donne à {@code siChange} chaque état que publie la fenêtre. */
    void prevenir(Consumer<Etat> siChange) {
        prevenus.add(siChange);
    }

    private void publier(Etat nouveau) {
        etat = nouveau;
        prevenus.forEach(prevenu -> prevenu.accept(nouveau));
    }

    /** Publie le même état : un panneau seul a changé. */
    void avertir() {
        publier(etat);
    }

    /** Montre le premier dessin de la fenêtre, déjà demandé ; sa scène est lue. */
    void ouvrir(Travail premier) {
        Source lue = new Source(premier.demande.lue.nom, premier.version, null);
        surveillance.suivre(lue.fichier);
        publier(commencer(adopter(etat.avec(lue), premier.demande), premier));
    }

    /** Lit cette scène et la dessine ; le dessin en cours est abandonné. */
    void ouvrir(String fichier) {
        surveillance.suivre(fichier);
        lire(etat.avec(new Source(fichier, null, null)));
    }

    void relire() {
        lire(etat);
    }

    /** Lit le fichier demandé ; ce qui en était dit le reste jusqu'à la fin de la lecture. */
    private void lire(Etat celui) {
        Source inconnue = new Source(celui.source.fichier, null, celui.source.faute);
        publier(commencer(celui.avec(inconnue).avec(celui.montre.retenu()),
                new Travail(programme, options, celui.source.fichier, celui.demande)));
    }

    /** Le fichier de ce nom est à cette version. Celle que cette fenêtre a lue ou écrite ne lui apprend rien. */
    void observer(String fichier, String version) {
        String connue = etat.getVersion();
        if (!fichier.equals(etat.source.fichier) || connue == null || connue.equals(version)) {
            return;
        }
        if (etat.connait(version) && etat.source.version != null) {
            // le fichier est revenu tel qu'il était
            publier(etat.avec(new Source(fichier, version, null)));
        } else {
            relire();
        }
    }

    /** Dessine la scène avec ces réglages ; s'ils sont impossibles, un avis le dit. */
    void regler(Reglages voulus) {
        if (!voulus.equals(etat.demande.reglages)) {
            try {
                publier(avancer(etat.avec(etat.montre.retenu()).avec(etat.demande.avecReglages(voulus))));
            } catch (SceneFautive e) {
                panneau.bandeau.dire(e.getMessage());
                avertir();
            }
        }
    }

    /** Montre cette vue. @param vue {@code null} pour l'image */
    void voir(String vue) {
        publier(avancer(etat.avec(etat.demande.avecVue(vue))));
    }

    /** Dessine la scène avec ces déplacements, que le fichier ne contient pas. */
    void deplacer(SceneLue deplacee) {
        publier(avancer(etat.avec(etat.montre.retenu()).avec(etat.demande.avecLecture(deplacee))));
    }

    /**
     * L'écriture des déplacements est finie.
     *
     * @param avant ce que contenait leur fichier
     * @param voulue ce qu'il contient, et qui n'est pas à relire
     * @param faute ce qui a empêché de l'écrire, ou {@code null}
     */
    void finirLEcriture(SceneLue avant, SceneLue voulue, String faute) {
        boolean demandee = avant.nom.equals(etat.source.fichier);
        if (faute != null && demandee) {
            publier(etat.avec(new Source(avant.nom, etat.source.version, faute)));
        } else if (faute != null) {
            panneau.bandeau.dire(faute);
        } else if (etat.ecrite == avant) {
            // une autre scène aurait pu être lue depuis
            Etat ecrit = etat.avec(voulue);
            publier(demandee ? ecrit.avec(new Source(avant.nom, voulue.getVersion(), null)) : ecrit);
        }
    }

    /** Suit la taille que la fenêtre donne à l'image. */
    void ajuster() {
        Etat ajuste = aLaTaille(etat);
        if (ajuste != etat) {
            publier(avancer(ajuste));
        }
    }

    private Etat aLaTaille(Etat celui) {
        if (celui.demande == null) {
            return celui;
        }
        Dimension place = taille.get();
        Demande voulue = celui.demande.avecTaille(place.width, place.height);
        return voulue.equals(celui.demande) ? celui : celui.avec(voulue);
    }

    void arreter() {
        if (etat.enCours) {
            etat.travail.cancel(true);
        }
    }

    void terminer() {
        arreter();
        // ce que ce travail a publié n'est plus attendu
        etat = etat.avec(null, false);
        surveillance.terminer();
    }

    /** Montre le dessin en cours dès son brouillon, puis commence celui qui est demandé, s'il ne l'est pas déjà. */
    private Etat avancer(Etat voulu) {
        Etat celui = aLaTaille(voulu);
        Travail travail = celui.travail;
        Montre montre = celui.montre;
        if (!celui.enCours) {
            boolean fait = montre.entier && celui.demande.equals(montre.dessin.demande);
            return fait ? celui : commencer(celui, new Travail(programme, celui.demande));
        }
        Etat suivant = celui;
        // sans image, un brouillon se montre dès son début
        if (montre.dessin != travail.dessin && (montre.dessin == null || travail.aSonBrouillon())) {
            suivant = (travail.aLire == null ? celui : adopter(celui, travail.demande))
                    .avec(new Montre(travail.dessin, false, montre.avant));
        }
        boolean autre = travail.aSonBrouillon() && !travail.isCancelled() && !suivant.demande.equals(travail.demande);
        return autre ? commencer(suivant, new Travail(programme, suivant.demande)) : suivant;
    }

    private Etat commencer(Etat celui, Travail nouveau) {
        Etat abandonne = etat;
        // le travail abandonné finit aussitôt : il n'est déjà plus celui de l'état
        etat = celui.avec(nouveau, true);
        if (abandonne.enCours) {
            abandonne.travail.cancel(true);
        }
        nouveau.suite = this::suivre;
        nouveau.execute();
        return etat;
    }

    /** Ce travail a passé une étape, ou il est achevé, arrêté, ou a échoué. */
    private void suivre(Travail celui) {
        if (celui != etat.travail || !etat.enCours) {
            return;
        }
        Etat avant = etat;
        Etat suivi = etat;
        if (celui.lue && etat.source.version == null) {
            // elle n'a plus de faute, même si son image n'est pas encore montrée
            suivi = suivi.avec(new Source(etat.source.fichier, celui.version, null));
        }
        if (!celui.isCancelled() || etat.montre.dessin == null) {
            suivi = avancer(suivi);
        }
        if (celui.estFini() && celui == suivi.travail) {
            suivi = finir(suivi);
        }
        if (suivi != avant) {
            publier(suivi);
        }
    }

    /** La scène montrée est désormais celle qui vient d'être lue. */
    private Etat adopter(Etat celui, Demande lue) {
        List<String> avis = new ArrayList<>(lue.lue.avertissements);
        if (celui.estDeplace()) {
            avis.add("ce qui était déplacé dans " + celui.getNom() + " sans être écrit est oublié");
        }
        if (!avis.isEmpty()) {
            panneau.bandeau.dire(String.join("\n", avis));
        }
        return celui.avec(new Source(celui.source.fichier, celui.source.version, null))
                .avec(lue.lue)
                .avec(celui.demande == null ? lue : celui.demande.avecLecture(lue.lue));
    }

    /** Le travail en cours est fini. */
    private Etat finir(Etat celui) {
        Travail travail = celui.travail;
        Throwable echec = travail.getEchec();
        Etat fini = celui.avec(travail, false);
        if (!travail.lue) {
            fini = fini.avec(new Source(fini.source.fichier, travail.version,
                    echec == null ? null : Messages.message(echec)));
        }
        if (travail.estAcheve()) {
            fini = fini.avec(new Montre(travail.dessin, true, fini.montre.avant));
            if (travail.dessin.ecart != null) {
                panneau.bandeau.dire(travail.dessin.ecart);
            }
        }
        if (echec != null && fini.demande != null && (!travail.lue || !fini.demande.equals(travail.demande))) {
            // la lecture a interrompu le dessin d'avant, ou autre chose a été demandé avant cet échec
            fini = avancer(fini);
        }
        return fini;
    }
}
