package lancer.fenetre.etat;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import lancer.Point;
import lancer.Sphere;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ce qui suit de ce qui arrive : l'état, et ce qu'il fait faire. */
class SuiteTest extends EssaiSuite {

    private static final String CHANGE = "boule.ini a changé sur le disque ; F5 le relit et oublie ce que vous avez changé, "
            + "Ctrl\\+E l'écrit dans le nouveau fichier";
    private static final String TIREE = "0.33 0.2 6";
    private static final String LECTURE = "lecture du fichier : la scène ne se change pas encore";
    private static final String ECRITURE = "écriture du fichier : la scène ne se change pas encore";

    /** Ce qui se lit de l'état, par son nom. */
    private final Map<String, Supplier<Object>> lectures = new HashMap<>();

    {
        lectures.put("titre", () -> etat.getTitre("lancer"));
        lectures.put("résumé", () -> etat.getResume());
        lectures.put("avis", () -> etat.avis.texte);
        lectures.put("passe", () -> etat.avis.passe());
        lectures.put("alerte", () -> etat.getAlerte());
        lectures.put("fautes", () -> String.join(" / ", etat.getFautesALire()));
        lectures.put("verdict", () -> etat.explication.direLeVerdict(etat.getImageEntiere()));
        lectures.put("mesures", () -> etat.direLesMesures());
        lectures.put("image", () -> etat.montre.entier ? "achevée" : etat.montre.dessin == null ? "aucune" : "brouillon");
        lectures.put("visible", () -> etat.montre.tenue ? "avant" : "présente");
        lectures.put("taille", () -> etat.montre.dessin.image.largeur + "x" + etat.montre.dessin.image.hauteur);
        lectures.put("fois", () -> etat.ecran.loupe.getReduction(etat.getVisible().image));
        lectures.put("coin", () -> etat.ecran.loupe.getCoin(etat.getVisible().image).toString());
        lectures.put("pixel", () -> etat.ecran.pixel.x + " " + etat.ecran.pixel.y);
        lectures.put("onglet", () -> etat.ecran.onglet);
        lectures.put("section", () -> etat.getSectionChoisie());
        lectures.put("police", () -> etat.ecran.police);
        lectures.put("réflexions", () -> etat.demande.reglages.get(Option.REFLETS));
        lectures.put("étape", () -> etat.demande.reglages.get(Option.ETAPE));
        lectures.put("nombres", () -> etat.direLePixel(11 * 32 + 16));
        lectures.put("copie", () -> copie);
        lectures.put("états", () -> publies);
        // les lignes où il n'est pas la scène des essais
        lectures.put("fichier", () -> {
            List<String> lignes = Arrays.asList(ROUGE.split("\n"));
            return Arrays.stream(lu(boule).split("\n")).filter(ligne -> !lignes.contains(ligne)).collect(Collectors.joining(" "));
        });
        for (String cle : new String[] {"centre", "rayon", "ns"}) {
            lectures.put(cle, () -> section(cle));
        }
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', value = {
        // ce qui se lit et se dessine
        "un réglage de plus se dessine une fois | +, achève | dessiner "
            + "| réflexions=10; image=achevée; états=3; résumé=32 × 24.* 10 réflexions",
        "un pixel ouvert s'explique une fois | clic 16 11, achève, compte, +, achève | expliquer 16 11, dessiner, expliquer 16 11 "
            + "| états=4",
        "ce qui ne change rien n'est pas un autre état | place 32 24, lâche Espace, observe, Ctrl+Z, textes 0 | | états=0",
        "moins de réflexions, jusqu'à aucune | -, -, -, -, achève | dessiner, arreter, dessiner | réflexions=0; image=achevée",
        "dix réflexions au plus | +, +, achève | dessiner | réflexions=10",
        "sans reflets, leur nombre ne se change pas | étape PHONG, +, achève | dessiner | réflexions=5; étape=phong",
        "un ordre remplacé répond pour rien | +, F5, l'ancien répond | dessiner, arreter, lire boule.ini | résumé=lecture 0 % — .*",
        "relire garde les réglages | -, achève, F5, achève | dessiner, lire boule.ini | réflexions=2; image=achevée",
        "un réglage changé pendant la lecture reste | F5, suite, -, achève | lire boule.ini, arreter, dessiner "
            + "| réflexions=2; image=achevée",
        "où en est la lecture se dit | F5, lit 42 | lire boule.ini | résumé=lecture 42 % — .*",
        "l'image d'avant reste, sans son coût | F5, suite, suite | lire boule.ini | image=achevée; résumé=brouillon 0 % — .*",
        "jusqu'au brouillon de la suivante | F5, suite, suite, suite | lire boule.ini | image=brouillon; résumé=dessin 100 % — .*",
        "une préparation n'avance pas | + | dessiner | image=achevée; résumé=préparation 0 % — .*",
        "Échap arrête | +, suite, suite, Échap | dessiner, arreter | image=brouillon; résumé=dessin 100 %, arrêt — .*",
        "F5 recommence | +, suite, suite, Échap, F5, achève | dessiner, arreter, lire boule.ini | image=achevée; réflexions=10",
        "un échec se lit | +, échoue | dessiner | fautes=échec du programme : java.lang.IllegalStateException: boum .*; image=achevée",
        "et se recommence | +, échoue, F5, achève | dessiner, lire boule.ini | fautes=; image=achevée",
        "et ne se lit plus si un autre dessin se fait | +, échoue, -, -, achève | dessiner, dessiner | fautes=; image=achevée",
        "Échap arrête une lecture | ouvre autre.ini, Échap | surveiller autre.ini, lire autre.ini, arreter "
            + "| titre=lancer — autre.ini; image=achevée; ns=40; résumé=32 × 24.*",
        "F5 est à la scène demandée | ouvre autre.ini, Échap, F5, achève "
            + "| surveiller autre.ini, lire autre.ini, arreter, lire autre.ini | titre=lancer — autre.ini; ns=7",
        "Échap arrête une préparation | ouvre autre.ini, suite, Échap | surveiller autre.ini, lire autre.ini, arreter "
            + "| titre=lancer — autre.ini; ns=40; résumé=32 × 24.*",
        "une lecture arrêtée ne recommence pas d'elle-même | fichier ns=41, Échap, observe | lire boule.ini, arreter | ns=40",
        "un autre changement se lit | fichier ns=41, Échap, observe, fichier ns=42, achève | lire boule.ini, arreter, lire boule.ini "
            + "| ns=42",
        // le fichier
        "effacé, son image reste | efface, achève | lire boule.ini | fautes=.*boule.ini : fichier introuvable.*; image=achevée",
        "puis il revient | efface, achève, fichier ns=41, achève | lire boule.ini, lire boule.ini | fautes=; ns=41",
        "corrigée, une faute ne se lit plus avant l'image | fichier ns=-1, achève, fichier ns=41, suite "
            + "| lire boule.ini, lire boule.ini | fautes=; ns=40; image=achevée",
        "fautive et demandée, une scène se surveille | ouvre faute.ini, achève, F5, achève "
            + "| surveiller faute.ini, lire faute.ini, lire faute.ini "
            + "| titre=lancer — faute.ini; ns=40; fautes=.*ligne 6, \\[Sphere 1], ns : .* / l'image qui reste est celle de boule.ini",
        "première et fautive, elle se surveille aussi | sans scène, ouvre faute.ini, achève | surveiller faute.ini, lire faute.ini "
            + "| titre=lancer — faute.ini; image=aucune; fautes=.*ligne 6, \\[Sphere 1], ns : .*",
        "un message fermé se dit encore si l'on relit | ouvre faute.ini, achève, ferme le message, F5, achève "
            + "| surveiller faute.ini, lire faute.ini, lire faute.ini | fautes=.+ / .+",
        // 1.1 : ni écriture, ni geste, tant que le fichier se lit ou s'écrit ; un geste commencé s'achève avant
        "F5 achève ce qui est tiré | saisit, tire, F5 | dessiner, arreter, lire boule.ini | centre=" + TIREE + "; fichier=",
        "F5 oublie ce qui n'est pas écrit | saisit, tire, lâche, F5, achève | dessiner, arreter, lire boule.ini "
            + "| centre=0 0.2 6; titre=lancer — boule.ini; fichier=",
        "une lecture empêche d'écrire | saisit, tire, lâche, achève, F5, Ctrl+E | dessiner, lire boule.ini | avis=" + LECTURE,
        "et de défaire | saisit, tire, lâche, achève, F5, Ctrl+Z | dessiner, lire boule.ini | avis=" + LECTURE + "; centre=" + TIREE,
        "et de tirer | F5, saisit, tire | lire boule.ini | avis=" + LECTURE + "; centre=0 0.2 6",
        "et de taper | F5, tape ns=3 | lire boule.ini | avis=" + LECTURE + "; ns=40",
        "une écriture aussi | tape ns=3, achève, Ctrl+E, saisit, tire, tape ns=4 | dessiner, ecrire | avis=" + ECRITURE + "; ns=3",
        "ce que l'on écrit n'est pas un changement | tape ns=3, achève, Ctrl+E, achève, observe | dessiner, ecrire "
            + "| fichier=ns=3; avis=écrit dans boule.ini; titre=lancer — boule.ini",
        // 1.4 et 2.2 : un fichier qui change pendant qu'un changement n'est pas écrit
        "il n'est pas lu | tape rayon=2, achève, fichier ns=41 | dessiner | ns=40; alerte=" + CHANGE,
        "un clic n'efface pas l'alerte | tape rayon=2, achève, fichier ns=41, ferme le message | dessiner | alerte=" + CHANGE,
        "les mêmes octets n'en sont pas un | tape rayon=2, achève, fichier ns=40 | dessiner | alerte=; rayon=2",
        "ni un fichier qui revient tel qu'il était | tape rayon=2, achève, efface, fichier ns=40 | dessiner | alerte=; rayon=2",
        "disparu, il se dit | tape rayon=2, achève, efface | dessiner | rayon=2; alerte=boule.ini n'est plus sur le disque ; .*",
        "Ctrl+E y écrit le changement seul, et le relit | tape rayon=2, achève, fichier ns=41, Ctrl+E, achève "
            + "| dessiner, ecrire, lire boule.ini | ns=41; fichier=rayon=2 ns=41; alerte=; titre=lancer — boule.ini",
        "relu, il n'a rien à défaire | tape ns=3, achève, F5, achève, Ctrl+Z, achève | dessiner, lire boule.ini | ns=40",
        "Ctrl+Z qui ne laisse rien à écrire le fait lire | tape rayon=2, achève, fichier ns=41, Ctrl+Z, achève "
            + "| dessiner, lire boule.ini | ns=41; rayon=1",
        "sans changement, il se lit | fichier ns=41, achève | lire boule.ini | ns=41; image=achevée",
        // 1.6 : une question à la fois
        "deux fermetures pendant une écriture n'en font qu'une | tape ns=3, achève, Ctrl+E, Ctrl+Q, Ctrl+Q, achève "
            + "| dessiner, ecrire, fermer, terminer | fichier=ns=3",
        "fermer sans écrire demande une fois | tape ns=3, achève, Ctrl+Q, Ctrl+Q, Ctrl+E, écrire sous "
            + "| dessiner, demanderDEcrire boule.ini | ns=3",
        "Rester reste | tape ns=3, achève, Ctrl+Q, répond Rester, Ctrl+Q "
            + "| dessiner, demanderDEcrire boule.ini, demanderDEcrire boule.ini | ns=3",
        "Écrire ferme une fois écrit | tape ns=3, achève, Ctrl+Q, fichier rayon=2, répond Écrire, achève "
            + "| dessiner, demanderDEcrire boule.ini, ecrire, fermer, terminer | fichier=rayon=2 ns=3",
        "Oublier ferme aussitôt | tape ns=3, achève, Ctrl+Q, répond Oublier | dessiner, demanderDEcrire boule.ini, fermer, terminer "
            + "| fichier=",
        "ouvrir demande aussi | tape ns=3, achève, ouvre autre.ini, répond Écrire, achève "
            + "| dessiner, demanderDEcrire boule.ini, ecrire, surveiller autre.ini, lire autre.ini "
            + "| fichier=ns=3; titre=lancer — autre.ini; ns=7",
        "ce qui n'est pas écrit se dit dans le titre | tape ns=3, achève, ouvre faute.ini, répond Oublier, achève "
            + "| dessiner, demanderDEcrire boule.ini, surveiller faute.ini, lire faute.ini "
            + "| titre=lancer — faute.ini \\(boule.ini •\\); ns=3",
        "et s'écrit là | tape ns=3, achève, ouvre faute.ini, répond Oublier, achève, Ctrl+E, achève "
            + "| dessiner, demanderDEcrire boule.ini, surveiller faute.ini, lire faute.ini, ecrire "
            + "| titre=lancer — faute.ini; fichier=ns=3; fautes=.*ns : .*",
        "renoncer à l'écrire laisse place à l'autre, corrigée "
            + "| tape ns=3, achève, ouvre faute.ini, répond Oublier, achève, corrige faute.ini, achève "
            + "| dessiner, demanderDEcrire boule.ini, surveiller faute.ini, lire faute.ini, lire faute.ini "
            + "| titre=lancer — faute.ini; fichier=",
        "changée depuis, celle qui reste attend | ouvre faute.ini, achève, tape ns=3, achève, corrige faute.ini "
            + "| surveiller faute.ini, lire faute.ini, dessiner "
            + "| ns=3; alerte=faute.ini a changé sur le disque ; F5 le relit et oublie ce que vous avez changé dans boule.ini, "
            + "Ctrl\\+E l'y écrit d'abord",
        "puis s'écrit d'abord | ouvre faute.ini, achève, tape ns=3, achève, corrige faute.ini, Ctrl+E, achève "
            + "| surveiller faute.ini, lire faute.ini, dessiner, ecrire, lire faute.ini | fichier=ns=3; titre=lancer — faute.ini; ns=40",
        "refusée, une écriture propose un autre fichier | tape rayon=2, achève, fichier ns=-1, Ctrl+E, achève "
            + "| dessiner, ecrire, proposerEcrireSous boule.ini, ligne 6, [Sphere 1], ns : hors limites : « -1 » ; "
            + "attendu : un nombre de 0 à 1e9 | titre=lancer — boule.ini •; fichier=ns=-1; passe=true",
        "qui s'ouvre | tape rayon=2, achève, efface, Ctrl+E, achève, répond sous.ini, achève "
            + "| dessiner, ecrire, proposerEcrireSous boule.ini : lecture impossible (fichier introuvable) ; "
            + "attendu : un fichier de scène, ecrire sous sous.ini, surveiller sous.ini, lire sous.ini | titre=lancer — sous.ini; rayon=2",
        // 1.5 : l'image d'avant, tant que sa touche est tenue
        "Espace montre l'image d'avant | -, achève, Espace | dessiner | visible=avant; résumé=avant : .* 5 réflexions",
        "celle d'avant une lecture aussi | fichier ns=41, achève, Espace | lire boule.ini | visible=avant; résumé=avant : .*",
        "lâcher Espace la cache | -, achève, Espace, lâche Espace | dessiner | visible=présente; résumé=32 × 24.* 2 réflexions",
        "F2 aussi | -, achève, Espace, F2 | dessiner | visible=présente",
        "F3 aussi | -, achève, Espace, F3 | dessiner, mesurer | visible=présente",
        "un pixel aussi | -, achève, Espace, clic 1 1 | dessiner, expliquer 1 1 | visible=présente",
        "sans image d'avant, rien | Espace | | visible=présente",
        // ce qui se tire et se tape
        "une boule se tire | saisit, tire, lâche | dessiner "
            + "| titre=lancer — boule.ini •; centre=" + TIREE + "; avis=\\[Sphere 1] ligne 1 : centre=" + TIREE + " ; "
            + "Ctrl\\+E l'écrit dans boule.ini; fichier=",
        "ce qui se tire se lit en bas | saisit, tire | dessiner | avis=; résumé=\\[Sphere 1] ligne 1 : centre=" + TIREE,
        "Échap rend sa place | saisit, tire, suite, suite, Échap, tire, achève | dessiner, arreter, dessiner "
            + "| centre=0 0.2 6; titre=lancer — boule.ini",
        "puis arrête | -, Échap, Échap | dessiner, arreter | onglet=null; image=achevée",
        "puis ferme | clic 16 11, Échap | expliquer 16 11, arreter | onglet=null",
        "Ctrl+Z défait un déplacement, puis l'autre | saisit, tire, lâche, achève, tape ns=3, achève, Ctrl+Z "
            + "| dessiner, dessiner, dessiner | ns=40; centre=" + TIREE,
        "et ne laisse rien à défaire | saisit, tire, lâche, achève, Ctrl+Z, achève, Ctrl+Z | dessiner, dessiner "
            + "| titre=lancer — boule.ini",
        "ni le ciel ne se prend | vise 2 2 | | avis=rien ne se tire ici ; .*",
        "pris sans être tiré, il montre ses nombres | saisit, lâche | | section=Sphere 1; onglet=PIXEL; titre=lancer — boule.ini",
        "le ciel n'en a pas | saisit, lâche, clic 0 0, achève | expliquer 0 0 | section=null",
        "un pixel montre ceux de ce qu'il voit | clic 16 11, achève, flèche rayon=1.5, achève "
            + "| expliquer 16 11, dessiner, expliquer 16 11 | section=Sphere 1; rayon=1.5",
        "ils restent, même si le pixel ne la voit plus | clic 16 11, achève, tape centre=9 0 6, achève "
            + "| expliquer 16 11, dessiner, expliquer 16 11 | section=Sphere 1",
        "un champ quitté ne rouvre pas son onglet | clic 16 11, achève, F2, tape ns=41 | expliquer 16 11, dessiner | onglet=REGLAGES",
        "une valeur refusée se dit | tape rayon=-1 | "
            + "| rayon=1; avis=.*ligne 3, \\[Sphere 1], rayon : hors limites : « -1 » ; attendu : .*",
        "une valeur possible ôte le refus | tape rayon=-1, tape rayon=1.5 | dessiner | rayon=1.5; avis=",
        "des flèches se défont d'un coup | tape rayon=1.5, achève, flèche rayon=1.6, flèche rayon=1.7, Ctrl+Z, achève "
            + "| dessiner, dessiner, arreter, dessiner | rayon=1.5",
        "les textes ont de dix points | textes -50, textes -1 | police 10 | police=10",
        "à trente-deux | textes 15, textes 15 | police 27, police 32 | police=32",
        // ce qui se montre
        "remplie, l'image a les proportions demandées | place 50 30, Ctrl+R, achève | dessiner | taille=40x30",
        "quelle que soit sa place | place 50 30, Ctrl+R, achève, place 20 30, achève | dessiner, dessiner | taille=20x15",
        "puis la taille demandée | place 50 30, Ctrl+R, achève, Ctrl+R, achève | dessiner, dessiner | taille=32x24",
        "réduite, elle le dit | place 16 24 | | fois=0.5; résumé=32 × 24 pixels montrés à 50 %, .*",
        "à la loupe aussi | Ctrl+Haut, Ctrl+Haut | | fois=4.0; résumé=32 × 24 pixels à la loupe × 4, .*",
        "seize fois au plus | Ctrl+Haut, Ctrl+Haut, Ctrl+Haut, Ctrl+Haut, Ctrl+Haut | | fois=16.0",
        "Ctrl+Haut grossit autour du pixel expliqué | clic 3 3, Ctrl+Haut | expliquer 3 3 | fois=2.0; coin=.*-4.*-4.*",
        "une image réduite passe d'abord à sa taille | place 16 24, Ctrl+Haut | | fois=1.0",
        "et y revient | place 16 24, Ctrl+Haut, Ctrl+Haut, Ctrl+Bas, Ctrl+Bas | | fois=0.5",
        "une vue a ses nombres | vue normales, achève | dessiner | nombres=N = .*",
        "son brouillon n'en a pas | vue normales, suite, suite | dessiner | image=brouillon; nombres=",
        "celui d'une image a ses couleurs | -, suite, suite | dessiner | image=brouillon; nombres=← .*",
        "les flèches vont d'un pixel à l'autre | clic 16 11, va 1 0, va 0 -1 "
            + "| expliquer 16 11, arreter, expliquer 17 11, arreter, expliquer 17 10 | pixel=17 10",
        "sans sortir de l'image | clic 3 23, achève, va -10 0, achève, va 0 1 | expliquer 3 23, expliquer 0 23 | pixel=0 23",
        "caché, il ne se calcule plus | clic 16 11, achève, F2, -, achève | expliquer 16 11, dessiner | onglet=REGLAGES",
        "il se raconte dès le brouillon | clic 16 11, achève, -, suite, suite, suite | expliquer 16 11, dessiner, expliquer 16 11 "
            + "| verdict=L'image n'est pas achevée.*; image=brouillon",
        "puis de l'image | clic 16 11, achève, -, achève | expliquer 16 11, dessiner, expliquer 16 11 "
            + "| verdict=Au bit près, la couleur du pixel dessiné : #.*",
        "pendant le calcul, il le dit | clic 16 11 | expliquer 16 11 | verdict=calcul…",
        "sous une vue, il n'y a rien à comparer | vue normales, clic 16 11, achève "
            + "| dessiner, expliquer 16 11, arreter, expliquer 16 11 "
            + "| verdict=La couleur de ce pixel, que la vue remplace : #.*; résumé=vue normales, 32 × 24.*",
        "une faute du fichier laisse expliquer l'image qui reste | fichier ns=-1, achève, clic 16 11, achève "
            + "| lire boule.ini, expliquer 16 11 | verdict=Au bit près.*",
        "et la mesurer | fichier ns=-1, achève, F3 | lire boule.ini, mesurer | mesures=mesure en cours : 0 dessin sur 15",
        // ce qui se mesure
        "chaque dessin se compte | F3, suite, suite | mesurer | mesures=mesure en cours : 2 dessins sur .*",
        "un réglage attend la fin du dessin | F3, achève, - | mesurer, dessiner | mesures=Les mesures reprendront après ce dessin.",
        "et ne se mesure pas de nouveau | F3, achève, -, achève | mesurer, dessiner | ns=40",
        "une autre scène se mesure | F3, achève, fichier ns=41, achève | mesurer, lire boule.ini, mesurer | ns=41",
        "Échap arrête la mesure | F3, suite, Échap | mesurer, arreter | mesures=arrêtée : 1 réglage mesuré ; F3 reprend; onglet=VITESSE",
        "F3 la reprend | F3, suite, Échap, F3 | mesurer, arreter, mesurer | mesures=mesure en cours : 1 dessin sur .*",
        "un autre onglet l'arrête | F3, suite, F2 | mesurer, arreter | onglet=REGLAGES",
        // ce qui s'enregistre et se copie
        "une image achevée s'enregistre | Ctrl+S | demanderOuEnregistrer | avis=",
        "une image inachevée, non | -, suite, suite, Ctrl+S | dessiner | avis=L'image se dessine encore : elle n'est pas enregistrée.",
        "une image arrêtée non plus | -, suite, suite, Échap, Ctrl+C | dessiner, arreter "
            + "| avis=Pas d'image achevée ; F5 pour la dessiner.",
        "un échec d'enregistrement reste | ne s'enregistre pas, fichier ns=41, achève | lire boule.ini "
            + "| avis=disque plein; passe=false; ns=41",
        "l'image copiée se dit | Ctrl+C | copier | avis=image copiée, 32 × 24 pixels",
        "les réglages copiés donnent l'image | +, achève, Ctrl+Maj+C | dessiner, copier "
            + "| avis=réglages copiés : la commande; copie=; java .* --taille 32x24 --reflets 10 .*boule.ini\\s"})
    void deCeQuiArriveSuiventDesOrdresEtCeQuiSeLit(String phrase, String gestes, String ordres, String voulu) {
        fichier("autre.ini", ROUGE.replace("ns=40", "ns=7"));
        fichier("faute.ini", ROUGE.replace("ns=40", "ns=-1"));
        montrerLaBoule();
        publies = 0;
        faire(gestes);
        assertEquals(ordres == null ? "" : ordres, String.join(", ", journal));
        for (String voulue : voulu.split("; (?=[a-zé]+=)")) {
            int egal = voulue.indexOf('=');
            String lue = String.valueOf(lectures.get(voulue.substring(0, egal)).get());
            assertTrue(lue.matches("(?s)" + voulue.substring(egal + 1)), voulue + ", et non : " + lue);
        }
    }

    /** L'image est celle de la ligne de commande. */
    @ParameterizedTest
    @CsvSource({"'', --reflets=5", "+, --reflets=10", "-, --reflets=2", "étape OMBRES, --etape=ombres", "vue normales, --vue=normales",
        "vue distance, --vue=distance", "vue lampes, --vue=lampes", "vue rayons, --vue=rayons", "vue marge, --vue=marge"})
    void lImageEstCelleDeLaLigneDeCommande(String geste, String option) {
        montrerLaBoule();
        if (!geste.isEmpty()) {
            faire(geste + ", achève");
        }
        assertArrayEquals(sansFenetre(ROUGE, option), etat.getImageEntiere().codes);
        faire("Ctrl+C, F5, achève");
        assertNotSame(((ImageMemoire) copie).codes, etat.getImageEntiere().codes, "aucun dessin ne se fait dans l'image copiée");
    }

    /** 1.2 : un point de F3 est de la scène où il a été mesuré. */
    @Test
    void unPointMesureSurUneSceneNeSePrendPasPourUneAutre() {
        montrerLaBoule();
        faire("F3, achève");
        Reglages premier = etat.mesures.essais.keySet().iterator().next();
        fichier("autre.ini", ROUGE.replace("rayon=1", "rayon=2"));
        faire("ouvre autre.ini");
        arrive(suite -> suite.viser(premier));
        arrive(Suite::prendre);
        assertEquals(5, etat.demande.reglages.get(Option.REFLETS), "elle se lit");
        executer();
        faire("clic 3 3, étape PHONG");
        arrive(suite -> suite.viser(premier.avec(Option.REFLETS, 3)));
        arrive(Suite::prendre);
        faire("achève");
        assertEquals(5, etat.demande.reglages.get(Option.REFLETS), "ce point n'est pas des siens");
        faire("étape REFLETS, F3, achève");
        arrive(suite -> suite.viser(premier));
        arrive(Suite::prendre);
        assertEquals(premier, etat.demande.reglages, "mesuré sur elle, il l'est");
    }

    @Test
    void unPixelDessineQuiNEstPasCeluiDesEquationsSeDit() {
        montrerLaBoule();
        etat.getImageEntiere().codes[11 * 32 + 16] ^= 1;
        faire("clic 16 11, achève");
        assertTrue(etat.explication.direLeVerdict(etat.getImageEntiere()).startsWith("Différent du pixel dessiné, qui est #"));
        faire("va 1 0, achève");
        assertTrue(etat.explication.direLeVerdict(etat.getImageEntiere()).startsWith("Au bit près"));
    }

    /** Où que soit l'œil, ce qui est tiré suit la souris dans le plan parallèle à l'écran. */
    @ParameterizedTest
    @CsvSource({"''", "'[Camera]\noeil=3 4 16\ncible=0 0 6\nchamp=40\n'"})
    void uneBouleSuitLaSourisEtUneLampeSePrendParSonEtoile(String camera) {
        fichier("boule.ini", camera + ROUGE.replace("-4 6 -3", "0.6 0.5 5"));
        montrerLaBoule();
        for (int k = 0; k < 2; k++) {
            boolean lampe = k == 1;
            Supplier<Point> present = () -> lampe ? etat.demande.lue.lampes.get(0).getPosition()
                    : ((Sphere) etat.demande.lue.objets.get(0)).getCentre();
            Supplier<Point> vue = () -> Prise.projeter(etat.montre.dessin.lancer.getCamera(), present.get());
            Point de = vue.get();
            arrive(suite -> suite.saisir(de.x, de.y, 2));
            arrive(suite -> suite.tirer(de.x + 4, de.y - 2));
            faire("lâche");
            assertEquals(de.x + 4, vue.get().x, 0.1);
            assertEquals(de.y - 2, vue.get().y, 0.1);
            assertEquals(de.z, vue.get().z, 0.1, "à la même distance de l'écran");
            executer();
        }
    }

    @Test
    void niUnSolNiCeQuiNeBougePasNeChange() {
        fichier("boule.ini", "[Sphere sol]\ncentre=0 -19892.188 2099.569\nrayon=20000\nKd=0.5 0.5 0.5\n"
                + ROUGE.replace("0 0.2 6", "0 0.123456789 6"));
        montrerLaBoule();
        faire("vise 30 23");
        assertTrue(etat.avis.texte.startsWith("rien ne se tire ici"), "plus large que l'image, c'est un sol");
        faire("saisit, tire, lâche");
        assertEquals("0.33 0.123456789 6", section("centre"), "ce qui ne bouge pas garde ses décimales");
    }

    /** Ce qui est sous la souris y reste, et le pixel que mènent les flèches reste en vue. */
    @ParameterizedTest
    @CsvSource({"65, 49, 20, 32", "20, 100, 14, 53"})
    void laLoupeGardeCeQuElleGrossit(int largeur, int hauteur, int x, int y) {
        montrerLaBoule();
        faire("place " + largeur + " " + hauteur);
        ImageMemoire image = etat.getVisible().image;
        double taille = etat.ecran.loupe.getReduction(image);
        double xe = (x - (largeur - taille * image.largeur) / 2) / taille;
        double ye = (y - (hauteur - taille * image.hauteur) / 2) / taille;
        for (int k = 0; k < 4; k++) {
            arrive(suite -> suite.grossir(true, x, y));
            assertEquals(x, etat.ecran.loupe.placeDe(image, xe, ye).x, 0.51, "à l'arrondi d'un coin près");
            assertEquals(y, etat.ecran.loupe.placeDe(image, xe, ye).y, 0.51);
        }
        arrive(suite -> suite.amener(new Point(10, 5, 0), 3, 7));
        assertEquals(new Pixel(10, 5), etat.ecran.loupe.pixelDe(image, 3.6, 7.6), "tirée, elle amène là ce point");
        faire("clic 2 3");
        for (int k = 0; k < 20; k++) {
            faire("va 1 1");
            Point coin = etat.ecran.loupe.placeDe(image, etat.ecran.pixel.x, etat.ecran.pixel.y);
            assertTrue(coin.x >= 0 && coin.y >= 0 && coin.x < largeur && coin.y < hauteur, coin.toString());
        }
        assertFalse(etat.enCours(), "rien n'est redessiné");
        assertSame(image, etat.getImageEntiere());
    }

    @ParameterizedTest
    @CsvSource({"0.50,0,1,0.51", "1,1,-1,0", "0.9 0.15 0.1,5,10,0.9 0.25 0.1", "0.9 0.15 0.1,12,-1,0.9 0.15 0.0", "40,0,10,50",
        "-4 6 -3,0,1,-3 6 -3", "1.5e-3,0,1,0.0016", "abc,0,1,", "'',0,1,", "5.,1,1,6", ".5,0,1,0.6"})
    void unPasEstUneUniteDuDernierChiffreEcrit(String texte, int place, int pas, String voulu) {
        assertEquals(voulu, Pas.changer(texte, place, pas));
    }

    @Test
    void uneSectionRenommeeDansLeFichierNEstPlusCelleQueLOnChange() {
        montrerLaBoule();
        faire("clic 16 11, achève, tape ns=41, achève");
        fichier("boule.ini", ROUGE.replace("[Sphere 1]", "[Sphere 2]"));
        faire("Ctrl+E, achève");
        assertTrue(journal.get(journal.size() - 1).contains("[Sphere 1] : section absente"), journal.toString());
        faire("répond Rester, F5, achève");
        assertEquals("Sphere 2", etat.getSectionChoisie(), "à défaut, les nombres sont ceux de ce que voit le pixel");
        faire("tape ns=42");
        assertTrue(etat.avis.texte.contains("[Sphere 1] : section absente du fichier"), etat.avis.texte);
    }
}
