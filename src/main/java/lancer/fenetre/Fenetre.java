package lancer.fenetre;

import java.util.List;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Programme;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Suite;
import lancer.fenetre.etat.Suite.Evenement;
import lancer.fenetre.moteur.Moteur;
import lancer.fenetre.vue.Cadre;

/** Relie l'état, le moteur et la vue : de chaque événement, l'état qui suit se montre, et ses ordres s'exécutent. */
public final class Fenetre {

    private final Moteur moteur;
    private final Cadre cadre;
    private Etat etat;

    /**
     * Commence le dessin, qui n'attend pas la fenêtre, plus longue à faire que le brouillon à dessiner.
     *
     * @param premiere ce qui est demandé de la première scène, lue, ou {@code null}
     * @param police taille des textes, en points
     * @param fin appelé à la fermeture, dans un autre fil
     */
    Fenetre(Programme programme, Reglages options, Demande premiere, List<String> variantes, int police, Runnable fin) {
        moteur = new Moteur(programme, options, fin, this::recevoir);
        etat = Etat.vide(options.get(Option.TAILLE).x, options.get(Option.TAILLE).y, police);
        if (premiere != null) {
            recevoir(suite -> suite.montrerLaPremiere(premiere));
        }
        cadre = new Cadre(variantes.isEmpty() ? "lancer" : "lancer (" + String.join(", ", variantes) + ")", etat,
                this::recevoir);
    }

    /** Montre le cadre. */
    void montrer() {
        cadre.montrer(etat);
        cadre.ouvrir();
    }

    Etat getEtat() {
        return etat;
    }

    Cadre getCadre() {
        return cadre;
    }

    /** Voici ce qui arrive. Appelé dans le fil des événements. */
    void recevoir(Evenement evenement) {
        Suite suite = Suite.apres(etat, evenement);
        Etat avant = etat;
        etat = suite.getEtat();
        if (etat != avant && cadre != null) {
            cadre.montrer(etat);
        }
        suite.getOrdres().forEach(ordre -> ordre.executer(moteur, cadre == null ? null : cadre.getDialogues()));
    }
}
