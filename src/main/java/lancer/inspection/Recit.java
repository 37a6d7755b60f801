package lancer.inspection;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
import lancer.texte.Nombre;
import lancer.texte.Texte;

/** Explication d'un pixel en arbre : les contacts, du dernier au premier, leurs termes, les facteurs des termes. */
public final class Recit {

    /** Nombre de lampes semblables au-delà duquel elles ne sont montrées qu'à la demande. */
    private static final int LAMPES = 3;

    private final Inspection pixel;
    private final DoubleFunction<String> nombre;
    private final DoubleFunction<String> composante;
    private int etape;
    /** Lampe, rival ou échantillon de la ligne en cours. */
    private String quoi = "";

    /** @param nombre écriture d'un nombre calculé ; un nombre du fichier garde l'écriture du fichier */
    public Recit(Inspection pixel, DoubleFunction<String> nombre) {
        this(pixel, nombre, nombre);
    }

    /** @param composante écriture d'une composante de couleur calculée */
    public Recit(Inspection pixel, DoubleFunction<String> nombre, DoubleFunction<String> composante) {
        this.pixel = pixel;
        this.nombre = nombre;
        this.composante = composante;
    }

    /** Lignes de l'explication ; la dernière est {@code somme R V B = #RRGGBB}. */
    public List<String> lignes() {
        return raconter().lignes();
    }

    /** L'explication, jusqu'à la faute s'il y en a une. */
    public Noeud raconter() {
        List<Noeud> lignes = new ArrayList<>();
        if (pixel.getEchantillons().size() > 1) {
            direLesEchantillons(lignes);
        }
        List<Noeud> contacts = new ArrayList<>();
        Rayon rayon = pixel.getDepart();
        Objet3D depart = null;
        for (Etape suivante : pixel.getEtapes()) {
            etape = suivante.numero;
            // la couleur d'un contact vient avant le contact dont le reflet la voit
            contacts.add(0, contact(suivante, rayon, depart));
            rayon = rayon == null || suivante.R == null ? null : new Rayon(suivante.contact, suivante.R);
            depart = rayon == null ? null : suivante.contact.objet;
        }
        lignes.addAll(contacts);
        etape = 0;
        if (pixel.getFaute() != null) {
            lignes.add(dire("échec : %s", Texte.cause(pixel.getFaute(), Texte.HORS_DE_JAVA)));
        } else {
            Couleur somme = pixel.getCouleur();
            lignes.add(new Noeud(dire("somme %s = #%06X", somme, somme.getCode() & 0xFFFFFF).texte, "somme", somme));
        }
        Echantillon choisi = pixel.getChoisi();
        String titre = "pixel " + pixel.x + ", " + pixel.y;
        String sujet = choisi == null ? titre : titre + " " + choisi.xe + " " + choisi.ye;
        return new Noeud(titre, sujet, null).sur(lignes, false);
    }

    private Noeud dire(String format, Object... valeurs) {
        Object[] textes = Arrays.stream(valeurs).map(this::ecrire).toArray();
        Object derniere = valeurs.length == 0 ? null : valeurs[valeurs.length - 1];
        return new Noeud(String.format(Locale.ROOT, format, textes),
                etape + " " + Noeud.sansNumero(quoi) + format.split(" = | : |%")[0],
                derniere instanceof Couleur ? (Couleur) derniere : null);
    }

    /** Les nombres d'une valeur, écrits ; la valeur elle-même si ce ne sont pas des nombres. */
    private Object ecrire(Object valeur) {
        if (valeur instanceof Couleur) {
            Couleur c = (Couleur) valeur;
            return composante.apply(c.r) + " " + composante.apply(c.v) + " " + composante.apply(c.b);
        }
        if (valeur instanceof Tuple) {
            Tuple t = (Tuple) valeur;
            return ecrire(t.x) + " " + ecrire(t.y) + " " + ecrire(t.z);
        }
        if (valeur instanceof Echantillon) {
            return ecrire(((Echantillon) valeur).xe) + " " + ecrire(((Echantillon) valeur).ye);
        }
        return valeur instanceof Double ? nombre.apply((Double) valeur) : valeur;
    }

    /** Une couleur, écrite comme dans un fichier. */
    private static String lue(Couleur c) {
        return Nombre.ecrire(c.r) + " " + Nombre.ecrire(c.v) + " " + Nombre.ecrire(c.b);
    }

