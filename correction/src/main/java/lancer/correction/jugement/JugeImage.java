package lancer.correction.jugement;

import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Machines.Assemblage;
import lancer.correction.jugement.Verdict.Etat;
import lancer.correction.modele.Modele;

/** Juge les images d'un rendu : si l'une n'est pas celle du corrigé, par quel pixel et par quelles classes. */
final class JugeImage {

    /** Pixels où l'on cherche d'où vient la faute. */
    private static final int PIXELS_ESSAYES = 200;

    private final Juge juge;
    private final Reference reference;
    private final Resultat resultat;

    JugeImage(Juge juge) {
        this.juge = juge;
        reference = juge.reference;
        resultat = juge.resultat;
    }

    /** Dessine chaque scène et compare ; de la première qui diffère, cherche d'où cela vient. */
    void juger() {
        String fausse = null;
        for (String scene : Reference.SCENES.keySet()) {
            Verdict verdict = juger(scene);
            resultat.verdicts.put(Grille.IMAGE + "." + scene, verdict);
            fausse = fausse == null && verdict.etat == Etat.RATE && resultat.images.containsKey(scene) ? scene : fausse;
        }
        if (fausse != null) {
            try {
                chercherLaFaute(fausse);
            } catch (Arret | Dialogue.Echec e) {
                resultat.remarques.add("la recherche de la faute dans l'image s'est arrêtée : " + e.getMessage());
            }
        }
    }

    private Verdict juger(String scene) {
        Image image;
        try {
            image = juge.image(juge.ensemble, scene, 0);
        } catch (Arret e) {
            resultat.regarder(e.getMessage() + " (en dessinant « " + scene + " »)");
            return new Verdict(Etat.RATE, e.getMessage());
        } catch (Dialogue.Echec e) {
            return new Verdict(Etat.RATE, e.getMessage());
        }
        // là où le rendu a raison, au ciel au moins, il l'a à un demi-pixel près : c'est là qu'on voit lequel
        resultat.centre = resultat.images.isEmpty() ? image.pareils(reference.getImage(scene, true))
                > image.pareils(reference.getImage(scene, false)) : resultat.centre;
        resultat.images.put(scene, image);
        Ecart ecart = new Ecart(reference.getImage(scene, resultat.centre), image);
        return ecart.memeImage() ? new Verdict(Etat.REUSSI, "") : new Verdict(commencee(image) ? Etat.RATE
                : Etat.NON_COMMENCE, ecart.combien() + " sur " + ecart.pixels);
    }

    /** Faux pour l'image d'une seule couleur du projet à compléter. */
    private static boolean commencee(Image image) {
        for (int p = 1; p < image.pixels(); p++) {
            if (image.code(p % image.largeur, p / image.largeur) != image.code(0, 0)) {
                return true;
            }
        }
        return false;
    }

    private void chercherLaFaute(String scene) throws Arret {
        Image image = resultat.images.get(scene);
        Image attendue = reference.getImage(scene, resultat.centre);
        Ecart ecart = new Ecart(attendue, image);
        resultat.chemin = chemin(scene, ecart.pireX, ecart.pireY);
        // un pixel très faux l'est souvent par ce qu'il reflète : un autre, moins faux, montre mieux d'où cela vient
        int pas = Math.max(1, image.pixels() / PIXELS_ESSAYES);
        for (int p = pas / 2; p < image.pixels(); p += pas) {
            if (Ecart.ecart(attendue, image, p) > 1) {
                Chemin autre = chemin(scene, p % image.largeur, p / image.largeur);
                resultat.chemin = autre.rangDuPremierEcart() < resultat.chemin.rangDuPremierEcart() ? autre : resultat.chemin;
            }
        }
        for (String classe : Modele.A_COMPLETER) {
            if (juge.projet.texte(classe) != null && !juge.intacte(classe) && changentLImage(scene, juge.seule(classe))) {
                resultat.classesFautives.add(classe);
            }
        }
    }

    /** Vrai si cet assemblage ne dessine pas l'image du corrigé. */
    private boolean changentLImage(String scene, Assemblage assemblage) {
        try {
            Image image = juge.estArrete(assemblage) ? null : juge.image(assemblage, scene, 0);
            return image == null || !new Ecart(reference.getImage(scene, false), image).memeImage()
                    && !new Ecart(reference.getImage(scene, true), image).memeImage();
        } catch (Arret | Dialogue.Echec e) {
            return true;
        }
    }

    private Chemin chemin(String scene, int x, int y) throws Arret {
        double decalage = resultat.centre ? 0.5 : 0;
        return new Chemin(x, y, reference.chemin(scene, x + decalage, y + decalage), juge.chemin(juge.ensemble, scene, x, y));
    }
}
