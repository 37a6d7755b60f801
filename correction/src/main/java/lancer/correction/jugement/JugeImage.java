package lancer.correction.jugement;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Machines.Assemblage;
import lancer.correction.jugement.Verdict.Etat;
import lancer.correction.modele.SourcesDuCours;

/** Juge l'image d'un rendu : est-elle celle du corrigé, et sinon, d'où vient la différence ? */
final class JugeImage {

    /** Temps permis à un dessin, en fois celui d'une vérification. */
    private static final double TEMPS = 4;
    /** Nombre de pixels où la cause d'une différence est cherchée. */
    private static final int PIXELS_ESSAYES = 200;

    private final JugeRendu juge;
    private final Reference reference;
    final Resultat resultat;

    JugeImage(JugeRendu juge, Reference reference) {
        this.juge = juge;
        this.reference = reference;
        this.resultat = juge.resultat;
    }

    /**
     * L'image d'une scène jugée, par la méthode {@code getCouleurPixel} de ces classes.
     *
     * @throws Dialogue.Echec si le dessin échoue, avec la raison
     */
    Image dessiner(Assemblage assemblage, String scene) throws Arret {
        int[] taille = Reference.SCENES.get(scene);
        // un petit dessin profond a moins de temps : si chaque reflet en demande deux, il ne finira pas
        double temps = taille[2] > 5 ? TEMPS / 2 : TEMPS;
        return new Image(taille[0], taille[1], juge.machine(assemblage).sonder(byte[].class, temps, "dessiner", reference.scene(scene),
                taille[0], taille[1], taille[2]));
    }

    /** L'image d'une scène, par la méthode {@code TracerImage} de ces classes. @throws Dialogue.Echec si le dessin échoue */
    Image tracer(Assemblage assemblage, String scene, int largeur, int hauteur, int profondeur) throws Arret {
        return new Image(largeur, hauteur, juge.machine(assemblage).sonder(byte[].class, TEMPS, "tracer", scene,
                largeur, hauteur, profondeur));
    }

    /** Réponses intermédiaires des méthodes de ces classes. */
    List<?> decrire(Assemblage assemblage, String scene, double xe, double ye) throws Arret {
        int[] taille = Reference.SCENES.get(scene);
        return juge.machine(assemblage).sonder(List.class, TEMPS, "decrire", reference.scene(scene), taille[0], taille[1], xe, ye,
                Math.min(5, taille[2]));
    }

    /** Dessine et compare chaque scène, puis cherche la cause de la première différence. */
    void juger() {
        String fausse = null;
        for (String scene : Reference.SCENES.keySet()) {
            Verdict verdict = juger(scene);
            resultat.verdicts.put(GrilleDeNotation.IMAGE + "." + scene, verdict);
            fausse = fausse == null && verdict.etat == Etat.FAUSSE && resultat.images.containsKey(scene) ? scene : fausse;
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
        try {
            Image image = dessiner(juge.ensemble, scene);
            // même un rendu faux a des pixels justes, au moins au ciel : ils disent s'il vise le centre des pixels
            resultat.centre = resultat.images.isEmpty() ? image.pareilles(reference.grille.getImage(scene, true))
                    > image.pareilles(reference.grille.getImage(scene, false)) : resultat.centre;
            resultat.images.put(scene, image);
            Image attendue = reference.grille.getImage(scene, resultat.centre);
            if (image.pareille(attendue)) {
                return new Verdict(Etat.REUSSI, "", image.combien(attendue));
            }
            // une image d'une seule couleur est celle du projet à compléter, sauf si getCouleurPixel est écrite
            boolean commencee = juge.aEcrit("Lancer", "getCouleurPixel") || IntStream.range(1, image.pixels())
                    .anyMatch(p -> image.code(p % image.largeur, p / image.largeur) != image.code(0, 0));
            return new Verdict(commencee ? Etat.FAUSSE : Etat.NON_COMMENCE, "", image.combien(attendue));
        } catch (Arret e) {
            resultat.regarder(e.getMessage() + " (en dessinant « " + scene + " »)");
            return new Verdict(Etat.FAUSSE, "", e.getMessage());
        } catch (Dialogue.Echec e) {
            return new Verdict(Etat.FAUSSE, "", e.getMessage(), e.faute, "");
        }
    }

    /** Dessine une extension, et la base du même rendu. L'enseignant les compare : le programme ne les juge pas. */
    void montrer(String extension, Assemblage variante) {
        String message = "l'image de l'extension, celle de la base et celle du corrigé sont plus bas";
        try {
            resultat.images.put(extension, etendre(variante, extension, false));
            resultat.images.put(extension + GrilleDeNotation.BASE, etendre(juge.ensemble, extension, false));
        } catch (Arret | Dialogue.Echec e) {
            message = "l'image n'a pas pu être dessinée : " + e.getMessage();
        }
        resultat.verdicts.put(extension + ".image", new Verdict(Etat.A_NOTER, "", message));
    }

    /** @param section vrai pour garder la section de l'extension, que le corrigé lit et qu'un rendu peut refuser */
    Image etendre(Assemblage assemblage, String extension, boolean section) throws Arret {
        String scene = SourcesDuCours.scene(GrilleDeNotation.EXTENSIONS.get(extension)[2]);
        return tracer(assemblage, section ? scene : scene.replaceFirst("(?s)\\[Brume\\].*?(?=\\n\\[)", ""), 160, 120, 5);
    }

    private void chercherLaFaute(String scene) throws Arret {
        Image image = resultat.images.get(scene);
        Image attendue = reference.grille.getImage(scene, resultat.centre);
        int pire = IntStream.range(0, image.pixels()).boxed().max(Comparator.comparing(p -> image.ecart(attendue, p))).get();
        resultat.chemin = chemin(scene, pire % image.largeur, pire / image.largeur);
        // un pixel très faux l'est souvent par un reflet : un pixel moins faux montre mieux la cause
        int pas = Math.max(1, image.pixels() / PIXELS_ESSAYES);
        for (int p = pas / 2; p < image.pixels(); p += pas) {
            if (image.ecart(attendue, p) > 1) {
                Chemin autre = chemin(scene, p % image.largeur, p / image.largeur);
                resultat.chemin = autre.rangDuPremierEcart() < resultat.chemin.rangDuPremierEcart() ? autre : resultat.chemin;
            }
        }
        // d'abord les classes qui ont raté des vérifications, puis les autres
        for (boolean faute : new boolean[] {true, false}) {
            if (resultat.classesFautives.isEmpty()) {
                juge.changees(SourcesDuCours.A_COMPLETER).stream().filter(c -> juge.aUneFaute(c) == faute && change(scene, c))
                        .forEach(resultat.classesFautives::add);
            }
        }
    }

    /** Dit si cette classe change l'image du corrigé. */
    private boolean change(String scene, String classe) {
        try {
            Image image = juge.seule(classe).arrete ? null : dessiner(juge.seule(classe), scene);
            return image == null || !image.pareille(reference.grille.getImage(scene, false))
                    && !image.pareille(reference.grille.getImage(scene, true));
        } catch (Arret | Dialogue.Echec e) {
            return true;
        }
    }

    /** Compare au même point de l'écran : celui que vise le {@code getCouleurPixel} du rendu pour ce pixel. */
    private Chemin chemin(String scene, int x, int y) throws Arret {
        double decalage = resultat.centre ? 0.5 : 0;
        return new Chemin(x, y, reference.chemin(scene, x + decalage, y + decalage),
                decrire(juge.ensemble, scene, x + decalage, y + decalage));
    }
}
