package lancer.inspection;

/** Ce que compte un échantillon dans un pixel qui n'en est pas la simple moyenne. */
final class Compte {

    final Echantillon echantillon;
    final double poids;

    Compte(Echantillon echantillon, double poids) {
        this.echantillon = echantillon;
        this.poids = poids;
    }
}
