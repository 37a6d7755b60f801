package lancer.inspection;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.Tuple;
import lancer.contrat.Atmosphere;
import lancer.contrat.Cause;
import lancer.inspection.Segment.Eclairage;
import lancer.texte.Nombre;

/** Explication d'un pixel en arbre : les contacts, du dernier au premier, leurs termes, les facteurs des termes. */
public final class Recit {

    private final Inspection pixel;
    private final Atmosphere air;
    private final DoubleFunction<String> nombre;
    private final DoubleFunction<String> composante;

    /** @param nombre écriture d'un nombre calculé ; le fichier garde la sienne @param composante celle d'une couleur */
    public Recit(Inspection pixel, DoubleFunction<String> nombre, DoubleFunction<String> composante) {
        this.pixel = pixel;
        air = pixel.scene.getModele().getAtmosphere();
        this.nombre = nombre;
        this.composante = composante;
    }

    /** L'explication, jusqu'à l'échec s'il y en a un ; sa dernière ligne est {@code somme R V B = #RRGGBB}. */
    public Noeud raconter() {
        List<Noeud> lignes = new ArrayList<>();
        if (pixel.echantillons.size() > 1) {
            direLesEchantillons(lignes);
        }
        List<Segment> segments = pixel.getSegments();
        // un contact est écrit avant celui qui le reflète
        for (int k = segments.size() - 1; k >= 0; k--) {
            lignes.add(direLeSegment(segments.get(k)));
        }
        if (pixel.echec != null) {
            lignes.add(ligne("échec : %s", Cause.dire(pixel.echec)));
        }
        if (pixel.getFaute() == null) {
            direLAutre(lignes, pixel.autre);
            Couleur somme = pixel.getCouleur();
            lignes.add(ligne("somme %s = #%06X", somme, somme.getCode() & 0xFFFFFF));
        }
        return ligne("pixel %d, %d", pixel.x, pixel.y).avec(lignes, false);
    }

    /** Une ligne, de la dernière couleur qu'elle dit. */
    private Noeud ligne(String format, Object... valeurs) {
        Couleur couleur = null;
        for (Object valeur : valeurs) {
            couleur = valeur instanceof Couleur ? (Couleur) valeur : couleur;
        }
        Object[] textes = Arrays.stream(valeurs).map(this::ecrireLesNombres).toArray();
        return new Noeud(String.format(Locale.ROOT, format, textes), couleur);
    }

    /** Les nombres d'une valeur, écrits ; la valeur elle-même si ce ne sont pas des nombres. */
    private Object ecrireLesNombres(Object valeur) {
        if (valeur instanceof Couleur) {
            Couleur c = (Couleur) valeur;
            return composante.apply(c.r) + " " + composante.apply(c.v) + " " + composante.apply(c.b);
        }
        if (valeur instanceof Tuple) {
            Tuple t = (Tuple) valeur;
            return nombre.apply(t.x) + " " + nombre.apply(t.y) + " " + nombre.apply(t.z);
        }
        return valeur instanceof Double ? nombre.apply((Double) valeur) : valeur;
    }

    /** Une couleur de la scène, écrite comme dans son fichier. */
    private static String ecrireCommeLeFichier(Couleur c) {
        return Nombre.ecrire(c.r) + " " + Nombre.ecrire(c.v) + " " + Nombre.ecrire(c.b);
    }

    private void direLesEchantillons(List<Noeud> lignes) {
        int tous = pixel.echantillons.size();
        long partages = pixel.echantillons.keySet().stream().filter(pixel::estPartage).count();
        String dits = tous - partages + (tous - partages > 1 ? " échantillons" : " échantillon");
        String avec = partages > 0 ? " et " + partages + " partagés avec les voisins" : "";
        List<Noeud> points = new ArrayList<>();
        pixel.echantillons.forEach((point, couleur) -> points.add(
                ligne("%s %s%s : %s", point.x, point.y, pixel.estPartage(point) ? " (partagé)" : "", couleur)));
        Couleur somme = pixel.echantillons.values().stream().reduce(new Couleur(), Segment::ajouter);
        lignes.add(ligne(dits + avec).avec(points, false));
        Couleur moyenne = somme.div(tous);
        lignes.add(moyenne.equals(pixel.getCouleur())
                ? ligne("leur somme = %s, divisée par %d pour le pixel", somme, tous)
                : ligne("leur moyenne = %s ; l'échantillonnage les pèse autrement pour le pixel", moyenne));
        lignes.add(ligne("chaîne de l'échantillon %s %s", pixel.choisi.x, pixel.choisi.y));
    }

