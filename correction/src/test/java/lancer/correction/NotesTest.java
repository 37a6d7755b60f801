package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;

/** Deux rendus jugés une fois : leurs notes sur les feuilles que l'on rencontre, et les résultats que l'on garde. */
@EnabledForJreRange(min = JRE.JAVA_17)
class NotesTest extends ClasseEssai {

    private static final Charset CP1252 = Charset.forName("windows-1252");
    private static final String TITRES =
            "Identifier,\"Full name\",Grade,\"Maximum grade\",\"Last modified (grade)\",\"Feedback comments\"\n";

    @TempDir
    static Path jugee;
    @TempDir
    Path dossier;

    @BeforeAll
    static void juger() throws IOException {
        rendre("Ólafur Þór_7001", "--corrige");
        rendre("Zoé N’Guyen_7002", "--squelette");
        noter(jugee.resolve("rendus"), jugee.resolve("classe"));
    }

    /** Un rendu, tel que Moodle le nomme. */
    private static Path rendre(String nom, String quoi) {
        Path rendu = jugee.resolve("rendus").resolve(nom + "_assignsubmission_file");
        assertEquals(0, executer(quoi, rendu.resolve("projet")).code);
        return rendu;
    }

    @BeforeEach
    void copierLaClasse() throws IOException {
        copier(jugee.resolve("classe"), dossier);
    }

    private Essai renoter(Object... options) {
        return renoter(dossier, options);
    }

    private Path feuille(String texte) throws IOException {
        return Files.writeString(dossier.resolve("feuille.csv"), texte);
    }

    private String deposee() throws IOException {
        return Files.readString(dossier.resolve("notes-a-deposer.csv"));
    }

    private Path resultat(String id) {
        return dossier.resolve("resultats/" + id + ".json");
    }

    private void baremer(String lignes) throws IOException {
        Files.writeString(dossier.resolve("bareme.ini"), Files.readString(dossier.resolve("bareme.ini")) + lignes);
    }

    private void ajuster(String lignes) throws IOException {
        Files.writeString(dossier.resolve("ajustements.csv"), lignes);
    }

    private String note(String id) throws IOException {
        Map<String, String> ligne = classe(dossier).get(id);
        return ligne.get("note") + "/" + ligne.get("sur");
    }

    @Test
    void lesNotesEtTousLesPointsSontSurLEchelleDeLaFeuille() throws IOException {
        for (String maximum : List.of("Maximum grade", "Maximum Grade", "MAXIMUM GRADE", "Note maximale")) {
            Path feuille = feuille(TITRES.replace("Maximum grade", maximum) + "Participant 7001,Ólafur Þór,,40.00,-,\n");
            assertEquals(0, renoter("--notes", feuille).code);
            contient(deposee(), "Participant 7001,Ólafur Þór,34.00,40.00,-,\"Correction automatique : 34,00,");
        }
        assertEquals("34.00/40.00", note("7001"));
        contient(page(dossier, "7001"), "34 points sur 40", "<td class=\"n\">5 / 5");
        contient(index(dossier), "note sur 40", "sur 40, la note maximale de la feuille");
        renoter();
        assertEquals("17.00/20.00", note("7001"));
    }

    @Test
    void unTotalQuiNEstPasCeluiDeLaFeuilleNeDonnePasDeuxEchelles() throws IOException {
        baremer("rapport écrit=4\n");
        ajuster("7001,rapport écrit,3,\n");
        renoter("--notes", feuille(TITRES + "Participant 7001,x,9.00,20.00,-,\nParticipant 7002,x,,20.00,-,\n"));
        assertEquals("9.00/20.00", note("7001"), "celle de l'enseignant, sur toutes les pages");
        String index = index(dossier);
        contient(index, "<td class=\"n\">9,00<td class=\"petit\">", "<div>note de la feuille gardée, que nous n&#39;avons pas écrite : "
                + "9,00 ; la nôtre serait 16,67");
        assertEquals(2, index.split("sur 24").length, "dit une fois, et le reste est sur une seule échelle");
        contient(index, "dans bareme.ini et ajustements.csv, ils sont sur 24");
        assertFalse(page(dossier, "7001").contains("sur 24"), "une seule échelle");
        contient(page(dossier, "7001"), "9 points sur 20, la note que l'enseignant a donnée");
    }

