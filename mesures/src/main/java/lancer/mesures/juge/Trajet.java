package lancer.mesures.juge;

import java.util.ArrayList;
import java.util.List;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;

/**
 * Ce qu'un rayon et ses reflets rencontrent : à chaque contact, l'objet et les lampes qui l'éclairent ; au bout, le ciel ou le sol.
 * Deux rayons de même chemin ont des couleurs qui varient continûment de l'un à l'autre.
 */
final class Trajet {

    private final List<Object> rencontres = new ArrayList<>();
    private final List<List<Lampe>> eclairages = new ArrayList<>();

    /** @param reflets nombre de réflexions permises */
    Trajet(Scene scene, Rayon premier, int reflets) {
        Rayon rayon = premier;
        Objet3D depart = null;
        for (int niveau = 0; niveau <= reflets && rayon != null; niveau++) {
            PointContact contact = scene.getClosestIntersection(rayon, depart);
            if (contact == null) {
                rencontres.add(rayon.getV().y > 0 ? "le ciel" : "sous l'horizon");
                return;
            }
            depart = contact.objet;
            rencontres.add(depart);
            eclairages.add(lampes(scene, contact));
            rayon = reflechi(scene, rayon, contact);
        }
    }

    private static List<Lampe> lampes(Scene scene, PointContact contact) {
        Vecteur N = contact.objet.getNormale(contact);
        List<Lampe> lampes = new ArrayList<>();
        for (Lampe lampe : scene.getLampes()) {
            Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
            if (N.dot(versLampe) > 0
                    && !scene.estCachee(lampe, contact, versLampe.normalized(), versLampe.norme(), contact.objet)) {
                lampes.add(lampe);
            }
        }
        return lampes;
    }

    /** Le rayon réfléchi, {@code null} s'il n'y en a pas. */
    private static Rayon reflechi(Scene scene, Rayon rayon, PointContact contact) {
        Couleur produitKs = rayon.getProduitKs().mul(contact.objet.getKs());
        if (contact.objet.getKs().estNoire() || produitKs.max() < scene.getSeuil()) {
            return null;
        }
        Vecteur V = rayon.getV();
        Vecteur N = contact.objet.getNormale(contact);
        return new Rayon(contact, V.sub(N.mul(2 * V.dot(N))).normalized(), produitKs);
    }

    /** Ce qui sépare ces deux chemins en premier, {@link Cause#PENTE} si rien ne les sépare. */
    Cause separation(Trajet autre) {
        for (int niveau = 0; niveau < Math.min(rencontres.size(), autre.rencontres.size()); niveau++) {
            Object ici = rencontres.get(niveau);
            Object la = autre.rencontres.get(niveau);
            if (ici != la) {
                boolean sansObjet = ici instanceof String && la instanceof String;
                return sansObjet ? Cause.HORIZON : niveau == 0 ? Cause.SILHOUETTE : Cause.SILHOUETTE_REFLETEE;
            }
            if (niveau < eclairages.size() && !eclairages.get(niveau).equals(autre.eclairages.get(niveau))) {
                return niveau == 0 ? Cause.OMBRE : Cause.OMBRE_REFLETEE;
            }
        }
        return Cause.PENTE;
    }
}
