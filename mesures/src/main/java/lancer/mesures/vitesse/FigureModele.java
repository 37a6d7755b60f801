package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/** Blinn est-il plus rapide que Phong, comme le dit le cours ? Deux modèles : aucun n'est l'erreur de l'autre. */
final class FigureModele {

    private final Releves releves;
    private final String note;

    FigureModele(Releves releves, String note) {
        this.releves = releves.de(Famille.MODELE);
        this.note = note;
    }

    Planche planche() {
        List<String> noms = new ArrayList<>();
        List<Marque> phong = new ArrayList<>();
        List<Marque> blinn = new ArrayList<>();
        List<String> chemins = releves.get().stream().map(r -> r.parametres).distinct().collect(Collectors.toList());
        for (String chemin : chemins) {
            for (String scene : releves.scenes()) {
                Releve p = releves.de(scene, Famille.MODELE).le(Catalogue.PHONG, chemin);
                Releve b = releves.de(scene, Famille.MODELE).le(Catalogue.BLINN, chemin);
                double rapport = b.medianeMs() / p.medianeMs();
                phong.add(marque(p, p, noms.size()));
                blinn.add(marque(b, p, noms.size()).nommee("× " + Style.nombre(rapport)));
                noms.add(Noms.scene(scene) + (chemin.equals("rapide") ? "" : ", --simple"));
            }
        }
        Volet rangees = Volet.rangees("Mêmes rayons, mêmes sphères essayées : seul le calcul du reflet des lampes diffère. "
                + "« --simple » : les boucles du cours.", "temps d'une image, celui de Phong valant 1", noms, 1);
        rangees.serie(new Serie("Phong", Style.BLEU, FormeDePoint.CARRE, false, phong));
        rangees.serie(new Serie("Blinn (barres : la moitié centrale des dessins)", Style.VERMILLON, FormeDePoint.ROND, false, blinn));
        return new Planche(reponse(releves), note).volet(rangees, 1);
    }

    private static Marque marque(Releve r, Releve phong, int rangee) {
        return Marque.en(r.medianeMs() / phong.medianeMs(), rangee)
                .entreX(r.nombre("q1_ms") / phong.medianeMs(), r.nombre("q3_ms") / phong.medianeMs());
    }

    /**
     * La réponse. Deux temps ne se distinguent que si la moitié centrale de l'un est tout entière d'un côté de celle de l'autre :
     * la machine n'est jamais assez tranquille pour en croire les seules médianes.
     */
    static String reponse(Releves releves) {
        int plusRapide = 0;
        int plusLent = 0;
        double min = Double.POSITIVE_INFINITY;
        double max = 0;
        List<Releve> blinns = releves.de(Famille.MODELE).de(Catalogue.BLINN).get();
        for (Releve b : blinns) {
            Releve p = releves.de(b.scene, Famille.MODELE).le(Catalogue.PHONG, b.parametres);
            plusRapide += b.nombre("q3_ms") < p.nombre("q1_ms") ? 1 : 0;
            plusLent += b.nombre("q1_ms") > p.nombre("q3_ms") ? 1 : 0;
            min = Math.min(min, b.medianeMs() / p.medianeMs());
            max = Math.max(max, b.medianeMs() / p.medianeMs());
        }
        return verdict(plusRapide, plusLent, blinns.size()) + " : de " + Style.arrondi(min) + " à " + Style.arrondi(max)
                + " fois son temps";
    }

    private static String verdict(int plusRapide, int plusLent, int tous) {
        if (plusRapide == 0 && plusLent == 0) {
            return "Blinn ne se distingue pas de Phong";
        }
        if (plusRapide > 0 && plusLent > 0) {
            return "Blinn est plus rapide que Phong ici, plus lent là";
        }
        return "Blinn est plus " + (plusLent == 0 ? "rapide" : "lent") + " que Phong"
                + (plusRapide + plusLent < tous ? ", ou ne s'en distingue pas" : "");
    }
}
