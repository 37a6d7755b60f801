package lancer.correction.jugement;

import lancer.correction.modele.SourcesDuCours;
import org.junit.platform.engine.TestTag;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestIdentifier;

/** Un critère d'une étape : une vérification de {@code lancer.Tests}, l'image d'une scène, une extension ou une consigne. */
public final class Verification {

    final String etape;
    /** Le titre de son étape. */
    final String titreEtape;
    final String methode;
    public final String titre;
    /** La classe du cours dont elle parle, vide s'il n'en est pas d'une. */
    public final String classe;
    /** Faux si le projet à compléter la réussit déjà : elle ne rapporte rien. */
    public boolean compte = true;
    /** La classe de {@code lancer.Tests} où elle est, {@code null} si elle n'en est pas. */
    String classeJava;

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

    /** La première de ses étiquettes qui soit, ou ne soit pas, une classe du cours. */
    private static String etiquette(TestIdentifier test, boolean duCours) {
        return test.getTags().stream().map(TestTag::getName).filter(e -> SourcesDuCours.A_COMPLETER.contains(e) == duCours)
                .sorted().findFirst().orElse("");
    }

    public String id() {
        return etape + "." + methode;
    }
}
