package lancer.correction.jugement;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lancer.correction.isolement.Arret;

/**
 * Ce qu'une vérification, qui tourne ici, dit à la machine où tourne le rendu : chaque appel d'une doublure y appelle la
 * vraie méthode, et rapporte ce qu'elle rend. Public pour les doublures, qui sont d'un autre paquet.
 */
public final class Dialogue {

    private static final ThreadLocal<Dialogue> COURANT = new ThreadLocal<>();

    private final Machines.Rendue machine;
    private final Map<Integer, Doublure> doublures = new HashMap<>();
    /** Pourquoi plus rien n'est demandé à la machine, {@code null} si rien ne l'empêche. */
    private String refus;

    Dialogue(Machines.Rendue machine) {
        this.machine = machine;
    }

    /** Fait quelque chose, dans ce fil, où les doublures parlent à cette machine. */
    void mener(Runnable travail) {
        COURANT.set(this);
        try {
            recommencer();
            travail.run();
        } finally {
            COURANT.remove();
        }
    }

    /** Une autre vérification commence. @return pourquoi la machine s'est arrêtée à la précédente, ou {@code null} */
    String recommencer() {
        String arret = refus;
        refus = null;
        doublures.clear();
        try {
            machine.oublier();
        } catch (Arret e) {
            refus = e.getMessage();
        }
        return arret;
    }

    /** Ne demande plus rien à la machine. */
    void refuser(String pourquoi) {
        refus = pourquoi;
    }

    /** Le rendu n'a pas répondu comme on peut l'attendre : le message dit en quoi. */
    static final class Echec extends RuntimeException {

        private static final long serialVersionUID = 1;

        Echec(String message) {
            super(message);
        }
    }

    /** La même chose pour des appels sans fin, que les vérifications attrapent. */
    private static final class Debordement extends StackOverflowError {

        private static final long serialVersionUID = 1;

        Debordement(String message) {
            super(message);
        }
    }

    /** Un objet du rendu, tel qu'il s'est décrit : son numéro, sa classe, ses champs publics. */
    public static final class Recu {

        private final int numero;
        private final String classe;
        private final String[] champs;

        private Recu(String[] mots) {
            String[] tete = mots[0].substring(1).split(":", 2);
            numero = Integer.parseInt(tete[0]);
            classe = tete[1];
            champs = mots;
        }

        /** Un champ public, par son rang. */
        public <T> T champ(Class<T> type, int rang) {
            return rang + 1 < champs.length ? lire(type, new String[] {champs[rang + 1]}) : null;
        }

        /** Un champ réel. @param attendue la classe, ou la mère, de l'objet */
        public double reel(String attendue, int rang) {
            Double reel = rang + 1 < champs.length ? champ(Double.class, rang) : null;
            if (reel == null) {
                throw new Echec("rend un " + classe + " au lieu d'un " + attendue);
            }
            return reel;
        }
    }

    /** Ce qui tient lieu, ici, d'un objet du rendu. */
    public abstract static class Doublure {

        private final int numero;

        protected Doublure(Recu recu) {
            numero = recu.numero;
            COURANT.get().doublures.put(numero, this);
            relire(recu);
        }

        /** Met à jour les champs publics. */
        protected void relire(Recu recu) {
            // une doublure sans champ n'a rien à relire
        }
    }

    /** Appelle une méthode du rendu. @param rend ce qu'elle doit rendre */
    public static <T> T appeler(Class<T> rend, int methode, Object... arguments) {
        StringBuilder demande = new StringBuilder("A\t").append(methode);
        for (Object argument : arguments) {
            demande.append('\t').append(coder(argument));
        }
        Dialogue ici = COURANT.get();
        if (ici.refus != null) {
            throw new Echec(ici.refus);
        }
        try {
            return lire(rend, reponse(ici.machine.demander(demande.toString())).split("\t"));
        } catch (Arret e) {
            ici.refus = e.getMessage();
            throw new Echec(ici.refus);
        }
    }

    private static String coder(Object valeur) {
        if (valeur instanceof Double) {
            return "d" + valeur;
        } else if (valeur instanceof Integer) {
            return "i" + valeur;
        } else if (valeur instanceof Doublure) {
            return "o" + ((Doublure) valeur).numero;
        } else if (valeur instanceof Recu) {
            return "o" + ((Recu) valeur).numero;
        } else if (valeur instanceof List) {
            List<String> elements = new ArrayList<>();
            ((List<?>) valeur).forEach(e -> elements.add(coder(e)));
            return "l" + String.join(",", elements);
        } else if (valeur == null) {
            return "n";
        }
        throw new IllegalArgumentException("une vérification passe un " + valeur.getClass());
    }

    private static <T> T lire(Class<T> rend, String[] mots) {
        Object valeur;
        try {
            String suite = mots[0].substring(1);
            switch (mots[0].charAt(0)) {
                case 'd':
                    valeur = Double.valueOf(suite);
                    break;
                case 'b':
                    valeur = Boolean.valueOf(suite);
                    break;
                case 's':
                    valeur = suite;
                    break;
                case 'o':
                    valeur = objet(rend, new Recu(mots));
                    break;
                default:
                    valeur = null;
            }
        } catch (NumberFormatException | IndexOutOfBoundsException e) {
            throw new Echec("réponse incompréhensible");
        }
        if (valeur instanceof Double && rend == Integer.class) {
            valeur = ((Double) valeur).intValue();
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
            if (recu.champs.length > 1) {
                connue.relire(recu);
            }
            return connue;
        }
        try {
            Constructor<?> doublure = Class.forName("lancer." + recu.classe, true, rend.getClassLoader())
                    .getConstructor(Recu.class);
            return doublure.newInstance(recu);
        } catch (InvocationTargetException e) {
            throw e.getCause() instanceof Echec ? (Echec) e.getCause() : new IllegalStateException(e);
        } catch (ReflectiveOperationException e) {
            throw new Echec("rend un objet d'une classe inattendue, " + recu.classe);
        }
    }

    /** Ce que dit une réponse de la machine. @throws Echec si le rendu n'a pas su répondre */
    static String reponse(String ligne) {
        String[] mots = ligne.split("\t", 2);
        String suite = mots.length > 1 ? mots[1] : "";
        switch (mots[0]) {
            case "R":
                return suite;
            case "C":
                String[] ou = suite.split("\t", 2);
                throw new Echec(Juge.NE_SE_COMPILE_PAS + ou[0]
                        + (ou.length < 2 || ou[1].isEmpty() ? "" : " : " + Traduction.francais(ou[1])));
            case "D":
                throw new Debordement(suite);
            default:
                throw new Echec(suite);
        }
    }
}
