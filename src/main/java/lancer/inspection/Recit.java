package lancer.inspection;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;
import lancer.Couleur;
import lancer.Tuple;
import lancer.contrat.Specularite;
import lancer.texte.Texte;

/** La chaîne d'un pixel en lignes de texte, chaque terme dans l'ordre où il s'ajoute, avec ses facteurs. */
public final class Recit {

    private static final String HORS_DE_JAVA = "(?!(java|javax|jdk|sun)\\.).*";

    /** Nombre de lampes de même sort au-delà duquel elles ne se montrent qu'à la demande. */
    private static final int LAMPES = 3;

    private final Inspection pixel;
    private final DoubleFunction<String> nombre;
    private final List<Ligne> lignes = new ArrayList<>();
    private int etape;

    /** Une ligne, et où elle est. Immuable. */
    public static final class Ligne {

        public final String texte;

        /** Le numéro du rayon dont elle parle, 0 si c'est du pixel. */
        final int etape;

        /** Ce qui tient lieu de cette ligne et de ses pareilles tant qu'on ne les demande pas ; {@code null} : rien. */
        public final String repli;

        /** Dit si elle n'est pas ce qu'elle était au dessin d'avant. */
        public final boolean changee;

        Ligne(String texte, int etape, String repli, boolean changee) {
            this.texte = texte;
            this.etape = etape;
            this.repli = repli;
            this.changee = changee;
        }

        /** Le numéro du rayon dont elle est le titre ; 0 : aucun. */
        public int rebond() {
            return texte.startsWith(etape + "  ") ? etape : 0;
        }
    }

    /** @param nombre comment s'écrit un nombre */
    public Recit(Inspection pixel, DoubleFunction<String> nombre) {
        this.pixel = pixel;
        this.nombre = nombre;
    }

    /** Toutes, en texte ; la dernière est {@code somme R V B = #RRGGBB}. */
    public List<String> lignes() {
        return raconter().stream().map(ligne -> ligne.texte).collect(Collectors.toList());
    }

    /** Les lignes de la chaîne, jusqu'à la faute s'il y en a une. */
    public List<Ligne> raconter() {
        dire("pixel " + pixel.x + ", " + pixel.y);
        if (pixel.getEchantillons().size() > 1) {
            dire(pixel.getEchantillons());
        }
        for (Etape suivante : pixel.getEtapes()) {
            etape = suivante.numero;
            dire(suivante);
        }
        etape = 0;
        dire(pixel.getFaute() != null ? "échec : " + Texte.cause(pixel.getFaute(), HORS_DE_JAVA)
                : "somme " + ecrire(pixel.getCouleur())
                + String.format(Locale.ROOT, " = #%06X", pixel.getCouleur().getCode() & 0xFFFFFF));
        return lignes;
    }

    private void dire(String ligne) {
        dire(ligne, null);
    }

    private void dire(String ligne, String repli) {
        lignes.add(new Ligne(ligne, etape, repli, false));
    }

    private void dire(List<Echantillon> echantillons) {
        long siens = echantillons.stream().filter(e -> e.estDans(pixel.x, pixel.y)).count();
        dire(siens + (siens > 1 ? " échantillons" : " échantillon") + (siens == echantillons.size() ? ""
                : " et " + (echantillons.size() - siens) + " partagés avec les voisins"));
        for (Echantillon e : echantillons) {
            dire("  " + point(e) + (e.estDans(pixel.x, pixel.y) ? " : " : " (partagé) : ") + ecrire(e.couleur));
        }
        if (!pixel.termes.isEmpty()) {
            dire(pixel.termes.size() + " termes");
        }
        for (Echantillon terme : pixel.termes) {
            dire("  " + nombre.apply(terme.poids) + " × " + point(terme) + " = " + ecrire(terme.couleur));
        }
        if (pixel.somme != null) {
            dire("leur somme = " + ecrire(pixel.somme) + ", divisée par " + nombre.apply(pixel.diviseur)
                    + " pour le pixel");
        }
        dire("chaîne de l'échantillon " + point(pixel.getChoisi()));
    }

    private String point(Echantillon e) {
        return nombre.apply(e.xe) + ", " + nombre.apply(e.ye);
    }

    private void dire(Etape etape) {
        String debut = etape.numero + "  ";
        if (etape.contact == null) {
            dire(debut + "ciel");
        } else {
            dire(debut + pixel.nom(etape.contact.objet) + "  d = " + nombre.apply(etape.contact.distance));
            dire("   contact = " + ecrire(etape.contact));
            if (etape.N != null) {
                direLaSurface(etape);
            }
        }
        if (etape.somme == null) {
            return;
        }
        dire("   somme " + etape.numero + " = " + ecrire(etape.somme));
        if (etape.aTraversLAir()) {
            direLAir(etape);
        }
        if (etape.reflet == null) {
            dire("   arrêt : " + arret(etape));
        }
    }

