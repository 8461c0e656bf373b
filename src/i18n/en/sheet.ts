import type { Shape } from "../shape.ts";

export const sheet = {
  title: "Setup sheet",
  print: "Print",
  close: "Back to the program",
  remarks: "Remarks",
  program: "Program",
} as const;

export type SheetTexts = Shape<typeof sheet>;
