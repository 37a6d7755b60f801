package lancer.correction.depot;

import com.sun.source.tree.AnnotationTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.ImportTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.PrimitiveTypeTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.regex.Pattern;
import javax.lang.model.element.Modifier;
import javax.lang.model.element.Name;
import javax.tools.Diagnostic;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * Lecture d'un fichier source par le JDK : paquet, classes, méthodes et leurs positions. Rien n'est compilé ni exécuté.
 */
public final class Lecteur {

    /** Nombre maximal de classes d'une réponse, puis de méthodes ou de noms. */
    public static final int CLASSES_MAX = 200;
    private static final int NOMS_MAX = 2000;

    /** Le compilateur du JDK, et non celui d'Eclipse. */
    private static final JavaCompiler JDK = ToolProvider.getSystemJavaCompiler();
    private static final StandardJavaFileManager GESTION = JDK.getStandardFileManager(null, null, StandardCharsets.UTF_8);

    /** Un fichier lu : son paquet, la fin de son en-tête, les noms de cet en-tête, ses classes, et les places de ses fautes de syntaxe. */
    public static final class Fichier {

        final String paquet;
        int entete;
        /** Le paquet, puis les préfixes de chaque importation, du plus long au plus court. */
        final List<Nom> noms = new ArrayList<>();
        /** Les importations, puis les annotations. */
        final List<Nom> importations = new ArrayList<>();
        final List<Nom> annotations = new ArrayList<>();
        final List<Type> types = new ArrayList<>();
        final List<Integer> fautes;

        Fichier(String paquet, List<Integer> fautes) {
            this.paquet = paquet;
            this.fautes = fautes;
        }
    }

    /** Un nom, et la place de ce qui le contient : un paquet, une importation, une annotation. */
    static final class Nom {

        final String texte;
        final int debut;
        final int fin;

        Nom(String texte, int debut, int fin) {
            this.texte = texte;
            this.debut = debut;
            this.fin = fin;
        }
    }

    /** Longueur d'une méthode que deux personnes n'écrivent pas pareil par hasard, en caractères de cet arbre. */
    private static final int LONGUE = 300;
    private static final Pattern NOM = Pattern.compile("[\\w$]+");

    private final String texte;
    private final CompilationUnitTree fichier;
    private final SourcePositions lieux;

    private Lecteur(String texte, CompilationUnitTree fichier, SourcePositions lieux) {
        this.texte = texte;
        this.fichier = fichier;
        this.lieux = lieux;
    }

    /** @return un fichier par texte, {@code null} si le lecteur échoue */
    static Fichier[] lire(Collection<String> textes) {
        return textes.stream().map(Lecteur::lire).toArray(Fichier[]::new);
    }

    private static Fichier lire(String texte) {
        List<Integer> fautes = new ArrayList<>();
        JavacTask tache = (JavacTask) JDK.getTask(new StringWriter(), GESTION, faute -> {
            if (faute.getKind() == Diagnostic.Kind.ERROR && fautes.size() < NOMS_MAX) {
                fautes.add((int) faute.getPosition());
            }
        }, List.of("-proc:none"), null, List.of(new Compilateur.EnMemoire("A.java", texte)));
        try {
            return new Lecteur(texte, tache.parse().iterator().next(), Trees.instance(tache).getSourcePositions()).fichier(fautes);
        } catch (IOException | RuntimeException | Error e) {
            // une imbrication trop profonde fait échouer le lecteur : les autres fichiers sont lus quand même
            return null;
        }
    }

    private int debut(Tree arbre) {
        return arbre == null ? 0 : (int) lieux.getStartPosition(fichier, arbre);
    }

    private int fin(Tree arbre) {
        return arbre == null ? 0 : (int) lieux.getEndPosition(fichier, arbre);
    }

    private Nom nom(Tree nom) {
        return new Nom(String.valueOf(nom), debut(nom), fin(nom));
    }

