package lancer.correction.depot;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.modele.Modele;

/**
 * Les noms du cours que l'étudiant a changés partout, là où un seul des siens peut en tenir lieu : c'est alors ce que
 * nous écrivons nous-mêmes, ce qui l'appelle et le corrigé, qui prend le sien. Son texte n'est jamais changé.
 */
public final class Renommage {

    private final Map<String, String> siennes;
    private final Map<String, String> noms = new LinkedHashMap<>();
    /** Phrases qui disent ce qui a changé de nom ou de place. */
    public final Set<String> changes = new LinkedHashSet<>();

    /** @param siennes le texte de chacune de ses classes, par nom complet */
    public Renommage(Map<String, String> siennes) {
        this.siennes = siennes;
        for (String classe : Modele.classes()) {
            Set<String> attendues = nommees(Methode.de(Modele.squelette(classe)));
            if (texte(classe) == null && attendues.size() > 3) {
                seul(siennes.keySet().stream().map(c -> c.replace("lancer/", "")).filter(c -> texte(c) != null
                        && !Modele.classes().contains(c) && nommees(Methode.de(texte(c))).containsAll(attendues))).ifPresent(sien -> {
                    noms.put(classe, sien);
                    changes.add("la classe " + classe + " s'appelle " + sien);
                });
            }
        }
        for (String classe : Modele.A_COMPLETER) {
            if (texte(classe(classe)) != null) {
                chercherMethodes(classe);
            }
        }
    }

    private void chercherMethodes(String classe) {
        List<Methode> duCours = Methode.de(Modele.squelette(classe));
        List<Methode> lesSiennes = Methode.de(texte(classe(classe)));
        Set<String> connues = nommees(duCours);
        for (Methode m : duCours) {
            if (nommees(lesSiennes).contains(m.nom) || nommees(lesSiennes).contains(dans(m.nom)) || m.nom.equals("toString")) {
                continue;
            }
            List<String> types = m.types.stream().map(this::dans).collect(Collectors.toList());
            Optional<String> sienne = seul(lesSiennes.stream().filter(s -> !connues.contains(s.nom) && s.types.equals(types)
                    && s.rend.equals(dans(m.rend))).map(s -> s.nom).distinct());
            if (sienne.isPresent()) {
                if (ailleurs(m.nom).count() == 0) {
                    noms.put(m.nom, sienne.get());
                }
                changes.add("la méthode " + classe + "." + m.nom + " s'appelle " + sienne.get());
            } else {
                seul(ailleurs(m.nom).filter(c -> !nommees(Methode.de(Modele.squelette(c))).contains(m.nom)))
                        .ifPresent(autre -> changes.add("la méthode " + m.nom + " est dans " + autre + ", au lieu de " + classe));
            }
        }
    }

    /** Les classes du cours où il a une méthode de ce nom. */
    private Stream<String> ailleurs(String methode) {
        return Modele.classes().stream().filter(c -> texte(classe(c)) != null
                && nommees(Methode.de(texte(classe(c)))).contains(methode));
    }

    /** Seul texte de ce flux ; aucun s'il n'y en a pas, ou s'il y en a plusieurs. */
    private static Optional<String> seul(Stream<String> flux) {
        List<String> liste = flux.limit(2).collect(Collectors.toList());
        return liste.size() == 1 ? Optional.of(liste.get(0)) : Optional.empty();
    }

    private String texte(String classe) {
        return siennes.get("lancer/" + classe);
    }

    private static Set<String> nommees(Collection<Methode> methodes) {
        return methodes.stream().map(m -> m.nom).collect(Collectors.toCollection(TreeSet::new));
    }

    /** Le nom qu'il donne à une classe du cours : le même, le plus souvent. */
    public String classe(String duCours) {
        return noms.getOrDefault(duCours, duCours);
    }

    /** Un texte à nous, où chaque nom du cours est celui qu'il lui donne. */
    public String dans(String texte) {
        return noms.isEmpty() ? texte : Pattern.compile("(?<!\")\\b(?:" + String.join("|", noms.keySet()) + ")\\b")
                .matcher(texte).replaceAll(m -> noms.get(m.group()));
    }

    /** Des classes à nous, par nom complet, où de même. */
    public Map<String, String> dans(Map<String, String> classes) {
        Map<String, String> autres = new LinkedHashMap<>();
        classes.forEach((nom, texte) -> autres.put("lancer/" + classe(nom.replace("lancer/", "")), dans(texte)));
        return autres;
    }
}
