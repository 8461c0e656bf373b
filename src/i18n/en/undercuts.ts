import type { Shape } from "../shape.ts";

export const undercuts = {
  label: "Undercut",
  of: (element: number) => `Element ${element}, undercut by name`,
  sizes: "Sizes",
  example: "e.g. F0.8×0.3 or DIN 76-A",
  none: "No known designation. Known: DIN 509 and ISO 18388 E, F, H with r×t1; DIN 76 A to D with pitch.",
  noPlace: "The diameter follows when a cylinder and a face meet here.",
  taken: (name: string) => `${name}: words filled in`,
  load: { usual: "usual load", fatigue: "increased fatigue strength" },
  source: "From public tables of DIN 509:2006-12 and DIN 76-1:2004-06, nominal sizes. Not printed for this control.",
  notes: {
    nearest: (asked: string, taken: string) => `${asked} is not in the standard. Nearest size: ${taken}.`,
    diameter: (from: string, to: string | null) =>
      to === null ? `The standard assigns it above ⌀${from}.` : `The standard assigns it above ⌀${from} up to ⌀${to}.`,
    side: (asked: string, taken: string) => `Form ${asked} is for the other side, form ${taken} is taken.`,
    pitch: (pitch: string) => `DIN 76 does not list pitch ${pitch}.`,
    formG: "UDC has no form G: draw it with lines and arcs.",
    faceOfF:
      "The cycle leaves the recess in the face (t2). “Undercut by name”, inserted as an operation, cuts it with path blocks.",
    faceOfH: (t2: string) => `TYPE_H does not cut t2 = ${t2} into the face.`,
    allowance: (z: string) => `Sizes before grinding with z = ${z}: program the contour with this material too.`,
  },
};

export type UndercutTexts = Shape<typeof undercuts>;
