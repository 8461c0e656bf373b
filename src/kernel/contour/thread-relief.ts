import { INCH_ROUNDED } from "../tolerance.ts";

/** Forms of DIN 76-1: outside A (regular) and B (short), inside C (regular) and D (short). */
export const RELIEF_FORMS = ["A", "B", "C", "D"] as const;
export type ReliefForm = (typeof RELIEF_FORMS)[number];

/** Undercut behind a metric thread, mm. */
export interface ThreadRelief {
  readonly form: ReliefForm;
  readonly pitch: number;
  /** Radius of both inner corners. */
  readonly R: number;
  /** Difference of diameters: the floor is at nominal − apart outside, at nominal + apart inside (dg). */
  readonly apart: number;
  /** Least width at the floor (g1). */
  readonly floor: number;
  /** Greatest width from the face to where the thread begins (g2). */
  readonly broad: number;
}

type Widths = readonly [floor: number, broad: number];

/**
 * Pitch, radius, difference of diameters outside and inside, then g1 and g2 of forms A, B, C and D. g2 of A and C, the
 * radius and the differences are printed for HEIDENHAIN lathes (tag L: MANUALplus 620, 12/2017, p. 685, CNC PILOT 640
 * p. 574, CNC PILOT 4290 p. 438; decision 0005). g1, and B and D, are of DIN 76-1:2004-06 tables 1 and 2, as two public
 * transcriptions have them (tag S; decision 0052). Two values differ between sources: pitch 0.45 inside has 0.3 on
 * MANUALplus 4110 p. 525, and g2 of D at 1.75 has 6.1 in one of the transcriptions.
 */
const DIN_76: readonly (readonly [
  pitch: number,
  R: number,
  outside: number,
  inside: number,
  A: Widths,
  B: Widths,
  C: Widths,
  D: Widths,
])[] = [
  [0.2, 0.1, 0.3, 0.1, [0.45, 0.7], [0.25, 0.5], [0.8, 1.2], [0.5, 0.9]],
  [0.25, 0.12, 0.4, 0.1, [0.55, 0.9], [0.25, 0.6], [1, 1.4], [0.6, 1]],
  [0.3, 0.16, 0.5, 0.1, [0.6, 1.05], [0.3, 0.75], [1.2, 1.6], [0.75, 1.25]],
  [0.35, 0.16, 0.6, 0.2, [0.7, 1.2], [0.4, 0.9], [1.4, 1.9], [0.9, 1.4]],
  [0.4, 0.2, 0.7, 0.2, [0.8, 1.4], [0.5, 1], [1.6, 2.2], [1, 1.6]],
  [0.45, 0.2, 0.7, 0.2, [1, 1.6], [0.5, 1.1], [1.8, 2.4], [1.1, 1.7]],
  [0.5, 0.2, 0.8, 0.3, [1.1, 1.75], [0.5, 1.25], [2, 2.7], [1.25, 2]],
  [0.6, 0.4, 1, 0.3, [1.2, 2.1], [0.6, 1.5], [2.4, 3.3], [1.5, 2.4]],
  [0.7, 0.4, 1.1, 0.3, [1.5, 2.45], [0.8, 1.75], [2.8, 3.8], [1.75, 2.75]],
  [0.75, 0.4, 1.2, 0.3, [1.6, 2.6], [0.9, 1.9], [3, 4], [1.9, 2.9]],
  [0.8, 0.4, 1.3, 0.3, [1.7, 2.8], [0.9, 2], [3.2, 4.2], [2, 3]],
  [1, 0.6, 1.6, 0.5, [2.1, 3.5], [1.1, 2.5], [4, 5.2], [2.5, 3.7]],
  [1.25, 0.6, 2, 0.5, [2.7, 4.4], [1.5, 3.2], [5, 6.7], [3.2, 4.9]],
  [1.5, 0.8, 2.3, 0.5, [3.2, 5.2], [1.8, 3.8], [6, 7.8], [3.8, 5.6]],
  [1.75, 1, 2.6, 0.5, [3.9, 6.1], [2.1, 4.3], [7, 9.1], [4.3, 6.4]],
  [2, 1, 3, 0.5, [4.5, 7], [2.5, 5], [8, 10.3], [5, 7.3]],
  [2.5, 1.2, 3.6, 0.5, [5.6, 8.7], [3.2, 6.3], [10, 13], [6.3, 9.3]],
  [3, 1.6, 4.4, 0.5, [6.7, 10.5], [3.7, 7.5], [12, 15.2], [7.5, 10.7]],
  [3.5, 1.6, 5, 0.5, [7.7, 12], [4.7, 9], [14, 17.7], [9, 12.7]],
  [4, 2, 5.7, 0.5, [9, 14], [5, 10], [16, 20], [10, 14]],
  [4.5, 2, 6.4, 0.5, [10.5, 16], [5.5, 11], [18, 23], [11, 16]],
  [5, 2.5, 7, 0.5, [11.5, 17.5], [6.5, 12.5], [20, 26], [12.5, 18.5]],
  [5.5, 3.2, 7.7, 0.5, [12.5, 19], [7.5, 14], [22, 28], [14, 20]],
  [6, 3.2, 8.3, 0.5, [14, 21], [8, 15], [24, 30], [15, 21]],
];

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

/** The undercut of DIN 76-1 for a pitch in mm, which an inch program states rounded; null for an unlisted pitch. */
export function threadRelief(pitch: number, form: ReliefForm): ThreadRelief | null {
  const row = DIN_76.find(isListed(pitch));
  if (!row) return null;
  const [listed, R, outside, inside, A, B, C, D] = row;
  const [floor, broad] = { A, B, C, D }[form];
  return { form, pitch: listed, R, apart: form === "A" || form === "B" ? outside : inside, floor, broad };
}
