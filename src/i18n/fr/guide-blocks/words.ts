import { typeset } from "../typography/typeset.ts";

/** What each word of a block does, by its field, and what is often done wrong with it. */
export const blockWords = typeset({
  name: {
    about: "Comment s’appelle le programme.",
    mistakes: ["Il contient des espaces ou des accents : certaines commandes refusent le fichier."],
  },
  unit: {
    about: "MM ou INCH pour toutes les longueurs et avances du programme.",
    mistakes: ["Des valeurs sont copiées entre programmes d’unités différentes."],
  },
  toolAxis: {
    about: "L’axe dans lequel se tient l’outil. Pour les pièces tournées, c’est Z.",
    mistakes: ["X ou Y est resté d’un programme de fraisage."],
  },
  "blankBox.X": {
    about: "X de ce coin. Autour de l’axe, le coin le plus éloigné décide.",
    mistakes: ["Le ⌀ est saisi ; un pavé compte depuis l’axe."],
  },
  "blankBox.Y": {
    about: "Y de ce coin. Autour de l’axe, le coin le plus éloigné décide.",
    mistakes: ["Le pavé est à côté de l’axe."],
  },
  "blankBox.Z": {
    about: "Z de ce coin : 0.1 l’arrière, 0.2 la face.",
    mistakes: ["La face finit à Z0 alors qu’elle est encore brute."],
  },
  outsideMeasure: {
    about: "Si l’extérieur est donné en ⌀ (D) ou en rayon (R).",
    mistakes: ["R est resté et un ⌀ est saisi : le brut est deux fois trop gros."],
  },
  insideMeasure: {
    about: "Si l’alésage est donné en ⌀ (DI) ou en rayon (RI).",
    mistakes: ["RI est resté et un ⌀ est saisi."],
  },
  measure: {
    about: "Si X du profil compte en ⌀ (DIM_D) ou en rayon (DIM_R).",
    mistakes: ["Le profil est tracé en rayons et DIM_D est là : le brut est deux fois trop mince."],
  },
  blankSource: {
    about: "Si le profil se trouve derrière un label de ce programme ou dans un fichier.",
    mistakes: ["Le fichier n’est pas à côté du programme."],
  },
  "blankRotation.label": {
    about: "Label du profil de la pièce brute.",
    mistakes: ["C’est le label du contour fini : il ne reste rien à couper."],
  },
  "turnBlank.label": {
    about: "Label du profil fermé de ce qui est dans le mandrin.",
    mistakes: ["Le profil est celui de la pièce finie."],
  },
  file: {
    about: "Fichier du profil, avec son extension, ou un paramètre QS qui contient son nom.",
    mistakes: ["Le chemin d’une autre machine le précède."],
  },
  "selectContour.file": {
    about: "Fichier du contour, avec son extension.",
    mistakes: ["Il contient un programme entier avec des positionnements."],
  },
  "toolDefinition.tool": {
    about: "Numéro ou nom de l’outil décrit.",
    mistakes: ["Il est aussi dans le tableau d’outils : c’est lui qui vaut."],
  },
  "toolDefinition.length": {
    about: "Longueur de l’outil depuis le point de référence.",
    mistakes: ["La longueur d’un autre porte-outil est restée."],
  },
  toolRadius: { about: "Rayon de l’outil, pour la correction des contours fraisés.", mistakes: ["Le ⌀ est saisi."] },
  "toolCall.speed": {
    about: "Tours d’une broche de fraisage ou de perçage. En tournage, FUNCTION TURNDATA SPIN décide.",
    mistakes: ["Elle est pensée pour la pièce tournée : là elle ne fait rien."],
  },
  "toolCall.feed": {
    about: "Avance pour FAUTO et pour les séquences sans avance propre.",
    mistakes: ["Elle est prise pour l’avance d’un cycle, qui a la sienne."],
  },
  deltaLength: {
    about: "Surépaisseur de longueur, ajoutée à celle du tableau.",
    mistakes: ["Elle sert pour des outils de tournage : là, c’est CORR-TCS."],
  },
  deltaRadius: {
    about: "Surépaisseur de rayon : plus laisse de la matière aux contours fraisés.",
    mistakes: ["Elle est restée de l’ébauche."],
  },
  mode: {
    about: "TURN pour tourner, MILL pour fraiser.",
    mistakes: ["MILL est oublié après le tournage : X reste un ⌀."],
  },
  kinematics: {
    about: "Nom d’une cinématique de la machine, si elle en a plusieurs.",
    mistakes: ["Le nom d’une autre machine s’y trouve."],
  },
  constantSurface: {
    about: "Marche : la vitesse de coupe est tenue et les tours suivent le ⌀. Arrêt : les tours sont tenus.",
    mistakes: [
      "Marche pour un filet : le pas n’est juste qu’à vitesse fixe.",
      "Marche sans SMAX : vers l’axe, la broche s’emballe.",
    ],
  },
  "turnCorrection.system": {
    about: "TCS : le long de l’outil. WPL : le long de la pièce.",
    mistakes: ["WPL est choisi pour une usure de l’outil."],
  },
  "turnCorrection.plane": {
    about: "Le plan où compte la correction : Z/X en tournage.",
    mistakes: ["X/Y est resté du fraisage."],
  },
  DZL: {
    about: "L’outil compte plus long d’autant en Z : les faces vont vers +Z.",
    mistakes: ["Elle est prise pour une surépaisseur du contour."],
  },
  DXL: {
    about: "L’outil compte plus long d’autant en X, au rayon : le ⌀ change du double.",
    mistakes: ["La différence de ⌀ est saisie."],
  },
  X: {
    about: "X du point final : un ⌀ en tournage, une coordonnée en fraisage. Avec I il compte d’où se trouve l’outil.",
    mistakes: ["Un rayon est saisi : la pièce devient deux fois trop mince.", "I reste : la valeur s’ajoute."],
  },
  Y: {
    about: "Y du point final. En tournage il reste vide.",
    mistakes: ["Il est resté du fraisage : en tournage il ne fait rien."],
  },
  Z: {
    about: "Z du point final. Z0 est en général la face finie ; la pièce est du côté moins.",
    mistakes: ["Le signe moins manque."],
  },
  axis: {
    about: "Un autre axe de la machine : rotatif en degrés, parallèle en mm. Il n’est pas simulé.",
    mistakes: ["Il tourne pendant que l’outil coupe."],
  },
  "CC.X": { about: "X du centre ou du pôle, un ⌀ en tournage.", mistakes: ["Un rayon est saisi."] },
  "CC.Y": { about: "Y du centre ou du pôle.", mistakes: ["Il reste vide : le dernier vaut."] },
  "CC.Z": { about: "Z du centre ou du pôle.", mistakes: ["Le signe moins manque."] },
  "C.X": {
    about: "X du point final. Il doit être sur le cercle autour de CC.",
    mistakes: ["Il est arrondi : la commande ne trouve pas de cercle."],
  },
  "C.Z": {
    about: "Z du point final. Il doit être sur le cercle autour de CC.",
    mistakes: ["Il est arrondi : la commande ne trouve pas de cercle."],
  },
  "datum.X": {
    about: "De combien le point zéro se déplace en X ; un ⌀ en tournage.",
    mistakes: ["C’était la moitié qu’il fallait."],
  },
  "datum.Y": { about: "De combien le point zéro se déplace en Y.", mistakes: ["Il est resté du fraisage."] },
  "datum.Z": {
    about: "De combien le point zéro se déplace en Z : moins va vers le mandrin.",
    mistakes: ["On le compte depuis le décalage précédent : une nouvelle valeur remplace l’ancienne."],
  },
  polarRadius: {
    about: "Distance du pôle CC au point final, en mm, pas un ⌀.",
    mistakes: ["Le ⌀ du cercle est saisi."],
  },
  polarAngle: {
    about:
      "Direction depuis le pôle, comptée du premier axe du plan : en tournage de +Z. Avec I, de la dernière direction.",
    mistakes: ["Il est compté de X en tournage.", "I manque dans une répétition : tout est au même endroit."],
  },
  radius: {
    about: "Rayon de l’arc. Plus prend l’arc de moins de 180°, moins le plus grand.",
    mistakes: ["DR est inversé : le creux devient une bosse."],
  },
  "RND.radius": {
    about: "Rayon de l’arrondi dans le coin.",
    mistakes: ["Il est plus petit que le rayon de bec dans un coin intérieur : le bec reste."],
  },
  turn: {
    about: "Le sens de l’arc, vu sur le plan : DR- horaire, DR+ antihoraire.",
    mistakes: ["Il est lu de dessous l’axe : là il est inversé."],
  },
  chamfer: {
    about: "Longueur le long de chacune des deux arêtes.",
    mistakes: ["Elle est plus longue qu’une arête voisine."],
  },
  compensation: {
    about: "Où passe l’outil par rapport au contour : RL à gauche, RR à droite, R0 dessus.",
    mistakes: ["Elle est activée dans la coupe et non dans l’air.", "R0 manque à la fin."],
  },
  feed: {
    about:
      "Avance de cette séquence et des suivantes. FMAX ne vaut que dans sa séquence, FAUTO prend celle de TOOL CALL.",
    mistakes: ["Avec M136, une avance par minute est saisie.", "FMAX est là où l’outil coupe."],
  },
  functions: {
    about: "Plusieurs fonctions M, séparées par des espaces.",
    mistakes: ["M3 et M4 sont inversés : la plaquette frotte du dos."],
  },
  retract: {
    about: "De combien l’outil recule dans son axe ; MAX jusqu’au bout de la course.",
    mistakes: ["Quelque chose est sur le chemin du retour."],
  },
  length: { about: "Longueur de la droite.", mistakes: ["La coordonnée est saisie à sa place."] },
  centreAngle: { about: "De combien l’arc tourne.", mistakes: ["L’angle du point final est saisi."] },
  free: {
    about: "Une valeur que le dessin donne de cet élément ; chacune peut manquer.",
    mistakes: ["Trop peu est donné : il y a plusieurs solutions."],
  },
  CLSD: { about: "Commence (+) et termine (−) un contour fermé.", mistakes: ["La fin n’est pas marquée."] },
  "undercut.form": {
    about: "La forme normalisée : E dans le cylindre, F dans cylindre et face, H, K, U, ou celle d’un filet.",
    mistakes: ["F alors que la face est déjà finie."],
  },
  "groove.form": {
    about: "RADIAL dans un cylindre, AXIAL dans une face.",
    mistakes: ["La forme ne convient pas à l’élément précédent."],
  },
  R: { about: "Rayon dans les coins du fond.", mistakes: ["Il est plus petit que le rayon de bec."] },
  DEPTH: { about: "De combien il entre dans la matière.", mistakes: ["Elle est saisie comme ⌀."] },
  BREADTH: { about: "Sa largeur le long de son élément.", mistakes: ["Elle est plus étroite que la plaquette."] },
  ANGLE: { about: "La pente du flanc.", mistakes: ["Il est plus raide que l’arête de la plaquette ne peut suivre."] },
  "groove.DEPTH": {
    about:
      "Profondeur de la gorge ; le signe indique de quel côté de l’élément elle se trouve : négatif vers −X ou −Z.",
    mistakes: ["Elle est saisie comme ⌀."],
  },
  "groove.ANGLE": {
    about: "Angle de chaque flanc par rapport à la perpendiculaire à l’élément, à la place de ANG_WIDTH.",
    mistakes: ["L’angle d’ouverture entre les deux flancs est saisi : c’est ANG_WIDTH."],
  },
  ANG_WIDTH: {
    about: "Angle d’ouverture entre les deux flancs, à la place de ANGLE.",
    mistakes: ["L’angle d’un seul flanc est saisi : la gorge s’ouvre alors deux fois moins."],
  },
  FACEDEPTH: {
    about: "De combien le dégagement entre dans la face.",
    mistakes: ["Elle manque et la valeur de la norme vaut."],
  },
  FACEANGLE: { about: "Sa pente à la sortie de la face.", mistakes: ["Il est mesuré depuis l’axe."] },
  ROT: {
    about: "De combien le dégagement est tourné.",
    mistakes: ["45° est usuel ; le signe le tourne dans la paroi."],
  },
  "rotation.ROT": {
    about: "Angle dont tourne le plan, positif dans le sens antihoraire.",
    mistakes: ["Il est encore actif pour la forme suivante."],
  },
  PITCH: {
    about: "Pas du filet auquel appartient le dégagement : le tableau en donne les cotes.",
    mistakes: ["Le ⌀ du filet est saisi."],
  },
  CENTER: {
    about: "Où est le milieu de la gorge : Z sur un cylindre, ⌀ sur une face.",
    mistakes: ["Un bord de la gorge est saisi."],
  },
  DIAM: { about: "⌀ du fond, à la place de la profondeur.", mistakes: ["Profondeur et ⌀ sont donnés tous deux."] },
  RND: { about: "Rayon sur l’arête extérieure.", mistakes: ["RND et CHF sont donnés tous deux."] },
  CHF: { about: "Chanfrein sur l’arête extérieure.", mistakes: ["RND et CHF sont donnés tous deux."] },
  FAR_RND: {
    about: "Rayon sur l’arête extérieure éloignée, s’il diffère.",
    mistakes: ["Arête proche et éloignée sont inversées."],
  },
  FAR_CHF: {
    about: "Chanfrein sur l’arête extérieure éloignée, s’il diffère.",
    mistakes: ["Arête proche et éloignée sont inversées."],
  },
  label: { about: "Numéro ou nom de l’endroit.", mistakes: ["Le même numéro est là deux fois."] },
  "call.label": {
    about: "Quel label est appelé.",
    mistakes: ["C’est le label d’un contour : il s’exécute comme trajectoire."],
  },
  repeat: {
    about: "Combien de fois la partie est répétée, après la première.",
    mistakes: ["Il y en a une de trop : la première exécution ne compte pas."],
  },
  "contour.cycleLine": {
    about: "Les labels du contour, séparés par /.",
    mistakes: ["Le label de la pièce brute s’y trouve."],
  },
  cycleLine: { about: "Ce qui suit le numéro de la ligne.", mistakes: ["Cela appartient à une autre ligne du cycle."] },
  how: {
    about: "Ici ; à des positions (POS) ; ou à chaque point d’un motif (PAT).",
    mistakes: ["PAT sans motif avant lui."],
  },
  SCL: { about: "Facteur : 1 est la même taille.", mistakes: ["Un pourcentage est saisi."] },
  target: { about: "Le paramètre qui reçoit la valeur.", mistakes: ["Q100 à Q199 appartiennent à la commande."] },
  formula: {
    about: "Un nombre, un paramètre ou un calcul avec + − * / et des fonctions.",
    mistakes: ["Les angles sont en degrés : SIN 30 vaut 0.5."],
  },
  text: { about: "Ce qui est dans la séquence, en texte.", mistakes: ["Un point-virgule commence un commentaire."] },
  parameter: {
    about: "Une valeur d’un cycle conservé ici. Son sens est dans le manuel de la commande.",
    mistakes: ["On la change en croyant que l’image suit."],
  },
});
