package lancer.correction.depot;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.correction.enfant.Lecteur;
import lancer.correction.isolement.Arret;

/**
 * Une classe d'un rendu : son texte, quel qu'en soit le codage, dans le paquet {@code lancer}, même si l'étudiant a changé ou oublié
 * ce paquet. C'est le JDK qui dit ce qu'un fichier déclare, et où.
 */
public final class Source {

    /** Motif de ce dont on peut faire un nom de fichier : rien qui sorte de son dossier, et rien de trop long. */
    private static final Pattern NOM_DE_PAQUET = Pattern.compile("(?!.{201})(?:\\w++(?:\\.\\w++)*+)?");
    private static final Pattern NOM_DE_CLASSE = Pattern.compile("[\\p{L}_$][\\p{L}\\p{N}_$]{0,99}+");
    private static final Pattern RESERVES = Pattern.compile("(javax?|jdk|sun|com\\.sun|lancer\\.correction|"
            + "org\\.(junit|opentest4j|apiguardian|ini4j|eclipse))(\\..*)?");
    private static final List<String> NOTRES = List.of("Appels", "Sonde");

    final Fichier fichier;
    final String classe;
    final String texte;
    final Type type;
    /** Où finit cette classe dans ce texte ; négatif si on ne le sait pas. */
    private final int fin;

    private Source(Fichier fichier, String classe, String texte, Type type, int fin) {
        this.fichier = fichier;
        this.classe = classe;
        this.texte = texte;
        this.type = type;
        this.fin = fin;
    }

    /** Les classes que déclare un fichier, telles que le JDK les lit. */
    static List<Type> types(List<?> lu, String texte) {
        return ((List<?>) lu.get(5)).stream().map(t -> new Type((List<?>) t, texte)).collect(Collectors.toList());
    }

    /** Un fichier, et ce que le JDK en lit. */
    static final class Fichier {

        final String chemin;
        /** Le dossier où commencent les paquets. */
        final String racine;
        /** Le paquet, une fois arrangé. */
        String paquet;
        /** Remarques sur ce qu'il a fallu arranger. */
        final List<String> remarques = new ArrayList<>();
        private final String texte;
        private final List<?> lu;
        private final int entete;
        private final List<Type> types;

        Fichier(String chemin, byte[] octets, List<?> lu) {
            this.chemin = chemin;
            this.lu = lu;
            texte = decoder(octets);
            paquet = (String) lu.get(0);
            entete = (Integer) lu.get(3);
            types = types(lu, texte);
            String dossier = chemin.substring(0, chemin.lastIndexOf('/') + 1);
            String suffixe = paquet.isEmpty() ? "lancer/" : paquet.replace('.', '/') + "/";
            racine = dossier.endsWith(suffixe) ? dossier.substring(0, dossier.length() - suffixe.length()) : dossier;
            if (codage(octets) != StandardCharsets.UTF_8) {
                remarques.add("n'est pas en UTF-8, lu en " + codage(octets).name());
            }
        }

        boolean declare(Set<String> noms) {
            return types.stream().anyMatch(t -> noms.contains(t.nom));
        }

        /** L'en-tête, aux mêmes lignes, où ces paquets sont {@code lancer}. */
        private String arranger(Set<String> paquets, String autres) {
            StringBuilder neuf = new StringBuilder(texte.substring(0, entete));
            List<?> importations = (List<?>) lu.get(4);
            for (int k = importations.size() - 1; k >= 0; k--) {
                String nom = (String) ((List<?>) importations.get(k)).get(0);
                int debut = (Integer) ((List<?>) importations.get(k)).get(1);
                paquets.stream().filter(p -> !p.isEmpty() && nom.startsWith(p + ".") && neuf.indexOf(p, debut) == debut)
                        .max(Comparator.comparing(String::length)).ifPresent(p -> neuf.replace(debut, debut + p.length(), "lancer"));
            }
            if (paquets.contains(paquet) && paquet.isEmpty()) {
                // sur la première ligne : les numéros des autres restent ceux de l'étudiant
                neuf.insert(0, "package lancer; ");
                remarques.add("la ligne « package lancer; » manque");
                paquet = "lancer";
            } else if (paquets.contains(paquet) && !paquet.equals("lancer")) {
                int debut = (Integer) lu.get(1);
                int fin = (Integer) lu.get(2);
                neuf.replace(debut, fin, "lancer" + texte.substring(debut, fin).replaceAll("[^\n]", ""));
                remarques.add("le paquet est « " + autres + " » au lieu de « lancer »");
                paquet = "lancer";
            }
            return neuf.toString();
        }

