package lancer.correction.jugement;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import lancer.correction.depot.Faute;
import lancer.correction.depot.Projet;
import lancer.correction.jugement.Verdict.Etat;
import lancer.correction.modele.SourcesDuCours;

/** Constats sur un rendu déjà jugé : les consignes, et ce que l'enseignant doit examiner. */
final class Constats {

    /** Ce qu'un rendu ne trouve pas ici, et les noms qui le demandent. */
    private static final Map<String, List<String>> DEHORS = new TreeMap<>(Map.of(
            "ouvre une fenêtre (%s) : la correction n'a pas d'écran", List.of("JOptionPane", "JFrame", "JDialog", "JFileChooser"),
            "lit le clavier ou un fichier (%s) : la correction n'a ni l'un, ni ceux que le rendu joint", List.of("Scanner", "Files",
                    "BufferedReader", "FileReader", "FileInputStream", "getResource", "getResourceAsStream")));

    private final JugeRendu juge;
    private final Projet projet;
    private final Resultat resultat;

    Constats(JugeRendu juge, Projet projet) {
        this.juge = juge;
        this.projet = projet;
        this.resultat = juge.resultat;
    }

    void dire() {
        consignes();
        confronter();
        compiler();
    }

    /** Classes du rendu qui utilisent ce nom. */
    private List<String> emploient(String nom) {
        return juge.changees(SourcesDuCours.classes()).stream().filter(c -> !c.equals("Main") && projet.type(c).noms.contains(nom))
                .collect(Collectors.toList());
    }

    private void consignes() {
        juge.changees(SourcesDuCours.A_COMPLETER).stream().filter(c -> !juge.aUneFaute(c) && projet.texte(c).contains("FIXME"))
                .forEach(c -> projet.noter(Projet.FIXME, "reste dans " + c));
        Projet.CONSIGNES.keySet().forEach(nom -> resultat.verdicts.put(GrilleDeNotation.CONSIGNES + "." + nom,
                new Verdict(projet.ecarts.containsKey(nom) ? Etat.FAUSSE : Etat.REUSSI, "", projet.ecarts.getOrDefault(nom, ""))));
    }

    /** Compare l'image et les étapes, qui doivent concorder. */
    private void confronter() {
        List<Verification> perdues = juge.verifications(v -> v.compte && !resultat.verdicts.get(v.id()).compte());
        List<String> autres = Reference.SCENES.keySet().stream().filter(scene -> !resultat.verdicts
                .get(GrilleDeNotation.IMAGE + "." + scene).compte()).collect(Collectors.toList());
        if (autres.isEmpty() && !perdues.isEmpty()) {
            resultat.regarder("image juste, mais " + perdues.size() + (perdues.size() > 1 ? " vérifications perdues, dont"
                    : " vérification perdue :") + " « " + perdues.get(0).titre + " »");
        } else if (perdues.isEmpty() && !autres.isEmpty()) {
            resultat.regarder("étapes toutes réussies, mais une autre image : « " + String.join(" », « ", autres) + " »"
                    + (resultat.classesFautives.isEmpty() ? "" : ", par " + String.join(", ", resultat.classesFautives)));
        }
        if (autres.isEmpty() && perdues.isEmpty()) {
            return;
        }
        DEHORS.forEach((quoi, noms) -> {
            String classes = noms.stream().flatMap(nom -> emploient(nom).stream()).distinct().collect(Collectors.joining(", "));
            if (!classes.isEmpty()) {
                resultat.regarder(String.format(quoi, classes));
            }
        });
        String scenes = juge.changees(SourcesDuCours.A_COMPLETER).stream().filter(c -> projet.texte(c).contains(".ini\""))
                .collect(Collectors.joining(", "));
        if (!scenes.isEmpty()) {
            resultat.regarder("ouvre une scène par son nom (" + scenes + ") : la correction donne la sienne");
        }
        String enFloat = String.join(", ", emploient("float"));
        if (!enFloat.isEmpty()) {
            String grain = "des calculs en float (" + enFloat + ") : de là peut venir du grain, que le cours évite par des double";
            resultat.remarques.add(0, grain);
            resultat.regarder(grain);
        }
    }

    /** Ajoute les fautes de compilation, d'abord celles qui coûtent des points. */
    private void compiler() {
        Set<String> perdues = resultat.verdicts.values().stream().filter(Verdict::rate).map(v -> v.classe).collect(Collectors.toSet());
        List<Faute> siennes = juge.siennes();
        siennes.sort(Comparator.comparing((Faute f) -> !perdues.contains(f.classe())).thenComparing(f -> f.remede.isEmpty()));
        siennes.forEach(f -> resultat.fautes.add(f.toString()));
        // là où git a laissé deux versions, ce que dit le compilateur ne sert à rien
        boolean coute = resultat.verdicts.values().stream().anyMatch(v -> v.neSeCompilePas() || v.etat == Etat.NON_EVALUABLE);
        siennes.stream().filter(f -> coute && projet.texte(f.classe()) != null && !projet.texte(f.classe()).contains("\n>>>>>>> "))
                .findFirst()
                .ifPresent(f -> resultat.aRegarder.add(0, "ne se compile pas : " + f + " ; pour juger le reste, réparez-la dans une "
                        + "copie du rendu, et jugez cette copie"));
    }
}