    private Noeud direLeSegment(Segment segment) {
        String nom = segment.contact == null ? "ciel" : pixel.nom(segment.contact.objet);
        Noeud titre = segment.somme == null ? ligne("%d  %s", segment.numero, nom)
                : ligne("%d  %s  %s%s", segment.numero, nom, segment.somme, resumer(segment));
        List<Noeud> lignes = new ArrayList<>();
        if (segment.contact != null) {
            segment.eclairages.forEach(eclairage -> lignes.add(direLaLampe(segment, eclairage)));
            if (segment.N != null && segment.eclairages.isEmpty()) {
                lignes.add(ligne("aucune lampe dans la scène : rien ne l'éclaire"));
            }
            if (segment.reflet != null) {
                lignes.add(ligne("Ks (%s) ⊗ %s = %s", ecrireCommeLeFichier(segment.contact.objet.getKs()),
                        nommerLaVue(segment.suite), segment.reflet).avec(Arrays.asList(
                        ligne("R = %s", segment.R), ligne("poids, produit des Ks = %s", segment.poids)), true));
            }
            direLAutre(lignes, segment.autre);
            lignes.add(ligne("contact, normale et rivaux").avec(direLeContact(segment), true));
        } else if (pixel.scene.getObjets().isEmpty()) {
            lignes.add(ligne("aucun objet dans la scène"));
        }
        if (segment.somme != null && estChangeParLAir(segment)) {
            direLAir(lignes, segment);
        }
        if (segment.somme != null && segment.suite == null) {
            direLArret(lignes, segment);
        }
        return titre.avec(lignes, false);
    }

    /** Les termes d'une somme, un mot par terme. */
    private String resumer(Segment segment) {
        if (segment.contact == null) {
            return "";
        }
        List<String> termes = new ArrayList<>();
        List<Eclairage> visibles = segment.eclairages.stream().filter(Eclairage::eclaire)
                .collect(Collectors.toList());
        List<String> parts = new ArrayList<>();
        if (visibles.stream().anyMatch(eclairage -> !eclairage.diffus.estNoire())) {
            parts.add("diffus");
        }
        if (visibles.stream().anyMatch(eclairage -> !eclairage.reflet.estNoire())) {
            parts.add("reflet");
        }
        if (!parts.isEmpty()) {
            termes.add(String.join(" + ", parts) + (visibles.size() > 1 ? " de " + visibles.size() + " lampes" : ""));
        }
        if (segment.reflet != null) {
            Couleur Ks = segment.contact.objet.getKs();
            boolean grise = Ks.r == Ks.v && Ks.v == Ks.b;
            termes.add((grise ? Nombre.ecrire(Ks.r) : "(" + ecrireCommeLeFichier(Ks) + ")") + " ⊗ "
                    + nommerLaVue(segment.suite));
        }
        if (!segment.autre.estNoire()) {
            termes.add("autre");
        }
        return termes.isEmpty() ? " : rien ne l'éclaire" : " = " + String.join(" + ", termes);
    }

    private String nommerLaVue(Segment segment) {
        return (estChangeParLAir(segment) ? "vue " : "somme ") + segment.numero;
    }

    private void direLAutre(List<Noeud> lignes, Couleur autre) {
        if (!autre.estNoire()) {
            lignes.add(ligne("autre = %s (que le récit ne connaît pas)", autre));
        }
    }

    private Noeud direLaLampe(Segment segment, Eclairage eclairage) {
        String nom = pixel.nom(eclairage.lampe);
        if (!(eclairage.devant > 0)) {
            return ligne("%s  N·(lampe − contact) = %s  dans le dos : pas de rayon d'ombre", nom, eclairage.devant);
        }
        if (eclairage.apport.estNoire()) {
            return ligne("%s  N·L = %s  sans effet sur cette matière : pas de rayon d'ombre", nom, eclairage.cosinus);
        }
        List<Noeud> facteurs = new ArrayList<>();
        facteurs.add(ligne("L = %s", eclairage.L));
        if (eclairage.cachee) {
            String obstacle = eclairage.obstacle == null ? "cachée, le récit ne sait par quoi"
                    : "cachée par " + pixel.nom(eclairage.obstacle.objet);
            return ligne("%s  N·L = %s  %s", nom, eclairage.cosinus, obstacle).avec(facteurs, true);
        }
        Objet3D objet = segment.contact.objet;
        String KL = ecrireCommeLeFichier(eclairage.lampe.getCouleur());
        String eclat = pixel.scene.getModele().getSpecularite()
                .dire(segment.rayon.getV(), segment.N, eclairage.L, segment.R, objet.getNs(), nombre);
        facteurs.add(ligne("diffus = Kd (%s) ⊗ lampe (%s) × N·L %s = %s", ecrireCommeLeFichier(segment.Kd), KL,
                eclairage.cosinus, eclairage.diffus));
        facteurs.add(ligne("reflet = Ks (%s) ⊗ lampe (%s) × %s = %s", ecrireCommeLeFichier(objet.getKs()), KL, eclat,
                eclairage.reflet));
        return ligne("%s  N·L = %s  éclairée : diffus + reflet = %s", nom, eclairage.cosinus, eclairage.apport)
                .avec(facteurs, true);
    }

