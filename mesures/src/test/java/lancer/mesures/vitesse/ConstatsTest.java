package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Les phrases des courbes. */
class ConstatsTest {

    private static Constats constats(List<Releve> releves) {
        return new Constats("scene1", new Releves(releves), Cout.RAYONS);
    }

    @Test
    void ellesDisentDeCombienLeDefautEstHorsDuFrontEtCeQuiNYEstJamais() {
        Constats c = constats(Faux.releves());
        assertEquals("Scène du cours : mieux que 3 × 3 pour 3 fois moins de rayons", c.titre());
        assertEquals("Le défaut, « coins » (3 ; 0,05), est battu : « partage » (4 ; 0,1) fait mieux pour 2 fois moins de rayons. "
                + "Jamais sur le front : grilles, « coins »", c.anticrenelage());
        assertEquals("Le défaut, la profondeur 5, se trompe de 0,02 pas d'écran et est sur le front", c.limites());
    }

    @Test
    void ellesDisentLeContraireQuandLesMesuresDisentLeContraire() {
        List<Releve> releves = Faux.releves();
        releves.removeIf(r -> r.methode.equals(Catalogue.PARTAGE));
        releves.add(Faux.releve(Famille.REFLETS, Catalogue.SEUIL, "p=1000 seuil=1/256", 2, 0.01));
        Constats c = constats(releves);
        assertEquals("Le défaut, « coins » (3 ; 0,05), est sur le front. Jamais sur le front : grilles",
                c.anticrenelage());
        assertEquals("Le défaut, la profondeur 5, se trompe de 0,02 pas d'écran : il est battu, le seuil 1/256 "
                + "fait au moins aussi bien pour "
                + "2 fois moins de rayons", c.limites());
    }

    @Test
    void ellesNePrennentPasQuelquesPourCentPourUneDifference() {
        List<Releve> releves = Faux.releves();
        releves.removeIf(r -> r.methode.equals(Catalogue.PARTAGE));
        releves.add(Faux.releve(Famille.ECHANTILLONNAGE, Catalogue.COINS, "n=4 seuil=0.2", 23.5, 1.5));
        assertEquals("Le défaut, « coins » (3 ; 0,05), ne se distingue pas du front. Jamais sur le front : grilles",
                constats(releves).anticrenelage());
        // en temps, les barres du défaut et de ce qui le bat de 12 % se touchent ; en rayons, tout compte
        releves.add(Faux.releve(Famille.ECHANTILLONNAGE, Catalogue.COINS, "n=4 seuil=0.1", 21.4, 1.5));
        assertEquals("Le défaut, « coins » (3 ; 0,05), ne se distingue pas du front. Jamais sur le front : grilles",
                new Constats("scene1", new Releves(releves), Cout.TEMPS).anticrenelage());
        assertEquals("Le défaut, « coins » (3 ; 0,05), est battu : « coins » (4 ; 0,1) fait mieux pour 1,1 fois moins de rayons. "
                + "Jamais sur le front : grilles", constats(releves).anticrenelage());
    }

    /** Blinn en tant de millisecondes, contre Phong en 10, chacun à 10 % près. */
    private static String blinn(double... temps) {
        List<Releve> releves = new java.util.ArrayList<>();
        for (int k = 0; k < temps.length; k++) {
            releves.add(Faux.releve(Famille.MODELE, Catalogue.PHONG, "chemin" + k, 20, 0));
            releves.add(Faux.releve(Famille.MODELE, Catalogue.BLINN, "chemin" + k, 2 * temps[k], 0));
        }
        return FigureModele.reponse(new Releves(releves));
    }

    @Test
    void ellesDisentSiBlinnEstPlusRapidePlusLentOuSiRienNeLeDit() {
        assertEquals("Blinn est plus rapide que Phong : de 0,5 à 0,6 fois son temps", blinn(5, 6));
        assertEquals("Blinn est plus rapide que Phong, ou ne s'en distingue pas : de 0,5 à 1 fois son temps", blinn(5, 10));
        assertEquals("Blinn est plus lent que Phong : de 1,5 à 2 fois son temps", blinn(15, 20));
        assertEquals("Blinn ne se distingue pas de Phong : de 0,95 à 1,1 fois son temps", blinn(9.5, 10.5));
        assertEquals("Blinn est plus rapide que Phong ici, plus lent là : de 0,5 à 2 fois son temps", blinn(5, 20));
    }
}
