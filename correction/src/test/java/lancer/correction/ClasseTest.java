package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipFile;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;

/** Six rendus de plus en plus complets, notés d'un bout à l'autre. */
@EnabledForJreRange(min = JRE.JAVA_17)
class ClasseTest extends ClasseEssai {

    @TempDir
    static Path dossier;

    private static final String TITRES = "Identifiant,Note,Note maximale,Dernière modification (note),Feedback par commentaires\n";

    private static Map<String, Map<String, String>> classe;

    @BeforeAll
    static void noterLaClasse() throws IOException {
        classe = noter(RENDUS.resolve("classe"), dossier);
    }

    private static void etapes(String id, String... attendues) {
        List<String> noms = List.of("vecteurs", "rayons", "sphere", "scene", "lambert", "phong", "ombres", "reflets", "image");
        for (int k = 0; k < attendues.length; k++) {
            assertEquals(attendues[k], classe.get(id).get(noms.get(k)), noms.get(k) + " de " + id);
        }
    }

    @Test
    void chacunAUneLigneDansLOrdre() {
        assertEquals("[101, 102, 103, 104, 105, 106]", classe.keySet().toString());
    }

    @Test
    void ceQuiNEstPasCommenceNeRapporteRienEtNEstPasRate() throws IOException {
        etapes("101", "1/7", "0/9", "0/7", "0/11", "0/9", "0/7", "0/7", "0/8", "0/3");
        assertEquals("aucune en entier", classe.get("101").get("étape atteinte"));
        String page = page(dossier, "101");
        assertEquals(List.of("fausse", "non commencé"), List.of(etat(page, "u.dot(v) est le produit scalaire"),
                etat(page, "norme2 est le carré de la norme")), "écrit et faux, ou laissé tel quel");
    }

    private static String etat(String page, String critere) {
        return page.replaceFirst("(?s).*<span class=\"e \\w+\">([^<]*)</span> " + Pattern.quote(critere) + ".*", "$1");
    }

    @Test
    void uneImageRenverseeEstUneFauteDeLaCameraSeule() throws IOException {
        etapes("102", "7/7", "5/9", "0/7", "1/11");
        assertTrue(page(dossier, "102").matches("(?s).*le pixel \\(0,0\\) d&#39;un écran [^<]*"
                + "attendu : \\(-1\\.0, ([\\d.]+), 0\\.0\\), obtenu : \\(-1\\.0, -\\1, 0\\.0\\).*"));
        assertEquals(2, page(dossier, "102").split("<pre>[^<]*Rayon getRayon").length, "montrée une fois, quoi qu'elle rate");
    }

    @Test
    void uneFauteDeSyntaxeNeCouteQueSaMethode() throws IOException {
        etapes("103", "7/7", "9/9", "0/7", "1/11", "1/9");
        contient(page(dossier, "103"), "n&#39;est pas en UTF-8",
                "Sphere.java:31 : il manque « ; » ; le compilateur dit « Syntax error, insert &quot;;&quot; to complete");
    }

    @Test
    void lNonNormaliseEstUneFauteDeLambertEtCeQuiSuitEstAFaire() throws IOException {
        etapes("104", "7/7", "9/9", "7/7", "11/11", "8/9", "0/7", "0/7", "0/8", "0/3");
        assertEquals("Scène de sphères", classe.get("104").get("étape atteinte"));
        contient(page(dossier, "104"), "L est normalisé", "lampe 1 seule, sans Ks");
    }

    @Test
    void uneRecursionSansFinNEchappePasEtLaSignatureDuCoursVautLaNotre() throws IOException {
        etapes("105", "7/7", "9/9", "7/7", "11/11", "9/9", "7/7", "7/7", "5/8");
        contient(page(dossier, "105"), "se renvoient le rayon sans fin");
    }

    /** Il s'écarte un peu de ses surfaces, limite ses couleurs à 1, et affiche chacun de ses reflets. */
    @Test
    void unRenduCompletATousLesPointsEtSesExtensionsSontANoter() throws IOException {
        assertEquals(List.of("17.00", "20.00", "oui", "à noter"), List.of(classe.get("106").get("note"), classe.get("106").get("sur"),
                classe.get("106").get("image identique"), classe.get("106").get("brume")));
        assertEquals("Reflets des objets ; extensions à noter : brume, anticrénelage, reflet de Blinn",
                classe.get("106").get("étape atteinte"));
        contient(page(dossier, "106"), "<figcaption>reflet de Blinn</figcaption>", "<figcaption>la base</figcaption>",
                "<figcaption>le corrigé</figcaption>");
        assertEquals("id,critère,points,commentaire\r\n106,brume,,\r\n106,antialias,,\r\n106,blinn,,\r\n",
                Files.readString(dossier.resolve("ajustements-a-remplir.csv")));
    }

