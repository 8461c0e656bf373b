/** A small program around a block, with a bar of ⌀50. The line of the block begins with `> `. */
export const program = (blank: string, lines: readonly string[]): readonly string[] => [
  "BEGIN PGM SAMPLE MM",
  ...blank.split("\n"),
  "TOOL CALL 1",
  "FUNCTION MODE TURN",
  "FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500",
  "M136",
  "L X+58 Z+4 FMAX M3",
  ...lines,
  "L X+58",
  "L Z+4 FMAX",
  "M30",
  "END PGM SAMPLE MM",
];
/** One cut along the outside, with the block of the sample in it. */
export const cut = (...lines: readonly string[]) => program("BLK FORM CYLINDER Z D50 L60 DIST+1", lines);
/** The approach, and the cut itself. */
export const TO_CUT = ["L X+44 FMAX", "L Z-12 F0.25"];
/** A cone along the outside. */
export const CONE = ["L X+42 Z+2 FMAX", "L X+46 Z-25 F0.25"];
/** The lines with one of them replaced. */
export const instead = (lines: readonly string[], line: string, ...others: readonly string[]) =>
  lines.flatMap((each) => (each === line ? others : [each]));
