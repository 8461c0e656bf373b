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
    text: "La matière avant la première passe. BLK FORM la décrit ; ici un cylindre, un tube ou un profil.",
    also: "brut",
  },
  stock: {
    name: "Matière en place",
    text: "La matière à un moment donné : ce que les passes ont laissé du brut jusqu’ici.",
  },
  finishedPart: { name: "Pièce finie", text: "Ce qui doit rester. Aucune passe ne doit y toucher." },
  residue: {
    name: "Matière résiduelle",
    text: "Matière qui reste au-delà du contour parce que la plaquette n’y arrive pas : dans les angles, derrière les flancs, aux limites.",
  },
  contour: {
    name: "Contour",
    text: "La suite de droites et d’arcs que suit la surface finie, dans le sens d’usinage.",
  },
  cornerElement: {
    name: "Chanfrein, arrondi",
    text: "Ce qui casse un angle entre deux éléments, ou l’arête au début ou à la fin d’un épaulement.",
  },
  shoulder: { name: "Épaulement", text: "Un cylindre et une face qui se rejoignent dans un angle rentrant." },
  face: { name: "Face", text: "Une surface perpendiculaire à l’axe. Elle se dresse en X." },
  recess: {
    name: "Gorge",
    text: "Un fond entre deux parois. Le tournage de gorge coupe latéralement, le plongement par plongées côte à côte.",
  },
  undercut: {
    name: "Dégagement",
    text: "Un creux sous la cote finie dans l’angle devant une face, pour laisser place à la pièce opposée ou à la meule.",
  },
  thread: {
    name: "Filetage",
    text: "Une rainure en hélice. L’avance est liée à la rotation de la broche, pour que chaque passe retombe dans la même rainure.",
    also: "filet",
  },
  pitch: {
    name: "Pas",
    text: "D’une rainure à la suivante. Avec plusieurs filets, le chemin par tour vaut autant de pas.",
    // Mostly half of "not".
    where: "(?<=(?:le|du|un|au|Le|Du|Un|Au) )",
  },
  runIn: { name: "Course d’approche du filet", text: "Chemin devant le filet où l’axe atteint sa vitesse." },
  oversize: { name: "Surépaisseur", text: "Ce que l’ébauche laisse à la finition : Q483 au diamètre, Q484 selon Z." },
  workpieceZero: {
    name: "Origine pièce",
    text: "Où se trouvent X0 et Z0. X0 est l’axe de la broche ; Z0 est le plus souvent sur la face finie, la pièce du côté négatif.",
  },
  diameter: { name: "Diamètre (⌀)", text: "X s’écrit au diamètre. 2 mm en X déplacent l’outil de 1 mm." },
  radius: {
    name: "Au rayon (r)",
    text: "Les profondeurs perpendiculaires à l’axe comptent d’un seul côté : 3 mm font 6 mm au diamètre.",
  },
  theoreticalTip: {
    name: "Pointe théorique",
    text:
      "L’angle qu’aurait la plaquette sans rayon de bec. La commande affiche et programme la position de ce " +
      "point, bien qu’il n’y ait là pas de matière.",
  },
  cuttingPoint: {
    name: "Point de coupe",
    text: "Où le bec touche la pièce. Sur un cylindre ou une face, il est au niveau de la pointe théorique ; sur un cône ou un arc, non.",
  },
  tipOrientation: {
    name: "Orientation de l’outil (TO)",
    text: "Où la pointe théorique se trouve à côté du bec, de 1 à 9. La commande sait ainsi de quel côté la plaquette coupe.",
  },
  noseRadius: {
    name: "Rayon de bec (RS)",
    text: "L’arrondi du coin coupant. Il laisse son propre rayon dans les angles rentrants vifs et forme les stries d’avance.",
  },
  compensation: {
    name: "Correction du rayon de bec",
    text: "La commande guide le bec pour que son arc touche le contour, et non la pointe théorique. Sans elle, cônes et arcs sont faux.",
  },
  insert: {
    name: "Plaquette",
    text: "La plaquette amovible qui coupe, avec sa forme, ses angles et son rayon de bec.",
  },
  mainEdge: {
    name: "Arête principale",
    text: "L’arête à côté du bec qui coupe le plus. Elle ne peut suivre une paroi plus inclinée qu’elle.",
  },
  secondaryEdge: {
    name: "Arête secondaire",
    text: "L’arête derrière le bec. Sur les flancs descendants elle doit rester dégagée de la pièce.",
  },
  edgeLength: {
    name: "Longueur d’arête (CUTLENGTH)",
    text: "Ce qui de l’arête peut couper. Une passe plus profonde travaille avec le porte-outil. D’un outil à fileter : la hauteur de la dent.",
  },
  holder: { name: "Porte-outil", text: "Ce qui porte la plaquette. Il ne doit toucher ni la pièce ni le mandrin." },
  pass: {
    name: "Passe",
    text: "Une coupe d’ébauche à une profondeur, de la prise de passe au retrait.",
    // A verb as well.
    where: "(?:(?=passes)|(?<=^|(?:la|une|aucune|chaque|cette|de|par|sans|longue|seule|même|[ei]ère|ième) ))",
  },
  infeed: {
    name: "Valeur de passe",
    text: "De combien une passe est plus profonde que la précédente. Q463 est le maximum ; la profondeur est divisée également.",
  },
  roughing: {
    name: "Ébauche",
    text: "Enlever l’essentiel de la matière en peu de passes profondes, jusqu’à la surépaisseur.",
  },
  finishing: {
    name: "Finition",
    text: "Une passe le long du contour à la cote, avec peu de copeau et une petite avance.",
  },
  setupClearance: {
    name: "Distance d’approche (Q460)",
    text: "La distance que le cycle garde quand il se prépositionne en rapide, et dont il se retire avant de revenir en rapide.",
  },
  startPoint: {
    name: "Point de départ",
    text: "Où se trouve la pointe à l’appel du cycle : dans l’air. Le cycle compte la profondeur à partir de là et y revient.",
  },
  rapid: { name: "Rapide", text: "Le déplacement le plus rapide des axes. Il ne doit jamais toucher la matière." },
  feedPerTurn: {
    name: "Avance par tour (M136)",
    text: "Le chemin de l’outil en un tour de broche. Épaisseur du copeau et surface ne dépendent alors plus de la vitesse.",
  },
  cuttingSpeed: {
    name: "Vitesse de coupe",
    text: "La vitesse à laquelle la surface passe devant l’arête, m/min : π · ⌀ · n / 1000. VCONST la maintient quand le diamètre change.",
  },
  speedLimit: {
    name: "Limitation de vitesse (SMAX)",
    text:
      "La vitesse la plus haute que la commande peut choisir. Près de l’axe, VCONST la voudrait infinie : " +
      "mandrin et pièce fixent la borne.",
  },
  chip: {
    name: "Copeau",
    text: "Ce qui est enlevé : profondeur fois avance donne sa section, force et puissance croissent avec elle.",
  },
  cuttingForce: {
    name: "Force spécifique de coupe (kc)",
    text: "La force par mm² de copeau. Les copeaux minces en demandent plus que les épais.",
  },
  roughness: {
    name: "Rugosité (Rz)",
    text: "Hauteur des stries d’avance. Le bec seul laisse environ f² / (8 · r) : moitié d’avance, quart de hauteur.",
  },
  gouge: {
    name: "Collision avec le contour",
    text: "Pièce finie qu’un déplacement a enlevée. On ne peut pas la remettre.",
  },
  airPass: { name: "Passe à vide", text: "Une passe qui ne touche aucune matière." },
  plunging: {
    name: "Plongée",
    text: "Couper dans la matière le long d’un flanc descendant ou tout droit. Q487 l’autorise, Q488 lui donne sa propre avance.",
    // What "est plongée" is no plunging.
    where: "(?<!(?:est|sont|être) )",
  },
  limit: {
    name: "Limite d’usinage",
    text: "Un diamètre (Q480) ou une position en Z (Q482) au-delà de laquelle le cycle ne coupe pas.",
  },
  program: { name: "Programme", text: "Ce que la commande exécute : des séquences, l’une après l’autre." },
  block: {
    name: "Séquence",
    text: "Une ligne numérotée d’un programme, ou plusieurs qui vont ensemble, comme un cycle avec ses paramètres.",
  },
  cycle: {
    name: "Cycle",
    text: "Un usinage que la commande connaît : de quelques valeurs elle déduit toutes ses passes.",
  },
  call: {
    name: "Appel de cycle",
    text: "M99, M89 ou CYCL CALL. Ce n’est qu’ici que le cycle défini déplace l’outil, avec l’outil et le point de départ du moment.",
  },
  verdict: {
    name: "Verdict",
    text: "Ce que donne la preuve d’un programme : prouvé, défauts trouvés, ou simulation incomplète.",
  },
});
