package lancer.correction;
import java.nio.file.Path;
import java.util.*;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
class EssaiTest {
    @TempDir static Path dossier;
    void voir(String nom, Programme p) {
        long[] g = new long[40]; for (int k = 0; k < 40; k++) g[k] = k + 1;
        Map<String, Integer> n = new TreeMap<>();
        Map<String, String> m = new TreeMap<>();
        p.rates(g).forEach((graine, r) -> r.forEach((k, v) -> { n.merge(k, 1, Integer::sum); m.put(k, v.substring(0, Math.min(200, v.length())) + " g" + graine); }));
        System.err.println("== " + nom); n.forEach((k, v) -> System.err.println(v + "/40 " + k + (v < 40 ? "  " + m.get(k) : "")));
    }
    @Test void essai() {
        String a = "new Rayon(lampe.getPosition(), contact);";
        String b = "scene.getClosestIntersection(rayon, (Sphere) this);\n        return obst";
        Programme f = GrainesTest.enFloatPourEssai(dossier);
        voir("float, du contact, sans exclure", f.changer("Objet3D", a, "new Rayon(contact, lampe.getPosition());").changer("Objet3D", b, b.replace("(Sphere) this", "(Sphere) null")));
        voir("float, de la lampe", GrainesTest.enFloatPourEssai(dossier).changer("Objet3D", b, b.replace("(Sphere) this", "(Sphere) null")));
        voir("eps 1e-14", new Programme(dossier).changer("Objet3D", a, "new Rayon(contact.add(getNormale(contact).mul(1e-14)), lampe.getPosition());").changer("Objet3D", b, b.replace("(Sphere) this", "(Sphere) null")));
        voir("eps sphere 1e-15", new Programme(dossier).changer("Objet3D", a, "new Rayon(contact, lampe.getPosition());").changer("Objet3D", b, b.replace("(Sphere) this", "(Sphere) null")).changer("Sphere", "-b - racine > 0", "-b - racine > 1e-15"));
        voir("ombre sans distance", new Programme(dossier).changer("Objet3D", a, "new Rayon(contact, lampe.getPosition());").changer("Objet3D", b, b.replace("(Sphere) this", "(Sphere) null")).changer("Objet3D", "obstacle != null && obstacle.distance < new Vecteur(lampe.getPosition(), contact).norme()", "obstacle != null"));
        voir("les deux", new Programme(dossier).changer("Objet3D", a, "new Rayon(contact, lampe.getPosition());").changer("Objet3D", b, b.replace("(Sphere) this", "(Sphere) null")).changer("Objet3D", "getClosestIntersection(reflechi, (Sphere) this)", "getClosestIntersection(reflechi, (Sphere) null)"));
    }
}
