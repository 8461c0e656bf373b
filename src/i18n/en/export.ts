import type { Shape } from "../shape.ts";

export const exported = {
  title: "Export part",
  lead: "Lengths in millimetres. Z is the spindle axis, the origin is the workpiece zero.",
  leadInches:
    "DXF in inches, as in the program; STL and SVG in millimetres. Z is the spindle axis, the origin is the workpiece zero.",
  bodies: "Bodies",
  bodiesHint: "STL in millimetres, closed surfaces, chord tolerance 0.02 mm. Threads are right-hand helices.",
  body: { part: "Finished part", blank: "Blank", stock: "Current stock" },
  bodyHint: {
    part: "The blank minus the material that all cycles and moves remove.",
    left: "No cycle defines a contour: the stock after all moves.",
    blank: "As defined in the program.",
    stock: (step: string, steps: string) => `After ${step} of ${steps} moves, at the playback position.`,
  },
  file: { part: "part", blank: "blank", stock: "stock" },
  contour: "Contour",
  which: "Which contour",
  all: "All, each on its own layer",
  one: (block: string, cycle: string) => `Block ${block}, cycle ${cycle}`,
  milled: (block: string) => `Block ${block}, working plane`,
  across: "X in the DXF file",
  radius: "As a radius, arcs as arcs",
  diameter: (within: string) => `As a diameter, arcs as chords within ${within}`,
  acrossHint: "The drawing shows a half section. Its reader must know whether X is a radius or a diameter.",
  svgHint: "SVG: true size, X as a radius, arcs as arcs.",
  planeHint: "True size, X to the right and Y up, arcs as arcs.",
  older: "Last valid state: the latest values give no tool path.",
  beginning: "The program is still being calculated.",
  lack: {
    noBlank: "The program defines no blank.",
    noTurning: "The program only mills: there is no turned part.",
    nothingLeft: "No stock is left here.",
    noCycle: "No material is removed from the blank.",
    noContour: "There is no contour yet.",
  },
  milling: "Milling is not included: the bodies show the turned part.",
  unproved: "Part of the program is not simulated and is not included in the bodies.",
  save: (what: string, format: string) => `${what} as ${format}`,
  saved: (file: string, volume: string) => `${file} saved, ${volume}.`,
  savedFile: (file: string) => `${file} saved.`,
  rings: "Threads are exported as rings, not as helices.",
};

export type ExportTexts = Shape<typeof exported>;
