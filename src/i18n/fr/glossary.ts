import type { GlossaryTexts } from "../glossary-text.ts";
import { typeset } from "./typography/typeset.ts";

export const glossary: GlossaryTexts = typeset({
  words: {
    formsOf: (name) =>
      name
        .split(" ")
        .map((word) => `${word}(?:e?s|x)?`)
        .join(" "),
    capitals: false,
    apart: true,
  },
  blank: {
    name: "Pièce brute",
    text: "La matière avant la première passe, définie par BLK FORM : cylindre, tube ou profil.",
    also: "brut",
  },
  stock: {
    name: "Matière en place",
    text: "La matière actuelle : la pièce brute moins toutes les passes précédentes.",
  },
  finishedPart: {
    name: "Pièce finie",
    text: "La pièce après toutes les passes, comme sur le dessin. Aucune passe ne doit l’endommager.",
  },
  residue: {
    name: "Matière résiduelle",
    text:
      "Matière qui reste sur le contour parce que la plaquette n’y accède pas : dans les coins, derrière les " +
      "flancs, aux limites.",
  },
  contour: {
    name: "Contour",
    text: "La suite de droites et d’arcs que suit la surface finie, dans le sens d’usinage.",
  },
  cornerElement: {
    name: "Chanfrein, arrondi",
    text: "Élément qui casse un coin entre deux éléments, ou l’arête au départ ou à la fin d’un épaulement.",
    // Not the nose, nor a rounded number or corner.
    where: "(?:(?=chanfrein)|(?<=^|(?:un|ou|et|des) ))",
  },
  shoulder: { name: "Épaulement", text: "Un cylindre et une face qui se rejoignent dans un coin intérieur." },
  face: {
    name: "Face",
    text: "Une surface perpendiculaire à l’axe, tournée par un mouvement en X.",
    // Not “face à”.
    where: String.raw`(?!face (?:à|au|aux)\s)`,
  },
  recess: {
    name: "Gorge",
    text:
      "Un fond entre deux parois. Le tournage de gorge usine latéralement, l’usinage de gorge par plongées côte à " +
      "côte.",
  },
  undercut: {
    name: "Dégagement",
    text: "Un creux sous la cote finie dans le coin devant une face, pour dégager la pièce opposée ou la meule.",
    // Usually a retraction.
    where: "(?<!, )(?!dégagement en )",
  },
  thread: {
    name: "Filetage",
    text:
      "Une rainure en hélice. L’avance est synchronisée avec la broche, pour que chaque passe suive la même " +
      "rainure.",
    also: "filet",
  },
  pitch: {
    name: "Pas",
    text:
      "Distance d’une rainure à la suivante. Avec plusieurs filets, la course par tour est le pas multiplié par le " +
      "nombre de filets.",
    // Usually part of a negation.
    where: String.raw`(?<=(?<!\p{L})(?:le|du|un|au) )`,
  },
  runIn: {
    name: "Course d’engagement",
    text: "Course devant le filetage sur laquelle l’axe accélère jusqu’à l’avance.",
    also: "engagement",
  },
  oversize: {
    name: "Surépaisseur",
    text: "Matière laissée par l’ébauche pour la finition : Q483 au diamètre, Q484 en Z.",
    // Not the material in front of the face.
    where: "(?!surépaisseur à dresser)",
  },
  workpieceZero: {
    name: "Origine pièce",
    text:
      "Position de X0 et Z0. X0 est l’axe de la broche ; Z0 est le plus souvent sur la face finie, la pièce du " +
      "côté négatif.",
  },
  diameter: { name: "Diamètre (⌀)", text: "X est programmé au diamètre. 2 mm en X déplacent l’outil de 1 mm." },
  radius: {
    name: "Au rayon (r)",
    text: "Les profondeurs perpendiculaires à l’axe sont par côté : 3 mm font 6 mm au diamètre.",
  },
  theoreticalTip: {
    name: "Pointe théorique",
    text:
      "Le coin de la plaquette sans rayon de bec. La commande affiche et programme la position de ce " +
      "point, bien qu’il n’y ait là pas de matière.",
  },
  cuttingPoint: {
    name: "Point de coupe",
    text:
      "Point où le bec touche la pièce. Sur un cylindre ou une face, il est au niveau de la pointe théorique ; sur " +
      "un cône ou un arc, non.",
  },
  tipOrientation: {
    name: "Orientation de l’outil (TO)",
    text: "Position de la pointe théorique par rapport au bec, de 1 à 9. Elle définit de quel côté la plaquette coupe.",
  },
  noseRadius: {
    name: "Rayon de bec (RS)",
    text: "L’arrondi du coin coupant. Il reste dans les coins intérieurs vifs et détermine les stries d’avance.",
  },
  compensation: {
    name: "Correction du rayon de bec",
    text:
      "La commande guide le bec, et non la pointe théorique, le long du contour. Sans correction, cônes et arcs " +
      "sont faux.",
  },
  insert: {
    name: "Plaquette",
    text: "La plaquette amovible qui coupe, avec sa forme, ses angles et son rayon de bec.",
  },
  mainEdge: {
    name: "Arête de coupe principale",
    also: "arête principale",
    text: "L’arête à côté du bec qui coupe le plus. Elle ne peut pas suivre une paroi plus raide.",
  },
  secondaryEdge: {
    name: "Arête de coupe secondaire",
    also: "arête secondaire",
    text: "L’arête derrière le bec. Sur les flancs descendants elle doit rester dégagée de la pièce.",
  },
  edgeLength: {
    name: "Longueur d’arête (CUTLENGTH)",
    text:
      "Longueur utile de l’arête. Dans une passe plus profonde, le porte-outil frotte. Pour un outil à fileter : " +
      "la hauteur de la dent.",
  },
  holder: {
    name: "Porte-outil",
    text: "Corps d’outil qui porte la plaquette. Il ne doit toucher ni la pièce ni le mandrin.",
  },
  pass: {
    name: "Passe",
    text: "Une coupe d’ébauche à une profondeur, de la prise de passe au retrait.",
    // Also a verb.
    where: "(?:(?=passes)|(?<=^|(?:la|une|aucune|chaque|cette|de|par|sans|longue|seule|même|[ei]ère|ième) ))",
  },
  infeed: {
    name: "Valeur de passe",
    text:
      "Profondeur d’une passe par rapport à la précédente. Q463 est le maximum ; la profondeur est répartie " +
      "uniformément.",
  },
  roughing: {
    name: "Ébauche",
    text: "Enlever l’essentiel de la matière en peu de passes profondes, jusqu’à la surépaisseur.",
    // Also a verb.
    where: String.raw`(?<!T\d+ )`,
  },
  finishing: {
    name: "Finition",
    text: "Une passe le long du contour à la cote finie, avec une faible profondeur et une petite avance.",
  },
  setupClearance: {
    name: "Distance d’approche (Q460)",
    text: "Distance à la matière pour le prépositionnement, et distance de retrait avant le retour en avance rapide.",
  },
  startPoint: {
    name: "Point de départ",
    text: "Position de la pointe d’outil à l’appel du cycle, hors de la matière. Le cycle y commence et y finit.",
  },
  rapid: {
    name: "Avance rapide",
    text: "Le déplacement le plus rapide des axes. Il ne doit jamais toucher la matière.",
  },
  feedPerTurn: {
    name: "Avance par tour (M136)",
    text:
      "La course de l’outil par tour de broche. Épaisseur du copeau et état de surface sont alors indépendants de " +
      "la vitesse.",
  },
  cuttingSpeed: {
    name: "Vitesse de coupe",
    text:
      "Vitesse de la surface devant l’arête, m/min : π · ⌀ · n / 1000. VCONST la maintient constante quand le " +
      "diamètre change.",
  },
  speedLimit: {
    name: "Limitation de vitesse (SMAX)",
    text:
      "La vitesse maximale de la broche. Près de l’axe, VCONST exigerait une vitesse infinie : mandrin et pièce " +
      "fixent la limite.",
  },
  chip: {
    name: "Copeau",
    text: "La matière enlevée. Sa section est profondeur fois avance ; force et puissance croissent avec la section.",
  },
  cuttingForce: {
    name: "Force spécifique de coupe (kc)",
    text: "Force par mm² de section de copeau. Elle est plus grande pour les copeaux minces.",
  },
  roughness: {
    name: "Rugosité (Rz)",
    text: "Hauteur des stries d’avance. Le rayon de bec donne environ f² / (8 · r) : moitié d’avance, quart de hauteur.",
  },
  gouge: {
    name: "Violation de contour",
    text: "Une coupe dans la pièce finie. Elle est irréparable.",
  },
  airPass: { name: "Passe à vide", text: "Une passe qui ne touche aucune matière." },
  plunging: {
    name: "Plongée",
    text:
      "Usiner dans la matière le long d’un flanc descendant ou tout droit. Q487 autorise la plongée, Q488 est " +
      "l’avance de plongée.",
    // "est plongée" is no plunging.
    where: "(?<!(?:est|sont|être) )",
  },
  limit: {
    name: "Limite d’usinage",
    text: "Un diamètre (Q480) ou une position en Z (Q482) au-delà de laquelle le cycle n’usine pas le contour.",
  },
  program: { name: "Programme", text: "Les séquences que la commande exécute l’une après l’autre." },
  block: {
    name: "Séquence",
    text: "Une ligne numérotée d’un programme, ou plusieurs qui vont ensemble, comme un cycle avec ses paramètres.",
  },
  cycle: {
    name: "Cycle",
    text: "Une opération d’usinage de la commande : quelques valeurs définissent toutes les passes.",
  },
  call: {
    name: "Appel de cycle",
    text: "M99, M89 ou CYCL CALL. Seul l’appel exécute le cycle défini, avec l’outil et le point de départ actuels.",
  },
  verdict: {
    name: "Résultat de la vérification",
    text: "Résultat de la vérification du programme : vérifié, erreurs trouvées ou simulation incomplète.",
  },
});
