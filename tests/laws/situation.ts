import fc from "fast-check";
import type { Given } from "../../src/cycles/define.ts";
import type { Pt, Ring } from "../../src/kernel/point.ts";
import type { TipOrientation, Tool } from "../../src/kernel/tool.ts";
import { axial, length, radius } from "../../src/kernel/units.ts";
import { shippedTools } from "../../src/program/shipped-tools.ts";

/**
 * One random set-up of a cycle: values, contour, tool, start point and the blank that fits them. Plain data: it can be written
 * to a file.
 */
export interface Situation {
  readonly values: Readonly<Record<string, number>>;
  readonly given: Given;
  readonly tool: Tool;
  readonly start: Pt;
  readonly blank: readonly Ring[];
}

export const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
export const round = (n: number) => Math.round(n * 1000) / 1000;

/** A box, whichever of its corners comes first. */
export const box = (z0: number, z1: number, r0: number, r1: number): Ring => {
  const [left, right, low, high] = [Math.min(z0, z1), Math.max(z0, z1), Math.min(r0, r1), Math.max(r0, r1)];
  return [at(left, low), at(right, low), at(right, high), at(left, high)];
};

/** A length on the control's grid, and an angle from 0. */
export const mm = (min: number, max: number) =>
  fc.integer({ min: Math.round(min * 1000), max: Math.round(max * 1000) }).map((n) => n / 1000);
export const deg = (max: number) => fc.integer({ min: 0, max: max * 1e4 }).map((n) => n / 1e4);
export const sign = fc.constantFrom(1, -1);
export const orZero = (of: fc.Arbitrary<number>) => fc.oneof(fc.constant(0), of);
/** Mostly the first, now and then the other. */
export const mostly = <T>(usual: fc.Arbitrary<T>, other: fc.Arbitrary<T>) =>
  fc.oneof({ weight: 5, arbitrary: usual }, { weight: 2, arbitrary: other });

/** Values that every cycle has. */
export const common = {
  Q460: mm(0.5, 4),
  Q478: fc.constant(0.3),
  Q483: orZero(mm(0, 1.5)),
  Q484: orZero(mm(0, 0.7)),
  Q505: fc.constant(0.1),
  Q463: mm(0.3, 5),
};
/** Start element, corner and end element of the cycles that have their own contour. */
export const elements = {
  Q501: fc.constantFrom(0, 1, 2),
  Q502: mm(0, 2),
  Q500: orZero(mm(0, 3)),
  Q503: fc.constantFrom(0, 1, 2),
  Q504: mm(0, 2),
};

/** A shipped tool, with its tip turned another way and a shorter edge where they are given. */
export const toolAs = (t: number, TO: TipOrientation, edge: number | null = null): Tool => {
  const tool = shippedTools.find((x) => x.T === t) as Tool;
  return { ...tool, TO, ...(edge !== null && { CUTLENGTH: length(edge) }) };
};
/** Now and then a short cutting edge; null keeps the tool's own. */
export const edge = mostly<number | null>(fc.constant(null), mm(2, 5));
/** Now and then a tool that points somewhere else. */
export const anyOrientation = mostly<TipOrientation | null>(fc.constant(null),
  fc.constantFrom<TipOrientation | null>(null, null, 1, 2, 3, 4, 5, 6, 7, 8));

/** Where the tip may stand at the cycle call: where it should, or anywhere round the blank and in it. */
export interface Place {
  readonly kind: "usual" | "anywhere";
  /** Share of the way through the surroundings, 0 … 1, along z and r. */
  readonly z: number;
  readonly r: number;
}
const share = fc.integer({ min: 0, max: 1000 }).map((n) => n / 1000);
export const place: fc.Arbitrary<Place> = fc.record({
  kind: mostly<Place["kind"]>(fc.constant("usual"), fc.constant("anywhere")),
  z: share,
  r: share,
});

/** Room round the blank that a start point is looked for in, mm. */
const ROOM = 15;

/** The start point: the usual one, or one anywhere within the blank and `ROOM` beyond it. */
export function startAt(p: Place, usual: Pt, blank: Ring): Pt {
  if (p.kind === "usual") return usual;
  const [z0, z1, r1] = [Math.min(...blank.map((q) => q.z)), Math.max(...blank.map((q) => q.z)), Math.max(...blank.map((q) => q.r))];
  return at(round(z0 - ROOM + p.z * (z1 - z0 + 2 * ROOM)), round(p.r * (r1 + ROOM)));
}
