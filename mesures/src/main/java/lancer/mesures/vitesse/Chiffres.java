package lancer.mesures.vitesse;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import lancer.mesures.trace.Style;

/** Les nombres que montrent les pages, par leurs noms. */
final class Chiffres {

    private static final String SANS_PROFONDEUR = "p=1000 seuil=1/1024";

    private final Map<String, String> valeurs = new TreeMap<>();

    Chiffres(Releves releves, List<Map<String, String>> besoins) {
        for (String scene : releves.de(Famille.ECHANTILLONNAGE).scenes()) {
            for (Cout cout : Cout.values()) {
                echantillonnage(scene + "." + cout.nom + ".", new Constats(scene, releves, cout));
            }
            reflets(scene + ".", new Constats(scene, releves, Cout.RAYONS));
            valeurs.put(scene + ".verite", Style.arrondi(releves.de(scene, Famille.VERITE).de("moyenne").get().get(0).erreurEnPas()));
        }
        for (Map<String, String> besoin : besoins) {
            valeurs.put(besoin.get("scene") + ".profondeur", besoin.get("profondeur_utile"));
            valeurs.put(besoin.get("scene") + ".epargne", Style.arrondi(100 * TableBesoins.economie(besoin)));
        }
        valeurs.put("modeles", FigureModele.reponse(releves));
        spheres(releves);
        demandes(releves);
        Releve premier = releves.get().get(0);
        valeurs.put("machine", premier.texte("machine") + ", " + premier.texte("coeurs") + " cœurs, " + premier.texte("jvm"));
    }

    Map<String, String> get() {
        return valeurs;
    }

    private void echantillonnage(String debut, Constats c) {
        Releve coins = Constats.defaut(c.echantillonnages, Catalogue.COINS);
        valeurs.put(debut + "titre", c.titre());
        valeurs.put(debut + "jugement", c.anticrenelage());
        valeurs.put(debut + "coins", Style.arrondi(c.cout(coins)));
        valeurs.put(debut + "coins.gain", Style.arrondi(c.front.gain(coins)));
        valeurs.put(debut + "coins.mieux", c.front.mieuxQue(coins).map(Noms::methode).orElse("rien"));
        valeurs.put(debut + "coins.mieux.cout", c.front.mieuxQue(coins).map(c::cout).map(Style::arrondi).orElse("—"));
        valeurs.put(debut + "coins.mieux.erreur", c.front.mieuxQue(coins).map(Releve::erreurEnPas).map(Style::arrondi).orElse("—"));
        valeurs.put(debut + "coins.erreur", Style.arrondi(coins.erreurEnPas()));
        for (Releve grille : c.echantillonnages.de(Catalogue.GRILLE).get()) {
            String nom = debut + "grille" + grille.parametres.charAt(0);
            valeurs.put(nom, Style.arrondi(c.cout(grille)));
            valeurs.put(nom + ".erreur", Style.arrondi(grille.erreurEnPas()));
            valeurs.put(nom + ".gain", Style.arrondi(c.front.gain(grille)));
            valeurs.put(nom + ".mieux", c.front.mieuxQue(grille).map(Noms::methode).orElse("rien"));
        }
    }

    private void reflets(String debut, Constats c) {
        Releve defaut = Constats.defaut(c.reflets, Catalogue.PROFONDEUR);
        Releve sans = c.reflets.le(Catalogue.SEUIL, SANS_PROFONDEUR);
        valeurs.put(debut + "reflets", c.limites());
        valeurs.put(debut + "reflets.erreur", Style.arrondi(defaut.erreurEnPas()));
        valeurs.put(debut + "reflets.max", Style.arrondi(255 * defaut.nombre("max")));
        valeurs.put(debut + "sansprofondeur.erreur", Style.arrondi(sans.erreurEnPas()));
        valeurs.put(debut + "sansprofondeur.rayons", fois(sans.rayonsParPixel() / defaut.rayonsParPixel()));
    }

    /** « 0,4 % de rayons en plus », « 3,7 fois plus de rayons ». */
    private static String fois(double rapport) {
        return rapport == 1 ? "pas un rayon de plus" : rapport < 1.5 ? Style.arrondi(100 * (rapport - 1)) + " % de rayons en plus"
                : Style.arrondi(rapport) + " fois plus de rayons";
    }

    private void spheres(Releves releves) {
        List<Releve> programme = releves.de(Famille.SPHERES).de(Catalogue.PROGRAMME).get();
        Releve grand = programme.get(programme.size() - 1);
        valeurs.put("spheres.temps", Style.arrondi(grand.medianeMs() / programme.get(0).medianeMs()));
        valeurs.put("spheres.essayees", Style.arrondi(grand.testsParRayon()));
        List<Releve> boucles = releves.de(Famille.SPHERES).de(Catalogue.BOUCLES).get();
        Releve derniere = boucles.get(boucles.size() - 1);
        valeurs.put("spheres.boucles", Style.arrondi(derniere.medianeMs() / boucles.get(0).medianeMs()));
        valeurs.put("spheres.boucles.nombre", Style.nombre(derniere.nombre("spheres")));
    }

    private void demandes(Releves releves) {
        valeurs.put("demandes.lampe", FigureDemandes.pourCent(FigureDemandes.facteur(releves, "lampe", "une de plus")));
        valeurs.put("demandes.brume", FigureDemandes.pourCent(FigureDemandes.facteur(releves, "brume", "")));
        valeurs.put("demandes.reflets", FigureDemandes.pourCent(FigureDemandes.facteur(releves, "reflets", "aucun")));
        valeurs.put("demandes.coins", Style.arrondi(FigureDemandes.facteur(releves, "antialias coins", "n=3 seuil=0.05")));
    }
}