    @Test
    void unMessageQuiSeRepeteNEstDeplieQuUneFois() throws IOException {
        String page = page(dossier, "103");
        assertEquals(1, Stream.of(page.split("<details open>")).skip(1).filter(d -> d.split("</details>")[0]
                .contains("Syntax error")).count(), "la même cause, à chaque vérification de la méthode");
    }

    @Test
    void lesPagesNOntRienQuiVienneDAilleurs() throws IOException {
        String index = index(dossier);
        contient(index, "L'étape qui arrête le plus d'étudiants", "6 entrées, 6 lignes");
        assertFalse(index.matches("(?s).*le plus d'étudiants : <strong>[^<]*(Extension|image).*"),
                "une étape du cours, non une extension que personne n'a encore faite");
        for (String page : List.of(index, page(dossier, "104"))) {
            assertFalse(page.matches("(?s).*(?:src|href)=\"(?!data:|etudiants/).*"), "une adresse");
            assertFalse(page.contains("<script"));
        }
    }

    /** Note de nouveau ce qui a été jugé. */
    private static Essai renoter(Object... options) {
        Essai essai = renoter(dossier, options);
        assertEquals(0, essai.code, essai.erreur);
        return essai;
    }

    @Test
    void noterNeJugePasDeNouveauEtSuitLeBareme() throws IOException {
        Path bareme = Files.writeString(dossier.resolve("autre.ini"), "[Barème]\nvecteurs=1\nimage=3\n");
        renoter("--bareme", bareme);
        assertEquals(List.of("4.00", "4.00"), List.of(classe(dossier).get("106").get("note"), classe(dossier).get("106").get("sur")));
        assertEquals("1.00", classe(dossier).get("104").get("note"));
        renoter();
        assertEquals(classe, classe(dossier));
    }

    @Test
    void sansResultatsIlNYARienANoter(@TempDir Path vide) {
        renoter(vide).exigerRefus();
        assertEquals(2, executer("--noter", RENDUS.resolve("classe")).code, "--noter ne juge rien");
    }

    @Test
    void laGraineEstTireeUneFoisEtUneAutreEstRefuseeSiCeNEstPasUnNombre(@TempDir Path autre) throws IOException {
        assertTrue(Files.readString(dossier.resolve("graine.txt")).matches("\\d+\n"));
        Files.writeString(autre.resolve("graine.txt"), "douze\n");
        executer("--sortie", autre, "--sans-confinement", RENDUS.resolve("classe"))
                .exigerRefus("graine.txt : « douze » ; attendu : un nombre entier");
    }

    @Test
    void lesPointsDUneExtensionEtDUneLigneLibreSontCeuxQueLEnseignantDonne() throws IOException {
        Path bareme = dossier.resolve("libre.ini");
        Files.writeString(bareme, Files.readString(dossier.resolve("bareme.ini")) + "qualité du code=3\n");
        renoter("--bareme", bareme);
        Map<String, String> avant = classe(dossier).get("106");
        assertEquals(List.of("17.00", "23.00", "à noter"), List.of(avant.get("note"), avant.get("sur"), avant.get("qualité du code")),
                "une ligne libre entre dans le total, comme une extension");
        Path ajustements = dossier.resolve("ajustements.csv");
        Files.writeString(ajustements, "106;brume;0,75;à peine visible\n106;qualité du code;2,5;\n106;blinn;;\n");
        renoter("--bareme", bareme);
        Map<String, String> apres = classe(dossier).get("106");
        assertEquals(List.of("20.25", "23.00", "0,75/1"), List.of(apres.get("note"), apres.get("sur"), apres.get("brume")));
        assertEquals(classe.get("104").get("note"), classe(dossier).get("104").get("note"));
        contient(Files.readString(dossier.resolve("ajustements-a-remplir.csv")), "106,brume,\"0,75\",à peine visible\r\n",
                "106,antialias,,\r\n", "106,blinn,,\r\n", "104,qualité du code,,\r\n");
        Files.delete(ajustements);
    }

