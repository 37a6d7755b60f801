package lancer.contrat;

import lancer.Objet3D;
import lancer.Point;
import lancer.Vecteur;

/** La recherche du cours ({@code --simple}) : elle propose tous les objets, dans l'ordre de la scène. */
public class TousLesObjets implements Recherche {

    private final int nombre;
    private int suivant;

    /** @param nombre celui des objets de la scène */
    public TousLesObjets(int nombre) {
        this.nombre = nombre;
    }

    @Override
    public void commencer(Point P, Vecteur V, Objet3D depart) {
        suivant = 0;
    }

    @Override
    public int suivant(double auPlus) {
        return suivant < nombre ? suivant++ : -1;
    }

    @Override
    public Recherche pourUnFil(Compteurs compteurs) {
        return new TousLesObjets(nombre);
    }
}
