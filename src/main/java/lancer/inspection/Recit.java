package lancer.inspection;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Sphere;
import lancer.Tuple;
import lancer.Vecteur;
import lancer.contrat.Ecoute.Eclairage;
import lancer.contrat.Ecoute.Etape;
import lancer.contrat.Specularite;
import lancer.texte.Texte;

/** La chaîne d'un pixel en lignes de texte, chaque terme dans l'ordre où il s'ajoute, avec ses facteurs. */
public final class Recit {

    /** Nombre de lampes de même sort au-delà duquel elles ne se montrent qu'à la demande. */
    private static final int LAMPES = 3;

    private final Inspection pixel;
    private final DoubleFunction<String> nombre;
    private final List<Ligne> lignes = new ArrayList<>();
    private int etape;
    /** Lampe, rival ou échantillon dont il est question, et celui dont c'est la chaîne ; vide : aucun. */
    private String quoi = "";
    private String chaine = "";

    /** Une ligne, et où elle est. Immuable. */
    public static final class Ligne {

        public final String texte;

        /** Le numéro du rayon dont elle parle, 0 si c'est du pixel, et son sujet, le même d'un dessin à l'autre. */
        final int etape;
        final String sujet;

        /** Titre qui la remplace, avec ses pareilles, tant qu'on ne les demande pas, ou null ; et si elle a changé. */
        public final String repli;
        public final boolean changee;

