package lancer.contrat;

import java.util.Optional;
import lancer.Constantes;
import lancer.SceneFautive;

/**
 * Façon de dessiner une scène : air, reflet, échantillonnage, que des variantes changent, étape du cours et seuil.
 * Immuable.
 */
public final class Modele {

    private final Atmosphere atmosphere;
    private final Specularite specularite;
    /** {@code null} si rien n'est choisi. */
    private final Echantillonnage echantillonnage;
    private final double seuil;
    private final boolean ombres;

    /** Le modèle de la base. */
    public Modele() {
        this(Atmosphere.CLAIRE, Specularite.PHONG, null, Constantes.SEUIL, true);
    }

    private Modele(Atmosphere atmosphere, Specularite specularite, Echantillonnage echantillonnage, double seuil,
            boolean ombres) {
        this.atmosphere = atmosphere;
        this.specularite = specularite;
        this.echantillonnage = echantillonnage;
        this.seuil = seuil;
        this.ombres = ombres;
    }

    /** Modèle identique, sauf l'échantillonnage et le seuil ({@link #getSeuil}). */
    public Modele avec(Echantillonnage autreEchantillonnage, double autreSeuil) {
        return new Modele(atmosphere, specularite, autreEchantillonnage, autreSeuil, ombres);
    }

    /** Modèle identique, sauf le seuil. @param autreSeuil fini, positif ou nul ; 0 : chaque rayon réfléchi est lancé */
    public Modele avecSeuil(double autreSeuil) {
        return new Modele(atmosphere, specularite, echantillonnage, autreSeuil, ombres);
    }

    public Atmosphere getAtmosphere() {
        return atmosphere;
    }

    public Specularite getSpecularite() {
        return specularite;
    }

    /** L'échantillonnage qu'une variante a choisi ; sans lui, un rayon passe par le centre de chaque pixel. */
    public Optional<Echantillonnage> getEchantillonnage() {
        return Optional.ofNullable(echantillonnage);
    }

    /** Dit si un objet peut cacher une lampe. */
    public boolean aDesOmbres() {
        return ombres;
    }

    /** Un rayon réfléchi est lancé si la plus grande composante du produit des Ks atteint ce seuil. */
    public double getSeuil() {
        return seuil;
    }

    /**
     * Les choix dont un modèle est fait, dans un ordre quelconque ; ceux de la base là où personne n'a choisi. Une
     * variante choisit l'air, le reflet des lampes ou l'échantillonnage, que nulle autre ne peut alors choisir.
     */
    public static final class Construction {

        private Atmosphere atmosphere;
        private Specularite specularite;
        private Echantillonnage echantillonnage;
        private double seuil = Constantes.SEUIL;
        private boolean avecReflets = true;
        private boolean ombres = true;

        /** @throws SceneFautive si une autre variante a déjà changé l'air */
        public void setAtmosphere(Atmosphere atmosphere) {
            this.atmosphere = libre(this.atmosphere, atmosphere, "l'air");
        }

        /** @throws SceneFautive si une autre variante a déjà changé le reflet des lampes */
        public void setSpecularite(Specularite specularite) {
            this.specularite = libre(this.specularite, specularite, "le reflet des lampes");
        }

        /** @throws SceneFautive si une autre variante a déjà changé l'échantillonnage */
        public void setEchantillonnage(Echantillonnage echantillonnage) {
            this.echantillonnage = libre(this.echantillonnage, echantillonnage, "l'échantillonnage");
        }

        /** @param seuil fini, positif ou nul ; 0 : chaque rayon réfléchi est lancé */
        public void setSeuil(double seuil) {
            this.seuil = seuil;
        }

        /** Ne laisse que l'éclairement de Lambert. */
        public void oterSpecularite() {
            avecReflets = false;
        }

        public void oterOmbres() {
            ombres = false;
        }

        public Modele construire() {
            Specularite reflet = specularite == null ? Specularite.PHONG : specularite;
            return new Modele(atmosphere == null ? Atmosphere.CLAIRE : atmosphere,
                    avecReflets ? reflet : (V, N, L, R, ns) -> 0, echantillonnage, seuil, ombres);
        }

        private static <T> T libre(T dejaChoisi, T contrat, String role) {
            if (contrat == null) {
                throw new IllegalArgumentException("une variante a changé " + role + " en null");
            }
            if (dejaChoisi != null) {
                throw new SceneFautive("deux variantes veulent changer " + role + " : " + nom(dejaChoisi) + " et "
                        + nom(contrat) + " ; attendu : une seule des deux dans le chemin des classes");
            }
            return contrat;
        }

        /** Le nom de la classe, sans le suffixe que Java donne à une lambda. */
        private static String nom(Object contrat) {
            return contrat.getClass().getName().replaceAll("\\$\\$Lambda.*", "");
        }
    }
}
