package lancer.correction.enfant;

import com.sun.source.tree.BlockTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.EmptyStatementTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.ImportTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MemberReferenceTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.ModifiersTree;
import com.sun.source.tree.ParenthesizedTree;
import com.sun.source.tree.PrimitiveTypeTree;
import com.sun.source.tree.StatementTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.math.BigInteger;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import javax.lang.model.element.Modifier;
import javax.tools.Diagnostic;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * Ce que le JDK lit d'un fichier source : son paquet, ses classes, leurs méthodes, et où tout cela commence et finit. Rien n'y est
 * compilé ni exécuté. Les réponses ne sont faites que de listes, de textes et de nombres.
 */
public final class Lecteur {

    /** Nombre de classes, et de noms dans une classe, au-delà duquel on ne les rapporte plus. */
    public static final int CLASSES_MAX = 200;
    private static final int NOMS_MAX = 2000;
    private static final int MEMBRES_MAX = 1000;

    /** Celui du JDK, et non celui d'Eclipse ; {@code null} là où Java n'a pas de compilateur. */
    private static final JavaCompiler JDK = ToolProvider.getSystemJavaCompiler();
    private static final StandardJavaFileManager GESTION = JDK.getStandardFileManager(null, Locale.ROOT, StandardCharsets.UTF_8);

    private Lecteur() {
    }

    /**
     * Lit des fichiers. Pour chacun : paquet, début et fin de ce nom, fin de l'en-tête ; importations (texte, début) ; classes ; lieux
     * des fautes de syntaxe. Pour chaque classe : nom, début, fin, empreinte, noms employés, méthodes. Pour chaque méthode : nom, type rendu
     * (vide d'un constructeur), types des paramètres, modificateurs, début, fin, empreinte, nombre d'instructions.
     *
     * @return une valeur par fichier, {@code null} pour celui qui fait échouer le lecteur
     */
    public static List<List<?>> lire(Collection<String> textes) {
        try {
            return tous(List.copyOf(textes));
        } catch (RuntimeException | Error e) {
            // l'un d'eux est trop emboîté, ou déroute le lecteur : il ne coûte que lui
            List<List<?>> lus = new ArrayList<>();
            for (String texte : textes) {
                try {
                    lus.add(tous(List.of(texte)).get(0));
                } catch (RuntimeException | Error sien) {
                    lus.add(null);
                }
            }
            return lus;
        }
    }

