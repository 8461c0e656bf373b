import { typeset } from "../typography/typeset.ts";

/** Function of each word of a block, by its field, and common mistakes. */
export const blockWords = typeset({
  name: {
    about: "Nom du programme.",
    mistakes: ["Contient des espaces ou des accents : certaines commandes refusent le fichier."],
  },
  unit: {
    about: "MM ou INCH pour toutes les longueurs et avances du programme.",
    mistakes: ["Des valeurs sont copiées entre programmes d’unités différentes."],
  },
  toolAxis: {
    about: "Axe d’outil. Z en tournage.",
    mistakes: ["X ou Y repris d’un programme de fraisage."],
  },
  "blankBox.X": {
    about: "X de ce coin. En tournage, le coin le plus éloigné décide.",
    mistakes: ["Un ⌀ est saisi ; un parallélépipède se mesure depuis l’axe."],
  },
  "blankBox.Y": {
    about: "Y de ce coin. En tournage, le coin le plus éloigné décide.",
    mistakes: ["Le parallélépipède est à côté de l’axe."],
  },
  "blankBox.Z": {
    about: "Z de ce coin : 0.1 l’arrière, 0.2 la face.",
    mistakes: ["La face finit à Z0 alors qu’elle est encore brute."],
  },
  outsideMeasure: {
    about: "Extérieur en ⌀ (D) ou en rayon (R).",
    mistakes: ["R avec un ⌀ saisi : la pièce brute est deux fois trop grosse."],
  },
  insideMeasure: {
    about: "Alésage en ⌀ (DI) ou en rayon (RI).",
    mistakes: ["RI avec un ⌀ saisi."],
  },
  measure: {
    about: "X du profil en ⌀ (DIM_D) ou en rayon (DIM_R).",
    mistakes: ["DIM_D avec un profil en rayons : la pièce brute est deux fois trop mince."],
  },
  blankSource: {
    about: "Profil dans un label de ce programme ou dans un fichier.",
    mistakes: ["Le fichier n’est pas dans le dossier du programme."],
  },
  "blankRotation.label": {
    about: "Label du profil de la pièce brute.",
    mistakes: ["Label du contour fini saisi : il ne reste rien à usiner."],
  },
  "turnBlank.label": {
    about: "Label du profil fermé de la matière serrée.",
    mistakes: ["Profil de la pièce finie utilisé."],
  },
  file: {
    about: "Fichier du profil, avec son extension, ou un paramètre QS qui contient son nom.",
    mistakes: ["Chemin d’une autre machine inclus."],
  },
  "selectContour.file": {
    about: "Fichier du contour, avec son extension.",
    mistakes: ["Le fichier est un programme entier avec des positionnements."],
  },
  "toolDefinition.tool": {
    about: "Numéro ou nom de l’outil défini.",
    mistakes: ["L’outil est aussi dans le tableau d’outils : le tableau s’applique."],
  },
  "toolDefinition.length": {
    about: "Longueur de l’outil depuis le point de référence.",
    mistakes: ["Longueur d’un autre porte-outil reprise."],
  },
  toolRadius: { about: "Rayon de l’outil, pour la correction des contours fraisés.", mistakes: ["Le ⌀ est saisi."] },
  "toolCall.speed": {
    about: "Vitesse de la broche de fraisage ou de perçage. En tournage, FUNCTION TURNDATA SPIN s’applique.",
    mistakes: ["Utilisée pour le tournage : sans effet."],
  },
  "toolCall.feed": {
    about: "Avance pour FAUTO et pour les séquences sans avance.",
    mistakes: ["Confondue avec l’avance d’un cycle, qui a une avance propre."],
  },
  deltaLength: {
    about: "Surépaisseur de longueur, ajoutée à celle du tableau.",
    mistakes: ["Utilisée pour des outils de tournage : utiliser CORR-TCS."],
  },
  deltaRadius: {
    about: "Surépaisseur de rayon : une valeur positive laisse une surépaisseur aux contours fraisés.",
    mistakes: ["Reprise de l’ébauche."],
  },
  mode: {
    about: "TURN pour tourner, MILL pour fraiser.",
    mistakes: ["MILL manque après le tournage : X reste un ⌀."],
  },
  kinematics: {
    about: "Nom de la cinématique de la machine, s’il y en a plusieurs.",
    mistakes: ["Nom d’une autre machine saisi."],
  },
  constantSurface: {
    about:
      "Marche : vitesse de coupe constante, la vitesse de rotation suit le ⌀. Arrêt : vitesse de rotation " +
      "constante.",
    mistakes: [
      "Marche pour un filetage : le pas n’est juste qu’à vitesse de rotation constante.",
      "Marche sans SMAX : vers l’axe, la vitesse est illimitée.",
    ],
  },
  "turnCorrection.system": {
    about: "TCS : le long de l’outil. WPL : le long de la pièce.",
    mistakes: ["WPL utilisé pour l’usure d’outil."],
  },
  "turnCorrection.plane": {
    about: "Plan de la correction : Z/X en tournage.",
    mistakes: ["X/Y repris du fraisage."],
  },
  DZL: {
    about: "Surépaisseur de longueur en Z : une valeur positive décale les faces vers +Z.",
    mistakes: ["Confondue avec une surépaisseur du contour."],
  },
  DXL: {
    about: "Surépaisseur de longueur en X, au rayon : le ⌀ change du double.",
    mistakes: ["La différence de ⌀ est saisie."],
  },
  X: {
    about:
      "X du point final : un ⌀ en tournage, une coordonnée en fraisage. Avec I : incrémental depuis la position " +
      "actuelle.",
    mistakes: ["Un rayon est saisi : la pièce devient deux fois trop mince.", "I reste actif : la valeur s’ajoute."],
  },
  Y: {
    about: "Y du point final. Vide en tournage.",
    mistakes: ["Repris du fraisage : sans effet en tournage."],
  },
  Z: {
    about: "Z du point final. Z0 est en général la face finie ; la pièce est du côté négatif.",
    mistakes: ["Le signe moins manque."],
  },
  axis: {
    about: "Axe machine supplémentaire : axes rotatifs en degrés, parallèles en mm. Non simulé.",
    mistakes: ["L’axe se déplace pendant que l’outil coupe."],
  },
  "CC.X": { about: "X du centre ou du pôle, un ⌀ en tournage.", mistakes: ["Un rayon est saisi."] },
  "CC.Y": { about: "Y du centre ou du pôle.", mistakes: ["Vide : la dernière valeur s’applique."] },
  "CC.Z": { about: "Z du centre ou du pôle.", mistakes: ["Le signe moins manque."] },
  "C.X": {
    about: "X du point final. Il doit être sur le cercle autour de CC.",
    mistakes: ["Valeur arrondie : le point n’est pas sur le cercle."],
  },
  "C.Z": {
    about: "Z du point final. Il doit être sur le cercle autour de CC.",
    mistakes: ["Valeur arrondie : le point n’est pas sur le cercle."],
  },
  "datum.X": {
    about: "Décalage du point zéro en X ; un ⌀ en tournage.",
    mistakes: ["Un rayon est saisi."],
  },
  "datum.Y": { about: "Décalage du point zéro en Y.", mistakes: ["Repris du fraisage."] },
  "datum.Z": {
    about: "Décalage du point zéro en Z : négatif vers le mandrin.",
    mistakes: ["Supposé relatif au décalage précédent : une nouvelle valeur remplace l’ancienne."],
  },
  polarRadius: {
    about: "Distance du pôle CC au point final, en mm, pas un ⌀.",
    mistakes: ["Le ⌀ du cercle est saisi."],
  },
  polarAngle: {
    about:
      "Direction depuis le pôle, mesurée depuis le premier axe du plan : en tournage, +Z. Avec I : depuis la " +
      "dernière direction.",
    mistakes: ["Mesuré depuis X en tournage.", "I manque dans une répétition : tout est au même endroit."],
  },
  radius: {
    about: "Rayon de l’arc. Positif : arc de moins de 180° ; négatif : le plus grand.",
    mistakes: ["DR inversé : un arc concave devient convexe."],
  },
  "RND.radius": {
    about: "Rayon de l’arrondi dans le coin.",
    mistakes: ["Inférieur au rayon de bec dans un coin intérieur : le rayon de bec reste."],
  },
  turn: {
    about: "Sens de rotation, vu sur le plan : DR- horaire, DR+ antihoraire.",
    mistakes: ["Vu de dessous l’axe : le sens est inversé."],
  },
  chamfer: {
    about: "Longueur le long de chacune des deux arêtes.",
    mistakes: ["Plus longue qu’une arête voisine."],
  },
  compensation: {
    about: "Position de l’outil par rapport au contour programmé : RL à gauche, RR à droite, R0 sur le contour.",
    mistakes: ["Activée dans la coupe au lieu de hors matière.", "R0 manque à la fin."],
  },
  feed: {
    about:
      "Avance de cette séquence et des suivantes. FMAX ne vaut que dans sa séquence, FAUTO reprend l’avance de " +
      "TOOL CALL.",
    mistakes: ["Avec M136, une avance par minute est saisie.", "FMAX est utilisé dans la coupe."],
  },
  functions: {
    about: "Plusieurs fonctions M, séparées par des espaces.",
    mistakes: ["M3 et M4 sont inversés : le dos de la plaquette frotte."],
  },
  retract: {
    about: "Distance de retrait dans l’axe d’outil ; MAX : jusqu’à la limite de course.",
    mistakes: ["Un obstacle est sur le trajet de retrait."],
  },
  length: { about: "Longueur de la droite.", mistakes: ["Une coordonnée est saisie à la place."] },
  centreAngle: { about: "Angle au centre de l’arc.", mistakes: ["L’angle du point final est saisi."] },
  free: {
    about: "Une valeur de cet élément d’après le dessin ; facultative.",
    mistakes: ["Trop peu de valeurs : plusieurs solutions."],
  },
  CLSD: { about: "Commence (+) et termine (−) un contour fermé.", mistakes: ["L’indicateur de fin manque."] },
  "undercut.form": {
    about: "La forme normalisée : E dans le cylindre, F dans cylindre et face, H, K, U, ou celle d’un filet.",
    mistakes: ["F alors que la face est déjà finie."],
  },
  "groove.form": {
    about: "RADIAL dans un cylindre, AXIAL dans une face.",
    mistakes: ["La forme ne convient pas à l’élément précédent."],
  },
  R: { about: "Rayon dans les coins du fond.", mistakes: ["Inférieur au rayon de bec."] },
  DEPTH: { about: "Profondeur dans la matière.", mistakes: ["Saisie comme ⌀."] },
  BREADTH: { about: "Largeur le long de l’élément.", mistakes: ["Plus étroite que la plaquette."] },
  ANGLE: { about: "Angle du flanc.", mistakes: ["Trop raide pour l’arête de la plaquette."] },
  "groove.DEPTH": {
    about: "Profondeur de la gorge ; le signe définit le côté de l’élément : négatif vers −X ou −Z.",
    mistakes: ["Saisie comme ⌀."],
  },
  "groove.ANGLE": {
    about: "Angle de chaque flanc par rapport à la perpendiculaire à l’élément, à la place de ANG_WIDTH.",
    mistakes: ["L’angle d’ouverture entre les deux flancs est saisi : utiliser ANG_WIDTH."],
  },
  ANG_WIDTH: {
    about: "Angle d’ouverture entre les deux flancs, à la place de ANGLE.",
    mistakes: ["L’angle d’un seul flanc est saisi : la gorge est deux fois moins ouverte."],
  },
  FACEDEPTH: {
    about: "Profondeur du dégagement dans la face.",
    mistakes: ["Omise : la valeur de la norme s’applique."],
  },
  FACEANGLE: { about: "Angle de sortie de la face.", mistakes: ["Mesuré depuis l’axe."] },
  ROT: {
    about: "Rotation du dégagement.",
    mistakes: ["45° est usuel ; un signe inversé le tourne dans la paroi."],
  },
  "rotation.ROT": {
    about: "Angle de rotation du plan, positif dans le sens antihoraire.",
    mistakes: ["Encore actif pour la forme suivante."],
  },
  PITCH: {
    about: "Pas du filetage : les cotes viennent du tableau.",
    mistakes: ["Le ⌀ du filet est saisi."],
  },
  CENTER: {
    about: "Centre de la gorge : Z sur un cylindre, ⌀ sur une face.",
    mistakes: ["Un bord de la gorge est saisi."],
  },
  DIAM: { about: "⌀ du fond, à la place de la profondeur.", mistakes: ["Profondeur et ⌀ sont saisis tous deux."] },
  RND: { about: "Rayon sur l’arête extérieure.", mistakes: ["RND et CHF sont saisis tous deux."] },
  CHF: { about: "Chanfrein sur l’arête extérieure.", mistakes: ["RND et CHF sont saisis tous deux."] },
  FAR_RND: {
    about: "Rayon sur l’arête extérieure éloignée, s’il diffère.",
    mistakes: ["Arête proche et éloignée sont inversées."],
  },
  FAR_CHF: {
    about: "Chanfrein sur l’arête extérieure éloignée, s’il diffère.",
    mistakes: ["Arête proche et éloignée sont inversées."],
  },
  label: { about: "Numéro ou nom du label.", mistakes: ["Le même numéro est utilisé deux fois."] },
  "call.label": {
    about: "Label à appeler.",
    mistakes: ["Label d’un contour appelé : il s’exécute comme trajectoire."],
  },
  repeat: {
    about: "Nombre de répétitions après la première exécution.",
    mistakes: ["Une de trop : la première exécution n’est pas comptée."],
  },
  "contour.cycleLine": {
    about: "Les labels du contour, séparés par /.",
    mistakes: ["Label de la pièce brute saisi."],
  },
  cycleLine: {
    about: "Contenu après le numéro de ligne.",
    mistakes: ["La valeur appartient à une autre ligne du cycle."],
  },
  how: {
    about: "À la position actuelle ; à des positions (POS) ; ou à chaque point d’un motif (PAT).",
    mistakes: ["PAT sans motif avant lui."],
  },
  SCL: { about: "Facteur d’échelle : 1 est la taille d’origine.", mistakes: ["Un pourcentage est saisi."] },
  target: { about: "Paramètre du résultat.", mistakes: ["Q100 à Q199 sont réservés à la commande."] },
  formula: {
    about: "Un nombre, un paramètre ou un calcul avec + − * / et des fonctions.",
    mistakes: ["Les angles sont en degrés : SIN 30 vaut 0.5."],
  },
  text: { about: "Contenu de la séquence en texte.", mistakes: ["Un point-virgule commence un commentaire."] },
  parameter: {
    about: "Une valeur d’un cycle conservé, mais non simulé. Voir le manuel de la commande.",
    mistakes: ["Modifiée en supposant que la simulation suit."],
  },
});
