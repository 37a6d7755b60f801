package lancer.correction.depot;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.correction.modele.Modele;

/**
 * Les classes d'un rendu : celles de la base, et celles de chaque variante, retrouvées où que l'étudiant les ait mises.
 */
public final class Projet {

    public static final List<String> VARIANTES = List.of("brume", "antialias", "blinn");

    private static final Pattern VARIANTE =
            Pattern.compile("(?i)(?:^|/)[^/]*?(brume|antialias|anti-alias|anticrenelage|blinn)[^/]*/");
    private static final Pattern DE_TEST = Pattern.compile("(?:^|.*/)src/test/.*");

    private final Map<String, String> base;
    private final Map<String, Map<String, String>> variantes;
    private final List<String> remarques;

    /** @param base texte de chaque fichier, par nom de classe complet : {@code lancer/Vecteur} */
    public Projet(Map<String, String> base, Map<String, Map<String, String>> variantes, List<String> remarques) {
        this.base = base;
        this.variantes = variantes;
        this.remarques = remarques;
    }

    public static Projet lire(Rendu rendu) {
        List<String> remarques = new ArrayList<>(rendu.getRemarques());
        Map<String, Map<String, List<Source>>> groupes = new TreeMap<>();
        for (Map.Entry<String, byte[]> fichier : rendu.getSources().entrySet()) {
            for (Source source : Source.lire(fichier.getKey(), fichier.getValue())) {
                // Tests, Etapes : ce sont les nôtres qui notent, pas la copie de l'étudiant
                if (!DE_TEST.matcher(source.chemin).matches()
                        && !List.of("Tests", "Etapes", "module-info", "package-info").contains(source.classe)) {
                    Matcher m = VARIANTE.matcher(source.racine);
                    String partie = m.find() ? variante(m.group(1)) : "";
                    groupes.computeIfAbsent(partie, p -> new TreeMap<>())
                            .computeIfAbsent(source.racine, r -> new ArrayList<>()).add(source);
                }
            }
        }
        Map<String, Map<String, String>> variantes = new LinkedHashMap<>();
        for (String nom : VARIANTES) {
            if (groupes.containsKey(nom)) {
                variantes.put(nom, choisir(groupes.get(nom), remarques));
            }
        }
        Map<String, String> base = choisir(groupes.getOrDefault("", Collections.emptyMap()), remarques);
        if (base.isEmpty() && !variantes.isEmpty()) {
            // une variante est une copie complète du projet
            String premiere = variantes.keySet().iterator().next();
            remarques.add("pas de projet de base : celui de « " + premiere + " » en tient lieu");
            base = variantes.get(premiere);
        }
        return new Projet(base, variantes, remarques);
    }

    private static String variante(String mot) {
        String bas = mot.toLowerCase();
        return bas.startsWith("anti") ? "antialias" : bas;
    }

    /**
     * Des dossiers qui contiennent des classes, celui qui en a le plus du cours ; les autres n'ajoutent que ce qui lui
     * manque.
     */
    private static Map<String, String> choisir(Map<String, List<Source>> groupes, List<String> remarques) {
        List<String> racines = new ArrayList<>(groupes.keySet());
        racines.sort((a, b) -> {
            int n = Long.compare(duCours(groupes.get(b)), duCours(groupes.get(a)));
            return n != 0 ? n : Integer.compare(a.length(), b.length());
        });
        Map<String, String> classes = new TreeMap<>();
        for (String racine : racines) {
            long deja = groupes.get(racine).stream().filter(s -> classes.containsKey("lancer/" + s.classe)).count();
            if (deja > 2) {
                remarques.add("plusieurs copies du projet : jugée, « " + racines.get(0) + " » ; laissée, « " + racine
                        + " »");
                continue;
            }
            for (Source source : groupes.get(racine)) {
                String nom = source.paquet.isEmpty() ? source.classe : source.paquet.replace('.', '/') + "/"
                        + source.classe;
                String intrusion = source.intrusion();
                if (intrusion != null) {
                    remarques.add(source.chemin + " : laissé de côté, " + intrusion);
                } else if (!classes.containsKey(nom)) {
                    classes.put(nom, source.paquet.equals("lancer")
                            ? Ponts.ajouter(source.classe, source.texte, remarques) : source.texte);
                    if (source.remarque != null) {
                        remarques.add(source.remarque);
                    }
                }
            }
        }
        return classes;
    }

    private static long duCours(List<Source> sources) {
        return sources.stream().filter(s -> Modele.A_COMPLETER.contains(s.classe)).count();
    }

    /** Les classes de la base : {@code lancer/Vecteur} et son texte. */
    public Map<String, String> getBase() {
        return Collections.unmodifiableMap(base);
    }

    /** Celles de chaque variante rendue. */
    public Map<String, Map<String, String>> getVariantes() {
        return Collections.unmodifiableMap(variantes);
    }

    public List<String> getRemarques() {
        return remarques;
    }

    /** Le texte d'une classe du cours, {@code null} si elle n'est pas rendue. */
    public String texte(String classe) {
        return base.get("lancer/" + classe);
    }
}
