package lancer.correction.jugement;

import lancer.correction.modele.Modele;
import org.junit.platform.engine.TestTag;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestIdentifier;

/** Une vérification de {@code lancer.Tests} : de quelle étape elle est, et de quelle classe elle parle. */
public final class Verification {

    final String classeJava;
    final String methode;
    final String titreEtape;
    final String titre;
    final String etape;
    /** La classe du cours qu'elle vérifie. */
    final String classe;

    Verification(MethodSource source, String titreEtape, TestIdentifier test) {
        classeJava = source.getClassName();
        methode = source.getMethodName();
        this.titreEtape = titreEtape;
        titre = test.getDisplayName();
        classe = test.getTags().stream().map(TestTag::getName).filter(Modele.A_COMPLETER::contains).findFirst().orElse("");
        etape = test.getTags().stream().map(TestTag::getName).filter(e -> !Modele.A_COMPLETER.contains(e)).sorted().findFirst()
                .orElse("");
    }

    public String id() {
        return etape + "." + methode;
    }
}
