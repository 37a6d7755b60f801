package lancer.correction.depot;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.lang.model.SourceVersion;
import lancer.correction.enfant.Texte;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.SourcesDuCours;

/** Un fichier d'un rendu, et ses classes lues par le JDK. Elles sont mises dans le paquet {@code lancer}, même s'il en nomme un autre. */
public final class Source {

    private static final int PAQUET_MAX = 200;
    private static final int CLASSE_MAX = 100;
    private static final Pattern RESERVES = Pattern.compile("(javax?|jdk|sun|com\\.sun|lancer\\.correction|"
            + "org\\.(junit|opentest4j|apiguardian|ini4j|eclipse))(\\..*)?");
    /** Les classes de la correction qui sont dans le paquet d'un rendu. */
    static final List<String> NOTRES = List.of("Appels", "Sonde");

    /** Les annotations que Java ou la correction définissent. */
    private static final Pattern CONNUES = Pattern.compile("Override|Deprecated|SuppressWarnings|FunctionalInterface|SafeVarargs"
            + "|(java|org\\.junit\\.jupiter)\\..*");
    private static final Pattern CONFLIT = Pattern.compile("(?m)^(<{7}|>{7}) ");

    private static final List<String> DU_COURS = SourcesDuCours.classes();

    /** Lecture de textes Java : voir {@link Lecteur#lire}. */
    public interface Lecture {
        Lecteur.Fichier[] lire(List<String> textes) throws Arret;

        /** Dit si le compilateur ne trouve aucune faute dans ces classes ; vrai là où il n'y a pas de compilateur. */
        default boolean compile(Map<String, String> classes) throws Arret {
            return true;
        }
    }

    final String chemin;
    /** Le nom du fichier, sans son dossier ni « .java ». */
    private final String nu;
    /** Vrai si le fichier est dans le dossier du paquet qu'il déclare. */
    private final boolean aSaPlace;
    final String dossier;
    /** Le dossier où commencent les paquets. */
    final String racine;
    /** Le paquet, après correction. */
    String paquet;
    /** Remarques sur les corrections faites, et la consigne que chacune concerne, vide si ce n'est aucune. */
    final Map<String, String> remarques = new TreeMap<>();
    final List<Type> types;
    private final String texte;
    private final Lecteur.Fichier lu;

    /** @param declares les noms des classes du rendu */
    private Source(String chemin, byte[] octets, Lecteur.Fichier lu, Set<String> declares) {
        this.chemin = chemin;
        this.lu = lu;
        texte = sansAnnotations(decoder(octets), declares);
        paquet = lu.paquet;
        types = lu.types;
        // macOS décompose les accents des noms de fichiers
        String compose = Normalizer.normalize(chemin, Normalizer.Form.NFC);
        nu = compose.replaceFirst("(?s).*/", "").replaceFirst("(?i)\\.java$", "");
        dossier = compose.substring(0, compose.lastIndexOf('/') + 1);
        String suffixe = paquet.isEmpty() ? "lancer/" : Normalizer.normalize(paquet, Normalizer.Form.NFC).replace('.', '/') + "/";
        racine = dossier.endsWith(suffixe) ? dossier.substring(0, dossier.length() - suffixe.length()) : dossier;
        aSaPlace = paquet.isEmpty() || dossier.endsWith(suffixe);
        if (codage(octets) != StandardCharsets.UTF_8) {
            remarques.put("n'est pas en UTF-8, lu en " + codage(octets).name(), Projet.TEXTE);
        }
        if (CONFLIT.matcher(texte).find()) {
            remarques.put("des marques de conflit de git (<<<<<<<, >>>>>>>) y restent : il faut choisir une des deux versions", "");
        }
    }

    /** Les classes de ces textes du cours, par leur nom. */
    public static Map<String, Type> duCours(Lecture lecture, UnaryOperator<String> texte) throws Arret {
        List<String> textes = DU_COURS.stream().map(texte).collect(Collectors.toList());
        return Stream.of(lecture.lire(textes)).map(lu -> lu.types.get(0)).collect(Collectors.toMap(t -> t.nom, t -> t));
    }

