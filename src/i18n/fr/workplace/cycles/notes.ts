export const turnMode =
  "Ne s’exécute qu’en FUNCTION MODE TURN. Sur une TNC7, le constructeur de la machine doit avoir activé la fonction.";
export const safePosition =
  "Avant l’appel, positionner l’outil avec R0 à un endroit sûr : ce point est le départ du cycle et détermine ce qui est usiné.";
export const edgeLength =
  "Une valeur CUTLENGTH du tableau d’outils limite la passe d’ébauche ; elle est alors réduite, avec un avertissement.";
/** What holds for every cycle that takes its contour from a subprogram. */
export const freeContour = [
  "Risque de collision : la limite d’usinage restreint le contour usiné, mais l’approche et la sortie peuvent la franchir. " +
    "Placer l’outil, avant l’appel, du côté de la limite qui doit être usiné.",
  turnMode,
  safePosition,
  "La forme de la plaquette est prise en compte pour ne endommager aucun élément. Ce que l’outil n’atteint pas reste, avec un " +
    "avertissement.",
  "Le cycle 14 avec le label du contour, ou SEL CONTOUR avec son fichier, doit précéder l’appel.",
  "Les paramètres locaux (QL) du contour doivent être affectés dans le sous-programme lui-même.",
  edgeLength,
];
/** What holds where a tool plunges and no feed is asked for it. */
export const plunging =
  "La plongée se fait à l’avance d’ébauche : ces cycles ne demandent pas d’avance propre pour elle. Sur un flanc plus " +
  "raide que l’arête ne peut le suivre, de la matière reste, avec un avertissement.";
