package lancer.correction.jugement;

import java.io.IOException;
import java.io.Serializable;
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
 * À quoi l'on compare : le corrigé, jugé comme un rendu, et le projet à compléter, qui dit ce que l'on réussit sans
 * rien faire. Une vérification ne compte que si le corrigé la passe et que le projet à compléter ne la passe pas.
 */
public final class Reference implements AutoCloseable {

    private static final Map<String, String> BESOINS = Map.of("phong", "lambert", "ombres", "lambert", "reflets",
            "lambert");

    /** Ce qu'on en garde d'une fois à l'autre. */
    private static final class Memoire implements Serializable {

        private static final long serialVersionUID = 1;

        private List<Verification> verifications;
        private final HashMap<String, Verdict> duSquelette = new HashMap<>();
        private Image coins;
        private Image centres;
    }

    private final Machines machines;
    private final Path dossier;
    private final Map<String, String> titres = new HashMap<>();
    private final Memoire memoire;

    /** Le corrigé, compilé, et la machine où il tourne : quand on en a besoin. */
    private Chantier chantier;
    private Machines.Rendue machine;
    private Juge corrige;
    private Assemblage assemblage;

    /** @param souvenir fichier où se trouve, ou sera mis, ce qui n'est pas à refaire */
    Reference(Machines machines, Path dossier, Path souvenir) throws Arret, IOException {
        this.machines = machines;
        this.dossier = dossier;
        Object connue = Souvenirs.relire(souvenir);
        if (connue instanceof Memoire) {
            memoire = (Memoire) connue;
        } else {
            memoire = new Memoire();
            apprendre();
            Souvenirs.ecrire(souvenir, memoire);
        }
        memoire.verifications.forEach(v -> titres.put(v.etape, v.titreEtape.replaceFirst("^\\d+\\. ", "")));
    }

    private void apprendre() throws Arret {
        preparer();
        memoire.verifications = Juge.verifications(machine, assemblage);
        memoire.coins = corrige.image(assemblage, 0);
        memoire.centres = corrige.image(assemblage, 0.5);
        Path vide = creer(dossier.resolve("squelette"));
        try (Machines.Compilation compilation = machines.new Compilation(vide);
                Machines.Rendue autre = machines.new Rendue(vide)) {
            Projet projet = new Projet(Chantier.squelette(), Collections.emptyMap(), new ArrayList<>());
            Chantier autreChantier = new Chantier(vide, compilation);
            Juge juge = new Juge(this, autreChantier, autre, projet);
            memoire.duSquelette.putAll(juge.lancer(autreChantier.assembler("ensemble", projet.getBase()),
                    memoire.verifications));
            for (Verification v : memoire.verifications) {
                if (memoire.duSquelette.get(v.id()).etat != Etat.REUSSI) {
                    memoire.duSquelette.put(v.id(), juge.lancer(juge.seule(v.classe), List.of(v)).get(v.id()));
                }
            }
        }
    }

    private void preparer() throws Arret {
        if (assemblage != null) {
            return;
        }
        Path sien = creer(dossier.resolve("corrige"));
        machine = machines.new Rendue(sien);
        try (Machines.Compilation compilation = machines.new Compilation(sien)) {
            chantier = new Chantier(sien, compilation);
            assemblage = chantier.assembler("corrige", Chantier.corrige());
        }
        if (!assemblage.fautes.isEmpty()) {
            throw new IllegalStateException("le corrigé ne se compile pas : " + assemblage.fautes.get(0));
        }
        corrige = new Juge(this, chantier, machine, null);
    }

    private static Path creer(Path dossier) {
        try {
            return Files.createDirectories(dossier);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public List<Verification> getVerifications() {
        return Collections.unmodifiableList(memoire.verifications);
    }

    /** Vrai si le projet à compléter ne la passe pas : elle compte. */
    public boolean compte(Verification v) {
        return memoire.duSquelette.get(v.id()).etat != Etat.REUSSI;
    }

    String messageDuSquelette(Verification v) {
        return memoire.duSquelette.get(v.id()).message;
    }

    /** Le titre de l'étape dont celle-ci dépend, vide si elle ne dépend que des classes des étudiants. */
    String besoin(String etape) {
        return BESOINS.containsKey(etape) ? titres.get(BESOINS.get(etape)) : "";
    }

    /** L'image du corrigé, aux coordonnées entières ou au centre des pixels. */
    public Image getImage(boolean auCentre) {
        return auCentre ? memoire.centres : memoire.coins;
    }

    /** Ce que répondent, en chemin, les méthodes du corrigé. */
    synchronized String chemin(double x, double y) throws Arret {
        preparer();
        return corrige.sonde(assemblage, "SondeChemin", "decrire", corrige.scene(), "" + Juge.LARGEUR, ""
                + Juge.HAUTEUR, "" + x, "" + y,
                "" + Juge.PROFONDEUR);
    }

    /** Le reflet de Blinn seul, par les classes du corrigé. */
    synchronized String blinn(String scene, double decalage, int facteur) throws Arret {
        preparer();
        Path copie = chantier.getDossier().resolve("scenes/blinn.ini");
        try {
            Files.copy(Path.of(scene), copie, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return corrige.sonde(assemblage, "SondeVariantes", "blinn", copie.toString(), "" + Juge.LARGEUR, ""
                + Juge.HAUTEUR, "" + decalage, "" + facteur);
    }

    @Override
    public void close() {
        if (machine != null) {
            machine.close();
        }
    }
}
