package lancer.inspection;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/** Un récit à lire : ses lignes repliées le restent tant qu'on ne les demande pas, celles qui changent le montrent. */
public final class Depliage {

    /** Scène du récit, {@code null} avant le premier. */
    private String scene;
    private List<Recit.Ligne> lignes = Collections.emptyList();
    private final Map<String, String> anciens = new HashMap<>();
    private final Set<String> deplies = new HashSet<>();

    /** Remplace le récit ; s'il est de cette même scène et du même pixel, ce qui a changé se compare à l'ancien. */
    public void remplacer(String nouvelleScene, List<Recit.Ligne> nouvelles) {
        if (textes(nouvelles).equals(textes(lignes))) {
            // le même récit, redemandé : ce qui avait changé le reste
            return;
        }
        anciens.clear();
        if (nouvelleScene.equals(scene) && lignes.get(0).texte.equals(nouvelles.get(0).texte)) {
            lignes.forEach(ligne -> anciens.put(ligne.sujet, ligne.texte));
        }
        scene = nouvelleScene;
        lignes = nouvelles;
    }

    private static List<String> textes(List<Recit.Ligne> recit) {
        return recit.stream().map(ligne -> ligne.texte).collect(Collectors.toList());
    }

    /** Déplie ce qui est replié, ou le contraire. @param repli {@code null} pour tout déplier, ou tout replier */
    public void basculer(String repli) {
        if (repli != null) {
            if (!deplies.remove(repli)) {
                deplies.add(repli);
            }
        } else if (deplies.isEmpty()) {
            lignes.forEach(ligne -> deplies.add(repli(ligne)));
        } else {
            deplies.clear();
        }
    }

    /** Les lignes à montrer, dans l'ordre ; d'un repli, celle qui le bascule vient d'abord. */
    public List<Recit.Ligne> getVues() {
        List<Recit.Ligne> vues = new ArrayList<>();
        Set<String> dits = new HashSet<>();
        for (Recit.Ligne ligne : lignes) {
            boolean ouvert = deplies.contains(repli(ligne));
            if (ligne.repli == null) {
                vues.add(vue(ligne));
            } else if (dits.add(repli(ligne))) {
                List<Recit.Ligne> pareilles = lignes.stream().filter(autre -> autre.repli != null
                        && repli(autre).equals(repli(ligne))).map(this::vue).collect(Collectors.toList());
                boolean changee = !ouvert && pareilles.stream().anyMatch(autre -> autre.changee);
                String titre = ligne.repli + (ouvert ? " ▾" : " ▸");
                vues.add(new Recit.Ligne(titre, ligne.etape, null, repli(ligne), changee));
                vues.addAll(ouvert ? pareilles : Collections.emptyList());
            }
        }
        return vues;
    }

    private Recit.Ligne vue(Recit.Ligne ligne) {
        String avant = anciens.get(ligne.sujet);
        if (avant == null || Recit.sansNumero(avant).equals(Recit.sansNumero(ligne.texte))) {
            return new Recit.Ligne(ligne.texte, ligne.etape, null, null, false);
        }
        // la valeur suffit, si elle est celle de la même chose
        boolean memeChose = avant.contains(" = ")
                && Recit.sansNumero(ligne.texte).startsWith(Recit.sansNumero(avant.split(" = ")[0]) + " = ");
        return new Recit.Ligne(ligne.texte + "   ← "
                + avant.substring(memeChose ? avant.lastIndexOf(" = ") + 1 : 0).trim(), ligne.etape, null, null, true);
    }

    /** Le repli d'une ligne, au nombre de ses pareilles près. */
    private static String repli(Recit.Ligne ligne) {
        return ligne.etape + " " + (ligne.repli == null ? "" : ligne.repli.replaceAll("\\d", ""));
    }
}
