import type { SecondSideTexts } from "../en/second-side.ts";

export const secondSide: SecondSideTexts = {
  title: "Zweite Seite",
  lead: "Das Ergebnis dieses Programms wird das Rohteil eines neuen Programms: gespiegelt, Nullpunkt an der neuen Planfläche. Dieses Programm bleibt unverändert.",
  piece: "Teil",
  held: (size) => `Im Futter, ${size}`,
  off: (size) => `Abgestochen, ${size}`,
  allowance: (unit) => `Aufmaß an der neuen Planfläche, ${unit}`,
  allowanceHint: "Abstand von Z0 hinter der neuen Planfläche. 0: Die Fläche wird nicht plangedreht.",
  allowanceWrong: (most) => `Eine Länge von 0 bis ${most}`,
  blank: "Rohteil",
  name: "Neues Programm",
  open: "Neues Programm öffnen",
  lack: {
    beginning: "Das Programm wird noch berechnet.",
    older: "Die neuesten Werte ergeben keine Bahn: Das Ergebnis ist unbekannt.",
    faults: "Das Programm hat Fehler: Sein Ergebnis ist nicht das Teil. Siehe Meldungen.",
    noBlank: "Das Programm definiert kein Rohteil.",
    nothingLeft: "Es ist kein Material mehr da.",
  },
  unproved: "Ein Teil des Programms wird nicht simuliert und fehlt im neuen Rohteil.",
  milling: "Ohne Fräsbearbeitung: Das neue Rohteil ist das Drehteil.",
};