        public Ligne(String texte, int etape, String sujet, String repli, boolean changee) {
            this.texte = texte;
            this.etape = etape;
            this.sujet = sujet;
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

    /** Lignes de la chaîne, en texte ; la dernière est {@code somme R V B = #RRGGBB}. */
    public List<String> lignes() {
        return raconter().stream().map(ligne -> ligne.texte).collect(Collectors.toList());
    }

    /** Les lignes de la chaîne, jusqu'à la faute s'il y en a une. */
    public List<Ligne> raconter() {
        dire("pixel %d, %d", pixel.x, pixel.y);
        if (pixel.getEchantillons().size() > 1) {
            dire(pixel.getEchantillons());
        }
        Rayon rayon = pixel.getDepart();
        Objet3D depart = null;
        for (Etape suivante : pixel.getEtapes()) {
            etape = suivante.numero;
            dire(suivante, rayon, depart);
            rayon = rayon == null || suivante.R == null ? null : new Rayon(suivante.contact, suivante.R);
            depart = rayon == null ? null : suivante.contact.objet;
        }
        etape = 0;
        chaine = "";
        if (pixel.getFaute() != null) {
            dire("échec : %s", Texte.cause(pixel.getFaute(), Texte.HORS_DE_JAVA));
        } else {
            dire("somme %s = #%06X", pixel.getCouleur(), pixel.getCouleur().getCode() & 0xFFFFFF);
        }
        return lignes;
    }

    /** Ce texte sans les numéros de ligne du fichier, que change tout ce qui s'écrit plus haut. */
    static String sansNumero(String texte) {
        return texte.replaceAll(" ligne \\d+", "");
    }

    private void dire(String format, Object... valeurs) {
        replier(null, format, valeurs);
    }

    private void replier(String repli, String format, Object... valeurs) {
        Object[] textes = Arrays.stream(valeurs).map(this::ecrire).toArray();
        lignes.add(new Ligne(String.format(Locale.ROOT, format, textes), etape,
                etape + chaine + " " + sansNumero(quoi) + format.split(" = | : |%")[0], repli, false));
    }

    /** Les nombres d'une valeur, comme ils s'écrivent ; elle-même, si ce n'en sont pas. */
    private Object ecrire(Object valeur) {
        if (valeur instanceof Couleur) {
            Couleur c = (Couleur) valeur;
            return ecrire(c.r) + " " + ecrire(c.v) + " " + ecrire(c.b);
        }
        if (valeur instanceof Tuple) {
            Tuple t = (Tuple) valeur;
            return ecrire(t.x) + " " + ecrire(t.y) + " " + ecrire(t.z);
        }
        if (valeur instanceof Echantillon) {
            return ecrire(((Echantillon) valeur).xe) + ", " + ecrire(((Echantillon) valeur).ye);
        }
        return valeur instanceof Double ? nombre.apply((Double) valeur) : valeur;
    }

    private void dire(List<Echantillon> echantillons) {
        long siens = echantillons.stream().filter(e -> e.estDans(pixel.x, pixel.y)).count();
        dire("%d échantillon%s%s", siens, siens > 1 ? "s" : "", siens == echantillons.size() ? ""
                : " et " + (echantillons.size() - siens) + " partagés avec les voisins");
        for (Echantillon e : echantillons) {
            quoi = e.xe + " " + e.ye;
            dire("  %s%s : %s", e, e.estDans(pixel.x, pixel.y) ? "" : " (partagé)", e.couleur);
        }
        quoi = "termes";
        if (!pixel.termes.isEmpty()) {
            dire("%d termes", pixel.termes.size());
        }
        for (Echantillon terme : pixel.termes) {
            quoi = "terme " + terme.xe + " " + terme.ye;
            dire("  %s × %s = %s", terme.poids, terme, terme.couleur);
        }
        quoi = "";
        if (pixel.somme != null) {
            dire("leur somme = %s, divisée par %s pour le pixel", pixel.somme, pixel.diviseur);
        }
        chaine = pixel.getChoisi().xe + " " + pixel.getChoisi().ye;
        dire("chaîne de l'échantillon %s", pixel.getChoisi());
    }

    /** @param rayon celui de l'étape, parti de cet objet ; {@code null} si une forme se colore à sa façon */
    private void dire(Etape etape, Rayon rayon, Objet3D depart) {
        if (etape.contact == null) {
            dire("%d  ciel", etape.numero);
        } else {
            dire("%d  %s  d = %s", etape.numero, pixel.nom(etape.contact.objet), etape.contact.distance);
            dire("   contact = %s", etape.contact);
            if (etape.N != null) {
                direLaSurface(etape, rayon, depart);
            }
        }
        if (etape.somme == null) {
            return;
        }
        if (!etape.inconnue().estNoire()) {
            dire("     autre = %s (que le récit ne connaît pas)", etape.inconnue());
        }
        dire("   somme %d = %s", etape.numero, etape.somme);
        if (aTraversLAir(etape)) {
            direLAir(etape);
        }
        if (etape.numero == pixel.getEtapes().size()) {
            direLArret(etape);
        }
    }

    private void direLaSurface(Etape etape, Rayon rayon, Objet3D depart) {
        dire("   N = %s", etape.N);
        int reflet = 1 + etape.lampes.size();
        etape.termes.subList(0, reflet).forEach(terme -> dire(etape, terme));
        quoi = "";
        String details = "   demi-corde, rivaux et directions des lampes";
        if (rayon != null) {
            direLesRivaux(details, etape.contact, rayon, depart);
        }
        for (Eclairage lampe : etape.lampes) {
            if (lampe.L != null) {
                quoi = pixel.nom(lampe.lampe);
                replier(details, "     L = %s  vers %s", lampe.L, quoi);
            }
        }
        quoi = "";
        etape.termes.subList(reflet, etape.termes.size()).forEach(terme -> dire(etape, terme));
        quoi = "";
    }

    /** Dit une lampe ou un reflet, puis ce qui s'ajoute tant qu'il en est question, dans l'ordre. */
    private void dire(Etape etape, Eclairage terme) {
        if (terme.lampe != null) {
            direLaLampe(etape, terme);
        } else if (terme.suite != null) {
            dire("     réfléchi : R = %s, poids %s → %d", etape.R, etape.poids == null ? "inconnu" : etape.poids,
                    terme.suite.numero);
        }
        for (int k = 0; k < terme.ajouts.size(); k++) {
            if (k != terme.apport()) {
                dire("     autre terme = %s", terme.ajouts.get(k));
            } else if (terme.lampe != null) {
                direLApport(etape, terme);
            } else {
                direLeProduit("       Ks (%s) ⊗ %s %d = %s", terme.produit, etape.contact.objet.getKs(),
                        aTraversLAir(terme.suite) ? "vue" : "somme", terme.suite.numero, terme.ajouts.get(k));
            }
        }
    }

    /** Dit que des facteurs donnent la dernière de ces valeurs, ou que non, si leur produit est autre. */
    private void direLeProduit(String format, Couleur produit, Object... valeurs) {
        dire(produit.equals(valeurs[valeurs.length - 1]) ? format
                : format.replaceFirst(" = (?=.* = )", " : ").replace(" = %s", " ne donne pas %s"), valeurs);
    }

    /** Dit la demi-corde d'une sphère, et les deux plus proches des autres objets, trouvés par les boucles du cours. */
    private void direLesRivaux(String details, PointContact contact, Rayon rayon, Objet3D depart) {
        if (contact.objet instanceof Sphere) {
            // cours : d = b ± h, b étant la distance jusqu'au milieu de la corde
            Vecteur f = new Vecteur(rayon.getP(), ((Sphere) contact.objet).getCentre());
            replier(details, "     demi-corde h = %s", Math.abs(contact.distance - f.dot(rayon.getV())));
        }
        pixel.scene.getObjets().stream().filter(objet -> objet != contact.objet && objet != depart
                && objet.getIntersectionDistance(rayon) < Constantes.INFINI).map(objet -> rayon.calcContact())
                .sorted(Comparator.comparingDouble(rival -> rival.distance)).limit(2)
                .forEach(rival -> {
                    quoi = pixel.nom(rival.objet);
                    replier(details, "     rival %s  d = %s", quoi, rival.distance);
                });
    }

    private void direLaLampe(Etape etape, Eclairage e) {
        long pareilles = etape.lampes.stream().filter(autre -> sort(autre).equals(sort(e))).count();
        quoi = pixel.nom(e.lampe);
        String repli = e.eclaire() || pareilles <= LAMPES ? null : "     " + pareilles + " lampes " + sort(e);
        if (e.diffus == null) {
            replier(repli, "     %s  N·(lampe − contact) = %s  dans le dos : pas de rayon d'ombre", quoi, e.devant);
            return;
        }
        replier(repli, "     %s  N·L = %s  %s", quoi, e.cosinus, e.eclaire() ? "éclairée"
                : e.L == null ? "sans effet sur cette matière : pas de rayon d'ombre"
                : e.cache == null ? "pas ajoutée" : "cachée par " + pixel.nom(e.cache.objet));
    }

    private void direLApport(Etape etape, Eclairage e) {
        Couleur KL = e.lampe.getCouleur();
        Objet3D objet = etape.contact.objet;
        Specularite specularite = pixel.scene.getModele().getSpecularite();
        // sans rayon d'ombre, personne n'a dit L
        double base = e.L == null ? Double.NaN : specularite.base(etape.V, etape.N, e.L, etape.R);
        double eclat = e.L == null ? e.eclat : specularite.eclat(etape.V, etape.N, e.L, etape.R, objet.getNs());
        direLeProduit("       diffus = Kd (%s) ⊗ lampe (%s) × N·L %s = %s", objet.getKd().mul(e.cosinus, KL),
                objet.getKd(), KL, e.cosinus, e.diffus);
        String facteur = Double.isNaN(base) ? "éclat " + ecrire(e.eclat) : (base < 0 ? "max(0, " : "(")
                + specularite.nomDeLaBase() + " " + ecrire(base) + ")^" + ecrire(specularite.exposant(objet.getNs()));
        direLeProduit("       + reflet = Ks (%s) ⊗ lampe (%s) × %s = %s", objet.getKs().mul(eclat, KL),
                objet.getKs(), KL, facteur, e.reflet);
        Couleur apport = e.ajouts.get(e.apport());
        dire(apport.equals(e.produit) ? "       = %s" : "       diffus + reflet ne donne pas %s", apport);
    }

    private static String sort(Eclairage e) {
        return e.eclaire() ? "éclairées" : e.diffus == null ? "dans le dos"
                : e.L == null ? "sans effet sur cette matière" : e.cache == null ? "pas ajoutées" : "cachées";
    }

    /** Part de l'air dans cette vue, NaN s'il n'en dit rien. */
    private double k(Etape etape) {
        return pixel.scene.getModele().getAtmosphere().k(etape.distance);
    }

    /** Dit si ce que voit le rayon n'est pas la somme telle quelle. */
    private boolean aTraversLAir(Etape etape) {
        return !Double.isNaN(k(etape)) || !etape.vue.equals(etape.somme);
    }

    private void direLAir(Etape etape) {
        double k = k(etape);
        if (!Double.isNaN(k)) {
            dire("     air : k = %s", k);
            dire("       k · air = %s",
                    pixel.scene.getModele().getAtmosphere().traverser(new Couleur(), etape.distance));
            dire("       + (1 − k) · somme %d = %s", etape.numero, etape.somme.mul(1 - k));
        }
        dire("   vue %d = %s", etape.numero, etape.vue);
    }

    private void direLArret(Etape etape) {
        if (etape.contact == null) {
            dire("   arrêt : ciel");
        } else if (etape.poids != null) {
            dire("   arrêt : poids %s < seuil %s", etape.poids.max(), pixel.scene.getModele().getSeuil());
        } else {
            dire("   arrêt : %s", etape.contact.objet.getKs().estNoire() ? "Ks nul"
                    : pixel.profondeur + (pixel.profondeur > 1 ? " réflexions" : " réflexion"));
        }
    }
}
