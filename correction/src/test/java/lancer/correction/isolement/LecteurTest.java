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
    void niLesCommentairesNiLaPresentationNiLesNomsDesVariablesLocalesNeComptent() {
        String texte = "int f(int p, Point q) { int a = p; for (int i = 0; i < a; i++) { champ += i; }"
                + " for (int i = 9; i > a; i--) { champ -= i; } return a * q.x; }";
        Object arbre = methode(texte).get(6);
        assertEquals(arbre, methode("int f(final int un, Point deux) {\n// vu\nfinal int b = (un);;\nfor (int i = 0; i < b; i++)\n"
                + "\tchamp += (i);/* { */ for (int j = 9; j > b; j--) champ -= j;\nreturn (b * deux.x);\n}").get(6));
        for (String[] change : new String[][] {{"i < a", "i <= a"}, {"champ -= i", "reste -= i"}, {"q.x", "q.y"}, {"i = 9", "i = 8"},
            {"a = p", "a = champ"}, {"a * q", "a + q"}, {"int p", "double p"}, {"p; for", "p; a++; for"}}) {
            assertNotEquals(arbre, methode(texte.replace(change[0], change[1])).get(6), change[1]);
        }
    }

    @Test
    void lesInstructionsSeComptentEmboiteesOuNonMaisNiLesBlocsNiLesParametres() {
        assertEquals(0, methode("void f() { }").get(7));
        assertEquals(6, methode("void f(int p) { int a = 1; if (a > p) { a++; } else { { a--; } } ; for (int i : t) return; }").get(7));
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