    private void direLesEchantillons(List<Noeud> lignes) {
        List<Echantillon> echantillons = pixel.getEchantillons();
        long siens = echantillons.stream().filter(e -> e.estDans(pixel.x, pixel.y)).count();
        List<Noeud> vus = new ArrayList<>();
        for (Echantillon e : echantillons) {
            quoi = e.xe + " " + e.ye;
            String partage = e.estDans(pixel.x, pixel.y) ? "" : " (partagé)";
            vus.add(dire("%s%s : %s", e, partage, e.couleur).choisissant(0, vus.size()));
        }
        quoi = "échantillons";
        lignes.add(dire("%d échantillon%s%s", siens, siens > 1 ? "s" : "", siens == echantillons.size() ? ""
                : " et " + (echantillons.size() - siens) + " partagés avec les voisins").sur(vus, false));
        List<Noeud> termes = new ArrayList<>();
        for (Echantillon terme : pixel.termes) {
            quoi = "terme " + terme.xe + " " + terme.ye;
            termes.add(dire("%s × %s = %s", terme.poids, terme, terme.couleur));
        }
        quoi = "termes";
        if (!termes.isEmpty()) {
            lignes.add(dire("%d termes", termes.size()).sur(termes, true));
        }
        quoi = "";
        if (pixel.somme != null) {
            lignes.add(dire("leur somme = %s, divisée par %s pour le pixel", pixel.somme,
                    Nombre.ecrire(pixel.diviseur)));
        }
        lignes.add(dire("chaîne de l'échantillon %s", pixel.getChoisi()));
    }

    /** @param rayon celui de l'étape, parti de {@code depart} ; {@code null} si une forme n'a pas noté sa direction */
    private Noeud contact(Etape etape, Rayon rayon, Objet3D depart) {
        String nom = etape.contact == null ? "ciel" : pixel.nom(etape.contact.objet);
        quoi = "";
        Noeud titre = etape.somme == null ? dire("%d  %s", etape.numero, nom)
                : new Noeud(dire("%d  %s  %s%s", etape.numero, nom, etape.somme, resume(etape)).texte,
                        etape.numero + " ", etape.somme);
        List<Noeud> lignes = new ArrayList<>();
        if (etape.contact == null) {
            direLeVide(lignes, etape);
        } else {
            if (etape.N != null) {
                direLesTermes(lignes, etape);
            }
            if (!etape.inconnue().estNoire()) {
                lignes.add(dire("autre = %s (que le récit ne connaît pas)", etape.inconnue()));
            }
            lignes.add(dire("contact, normale et rivaux").sur(details(etape, rayon, depart), true));
        }
        if (etape.somme != null && aTraversLAir(etape)) {
            direLAir(lignes, etape);
        }
        if (etape.somme != null && etape.numero == pixel.getEtapes().size()) {
            lignes.add(arret(etape));
        }
        return titre.sur(lignes, false).choisissant(etape.numero, -1);
    }

    /** Les termes d'une somme, en un mot chacun. */
    private String resume(Etape etape) {
        if (etape.N == null) {
            return "";
        }
        List<Eclairage> ajoutees = etape.lampes.stream().filter(Eclairage::eclaire).collect(Collectors.toList());
        boolean exactes = ajoutees.stream().allMatch(e -> e.ajouts.get(e.apport()).equals(e.produit));
        boolean diffus = exactes && ajoutees.stream().anyMatch(e -> !e.diffus.estNoire());
        boolean reflet = exactes && ajoutees.stream().anyMatch(e -> !e.reflet.estNoire());
        String lampes = ajoutees.size() == 1 ? "une lampe" : ajoutees.size() + " lampes";
        String apports = diffus && reflet ? "diffus + reflet" : diffus ? "diffus" : reflet ? "reflet" : lampes;
        List<String> termes = new ArrayList<>();
        if (!ajoutees.isEmpty()) {
            termes.add(ajoutees.size() > 1 && (diffus || reflet) ? apports + " de " + lampes : apports);
        }
        Couleur Ks = etape.contact.objet.getKs();
        String facteur = Ks.r == Ks.v && Ks.v == Ks.b ? Nombre.ecrire(Ks.r) : "(" + lue(Ks) + ")";
        etape.termes.stream().filter(terme -> terme.suite != null && terme.eclaire())
                .forEach(terme -> termes.add(terme.ajouts.get(terme.apport()).equals(terme.produit)
                        ? facteur + " ⊗ " + nomDeLaVue(terme.suite) : "réfléchi"));
        if (!etape.inconnue().estNoire() || etape.termes.stream()
                .anyMatch(terme -> terme.ajouts.size() > (terme.eclaire() ? 1 : 0))) {
            termes.add("autre");
        }
        return termes.isEmpty() ? " : rien ne l'éclaire" : " = " + String.join(" + ", termes);
    }

