package lancer.correction.jugement;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import lancer.correction.modele.Modele;

/** Une vérification de {@code lancer.Tests} : de quelle étape elle est, et de quelle classe elle parle. */
public final class Verification implements Serializable {

    private static final long serialVersionUID = 1;

    public final String classeJava;
    public final String methode;
    public final String titreEtape;
    public final String titre;
    public final String etape;
    /** La classe du cours qu'elle vérifie. */
    public final String classe;

    private Verification(String[] champs) {
        classeJava = champs[0];
        methode = champs[1];
        titreEtape = champs[2];
        titre = champs[3];
        String uneEtape = "";
        String uneClasse = "";
        for (String etiquette : champs[4].split(",")) {
            if (Modele.A_COMPLETER.contains(etiquette)) {
                uneClasse = etiquette;
            } else {
                uneEtape = etiquette;
            }
        }
        etape = uneEtape;
        classe = uneClasse;
    }

    /** @param reponse ce que répond {@code Execution} à la demande L */
    static List<Verification> lire(String reponse) {
        String[] mots = reponse.split("\t");
        if (!mots[0].equals("LISTE")) {
            throw new IllegalStateException("les vérifications n'ont pu être listées : " + reponse);
        }
        List<Verification> liste = new ArrayList<>();
        for (int k = 1; k < mots.length; k++) {
            liste.add(new Verification(mots[k].split("\\|", -1)));
        }
        return liste;
    }

    public String id() {
        return etape + "." + methode;
    }
}
