package lancer.fenetre.etat;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import lancer.auto.Echelle;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Durees;

/** Le temps et l'erreur de chaque réglage de l'échelle, et la scène où ils sont mesurés. Immuable. */
public final class Mesures {

    static final Mesures AUCUNES = new Mesures(null, Collections.emptyMap(), 0, null, null, null);

    /** Ce que demande l'échelle mesurée : tout, sauf le réglage ; {@code null} avant la première. */
    final Demande base;
    public final Map<Reglages, Essai> essais;
    /** Le numéro de la mesure en cours, ou 0. */
    final int numero;
    /** Le dessin dont l'échelle se mesure ou, avec une phrase qui dit pourquoi, celui dont elle ne se mesure pas. */
    final Dessin dessin;
    final String arret;
    /** Le réglage que désignent la souris ou les flèches, ou {@code null}. */
    public final Reglages vise;

    private Mesures(Demande base, Map<Reglages, Essai> essais, int numero, Dessin dessin, String arret,
            Reglages vise) {
        this.base = base;
        this.essais = essais;
        this.numero = numero;
        this.dessin = dessin;
        this.arret = arret;
        this.vise = vise;
    }

    /** Celles de ce dessin : l'échelle, et son réglage. Les essais d'une même échelle restent. */
    Mesures de(Dessin celui, int autreNumero) {
        Demande demande = celui.demande.avecVue(null);
        Set<Reglages> echelle = new LinkedHashSet<>(Echelle.de(demande.reglages, false, false));
        Demande celle = demande.avecReglages(echelle.iterator().next());
        Map<Reglages, Essai> connus = celle.equals(base) ? essais : Collections.emptyMap();
        echelle.add(demande.reglages);
        Map<Reglages, Essai> tous = new LinkedHashMap<>();
        echelle.forEach(voulu -> tous.put(voulu,
                connus.getOrDefault(voulu, new Essai(voulu, new Durees(), 0, 0))));
        return new Mesures(celle, tous, autreNumero, celui, null, vise);
    }

    Mesures avec(Essai fait) {
        Map<Reglages, Essai> autres = new LinkedHashMap<>(essais);
        autres.put(fait.reglages, fait);
        return new Mesures(base, autres, numero, dessin, arret, vise);
    }

    Mesures viser(Reglages celui) {
        return new Mesures(base, essais, numero, dessin, arret, celui);
    }

    /** Celles-ci, que rien ne continue. @param pourquoi {@code null} si la mesure reprendra d'elle-même */
    Mesures arretees(String pourquoi) {
        return new Mesures(base, essais, 0, dessin, pourquoi, vise);
    }

    boolean sontFaites() {
        return essais.values().stream().allMatch(Essai::suffit);
    }

    /** Dit si elles se continuent, ou sont à commencer, pour ce dessin. */
    boolean restentAFaire(Dessin celui) {
        return celui != dessin || arret == null && numero == 0 && !sontFaites();
    }

    String direLArret() {
        long vus = essais.values().stream().filter(Essai::estFait).count();
        return "arrêtée : " + vus + (vus > 1 ? " réglages mesurés" : " réglage mesuré") + " ; F3 reprend";
    }

    /** Où elles en sont, en une phrase. */
    String dire() {
        if (!sontFaites()) {
            int faits = essais.values().stream().mapToInt(essai -> essai.durees.getNombre()).sum();
            int voulus = essais.values().stream()
                    .mapToInt(essai -> Math.max(essai.durees.getNombre(), essai.getVoulus())).sum();
            return "mesure en cours : " + faits + (faits > 1 ? " dessins sur " : " dessin sur ") + voulus;
        }
        return essais.values().stream().anyMatch(Essai::varie)
                ? "La machine est occupée : des temps y varient de plus de 30 %."
                : "Les flèches ou la souris désignent un point ; Entrée ou un clic dessine son image.";
    }
}
