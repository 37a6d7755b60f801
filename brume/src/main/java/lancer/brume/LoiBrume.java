package lancer.brume;

/** La part de brume dans ce que voit un rayon, selon sa longueur. Sans état. */
interface LoiBrume {

    /**
     * @param distance longueur du rayon, finie, en unités de la scène
     * @return de 0 (on ne voit que l'objet) à 1 (on ne voit que la brume), jamais NaN
     */
    double k(double distance);

    /** k = (d − debut) / (fin − debut). */
    final class Lineaire implements LoiBrume {

        private final double debut;
        private final double fin;

        /** @param fin plus grande que {@code debut}, qui est positif ou nul */
        Lineaire(double debut, double fin) {
            this.debut = debut;
            this.fin = fin;
        }

        @Override
        public double k(double distance) {
            return Math.max(0, Math.min(1, (distance - debut) / (fin - debut)));
        }
    }

    /** k = 1 − exp(−densite·(d − debut)), la loi d'une brume également répartie (Beer et Lambert). */
    final class Exponentielle implements LoiBrume {

        private final double debut;
        private final double densite;

        /** @param densite par unité de la scène, positive ou nulle, finie */
        Exponentielle(double debut, double densite) {
            this.debut = debut;
            this.densite = densite;
        }

        @Override
        public double k(double distance) {
            // pas de limite à 1 : 1 − exp d'un négatif ne la dépasse pas ; expm1 garde les chiffres d'une brume très
            // légère
            return Math.max(0, -Math.expm1(-densite * (distance - debut)));
        }
    }
}