    private String nomDeLaVue(Etape etape) {
        return (aTraversLAir(etape) ? "vue " : "somme ") + etape.numero;
    }

    /** Explique le ciel, si aucun rayon de l'écran ne peut rencontrer d'objet. */
    private void direLeVide(List<Noeud> lignes, Etape etape) {
        List<Objet3D> objets = pixel.scene.getObjets();
        if (objets.isEmpty()) {
            lignes.add(dire("aucun objet dans la scène"));
        } else if (etape.numero == 1 && objets.stream().allMatch(objet -> objet instanceof Sphere
                && ((Sphere) objet).getCentre().z + ((Sphere) objet).getRayon() <= 0)) {
            lignes.add(dire("aucun objet devant l'écran : tous sont en z ≤ 0, et les rayons partent de z = 0"));
        }
    }

    private void direLesTermes(List<Noeud> lignes, Etape etape) {
        if (etape.lampes.isEmpty()) {
            lignes.add(dire(pixel.scene.getLampes().isEmpty() ? "aucune lampe dans la scène : rien ne l'éclaire"
                    : "aucune lampe demandée"));
        }
        Map<String, List<Eclairage>> sorts = etape.lampes.stream().filter(lampe -> !lampe.eclaire())
                .collect(Collectors.groupingBy(Recit::sort, LinkedHashMap::new, Collectors.toList()));
        sorts.values().removeIf(lampes -> lampes.size() <= LAMPES);
        for (Eclairage terme : etape.termes) {
            List<Eclairage> pareilles = terme.lampe == null ? null : sorts.get(sort(terme));
            if (pareilles != null && pareilles.get(0) == terme) {
                quoi = sort(terme);
                lignes.add(dire("%d lampes %s", pareilles.size(), quoi).sur(
                        pareilles.stream().map(lampe -> lampe(etape, lampe)).collect(Collectors.toList()), true));
            } else if (!terme.eclaire() && pareilles == null && (terme.lampe != null || terme.suite != null)) {
                lignes.add(terme.lampe != null ? lampe(etape, terme)
                        : dire("%s n'est pas ajoutée", nomDeLaVue(terme.suite)));
            }
            quoi = "";
            for (int k = 0; k < terme.ajouts.size(); k++) {
                lignes.add(k != terme.apport() ? dire("autre terme = %s", terme.ajouts.get(k))
                        : terme.lampe != null ? lampe(etape, terme) : reflet(etape, terme));
                quoi = "";
            }
        }
    }

    private Noeud reflet(Etape etape, Eclairage terme) {
        quoi = "réfléchi";
        return produit("Ks (%s) ⊗ %s = %s", terme.produit, lue(etape.contact.objet.getKs()), nomDeLaVue(terme.suite),
                terme.ajouts.get(terme.apport())).sur(Arrays.asList(dire("R = %s", etape.R), etape.poids == null
                ? dire("poids : inconnu") : dire("poids, produit des Ks = %s", etape.poids)), true);
    }

    /** Écrit que des facteurs donnent la dernière valeur ou, si leur produit est autre, qu'ils ne la donnent pas. */
    private Noeud produit(String format, Couleur produit, Object... valeurs) {
        return dire(produit.equals(valeurs[valeurs.length - 1]) ? format
                : format.replaceFirst(" = (?=.* = )", " : ").replace(" = %s", " ne donne pas %s"), valeurs);
    }

    private Noeud lampe(Etape etape, Eclairage e) {
        quoi = pixel.nom(e.lampe);
        if (e.diffus == null) {
            return dire("%s  N·(lampe − contact) = %s  dans le dos : pas de rayon d'ombre", quoi, e.devant);
        }
        if (!e.eclaire()) {
            Noeud titre = dire("%s  N·L = %s  %s", quoi, e.cosinus, e.L == null
                    ? "sans effet sur cette matière : pas de rayon d'ombre"
                    : e.cache == null ? "pas ajoutée" : "cachée par " + pixel.nom(e.cache.objet));
            return e.L == null ? titre : titre.sur(Arrays.asList(dire("L = %s", e.L)), true);
        }
        Couleur apport = e.ajouts.get(e.apport());
        Noeud titre = dire(apport.equals(e.produit) ? "%s  N·L = %s  éclairée : diffus + reflet = %s"
                : "%s  N·L = %s  éclairée : diffus + reflet ne donne pas %s", quoi, e.cosinus, apport);
        return titre.sur(facteurs(etape, e), true);
    }

