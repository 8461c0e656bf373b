import type { Shape } from "../shape.ts";

/** Texts of the dialog that inserts an operation: where it starts in the stock, with which contour, with which tool. */
export const insert = {
  site: "Where",
  sites: { outside: "Outside", inside: "Inside", face: "Face" },
  surface: "Surface",
  cylinder: (across: string, from: string, to: string) => `⌀${across}, Z${from} to Z${to}`,
  face: (z: string, from: string, to: string) => `Z${z}, ⌀${from} to ⌀${to}`,
  picture: (surfaces: number) => `Stock before this operation, surfaces: ${surfaces}`,
  none: {
    outside: "The stock has no cylinder here.",
    inside: "The stock has no bore yet. Drill first, or state an inside diameter in the blank.",
    face: "The stock has no front face here.",
  },
  noStock: "The stock is unknown: state a blank (BLK FORM) to get sizes suggested.",
  fromSurface: (sizes: string) => `From the surface: ${sizes}`,
  fromStock: (sizes: string) => `Suggested: ${sizes}`,
  open: (prompts: string) => `Open: ${prompts}`,
  contour: "Contour",
  label: (label: string) => `LBL ${label}`,
  draw: "Draw a new contour",
  undrawn: "Draw the contour to continue.",
  unsuitable: (tools: number) => `Unsuitable tools (${tools})`,
  noTool: "No tool in the table reaches this place.",
  fromThread: (name: string, values: string) => `${name}: ${values}`,
  threadBefore: {
    outside: (should: string, is: string) => `The thread needs a shaft of ⌀${should}; here it is ⌀${is}.`,
    inside: (should: string, is: string) => `The thread needs a bore of ⌀${should}; here it is ⌀${is}.`,
  },
  noThreadTool: (angle: string) => `No thread tool with ${angle}° reaches this place.`,
  addThreadTool: "Add one",
  hand: {
    title: "Other operations",
    of: {
      chamfer: "Chamfer by hand (L)",
      partOff: "Part off",
      partOffChamfered: "Part off with back chamfer",
      centre: "Centre hole by name",
      drill: "Drill on the axis",
      peck: "Drill a deep hole on the axis",
      ream: "Ream on the axis",
      tap: "Tap on the axis",
    },
    threads: "Threads",
    threadOf: (name: string, site: string, cycle: number) => `${name} ${site.toLowerCase()}: cycle ${cycle}`,
    tapOf: (name: string) => `Tap ${name}`,
    thread: "Thread",
    core: (least: string, greatest: string) => `Core ⌀${least} to ⌀${greatest}`,
    noTap: "No thread that a tap makes. Examples: M10, M20×1.5, G1/2, 1/4-20 UNC.",
    wrongBore: (is: string, least: string, greatest: string) =>
      `The bore is ⌀${is}; the tap needs ⌀${least} to ⌀${greatest}.`,
    drillBefore: (across: string, tool: number) => `Drill ⌀${across} before it (T${tool})`,
    undercut: "Undercut by name",
    undercutName: "Designation of the undercut",
    noShoulder: "The stock has no shoulder here: type diameter and position.",
    cylinder: "Diameter at the undercut",
    shoulder: "Shoulder in Z",
    undercutUnfit: "The undercut does not fit here: the cylinder or the face is too short.",
    hole: {
      name: "Designation of the centre hole",
      unknown:
        "Known: ISO 6411 and DIN 332-1, forms A, B and R with 1, 1.6, 2, 2.5, 3.15, 4, 6.3 or 10, e.g. ISO 6411-A 4/8.5.",
      size: (mouth: string, depth: string) =>
        `⌀${mouth} at the face, least depth ${depth}. Sizes from public tables of ISO 6411 and DIN 332-1; the shaft is a guide value.`,
      pilot: "LCUTS of the drill is the length of its pilot: measure it, the depth follows from it.",
      formR: "The flank of form R is drawn straight; its radius is not known.",
    },
    sizes: { size: "Chamfer", z: "Rear face in Z" },
    noTool: "The tool table has no tool for this.",
    drills: "Drills and taps",
    standard: "The tool table has none. The chosen standard tool is added to it.",
    tools: "Open the tool table",
  },
};

export type InsertTexts = Shape<typeof insert>;
