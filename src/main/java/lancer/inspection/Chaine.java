package lancer.inspection;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Ecoute;

/** Chaîne des contacts d'un rayon parti de l'écran, telle que la disent les classes du cours en la calculant. */
final class Chaine implements Ecoute {

    final List<Etape> etapes = new ArrayList<>();
    private final Deque<Etape> ouvertes = new ArrayDeque<>();

    @Override
    public void auRayon(Vecteur V, PointContact contact) {
        if (ouvertes.isEmpty()) {
            etapes.clear();
        }
        Etape etape = new Etape(etapes.size() + 1, V, contact);
        etapes.add(etape);
        ouvertes.push(etape);
    }

    @Override
    public void auContact(Vecteur N, Vecteur R) {
        ouvertes.peek().N = N;
        ouvertes.peek().R = R;
    }

    @Override
    public void aLaLampe(Lampe lampe, double devant) {
        ouvertes.peek().lampes.add(new Eclairage(lampe, devant));
    }

    private Eclairage enCours() {
        List<Eclairage> lampes = ouvertes.peek().lampes;
        return lampes.get(lampes.size() - 1);
    }

    @Override
    public void aLEclairement(double cosinus, double eclat, Couleur diffus, Couleur reflet) {
        Eclairage lampe = enCours();
        lampe.cosinus = cosinus;
        lampe.eclat = eclat;
        lampe.diffus = diffus;
        lampe.reflet = reflet;
    }

    @Override
    public void aLOmbre(Vecteur L, double distance) {
        // une forme qui se colore à sa façon demande ses ombres sans nommer la lampe
        if (!ouvertes.peek().lampes.isEmpty()) {
            enCours().L = L;
            enCours().distance = distance;
        }
    }

    @Override
    public void aLaSomme(Couleur terme) {
        if (ouvertes.peek().poids != null) {
            ouvertes.peek().reflet = terme;
        } else {
            enCours().apport = terme;
        }
    }

    @Override
    public void auPoids(Couleur produitKs) {
        ouvertes.peek().poids = produitKs;
    }

    @Override
    public void aLaVue(Couleur somme, Couleur vue) {
        Etape etape = ouvertes.pop();
        etape.somme = somme;
        etape.vue = vue;
    }

    /** Cherche, par les boucles du cours, ce que personne n'a eu à dire : qui cache une lampe, et les rivaux. */
    void chercher(Scene scene, Rayon depart) {
        Rayon rayon = depart;
        PointContact sauf = null;
        for (Etape etape : etapes) {
            etape.k = scene.getModele().getAtmosphere().k(etape.distance());
            for (Eclairage eclairage : etape.lampes) {
                if (eclairage.L != null && !eclairage.eclaire()) {
                    eclairage.cache = cache(eclairage, etape.contact, scene);
                }
            }
            if (etape.contact != null && rayon != null) {
                comparer(etape, rayon, sauf, scene);
                rayon = etape.R == null ? null : new Rayon(etape.contact, etape.R);
                sauf = etape.contact;
            }
        }
    }

    private static void comparer(Etape etape, Rayon rayon, PointContact sauf, Scene scene) {
        if (etape.contact.objet instanceof Sphere) {
            // cours : d = b ± h, b étant la distance jusqu'au milieu de la corde
            Vecteur f = new Vecteur(rayon.getP(), ((Sphere) etape.contact.objet).getCentre());
            etape.h = Math.abs(etape.contact.distance - f.dot(rayon.getV()));
        }
        etape.rivaux = scene.getObjets().stream().filter(objet -> objet != etape.contact.objet
                && (sauf == null || objet != sauf.objet) && objet.getIntersectionDistance(rayon) < Constantes.INFINI)
                .map(objet -> rayon.calcContact()).sorted(Comparator.comparingDouble(rival -> rival.distance)).limit(2)
                .collect(Collectors.toList());
    }

    private static PointContact cache(Eclairage cachee, PointContact contact, Scene scene) {
        boolean lointaine = Scene.estLointaine(cachee.lampe);
        double portee = lointaine ? cachee.distance / 2 : cachee.distance;
        Rayon ombre = Rayon.dOmbre(cachee.lampe.getPosition(), cachee.L.neg());
        PointContact depuisLaLampe = scene.getClosestIntersection(ombre, contact.objet);
        if (ombre.getDistance() < portee || !lointaine) {
            return depuisLaLampe;
        }
        Rayon versLampe = Rayon.dOmbre(contact, cachee.L);
        return scene.getObjets().stream()
                .filter(objet -> objet != contact.objet && objet.getIntersectionDistance(versLampe) < portee)
                .map(objet -> versLampe.calcContact()).max(Comparator.comparingDouble(dernier -> dernier.distance))
                .orElse(null);
    }
}
