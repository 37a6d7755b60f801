package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Ce que le JDK lit d'un texte. */
class LecteurTest {

    private static String arbre(String texte) {
        return Lecteur.lire(List.of("class A { int champ; " + texte + " }"))[0].types.get(0).methodes.get(0).arbre;
    }

    @Test
    void niLesCommentairesNiLaPresentationNeComptent() {
        String texte = "int f(int p, Point q) { int a = p; for (int i = 0; i < a; i++) { champ += i; } return a * q.x; }";
        String arbre = arbre(texte);
        assertEquals(arbre, arbre("int f(int p,\n  Point q) {\n// vu\nint a = p;\nfor (int i = 0; i < a; i++)\n{\tchamp += i;/* { */ }"
                + "\nreturn a * q . x;\n}"));
        for (String[] change : new String[][] {{"i < a", "i <= a"}, {"champ += i", "champ -= i"}, {"q.x", "q.y"}, {"i = 0", "i = 8"},
            {"a * q", "a + q"}, {"int p", "double p"}, {"p; for", "p; a++; for"}}) {
            assertNotEquals(arbre, arbre(texte.replace(change[0], change[1])), change[1]);
        }
    }

    @Test
    void uneFauteDitEnFrancaisCeQuIlFaut() {
        String ici = "Java " + Runtime.version().feature();
        String ailleurs = " n'est pas dans " + ici + ", qui juge ici : est-elle d'une version plus récente ? ; ";
        for (String[] une : new String[][] {{"Syntax error, insert \"}\" to complete ClassBody", "il manque « } » ; "},
            {"Syntax error, insert \";\" to complete Statement", "il manque « ; » ; "},
            {"The Java feature 'Record Pattern' is only available with source level 21 and above", "il faut Java 21, et ici juge "
                    + ici + " ; "},
            {"The method clamp(double, int, int) is undefined for the type java.lang.Math", "clamp" + ailleurs},
            {"The method clamp(double, int, int) is undefined for the type Math", "clamp" + ailleurs},
            {"The method getFirst() is undefined for the type List<Lampe>", "getFirst" + ailleurs},
            {"The method norm() is undefined for the type lancer.Vecteur", ""}}) {
            assertEquals("A.java:3 : " + une[1] + "le compilateur dit « " + une[0] + " »",
                    new Faute("lancer/A.java", 3, une[0]).toString());
        }
    }

    @Test
    void lesNomsDesVariablesNeFontPasUneAutreFormeEtUneMethodeCourteNEnAPas() {
        String suite = "; print(1, 2, 3)".repeat(30) + "; return ";
        String une = forme("int p) { int a = p" + suite + "a * p");
        assertEquals(une, forme("int q) { /* vu */ int b = q" + suite + "b * q"));
        assertNotEquals(une, forme("int q) { int b = q" + suite + "q * b"));
        assertEquals("", forme("int p) { int a = p; return a * p"));
    }

    private static String forme(String methode) {
        return Lecteur.lire(List.of("class A { int f(" + methode + "; } }"))[0].types.get(0).methodes.get(0).forme;
    }

    @Test
    void unTexteTropEmboiteNeCouteQueLui() {
        String emboite = "class B { int b = " + "(".repeat(60_000) + "1" + ")".repeat(60_000) + "; }";
        Lecteur.Fichier[] lus = Lecteur.lire(List.of("class A { }", emboite, "class C {"));
        assertNotNull(lus[0]);
        assertNull(lus[1]);
        assertEquals(List.of(9), lus[2].fautes, "une faute de syntaxe, et où");
    }
}
