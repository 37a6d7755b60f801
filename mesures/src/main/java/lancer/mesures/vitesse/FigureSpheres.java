package lancer.mesures.vitesse;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/** Ce que coûte le nombre de sphères : en sphères essayées par rayon, et en temps par image. */
final class FigureSpheres {

    private final List<Releve> programme;
    private final List<Releve> boucles;
    private final String note;

    FigureSpheres(Releves releves, String note) {
        programme = releves.de(Famille.SPHERES).de(Catalogue.PROGRAMME).get();
        boucles = releves.de(Famille.SPHERES).de(Catalogue.BOUCLES).get();
        this.note = note;
    }

    Planche planche() {
        Volet tests = new Volet("Le programme essaie " + Style.nombre(programme.get(programme.size() - 1).testsParRayon())
                + " sphères par rayon dans la plus grande scène", "", "nombre de sphères", "sphères essayées par rayon");
        Volet temps = new Volet(tempsDesBoucles(), "", "nombre de sphères",
                "temps d'une image, en ms");
        for (Volet volet : new Volet[] {tests, temps}) {
            ToDoubleFunction<Releve> y = volet == tests ? Releve::testsParRayon : Releve::medianeMs;
            boolean barres = volet == temps;
            volet.serie(new Serie("les boucles du cours", Style.BLEU, FormeDePoint.CARRE, true, marques(boucles, y, barres)));
            volet.serie(new Serie("le programme", Style.VERMILLON, FormeDePoint.ROND, true, marques(programme, y, barres)));
        }
        return new Planche(titre(), note).volet(tests, 1).volet(temps, 1);
    }

    private String titre() {
        Releve petit = programme.get(0);
        Releve grand = programme.get(programme.size() - 1);
        return Style.nombre(grand.nombre("spheres") / petit.nombre("spheres")) + " fois plus de sphères ne coûtent que "
                + Style.arrondi(grand.medianeMs() / petit.medianeMs()) + " fois plus de temps";
    }

    private String tempsDesBoucles() {
        Releve derniere = boucles.get(boucles.size() - 1);
        return "Par les boucles du cours, " + Style.nombre(derniere.nombre("spheres")) + " sphères prennent "
                + Style.arrondi(derniere.medianeMs() / boucles.get(0).medianeMs()) + " fois le temps d'une seule";
    }

    private static List<Marque> marques(List<Releve> releves, ToDoubleFunction<Releve> y, boolean barres) {
        return releves.stream().map(r -> {
            Marque m = Marque.en(r.nombre("spheres"), y.applyAsDouble(r));
            return (barres ? m.entreY(r.nombre("q1_ms"), r.nombre("q3_ms")) : m).nommee(Style.nombre(y.applyAsDouble(r)));
        }).collect(Collectors.toList());
    }
}
