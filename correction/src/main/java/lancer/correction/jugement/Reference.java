package lancer.correction.jugement;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lancer.correction.depot.Projet;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Chantier.Assemblage;
import lancer.correction.jugement.Verdict.Etat;

/**
 * À quoi l'on compare : le corrigé, jugé comme un rendu, et le projet à compléter, qui dit ce que l'on réussit sans rien faire. Une
 * vérification ne compte que si le corrigé la passe et que le projet à compléter ne la passe pas.
 */
public final class Reference implements AutoCloseable {

    private static final Map<String, String> BESOINS = Map.of("phong", "lambert", "ombres", "lambert", "reflets", "lambert");

    private final List<Verification> verifications;
    private final Map<String, Verdict> duSquelette = new HashMap<>();
    private final Map<String, String> titres = new HashMap<>();
    private final Machines.Rendue machine;
    private final Chantier chantier;
    private final Juge corrige;
    private final Assemblage assemblage;
    private final Image coins;
    private final Image centres;

    Reference(Machines machines, Machines.Compilation compilation, Path dossier) throws Arret {
        Path sienne = creer(dossier.resolve("corrige"));
        chantier = new Chantier(sienne, compilation);
        machine = machines.new Rendue(sienne);
        assemblage = chantier.assembler("corrige", Chantier.corrige());
        if (!assemblage.fautes.isEmpty()) {
            throw new IllegalStateException("le corrigé ne se compile pas : " + assemblage.fautes.get(0));
        }
        List<Verification> toutes = Juge.verifications(machine, assemblage);
        verifications = Collections.unmodifiableList(toutes);
        toutes.forEach(v -> titres.put(v.etape, v.titreEtape.replaceFirst("^\\d+\\. ", "")));
        corrige = new Juge(this, chantier, machine, null);
        coins = corrige.image(assemblage, 0);
        centres = corrige.image(assemblage, 0.5);
        Map<String, String> vide = Chantier.squelette();
        Path dossierVide = creer(dossier.resolve("squelette"));
        try (Machines.Rendue autre = machines.new Rendue(dossierVide)) {
            Chantier autreChantier = new Chantier(dossierVide, compilation);
            Assemblage squelette = autreChantier.assembler("ensemble", vide);
            Juge juge = new Juge(this, autreChantier, autre, new Projet(vide, Collections.emptyMap(), new ArrayList<>()));
            duSquelette.putAll(juge.lancer(squelette, toutes));
            for (Verification v : toutes) {
                if (duSquelette.get(v.id()).etat != Etat.REUSSI) {
                    duSquelette.put(v.id(), juge.lancer(juge.seule(v.classe), List.of(v)).get(v.id()));
                }
            }
        }
    }

    private static Path creer(Path dossier) {
        try {
            return Files.createDirectories(dossier);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public List<Verification> getVerifications() {
        return verifications;
    }

    /** Vrai si le projet à compléter ne la passe pas : elle compte. */
    public boolean compte(Verification v) {
        return duSquelette.get(v.id()).etat != Etat.REUSSI;
    }

    String messageDuSquelette(Verification v) {
        return duSquelette.get(v.id()).message;
    }

    /** Le titre de l'étape dont celle-ci dépend, vide si elle ne dépend que des classes des étudiants. */
    String besoin(String etape) {
        return BESOINS.containsKey(etape) ? titres.get(BESOINS.get(etape)) : "";
    }

    /** L'image du corrigé, aux coordonnées entières ou au centre des pixels. */
    public Image getImage(boolean auCentre) {
        return auCentre ? centres : coins;
    }

    /** Ce que répondent, en chemin, les méthodes du corrigé. */
    synchronized String chemin(double x, double y) throws Arret {
        return corrige.sonde(assemblage, "SondeChemin", "decrire", corrige.scene(), "" + Juge.LARGEUR, "" + Juge.HAUTEUR, "" + x, "" + y,
                "" + Juge.PROFONDEUR);
    }

    /** Le reflet de Blinn seul, par les classes du corrigé. */
    synchronized String blinn(String scene, double decalage, int facteur) throws Arret {
        Path copie = chantier.getDossier().resolve("scenes/blinn.ini");
        try {
            Files.copy(Path.of(scene), copie, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return corrige.sonde(assemblage, "SondeVariantes", "blinn", copie.toString(), "" + Juge.LARGEUR, "" + Juge.HAUTEUR, "" + decalage, "" + facteur);
    }

    @Override
    public void close() {
        machine.close();
    }
}
