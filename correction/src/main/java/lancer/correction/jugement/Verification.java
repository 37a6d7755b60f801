package lancer.correction.jugement;

import lancer.correction.modele.SourcesDuCours;
import org.junit.platform.engine.TestTag;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestIdentifier;

/** Un critère d'une étape : une vérification de {@code lancer.Tests}, l'image d'une scène, une extension ou une consigne. */
public final class Verification {

    /** L'étape qui ne vaut aucun point : ce qu'une classe garde d'un appel à l'autre est dit, et coûte là où cela rend faux. */
    static final String REPETITION = "repetition";

    final String etape;
    /** Le titre de son étape. */
    final String titreEtape;
    final String methode;
    public final String titre;
    /** La classe du cours visée, vide s'il n'y en a pas. */
    public final String classe;
    /** Faux si le projet à compléter réussit déjà ce critère, qui ne rapporte alors rien. */
    public boolean compte = true;
    /** La classe de {@code lancer.Tests} qui contient la vérification, {@code null} pour un autre critère. */
    transient String classeJava;

    Verification(String etape, String titreEtape, String methode, String classe, String titre) {
        this.etape = etape;
        this.titreEtape = titreEtape;
        this.methode = methode;
        this.classe = classe;
        this.titre = titre;
    }

    Verification(String titreEtape, TestIdentifier test) {
        this(etiquette(test, false), titreEtape.replaceFirst("^\\d+\\. ", ""), source(test).getMethodName(), etiquette(test, true),
                test.getDisplayName());
        classeJava = source(test).getClassName();
    }

    private static MethodSource source(TestIdentifier test) {
        return (MethodSource) test.getSource().get();
    }

    /** La première étiquette qui est le nom d'une classe du cours, ou qui ne l'est pas. */
    private static String etiquette(TestIdentifier test, boolean duCours) {
        return test.getTags().stream().map(TestTag::getName).filter(e -> SourcesDuCours.classes().contains(e) == duCours)
                .sorted().findFirst().orElse("");
    }

    public String id() {
        return etape + "." + methode;
    }
}
