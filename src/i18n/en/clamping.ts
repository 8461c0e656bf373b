import type { Shape } from "../shape.ts";

export const clamping = {
  title: "Clamping",
  unstated:
    "Not stated: the blank counts as held at its rear end. Contact with jaws, chuck or tailstock is not looked for.",
  state: "State a clamping",
  remove: "State none",
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
    LENGTH: "Length in the grip",
    FACE: "Z of the front",
    SIZE: "Chuck ⌀",
    QUILL: "Quill ⌀",
    TIP: "Z of the centre's tip",
    ANGLE: "Point angle",
    LIMITZ: "Limit: nothing left of Z",
    LIMITX: "Limit: nothing within ⌀",
  },
  tailstock: "With tailstock",
  known:
    "Drawn to scale; contact of tool or holder with it is an error. Jaws are those of usual power chucks: measure yours.",
  inProgram: "Kept in the program as a comment, ;\u00A0CLAMPING …, which a control passes over.",
  units: { mm: { diameter: "mm ⌀", length: "mm" }, inch: { diameter: "inch ⌀", length: "inch" } },
};

export type ClampingTexts = Shape<typeof clamping>;
