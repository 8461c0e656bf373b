export const turnMode =
  "Ne s’exécute qu’en FUNCTION MODE TURN. Sur une TNC7, le constructeur de la machine doit avoir activé la fonction.";
export const safePosition =
  "Avant l’appel, positionner l’outil avec R0 à un endroit sûr : ce point est le départ du cycle et détermine la " +
  "zone à usiner.";
export const edgeLength =
  "CUTLENGTH dans le tableau d’outils limite la passe d’ébauche ; une passe plus grande est réduite, avec un " +
  "avertissement.";
/** Notes of every cycle that takes its contour from a subprogram. */
export const freeContour = [
  "Risque de collision : la limite d’usinage restreint le contour usiné, mais l’approche et la sortie peuvent la " +
    "franchir. " +
    "Avant l’appel, positionner l’outil du côté de la limite où la matière doit être enlevée.",
  turnMode,
  safePosition,
  "La géométrie de la plaquette est prise en compte pour n’endommager aucun élément du contour. Là où l’outil " +
    "n’accède pas, il reste de la matière résiduelle, avec un avertissement.",
  "Le cycle 14 avec le label du contour, ou SEL CONTOUR avec son fichier, doit précéder l’appel.",
  "Les paramètres locaux (QL) du contour doivent être affectés dans le sous-programme lui-même.",
  edgeLength,
];
/** Note of the cycles that plunge without a plunging feed. */
export const plunging =
  "L’outil plonge à l’avance d’ébauche : ces cycles n’ont pas d’avance de plongée. Sur un flanc trop raide pour " +
  "la plaquette, il reste de la matière résiduelle, avec un avertissement.";
/** Note of cycle 812: a printed list, with one fact that the page leaves open. */
export const inclination = "Non imprimé, donc non vérifié : le sens dans lequel Q495 et Q496 inclinent les surfaces.";