    @Test
    void uneNoteDeLEnseignantResteASaTroisiemeFoisCommeALaPremiere() throws IOException {
        Path feuille = dossier.resolve("a-lui.csv");
        String nous = "Correction automatique : 16.75, étape atteinte, « x » ; le détail est dans le fichier de retour.";
        Files.writeString(feuille, TITRES + "Participant106,\"8,50\",20.00,-,\nParticipant104,12.00,20.00,-,\"Bien vu " + nous
                + "\"\nParticipant105,16.75,20.00,-,\"" + nous
                + "\"\nParticipant103,,20.00,-,Absent\nParticipant102," + classe.get("102").get("note") + ",20.00,-,\n");
        String premiere = null;
        for (int fois = 0; fois < 3; fois++) {
            renoter("--notes", feuille);
            String ecrit = Files.readString(dossier.resolve("notes-a-deposer.csv"));
            assertEquals(premiere == null ? ecrit : premiere, ecrit);
            premiere = ecrit;
            contient(classe(dossier).get("106").get("à regarder"), "note de la feuille gardée, que nous n'avons pas écrite : 8,50 ; la "
                    + "nôtre serait 17,00");
            contient(ecrit, "Participant106,\"8,50\",20.00,-,\n", "Participant104,12.00,20.00,-,Bien vu\n",
                    "Participant105," + classe.get("105").get("note") + ",20.00,-,\"Correction automatique : "
                    + classe.get("105").get("note").replace('.', ','),
                    "Participant103," + classe.get("103").get("note") + ",20.00,-,\"Absent Correction automatique : ",
                    "Participant102," + classe.get("102").get("note") + ",20.00,-,\n");
            // déposée, puis donnée de nouveau par Moodle, elle en reste là
            Files.copy(dossier.resolve("notes-a-deposer.csv"), feuille, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    @Test
    void lesMotsDeLEnseignantDansNotrePhraseSontLesSiens() throws IOException {
        String phrase = "Correction automatique : 12.00, mais voir mon mail ; le détail est dans le fichier de retour.";
        renoter("--notes", Files.writeString(dossier.resolve("melee.csv"), TITRES + "Participant106,12.00,20,-,\"" + phrase + "\"\n"));
        contient(Files.readString(dossier.resolve("notes-a-deposer.csv")), "Participant106,12.00,20,-,\"" + phrase);
    }

    @Test
    void unResultatAbimeEstNomme(@TempDir Path copie) throws IOException {
        copier(dossier, copie);
        Path abime = copie.resolve("resultats/102.json");
        String texte = Files.readString(abime);
        Files.writeString(abime, texte.substring(0, texte.length() / 2) + "\"");
        renoter(copie).exigerRefus("102.json manque, ou est abîmé");
    }

    @Test
    void sansColonneDeCommentairesSeulesLesCasesVidesSontRemplies() throws IOException {
        String lignes = "Identifier,Grade,Maximum Grade,Last modified (grade)\nParticipant 106,17.00,20.00,-\n"
                + "Participant 104,3.00,20.00,-\nParticipant 105,%s,20.00,-\n";
        renoter("--notes", Files.writeString(dossier.resolve("sans.csv"), String.format(lignes, "")));
        assertEquals(String.format(lignes, classe.get("105").get("note")), Files.readString(dossier.resolve("notes-a-deposer.csv")));
        contient(classe(dossier).get("104").get("à regarder"), "la nôtre serait " + classe.get("104").get("note").replace('.', ','));
    }

    @Test
    void laFeuilleDeMoodleNEstChangeeQueDansLesCasesDeLaNoteEtDuCommentaire() throws IOException {
        verifierFeuille("notes-fr.csv", "\uFEFFIdentifiant,\"Nom complet\",Statut,Note,\"Note maximale\",\"La note peut être modifiée\","
                + "\"Dernière modification (travail remis)\",\"Dernière modification (note)\",Autre,\"Feedback par commentaires\"\n",
                "Participant", "Oui", "Non");
        verifierFeuille("notes-en.csv", "Identifier,\"Full name\",Status,Grade,\"Maximum Grade\",\"Grade can be changed\","
                + "\"Last modified (submission)\",\"Last modified (grade)\",Other,\"Feedback comments\"\n", "Participant ", "Yes", "No");
    }

    private void verifierFeuille(String nom, String entete, String prefixe, String oui, String non) throws IOException {
        String lignes = prefixe + "106,\"Étudiant, 6\",\"Remis \"\"à temps\"\"\",,10.00," + oui + ",hier,-,\"a\nb\",\n"
                + prefixe + "104,Étudiant 4,x,3.00,10.00," + oui + ",hier,-,,Très bien !\n"
                + prefixe + "105,Étudiant 5,x,,10.00," + non + ",hier,-,,\n"
                + prefixe + "999,Étudiant absent,x,,10.00," + oui + ",,-,,\n";
        Essai essai = renoter("--notes", Files.writeString(dossier.resolve(nom), entete + lignes));
        contient(essai.erreur, "absents de la feuille, ou que Moodle y a verrouillés : Étudiant 1 (101), Étudiant 2 (102), "
                + "Étudiant 3 (103), Étudiant 5 (105)\n");
        String ecrit = Files.readString(dossier.resolve("notes-a-deposer.csv"));
        assertEquals(entete.startsWith("\uFEFF"), ecrit.startsWith("\uFEFF"));
        List<CSVRecord> avant = CSVParser.parse(entete + lignes, CSVFormat.DEFAULT).getRecords();
        List<CSVRecord> apres = CSVParser.parse(ecrit, CSVFormat.DEFAULT).getRecords();
        assertEquals(avant.size(), apres.size());
        for (int i = 0; i < avant.size(); i++) {
            for (int k = 0; k < avant.get(i).size(); k++) {
                if (i == 0 || k != 3 && k != 9 || i > 2) {
                    assertEquals(avant.get(i).get(k), apres.get(i).get(k), "ligne " + i + ", colonne " + k);
                }
            }
        }
        assertEquals("8.50", apres.get(1).get(3), "ramenée à la note maximale de la feuille");
        contient(apres.get(1).get(9), "Reflets des objets ; extensions à noter : brume");
        assertEquals(List.of("3.00", "Très bien !"), List.of(apres.get(2).get(3), apres.get(2).get(9)),
                "ce que l'enseignant a écrit reste");
        try (ZipFile zip = new ZipFile(dossier.resolve("retours.zip").toFile())) {
            assertTrue(zip.getEntry("Étudiant 4_104_assignsubmission_file/correction.html") != null);
            assertEquals(6, zip.size());
        }
    }

    @Test
    void desPointsDonnesALaMainComptentEtToutesLesLignesFautivesSontNommeesSansRienNoter() throws IOException {
        Path ajustements = dossier.resolve("ajustements.csv");
        String titres = "id,critère,points,commentaire\n";
        Files.writeString(ajustements, titres
                + "101,sphere,2.5,vu en TP\n999,sphere,1,\n102,flou,1,\n101,sphere,1,encore\n104,lambert,25,\n");
        String index = index(dossier);
        Essai essai = renoter(dossier);
        assertEquals(2, essai.code);
        contient(essai.erreur, "ligne 3, l'étudiant « 999 » n'existe pas", "ligne 4, le critère « flou » n'existe pas",
                "ligne 5, « sphere » a déjà été donné à « 101 » plus haut", "ligne 6, « 25 » ; attendu : de 0 à 2.0 pour « lambert »");
        assertEquals(index, index(dossier));
        Files.writeString(ajustements, titres + "101,sphere,2.5,vu en TP\n");
        renoter();
        Files.delete(ajustements);
        assertEquals(Double.parseDouble(classe.get("101").get("note")) + 2.5, Double.parseDouble(classe(dossier).get("101").get("note")),
                1e-9);
        assertEquals(classe.get("102").get("note"), classe(dossier).get("102").get("note"));
        contient(page(dossier, "101"), "Donné par l'enseignant : vu en TP");
    }

    @Test
    void uneFeuilleDontUneColonneManqueEstRefuseeEnUnePhrase() throws IOException {
        Path feuille = Files.writeString(dossier.resolve("fausse.csv"), "Identifiant,Nom complet,Note\nParticipant101,x,\n");
        executer("--sortie", dossier, "--notes", feuille, RENDUS.resolve("classe")).exigerRefus("Dernière modification (note)");
    }
}