    @Test
    void uneNoteMaximaleQuiNeSeLitPasEstRefuseeAvantDeJuger() throws IOException {
        for (String lignes : List.of("7001,x,,trente,-,\n", "7001,x,,,-,\n", "7001,x,,0.00,-,\n", "7001,x,,-5,-,\n", "7001,x,,A,-,\n",
                "7001,x,,30,-,\n7002,x,,3O,-,\n", "7001,x,,30,-,\n7002,x,,20,-,\n", "")) {
            Path feuille = feuille(TITRES + lignes);
            executer("--sans-confinement", "--sortie", dossier, "--notes", feuille, jugee.resolve("rendus"))
                    .exigerRefus(lignes.isEmpty() ? "aucun étudiant" : "attendu : un nombre, le même pour tous");
        }
        renoter("--notes", feuille("Identifier,Grade,Top mark,Last modified (grade)\n7001,,30,-\n"))
                .exigerRefus("la colonne « Note maximale » (« Maximum grade ») manque");
    }

    @Test
    void uneFeuilleEnregistreeParUnTableurFrancaisGardeSonSeparateurSonCodageEtSonSigneDecimal() throws IOException {
        String titres = "Identifiant;Nom complet;NOTE;Note Maximale;Dernière modification (note);Feedback par commentaires\r\n";
        Path feuille = Files.writeString(dossier.resolve("tableur.csv"), titres + "Participant7001;Œuvrée, Maëlle;;50,00;-;\r\n;;;;;\r\n"
                + "Participant7002;b;3,25;50,00;-;à « voir »\r\n", CP1252);
        Essai essai = renoter("--notes", feuille);
        assertEquals(0, essai.code, essai.erreur);
        String ecrit = Files.readString(dossier.resolve("notes-a-deposer.csv"), CP1252);
        contient(ecrit, titres + "Participant7001;Œuvrée, Maëlle;42,50;50,00;-;\"Correction automatique : 42,50, étape atteinte, « ",
                ";;;;;\r\nParticipant7002;b;3,25;50,00;-;à « voir »\r\n");
        assertEquals(0, renoter("--notes", dossier.resolve("notes-a-deposer.csv")).code);
        assertEquals(ecrit, Files.readString(dossier.resolve("notes-a-deposer.csv"), CP1252));
    }

    @Test
    void unBonusEtUnePenaliteNEntrentJamaisDansLeTotalEtLaNoteResteEntreZeroEtLeMaximum() throws IOException {
        baremer("soutenance orale=+2.5\ntrois jours=-4\n");
        Essai avant = renoter();
        assertEquals(List.of("17.00/20.00", ""), List.of(note("7001"), classe(dossier).get("7001").get("trois jours")), avant.erreur);
        assertFalse(Files.readString(dossier.resolve("ajustements-a-remplir.csv")).contains("soutenance"), "rien à donner à chacun");
        ajuster("7001,soutenance orale,\"1,5\",bravo\n7002,trois jours,-4,en retard\n");
        renoter();
        assertEquals(List.of("18.50/20.00", "0.00/20.00"), List.of(note("7001"), note("7002")), "jamais négative");
        contient(page(dossier, "7001"), "1,5 / 0", "bravo");
        contient(page(dossier, "7002"), "-4 / 0", "en retard");
        ajuster("7001,soutenance orale,2.5,\n7001,brume,1,\n7001,antialias,1,\n7001,blinn,1,\n");
        renoter();
        assertEquals("20.00/20.00", note("7001"), "jamais plus que le maximum");
        ajuster("7001,soutenance orale,3,\n7001,trois jours,1,\n7002,consignes,-2,\n7001,absences,-1,\n");
        contient(renoter().erreur, "« 3 » ; attendu : de 0 à 2.5", "« 1 » ; attendu : de -4.0 à 0",
                "« absences » n'existe pas ; attendu : un parmi vecteurs", "ou une ligne de plus dans bareme.ini : bonus=+1, retard=-2");
        assertEquals("20.00/20.00", note("7001"), "la note d'avant");
        baremer("sphere=-1\n");
        contient(renoter().erreur, "« -1 » ; attendu : un nombre de 0 à 9999\n");
    }

