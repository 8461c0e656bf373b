import type { BarMake, InsertClamping, Cuts } from "./code-part.ts";

/*
 * Facts of ISO 5608 (holders), ISO 5609 and 6261 (boring bars) and ISO 5610 (shanks). Sources, and where they differ:
 * docs/decisions, the reading of tool codes.
 */

/** Clamping of the insert; X is special. */
export const CLAMPINGS: Readonly<Record<string, InsertClamping>> = {
  C: "top",
  D: "topHole",
  M: "topHole",
  P: "hole",
  S: "screw",
  W: "wedge",
};

/** Position of the tip on the shank: centred, over one side, or beyond that side. */
type Seat = "middle" | "straight" | "offset";

export interface HolderStyle {
  /** Entering angle from the direction of feed to the main edge, degrees. */
  readonly angle: number;
  readonly cuts: Cuts;
  readonly seat: Seat;
  /** False where the sources differ, or none of them has the letter. */
  readonly sure: boolean;
}
const style = (angle: number, cuts: Cuts, seat: Seat, sure = true): HolderStyle => ({ angle, cuts, seat, sure });

/** Style by its letter; X is special. */
export const HOLDER_STYLES: Readonly<Record<string, HolderStyle>> = {
  A: style(90, "side", "straight"),
  B: style(75, "side", "straight"),
  C: style(90, "end", "straight"),
  D: style(45, "side", "middle"),
  E: style(60, "side", "middle"),
  F: style(90, "end", "offset"),
  G: style(90, "side", "offset"),
  H: style(107.5, "side", "offset", false),
  J: style(93, "side", "offset"),
  K: style(75, "end", "offset"),
  L: style(95, "both", "offset"),
  M: style(50, "side", "middle"),
  N: style(63, "side", "middle", false),
  P: style(117.5, "side", "offset", false),
  Q: style(107.5, "end", "offset", false),
  R: style(75, "side", "offset"),
  S: style(45, "side", "offset"),
  T: style(60, "side", "offset"),
  U: style(93, "end", "offset"),
  V: style(72.5, "side", "middle"),
  W: style(60, "end", "offset", false),
  Y: style(85, "end", "offset"),
};

/** Length of a shank or a bar by its letter, mm; X is special. */
export const LENGTHS: Readonly<Record<string, number>> = {
  A: 32,
  B: 40,
  C: 50,
  D: 60,
  E: 70,
  F: 80,
  G: 90,
  H: 100,
  J: 110,
  K: 125,
  L: 140,
  M: 150,
  N: 160,
  P: 170,
  Q: 180,
  R: 200,
  S: 250,
  T: 300,
  U: 350,
  V: 400,
  W: 450,
  Y: 500,
};
/** Length letters on which tables differ. */
export const UNSURE_LENGTHS = ["F", "G", "N", "W"];

/** Distance from the back of an offset shank to the tip, by shank width, mm. */
export const SHANK_REACH: Readonly<Record<number, number>> = {
  8: 10,
  10: 12,
  12: 16,
  16: 20,
  20: 25,
  25: 32,
  32: 40,
  40: 50,
  50: 60,
};

/** Distance from the bar axis to the tip, by bar diameter, mm. */
export const BAR_REACH: Readonly<Record<number, number>> = {
  8: 6,
  10: 7,
  12: 9,
  16: 11,
  20: 13,
  25: 17,
  32: 22,
  40: 27,
  50: 35,
};

export const BAR_MAKES: Readonly<Record<string, BarMake>> = {
  S: "steel",
  A: "steelCoolant",
  B: "steelDamped",
  D: "steelDampedCoolant",
  C: "carbide",
  E: "carbideCoolant",
  F: "carbideDamped",
  G: "carbideDampedCoolant",
  H: "heavy",
  J: "heavyCoolant",
};
