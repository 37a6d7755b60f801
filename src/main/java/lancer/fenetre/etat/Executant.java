package lancer.fenetre.etat;

import java.io.File;
import java.util.Map;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.image.ImageMemoire;
import lancer.inspection.Inspection;
import lancer.scene.SceneLue;
import lancer.scene.TexteScene;

/** Ce qui travaille pour la fenêtre, dans d'autres fils. Un ordre revient aussitôt ; ses réponses en ont le numéro. */
public interface Executant {

    /** Lit ce fichier, puis dessine sa scène. @param avant la demande dont les réglages restent, ou {@code null} */
    void lire(int numero, String fichier, Demande avant, Avancement avancement);

    void dessiner(int numero, Demande demande, Avancement avancement);

    /** Explique un pixel de ce dessin. */
    void expliquer(int numero, Inspection inspection, Dessin dessin);

    /** Dessine ces réglages à tour de rôle, dans les mêmes conditions. @param dessin celui dont ils ont la scène */
    void mesurer(int numero, Dessin dessin, Map<Reglages, Essai> essais);

    /** Arrête le travail, l'explication ou la mesure de ce numéro, qui ne répond plus. */
    void arreter(int numero);

    /** Écrit la scène voulue dans son fichier. Voir {@link lancer.scene.EcritureScene#remplacer}. */
    void ecrire(int numero, SceneLue voulue, SceneLue avant, TexteScene connu);

    /** Écrit ce texte dans un autre fichier. */
    void ecrireSous(int numero, TexteScene texte, String fichier);

    /** Enregistre cette image. @param scene le fichier dont elle vient, qui n'est pas à écraser */
    void enregistrer(ImageMemoire image, File cible, String scene);

    /** Observe ce fichier. */
    void surveiller(String fichier);

    /** Garde cette taille des textes pour la prochaine fenêtre. */
    void garderLaPolice(int taille);

    /** Ne fait plus rien ; les écritures en cours s'achèvent. */
    void terminer();
}