    /** Ces fichiers, lus. @param illisibles reçoit ceux qui ne le sont pas */
    static List<Source> lire(Map<String, byte[]> octets, Lecture lecture, List<String> illisibles) throws Arret {
        List<Lecteur.Fichier> lus = Arrays.asList(lecture.lire(octets.values().stream().map(Source::decoder).collect(Collectors.toList())));
        Set<String> declares = lus.stream().filter(Objects::nonNull).flatMap(f -> f.types.stream()).map(t -> t.nom)
                .collect(Collectors.toSet());
        List<Source> fichiers = new ArrayList<>();
        Iterator<Lecteur.Fichier> suite = lus.iterator();
        octets.forEach((chemin, siens) -> {
            Lecteur.Fichier lu = suite.next();
            if (lu == null) {
                illisibles.add(chemin + Contenu.DE_COTE + "le compilateur ne peut pas le lire : trop de parenthèses, ou d'accolades, l'une "
                        + "dans l'autre");
            } else {
                fichiers.add(new Source(chemin, siens, lu, declares));
            }
        });
        return fichiers;
    }

    /** Ce texte, où des blancs remplacent les annotations que rien ne définit, et leurs importations. */
    private String sansAnnotations(String lui, Set<String> declares) {
        List<Lecteur.Nom> inconnues = lu.annotations.stream().filter(a -> inconnue(a.texte, declares)).collect(Collectors.toList());
        inconnues.forEach(a -> remarques.put("jugé sans l'annotation @" + a.texte + ", que rien ne définit ici", ""));
        StringBuilder reste = new StringBuilder(lui);
        Stream.concat(inconnues.stream(), lu.importations.stream().filter(i -> inconnues.stream()
                .anyMatch(a -> i.texte.endsWith("." + a.texte)))).filter(q -> q.debut >= 0 && q.fin > q.debut)
                .forEach(q -> reste.replace(q.debut, q.fin, lui.substring(q.debut, q.fin).replaceAll("[^\n]", " ")));
        return reste.toString();
    }

    /** Dit si rien ne définit cette annotation : ni Java, ni le rendu, ni ce que la correction fournit. */
    private boolean inconnue(String nom, Set<String> declares) {
        String complet = lu.importations.stream().map(i -> i.texte).filter(i -> i.endsWith("." + nom)).findFirst().orElse(nom);
        return !CONNUES.matcher(complet).matches() && Stream.of(complet.split("\\.")).noneMatch(declares::contains);
    }

    /** Dit s'il déclare une classe du cours. */
    boolean declare() {
        return types.stream().anyMatch(t -> DU_COURS.contains(t.nom));
    }

    /** De plusieurs fichiers de cette classe, le sien a le plus petit rang. Un fichier vide, ou tout en commentaire, a le plus grand. */
    int rang(String classe) {
        int place = aSaPlace ? 0 : 1;
        if (types.isEmpty() && lu.fautes.isEmpty()) {
            return 4 + place;
        }
        return (nu.equals(classe) ? 0 : 2) + place;
    }

    /** L'en-tête, aux mêmes lignes, où ces paquets sont remplacés par {@code lancer}. */
    private String arranger(Set<String> paquets) {
        StringBuilder neuf = new StringBuilder();
        int la = 0;
        for (Lecteur.Nom nom : lu.noms) {
            // les noms viennent du plus long au plus court : le paquet remplacé est le plus long
            if (nom.debut >= la && paquets.contains(nom.texte)) {
                neuf.append(texte, la, nom.debut).append("lancer").append(texte.substring(nom.debut, nom.fin).replaceAll("[^\n]", ""));
                la = nom.fin;
            }
        }
        neuf.append(texte, la, lu.entete);
        if (paquets.contains(paquet) && !paquet.equals("lancer")) {
            // sur la première ligne : les numéros de ligne de l'étudiant ne changent pas
            neuf.insert(0, paquet.isEmpty() ? "package lancer; " : "");
            String autres = paquets.stream().filter(p -> !p.equals("lancer")).map(p -> p.isEmpty() ? "aucun" : "« " + p + " »")
                    .collect(Collectors.joining(", "));
            remarques.put(autres.equals("aucun") ? "la ligne « package lancer; » manque"
                    : "le paquet est " + autres + " au lieu de « lancer »", Projet.NOMS);
            paquet = "lancer";
        }
        return neuf.toString();
    }

