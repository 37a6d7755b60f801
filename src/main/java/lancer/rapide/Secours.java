package lancer.rapide;

/** L'arbre, construit seulement si quelqu'un le demande : d'ordinaire, personne. */
final class Secours implements Voisins, Obstacles {

    private final Spheres spheres;
    private final int[] lesquelles;
    private final int[] grosses;
    private final double portee;
    private volatile Arbre arbre;

    Secours(Spheres spheres, int[] lesquelles, int[] grosses, double portee) {
        this.spheres = spheres;
        this.lesquelles = lesquelles;
        this.grosses = grosses;
        this.portee = portee;
    }

    Arbre arbre() {
        Arbre a = arbre;
        if (a == null) {
            synchronized (this) {
                a = arbre;
                if (a == null) {
                    a = Pousse.arbre(spheres, lesquelles.clone(), grosses, portee);
                    arbre = a;
                }
            }
        }
        return a;
    }

    @Override
    public int plusProche(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz, int sauf) {
        return arbre().plusProche(sonde, px, py, pz, vx, vy, vz, sauf);
    }

    @Override
    public boolean cachee(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf) {
        return arbre().cachee(sonde, px, py, pz, vx, vy, vz, distance, sauf);
    }
}
