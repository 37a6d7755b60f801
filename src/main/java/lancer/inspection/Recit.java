package lancer.inspection;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleFunction;
import lancer.Couleur;
import lancer.Tuple;

/** La chaîne d'un pixel en lignes de texte, chaque terme dans l'ordre où il s'ajoute. */
public final class Recit {

    private final Inspection pixel;
    private final DoubleFunction<String> nombre;
    private final List<String> lignes = new ArrayList<>();

    /** @param nombre comment s'écrit un nombre */
    public Recit(Inspection pixel, DoubleFunction<String> nombre) {
        this.pixel = pixel;
        this.nombre = nombre;
    }

    /** La dernière est {@code somme R V B = #RRGGBB}. */
    public List<String> lignes() {
        lignes.add("pixel " + pixel.x + ", " + pixel.y);
        if (pixel.getEchantillons().size() > 1) {
            dire(pixel.getEchantillons());
        }
        for (Etape etape : pixel.getEtapes()) {
            dire(etape);
        }
        lignes.add("somme " + ecrire(pixel.getCouleur())
                + String.format(Locale.ROOT, " = #%06X", pixel.getCouleur().getCode() & 0xFFFFFF));
        return lignes;
    }

    private void dire(List<Echantillon> echantillons) {
        long siens = echantillons.stream().filter(e -> e.estDans(pixel.x, pixel.y)).count();
        lignes.add(siens + (siens > 1 ? " échantillons" : " échantillon") + (siens == echantillons.size() ? ""
                : " et " + (echantillons.size() - siens) + " partagés avec les voisins"));
        for (Echantillon e : echantillons) {
            lignes.add("  " + point(e) + (e.estDans(pixel.x, pixel.y) ? " : " : " (partagé) : ") + ecrire(e.couleur));
        }
        if (!pixel.termes.isEmpty()) {
            lignes.add(pixel.termes.size() + " termes");
        }
        for (Echantillon terme : pixel.termes) {
            lignes.add("  " + nombre.apply(terme.poids) + " × " + point(terme) + " = " + ecrire(terme.couleur));
        }
        if (pixel.somme != null) {
            lignes.add("leur somme = " + ecrire(pixel.somme) + ", divisée par " + nombre.apply(pixel.diviseur)
                    + " pour le pixel");
        }
        lignes.add("chaîne de l'échantillon " + point(pixel.getChoisi()));
    }

    private String point(Echantillon e) {
        return nombre.apply(e.xe) + ", " + nombre.apply(e.ye);
    }

    private void dire(Etape etape) {
        String debut = etape.numero + "  ";
        if (etape.contact == null) {
            lignes.add(debut + "ciel");
        } else {
            lignes.add(debut + pixel.nom(etape.contact.objet) + "  d = " + nombre.apply(etape.contact.distance));
            lignes.add("   contact = " + ecrire(etape.contact));
            if (etape.N != null) {
                direLaSurface(etape);
            }
        }
        lignes.add("   somme " + etape.numero + " = " + ecrire(etape.somme));
        if (etape.aTraversLAir()) {
            direLAir(etape);
        }
        if (etape.reflet == null) {
            lignes.add("   arrêt : " + arret(etape));
        }
    }

    private void direLaSurface(Etape etape) {
        lignes.add("   N = " + ecrire(etape.N));
        for (Eclairage lampe : etape.lampes) {
            dire(lampe);
        }
        if (etape.reflet != null) {
            lignes.add("     réfléchi : R = " + ecrire(etape.R) + ", poids " + ecrire(etape.poids) + " → "
                    + (etape.numero + 1));
            lignes.add("       Ks ⊗ " + pixel.getEtapes().get(etape.numero).nomDeLaVue() + " = "
                    + ecrire(etape.reflet));
        }
    }

    private void dire(Eclairage e) {
        String debut = "     " + pixel.nom(e.lampe);
        if (e.diffus == null) {
            lignes.add(debut + "  N·(lampe − contact) = " + nombre.apply(e.devant)
                    + "  dans le dos : pas de rayon d'ombre");
            return;
        }
        lignes.add(debut + "  N·L = " + nombre.apply(e.cosinus) + "  " + (e.eclaire() ? "éclairée"
                : e.L == null ? "sans effet sur cette matière : pas de rayon d'ombre"
                : e.cache == null ? "cachée" : "cachée par " + pixel.nom(e.cache.objet)));
        if (e.eclaire()) {
            lignes.add("       diffus = " + ecrire(e.diffus));
            lignes.add("       + reflet = " + ecrire(e.reflet) + "  éclat " + nombre.apply(e.eclat));
            lignes.add("       = " + ecrire(e.apport));
        }
    }

    private void direLAir(Etape etape) {
        if (etape.air != null) {
            lignes.add("     air : k = " + nombre.apply(etape.k));
            lignes.add("       k · air = " + ecrire(etape.air));
            lignes.add("       + (1 − k) · somme " + etape.numero + " = " + ecrire(etape.reste));
        }
        lignes.add("   vue " + etape.numero + " = " + ecrire(etape.vue));
    }

    private String arret(Etape etape) {
        if (etape.contact == null) {
            return "ciel";
        }
        if (etape.poids != null) {
            return "poids " + nombre.apply(etape.poids.max()) + " < seuil "
                    + nombre.apply(pixel.scene.getModele().getSeuil());
        }
        return etape.contact.objet.getKs().estNoire() ? "Ks nul"
                : pixel.profondeur + (pixel.profondeur > 1 ? " réflexions" : " réflexion");
    }

    private String ecrire(Couleur c) {
        return nombre.apply(c.r) + " " + nombre.apply(c.v) + " " + nombre.apply(c.b);
    }

    private String ecrire(Tuple t) {
        return nombre.apply(t.x) + " " + nombre.apply(t.y) + " " + nombre.apply(t.z);
    }
}
