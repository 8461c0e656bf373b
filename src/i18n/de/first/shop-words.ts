import type { ShopWords } from "../../shop-words.ts";

export const shopWords: ShopWords = {
  groups: {
    special: ["einrichten", "Koordinatensystem", "zurücksetzen"],
    longitudinal: ["längs", "Längsdrehen", "Ausdrehen", "Bohrung", "Innendrehen", "Außendrehen", "Durchmesser"],
    transverse: ["plan", "Plandrehen", "Planen", "Stirnfläche", "Planfläche"],
    recessTurning: ["Einstich", "Nut", "Stechdrehen"],
    recessing: ["Einstich", "Nut", "Abstechen", "Stechen", "Einstechen"],
    thread: ["Gewinde", "Gewindedrehen", "Steigung", "Schraube"],
  },
  free: ["Freistich", "Profil", "Form", "Kontur"],
  same: [
    ["Absatz", "Schulter", "Stufe", "Ansatz", "Bund"],
    ["Einstich", "Nut"],
    ["Kontur", "Profil"],
  ],
};
