package lancer.correction.jugement;

import java.util.Collection;
import lancer.correction.modele.Modele;

/** Une vérification de {@code lancer.Tests} : de quelle étape elle est, et de quelle classe elle parle. */
public final class Verification {

    public final String classeJava;
    public final String methode;
    public final String titreEtape;
    public final String titre;
    public final String etape;
    /** La classe du cours qu'elle vérifie. */
    public final String classe;

    Verification(String classeJava, String methode, String titreEtape, String titre, Collection<String> etiquettes) {
        this.classeJava = classeJava;
        this.methode = methode;
        this.titreEtape = titreEtape;
        this.titre = titre;
        classe = etiquettes.stream().filter(Modele.A_COMPLETER::contains).findFirst().orElse("");
        etape = etiquettes.stream().filter(e -> !Modele.A_COMPLETER.contains(e)).findFirst().orElse("");
    }

    public String id() {
        return etape + "." + methode;
    }
}
