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
import lancer.contrat.Specularite;
import lancer.inspection.Chemin.Segment;
import lancer.inspection.Chemin.Terme;
import lancer.texte.Nombre;
import lancer.texte.Pile;

/** Explication d'un pixel en arbre : les contacts, du dernier au premier, leurs termes, les facteurs des termes. */
public final class Recit {

    private final Inspection pixel;
    private final DoubleFunction<String> nombre;
    private final DoubleFunction<String> composante;

    /** @param nombre écriture d'un nombre calculé ; le fichier garde la sienne @param composante celle d'une couleur */
    public Recit(Inspection pixel, DoubleFunction<String> nombre, DoubleFunction<String> composante) {
        this.pixel = pixel;
        this.nombre = nombre;
        this.composante = composante;
    }

    /** L'explication, jusqu'à la faute s'il y en a une ; sa dernière ligne est {@code somme R V B = #RRGGBB}. */
    public Noeud raconter() {
        List<Noeud> lignes = new ArrayList<>();
        if (pixel.getEchantillons().size() > 1) {
            direLesEchantillons(lignes);
        }
        List<Noeud> contacts = new ArrayList<>();
        Rayon rayon = pixel.getDepart();
        Objet3D depart = null;
        for (Segment suivante : pixel.getSegments()) {
            // un contact est écrit avant celui qui le reflète
            contacts.add(0, contact(suivante, rayon, depart));
            rayon = rayon == null || suivante.R == null ? null : new Rayon(suivante.contact, suivante.R);
            depart = rayon == null ? null : suivante.contact.objet;
        }
        lignes.addAll(contacts);
        if (pixel.getFaute() != null) {
            lignes.add(dire("échec : %s", Pile.cause(pixel.getFaute(), Pile.HORS_DE_JAVA)));
        } else {
            Couleur somme = pixel.getCouleur();
            lignes.add(teinter(somme, "somme %s = #%06X", somme, somme.getCode() & 0xFFFFFF));
        }
        return dire("pixel %d, %d", pixel.x, pixel.y).sur(lignes, false);
    }

    /** Une ligne, de la couleur de sa dernière valeur si c'en est une. */
    private Noeud dire(String format, Object... valeurs) {
        Object derniere = valeurs.length == 0 ? null : valeurs[valeurs.length - 1];
        return teinter(derniere instanceof Couleur ? (Couleur) derniere : null, format, valeurs);
    }

