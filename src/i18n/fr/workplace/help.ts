import type { HelpTexts } from "../../en/workplace/help.ts";

export const help = {
  picture: (cycle) => `Dessin du contour, cycle ${cycle}`,
  highlighted: (parameter, label, value) => `En évidence : ${parameter} ${label}, ${value}`,
  stale: "Contour non valide ; dernier dessin valide",
  partial: "Les numéros Q représentent des valeurs non saisies.",
  noValue: "pas encore de valeur",
  inWords: {
    diameter: (value) => `diamètre ${value} mm`,
    oversizeDiameter: (value) => `${value} mm au diamètre`,
    radial: (value) => `${value} mm au rayon`,
    axial: (value) => `Z ${value} mm`,
    axialDepth: (value) => `${value} mm selon Z`,
    length: (value) => `${value} mm`,
    angle: (value) => `${value} degrés`,
    feed: (value) => `avance ${value}`,
    count: (value) => value,
    factor: (value) => `facteur ${value}`,
    percent: (value) => `${value} pour cent`,
    revolutions: (value) => `${value} tours`,
    auto: "FAUTO, l’avance de l’appel d’outil",
    choice: (value, meaning) => `${value}, ${meaning}`,
  },
  element: { none: "aucun", chamfer: "chanfrein", radius: "rayon" },
  reserved: "(sans fonction)",
  notToScale: "hors échelle",
} satisfies HelpTexts;
