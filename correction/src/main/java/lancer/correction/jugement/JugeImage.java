package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.List;
import lancer.correction.depot.Projet;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Chantier.Assemblage;
import lancer.correction.jugement.Verdict.Etat;
import lancer.correction.modele.Modele;

/** Juge l'image d'un rendu : si elle n'est pas celle du corrigé, par quel pixel et par quelles classes. */
final class JugeImage {

    /** Pixels où l'on cherche d'où vient la faute. */
    private static final int PIXELS_ESSAYES = 200;

    private final Juge juge;
    private final Reference reference;
    private final Projet projet;
    private final Resultat resultat;

    JugeImage(Juge juge, Reference reference, Projet projet, Resultat resultat) {
        this.juge = juge;
        this.reference = reference;
        this.projet = projet;
        this.resultat = resultat;
    }

    /** Dessine, compare, et cherche d'où vient ce qui diffère. */
    void juger() {
        try {
            Image image = juge.image(juge.ensemble(), 0);
            resultat.image = image;
            // là où le rendu a raison, au ciel au moins, il l'a à un demi-pixel près : c'est là qu'on voit lequel
            resultat.centre = image.pareils(reference.getImage(true)) > image.pareils(reference.getImage(false));
            resultat.ecart = new Ecart(reference.getImage(resultat.centre), image);
            boolean meme = resultat.ecart.memeImage();
            resultat.verdicts.put(Grille.IMAGE, meme ? new Verdict(Etat.REUSSI, "")
                    : new Verdict(commencee(image) ? Etat.RATE : Etat.NON_COMMENCE,
                    resultat.ecart.combien() + " sur " + resultat.ecart.pixels));
            if (!meme && commencee(image)) {
                chercherLaFaute(image);
            }
        } catch (Arret | Dialogue.Echec e) {
            if (resultat.image == null) {
                resultat.sansImage = e.getMessage();
                resultat.verdicts.put(Grille.IMAGE, new Verdict(Etat.RATE, e.getMessage()));
            } else {
                resultat.remarques.add("la recherche de la faute dans l'image s'est arrêtée : " + e.getMessage());
            }
        }
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

    private void chercherLaFaute(Image image) throws Arret {
        Image attendue = reference.getImage(resultat.centre);
        resultat.chemin = chemin(resultat.ecart.pireX, resultat.ecart.pireY);
        // un pixel très faux l'est souvent par ce qu'il reflète : un autre, moins faux, montre mieux d'où cela vient
        int pas = Math.max(1, image.pixels() / PIXELS_ESSAYES);
        for (int p = pas / 2; p < image.pixels(); p += pas) {
            if (Ecart.ecart(attendue, image, p) > 1) {
                Chemin autre = chemin(p % Juge.LARGEUR, p / Juge.LARGEUR);
                if (autre.rangDuPremierEcart() < resultat.chemin.rangDuPremierEcart()
                        && (resultat.cheminPlusTot == null
                        || autre.rangDuPremierEcart() < resultat.cheminPlusTot.rangDuPremierEcart())) {
                    resultat.cheminPlusTot = autre;
                }
            }
        }
        List<String> suspectes = new ArrayList<>(Modele.A_COMPLETER);
        suspectes.removeIf(classe -> projet.texte(classe) == null || juge.intacte(classe));
        List<String> justes = new ArrayList<>(suspectes);
        justes.removeIf(classe -> reference.getVerifications().stream()
                .anyMatch(v -> v.classe.equals(classe) && !resultat.verdicts.get(v.id()).compte()));
        // celles dont tout réussit d'abord, d'un seul coup : elles sont rarement en cause
        if (justes.size() > 1 && !changentLImage(juge.parmiLeCorrige(justes))) {
            suspectes.removeAll(justes);
        }
        for (String classe : suspectes) {
            if (changentLImage(juge.seule(classe))) {
                resultat.classesFautives.add(classe);
            }
        }
    }

    /** Vrai si cet assemblage ne dessine pas l'image du corrigé. */
    private boolean changentLImage(Assemblage assemblage) {
        try {
            Image image = juge.estArrete(assemblage) ? null : juge.image(assemblage, 0);
            return image == null || !new Ecart(reference.getImage(false), image).memeImage()
                    && !new Ecart(reference.getImage(true), image).memeImage();
        } catch (Arret | Dialogue.Echec e) {
            return true;
        }
    }

    private Chemin chemin(int x, int y) throws Arret {
        double decalage = resultat.centre ? 0.5 : 0;
        String siens = juge.sonde(juge.ensemble(), "SondeChemin", "decrire", juge.scene(), "" + Juge.LARGEUR,
                "" + Juge.HAUTEUR, "" + x, "" + y, "" + Juge.PROFONDEUR);
        return new Chemin(x, y, reference.chemin(x + decalage, y + decalage), siens);
    }
}
