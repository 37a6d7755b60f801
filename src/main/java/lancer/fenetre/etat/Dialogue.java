package lancer.fenetre.etat;

import lancer.image.ImageMemoire;

/** Ce que la fenêtre demande à l'utilisateur, ou met dans le presse-papiers. Les réponses sont des événements. */
public interface Dialogue {

    /** Demande quelle scène ouvrir. @param presente celle qui est demandée, ou {@code null} */
    void choisirUneScene(String presente);

    /** Demande que faire de ce qui n'est pas écrit dans cette scène. */
    void demanderDEcrire(String nom);

    /** Propose d'écrire la scène dans un autre fichier. @param pourquoi ce qui a empêché d'écrire, ou {@code null} */
    void proposerEcrireSous(String pourquoi, String fichier);

    /** Demande où enregistrer cette image. @param scene le fichier dont elle vient */
    void demanderOuEnregistrer(ImageMemoire image, String scene);

    void copier(String texte);

    void copier(ImageMemoire image);

    void fermer();
}
