export const turnMode = "Ne s'exécute qu'en FUNCTION MODE TURN. Sur une TNC7, le constructeur de la machine doit avoir activé la fonction.";
export const safePosition =
  "Avant l'appel, positionner l'outil avec R0 à un endroit sûr : ce point est le départ du cycle et détermine ce qui est usiné.";
export const edgeLength = "Une valeur CUTLENGTH du tableau d'outils limite la passe d'ébauche ; elle est alors réduite, avec un message.";