    private void direLaSurface(Etape etape) {
        dire("   N = " + ecrire(etape.N));
        for (Eclairage lampe : etape.lampes) {
            dire(etape, lampe);
        }
        String details = "   demi-corde, rivaux et directions des lampes";
        if (!Double.isNaN(etape.h)) {
            dire("     demi-corde h = " + nombre.apply(etape.h), details);
        }
        etape.rivaux.forEach(rival -> dire("     rival " + pixel.nom(rival.objet) + "  d = "
                + nombre.apply(rival.distance), details));
        for (Eclairage lampe : etape.lampes) {
            if (lampe.L != null) {
                dire("     L = " + ecrire(lampe.L) + "  vers " + pixel.nom(lampe.lampe), details);
            }
        }
        if (etape.reflet != null) {
            dire("     réfléchi : R = " + ecrire(etape.R) + ", poids " + ecrire(etape.poids) + " → "
                    + (etape.numero + 1));
            dire("       Ks " + facteur(etape.contact.objet.getKs()) + " ⊗ "
                    + pixel.getEtapes().get(etape.numero).nomDeLaVue() + " = " + ecrire(etape.reflet));
        }
    }

    private void dire(Etape etape, Eclairage e) {
        String debut = "     " + pixel.nom(e.lampe);
        long pareilles = etape.lampes.stream().filter(autre -> autre.sort() == e.sort()).count();
        String repli = e.eclaire() || pareilles <= LAMPES ? null : "     " + pareilles + " lampes " + e.sort().nom;
        if (e.diffus == null) {
            dire(debut + "  N·(lampe − contact) = " + nombre.apply(e.devant)
                    + "  dans le dos : pas de rayon d'ombre", repli);
            return;
        }
        dire(debut + "  N·L = " + nombre.apply(e.cosinus) + "  " + (e.eclaire() ? "éclairée"
                : e.L == null ? "sans effet sur cette matière : pas de rayon d'ombre"
                : e.cache == null ? "cachée" : "cachée par " + pixel.nom(e.cache.objet)), repli);
        if (e.eclaire()) {
            String lampe = " ⊗ lampe " + facteur(e.lampe.getCouleur()) + " × ";
            dire("       diffus = Kd " + facteur(etape.contact.objet.getKd()) + lampe + "N·L "
                    + nombre.apply(e.cosinus) + " = " + ecrire(e.diffus));
            dire("       + reflet = Ks " + facteur(etape.contact.objet.getKs()) + lampe + eclat(etape, e) + " = "
                    + ecrire(e.reflet));
            dire("       = " + ecrire(e.apport));
        }
    }

    /** La base et l'exposant de l'éclat d'une lampe, s'il a été calculé et les dit ; sinon l'éclat lui-même. */
    private String eclat(Etape etape, Eclairage e) {
        Specularite specularite = pixel.scene.getModele().getSpecularite();
        double base = specularite.base(etape.V, etape.N, e.L, etape.R);
        return Double.isNaN(base) || etape.contact.objet.getKs().estNoire() ? "éclat " + nombre.apply(e.eclat)
                : "(" + specularite.nomDeLaBase() + " " + nombre.apply(base) + ")^"
                + nombre.apply(specularite.exposant(etape.contact.objet.getNs()));
    }

    private void direLAir(Etape etape) {
        if (!Double.isNaN(etape.k)) {
            Couleur air = pixel.scene.getModele().getAtmosphere().traverser(new Couleur(), etape.distance());
            dire("     air : k = " + nombre.apply(etape.k));
            dire("       k · air = " + ecrire(air));
            dire("       + (1 − k) · somme " + etape.numero + " = " + ecrire(etape.somme.mul(1 - etape.k)));
        }
        if (etape.vue != null) {
            dire("   vue " + etape.numero + " = " + ecrire(etape.vue));
        }
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

    private String facteur(Couleur c) {
        return "(" + ecrire(c) + ")";
    }

    private String ecrire(Couleur c) {
        return nombre.apply(c.r) + " " + nombre.apply(c.v) + " " + nombre.apply(c.b);
    }

    private String ecrire(Tuple t) {
        return nombre.apply(t.x) + " " + nombre.apply(t.y) + " " + nombre.apply(t.z);
    }
}
