package lancer.mesures.vitesse;

/** Ce qu'une image a coûté : du travail, compté et le même partout, ou du temps. */
enum Cout {

    RAYONS("rayons", "rayons de toutes sortes par pixel", "de rayons") {
        @Override
        double de(Releve r) {
            return r.rayonsParPixel();
        }
    },

    TEMPS("temps", "temps d'une image, en millisecondes", "de temps") {
        @Override
        double de(Releve r) {
            return r.medianeMs();
        }
    };

    /** Pour le nom d'un fichier. */
    final String nom;

    /** Pour un axe. */
    final String axe;

    /** Pour une phrase : « moitié moins de rayons ». */
    final String deQuoi;

    Cout(String nom, String axe, String deQuoi) {
        this.nom = nom;
        this.axe = axe;
        this.deQuoi = deQuoi;
    }

    abstract double de(Releve r);
}
