/**
 * Les réponses plus rapides aux deux questions d'un rayon, « que rencontre-t-il d'abord ? » et « cette lampe est-elle
 * cachée ? », au bit près celles des boucles du cours : par des masques, des cartes, une grille ou un arbre. Rien n'y
 * entre qui change un pixel, ni qui sache d'où vient la scène ou où va l'image.
 *
 * <p>Ce que la machine virtuelle en attend : {@code RechercheRapide} répond par des méthodes assez courtes pour
 * s'incorporer à ce qui les appelle, et les boucles sur les sphères, trop longues pour cela, se compilent une fois
 * chacune ; la recherche d'une scène est toujours de la même classe, et ne laisse échapper que des nombres. Pour le
 * voir : {@code java -XX:+UnlockDiagnosticVMOptions -XX:+PrintCompilation -XX:+PrintInlining -jar target/lancer.jar
 * --repeter 30 --image boules.png scenes/scene1.ini}.
 */
package lancer.rapide;
