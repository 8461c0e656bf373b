import type { ClampingTexts } from "../en/clamping.ts";

export const clamping: ClampingTexts = {
  title: "Spannung",
  unstated:
    "Nicht angegeben: das Rohteil gilt als am hinteren Ende gehalten. Berührung von Backen, Futter und Reitstock wird nicht geprüft.",
  state: "Spannung angeben",
  remove: "Keine angeben",
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
    FACE: "Z der Vorderkante",
    SIZE: "Futter-⌀",
    QUILL: "⌀ der Pinole",
    TIP: "Z der Körnerspitze",
    ANGLE: "Spitzenwinkel",
    LIMITZ: "Grenze: nichts links von Z",
    LIMITX: "Grenze: nichts innerhalb ⌀",
  },
  tailstock: "Mit Reitstock",
  known:
    "Maßstäblich gezeichnet; Berührung durch Werkzeug oder Halter ist ein Fehler. " +
    "Backen wie bei üblichen Kraftspannfuttern: eigene messen.",
  inProgram: "Steht als Kommentar im Programm, ;\u00A0CLAMPING …, den die Steuerung übergeht.",
  units: { mm: { diameter: "mm ⌀", length: "mm" }, inch: { diameter: "inch ⌀", length: "inch" } },
};