    /** Ses classes, chacune avec son texte, aux mêmes lignes. Un fichier de plusieurs classes, dont une du cours, est séparé. */
    List<Type> classes(Set<String> paquets) {
        String debut = arranger(paquets);
        // « Vecteur (1).java », « AncienVecteur.java » : le nom déclaré est plus sûr que celui du fichier
        String nom = types.size() == 1 || !deClasse(nu) && !types.isEmpty() ? types.get(0).nom : nu;
        // une faute de syntaxe hors de toute classe peut avoir changé les limites des classes
        if (types.size() < 2 || types.size() > Lecteur.CLASSES_MAX || !declare() || types.get(0).debut < lu.entete
                || !lu.fautes.stream().allMatch(f -> types.stream().anyMatch(t -> t.debut <= f && f <= t.fin))) {
            Type sien = types.stream().filter(t -> t.nom.equals(nom)).findFirst().orElse(Type.rien(nom));
            return List.of(sien.placer(this, debut + texte.substring(lu.entete), texte.length() - sien.fin));
        }
        if (types.stream().anyMatch(t -> DU_COURS.contains(t.nom) && !t.nom.equals(nom))) {
            remarques.put("contient plusieurs classes (" + types.stream().map(t -> t.nom).collect(Collectors.joining(", "))
                    + ") : jugées à part", Projet.NOMS);
        }
        int avant = lu.entete;
        for (Type t : types) {
            t.placer(this, debut + texte.substring(lu.entete, avant).replaceAll("[^\n]", " ") + texte.substring(avant, t.fin), 0);
            avant = t.fin;
        }
        return types;
    }

    /** Raison d'ignorer cette classe : son nom n'en est pas un, ou appartient à un autre. */
    String intrusion(String classe) {
        if (!deClasse(classe) || !paquet.isEmpty() && (!SourceVersion.isName(paquet) || paquet.length() > PAQUET_MAX)) {
            return "« " + paquet + " », « " + classe + " » : ce ne sont pas des noms de paquet et de classe";
        } else if (RESERVES.matcher(paquet).matches()) {
            return "le paquet « " + paquet + " » n'est pas à vous";
        } else if (types.size() > Lecteur.CLASSES_MAX) {
            return "il déclare plus de " + Lecteur.CLASSES_MAX + " classes";
        }
        return types.stream().map(t -> t.nom).filter(nom -> paquet.equals("lancer") && NOTRES.contains(nom)).findFirst()
                .map(nom -> "il déclare une classe " + nom + " qui cacherait celle de la correction").orElse(null);
    }

    /** Dit si une classe peut avoir ce nom, dans toutes les langues ; il fait aussi un nom de fichier. */
    private static boolean deClasse(String nom) {
        return SourceVersion.isIdentifier(nom) && nom.length() <= CLASSE_MAX && !Texte.NUISIBLES.matcher(nom).find();
    }

    /** Le texte, décodé, sans marque d'ordre des octets, avec des fins de ligne {@code \n}. */
    public static String decoder(byte[] octets) {
        return new String(octets, codage(octets)).replace("\uFEFF", "").replace("\r\n", "\n").replace('\r', '\n');
    }

    public static Charset codage(byte[] octets) {
        if (octets.length >= 2 && (octets[0] == (byte) 0xFE && octets[1] == (byte) 0xFF || octets[0] == (byte) 0xFF
                && octets[1] == (byte) 0xFE)) {
            return StandardCharsets.UTF_16;
        }
        // UTF-16 sans marque : en Java, un octet sur deux est presque toujours nul
        long[] nuls = IntStream.range(0, 2).mapToLong(k -> IntStream.range(0, octets.length / 2).filter(n -> octets[2 * n + k] == 0)
                .count()).toArray();
        if (4 * Math.max(nuls[0], nuls[1]) > octets.length) {
            return nuls[0] > nuls[1] ? StandardCharsets.UTF_16BE : StandardCharsets.UTF_16LE;
        }
        try {
            StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(octets));
            return StandardCharsets.UTF_8;
        } catch (CharacterCodingException e) {
            return Charset.isSupported("windows-1252") ? Charset.forName("windows-1252") : StandardCharsets.ISO_8859_1;
        }
    }
}
