import { METRIC, METRIC_SIZES } from "../kernel/contour/metric-thread.ts";
import { rounded } from "../kernel/units.ts";
import type { ThreadRoles } from "./define.ts";

/**
 * A thread by its trade name: facts of ISO 261 and 262 (metric), ISO 228 (pipe) and ISO 2904 (trapezoidal). mm and
 * degrees.
 */
export interface ThreadSize {
  readonly name: string;
  /** Alternative spellings. */
  readonly also: readonly string[];
  readonly pitch: number;
  /** Angle between the flanks, which the insert must have. */
  readonly angle: 60 | 55 | 30;
  /** Crest diameter of the external thread, root diameter of the internal one, and the depth of each on the radius. */
  readonly outside: { readonly diameter: number; readonly depth: number };
  readonly inside: { readonly diameter: number; readonly depth: number };
}

/** Name in inches, major diameter, threads per inch. */
const PIPE_SIZES: readonly (readonly [inches: string, diameter: number, perInch: 28 | 19 | 14 | 11])[] = [
  ["1/16", 7.723, 28],
  ["1/8", 9.728, 28],
  ["1/4", 13.157, 19],
  ["3/8", 16.662, 19],
  ["1/2", 20.955, 14],
  ["5/8", 22.911, 14],
  ["3/4", 26.441, 14],
  ["7/8", 30.201, 14],
  ["1", 33.249, 11],
  ["1 1/8", 37.897, 11],
  ["1 1/4", 41.91, 11],
  ["1 1/2", 47.803, 11],
  ["1 3/4", 53.746, 11],
  ["2", 59.614, 11],
  ["2 1/4", 65.71, 11],
  ["2 1/2", 75.184, 11],
  ["2 3/4", 81.534, 11],
  ["3", 87.884, 11],
  ["3 1/2", 100.33, 11],
  ["4", 113.03, 11],
  ["4 1/2", 125.73, 11],
  ["5", 138.43, 11],
  ["5 1/2", 151.13, 11],
  ["6", 163.83, 11],
];
/** Pitch and depth as the standard rounds them. */
const PIPE = { 28: [0.907, 0.581], 19: [1.337, 0.856], 14: [1.814, 1.162], 11: [2.309, 1.479] } as const;

const TRAPEZOIDAL_SIZES: readonly (readonly [diameter: number, pitch: number])[] = [
  [8, 1.5],
  [10, 2],
  [12, 3],
  [14, 3],
  [16, 4],
  [18, 4],
  [20, 4],
  [22, 5],
  [24, 5],
  [26, 5],
  [28, 5],
  [30, 6],
  [32, 6],
  [34, 6],
  [36, 6],
  [38, 7],
  [40, 7],
  [42, 7],
  [44, 7],
  [46, 8],
  [48, 8],
  [50, 8],
  [52, 8],
  [55, 9],
  [60, 9],
  [65, 10],
  [70, 10],
  [75, 10],
  [80, 10],
  [85, 12],
  [90, 12],
  [95, 12],
  [100, 12],
];
/** Clearance at the crest. */
const clearance = (pitch: number) => (pitch < 2 ? 0.15 : pitch <= 5 ? 0.25 : 0.5);

function metric(diameter: number, pitch: number, isCoarse: boolean): ThreadSize {
  const whole = `M${diameter}×${pitch}`;
  const part = (factor: number) => ({ diameter, depth: rounded(pitch * factor) });
  return {
    name: isCoarse ? `M${diameter}` : whole,
    also: isCoarse ? [whole] : [],
    pitch,
    angle: 60,
    outside: part(METRIC.outside),
    inside: part(METRIC.inside),
  };
}

function pipe(inches: string, diameter: number, perInch: keyof typeof PIPE): ThreadSize {
  const [pitch, depth] = PIPE[perInch];
  return { name: `G${inches}`, also: [], pitch, angle: 55, outside: { diameter, depth }, inside: { diameter, depth } };
}

function trapezoidal(diameter: number, pitch: number): ThreadSize {
  const gap = clearance(pitch);
  const depth = rounded(pitch / 2 + gap);
  const root = rounded(diameter + gap + gap);
  return {
    name: `Tr${diameter}×${pitch}`,
    also: [],
    pitch,
    angle: 30,
    outside: { diameter, depth },
    inside: { diameter: root, depth },
  };
}

/** Every size that can be chosen by name. */
export const threadSizes: readonly ThreadSize[] = [
  ...METRIC_SIZES.flatMap(([nominal, coarse, ...fine]) => [
    ...(coarse === null ? [] : [metric(nominal, coarse, true)]),
    ...fine.map((pitch) => metric(nominal, pitch, false)),
  ]),
  ...PIPE_SIZES.map((size) => pipe(...size)),
  ...TRAPEZOIDAL_SIZES.map((size) => trapezoidal(...size)),
];

