package lancer.fenetre.moteur;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import lancer.Constantes;
import lancer.Couleur;
import lancer.auto.Echantillon;
import lancer.auto.Mesure;
import lancer.commande.Messages;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.dessin.Dessin;
import lancer.fenetre.etat.Essai;
import lancer.fenetre.etat.Suite.Evenement;

/** Dessine les réglages à tour de rôle, donc dans les mêmes conditions, et dit leurs essais. */
final class Mesureur extends Tache {

    /** Erreur, en niveaux, dont dépend le nombre de rayons d'une référence. */
    private static final double VOULUE = 0.125;

    private final Dessin montre;
    private final Map<Reglages, Essai> essais;

    Mesureur(int numero, Consumer<Evenement> recevoir, Dessin montre, Map<Reglages, Essai> essais) {
        super(numero, recevoir);
        this.montre = montre;
        this.essais = new LinkedHashMap<>(essais);
    }

    @Override
    protected Evenement doInBackground() {
        Dessin prepare = Dessin.preparer(montre.demande.avecVue(null));
        // les bords se cherchent dans l'image, et non dans une vue
        IntFunction<Couleur> dessinee = montre.demande.vue == null ? montre.image::getCouleur : rang -> Constantes.CIEL;
        int fils = montre.demande.reglages.get(Option.FILS);
        Echantillon echantillon = new Echantillon(prepare.lancer, fils, dessinee, VOULUE, Long.MAX_VALUE,
                Integer.MAX_VALUE, new SplittableRandom(1));
        Essai moins = suivant();
        while (!moins.suffit()) {
            long dureeNs = prepare.tracer(moins.reglages, prepare.image);
            Mesure mesure = echantillon.mesurer(prepare.image::getCouleur);
            Essai fait = new Essai(moins.reglages, moins.durees.avec(dureeNs), mesure.erreur, mesure.incertitude);
            essais.put(fait.reglages, fait);
            dire(suite -> suite.compter(fait));
            moins = suivant();
        }
        return suite -> suite.finirLaMesure(null);
    }

    /** Celui qui a été dessiné le moins souvent, de ceux qui ne l'ont pas été assez. */
    private Essai suivant() {
        return essais.values().stream().min(Comparator.comparing(Essai::suffit)
                .thenComparing(essai -> essai.durees.getNombre())).get();
    }

    @Override
    Evenement echouer(Throwable echec) {
        return suite -> suite.finirLaMesure(Messages.message(echec));
    }
}
