import type { ParamsTexts } from "../../param-text.ts";
import { turning } from "./params/turning.ts";
import { recessing } from "./params/recessing.ts";
import { threads } from "./params/threads.ts";
import { special } from "./params/special.ts";

const printed = true;
const element = { 0: "aucun élément", 1: "chanfrein", 2: "rayon" };

export const params = {
  operation: {
    prompt: "Opération d'usinage (0/1/2/3)?",
    printed,
    label: "Opération",
    explanation: "Ce que fait le cycle : ébauche, finition ou les deux.",
    choices: {
      0: "ébauche et finition",
      1: "ébauche seule",
      2: "finition seule, à la cote finie",
      3: "finition seule, à la surépaisseur",
    },
  },
  clearance: {
    prompt: "Distance d'approche?",
    printed,
    label: "Distance d’approche",
    explanation: "Distance à la matière pour le prépositionnement et le retrait.",
  },
  clearanceReserved: {
    prompt: "Distance d'approche?",
    printed,
    label: "Distance d’approche (réservé)",
    explanation: "Réservé : dans ce cycle, la valeur n’a aucune fonction. Les dégagements utilisent une distance fixe.",
  },
  startDiameter: {
    prompt: "Diamètre de départ du contour?",
    printed,
    label: "⌀ départ",
    explanation:
      "X du départ du contour, au diamètre. Supérieur à Q493 : usinage extérieur. Inférieur à Q493 : usinage " +
      "intérieur.",
  },
  startZ: {
    prompt: "Départ de contour Z?",
    printed,
    label: "Z départ",
    explanation: "Z du départ du contour.",
  },
  endDiameter: {
    prompt: "Diamètre fin de contour?",
    printed,
    label: "⌀ fin",
    explanation:
      "X de la fin du contour, au diamètre. Avec le diamètre de départ, il décide entre usinage extérieur et " +
      "intérieur.",
  },
  endZ: {
    prompt: "Fin de contour Z?",
    printed,
    label: "Z fin",
    explanation: "Z de la fin du contour.",
  },
  surfaceAngle: {
    prompt: "Angle de surface du pourtour?",
    printed,
    label: "Angle du pourtour",
    explanation:
      "Angle entre la surface périphérique et l’axe rotatif ; 0 donne un cylindre. La surface est inclinée vers " +
      "la zone à usiner, jamais en dessous.",
  },
  flankAngle: {
    prompt: "Angle du flanc?",
    printed,
    label: "Angle du flanc",
    explanation:
      "Angle entre le flanc au départ du contour et la parallèle à l’axe rotatif. La gorge se resserre vers le fond.",
  },
  faceAngle: {
    prompt: "Angle face transversale?",
    printed,
    label: "Angle de la face",
    explanation:
      "Inclinaison de la face transversale ; 0 est perpendiculaire à l’axe rotatif. La face est inclinée vers la " +
      "zone à usiner.",
  },
  secondFlankAngle: {
    prompt: "Angle du deuxième flanc?",
    printed,
    label: "Angle du 2e flanc",
    explanation: "Angle entre le flanc en fin de contour et la parallèle à l’axe rotatif.",
  },
  startElement: {
    prompt: "Type élément de départ (0/1/2)?",
    printed,
    label: "Élément de départ",
    explanation: "Élément sur l’arête au départ du contour.",
    choices: element,
  },
  startElementSize: {
    prompt: "Taille de l'élément de départ?",
    printed,
    label: "Taille élément de départ",
    explanation: "Côté du chanfrein ou rayon au départ du contour. Sans élément (Q501 = 0), sans effet.",
  },
  cornerRadius: {
    prompt: "Rayon au coin du contour?",
    printed,
    label: "Rayon de coin",
    explanation: "Rayon du coin intérieur. 0 ou aucune valeur : coin vif, où reste le rayon de bec.",
  },
  endElement: {
    prompt: "Type élément final (0/1/2)?",
    printed,
    label: "Élément final",
    explanation: "Élément sur l’arête à la fin du contour.",
    choices: element,
  },
  endElementSize: {
    prompt: "Taille de l'élément final?",
    printed,
    label: "Taille élément final",
    explanation: "Côté du chanfrein ou rayon à la fin du contour. Sans élément (Q503 = 0), sans effet.",
  },
  infeedRadial: {
    prompt: "Plongée max.?",
    printed,
    label: "Passe max.",
    explanation:
      "Passe maximale, au rayon. La profondeur est répartie uniformément : la passe réelle est souvent plus " +
      "petite, sans dernière passe trop mince.",
  },
  infeedAxial: {
    prompt: "Plongée max.?",
    printed,
    label: "Passe max.",
    explanation:
      "Passe maximale, en Z. La profondeur est répartie uniformément : la passe réelle est souvent plus petite, " +
      "sans dernière passe trop mince. 0 : une seule passe.",
  },
  infeedGroove: {
    prompt: "Plongée max.?",
    printed,
    label: "Passe max.",
    explanation:
      "Passe maximale, en Z, répartie uniformément. Le manuel la dit radiale, mais une gorge axiale a sa prise " +
      "de passe en Z ; non vérifié.",
  },
  roughingFeed: {
    prompt: "Avance d'ébauche?",
    printed,
    label: "Avance d’ébauche",
    explanation:
      "Avance des passes d’ébauche : en mm par tour avec M136, sinon en mm par minute. FAUTO reprend l’avance de " +
      "l’appel d’outil.",
  },
  oversizeDiameter: {
    prompt: "Surépaisseur diamètre ?",
    printed,
    label: "Surépaisseur ⌀",
    explanation: "Surépaisseur de finition sur le diamètre ; la moitié de chaque côté.",
  },
  oversizeZ: {
    prompt: "Surépaisseur Z?",
    printed,
    label: "Surépaisseur Z",
    explanation: "Surépaisseur de finition sur les faces, en Z.",
  },
  finishingFeed: {
    prompt: "Avance de finition?",
    printed,
    label: "Avance de finition",
    explanation:
      "Avance de la passe de finition : en mm par tour avec M136, sinon en mm par minute. FAUTO reprend l’avance " +
      "de l’appel d’outil.",
  },
  smoothing: {
    prompt: "Lissage du contour (0/1/2)?",
    printed,
    label: "Lissage",
    explanation: "Comment les marches entre les passes sont enlevées et comment l’outil se relève.",
    choices: {
      0: "après chaque passe le long du contour, dans la passe",
      1: "une fois après la dernière passe, sur tout le contour ; relevage à 45°",
      2: "pas de lissage ; relevage à 45°",
    },
  },
  reverseContour: {
    prompt: "Inverser contour (0-2)?",
    printed,
    label: "Inverser contour",
    explanation: "Sens dans lequel le contour est usiné.",
    choices: {
      0: "sens programmé",
      1: "sens inverse",
      2: "sens inverse, pointe inversée dans le sens d’avance (l’orientation 1 usine comme 7)",
    },
  },
  plunging: {
    prompt: "Autoriser la plongée (0/1)?",
    printed,
    label: "Plongée",
    explanation: "Si les éléments de contour en plongée sont usinés.",
    choices: { 0: "éléments en plongée non usinés", 1: "éléments en plongée usinés" },
  },
  plungingFeed: {
    prompt: "Avance plongée (0=autom.)?",
    printed,
    label: "Avance de plongée",
    explanation: "Avance sur les éléments de contour en plongée. 0 ou aucune valeur : l’avance de tournage.",
  },
  limits: {
    prompt: "Limites d'usinage (0/1)?",
    printed,
    label: "Limites",
    explanation:
      "Restreint le contour usiné à un côté de Q480 et Q482 : celui où se trouve l’outil à l’appel. L’approche " +
      "et la sortie " +
      "peuvent franchir les limites.",
    choices: { 0: "pas de limite", 1: "limites à Q480 et Q482" },
  },
  limitDiameter: {
    prompt: "Valeur de limitation diamètre?",
    printed,
    label: "Limite ⌀",
    explanation: "Limite en X, au diamètre. Active avec Q479 = 1.",
  },
  limitZ: {
    prompt: "Valeur limitation de coupe Z?",
    printed,
    label: "Limite Z",
    explanation: "Limite en Z. Active avec Q479 = 1.",
  },
  direction: {
    prompt: "Sens: (0= bidir. / 1=unidir.)?",
    printed,
    label: "Sens",
    explanation: "Si les passes alternent entre les deux sens.",
    choices: { 0: "dans les deux sens", 1: "un seul sens, celui du contour" },
  },
  offsetWidth: {
    prompt: "Largeur de décalage?",
    printed,
    label: "Largeur de décalage",
    explanation:
      "Raccourcit chaque passe à partir de la deuxième, ce qui réduit la pression latérale sur l’arête. 0 : 0,1 " +
      "mm par passe. La matière résiduelle sur les flancs est enlevée à la fin de l’ébauche. La somme par côté " +
      "peut atteindre 80 % de la largeur effective.",
  },
  depthCompensation: {
    prompt: "Correction de prof. finition?",
    printed,
    label: "Correction de profondeur",
    explanation:
      "Déplace le fond lors de la finition, pour compenser le basculement de l’arête pendant le tournage latéral " +
      ": positive, la gorge est moins profonde ; négative, plus profonde.",
  },
  ...turning,
  ...recessing,
  ...threads,
  ...special,
} satisfies ParamsTexts;
