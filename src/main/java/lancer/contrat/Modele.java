package lancer.contrat;

import lancer.Constantes;
import lancer.SceneFautive;

/** Façon de dessiner une scène : air, reflet, échantillonnage, que des variantes changent, étape du cours et seuil. */
public final class Modele {

    private Atmosphere atmosphere = Atmosphere.CLAIRE;
    private Specularite specularite = Specularite.PHONG;
    private Echantillonnage echantillonnage = Echantillonnage.CENTRES;
    private double seuil = Constantes.SEUIL;
    private boolean ombres = true;

    /** Le modèle de la base : un rayon au centre de chaque pixel. */
    public Modele() {
    }

    private Modele(Modele autre) {
        atmosphere = autre.atmosphere;
        specularite = autre.specularite;
        echantillonnage = autre.echantillonnage;
        seuil = autre.seuil;
        ombres = autre.ombres;
    }

    /** Modèle identique, sauf l'échantillonnage et le seuil ({@link #setSeuil}). */
    public Modele avec(Echantillonnage echantillonnage, double seuil) {
        Modele autre = new Modele(this);
        autre.echantillonnage = echantillonnage;
        autre.seuil = seuil;
        return autre;
    }

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

    /** Ne laisse que l'éclairement de Lambert. */
    public void oterSpecularite() {
        specularite = (V, N, L, R, ns) -> 0;
    }

    /** Dit si un objet peut cacher une lampe. */
    public boolean aDesOmbres() {
        return ombres;
    }

    public void oterOmbres() {
        ombres = false;
    }

    public Echantillonnage getEchantillonnage() {
        return echantillonnage;
    }

    /** @throws SceneFautive si une autre variante a déjà changé l'échantillonnage */
    public void setEchantillonnage(Echantillonnage echantillonnage) {
        this.echantillonnage = libre(this.echantillonnage, Echantillonnage.CENTRES, echantillonnage,
                "l'échantillonnage");
    }

    /** Un rayon réfléchi est lancé si la plus grande composante du produit des Ks atteint ce seuil. */
    public double getSeuil() {
        return seuil;
    }

    /** @param seuil fini, positif ou nul ; 0 : chaque rayon réfléchi est lancé */
    public void setSeuil(double seuil) {
        this.seuil = seuil;
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

    /** Le nom de la classe, sans le suffixe que Java donne à une lambda. */
    public static String nom(Object contrat) {
        return contrat.getClass().getName().replaceAll("\\$\\$Lambda.*", "");
    }
}
