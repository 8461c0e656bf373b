import type { HelpTexts } from "../../en/workplace/help.ts";

export const help = {
  picture: (cycle) => `Zeichnung der Kontur, Zyklus ${cycle}`,
  highlighted: (parameter, label, value) => `Hervorgehoben: ${parameter} ${label}, ${value}`,
  stale: "Ungültige Kontur; letzte gültige Zeichnung",
  partial: "Q-Nummern vertreten Werte, die noch fehlen.",
  noValue: "noch kein Wert",
  inWords: {
    diameter: (value) => `Durchmesser ${value} mm`,
    oversizeDiameter: (value) => `${value} mm im Durchmesser`,
    radial: (value) => `${value} mm im Radius`,
    axial: (value) => `Z ${value} mm`,
    axialDepth: (value) => `${value} mm in Z`,
    length: (value) => `${value} mm`,
    angle: (value) => `${value} Grad`,
    feed: (value) => `Vorschub ${value}`,
    count: (value) => value,
    factor: (value) => `Faktor ${value}`,
    percent: (value) => `${value} Prozent`,
    revolutions: (value) => `${value} Umdrehungen`,
    auto: "FAUTO, der Vorschub aus dem Werkzeugaufruf",
    choice: (value, meaning) => `${value}, ${meaning}`,
  },
  element: { none: "ohne", chamfer: "Fase", radius: "Radius" },
  reserved: "(ohne Funktion)",
  notToScale: "nicht maßstäblich",
} satisfies HelpTexts;
