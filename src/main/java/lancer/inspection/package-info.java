/** Explication de la couleur d'un pixel : ses contacts, notés par les classes du cours, seules à calculer. */
package lancer.inspection;