    private Noeud teinter(Couleur couleur, String format, Object... valeurs) {
        Object[] textes = Arrays.stream(valeurs).map(this::ecrire).toArray();
        return new Noeud(String.format(Locale.ROOT, format, textes), couleur);
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
            String partage = e.estDans(pixel.x, pixel.y) ? "" : " (partagé)";
            vus.add(dire("%s%s : %s", e, partage, e.couleur).choisissant(vus.size()));
        }
        String autres = siens == echantillons.size() ? ""
                : " et " + (echantillons.size() - siens) + " partagés avec les voisins";
        lignes.add(dire("%d échantillon%s%s", siens, siens > 1 ? "s" : "", autres).sur(vus, false));
        if (!pixel.termes.isEmpty()) {
            lignes.add(dire("%d termes", pixel.termes.size()).sur(pixel.termes.stream().map(terme ->
                    dire("%s × %s = %s", terme.poids, terme, terme.couleur)).collect(Collectors.toList()), true));
        }
        if (pixel.somme != null) {
            lignes.add(dire("leur somme = %s, divisée par %s pour le pixel", pixel.somme,
                    Nombre.ecrire(pixel.diviseur)));
        }
        lignes.add(dire("chaîne de l'échantillon %s", pixel.getChoisi()));
    }

    /** @param rayon celui du segment, parti de {@code depart} ; {@code null} si une forme n'a pas noté sa direction */
    private Noeud contact(Segment segment, Rayon rayon, Objet3D depart) {
        String nom = segment.contact == null ? "ciel" : pixel.nom(segment.contact.objet);
        Noeud titre = segment.somme == null ? dire("%d  %s", segment.numero, nom)
                : teinter(segment.somme, "%d  %s  %s%s", segment.numero, nom, segment.somme, resume(segment));
        List<Noeud> lignes = new ArrayList<>();
        if (segment.contact == null && pixel.scene.getObjets().isEmpty()) {
            lignes.add(dire("aucun objet dans la scène"));
        } else if (segment.contact != null) {
            if (segment.N != null) {
                direLesTermes(lignes, segment);
            }
            if (!Apports.inconnue(segment).estNoire()) {
                lignes.add(dire("autre = %s (que le récit ne connaît pas)", Apports.inconnue(segment)));
            }
            lignes.add(dire("contact, normale et rivaux").sur(details(segment, rayon, depart), true));
        }
        if (segment.somme != null && aTraversLAir(segment)) {
            direLAir(lignes, segment);
        }
        if (segment.somme != null && segment.numero == pixel.getSegments().size()) {
            lignes.add(arret(segment));
        }
        return titre.sur(lignes, false);
    }

    /** Les termes d'une somme, un mot par terme. */
    private String resume(Segment segment) {
        if (segment.N == null) {
            return "";
        }
        List<Terme> ajoutees = segment.lampes.stream().filter(Apports::eclaire).collect(Collectors.toList());
        boolean exactes = ajoutees.stream().allMatch(e -> Apports.apport(e).equals(e.produit));
        boolean diffus = exactes && ajoutees.stream().anyMatch(e -> !e.diffus.estNoire());
        boolean reflet = exactes && ajoutees.stream().anyMatch(e -> !e.reflet.estNoire());
        String lampes = ajoutees.size() == 1 ? "une lampe" : ajoutees.size() + " lampes";
        String apports = diffus ? "diffus" : "reflet";
        if (diffus == reflet) {
            apports = diffus ? "diffus + reflet" : lampes;
        }
        List<String> termes = new ArrayList<>();
        if (!ajoutees.isEmpty()) {
            termes.add(ajoutees.size() > 1 && (diffus || reflet) ? apports + " de " + lampes : apports);
        }
        Couleur Ks = segment.contact.objet.getKs();
        String facteur = Ks.r == Ks.v && Ks.v == Ks.b ? Nombre.ecrire(Ks.r) : "(" + lue(Ks) + ")";
        segment.termes.stream().filter(terme -> terme.suite != null && Apports.eclaire(terme))
                .forEach(terme -> termes.add(Apports.apport(terme).equals(terme.produit)
                        ? facteur + " ⊗ " + nomDeLaVue(terme.suite) : "réfléchi"));
        if (!Apports.inconnue(segment).estNoire() || segment.termes.stream()
                .anyMatch(terme -> terme.ajouts.size() > (Apports.eclaire(terme) ? 1 : 0))) {
            termes.add("autre");
        }
        return termes.isEmpty() ? " : rien ne l'éclaire" : " = " + String.join(" + ", termes);
    }

    private String nomDeLaVue(Segment segment) {
        return (aTraversLAir(segment) ? "vue " : "somme ") + segment.numero;
    }

    private void direLesTermes(List<Noeud> lignes, Segment segment) {
        if (segment.lampes.isEmpty()) {
            lignes.add(dire(pixel.scene.getLampes().isEmpty() ? "aucune lampe dans la scène : rien ne l'éclaire"
                    : "aucune lampe demandée"));
        }
        for (Terme terme : segment.termes) {
            if (terme.lampe != null && !Apports.eclaire(terme)) {
                lignes.add(lampe(segment, terme));
            } else if (terme.suite != null && !Apports.eclaire(terme)) {
                lignes.add(dire("%s n'est pas ajoutée", nomDeLaVue(terme.suite)));
            }
            for (Couleur ajout : terme.ajouts) {
                if (ajout != Apports.apport(terme)) {
                    lignes.add(dire("autre terme = %s", ajout));
                } else {
                    lignes.add(terme.lampe != null ? lampe(segment, terme) : reflet(segment, terme));
                }
            }
        }
    }

    private Noeud reflet(Segment segment, Terme terme) {
        return produit("Ks (%s) ⊗ %s = %s", terme.produit, lue(segment.contact.objet.getKs()), nomDeLaVue(terme.suite),
                Apports.apport(terme)).sur(Arrays.asList(dire("R = %s", segment.R), segment.poids == null
                ? dire("poids : inconnu") : dire("poids, produit des Ks = %s", segment.poids)), true);
    }

    /** Écrit si le produit des facteurs donne, ou ne donne pas, la dernière valeur. */
    private Noeud produit(String format, Couleur produit, Object... valeurs) {
        return dire(produit.equals(valeurs[valeurs.length - 1]) ? format
                : format.replaceFirst(" = (?=.* = )", " : ").replace(" = %s", " ne donne pas %s"), valeurs);
    }

    private Noeud lampe(Segment segment, Terme e) {
        String nom = pixel.nom(e.lampe);
        if (e.diffus == null) {
            return dire("%s  N·(lampe − contact) = %s  dans le dos : pas de rayon d'ombre", nom, e.devant);
        }
        if (e.L == null && !Apports.eclaire(e)) {
            return dire("%s  N·L = %s  sans effet sur cette matière : pas de rayon d'ombre", nom, e.cosinus);
        }
        if (!Apports.eclaire(e)) {
            return dire("%s  N·L = %s  %s", nom, e.cosinus, e.cache == null ? "pas ajoutée"
                    : "cachée par " + pixel.nom(e.cache.objet)).sur(Arrays.asList(dire("L = %s", e.L)), true);
        }
        Couleur apport = Apports.apport(e);
        Noeud titre = dire(apport.equals(e.produit) ? "%s  N·L = %s  éclairée : diffus + reflet = %s"
                : "%s  N·L = %s  éclairée : diffus + reflet ne donne pas %s", nom, e.cosinus, apport);
        return titre.sur(facteurs(segment, e), true);
    }

    private List<Noeud> facteurs(Segment segment, Terme e) {
        Couleur KL = e.lampe.getCouleur();
        Objet3D objet = segment.contact.objet;
        Couleur Kd = objet.getKd(segment.contact);
        Specularite specularite = pixel.scene.getModele().getSpecularite();
        // sans rayon d'ombre, L n'est pas connu
        double eclat = e.L == null ? e.eclat : specularite.eclat(segment.V, segment.N, e.L, segment.R, objet.getNs());
        String facteur = e.L == null ? "éclat " + ecrire(e.eclat)
                : specularite.dire(segment.V, segment.N, e.L, segment.R, objet.getNs(), nombre);
        List<Noeud> facteurs = new ArrayList<>();
        if (e.L != null) {
            facteurs.add(dire("L = %s", e.L));
        }
        facteurs.add(produit("diffus = Kd (%s) ⊗ lampe (%s) × N·L %s = %s", Kd.mul(KL).mul(e.cosinus),
                lue(Kd), lue(KL), e.cosinus, e.diffus));
        facteurs.add(produit("reflet = Ks (%s) ⊗ lampe (%s) × %s = %s", objet.getKs().mul(KL).mul(eclat),
                lue(objet.getKs()), lue(KL), facteur, e.reflet));
        return facteurs;
    }

    /** Le contact, la demi-corde d'une sphère, et les deux autres objets les plus proches, par les boucles du cours. */
    private List<Noeud> details(Segment segment, Rayon rayon, Objet3D depart) {
        PointContact contact = segment.contact;
        List<Noeud> lignes = new ArrayList<>();
        lignes.add(dire("d = %s", contact.distance));
        lignes.add(dire("contact = %s", contact));
        if (segment.N != null) {
            lignes.add(dire("N = %s", segment.N));
        }
        if (segment.N == null || rayon == null) {
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
                .forEach(rival -> lignes.add(dire("rival %s  d = %s", pixel.nom(rival.objet), rival.distance)));
        return lignes;
    }

    /** Part k de l'air dans la couleur, NaN si l'air n'en a pas. */
    private double k(Segment segment) {
        return pixel.scene.getModele().getAtmosphere().k(segment.distance);
    }

    /** Dit si l'air change la couleur. */
    private boolean aTraversLAir(Segment segment) {
        return !Double.isNaN(k(segment)) || !segment.vue.equals(segment.somme);
    }

    private void direLAir(List<Noeud> lignes, Segment segment) {
        double k = k(segment);
        List<Noeud> parts = new ArrayList<>();
        if (!Double.isNaN(k)) {
            parts.add(dire("air : k = %s", k));
            parts.add(dire("k · air = %s",
                    pixel.scene.getModele().getAtmosphere().traverser(new Couleur(), segment.distance)));
            parts.add(dire("(1 − k) · somme %d = %s", segment.numero, segment.somme.mul(1 - k)));
        }
        lignes.add(dire("vue %d = %s", segment.numero, segment.vue).sur(parts, false));
    }

    private Noeud arret(Segment segment) {
        if (segment.contact == null) {
            return dire("arrêt : ciel");
        }
        if (segment.poids != null) {
            return dire("arrêt : poids %s < seuil %s", segment.poids.max(),
                    Nombre.ecrire(pixel.scene.getModele().getSeuil()));
        }
        String permises = pixel.profondeur + (pixel.profondeur > 1 ? " réflexions" : " réflexion");
        return dire("arrêt : %s", segment.contact.objet.getKs().estNoire() ? "Ks nul" : permises);
    }
}