        /** Une source pour chaque classe, à ses lignes, si plusieurs, dont une du cours, se partagent la place. */
        private List<Source> sources(Set<String> paquets, Set<String> duCours, String autres) {
            String debut = arranger(paquets, autres);
            String nu = chemin.replaceFirst("(?s).*/", "").replaceFirst("(?i)\\.java$", "");
            // « Vecteur (1).java », « Copie de Vecteur.java » : ce qu'il déclare dit mieux ce qu'il est
            String classe = !NOM_DE_CLASSE.matcher(nu).matches() && !types.isEmpty() ? types.get(0).nom : nu;
            // une faute hors de toute classe peut en avoir changé les limites
            if (types.size() < 2 || types.size() > Lecteur.CLASSES_MAX || !declare(duCours) || types.get(0).debut < entete
                    || !((List<?>) lu.get(6)).stream().map(Integer.class::cast)
                    .allMatch(f -> types.stream().anyMatch(t -> t.debut <= f && f <= t.fin))) {
                Type sien = types.stream().filter(t -> t.nom.equals(classe)).findFirst().orElse(Type.RIEN);
                return List.of(new Source(this, classe, debut + texte.substring(entete), sien,
                        sien.fin > entete ? sien.fin + debut.length() - entete : -1));
            }
            if (types.stream().anyMatch(t -> duCours.contains(t.nom) && !t.nom.equals(classe))) {
                remarques.add("contient plusieurs classes (" + types.stream().map(t -> t.nom).collect(Collectors.joining(", "))
                        + ") : jugées à part");
            }
            return IntStream.range(0, types.size()).mapToObj(k -> {
                int avant = k == 0 ? entete : types.get(k - 1).fin;
                String sienne = debut + texte.substring(entete, avant).replaceAll("[^\n]", " ") + texte.substring(avant, types.get(k).fin);
                return new Source(this, types.get(k).nom, sienne, types.get(k), sienne.length());
            }).collect(Collectors.toList());
        }
    }

    /**
     * Les classes de ces fichiers.
     *
     * @param duCours les noms des classes du cours, et ceux qu'il leur donne ; @param remarques reçoit les fichiers que l'on n'a pu lire
     */
    static List<Source> lire(Map<String, byte[]> octets, Cours.Lecture lecture, Set<String> duCours, List<String> remarques) throws Arret {
        List<?> lus = lecture.lire(octets.values().stream().map(Source::decoder).collect(Collectors.toList()));
        List<Fichier> fichiers = new ArrayList<>();
        int rang = 0;
        for (String chemin : octets.keySet()) {
            List<?> lu = (List<?>) lus.get(rang++);
            if (lu == null) {
                remarques.add(chemin + Projet.DE_COTE + "le compilateur ne peut pas le lire : trop de parenthèses, ou d'accolades, l'une "
                        + "dans l'autre");
            } else {
                fichiers.add(new Fichier(chemin, octets.get(chemin), lu));
            }
        }
        Set<String> paquets = fichiers.stream().filter(f -> f.declare(duCours)).map(f -> f.paquet)
                .collect(Collectors.toCollection(TreeSet::new));
        String autres = paquets.stream().filter(p -> !p.isEmpty() && !p.equals("lancer")).collect(Collectors.joining(" », « "));
        return fichiers.stream().flatMap(f -> f.sources(paquets, duCours, autres).stream()).collect(Collectors.toList());
    }

    /** Raison pour laquelle elle est à laisser de côté : ce que déclare son fichier cacherait ce qui ne lui appartient pas. */
    String intrusion() {
        String paquet = fichier.paquet;
        if (!NOM_DE_PAQUET.matcher(paquet).matches() || !NOM_DE_CLASSE.matcher(classe).matches()) {
            return "« " + paquet + " », « " + classe + " » : ce ne sont pas des noms de paquet et de classe";
        } else if (RESERVES.matcher(paquet).matches()) {
            return "le paquet « " + paquet + " » n'est pas à vous";
        } else if (fichier.types.size() > Lecteur.CLASSES_MAX) {
            return "il déclare plus de " + Lecteur.CLASSES_MAX + " classes";
        }
        return fichier.types.stream().map(t -> t.nom).filter(nom -> paquet.equals("lancer") && estPrise(nom)).findFirst()
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

    /** Le texte, où ceci est ajouté à la fin de la classe. */
    String avec(String membres) {
        return membres.isEmpty() || fin < 1 || texte.charAt(fin - 1) != '}' ? texte
                : texte.substring(0, fin - 1) + membres + " " + texte.substring(fin - 1);
    }

    /** Le texte, quel qu'en soit le codage, sans marque d'ordre des octets, et ses lignes finies par {@code \n}. */
    public static String decoder(byte[] octets) {
        return new String(octets, codage(octets)).replace("\uFEFF", "").replace("\r\n", "\n").replace('\r', '\n');
    }

    private static Charset codage(byte[] octets) {
        if (octets.length >= 2 && (octets[0] == (byte) 0xFE && octets[1] == (byte) 0xFF || octets[0] == (byte) 0xFF
                && octets[1] == (byte) 0xFE)) {
            return StandardCharsets.UTF_16;
        }
        // sans marque : en Java, une lettre sur deux octets a presque toujours le même nul, avant ou après
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
