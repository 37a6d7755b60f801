package lancer.contrat;

import lancer.SceneFautive;

/**
 * Ce que les variantes peuvent changer d'une scène : l'air, le reflet des lampes, l'échantillonnage. Chaque contrat ne
 * se prend qu'une fois : deux variantes qui veulent le même ne vont pas ensemble.
 */
public final class Modele {

    private Atmosphere atmosphere = Atmosphere.CLAIRE;
    private Specularite specularite = Specularite.PHONG;
    private Echantillonnage echantillonnage = Echantillonnage.CENTRE;

    public Atmosphere getAtmosphere() {
        return atmosphere;
    }

    /** @throws SceneFautive si une autre variante a déjà changé l'air */
    public void setAtmosphere(Atmosphere atmosphere) {
        this.atmosphere = libre(this.atmosphere, Atmosphere.CLAIRE, atmosphere, "l'air");
    }

    public Specularite getSpecularite() {
        return specularite;
    }

    /** @throws SceneFautive si une autre variante a déjà changé le reflet des lampes */
    public void setSpecularite(Specularite specularite) {
        this.specularite = libre(this.specularite, Specularite.PHONG, specularite, "le reflet des lampes");
    }

    public Echantillonnage getEchantillonnage() {
        return echantillonnage;
    }

    /** @throws SceneFautive si une autre variante a déjà changé l'échantillonnage */
    public void setEchantillonnage(Echantillonnage echantillonnage) {
        this.echantillonnage = libre(this.echantillonnage, Echantillonnage.CENTRE, echantillonnage,
                "l'échantillonnage");
    }

    private static <T> T libre(T present, T defaut, T nouveau, String quoi) {
        if (nouveau == null) {
            throw new IllegalArgumentException("une variante a changé " + quoi + " en null");
        }
        if (present != defaut) {
            throw new SceneFautive("deux variantes veulent changer " + quoi + " : " + nom(present) + " et "
                    + nom(nouveau) + " ; attendu : une seule des deux dans le chemin des classes");
        }
        return nouveau;
    }

    /** Le nom de la classe, sans ce que Java ajoute à celui d'une lambda. */
    static String nom(Object contrat) {
        return contrat.getClass().getName().replaceAll("\\$\\$Lambda.*", "");
    }
}