    @Test
    void unePageQuiEchoueEstNommeeEtNeCouteQuElle() throws IOException {
        String juge = Files.readString(resultat("7001"));
        Files.writeString(resultat("7001"), juge.replaceFirst("\"remarques\":\\[", "\"remarques\":[null,"));
        Files.delete(dossier.resolve("etudiants/7002.html"));
        Essai essai = renoter();
        assertEquals(1, essai.code);
        contient(essai.erreur, "des pages n'ont pas été écrites : ");
        contient(page(dossier, "7001"), "17 points sur 20 ; le reste de cette page n'a pu être écrit");
        contient(page(dossier, "7002"), "<h2>Les images</h2>");
        contient(index(dossier), "la page de Ólafur", "7002");
        Files.writeString(resultat("7001"), juge);
        renoter();
    }

    @Test
    void leCodageDUneFeuilleEstCeluiQueDisentSesTitresOuElleEstRefusee() throws IOException {
        String cases = "Participant 7002,ç,5,\"20,00\",-,très soigné ; ça marche";
        String lignes = "Participant 7001,é,,\"20\u00A0,00\",-,à voir\n" + cases + "\n";
        for (String codage : List.of("windows-1252", "x-MacRoman", "IBM850")) {
            // Excel finit ainsi les lignes d'un « CSV (Macintosh) »
            String fin = codage.equals("x-MacRoman") ? "\r" : "\n";
            Path feuille = dossier.resolve("codee.csv");
            Files.write(feuille, ("Identifiant,Nom complet,Note,Note maximale,Dernière modification (note),Feedback par commentaires\n"
                    + lignes).replace("\n", fin).getBytes(codage));
            assertEquals(0, renoter("--notes", feuille).code, codage);
            String ecrit = new String(Files.readAllBytes(dossier.resolve("notes-a-deposer.csv")), codage);
            contient(ecrit, fin + cases + fin, "à voir", "étape atteinte, « ");
            Files.write(feuille, (TITRES + lignes).getBytes(codage));
            Essai anglaise = renoter("--notes", feuille);
            assertEquals(codage.equals("windows-1252") ? 0 : 2, anglaise.code, anglaise.erreur);
            assertTrue(anglaise.code == 0 || anglaise.erreur.contains("CSV UTF-8"), anglaise.erreur);
        }
    }

    @Test
    void uneFeuilleADeposerQueQuelquUnAChangeeEstMiseDeCoteEtCEstDit() throws IOException {
        Path feuille = feuille(TITRES + "Participant 7001,a,,20.00,-,\nParticipant 7002,b,21,20.00,-,déjà vu\n");
        assertFalse(renoter("--notes", feuille).erreur.contains("changé"));
        String notre = deposee();
        contient(notre, "b,21,20.00,-,déjà vu");
        contient(classe(dossier).get("7002").get("à regarder"), "note de la feuille gardée, que nous n'avons pas écrite : 21, que Moodle "
                + "ignorera");
        assertFalse(renoter("--notes", feuille).erreur.contains("changé"), "elle est telle que nous l'avons écrite");
        Files.writeString(dossier.resolve("notes-a-deposer.csv"), notre.replace("a,17.00", "a,11.75"));
        String dit = renoter("--notes", feuille).erreur;
        contient(dit, "notes-a-deposer.csv a été changé : il est gardé sous le nom « notes-a-deposer changée avant le ");
        assertEquals(notre, deposee());
        contient(Files.readString(dossier.resolve(dit.replaceFirst("(?s).*« (.*?\\.csv) ».*", "$1"))), "a,11.75");
        contient(index(dossier), "notes-a-deposer.csv a été changé");
    }

