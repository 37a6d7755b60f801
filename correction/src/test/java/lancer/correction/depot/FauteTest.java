package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ce qui se dit d'une faute de compilation. */
class FauteTest {

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "The method clamp(double, int, int) is undefined for the type java.lang.Math | true",
        "The method clamp(double, int, int) is undefined for the type Math | true",
        "The method getFirst() is undefined for the type List<Lampe> | true",
        "The method norm() is undefined for the type lancer.Vecteur | false",
        "Syntax error, insert \";\" to complete Statement | false"})
    void uneMethodeQueCeJavaNAPasEnDonneLaVersion(String message, boolean deJava) {
        assertEquals("Objet3D.java:7 : le compilateur dit « " + message + " »" + (deJava ? " ; Java " + Runtime.version().feature()
                + ", celui de la correction, n'a pas cette méthode, qu'un Java plus récent a peut-être" : ""),
                new Faute("lancer/Objet3D.java", 7, message).toString());
    }
}
