package lancer.contrat;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;

/**
 * Un pixel qui a échoué, redessiné en vérifiant chaque réponse des classes de la scène : de quoi nommer celle qui ne
 * tient pas ce qu'elle promet. Lente, et appelée une seule fois.
 */
public final class Diagnostic extends RechercheSimple {

    private final List<Objet3D> objets;
    private Objet3D touche;

    private Diagnostic(List<Objet3D> objets) {
        super(objets, new Compteurs());
        this.objets = objets;
    }

    /** Le même échec, avec pour cause la réponse fautive s'il y en a une, ou la ligne d'une classe de la scène. */
    public static PixelFautif preciser(PixelFautif panne, Scene scene, Camera camera, int profondeur) {
        Diagnostic diagnostic = new Diagnostic(scene.getObjets());
        Atmosphere air = scene.getAtmosphere();
        Specularite reflet = scene.getSpecularite();
        Modele modele = new Modele();
        modele.setAtmosphere((vue, distance) -> {
            verifier(vue != null && vue.estFinie(), diagnostic.touche, "getColor", vue);
            Couleur couleur = air.traverser(vue, distance);
            verifier(couleur != null && couleur.estFinie(), air, "traverser", couleur);
            return couleur;
        });
        modele.setSpecularite((V, N, L, R, ns) -> {
            double eclat = reflet.eclat(V, N, L, R, ns);
            verifier(eclat >= 0 && eclat <= 1, reflet, "eclat", eclat);
            return eclat;
        });
        Scene verifiee = scene.avec(modele, scene.getSeuil());
        verifiee.setRecherche(diagnostic);
        Set<String> classes = Stream.concat(Stream.of(air, reflet, scene.getEchantillonnage()),
                scene.getObjets().stream()).map(Modele::nom).collect(Collectors.toSet());
        try {
            for (Lampe lampe : scene.getLampes()) {
                verifier(lampe.getPosition() != null, lampe, "getPosition", null);
                verifier(lampe.getCouleur() != null, lampe, "getCouleur", null);
            }
            new Lancer(verifiee, camera).getCouleurPixel(panne.xe, panne.ye, profondeur);
            return new PixelFautif(panne.xe, panne.ye, depuis(classes, panne));
        } catch (RuntimeException e) {
            return new PixelFautif(panne.xe, panne.ye, depuis(classes, e));
        } catch (StackOverflowError e) {
            return panne;
        }
    }

    private static void verifier(boolean tenue, Object auteur, String methode, Object reponse) {
        if (!tenue) {
            RuntimeException faute = new IllegalStateException(Modele.nom(auteur) + "." + methode
                    + " a rendu " + reponse);
            // elle n'est pas née ici
            faute.setStackTrace(new StackTraceElement[0]);
            throw faute;
        }
    }

    /** Cet échec, sa pile commençant à la première ligne d'une de ces classes, s'il y en a une. */
    private static Throwable depuis(Set<String> classes, Throwable echec) {
        Throwable cause = echec;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        StackTraceElement[] pile = cause.getStackTrace();
        for (int k = 0; k < pile.length; k++) {
            if (classes.contains(pile[k].getClassName())) {
                cause.setStackTrace(Arrays.copyOfRange(pile, k, pile.length));
                break;
            }
        }
        return cause;
    }

    @Override
    public void plusProche(Rayon incident, Objet3D saufLui) {
        for (Objet3D objet : objets) {
            double d = objet == saufLui ? Constantes.INFINI : objet.getIntersectionDistance(incident);
            verifier(d > 0, objet, "getIntersectionDistance", d);
        }
        super.plusProche(incident, saufLui);
        touche = incident.getObjet();
        if (incident.getDistance() < Constantes.INFINI) {
            Point contact = incident.getP().add(incident.getDistance(), incident.getV());
            Point surface = touche.getPointDeSurface(contact);
            verifier(surface != null, touche, "getPointDeSurface", null);
            Vecteur normale = touche.getNormale(surface);
            verifier(normale != null && Math.abs(normale.norme() - 1) < 1e-6, touche, "getNormale", normale);
            verifier(touche.getKd() != null, touche, "getKd", null);
            verifier(touche.getKs() != null, touche, "getKs", null);
        }
    }
}