    private String empreinte(String id) throws IOException {
        return Files.readString(resultat(id)).replaceFirst("(?s).*(\"empreinte\":\"[^\"]*).*", "$1");
    }

    @Test
    void laMemeNoteEstSurLaPageDansLeTableauEtDansLaFeuille() throws IOException {
        ajuster("7001,sphere,0.625,\n");
        renoter("--notes", feuille(TITRES + "Participant 7001,x,,20.00,-,\nParticipant 7002,y,3.5,20.00,-,\n"));
        contient(page(dossier, "7001"), "15,13 points sur 20");
        contient(deposee(), "7001,x,15.13,20.00,-,\"Correction automatique : 15,13, ");
        assertEquals(List.of("15.13/20.00", "3.50/20.00"), List.of(note("7001"), note("7002")));
        contient(page(dossier, "7002"), "3,5 points sur 20, la note que l'enseignant a donnée");
        contient(index(dossier), "moyenne 9,32 sur 20, médiane 9,32", "<h2>Les notes</h2>");
    }

    @Test
    void quiNARienRenduEstNommeEtUnGroupeAussi() throws IOException {
        changer(resultat("7002"), empreinte("7002"), empreinte("7001"));
        contient(renoter("--notes", feuille(TITRES + "Participant 7001,x,,20.00,-,\nParticipant 7003,Zoé Roux,,20.00,-,\n")).erreur,
                "dans la feuille, et sans rendu ici (1) : Zoé Roux\n",
                "un même rendu pour 2 identifiants : Ólafur Þór (7001), Zoé N’Guyen (7002)\n");
    }

    @Test
    void desClassesEcritesPareilSontDitesADeuxEtudiants() throws IOException {
        changer(resultat("7001"), "\"formes\":{", "\"formes\":{\"Sphere.f\":\"s\",\"Scene.g\":\"a\"");
        changer(resultat("7002"), "\"formes\":{", "\"formes\":{\"Sphere.autre\":\"s\",\"Scene.g\":\"b\"");
        renoter();
        contient(classe(dossier).get("7001").get("à regarder"),
                "écrit comme chez Zoé N’Guyen (7002), aux noms et aux commentaires près : Sphere.f");
        contient(classe(dossier).get("7002").get("à regarder"),
                "écrit comme chez Ólafur Þór (7001), aux noms et aux commentaires près : Sphere");
    }

    @Test
    void ceQueLaFeuilleDitDUnRetardEstSurLesPages() throws IOException {
        renoter("--notes", feuille("Identifiant,Statut,Note,Note maximale,Dernière modification (note)\n"
                + "Participant7001,Remis pour évaluation - En retard de 2 jours,,20,-\nParticipant7002,Remis pour évaluation,,20,-\n"));
        contient(page(dossier, "7001"), "<p>En retard de 2 jours</p>");
        contient(index(dossier), "En retard de 2 jours");
        assertFalse(page(dossier, "7002").contains("retard"));
    }

