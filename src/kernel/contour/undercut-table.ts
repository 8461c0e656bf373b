import { nominalOfBore } from "./metric-thread.ts";
import { INCH_ROUNDED } from "../tolerance.ts";
import type { Diameter } from "../units.ts";

/** Dimensions of an undercut, mm. */
export interface UndercutMeasures {
  readonly R: number;
  readonly DEPTH: number;
  readonly BREADTH: number;
  readonly FACEDEPTH: number;
}

/**
 * Up to diameter: radius, depth, breadth, depth into the face. DIN 509, forms E and F, printed for HEIDENHAIN lathes
 * (tag L: MANUALplus 620 p. 581, CNC PILOT 640 p. 617; decision 0005).
 */
const DIN_509: readonly (readonly [upTo: number, R: number, DEPTH: number, BREADTH: number, FACEDEPTH: number])[] = [
  [1.6, 0.1, 0.1, 0.5, 0.1],
  [3, 0.2, 0.1, 1, 0.1],
  [10, 0.2, 0.2, 2, 0.1],
  [18, 0.6, 0.2, 2, 0.1],
  [80, 0.6, 0.3, 2.5, 0.2],
  [Infinity, 1, 0.4, 4, 0.3],
];

/**
 * Pitch, radius, then diameter difference and breadth outside, and the same inside. DIN 76, printed for HEIDENHAIN
 * lathes (tag L: MANUALplus 620, 12/2017, p. 685, CNC PILOT 640 p. 574, CNC PILOT 4290 p. 438; decision 0005).
 * MANUALplus 4110 p. 525 has 0.3 for pitch 0.45 inside.
 */
const DIN_76: readonly (readonly [
  pitch: number,
  R: number,
  outside: number,
  broad: number,
  inside: number,
  broadInside: number,
])[] = [
  [0.2, 0.1, 0.3, 0.7, 0.1, 1.2],
  [0.25, 0.12, 0.4, 0.9, 0.1, 1.4],
  [0.3, 0.16, 0.5, 1.05, 0.1, 1.6],
  [0.35, 0.16, 0.6, 1.2, 0.2, 1.9],
  [0.4, 0.2, 0.7, 1.4, 0.2, 2.2],
  [0.45, 0.2, 0.7, 1.6, 0.2, 2.4],
  [0.5, 0.2, 0.8, 1.75, 0.3, 2.7],
  [0.6, 0.4, 1, 2.1, 0.3, 3.3],
  [0.7, 0.4, 1.1, 2.45, 0.3, 3.8],
  [0.75, 0.4, 1.2, 2.6, 0.3, 4],
  [0.8, 0.4, 1.3, 2.8, 0.3, 4.2],
  [1, 0.6, 1.6, 3.5, 0.5, 5.2],
  [1.25, 0.6, 2, 4.4, 0.5, 6.7],
  [1.5, 0.8, 2.3, 5.2, 0.5, 7.8],
  [1.75, 1, 2.6, 6.1, 0.5, 9.1],
  [2, 1, 3, 7, 0.5, 10.3],
  [2.5, 1.2, 3.6, 8.7, 0.5, 13],
  [3, 1.6, 4.4, 10.5, 0.5, 15.2],
  [3.5, 1.6, 5, 12, 0.5, 17.7],
  [4, 2, 5.7, 14, 0.5, 20],
  [4.5, 2, 6.4, 16, 0.5, 23],
  [5, 2.5, 7, 17.5, 0.5, 26],
  [5.5, 3.2, 7.7, 19, 0.5, 28],
  [6, 3.2, 8.3, 21, 0.5, 30],
];

/** DIN 509 dimensions for a shaft or bore of this diameter. */
export function undercutOfDiameter(diameter: Diameter): UndercutMeasures {
  const row = DIN_509.find(([upTo]) => diameter <= upTo) ?? DIN_509[DIN_509.length - 1];
  const [, R, DEPTH, BREADTH, FACEDEPTH] = row ?? [0, 0, 0, 0, 0];
  return { R, DEPTH, BREADTH, FACEDEPTH };
}

/** The thread that an undercut belongs to: a shaft, or a bore with its programmed diameter. */
export type ThreadedCylinder = "shaft" | { readonly bore: Diameter };

const isListed =
  (pitch: number) =>
  ([listed]: (typeof DIN_76)[number]): boolean =>
    Math.abs(listed - pitch) <= INCH_ROUNDED;

/** The next smaller and larger pitch of DIN 76 for an unlisted one, mm. */
export function neighboursOfPitch(pitch: number): { readonly below?: number; readonly above?: number } {
  const [below] = DIN_76.findLast(([listed]) => listed < pitch) ?? [];
  const [above] = DIN_76.find(([listed]) => listed > pitch) ?? [];
  return { ...(below !== undefined && { below }), ...(above !== undefined && { above }) };
}

/**
 * DIN 76 dimensions for a thread of this pitch, which an inch program states rounded; null for an unlisted pitch.
 * Inside the floor lies at nominal + I, so its depth counts from the bore: (nominal + I − bore) / 2.
 */
export function undercutOfPitch(pitch: number, cylinder: ThreadedCylinder): UndercutMeasures | null {
  const row = DIN_76.find(isListed(pitch));
  if (!row) return null;
  const [listed, R, outer, broad, inner, broadInside] = row;
  const [apart, BREADTH] =
    cylinder === "shaft" ? [outer, broad] : [nominalOfBore(cylinder.bore, listed) + inner - cylinder.bore, broadInside];
  return { R, DEPTH: apart / 2, BREADTH, FACEDEPTH: 0 };
}
