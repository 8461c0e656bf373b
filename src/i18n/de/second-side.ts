import type { SecondSideTexts } from "../en/second-side.ts";

export const secondSide: SecondSideTexts = {
  title: "Umspannen",
  lead:
    "Was dieses Programm stehen lässt, wird das Rohteil eines neuen: gespiegelt, Nullpunkt an der neuen Planfläche. Dieses Programm " +
    "bleibt, wie es ist.",
  piece: "Teil",
  held: (size) => `Im Futter, ${size}`,
  off: (size) => `Abgestochen, ${size}`,
  allowance: (unit) => `Aufmaß an der neuen Planfläche, ${unit}`,
  allowanceHint: "So weit dahinter liegt Z0. 0: Die Fläche wird nicht mehr plangedreht.",
  allowanceWrong: (most) => `Eine Länge von 0 bis ${most}`,
  blank: "Rohteil",
  name: "Neues Programm",
  open: "Neues Programm öffnen",
  lack: {
    beginning: "Das Programm wird noch berechnet.",
    older: "Mit den neuesten Werten entsteht kein Weg: Was sie stehen lassen, ist nicht bekannt.",
    faults: "Das Programm hat Fehler: Was es stehen lässt, ist nicht das Teil. Siehe Befunde.",
    noBlank: "Das Programm gibt kein Rohteil an.",
    nothingLeft: "Vom Material ist nichts übrig.",
  },
  unproved: "Ein Teil des Programms wird nicht simuliert. Was er tut, fehlt im neuen Rohteil.",
  milling: "Gefrästes fehlt im neuen Rohteil: Es ist das Teil, wie es gedreht ist.",
};
