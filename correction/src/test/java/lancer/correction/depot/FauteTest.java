package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ce qui se dit d'une faute de compilation. */
class FauteTest {

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "The method clamp(double, int, int) is undefined for the type java.lang.Math | clamp n'est pas dans Java ICI, qui juge ici : "
                + "est-elle "
            + "d'une version plus récente ?",
        "The method clamp(double, int, int) is undefined for the type Math | clamp n'est pas dans Java ICI, qui juge ici : est-elle d'une "
            + "version plus récente ?",
        "The method getFirst() is undefined for the type List<Lampe> | getFirst n'est pas dans Java ICI, qui juge ici : est-elle d'une "
                + "version "
            + "plus récente ?",
        "The method norm() is undefined for the type lancer.Vecteur | ''",
        "Syntax error, insert \";\" to complete Statement | il manque « ; »"})
    void ceQuUneFauteDeCompilationVeutDirePrecedeLesMotsDuCompilateur(String message, String remede) {
        String attendu = remede.isEmpty() ? "" : remede.replace("ICI", "" + Runtime.version().feature()) + " ; ";
        assertEquals("Objet3D.java:7 : " + attendu + "le compilateur dit « " + message + " »",
                new Faute("lancer/Objet3D.java", 7, message).toString());
    }
}