    @Test
    void unRenduDePlusEstAjouteOuRemplaceSansQuAucunAutreNeChange() throws IOException {
        Path resultats = dossier.resolve("resultats");
        Files.writeString(resultats.resolve("mes-notes.csv"), "à moi");
        String autre = Files.readString(resultat("7002"));
        Path achevee = jugee.resolve("rendus/Ólafur Þór_7001_assignsubmission_file");
        Path tard = dossier.resolve("tard");
        copier(achevee, tard.resolve("Émile Abe_7009_assignsubmission_file"));
        copier(achevee, tard.resolve(achevee.getFileName().toString()));
        changer(tard.resolve(achevee.getFileName() + "/projet/src/main/java/lancer"), "Sphere", "distance = (-b - racine) / 2;",
                "distance = 3;");
        Essai essai = executer("--sans-confinement", "--sortie", dossier, tard);
        assertEquals(0, essai.code, essai.erreur);
        contient(essai.erreur, "2 entrées, 2 lignes", "un autre travail va remplacer celui de « Ólafur Þór, jugé le ",
                "Ólafur Þór (7001) : jugé ; remplace un autre travail de « Ólafur Þór », jugé le ");
        contient(classe(dossier).get("7001").get("à regarder"), "remplace un autre travail de « Ólafur Þór », jugé le ");
        assertEquals(Set.of("7001", "7002", "7009"), classe(dossier).keySet());
        contient(index(dossier), "3 entrées, 3 lignes");
        assertEquals("17.00/20.00", note("7009"));
        assertFalse(note("7001").equals("17.00/20.00"), "il a pris la place du premier");
        assertEquals(autre, Files.readString(resultat("7002")));
        assertEquals(2, renoter("--neuf").code, "sans rendus, rien de neuf");
        // un seul rendu, et tout ce qui précède est mis de côté
        Path seul = dossier.resolve("seul/Zoé_7003_assignsubmission_file");
        copier(achevee, seul);
        Essai neuf = executer("--sans-confinement", "--neuf", "--un", "--sortie", dossier, seul);
        assertEquals(0, neuf.code, neuf.erreur);
        assertEquals(Set.of("7003"), classe(dossier).keySet());
        try (Stream<Path> tous = Files.walk(dossier)) {
            assertEquals(1, tous.filter(f -> f.toString().matches(".*/avant [^/]*/resultats/mes-notes.csv")).count());
        }
    }

    @Test
    void lIdentifiantDUnDossierNEstPasUneFormuleEtSaLigneSeRelit() throws IOException {
        Path resultat = resultat("7001");
        String nom = "=SOMME(A1)+k;@b";
        Files.writeString(resultat, Files.readString(resultat).replaceFirst("\"id\":\"7001\",\"nom\":\"[^\"]*",
                "\"id\":\"" + nom + "\",\"nom\":\"" + nom)
                .replace("\"verdicts\":{", "\"verdicts\":{\"brume.image\":{\"etat\":\"A_NOTER\",\"message\":\"\"},"));
        renoter();
        String aRemplir = Files.readString(dossier.resolve("ajustements-a-remplir.csv"));
        contient(aRemplir, "'=SOMME(A1)+k;'@b,brume,,");
        ajuster(aRemplir.replace("brume,,", "brume,0.5,"));
        assertEquals("", renoter().erreur);
        assertEquals("17.50", classe(dossier).values().stream().map(l -> l.get("note")).max(String::compareTo).get());
    }

    @Test
    void unTexteDUnEtudiantNAgitNiSurSaPageNiSurLIndex() throws IOException {
        Path resultat = resultat("7001");
        Files.writeString(resultat, Files.readString(resultat).replaceFirst("\"nom\":\"[^\"]*",
                "\"nom\":\"<b>x</b> & '\\\\\"y\\\\\" \\${7*7} <#stop> \u202e\\\\u0007"));
        assertEquals(0, renoter().code);
        for (String page : List.of(page(dossier, "7001"), index(dossier))) {
            contient(page, "&lt;b&gt;x&lt;/b&gt; &amp; &#39;&quot;y&quot; ${7*7} &lt;#stop&gt; \uFFFD\uFFFD");
        }
    }

    @Test
    void deuxCorrecteursALaFoisDonnentLUnion() throws Exception {
        CompletableFuture<?>[] correcteurs = Stream.of("TP1", "TP2").map(nom -> CompletableFuture.runAsync(() -> {
            try {
                Path rendus = Files.createDirectories(dossier.resolve(nom));
                for (String fin : List.of(" à déplier", " vide")) {
                    Files.writeString(Files.createDirectories(rendus.resolve(nom + fin)).resolve("rapport.pdf"), "x");
                }
                Essai essai = executer("--sans-confinement", "--sortie", dossier, rendus);
                assertEquals(0, essai.code, essai.erreur);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        })).toArray(CompletableFuture[]::new);
        CompletableFuture.allOf(correcteurs).join();
        assertEquals(Set.of("7001", "7002", "TP1 à déplier", "TP1 vide", "TP2 à déplier", "TP2 vide"),
                classe(dossier).keySet());
        contient(index(dossier), "6 entrées, 6 lignes", "etudiants/TP1%2520vide.html");
    }
}
