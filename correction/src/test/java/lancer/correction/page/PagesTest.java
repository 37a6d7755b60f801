package lancer.correction.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import lancer.correction.enfant.Texte;
import org.junit.jupiter.api.Test;

/** Ce que devient un texte qui vient d'un étudiant, là où on le montre. */
class PagesTest {

    /** Un terminal, un sens d'écriture, une fin de ligne et une moitié de caractère. */
    private static final String SIGNES = "\u001b\u009b\u200e\u200f\u061c\u202a\u202e\u2066\u2069\u2028\ud83d\u0007";

    @Test
    void unTexteEtrangerNAgitNiSurLeTerminalNiSurLaPage() {
        assertEquals("a b", Texte.protege("a\n" + SIGNES + "\t\r\nb"));
        assertEquals("é à 日本 \uD83D\uDE00", Texte.protege("é à 日本 \uD83D\uDE00"), "ce qui s'écrit reste");
        assertEquals("aaa…", Texte.protege("a".repeat(9), 3));
    }

    @Test
    void aucuneCaseNeDevientUneFormuleQuelQueSoitLeSeparateur() {
        for (char separateur : new char[] {',', ';', '\t', '\n'}) {
            for (String debut : new String[] {"", "a", "\"", " \"\" "}) {
                for (String formule : new String[] {"=1+1", "+1", "-1", "@A1"}) {
                    String texte = Texte.sansFormule(debut + (debut.equals("a") ? separateur : "") + formule);
                    assertFalse(texte.matches("(?s)(.*[;\t\n\r])?[\\s\"]*[=+@-].*"), texte);
                }
            }
        }
        assertEquals("Étudiant 1 ; à regarder", Texte.sansFormule("Étudiant 1 ; à regarder"), "un texte ordinaire reste");
    }
}
