import type { InsertTexts } from "../en/insert.ts";

export const insert: InsertTexts = {
  site: "Wo",
  sites: { outside: "Außen", inside: "Innen", face: "Plan" },
  surface: "Fläche",
  cylinder: (across, from, to) => `⌀${across}, Z${from} bis Z${to}`,
  face: (z, from, to) => `Z${z}, ⌀${from} bis ⌀${to}`,
  picture: (surfaces) => `Rohteil vor dieser Bearbeitung, Flächen: ${surfaces}`,
  none: {
    outside: "Das Rohteil hat hier keinen Zylinder.",
    inside: "Das Rohteil hat noch keine Bohrung. Zuerst bohren oder im Rohteil einen Innendurchmesser angeben.",
    face: "Das Rohteil hat hier keine Stirnfläche.",
  },
  noStock: "Das Rohteil ist unbekannt: mit BLK FORM angeben, damit Maße vorgeschlagen werden.",
  fromSurface: (sizes) => `Aus der Fläche: ${sizes}`,
  fromStock: (sizes) => `Vorgeschlagen: ${sizes}`,
  open: (prompts) => `Offen: ${prompts}`,
  contour: "Kontur",
  label: (label) => `LBL ${label}`,
  draw: "Neue Kontur zeichnen",
  undrawn: "Zuerst die Kontur zeichnen.",
  unsuitable: (tools) => `Ungeeignete Werkzeuge (${tools})`,
  noTool: "Kein Werkzeug der Tabelle erreicht diese Stelle.",
  hand: {
    title: "Ohne Drehzyklus",
    of: {
      chamfer: "Fase von Hand (L)",
      partOff: "Abstechen",
      partOffChamfered: "Abstechen mit Fase hinten",
      drill: "Bohren in der Drehmitte",
      tap: "Gewindebohren in der Drehmitte",
    },
    sizes: { size: "Fase", z: "Rückseite in Z" },
    noTool: "Die Werkzeugtabelle hat kein Werkzeug dafür.",
    tools: "Werkzeugtabelle öffnen",
  },
};
