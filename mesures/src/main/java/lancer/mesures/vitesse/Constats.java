package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lancer.mesures.trace.Style;

/** Ce que disent les mesures d'une scène, en phrases : les titres des courbes. Tout est calculé, rien n'est écrit d'avance. */
final class Constats {

    /** Au-dessous, une différence ne vaut pas une phrase. */
    private static final double GAIN_MIN = 1.05;

    final Releves echantillonnages;
    final Releves reflets;
    final Front front;
    final Front frontReflets;
    private final String scene;
    private final Cout cout;

    Constats(String scene, Releves releves, Cout cout) {
        this.scene = scene;
        this.cout = cout;
        echantillonnages = releves.de(scene, Famille.ECHANTILLONNAGE);
        reflets = releves.de(scene, Famille.REFLETS);
        front = new Front(echantillonnages.get(), cout);
        frontReflets = new Front(reflets.get(), cout);
    }

    /** La grille complète que bat le plus ce qui est adaptatif. */
    String titre() {
        Releve battue = null;
        double gain = 1;
        for (Releve grille : echantillonnages.de(Catalogue.GRILLE).get()) {
            if (front.gain(grille) > gain) {
                gain = front.gain(grille);
                battue = grille;
            }
        }
        return Noms.scene(scene) + " : " + (battue == null ? "aucune méthode ne bat les grilles complètes"
                : "mieux que " + battue.parametres + " pour " + fois(gain));
    }

    /** Ce que vaut le réglage par défaut de l'anticrénelage, et ce qui n'est jamais sur le front. */
    String anticrenelage() {
        return jugement(defaut(echantillonnages, Catalogue.COINS), front) + jamais();
    }

    /** Ce que vaut le réglage par défaut des reflets. */
    String limites() {
        Releve defaut = defaut(reflets, Catalogue.PROFONDEUR);
        Optional<Releve> mieux = frontReflets.mieuxQue(defaut);
        String valeur = "Le défaut, " + Noms.methode(defaut) + ", se trompe de " + pas(defaut.erreurEnPas());
        return valeur + (mieux.isPresent() && bat(mieux.get(), defaut)
                ? " : il est battu, " + Noms.methode(mieux.get()) + " fait au moins aussi bien pour " + fois(frontReflets.gain(defaut))
                : mieux.isPresent() ? " et ne se distingue pas du front" : " et est sur le front");
    }

    /** Vrai si la différence de coût en est une : deux temps dont les barres se touchent n'en font pas. */
    private boolean bat(Releve mieux, Releve r) {
        return cout.de(r) >= GAIN_MIN * cout.de(mieux)
                && (cout != Cout.TEMPS || mieux.nombre("q3_ms") < r.nombre("q1_ms"));
    }

    private String jugement(Releve defaut, Front sien) {
        Optional<Releve> mieux = sien.mieuxQue(defaut);
        if (!mieux.isPresent()) {
            return "Le défaut, " + Noms.methode(defaut) + ", est sur le front";
        }
        return !bat(mieux.get(), defaut) ? "Le défaut, " + Noms.methode(defaut) + ", ne se distingue pas du front"
                : "Le défaut, " + Noms.methode(defaut) + ", est battu : " + Noms.methode(mieux.get())
                + " fait mieux pour " + fois(sien.gain(defaut));
    }

    private String jamais() {
        List<String> absentes = new ArrayList<>();
        for (String methode : new String[] {Catalogue.GRILLE, Catalogue.COINS, Catalogue.PARTAGE}) {
            List<Releve> siens = echantillonnages.de(methode).get();
            if (!siens.isEmpty() && siens.stream().allMatch(r -> front.mieuxQue(r).filter(m -> bat(m, r)).isPresent())) {
                absentes.add(methode.equals(Catalogue.GRILLE) ? "grilles" : "« " + methode + " »");
            }
        }
        return absentes.isEmpty() ? "" : ". Jamais sur le front : " + String.join(", ", absentes);
    }

    /** Ce que ce relevé a coûté. */
    double cout(Releve r) {
        return cout.de(r);
    }

    static Releve defaut(Releves releves, String methode) {
        return releves.de(methode).get().stream().filter(Catalogue::estParDefaut).findFirst()
                .orElseThrow(() -> new IllegalStateException("pas de réglage par défaut pour " + methode));
    }

    /** « 2,1 fois moins de rayons ». */
    String fois(double gain) {
        return Style.arrondi(gain) + " fois moins " + cout.deQuoi;
    }

    /** « 0,4 pas de l'écran ». */
    static String pas(double erreur) {
        return Style.arrondi(erreur) + " pas d'écran";
    }
}
