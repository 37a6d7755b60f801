package lancer.correction.jugement;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Les messages ordinaires du compilateur d'Eclipse, en français ; les autres sont cités. */
final class Traduction {

    private static final String[][] MESSAGES = {
        {"(\\S+) cannot be resolved to a type", "le type $1 est inconnu"},
        {"(\\S+) cannot be resolved to a variable", "la variable $1 est inconnue"},
        {"(\\S+) cannot be resolved or is not a field", "$1 n'existe pas, ou n'est pas un champ"},
        {"(\\S+) cannot be resolved", "$1 est inconnu"},
        {"The import (\\S+) cannot be resolved", "import inconnu : $1"},
        {"The method (.+) is undefined for the type (.+)", "la méthode $1 n'existe pas dans $2"},
        {"The method (.+) in the type (.+) is not applicable for the arguments (.+)",
        "la méthode $1 de $2 ne prend pas les arguments $3"},
        {"The method (.+) from the type (.+) refers to the missing type (.+)",
        "la méthode $1 de $2 a besoin du type $3, inconnu"},
        {"The constructor (.+) is undefined", "le constructeur $1 n'existe pas"},
        {"The constructor (.+) refers to the missing type (.+)", "le constructeur $1 a besoin du type $2, inconnu"},
        {"Syntax error on token \"(.+)\", delete this token", "syntaxe : « $1 » est de trop"},
        {"Syntax error on token \"(.+)\", (\\S+) expected( after this token)?",
        "syntaxe : après « $1 », il manque « $2 »"},
        {"Syntax error, insert \"([^\\w\"]+|while|class|catch|finally)\" to complete .+", "syntaxe : il manque « $1 »"},
        {"Syntax error, insert .+", "syntaxe incorrecte ici : une accolade, une parenthèse de trop, ou de moins ?"},
        {"Syntax error on tokens?.*", "syntaxe incorrecte ici"},
        {"Type mismatch: cannot convert from (.+) to (.+)", "un $1 ne peut devenir un $2"},
        {"This method must return a result of type (.+)", "cette méthode doit retourner un $1"},
        {"Void methods cannot return a value", "une méthode void ne retourne rien"},
        {"The type (.+) must implement the inherited abstract method (.+)", "la classe $1 doit définir $2"},
        {"The (?:local variable|blank final field) (.+) may not have been initialized",
        "$1 n'a peut-être pas de valeur"},
        {"Duplicate method (.+) in type (.+)", "la méthode $1 est deux fois dans $2"},
        {"Duplicate local variable (.+)", "la variable $1 est déclarée deux fois"},
        {"The type (.+) is already defined", "la classe $1 est définie deux fois"},
        {"The field (.+) is not visible", "le champ $1 est privé"},
        {"The final field (.+) cannot be assigned", "le champ final $1 ne peut changer"},
        {"Unreachable code", "ce code n'est jamais atteint"},
        {"Unhandled exception type (.+)", "l'exception $1 doit être attrapée ou annoncée"},
        {"The return type is incompatible with (.+)", "ne rend pas le même type que $1"},
        {"Cannot reduce the visibility of the inherited method from (.+)", "doit être public, comme dans $1"},
        {"The method (.+) of type (.+) must override .+", "$1 ne redéfinit rien : ce nom, ou ces types, ne sont pas "
            + "ceux du cours"},
        {"The method (.+) from the type (.+) is not visible", "la méthode $1 de $2 est privée"},
        {"The constructor (.+) is not visible", "le constructeur $1 est privé"},
        {"Cannot make a static reference to the non-static (?:method|field) (.+?)(?: from .+)?",
            "$1 n'est pas static : il faut un objet devant"},
        {"Cannot invoke (.+) on the primitive type (.+)", "un $2 n'a pas de méthode $1"},
        {"The operator (.+) is undefined for the argument type\\(s\\) (.+)", "l'opérateur $1 ne s'applique pas à $2"},
        {"Cannot instantiate the type (.+)", "la classe $1 est abstraite"},
        {"Implicit super constructor (.+) is undefined.*",
            "il manque un appel à un constructeur de la classe mère ($1)"},
        {"Incompatible operand types (.+) and (.+)", "un $1 et un $2 ne se comparent pas"},
        {"Cannot use (this|super) in a static context", "« $1 » n'a pas de sens dans une méthode static"},
        {"This static method cannot hide the instance method from (.+)", "ne doit pas être static, comme dans $1"},
        {"Cannot cast from (.+) to (.+)", "un $1 ne peut être converti en $2"},
        {"Cannot return a void result", "ce qui est appelé là ne rend rien"},
        {"Return type for the method is missing", "il manque ce que rend la méthode"},
        {"String literal is not properly closed by a double-quote", "syntaxe : guillemet fermant absent"},
        {"The left-hand side of an assignment must be a variable", "à gauche de « = », il faut une variable"},
        {"Duplicate field (.+)", "le champ $1 est déclaré deux fois"},
        {"The public type (.+) must be defined in its own file",
        "la classe publique $1 doit être dans le fichier de son nom"},
    };

    private Traduction() {
    }

    static String francais(String message) {
        String court = message.replace("lancer.", "").replace("java.lang.", "");
        for (String[] paire : MESSAGES) {
            Matcher m = Pattern.compile("^(?:" + paire[0] + ")$").matcher(court);
            if (m.matches()) {
                return m.replaceFirst(paire[1]);
            }
        }
        return "le compilateur dit « " + court + " »";
    }
}
