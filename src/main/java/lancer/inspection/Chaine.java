package lancer.inspection;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Ecoute;
import lancer.contrat.Recherche;

/** Ce que les classes du cours disent en calculant : les échantillons pris près d'un pixel, et le dernier en détail. */
final class Chaine implements Ecoute {

    final Map<Couleur, Echantillon> echantillons = new IdentityHashMap<>();
    final List<Compte> comptes = new ArrayList<>();
    final List<Etape> etapes = new ArrayList<>();
    private final Deque<Etape> ouvertes = new ArrayDeque<>();
    private final int x;
    private final int y;
    private boolean finie;
    private double k;
    private Couleur air;
    private Couleur reste;

    Chaine(int x, int y) {
        this.x = x;
        this.y = y;
    }

    @Override
    public void auRegard(double xe, double ye, Couleur couleur) {
        finie = true;
        if (xe >= x && xe < x + 2 && ye >= y && ye < y + 2) {
            echantillons.put(couleur, new Echantillon(xe, ye, couleur));
        }
    }

    @Override
    public void auCompte(Couleur couleur, double poids) {
        comptes.add(new Compte(echantillons.get(couleur), poids));
    }

    @Override
    public void auContact(PointContact contact, Vecteur N, Vecteur R) {
        Etape etape = ajouter(contact);
        etape.N = N;
        etape.R = R;
        ouvertes.push(etape);
    }

    private Etape ajouter(PointContact contact) {
        if (finie) {
            etapes.clear();
            finie = false;
        }
        Etape etape = new Etape(etapes.size() + 1, contact);
        etapes.add(etape);
        return etape;
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
        enCours().L = L;
        enCours().distance = distance;
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
    public void aLAir(double part, Couleur sien, Couleur passe) {
        k = part;
        air = sien;
        reste = passe;
    }

    @Override
    public void aLaVue(PointContact contact, Couleur somme, Couleur vue) {
        boolean ouverte = contact != null && !ouvertes.isEmpty() && ouvertes.peek().contact == contact;
        // sinon c'est le ciel, ou un objet d'une classe à lui, qui se colore sans rien dire
        Etape etape = ouverte ? ouvertes.pop() : ajouter(contact);
        etape.somme = somme;
        etape.vue = vue;
        etape.k = k;
        etape.air = air;
        etape.reste = reste;
        air = null;
    }

    /** Cherche, de chaque lampe cachée, ce qui la cache le plus près d'elle. */
    void nommerCaches(Scene scene) {
        Recherche recherche = scene.getRecherche().pourUnFil(new Compteurs());
        for (Etape etape : etapes) {
            for (Eclairage eclairage : etape.lampes) {
                if (eclairage.L != null && !eclairage.eclaire()) {
                    eclairage.cache = cache(eclairage, etape.contact, scene, recherche);
                }
            }
        }
    }

    private static PointContact cache(Eclairage cachee, PointContact contact, Scene scene, Recherche recherche) {
        boolean lointaine = Scene.estLointaine(cachee.lampe);
        double portee = lointaine ? cachee.distance / 2 : cachee.distance;
        Rayon ombre = Rayon.dOmbre(cachee.lampe.getPosition(), cachee.L.neg());
        recherche.plusProche(ombre, contact.objet);
        if (ombre.getDistance() < portee || !lointaine) {
            return ombre.calcContact();
        }
        PointContact leDernier = null;
        for (Objet3D objet : scene.getObjets()) {
            Rayon versLampe = Rayon.dOmbre(contact, cachee.L);
            double d = objet == contact.objet ? portee : objet.getIntersectionDistance(versLampe);
            if (d < portee && (leDernier == null || d > leDernier.distance)) {
                leDernier = versLampe.calcContact();
            }
        }
        return leDernier;
    }
}
