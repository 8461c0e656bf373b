import type { ClampingTexts } from "../en/clamping.ts";

export const clamping: ClampingTexts = {
  title: "Spannung",
  unstated:
    "Nicht angegeben: Das Rohteil gilt als am hinteren Ende gespannt. Berührung mit Backen, Futter oder Reitstock wird nicht geprüft.",
  state: "Spannung angeben",
  remove: "Spannung entfernen",
  kind: "Gespannt in",
  kinds: {
    chuckOutside: "Futter außen",
    chuckInside: "Futter innen",
    softJaws: "Weiche Backen",
    collet: "Spannzange",
    centres: "Zwischen Spitzen",
  },
  grips: {
    chuckOutside: "Spann-⌀ außen",
    chuckInside: "Spann-⌀ innen",
    softJaws: "Spann-⌀ außen",
    collet: "Spann-⌀",
    centres: "⌀ des Mitnehmers",
  },
  nose: "⌀ der Nase",
  words: {
    D: "Spann-⌀",
    LENGTH: "Spannlänge",
    FACE: "Z der vorderen Fläche",
    SIZE: "Futter-⌀",
    QUILL: "⌀ der Pinole",
    TIP: "Z der Körnerspitze",
    ANGLE: "Spitzenwinkel",
    LIMITZ: "Grenze: nichts links von Z",
    LIMITX: "Grenze: nichts innerhalb ⌀",
  },
  tailstock: "Mit Reitstock",
  known:
    "Maßstäblich gezeichnet; Berührung mit Werkzeug oder Halter ist ein Fehler. Backen wie bei üblichen Kraftspannfuttern: eigene messen.",
  inProgram: "Im Programm als Kommentar gespeichert, ;\u00A0CLAMPING …; die Steuerung ignoriert ihn.",
  units: { mm: { diameter: "mm ⌀", length: "mm" }, inch: { diameter: "inch ⌀", length: "inch" } },
};
