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
import java.util.Set;
import java.util.TreeSet;
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

    private static final List<String> DU_COURS = SourcesDuCours.classes();

    /** Lecture de textes Java : voir {@link Lecteur#lire}. */
    public interface Lecture {
        Lecteur.Fichier[] lire(List<String> textes) throws Arret;
    }

    final String chemin;
    /** Le nom du fichier, sans son dossier ni « .java ». */
    private final String nu;
    /** Vrai si le fichier est dans le dossier du paquet qu'il déclare. */
    private final boolean aSaPlace;
    /** Le dossier où commencent les paquets. */
    final String racine;
    /** Le paquet, après correction. */
    String paquet;
    /** Remarques sur les corrections faites. */
    final List<String> remarques = new ArrayList<>();
    private final String texte;
    private final Lecteur.Fichier lu;
    private final List<Type> types;

    private Source(String chemin, byte[] octets, Lecteur.Fichier lu) {
        this.chemin = chemin;
        this.lu = lu;
        texte = decoder(octets);
        paquet = lu.paquet;
        types = lu.types;
        // macOS décompose les accents des noms de fichiers
        String compose = Normalizer.normalize(chemin, Normalizer.Form.NFC);
        nu = compose.replaceFirst("(?s).*/", "").replaceFirst("(?i)\\.java$", "");
        String dossier = compose.substring(0, compose.lastIndexOf('/') + 1);
        String suffixe = paquet.isEmpty() ? "lancer/" : Normalizer.normalize(paquet, Normalizer.Form.NFC).replace('.', '/') + "/";
        racine = dossier.endsWith(suffixe) ? dossier.substring(0, dossier.length() - suffixe.length()) : dossier;
        aSaPlace = paquet.isEmpty() || dossier.endsWith(suffixe);
        if (codage(octets) != StandardCharsets.UTF_8) {
            remarques.add("n'est pas en UTF-8, lu en " + codage(octets).name());
        }
    }

    /** Les classes de ces textes du cours, par leur nom. */
    public static Map<String, Type> duCours(Lecture lecture, UnaryOperator<String> texte) throws Arret {
        List<String> textes = DU_COURS.stream().map(texte).collect(Collectors.toList());
        return Stream.of(lecture.lire(textes)).map(lu -> lu.types.get(0)).collect(Collectors.toMap(t -> t.nom, t -> t));
    }

    /** Les classes de ces fichiers. @param remarques reçoit les fichiers illisibles */
    static List<Type> lire(Map<String, byte[]> octets, Lecture lecture, List<String> remarques) throws Arret {
        Iterator<Lecteur.Fichier> lus = Arrays.asList(lecture.lire(octets.values().stream().map(Source::decoder)
                .collect(Collectors.toList()))).iterator();
        List<Source> fichiers = new ArrayList<>();
        for (String chemin : octets.keySet()) {
            Lecteur.Fichier lu = lus.next();
            if (lu == null) {
                remarques.add(chemin + Contenu.DE_COTE + "le compilateur ne peut pas le lire : trop de parenthèses, ou d'accolades, l'une "
                        + "dans l'autre");
            } else {
                fichiers.add(new Source(chemin, octets.get(chemin), lu));
            }
        }
        Set<String> paquets = fichiers.stream().filter(Source::declare).map(f -> f.paquet)
                .collect(Collectors.toCollection(TreeSet::new));
        return fichiers.stream().flatMap(f -> f.classes(paquets).stream()).collect(Collectors.toList());
    }

    /** Dit s'il déclare une classe du cours. */
    private boolean declare() {
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
            remarques.add(paquet.isEmpty() ? "la ligne « package lancer; » manque" : "le paquet est « " + paquets.stream()
                    .filter(p -> !p.isEmpty() && !p.equals("lancer")).collect(Collectors.joining(" », « ")) + " » au lieu de « lancer »");
            paquet = "lancer";
        }
        return neuf.toString();
    }

    /** Ses classes, chacune avec son texte, aux mêmes lignes. Un fichier de plusieurs classes, dont une du cours, est séparé. */
    private List<Type> classes(Set<String> paquets) {
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
            remarques.add("contient plusieurs classes (" + types.stream().map(t -> t.nom).collect(Collectors.joining(", "))
                    + ") : jugées à part");
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
