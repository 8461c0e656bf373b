import type { Shape } from "../shape.ts";

/** Texts of the next clamping: a program whose blank is the part that this program leaves. */
export const secondSide = {
  title: "Second side",
  lead: "The result of this program becomes the blank of a new program: mirrored, with its zero point on the new face. This program is not changed.",
  piece: "Piece",
  held: (size: string) => `In the chuck, ${size}`,
  off: (size: string) => `Parted off, ${size}`,
  allowance: (unit: string) => `Stock on the new face, ${unit}`,
  allowanceHint: "Distance of Z0 behind the new face. 0: the face is not machined.",
  allowanceWrong: (most: string) => `A length from 0 to ${most}`,
  blank: "Blank",
  name: "New program",
  open: "Open the new program",
  lack: {
    beginning: "The program is still being calculated.",
    older: "The latest values give no tool path: the result is unknown.",
    faults: "The program has errors: its result is not the part. See the findings.",
    noBlank: "The program defines no blank.",
    nothingLeft: "No stock is left.",
  },
  unproved: "Part of the program is not simulated and is not included in the new blank.",
  milling: "Milling is not included in the new blank: it is the turned part.",
};

export type SecondSideTexts = Shape<typeof secondSide>;