    private static List<List<?>> tous(List<String> textes) {
        List<JavaFileObject> fichiers = new ArrayList<>();
        Map<URI, List<Integer>> fautes = new HashMap<>();
        for (String texte : textes) {
            URI nom = URI.create("memoire:///" + fichiers.size() + ".java");
            fautes.put(nom, new ArrayList<>());
            fichiers.add(new SimpleJavaFileObject(nom, JavaFileObject.Kind.SOURCE) {
                @Override
                public CharSequence getCharContent(boolean tel) {
                    return texte;
                }
            });
        }
        JavacTask tache = (JavacTask) JDK.getTask(new StringWriter(), GESTION, faute -> {
            if (faute.getKind() == Diagnostic.Kind.ERROR && faute.getSource() != null) {
                fautes.get(faute.getSource().toUri()).add((int) faute.getPosition());
            }
        }, List.of("-proc:none"), null, fichiers);
        List<List<?>> lus = new ArrayList<>();
        SourcePositions lieux = Trees.instance(tache).getSourcePositions();
        try {
            for (CompilationUnitTree fichier : tache.parse()) {
                lus.add(fichier(fichier, lieux, fautes.get(fichier.getSourceFile().toUri())));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return lus;
    }

    private static List<?> fichier(CompilationUnitTree fichier, SourcePositions lieux, List<Integer> fautes) {
        Tree paquet = fichier.getPackageName();
        int entete = (int) Math.max(0, fichier.getPackage() == null ? 0 : lieux.getEndPosition(fichier, fichier.getPackage()));
        List<List<?>> importations = new ArrayList<>();
        for (ImportTree importation : fichier.getImports()) {
            Tree nom = importation.getQualifiedIdentifier();
            importations.add(List.of(nom.toString(), (int) lieux.getStartPosition(fichier, nom)));
            entete = (int) Math.max(entete, lieux.getEndPosition(fichier, importation));
        }
        List<List<?>> classes = new ArrayList<>();
        for (Tree classe : fichier.getTypeDecls()) {
            if (classe instanceof ClassTree && classes.size() <= CLASSES_MAX) {
                classes.add(classe(fichier, lieux, (ClassTree) classe));
            }
        }
        return List.of(paquet == null ? "" : paquet.toString(), paquet == null ? 0 : (int) lieux.getStartPosition(fichier, paquet),
                paquet == null ? 0 : (int) lieux.getEndPosition(fichier, paquet), entete, importations, classes,
                fautes.subList(0, Math.min(CLASSES_MAX, fautes.size())));
    }

    private static List<?> classe(CompilationUnitTree fichier, SourcePositions lieux, ClassTree classe) {
        Empreinte tout = new Empreinte();
        tout.scan(classe, null);
        List<List<?>> methodes = new ArrayList<>();
        for (Tree membre : classe.getMembers()) {
            if (membre instanceof MethodTree && methodes.size() < MEMBRES_MAX) {
                MethodTree m = (MethodTree) membre;
                Empreinte sienne = new Empreinte();
                sienne.scan(m.getParameters(), null);
                sienne.scan(m.getBody(), null);
                methodes.add(List.of(m.getReturnType() == null ? classe.getSimpleName().toString() : m.getName().toString(),
                        m.getReturnType() == null ? "" : type(m.getReturnType()),
                        m.getParameters().stream().map(p -> type(p.getType())).collect(Collectors.toList()),
                        m.getModifiers().getFlags().toString(), (int) lieux.getStartPosition(fichier, m),
                        (int) lieux.getEndPosition(fichier, m), sienne.condense(), sienne.instructions));
            }
        }
        return List.of(classe.getSimpleName().toString(), (int) lieux.getStartPosition(fichier, classe), (int) lieux.getEndPosition(fichier, classe), tout.condense(),
                tout.noms.stream().limit(NOMS_MAX).collect(Collectors.toList()), methodes);
    }

    /** Un type par son seul nom : ni paquet, ni paramètres. */
    private static String type(Tree type) {
        return String.valueOf(type).replaceFirst("(?s)<.*", "").replaceFirst(".*\\.(?=\\w)", "");
    }

    /**
     * L'arbre d'une méthode ou d'une classe, en un texte où ne comptent ni les commentaires, ni la présentation, ni les accolades d'une
     * seule instruction, ni les noms des variables locales et des paramètres.
     */
    private static final class Empreinte extends TreeScanner<Void, Void> {

        private final StringBuilder texte = new StringBuilder();
        private final Set<String> noms = new TreeSet<>();
        private Map<String, Integer> locales = new HashMap<>();
        private int declarees;
        private int instructions;
        private Tree mere;
        private Tree courant;

        String condense() {
            try {
                byte[] calcul = MessageDigest.getInstance("SHA-256").digest(texte.toString().getBytes(StandardCharsets.UTF_8));
                return new BigInteger(1, calcul).toString(Character.MAX_RADIX);
            } catch (GeneralSecurityException e) {
                throw new IllegalStateException(e);
            }
        }

        @Override
        public Void scan(Tree arbre, Void rien) {
            if (arbre == null) {
                texte.append('-');
            } else if (arbre instanceof EmptyStatementTree) {
                return null;
            } else if (arbre instanceof ParenthesizedTree) {
                scan(((ParenthesizedTree) arbre).getExpression(), rien);
            } else if (arbre instanceof BlockTree && ((BlockTree) arbre).getStatements().size() == 1) {
                scan(((BlockTree) arbre).getStatements().get(0), rien);
            } else {
                Tree avant = mere;
                mere = courant;
                courant = arbre;
                instructions += arbre instanceof StatementTree && !(arbre instanceof BlockTree)
                        && (!(arbre instanceof VariableTree) || mere instanceof BlockTree) ? 1 : 0;
                texte.append(arbre.getKind()).append('(');
                super.scan(arbre, rien);
                texte.append(')');
                courant = mere;
                mere = avant;
            }
            return null;
        }

        @Override
        public Void scan(Iterable<? extends Tree> arbres, Void rien) {
            texte.append('[');
            super.scan(arbres, rien);
            texte.append(']');
            return null;
        }

        private void nommer(Object nom) {
            noms.add(nom.toString());
            texte.append(nom).append(' ');
        }

        @Override
        public Void visitVariable(VariableTree variable, Void rien) {
            if (mere instanceof ClassTree) {
                nommer(variable.getName());
            } else {
                locales.put(variable.getName().toString(), declarees++);
            }
            return super.visitVariable(variable, rien);
        }

        @Override
        public Void visitIdentifier(IdentifierTree identifiant, Void rien) {
            Integer rang = locales.get(identifiant.getName().toString());
            if (rang == null) {
                nommer(identifiant.getName());
            } else {
                texte.append('#').append(rang);
            }
            return null;
        }

        @Override
        public Void visitMemberSelect(MemberSelectTree choix, Void rien) {
            nommer(choix.getIdentifier());
            if (choix.toString().equals("System.in")) {
                noms.add("System.in");
            }
            return super.visitMemberSelect(choix, rien);
        }

        @Override
        public Void visitMethod(MethodTree methode, Void rien) {
            nommer(methode.getName());
            Map<String, Integer> dehors = locales;
            locales = new HashMap<>(dehors);
            super.visitMethod(methode, rien);
            locales = dehors;
            return null;
        }

        @Override
        public Void visitClass(ClassTree classe, Void rien) {
            nommer(classe.getSimpleName());
            return super.visitClass(classe, rien);
        }

        @Override
        public Void visitMemberReference(MemberReferenceTree reference, Void rien) {
            nommer(reference.getName());
            return super.visitMemberReference(reference, rien);
        }

        @Override
        public Void visitPrimitiveType(PrimitiveTypeTree type, Void rien) {
            nommer(type);
            return null;
        }

        @Override
        public Void visitLiteral(LiteralTree valeur, Void rien) {
            texte.append(valeur.getValue()).append(' ');
            return null;
        }

        /** Ni les annotations, ni « final », ni l'accès ne changent ce que fait le programme. */
        @Override
        public Void visitModifiers(ModifiersTree mots, Void rien) {
            mots.getFlags().stream().filter(mot -> mot != Modifier.FINAL && mot.compareTo(Modifier.PRIVATE) > 0).forEach(texte::append);
            return null;
        }
    }
}
