package lancer.correction.depot;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.correction.enfant.Contenu;
import lancer.correction.enfant.Lecteur;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.SourcesDuCours;

/** Un fichier d'un rendu, et ses classes lues par le JDK. Elles sont mises dans le paquet {@code lancer}, même s'il en nomme un autre. */
public final class Source {

    /** Motif d'un nom utilisable comme nom de fichier : court, et sans séparateur de dossiers. */
    private static final Pattern NOM_DE_PAQUET = Pattern.compile("(?!.{201})(?:\\w++(?:\\.\\w++)*+)?");
    private static final Pattern NOM_DE_CLASSE = Pattern.compile("[\\p{L}_$][\\p{L}\\p{N}_$]{0,99}+");
    private static final Pattern RESERVES = Pattern.compile("(javax?|jdk|sun|com\\.sun|lancer\\.correction|"
            + "org\\.(junit|opentest4j|apiguardian|ini4j|eclipse))(\\..*)?");
    private static final List<String> NOTRES = List.of("Appels", "Sonde");

    private static final List<String> DU_COURS = SourcesDuCours.classes();

    /** Lecture de textes Java : une valeur par texte, celle de {@link Lecteur#lire}. */
    public interface Lecture {
        List<?> lire(List<String> textes) throws Arret;
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
    private final List<?> lu;
    private final int entete;
    private final List<Type> types;

    private Source(String chemin, byte[] octets, List<?> lu) {
        this.chemin = chemin;
        this.lu = lu;
        texte = decoder(octets);
        paquet = (String) lu.get(0);
        entete = (Integer) lu.get(1);
        types = types(lu, texte);
        nu = chemin.replaceFirst("(?s).*/", "").replaceFirst("(?i)\\.java$", "");
        String dossier = chemin.substring(0, chemin.lastIndexOf('/') + 1);
        String suffixe = paquet.isEmpty() ? "lancer/" : paquet.replace('.', '/') + "/";
        racine = dossier.endsWith(suffixe) ? dossier.substring(0, dossier.length() - suffixe.length()) : dossier;
        aSaPlace = paquet.isEmpty() || dossier.endsWith(suffixe);
        if (codage(octets) != StandardCharsets.UTF_8) {
            remarques.add("n'est pas en UTF-8, lu en " + codage(octets).name());
        }
    }

    /** Les classes que déclare un fichier, lues par le JDK. */
    static List<Type> types(List<?> lu, String texte) {
        return ((List<?>) lu.get(3)).stream().map(t -> new Type((List<?>) t, texte)).collect(Collectors.toList());
    }

    /** Les classes du projet à compléter, par leur nom. */
    public static Map<String, Type> squelette(Lecture lecture) throws Arret {
        List<String> textes = DU_COURS.stream().map(SourcesDuCours::squelette).collect(Collectors.toList());
        Iterator<?> lus = lecture.lire(textes).iterator();
        return textes.stream().map(t -> types((List<?>) lus.next(), t).get(0)).collect(Collectors.toMap(t -> t.nom, t -> t));
    }

    /** Les classes de ces fichiers. @param remarques reçoit les fichiers illisibles */
    static List<Type> lire(Map<String, byte[]> octets, Lecture lecture, List<String> remarques) throws Arret {
        Iterator<?> lus = lecture.lire(octets.values().stream().map(Source::decoder).collect(Collectors.toList())).iterator();
        List<Source> fichiers = new ArrayList<>();
        for (String chemin : octets.keySet()) {
            List<?> lu = (List<?>) lus.next();
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

    /** De plusieurs fichiers qui déclarent cette classe, le sien a le plus petit rang. */
    int rang(String classe) {
        return (nu.equals(classe) ? 0 : 2) + (aSaPlace ? 0 : 1);
    }

    /** L'en-tête, aux mêmes lignes, où ces paquets sont remplacés par {@code lancer}. */
    private String arranger(Set<String> paquets) {
        StringBuilder neuf = new StringBuilder();
        int la = 0;
        for (Object nom : (List<?>) lu.get(2)) {
            int debut = (Integer) ((List<?>) nom).get(1);
            // les noms viennent du plus long au plus court : le paquet remplacé est le plus long
            if (debut >= la && paquets.contains(((List<?>) nom).get(0))) {
                int fin = (Integer) ((List<?>) nom).get(2);
                neuf.append(texte, la, debut).append("lancer").append(texte.substring(debut, fin).replaceAll("[^\n]", ""));
                la = fin;
            }
        }
        neuf.append(texte, la, entete);
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
        String nom = types.size() == 1 || !NOM_DE_CLASSE.matcher(nu).matches() && !types.isEmpty() ? types.get(0).nom : nu;
        // une faute de syntaxe hors de toute classe peut avoir changé les limites des classes
        if (types.size() < 2 || types.size() > Lecteur.CLASSES_MAX || !declare() || types.get(0).debut < entete
                || !((List<?>) lu.get(4)).stream().map(Integer.class::cast)
                .allMatch(f -> types.stream().anyMatch(t -> t.debut <= f && f <= t.fin))) {
            Type sien = types.stream().filter(t -> t.nom.equals(nom)).findFirst().orElse(Type.rien(nom));
            return List.of(sien.placer(this, debut + texte.substring(entete), texte.length() - sien.fin));
        }
        if (types.stream().anyMatch(t -> DU_COURS.contains(t.nom) && !t.nom.equals(nom))) {
            remarques.add("contient plusieurs classes (" + types.stream().map(t -> t.nom).collect(Collectors.joining(", "))
                    + ") : jugées à part");
        }
        int avant = entete;
        for (Type t : types) {
            t.placer(this, debut + texte.substring(entete, avant).replaceAll("[^\n]", " ") + texte.substring(avant, t.fin), 0);
            avant = t.fin;
        }
        return types;
    }

    /** Raison d'ignorer cette classe : elle en cacherait une de Java ou de la correction. */
    String intrusion(String classe) {
        if (!NOM_DE_PAQUET.matcher(paquet).matches() || !NOM_DE_CLASSE.matcher(classe).matches()) {
            return "« " + paquet + " », « " + classe + " » : ce ne sont pas des noms de paquet et de classe";
        } else if (RESERVES.matcher(paquet).matches()) {
            return "le paquet « " + paquet + " » n'est pas à vous";
        } else if (types.size() > Lecteur.CLASSES_MAX) {
            return "il déclare plus de " + Lecteur.CLASSES_MAX + " classes";
        }
        return types.stream().map(t -> t.nom).filter(nom -> paquet.equals("lancer") && estPrise(nom)).findFirst()
                .map(nom -> "il déclare une classe " + nom + " qui cacherait celle de " + (NOTRES.contains(nom) ? "la correction" : "Java"))
                .orElse(null);
    }

    private static boolean estPrise(String nom) {
        try {
            return NOTRES.contains(nom) || Class.forName("java.lang." + nom, false, null) != null;
        } catch (ClassNotFoundException | LinkageError e) {
            return false;
        }
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
