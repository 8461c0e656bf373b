import type { Shape } from "../shape.ts";

/** Texts of the next clamping: a program whose blank is what this one leaves. */
export const secondSide = {
  title: "Turn it round",
  lead: "What this program leaves becomes the blank of a new one: mirrored, with its zero point at the new face. This program stays as it is.",
  piece: "Piece",
  held: (size: string) => `In the chuck, ${size}`,
  off: (size: string) => `Came off, ${size}`,
  allowance: (unit: string) => `Stock on the new face, ${unit}`,
  allowanceHint: "Z0 lies so far behind the new face. 0: it is not faced any more.",
  allowanceWrong: (most: string) => `A length from 0 to ${most}`,
  blank: "Blank",
  name: "New program",
  open: "Open the new program",
  lack: {
    beginning: "The program is still being calculated.",
    older: "The newest values make no path: nobody knows what they leave.",
    faults: "The program has errors: what it leaves is not the part. See the findings.",
    noBlank: "The program states no blank.",
    nothingLeft: "Nothing is left of the stock.",
  },
  unproved: "Part of the program is not simulated. The new blank is without what it does.",
  milling: "What is milled is not in the new blank: it is the part as it is turned.",
};

export type SecondSideTexts = Shape<typeof secondSide>;
