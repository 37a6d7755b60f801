package lancer.inspection;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.Couleur;

/** Une ligne de l'explication d'un pixel, et les lignes qui l'expliquent à leur tour. Immuable. */
public final class Noeud {

    private static final Pattern VALEUR = Pattern.compile(".*(?:  | = | : )");

    public final String texte;

    /** Sujet de la ligne, le même d'un dessin à l'autre. */
    public final String sujet;

    /** La couleur qu'elle montre, ou {@code null} ; la valeur d'avant si elle a changé, ou {@code null}. */
    public final Couleur couleur;
    public final String avant;

    public final List<Noeud> enfants;

    /** Dit si les enfants ne sont montrés qu'à la demande. */
    public final boolean replie;

    /** Numéro du rayon dont cette ligne est le titre, ou 0 ; rang de l'échantillon, ou -1. */
    public final int rebond;
    public final int echantillon;

    private Noeud(String texte, String sujet, Couleur couleur, String avant, List<Noeud> enfants, boolean replie,
            int rebond, int echantillon) {
        this.texte = texte;
        this.sujet = sujet;
        this.couleur = couleur;
        this.avant = avant;
        this.enfants = Collections.unmodifiableList(enfants);
        this.replie = replie;
        this.rebond = rebond;
        this.echantillon = echantillon;
    }

    Noeud(String texte, String sujet, Couleur couleur) {
        this(texte, sujet, couleur, null, Collections.emptyList(), false, 0, -1);
    }

    Noeud sur(List<Noeud> siens, boolean replies) {
        return new Noeud(texte, sujet, couleur, avant, siens, replies, rebond, echantillon);
    }

    /** Le même nœud, titre de ce rayon ou échantillon de ce rang. */
    Noeud choisissant(int unRebond, int unEchantillon) {
        return new Noeud(texte, sujet, couleur, avant, enfants, replie, unRebond, unEchantillon);
    }

    /** Les lignes, chacune suivie de celles qui l'expliquent, en retrait ; la racine n'ajoute pas de retrait. */
    public List<String> lignes() {
        List<String> lignes = new ArrayList<>();
        lignes.add(texte);
        enfants.forEach(enfant -> enfant.dire("", lignes));
        return lignes;
    }

    private void dire(String retrait, List<String> lignes) {
        lignes.add(retrait + texte);
        enfants.forEach(enfant -> enfant.dire(retrait + "  ", lignes));
    }

    /** Cette explication, comparée à une autre du même pixel : un nœud changé garde sa valeur d'avant. */
    public Noeud depuis(Noeud ancien) {
        if (ancien == null || !sujet.equals(ancien.sujet)) {
            return this;
        }
        if (lignes().equals(ancien.lignes())) {
            // l'explication n'a pas changé : les différences d'avant restent montrées
            return ancien;
        }
        Map<String, String> textes = new HashMap<>();
        ancien.noter(textes);
        return comparer(textes);
    }

    private void noter(Map<String, String> textes) {
        textes.put(sujet, texte);
        enfants.forEach(enfant -> enfant.noter(textes));
    }

    private Noeud comparer(Map<String, String> textes) {
        return new Noeud(texte, sujet, couleur, valeurChangee(textes.get(sujet)),
                enfants.stream().map(enfant -> enfant.comparer(textes)).collect(Collectors.toList()), replie, rebond,
                echantillon);
    }

    /** La fin du texte d'avant qui diffère ; {@code null} s'il n'a pas changé. */
    private String valeurChangee(String ancien) {
        String sien = sansNumero(texte);
        String autre = sansNumero(ancien == null ? texte : ancien);
        int commun = 0;
        while (commun < Math.min(sien.length(), autre.length()) && sien.charAt(commun) == autre.charAt(commun)) {
            commun++;
        }
        Matcher debut = VALEUR.matcher(autre.substring(0, commun));
        return sien.equals(autre) ? null : autre.substring(debut.lookingAt() ? debut.end() : 0);
    }

    /** Ce texte sans les numéros de ligne du fichier, qu'une ligne ajoutée plus haut change. */
    static String sansNumero(String texte) {
        return texte.replaceAll(" ligne \\d+", "");
    }

    /** Dit si ce nœud, ou un de ceux qui l'expliquent, a changé. */
    public boolean aChange() {
        return avant != null || enfants.stream().anyMatch(Noeud::aChange);
    }
}
