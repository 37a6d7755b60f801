package lancer.correction.jugement;

import java.lang.reflect.InvocationTargetException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import lancer.correction.Panne;
import lancer.correction.depot.Faute;
import lancer.correction.enfant.Echange;
import lancer.correction.enfant.Execution;
import lancer.correction.isolement.Arret;

/**
 * Messages d'une vérification, exécutée ici, à la machine virtuelle du rendu. Chaque appel d'une doublure y appelle la vraie méthode, et en
 * rapporte le résultat. Cette classe est publique pour les doublures, qui sont dans un autre paquet.
 */
public final class Dialogue {

    private static final ThreadLocal<Dialogue> COURANT = new ThreadLocal<>();

    private final Machines.Rendue machine;
    private final Map<Integer, Doublure> doublures = new HashMap<>();
    /** Raison de ne plus rien demander à la machine virtuelle, ou {@code null}. */
    String refus;
    private Panne panne;

    Dialogue(Machines.Rendue machine) {
        this.machine = machine;
    }

    /** Exécute un travail dans ce fil, où les doublures appellent cette machine virtuelle. */
    void mener(Runnable travail) {
        COURANT.set(this);
        try {
            recommencer();
            travail.run();
        } finally {
            COURANT.remove();
        }
        if (panne != null) {
            throw panne;
        }
    }

    /** Commence une vérification. @return pourquoi la machine virtuelle s'est arrêtée à la précédente, ou {@code null} */
    String recommencer() {
        String arret = refus;
        refus = null;
        doublures.clear();
        try {
            machine.oublier();
        } catch (Arret | Echec | StackOverflowError e) {
            // un rendu peut aussi répondre à ce qui n'appelle aucune de ses méthodes
            refus = e.getMessage();
        } catch (Panne e) {
            // JUnit cacherait cette panne : elle est levée à la fin
            panne = e;
            refus = e.getMessage();
        }
        return arret;
    }

    /** Réponse fautive du rendu, que le message décrit. */
    static final class Echec extends RuntimeException {

        private static final long serialVersionUID = 1;

        /** Ce que dit le compilateur de la méthode appelée, vide s'il ne se sait pas ; {@code null} si elle se compile. */
        final String faute;

        Echec(String message) {
            this(message, null);
        }

        Echec(String message, String faute) {
            super(message);
            this.faute = faute;
        }
    }

    /** Un objet du rendu, avec ses champs publics. */
    public static final class Recu extends Echange.Objet {

        List<?> champs = List.of();

        Recu(Echange.Objet objet) {
            super(objet.numero, objet.classe);
        }

        /** Un champ public, par son rang. */
        public <T> T champ(Class<T> type, int rang) {
            return rang < champs.size() ? rendre(type, champs.get(rang)) : null;
        }

        /** Un champ réel. @param attendue la classe attendue de l'objet, ou sa classe mère */
        public double reel(String attendue, int rang) {
            Double reel = champ(Double.class, rang);
            if (reel == null) {
                throw new Echec("rend un " + classe + " au lieu d'un " + attendue);
            }
            return reel;
        }
    }

    /** Remplaçant, dans la vérification, d'un objet du rendu. */
    public abstract static class Doublure extends Echange.Objet {

        protected Doublure(Recu recu) {
            super(recu.numero, recu.classe);
            COURANT.get().doublures.put(numero, this);
            relire(recu);
        }

        /** Met à jour les champs publics. */
        protected void relire(Recu recu) {
            // une doublure sans champ n'a rien à mettre à jour
        }
    }

    /** Appelle une méthode du rendu. @param rend type attendu du résultat */
    public static <T> T appeler(Class<T> rend, int methode, Object... arguments) {
        Dialogue ici = COURANT.get();
        if (ici.refus != null) {
            throw new Echec(ici.refus);
        }
        try {
            return rendre(rend, ici.machine.appeler(methode, Arrays.asList(arguments)));
        } catch (Arret e) {
            // la doublure qui appelle a le nom de la méthode
            StackWalker.StackFrame appelee = StackWalker.getInstance().walk(pile -> pile.skip(1).findFirst()).get();
            ici.refus = e.getMessage() + " (" + appelee.getClassName().replace("lancer.", "") + "." + appelee.getMethodName()
                    .replace("<init>", "new") + ")";
            throw new Echec(ici.refus);
        }
    }

    private static <T> T rendre(Class<T> rend, Object brut) {
        Object valeur = brut;
        if (brut instanceof Recu) {
            valeur = objet(rend, (Recu) brut);
        } else if (brut instanceof Number && rend == Integer.class) {
            valeur = ((Number) brut).intValue();
        } else if (brut instanceof Number) {
            valeur = ((Number) brut).doubleValue();
        }
        if (valeur == null && (rend == Double.class || rend == Integer.class || rend == Boolean.class)) {
            throw new Echec("rend null au lieu d'un nombre");
        } else if (valeur != null && !rend.isInstance(valeur)) {
            throw new Echec("rend un " + valeur.getClass().getSimpleName() + " au lieu d'un " + rend.getSimpleName());
        }
        return rend.cast(valeur);
    }

    private static Object objet(Class<?> rend, Recu recu) {
        if (rend == Recu.class) {
            return recu;
        }
        Doublure connue = COURANT.get().doublures.get(recu.numero);
        if (connue != null) {
            if (!recu.champs.isEmpty()) {
                connue.relire(recu);
            }
            return connue;
        }
        try {
            if (rend.getSimpleName().equals("Couleur")) {
                return rend.getConstructor(double.class, double.class, double.class)
                        .newInstance(recu.reel("Couleur", 0), recu.reel("Couleur", 1), recu.reel("Couleur", 2));
            }
            Class<?> classe = Class.forName("lancer." + recu.classe, true, rend.getClassLoader());
            return classe.asSubclass(Doublure.class).getConstructor(Recu.class).newInstance(recu);
        } catch (InvocationTargetException e) {
            throw e.getCause() instanceof Echec ? (Echec) e.getCause() : new IllegalStateException(e);
        } catch (ReflectiveOperationException | ClassCastException | LinkageError e) {
            throw new Echec("rend un objet d'une classe inattendue, " + recu.classe);
        }
    }

    /**
     * Ce qui suit la sorte d'une réponse : le résultat.
     *
     * @param fautes les fautes de compilation de ces classes : ce qu'un rendu en dit n'est cru que si le compilateur l'a dit
     * @throws Echec si le rendu n'a pas répondu ; @throws NullPointerException si un des textes n'est pas là
     */
    static List<?> resultat(List<?> reponse, List<Faute> fautes) {
        Object sorte = reponse.get(0);
        if (sorte.equals(Execution.RENDU)) {
            return reponse.subList(1, reponse.size());
        }
        String ou = Objects.requireNonNull((String) reponse.get(1));
        String quoi = Objects.requireNonNull((String) reponse.get(2));
        if (sorte.equals(Execution.SANS_FIN)) {
            // les vérifications des reflets attendent cette exception
            throw new StackOverflowError(ou);
        } else if (!sorte.equals(Execution.FAUTE)) {
            throw new Echec(ou);
        } else if (fautes.isEmpty()) {
            throw new Echec("erreur de Java" + ou);
        } else if (fautes.stream().anyMatch(f -> f.message.equals(quoi))) {
            throw new Echec("ne se compile pas" + ou + " : " + Faute.citer(quoi), quoi);
        }
        throw new Echec("ne se compile pas" + ou, "");
    }
}
