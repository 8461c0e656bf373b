import type { SomeParamTexts } from "../../../param-text.ts";

const printed = false;

export const threads = {
  clearanceRunIn: {
    prompt: "Distance d'approche?",
    printed,
    label: "Distance d’approche",
    explanation:
      "Distance de dégagement entre les passes. Dans ce cycle, c’est aussi la course d’engagement : chaque passe " +
      "commence à cette distance avant le départ.",
  },
  threadPosition: {
    prompt: "Position du filetage (0=ext./1=int.)?",
    printed,
    label: "Position",
    explanation:
      "Filetage à l’extérieur ou à l’intérieur. Le diamètre nominal est le sommet à l’extérieur, le fond à " +
      "l’intérieur.",
    choices: { 0: "filetage extérieur", 1: "filetage intérieur" },
  },
  threadOrientation: {
    prompt: "Orientation du filetage (0=long./1=transv.)?",
    printed,
    label: "Orientation",
    explanation: "Axe synchronisé avec la broche : le pas est mesuré le long de cet axe.",
    choices: { 0: "longitudinale, parallèle à l’axe", 1: "transversale, dans une face" },
  },
  threadDiameter: {
    prompt: "Diamètre du filetage?",
    printed,
    label: "⌀ filetage",
    explanation: "Diamètre nominal : sommet d’un filetage extérieur, fond d’un filetage intérieur.",
  },
  threadStartDiameter: {
    prompt: "Diamètre au départ du filetage?",
    printed,
    label: "⌀ départ",
    explanation: "Diamètre nominal au départ du filetage. Avec Q464 = 2, il résulte de la fin et de l’angle.",
  },
  threadEndDiameter: {
    prompt: "Diamètre à la fin du filetage?",
    printed,
    label: "⌀ fin",
    explanation: "Diamètre nominal à la fin du filetage. Avec Q464 = 4, il résulte du départ et de l’angle.",
  },
  threadPitch: {
    prompt: "Pas du filetage?",
    printed,
    label: "Pas",
    explanation:
      "Course de l’outil par tour de broche. Avec plusieurs filets, c’est le pas hélicoïdal ; l’écart d’un filet " +
      "au suivant est ce pas divisé par le nombre de filets.",
  },
  threadDepth: {
    prompt: "Profondeur du filetage?",
    printed,
    label: "Profondeur",
    explanation:
      "Profondeur au rayon. 0 : d’après le pas, comme pour un filetage ISO métrique (extérieur 0,6134, intérieur " +
      "0,5413 × pas).",
  },
  threadRunOut: {
    prompt: "Longueur de sortie du filetage?",
    printed,
    label: "Sortie",
    explanation:
      "Course à la fin du filetage sur laquelle l’outil remonte du fond au sommet. 0 : l’outil se dégage après " +
      "le dépassement, depuis la pleine profondeur.",
  },
  threadRunIn: {
    prompt: "Course d'engagement?",
    printed,
    label: "Engagement",
    explanation: "Course avant le filetage sur laquelle l’axe accélère jusqu’à l’avance.",
  },
  threadOverrun: {
    prompt: "Course de dépassement?",
    printed,
    label: "Dépassement",
    explanation:
      "Course après le filetage sur laquelle l’axe freine. Sans sortie, cette course se fait à pleine profondeur " +
      ": un dégagement est nécessaire.",
  },
  taperForm: {
    prompt: "Type de cotation du cône (0-4)?",
    printed,
    label: "Cône défini par",
    explanation:
      "Valeurs qui définissent la ligne du filetage. L’angle Q469 se mesure depuis une parallèle à l’axe dans le " +
      "sens de coupe.",
    choices: {
      0: "points de départ et de fin",
      1: "point de fin, diamètre de départ, angle",
      2: "point de fin, Z de départ, angle",
      3: "point de départ, diamètre de fin, angle",
      4: "point de départ, Z de fin, angle",
    },
  },
  taperAngle: {
    prompt: "Angle du cône?",
    printed,
    label: "Angle du cône",
    explanation:
      "Angle entre la ligne du filetage et l’axe, positif si le diamètre croît dans le sens de coupe. Sans effet " +
      "avec Q464 = 0.",
  },
  firstInfeed: {
    prompt: "Profondeur de passe max.?",
    printed,
    label: "Première passe",
    explanation:
      "Profondeur de la première passe, au rayon. À section de copeau constante, chaque passe suivante est " +
      "plus faible, mais jamais moins d’un vingtième de la première.",
  },
  infeedAngle: {
    prompt: "Angle de prise de passe?",
    printed,
    label: "Angle de pénétration",
    explanation:
      "Direction de la prise de passe par rapport à la perpendiculaire au filetage : l’outil se décale aussi " +
      "latéralement, et c’est surtout le flanc avant qui coupe. Au plus la moitié de l’angle de pointe.",
  },
  infeedType: {
    prompt: "Type de prise de passe (0/1)?",
    printed,
    label: "Type de passe",
    explanation: "Répartition de la profondeur entre les passes.",
    choices: { 0: "section de copeau constante", 1: "profondeur constante" },
  },
  startingAngle: {
    prompt: "Angle de départ?",
    printed,
    label: "Angle de départ",
    explanation: "Angle de broche où commence le filetage : il décale le filetage autour de l’axe.",
  },
  threadStarts: {
    prompt: "Nombre de filets?",
    printed,
    label: "Filets",
    explanation: "Nombre de filets ; chacun commence 360° divisés par ce nombre après le précédent.",
  },
  airCuts: {
    prompt: "Nombre de passes à vide?",
    printed,
    label: "Passes à vide",
    explanation: "Passes à la profondeur finie sans prise de passe, pour chaque filet.",
  },
} satisfies SomeParamTexts;
