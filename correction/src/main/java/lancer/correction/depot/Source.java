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

    final String chemin;
    final String classe;
    /** Le dossier où commencent les paquets. */
    final String racine;
    final String paquet;
    final String texte;
    final Type type;
    /** Où finit cette classe dans ce texte ; négatif si on ne le sait pas. */
    private final int fin;
    /** Remarques sur ce qu'il a fallu arranger. */
    final List<String> remarques;
    /** Raison pour laquelle elle est à laisser de côté, {@code null} s'il n'y en a pas. */
    final String intrusion;

    private Source(Fichier fichier, String classe, String texte, Type type, int fin, List<String> remarques) {
        chemin = fichier.chemin;
        racine = fichier.racine;
        paquet = fichier.arrive;
        this.classe = classe;
        this.texte = texte;
        this.type = type;
        this.fin = fin;
        this.remarques = remarques;
        intrusion = fichier.intrusion(classe);
    }

    /** Les classes que déclare un fichier, telles que le JDK les lit. */
    static List<Type> types(List<?> lu, String texte) {
        return ((List<?>) lu.get(5)).stream().map(t -> new Type((List<?>) t, texte)).collect(Collectors.toList());
    }

    /** Ce que le JDK lit d'un fichier. */
    private static final class Fichier {

        private final String chemin;
        private final String nu;
        private final String texte;
        private final List<?> lu;
        private final String paquet;
        private final int entete;
        private final List<Type> types;
        private final String racine;
        /** Le paquet où il arrive, une fois arrangé. */
        private String arrive;

        Fichier(String chemin, String texte, List<?> lu) {
            this.chemin = chemin;
            this.texte = texte;
            this.lu = lu;
            paquet = (String) lu.get(0);
            arrive = paquet;
            entete = (Integer) lu.get(3);
            types = types(lu, texte);
            String dossier = chemin.substring(0, chemin.lastIndexOf('/') + 1);
            nu = chemin.substring(dossier.length(), chemin.length() - ".java".length());
            String suffixe = paquet.isEmpty() ? "lancer/" : paquet.replace('.', '/') + "/";
            racine = dossier.endsWith(suffixe) ? dossier.substring(0, dossier.length() - suffixe.length()) : dossier;
        }

        boolean declare(Set<String> noms) {
            return types.stream().anyMatch(t -> noms.contains(t.nom));
        }

        /** L'en-tête, aux mêmes lignes, où ces paquets sont {@code lancer}. */
        private String arranger(Set<String> paquets) {
            StringBuilder neuf = new StringBuilder(texte.substring(0, entete));
            List<?> importations = (List<?>) lu.get(4);
            for (int k = importations.size() - 1; k >= 0; k--) {
                String nom = (String) ((List<?>) importations.get(k)).get(0);
                int debut = (Integer) ((List<?>) importations.get(k)).get(1);
                paquets.stream().filter(p -> !p.isEmpty() && nom.startsWith(p + ".") && neuf.indexOf(p, debut) == debut)
                        .max(Comparator.comparing(String::length)).ifPresent(p -> neuf.replace(debut, debut + p.length(), "lancer"));
            }
            if (!arrive.equals(paquet) && paquet.isEmpty()) {
                // sur la première ligne : les numéros des autres restent ceux de l'étudiant
                neuf.insert(0, "package lancer; ");
            } else if (!arrive.equals(paquet)) {
                int fin = (Integer) lu.get(2);
                neuf.replace((Integer) lu.get(1), fin, "lancer" + texte.substring((Integer) lu.get(1), fin).replaceAll("[^\n]", ""));
            }
            return neuf.toString();
        }

        /** Une source pour chaque classe, à ses lignes, si plusieurs, dont une du cours, se partagent la place. */
        List<Source> sources(Set<String> paquets, Set<String> duCours, String autres) {
            List<String> remarques = new ArrayList<>();
            if (paquets.contains(paquet) && !paquet.equals("lancer")) {
                arrive = "lancer";
                remarques.add(paquet.isEmpty() ? "la ligne « package lancer; » manque"
                        : "le paquet est « " + autres + " » au lieu de « lancer »");
            }
            String debut = arranger(paquets);
            // « Vecteur (1).java », « Copie de Vecteur.java » : ce qu'il déclare dit mieux ce qu'il est
            String classe = !NOM_DE_CLASSE.matcher(nu).matches() && !types.isEmpty() ? types.get(0).nom : nu;
            // une faute hors de toute classe peut en avoir changé les limites
            boolean separables = types.size() > 1 && types.size() <= Lecteur.CLASSES_MAX && declare(duCours) && types.get(0).debut >= entete
                    && ((List<?>) lu.get(6)).stream().allMatch(f -> types.stream().anyMatch(t -> t.debut <= (Integer) f && (Integer) f <= t.fin));
            if (!separables) {
                Type sien = types.stream().filter(t -> t.nom.equals(classe)).findFirst().orElse(Type.RIEN);
                return List.of(new Source(this, classe, debut + texte.substring(entete), sien,
                        sien.fin > entete ? sien.fin + debut.length() - entete : -1, remarques));
            }
            if (types.stream().anyMatch(t -> duCours.contains(t.nom) && !t.nom.equals(classe))) {
                remarques.add("contient plusieurs classes (" + types.stream().map(t -> t.nom).collect(Collectors.joining(", "))
                        + ") : jugées à part");
            }
            return IntStream.range(0, types.size()).mapToObj(k -> {
                int avant = k == 0 ? entete : types.get(k - 1).fin;
                String sienne = debut + texte.substring(entete, avant).replaceAll("[^\n]", " ") + texte.substring(avant, types.get(k).fin);
                return new Source(this, types.get(k).nom, sienne, types.get(k), sienne.length(), k == 0 ? remarques : List.of());
            }).collect(Collectors.toList());
        }

        /** Raison pour laquelle ce fichier est à laisser de côté : ce qu'il déclare cacherait ce qui ne lui appartient pas. */
        private String intrusion(String classe) {
            if (!NOM_DE_PAQUET.matcher(arrive).matches() || !NOM_DE_CLASSE.matcher(classe).matches()) {
                return "« " + arrive + " », « " + classe + " » : ce ne sont pas des noms de paquet et de classe";
            } else if (RESERVES.matcher(arrive).matches()) {
                return "le paquet « " + arrive + " » n'est pas à vous";
            } else if (types.size() > Lecteur.CLASSES_MAX) {
                return "il déclare plus de " + Lecteur.CLASSES_MAX + " classes";
            }
            return !arrive.equals("lancer") ? null : types.stream().map(t -> t.nom).filter(Source::estPrise).findFirst().map(nom ->
                    "il déclare une classe " + nom + " qui cacherait celle de " + (NOTRES.contains(nom) ? "la correction" : "Java"))
                    .orElse(null);
        }
    }

    private static final List<String> NOTRES = List.of("Appels", "Sonde");

    private static boolean estPrise(String nom) {
        try {
            return NOTRES.contains(nom) || Class.forName("java.lang." + nom, false, null) != null;
        } catch (ClassNotFoundException | LinkageError e) {
            return false;
        }
    }

    /**
     * Les classes de ces fichiers.
     *
     * @param duCours les noms des classes du cours, et ceux qu'il leur donne ; @param remarques reçoit les fichiers que l'on n'a pu lire
     */
    static List<Source> lire(Map<String, byte[]> octets, Cours.Lecture lecture, Set<String> duCours, List<String> remarques) throws Arret {
        List<String> textes = octets.values().stream().map(Source::decoder).collect(Collectors.toList());
        List<?> lus = lecture.lire(textes);
        List<Fichier> fichiers = new ArrayList<>();
        for (String chemin : octets.keySet()) {
            int k = fichiers.size();
            fichiers.add(lus.get(k) == null ? null : new Fichier(chemin, textes.get(k), (List<?>) lus.get(k)));
            if (lus.get(k) == null) {
                remarques.add(chemin + Projet.DE_COTE + "le compilateur ne peut pas le lire : trop de parenthèses, ou d'accolades, l'une "
                        + "dans l'autre");
            }
        }
        fichiers.removeIf(f -> f == null);
        Set<String> paquets = fichiers.stream().filter(f -> f.declare(duCours)).map(f -> f.paquet)
                .collect(Collectors.toCollection(TreeSet::new));
        String autres = paquets.stream().filter(p -> !p.isEmpty() && !p.equals("lancer")).collect(Collectors.joining(" », « "));
        List<Source> sources = new ArrayList<>();
        for (Fichier f : fichiers) {
            Charset codage = codage(octets.get(f.chemin));
            List<Source> siennes = f.sources(paquets, duCours, autres);
            if (codage != StandardCharsets.UTF_8) {
                siennes.get(0).remarques.add("n'est pas en UTF-8, lu en " + codage.name());
            }
            sources.addAll(siennes);
        }
        return sources;
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
        for (int k = 0; k < 2; k++) {
            int rang = k;
            if (octets.length > 1 && IntStream.range(0, octets.length / 2).filter(n -> octets[2 * n + rang] == 0).count() > octets.length / 4) {
                return k == 0 ? StandardCharsets.UTF_16BE : StandardCharsets.UTF_16LE;
            }
        }
        try {
            StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(octets));
            return StandardCharsets.UTF_8;
        } catch (CharacterCodingException e) {
            return Charset.isSupported("windows-1252") ? Charset.forName("windows-1252") : StandardCharsets.ISO_8859_1;
        }
    }
}
