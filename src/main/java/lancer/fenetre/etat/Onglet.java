package lancer.fenetre.etat;

/** Un onglet du panneau, à droite de l'image. */
public enum Onglet { PIXEL, REGLAGES, VITESSE }
