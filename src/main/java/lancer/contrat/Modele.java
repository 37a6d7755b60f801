package lancer.contrat;

import lancer.Constantes;
import lancer.SceneFautive;

/** Façon de dessiner une scène : air, reflet, échantillonnage, que des variantes changent, recherche et seuil. */
public final class Modele {

    private Atmosphere atmosphere = Atmosphere.CLAIRE;
    private Specularite specularite = Specularite.PHONG;
    private Echantillonnage echantillonnage;
    private Recherche recherche;
    private double seuil = Constantes.SEUIL;
    private Ecoute ecoute;
    private boolean avecOmbres = true;

    /** Le modèle de la base : un rayon par pixel, les boucles du cours. */
    public Modele() {
    }

    private Modele(Modele autre) {
        atmosphere = autre.atmosphere;
        specularite = autre.specularite;
        echantillonnage = autre.echantillonnage;
        recherche = autre.recherche;
        seuil = autre.seuil;
        ecoute = autre.ecoute;
        avecOmbres = autre.avecOmbres;
    }

    /** Le même modèle pour un fil, dont la recherche compte dans {@code compteurs}. */
    public Modele pourUnFil(Compteurs compteurs) {
        Modele sien = new Modele(this);
        sien.recherche = recherche == null ? null : recherche.pourUnFil(compteurs);
        return sien;
    }

    /** Modèle identique, sauf l'échantillonnage et le seuil ({@link #setSeuil}). */
    public Modele avec(Echantillonnage echantillonnage, double seuil) {
        Modele autre = new Modele(this);
        autre.echantillonnage = echantillonnage;
        autre.seuil = seuil;
        return autre;
    }

    /** Modèle identique, dont le calcul est noté dans {@code ecoute}. */
    public Modele ecoute(Ecoute ecoute) {
        Modele autre = new Modele(this);
        autre.ecoute = ecoute;
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
    public boolean avecOmbres() {
        return avecOmbres;
    }

    public void oterOmbres() {
        avecOmbres = false;
    }

    /** Échantillonnage de l'image ; {@code null} : un rayon au centre de chaque pixel. */
    public Echantillonnage getEchantillonnage() {
        return echantillonnage;
    }

    /** @throws SceneFautive si une autre variante a déjà changé l'échantillonnage */
    public void setEchantillonnage(Echantillonnage echantillonnage) {
        this.echantillonnage = libre(this.echantillonnage, null, echantillonnage, "l'échantillonnage");
    }

    /** Recherche qui propose des objets aux boucles du cours ; {@code null} : elles les demandent tous. */
    public Recherche getRecherche() {
        return recherche;
    }

    public void setRecherche(Recherche recherche) {
        this.recherche = recherche;
    }

    /** Un rayon réfléchi est lancé si la plus grande composante du produit des Ks atteint ce seuil. */
    public double getSeuil() {
        return seuil;
    }

    /** @param seuil fini, positif ou nul ; 0 : chaque rayon réfléchi est lancé */
    public void setSeuil(double seuil) {
        this.seuil = seuil;
    }

    /** Détail du calcul pour l'inspecteur ; {@code null} pendant un dessin. */
    public Ecoute getEcoute() {
        return ecoute;
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