    private List<Noeud> facteurs(Etape etape, Eclairage e) {
        Couleur KL = e.lampe.getCouleur();
        Objet3D objet = etape.contact.objet;
        Specularite specularite = pixel.scene.getModele().getSpecularite();
        // sans rayon d'ombre, L n'est pas connu
        double base = e.L == null ? Double.NaN : specularite.base(etape.V, etape.N, e.L, etape.R);
        double eclat = e.L == null ? e.eclat : specularite.eclat(etape.V, etape.N, e.L, etape.R, objet.getNs());
        String facteur = Double.isNaN(base) ? "éclat " + ecrire(e.eclat) : (base < 0 ? "max(0, " : "(")
                + specularite.nomDeLaBase() + " " + ecrire(base) + ")^"
                + Nombre.ecrire(specularite.exposant(objet.getNs()));
        List<Noeud> facteurs = new ArrayList<>();
        if (e.L != null) {
            facteurs.add(dire("L = %s", e.L));
        }
        facteurs.add(produit("diffus = Kd (%s) ⊗ lampe (%s) × N·L %s = %s", objet.getKd().mul(e.cosinus, KL),
                lue(objet.getKd()), lue(KL), e.cosinus, e.diffus));
        facteurs.add(produit("reflet = Ks (%s) ⊗ lampe (%s) × %s = %s", objet.getKs().mul(eclat, KL),
                lue(objet.getKs()), lue(KL), facteur, e.reflet));
        return facteurs;
    }

    /** Le contact, la demi-corde d'une sphère, et les deux autres objets les plus proches, par les boucles du cours. */
    private List<Noeud> details(Etape etape, Rayon rayon, Objet3D depart) {
        PointContact contact = etape.contact;
        List<Noeud> lignes = new ArrayList<>();
        lignes.add(dire("d = %s", contact.distance));
        lignes.add(dire("contact = %s", contact));
        if (etape.N != null) {
            lignes.add(dire("N = %s", etape.N));
        }
        if (etape.N == null || rayon == null) {
            return lignes;
        }
        if (contact.objet instanceof Sphere) {
            // cours : d = b ± h, où b est la distance jusqu'au milieu de la corde
            Vecteur f = new Vecteur(rayon.getP(), ((Sphere) contact.objet).getCentre());
            lignes.add(dire("demi-corde h = %s", Math.abs(contact.distance - f.dot(rayon.getV()))));
        }
        pixel.scene.getObjets().stream().filter(objet -> objet != contact.objet && objet != depart
                && objet.getIntersectionDistance(rayon) < Constantes.INFINI).map(objet -> rayon.calcContact())
                .sorted(Comparator.comparingDouble(rival -> rival.distance)).limit(2)
                .forEach(rival -> {
                    quoi = pixel.nom(rival.objet);
                    lignes.add(dire("rival %s  d = %s", quoi, rival.distance));
                });
        quoi = "";
        return lignes;
    }

    private static String sort(Eclairage e) {
        return e.eclaire() ? "éclairées" : e.diffus == null ? "dans le dos"
                : e.L == null ? "sans effet sur cette matière" : e.cache == null ? "pas ajoutées" : "cachées";
    }

    /** Part k de l'air dans la couleur, NaN si l'air n'en a pas. */
    private double k(Etape etape) {
        return pixel.scene.getModele().getAtmosphere().k(etape.distance);
    }

    /** Dit si l'air change la couleur. */
    private boolean aTraversLAir(Etape etape) {
        return !Double.isNaN(k(etape)) || !etape.vue.equals(etape.somme);
    }

    private void direLAir(List<Noeud> lignes, Etape etape) {
        double k = k(etape);
        List<Noeud> parts = new ArrayList<>();
        if (!Double.isNaN(k)) {
            parts.add(dire("air : k = %s", k));
            parts.add(dire("k · air = %s",
                    pixel.scene.getModele().getAtmosphere().traverser(new Couleur(), etape.distance)));
            parts.add(dire("(1 − k) · somme %d = %s", etape.numero, etape.somme.mul(1 - k)));
        }
        lignes.add(dire("vue %d = %s", etape.numero, etape.vue).sur(parts, false));
    }

    private Noeud arret(Etape etape) {
        if (etape.contact == null) {
            return dire("arrêt : ciel");
        }
        if (etape.poids != null) {
            return dire("arrêt : poids %s < seuil %s", etape.poids.max(),
                    Nombre.ecrire(pixel.scene.getModele().getSeuil()));
        }
        return dire("arrêt : %s", etape.contact.objet.getKs().estNoire() ? "Ks nul"
                : pixel.profondeur + (pixel.profondeur > 1 ? " réflexions" : " réflexion"));
    }
}
