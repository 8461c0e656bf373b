import type { Shape } from "../shape.ts";

export const exported = {
  title: "Export part",
  lead: "Lengths in millimetres. Z lies along the spindle, the zero point is that of the workpiece.",
  leadInches:
    "DXF in inches, as the program counts; STL and SVG in millimetres. Z lies along the spindle, the zero point is that of the workpiece.",
  bodies: "Bodies",
  bodiesHint:
    "STL in millimetres, closed surfaces, chords within 0.02 mm of the round. Threads are helices, right-handed.",
  body: { part: "Finished part", blank: "Blank", stock: "Stock as it is now" },
  bodyHint: {
    part: "The blank less all that the cycles and the moves between them take away.",
    left: "No cycle states a contour: what all moves leave of the blank at the end.",
    blank: "As the program states it.",
    stock: (step: string, steps: string) => `After ${step} of ${steps} moves, where the playback stands.`,
  },
  file: { part: "part", blank: "blank", stock: "stock" },
  contour: "Contour",
  which: "Which contour",
  all: "All, each on a layer of its own",
  one: (block: string, cycle: string) => `Block ${block}, cycle ${cycle}`,
  milled: (block: string) => `Block ${block}, working plane`,
  across: "X in the DXF file",
  radius: "As a radius, arcs as arcs",
  diameter: (within: string) => `As a diameter, arcs as chords within ${within}`,
  acrossHint: "The drawing shows half of the section. Whoever reads it has to know which of the two it is.",
  svgHint: "SVG: true size, X as a radius, arcs as arcs.",
  planeHint: "True size, X to the right and Y up, arcs as arcs.",
  older: "This is older than what was typed: the newest values make no path.",
  beginning: "The program is still being calculated.",
  lack: {
    noBlank: "The program states no blank.",
    noTurning: "The program mills only: there is no turned body.",
    nothingLeft: "Nothing is left of the stock here.",
    noCycle: "Nothing is taken away from the blank.",
    noContour: "There is no contour yet.",
  },
  milling: "What is milled is not in the bodies: they show the part as it is turned.",
  unproved: "Part of the program is not simulated. The bodies show the rest of it.",
  save: (what: string, format: string) => `${what} as ${format}`,
  saved: (file: string, volume: string) => `${file} saved, ${volume}.`,
  savedFile: (file: string) => `${file} saved.`,
  rings: "Its threads are rings: they could not be made helices.",
};

export type ExportTexts = Shape<typeof exported>;
