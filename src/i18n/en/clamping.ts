import type { Shape } from "../shape.ts";

export const clamping = {
  title: "Clamping",
  unstated:
    "Not specified: the blank is assumed to be held at its rear end. Contact with jaws, chuck or tailstock is not checked.",
  state: "Specify clamping",
  remove: "Remove clamping",
  kind: "Held by",
  kinds: {
    chuckOutside: "Chuck, jaws outside",
    chuckInside: "Chuck, jaws inside",
    softJaws: "Soft jaws",
    collet: "Collet",
    centres: "Between centres",
  },
  /** The diameter at which each kind grips. */
  grips: {
    chuckOutside: "Gripped outside ⌀",
    chuckInside: "Gripped inside ⌀",
    softJaws: "Gripped outside ⌀",
    collet: "Gripped ⌀",
    centres: "Driver ⌀",
  },
  nose: "Nose ⌀",
  words: {
    D: "Gripped ⌀",
    LENGTH: "Clamping length",
    FACE: "Z of the front face",
    SIZE: "Chuck ⌀",
    QUILL: "Quill ⌀",
    TIP: "Z of the centre tip",
    ANGLE: "Point angle",
    LIMITZ: "Limit: nothing left of Z",
    LIMITX: "Limit: nothing within ⌀",
  },
  tailstock: "With tailstock",
  known:
    "Drawn to scale; contact with tool or holder is an error. Jaws are those of common power chucks: measure your own.",
  inProgram: "Saved in the program as a comment, ;\u00A0CLAMPING …, which the control ignores.",
  units: { mm: { diameter: "mm ⌀", length: "mm" }, inch: { diameter: "inch ⌀", length: "inch" } },
};

export type ClampingTexts = Shape<typeof clamping>;