const HALVES: Readonly<Record<string, string>> = {
  "½": "1/2",
  "¼": "1/4",
  "¾": "3/4",
  "⅛": "1/8",
  "⅜": "3/8",
  "⅝": "5/8",
  "⅞": "7/8",
};
/** A name for comparison, however it is typed: M20x1,5, G 1 1/2", tr 20*4. */
const plain = (name: string) =>
  name
    .replace(/[½¼¾⅛⅜⅝⅞]/g, (c) => HALVES[c] ?? c)
    .toLowerCase()
    .replace(/[\s"″]/g, "")
    .replace(/[×*]/g, "x")
    .replaceAll(",", ".");

/** Unified threads by inches and threads per inch, with the metric profile: 1/4-20 UNC, 1 1/2-12 UN, #10-32. */
const UNIFIED =
  /^(?:un[a-z]*)?\s*(?:#(\d{1,2})|(?:(\d+)[\s-]+)?(\d+)\/(\d+)|(\d+(?:[.,]\d+)?))\s*["″]?\s*-\s*(\d+(?:[.,]\d+)?)\s*(un[a-z]*)?$/i;
/** Diameter of number 0, and the step from one number to the next, inches. */
const [NUMBER_ZERO, NUMBER_STEP] = [0.06, 0.013];
/** Sizes that are no misprint: diameter, pitch, threads per inch. */
const [LARGEST, COARSEST, FINEST] = [1000, 24, 80];
/** Threads per inch from which a whole number is a number size. */
const FINE = 24;

/** Largest pitch of a thread, in diameters. */
const STEEPEST = 0.4;

const numberIn = (text: string | undefined): number => Number((text ?? "0").replace(",", "."));

function unified(typed: string): ThreadSize | null {
  const m = UNIFIED.exec(typed.trim());
  if (!m) return null;
  const [, marked, whole, above, below, plainInches, perInch] = m;
  // Without its mark, 10-32 is number 10: no inch size has so fine a thread.
  const isNumber = plainInches !== undefined && /^\d+$/.test(plainInches) && numberIn(perInch) >= FINE;
  const number = marked ?? (isNumber ? plainInches : undefined);
  const inches =
    number !== undefined
      ? NUMBER_ZERO + NUMBER_STEP * Number(number)
      : above !== undefined
        ? numberIn(whole) + Number(above) / Number(below)
        : numberIn(plainInches);
  const [diameter, pitch] = [rounded(25.4 * inches), rounded(25.4 / numberIn(perInch))];
  if (!(numberIn(perInch) <= FINEST) || !isPlausible(diameter, pitch)) return null;
  const name = typed.trim().replace(/["″]/g, "").toUpperCase();
  return { ...metric(diameter, pitch, false), name: /UN/.test(name) ? name : `${name} UN` };
}

const isPlausible = (diameter: number, pitch: number): boolean =>
  diameter > 0 && diameter <= LARGEST && pitch > 0 && pitch <= COARSEST && pitch < STEEPEST * diameter;

/** A metric, trapezoidal or unified thread of any diameter and pitch; null where the text names none. */
function computedSize(typed: string): ThreadSize | null {
  const m = /^(m|tr)(\d+(?:\.\d+)?)x(\d+(?:\.\d+)?)$/.exec(plain(typed));
  if (!m) return unified(typed);
  const [diameter, pitch] = [numberIn(m[2]), numberIn(m[3])];
  if (!isPlausible(diameter, pitch)) return null;
  return m[1] === "m" ? metric(diameter, pitch, false) : trapezoidal(diameter, pitch);
}

/**
 * Sizes whose name begins with the typed text, exact matches first. A size that no table lists is computed from its
 * diameter and pitch.
 */
export function sizesNamed(typed: string): ThreadSize[] {
  const asked = plain(typed);
  if (asked === "") return [];
  const names = ({ name, also }: ThreadSize) => [name, ...also].map(plain);
  const found = threadSizes.filter((size) => names(size).some((name) => name.startsWith(asked)));
  const isExact = (size: ThreadSize) => names(size).includes(asked);
  const computed = found.some(isExact) ? null : computedSize(typed);
  return [...(computed ? [computed] : []), ...found.filter(isExact), ...found.filter((size) => !isExact(size))];
}

/**
 * The values of a size for a cycle, by Q. `flank`: the current infeed angle; it may be at most half the point angle.
 */
export function valuesOf(
  size: ThreadSize,
  roles: ThreadRoles,
  inside: boolean,
  flank: number,
): Readonly<Record<string, number>> {
  const { diameter, depth } = inside ? size.inside : size.outside;
  const half = size.angle * 0.5;
  return {
    [roles.pitch]: size.pitch,
    [roles.depth]: depth,
    [roles.starts]: 1,
    ...Object.fromEntries(roles.diameters.map((q) => [q, diameter])),
    ...(flank > half && { [roles.flank]: half }),
  };
}
