package lancer.correction.isolement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import lancer.correction.enfant.Lecteur;
import org.junit.jupiter.api.Test;

/** Ce que le JDK lit d'un texte. */
class LecteurTest {

    private static List<?> methode(String texte) {
        List<?> lu = (List<?>) Lecteur.lire(List.of("class A { int champ; " + texte + " }")).get(0);
        List<?> classe = (List<?>) ((List<?>) lu.get(3)).get(0);
        return (List<?>) ((List<?>) classe.get(5)).get(0);
    }

    @Test
    void niLesCommentairesNiLaPresentationNeComptent() {
        String texte = "int f(int p, Point q) { int a = p; for (int i = 0; i < a; i++) { champ += i; } return a * q.x; }";
        Object arbre = methode(texte).get(6);
        assertEquals(arbre, methode("int f(int p,\n  Point q) {\n// vu\nint a = p;\nfor (int i = 0; i < a; i++)\n{\tchamp += i;/* { */ }"
                + "\nreturn a * q . x;\n}").get(6));
        for (String[] change : new String[][] {{"i < a", "i <= a"}, {"champ += i", "champ -= i"}, {"q.x", "q.y"}, {"i = 0", "i = 8"},
            {"a * q", "a + q"}, {"int p", "double p"}, {"p; for", "p; a++; for"}}) {
            assertNotEquals(arbre, methode(texte.replace(change[0], change[1])).get(6), change[1]);
        }
    }

    @Test
    void unTexteTropEmboiteNeCouteQueLui() {
        String emboite = "class B { int b = " + "(".repeat(60_000) + "1" + ")".repeat(60_000) + "; }";
        List<?> lus = Lecteur.lire(List.of("class A { }", emboite, "class C {"));
        assertNotNull(lus.get(0));
        assertNull(lus.get(1));
        assertEquals(List.of(9), ((List<?>) lus.get(2)).get(4), "une faute de syntaxe, et où");
    }
}
