package lancer.scene;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.SceneFautive;
import lancer.contrat.Modele;
import lancer.contrat.Section;
import lancer.contrat.Variante;

/** Le contenu d'un fichier de scène. */
public final class SceneLue {

    public final List<Objet3D> objets = new ArrayList<>();
    public final List<Lampe> lampes = new ArrayList<>();
    public final Origines origines;

    /** Les variantes présentes, chacune avec sa section ; la ligne est 0 si le fichier n'a pas cette section. */
    public final Map<Variante, Section> variantes = new LinkedHashMap<>();

    /** Avertissements : une ligne pour chaque section que la lecture a ignorée. */
    public final List<String> avertissements = new ArrayList<>();

    SceneLue(Origines origines) {
        this.origines = origines;
    }

    private SceneLue(SceneLue autre, int rang, Object nouvelle, SectionLue section) {
        Object ancienne = autre.origines.getChose(rang);
        objets.addAll(autre.objets);
        lampes.addAll(autre.lampes);
        objets.replaceAll(objet -> objet == ancienne ? (Objet3D) nouvelle : objet);
        lampes.replaceAll(lampe -> lampe == ancienne ? (Lampe) nouvelle : lampe);
        variantes.putAll(autre.variantes);
        avertissements.addAll(autre.avertissements);
        origines = new Origines(autre.origines, rang, nouvelle, section);
    }

    /**
     * La même scène, où une section est lue de nouveau avec une autre valeur.
     *
     * @param rang celui de la section, dans {@link #origines}
     * @throws lancer.SceneFautive si la lecture d'un fichier refuserait cette valeur
     */
    public SceneLue avec(int rang, String cle, String valeur) {
        SectionLue section = origines.getSection(rang).avec(cle, valeur, null);
        return new SceneLue(this, rang, origines.lecteur.lire(section), section);
    }

    /** Les sections qui diffèrent de celles de {@code avant}, à copier dans le fichier. */
    public String getChanges(SceneLue avant) {
        return origines.getChanges(avant.origines).mapToObj(k -> origines.getSection(k).ecrire("\n") + "\n\n")
                .collect(Collectors.joining());
    }

    /**
     * Cette scène, relue, avec les changements faits de {@code avant} à {@code changee}. Une valeur que le fichier a
     * changée reste, sauf si {@code malgreLui} est vrai ; une section que le fichier n'a plus est oubliée.
     */
    public SceneLue reporter(SceneLue avant, SceneLue changee, boolean malgreLui) {
        SceneLue faite = this;
        for (int k : changee.origines.getChanges(avant.origines).toArray()) {
            SectionLue ancienne = avant.origines.getSection(k);
            SectionLue voulue = changee.origines.getSection(k);
            int ici = origines.getRangDuNom(voulue.nom, k);
            for (String cle : ici < 0 ? Collections.<String>emptyList() : voulue.getDonnees()) {
                String valeur = voulue.valeur(cle);
                String sienne = origines.getSection(ici).valeur(cle);
                if (!valeur.equals(ancienne.valeur(cle)) && !valeur.equals(sienne)
                        && (malgreLui || Objects.equals(sienne, ancienne.valeur(cle)))) {
                    try {
                        faite = faite.avec(ici, cle, valeur);
                    } catch (SceneFautive e) {
                        // le fichier a changé cette section au point que la valeur n'y convient plus
                    }
                }
            }
        }
        return faite;
    }

    /** La même scène, où des objets et des lampes en remplacent d'autres, dont ils prennent la section. */
    public SceneLue remplacer(Map<Object, Object> autres) {
        SceneLue faite = new SceneLue(origines.remplacer(autres));
        objets.forEach(objet -> faite.objets.add((Objet3D) autres.getOrDefault(objet, objet)));
        lampes.forEach(lampe -> faite.lampes.add((Lampe) autres.getOrDefault(lampe, lampe)));
        faite.variantes.putAll(variantes);
        faite.avertissements.addAll(avertissements);
        return faite;
    }

    void ajouter(Object chose, SectionLue section) {
        if (chose instanceof Lampe) {
            lampes.add((Lampe) chose);
        } else {
            objets.add((Objet3D) chose);
        }
        origines.ajouter(chose, section);
    }

    /** Modèle où chaque variante est installée. @throws lancer.SceneFautive si une section est refusée */
    public Modele getModele() {
        Modele modele = new Modele();
        variantes.forEach((variante, section) -> {
            variante.installer(section, modele);
            section.verifierCles();
        });
        return modele;
    }
}