    private Fichier fichier(List<Integer> fautes) {
        Tree paquet = fichier.getPackageName();
        Fichier lu = new Fichier(paquet == null ? "" : paquet.toString(), fautes);
        lu.entete = fin(fichier.getPackage());
        lu.noms.add(nom(paquet));
        for (ImportTree importation : fichier.getImports()) {
            Tree nom = importation.getQualifiedIdentifier();
            lu.importations.add(new Nom(nom.toString(), debut(importation), fin(importation)));
            lu.entete = Math.max(lu.entete, fin(importation));
            for (; nom instanceof MemberSelectTree; nom = ((MemberSelectTree) nom).getExpression()) {
                lu.noms.add(nom(((MemberSelectTree) nom).getExpression()));
            }
        }
        fichier.getTypeDecls().stream().filter(ClassTree.class::isInstance).limit(CLASSES_MAX + 1)
                .forEach(c -> lu.types.add(classe((ClassTree) c)));
        new TreeScanner<Void, Void>() {
            @Override
            public Void visitAnnotation(AnnotationTree annotation, Void rien) {
                if (lu.annotations.size() < NOMS_MAX) {
                    lu.annotations.add(new Nom(annotation.getAnnotationType().toString(), debut(annotation), fin(annotation)));
                }
                return super.visitAnnotation(annotation, rien);
            }
        }.scan(fichier.getTypeDecls(), null);
        return lu;
    }

    private Type classe(ClassTree classe) {
        Set<String> noms = new TreeSet<>();
        Set<String> variables = new HashSet<>();
        new TreeScanner<Void, Void>() {
            @Override
            public Void scan(Tree arbre, Void rien) {
                if (arbre instanceof IdentifierTree || arbre instanceof PrimitiveTypeTree) {
                    noms.add(arbre.toString());
                } else if (arbre instanceof VariableTree) {
                    noms.add(((VariableTree) arbre).getName().toString());
                    variables.add(((VariableTree) arbre).getName().toString());
                } else if (arbre instanceof MemberSelectTree) {
                    noms.add(((MemberSelectTree) arbre).getIdentifier().toString());
                }
                return super.scan(arbre, rien);
            }
        }.scan(classe, null);
        Type lu = new Type(classe.getSimpleName().toString(), debut(classe), fin(classe), condense(classe.toString()));
        noms.stream().limit(NOMS_MAX).forEach(lu.noms::add);
        classe.getMembers().stream().filter(MethodTree.class::isInstance).limit(NOMS_MAX)
                .forEach(m -> lu.methodes.add(methode((MethodTree) m, classe, variables)));
        return lu;
    }

    private Signature methode(MethodTree methode, ClassTree classe, Set<String> variables) {
        boolean constructeur = methode.getReturnType() == null;
        Set<Modifier> modificateurs = methode.getModifiers().getFlags();
        int debut = Math.max(0, debut(methode));
        Name nom = constructeur ? classe.getSimpleName() : methode.getName();
        String rend = constructeur ? "" : type(methode.getReturnType());
        Signature lue = new Signature(nom.toString(), rend, modificateurs.contains(Modifier.STATIC),
                modificateurs.contains(Modifier.PRIVATE), texte.substring(debut, Math.max(debut, fin(methode))),
                condense(methode.getParameters() + " " + methode.getBody()));
        former(lue, methode, variables);
        methode.getParameters().forEach(p -> lue.types.add(type(p.getType())));
        return lue;
    }

    /** Donne à une méthode la forme de son arbre, où chaque variable a pour nom son rang ; aucune, si elle est courte. */
    private static void former(Signature lue, MethodTree methode, Set<String> variables) {
        Map<String, String> rangs = new HashMap<>();
        String forme = NOM.matcher(methode.getParameters() + " " + methode.getBody()).replaceAll(m -> variables.contains(m.group())
                ? rangs.computeIfAbsent(m.group(), nom -> "n" + rangs.size()) : m.group().replace("$", ""));
        lue.longueur = forme.length();
        lue.forme = forme.length() < LONGUE ? "" : condense(forme);
    }

    /** L'arbre que le JDK écrit n'a ni commentaire, ni présentation. */
    private static String condense(String arbre) {
        return UUID.nameUUIDFromBytes(arbre.getBytes(StandardCharsets.UTF_8)).toString();
    }

    /** Le nom seul d'un type, sans paquet ni paramètres. */
    private static String type(Tree type) {
        return String.valueOf(type).replaceFirst("(?s)<.*", "").replaceFirst(".*\\.(?=[\\w$])", "");
    }
}