    /** Le contact, et les deux autres objets les plus proches. */
    private List<Noeud> direLeContact(Segment segment) {
        List<Noeud> lignes = new ArrayList<>();
        lignes.add(ligne("d = %s", segment.distance));
        lignes.add(ligne("contact = %s", segment.contact));
        if (segment.N != null) {
            lignes.add(ligne("N = %s", segment.N));
        }
        segment.rivaux.forEach(rival ->
                lignes.add(ligne("rival %s  d = %s", pixel.nom(rival.objet), rival.distance)));
        return lignes;
    }

    private boolean estChangeParLAir(Segment segment) {
        return !Double.isNaN(air.k(segment.distance)) || !segment.vue.equals(segment.somme);
    }

    private void direLAir(List<Noeud> lignes, Segment segment) {
        double k = air.k(segment.distance);
        List<Noeud> parts = new ArrayList<>();
        // NaN si l'air n'a pas de part
        if (!Double.isNaN(k)) {
            parts.add(ligne("air : k = %s", k));
            parts.add(ligne("k · air = %s", air.traverser(new Couleur(), segment.distance)));
            parts.add(ligne("(1 − k) · somme %d = %s", segment.numero, segment.somme.mul(1 - k)));
        }
        lignes.add(ligne("vue %d = %s", segment.numero, segment.vue).avec(parts, false));
    }

    private void direLArret(List<Noeud> lignes, Segment segment) {
        double seuil = pixel.scene.getModele().getSeuil();
        if (segment.contact == null) {
            lignes.add(ligne("arrêt : ciel"));
        } else if (segment.contact.objet.getKs().estNoire()) {
            lignes.add(ligne("arrêt : Ks nul"));
        } else if (segment.profondeur == 0) {
            lignes.add(ligne("arrêt : %d réflexion%s", pixel.profondeur, pixel.profondeur > 1 ? "s" : ""));
        } else if (segment.poids.max() < seuil) {
            lignes.add(ligne("arrêt : poids %s < seuil %s", segment.poids.max(), Nombre.ecrire(seuil)));
        }
    }

    /** Une ligne de l'explication d'un pixel, et les lignes qui l'expliquent à leur tour. Immuable. */
    public static final class Noeud {

        public final String texte;

        /** La couleur qu'elle montre, ou {@code null}. */
        public final Couleur couleur;

        public final List<Noeud> enfants;

        /** Dit si les enfants ne sont montrés qu'à la demande. */
        public final boolean replie;

        private Noeud(String texte, Couleur couleur, List<Noeud> enfants, boolean replie) {
            this.texte = texte;
            this.couleur = couleur;
            this.enfants = Collections.unmodifiableList(enfants);
            this.replie = replie;
        }

        Noeud(String texte, Couleur couleur) {
            this(texte, couleur, Collections.emptyList(), false);
        }

        /** La même ligne, expliquée par celles-ci. */
        Noeud avec(List<Noeud> lignes, boolean replies) {
            return new Noeud(texte, couleur, lignes, replies);
        }

        /** Les lignes, chacune suivie de celles qui l'expliquent, en retrait ; la racine n'ajoute pas de retrait. */
        public List<String> lignes() {
            List<String> lignes = new ArrayList<>();
            lignes.add(texte);
            enfants.forEach(enfant -> enfant.ecrire("", lignes));
            return lignes;
        }

        private void ecrire(String retrait, List<String> lignes) {
            lignes.add(retrait + texte);
            enfants.forEach(enfant -> enfant.ecrire(retrait + "  ", lignes));
        }
    }
}
