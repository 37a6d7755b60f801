package lancer.correction.enfant;

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
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.stream.Collectors;
import javax.tools.Diagnostic;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * Lecture d'un fichier source par le JDK : paquet, classes, méthodes et leurs positions. Rien n'est compilé ni exécuté. Les réponses ne
 * contiennent que des listes, des textes et des nombres.
 */
public final class Lecteur {

    /** Nombre maximal de classes d'une réponse, puis de méthodes ou de noms. */
    public static final int CLASSES_MAX = 200;
    private static final int NOMS_MAX = 2000;

    /** Le compilateur du JDK, et non celui d'Eclipse. */
    private static final JavaCompiler JDK = ToolProvider.getSystemJavaCompiler();
    private static final StandardJavaFileManager GESTION = JDK.getStandardFileManager(null, null, StandardCharsets.UTF_8);

    private final CompilationUnitTree fichier;
    private final SourcePositions lieux;

    private Lecteur(CompilationUnitTree fichier, SourcePositions lieux) {
        this.fichier = fichier;
        this.lieux = lieux;
    }

    /**
     * Lit des fichiers. Pour chaque fichier : paquet, fin de l'en-tête, noms de l'en-tête, classes, positions des fautes de syntaxe. Pour
     * chaque nom de l'en-tête (le paquet, puis les préfixes de chaque importation, du plus long au plus court) : texte, début, fin. Pour
     * chaque classe : nom, début, fin, empreinte, noms utilisés, méthodes. Pour chaque méthode : nom, type de retour (vide pour un
     * constructeur), types des paramètres, modificateurs, début, fin, empreinte.
     *
     * @return une valeur par fichier, {@code null} si le lecteur échoue
     */
    public static List<?> lire(Collection<String> textes) {
        return textes.stream().map(Lecteur::lire).collect(Collectors.toList());
    }

    private static List<?> lire(String texte) {
        List<Integer> fautes = new ArrayList<>();
        JavacTask tache = (JavacTask) JDK.getTask(new StringWriter(), GESTION, faute -> {
            if (faute.getKind() == Diagnostic.Kind.ERROR && fautes.size() < NOMS_MAX) {
                fautes.add((int) faute.getPosition());
            }
        }, List.of("-proc:none"), null, List.of(new SimpleJavaFileObject(URI.create("memoire:///A.java"), JavaFileObject.Kind.SOURCE) {
            @Override
            public CharSequence getCharContent(boolean tel) {
                return texte;
            }
        }));
        try {
            return new Lecteur(tache.parse().iterator().next(), Trees.instance(tache).getSourcePositions()).fichier(fautes);
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

    private List<?> nom(Tree nom) {
        return List.of(String.valueOf(nom), debut(nom), fin(nom));
    }

    private List<?> fichier(List<Integer> fautes) {
        Tree paquet = fichier.getPackageName();
        int entete = fin(fichier.getPackage());
        List<List<?>> noms = new ArrayList<>(List.of(nom(paquet)));
        for (ImportTree importation : fichier.getImports()) {
            Tree nom = importation.getQualifiedIdentifier();
            for (; nom instanceof MemberSelectTree; nom = ((MemberSelectTree) nom).getExpression()) {
                noms.add(nom(((MemberSelectTree) nom).getExpression()));
            }
            entete = Math.max(entete, fin(importation));
        }
        return List.of(paquet == null ? "" : paquet.toString(), entete, noms, fichier.getTypeDecls().stream()
                .filter(ClassTree.class::isInstance).limit(CLASSES_MAX + 1).map(c -> classe((ClassTree) c)).collect(Collectors.toList()),
                fautes);
    }

    private List<?> classe(ClassTree classe) {
        Set<String> noms = new TreeSet<>();
        new TreeScanner<Void, Void>() {
            @Override
            public Void scan(Tree arbre, Void rien) {
                if (arbre instanceof IdentifierTree || arbre instanceof PrimitiveTypeTree) {
                    noms.add(arbre.toString());
                } else if (arbre instanceof VariableTree) {
                    noms.add(((VariableTree) arbre).getName().toString());
                } else if (arbre instanceof MemberSelectTree) {
                    String nom = ((MemberSelectTree) arbre).getIdentifier().toString();
                    noms.add(nom.equals("in") && arbre.toString().equals("System.in") ? "System.in" : nom);
                }
                return super.scan(arbre, rien);
            }
        }.scan(classe, null);
        return List.of(classe.getSimpleName().toString(), debut(classe), fin(classe), condense(classe.toString()), noms.stream()
                .limit(NOMS_MAX).collect(Collectors.toList()), classe.getMembers().stream().filter(MethodTree.class::isInstance)
                .limit(NOMS_MAX).map(m -> methode((MethodTree) m, classe)).collect(Collectors.toList()));
    }

    private List<?> methode(MethodTree methode, ClassTree classe) {
        boolean constructeur = methode.getReturnType() == null;
        return List.of((constructeur ? classe.getSimpleName() : methode.getName()).toString(),
                constructeur ? "" : type(methode.getReturnType()),
                methode.getParameters().stream().map(p -> type(p.getType())).collect(Collectors.toList()),
                methode.getModifiers().getFlags().toString(), debut(methode), fin(methode),
                condense(methode.getParameters() + " " + methode.getBody()));
    }

    /** L'arbre que le JDK écrit n'a ni commentaire, ni présentation. */
    private static String condense(String arbre) {
        return UUID.nameUUIDFromBytes(arbre.getBytes(StandardCharsets.UTF_8)).toString();
    }

    /** Le nom seul d'un type, sans paquet ni paramètres. */
    private static String type(Tree type) {
        return String.valueOf(type).replaceFirst("(?s)<.*", "").replaceFirst(".*\\.(?=\\w)", "");
    }
}
