import type { UndercutTexts } from "../en/undercuts.ts";

export const undercuts: UndercutTexts = {
  label: "Freistich",
  of: (element) => `Element ${element}, Freistich nach Bezeichnung`,
  sizes: "Größen",
  example: "z. B. F0,8×0,3 oder DIN 76-A",
  none: "Keine bekannte Bezeichnung. Bekannt: DIN 509 und ISO 18388 E, F, H mit r×t1; DIN 76 A bis D mit Steigung.",
  noPlace: "Der Durchmesser ergibt sich, sobald hier Zylinder und Planfläche zusammentreffen.",
  taken: (name) => `${name}: Wörter eingetragen`,
  load: { usual: "übliche Beanspruchung", fatigue: "erhöhte Wechselfestigkeit" },
  source:
    "Aus öffentlichen Tabellen der DIN 509:2006-12 und DIN 76-1:2004-06, Nennmaße. Für diese Steuerung nicht gedruckt.",
  notes: {
    nearest: (asked, taken) => `${asked} gibt es in der Norm nicht. Nächste Größe: ${taken}.`,
    diameter: (from, to) =>
      to === null ? `Die Norm sieht ihn über ⌀${from} vor.` : `Die Norm sieht ihn über ⌀${from} bis ⌀${to} vor.`,
    side: (asked, taken) => `Form ${asked} gilt für die andere Seite, Form ${taken} wird genommen.`,
    pitch: (pitch) => `DIN 76 enthält die Steigung ${pitch} nicht.`,
    formG: "UDC hat keine Form G: mit Geraden und Bögen zeichnen.",
    faceOfF:
      "Der Zyklus lässt den Einstich in die Planfläche (t2) stehen. „Freistich nach Norm“, als Bearbeitung eingefügt, schneidet ihn mit Bahnsätzen.",
    faceOfH: (t2) => `TYPE_H schneidet t2 = ${t2} nicht in die Planfläche.`,
    allowance: (z) => `Maße vor dem Schleifen mit z = ${z}: auch die Kontur mit dieser Zugabe programmieren.`,
  },
};
