import { part, type Pt, type Segment } from "../kernel/geometry/point.ts";
import { JOINED } from "../kernel/tolerance.ts";
import { completions, isPosition, plainCompletion } from "./completions.ts";
import type { Cycle, Given } from "./define.ts";
import type { SomeValues } from "./effect.ts";
import type { Param } from "./params.ts";

/** A typed position: a diameter or a Z. */
export interface KnownPosition {
  readonly q: string;
  readonly axis: "x" | "z";
  readonly value: number;
}

/** The parts of a contour that the typed values determine. */
export interface KnownOutline {
  readonly positions: readonly KnownPosition[];
  /** The start and end corners whose diameter and Z are both typed: X as diameter, mm. */
  readonly corners: readonly { readonly x: number; readonly z: number }[];
  /** The elements that no missing value can change. */
  readonly contour: readonly Segment[];
  /** The contour with square walls and sharp corners where no value is typed yet; empty while a position is missing. */
  readonly sketch: readonly Segment[];
  /** Whether no missing value changes the contour. */
  readonly whole: boolean;
}

const same = (a: Pt, b: Pt): boolean => Math.hypot(a.z - b.z, a.r - b.r) < JOINED;

const half = (s: Segment): Pt => part.pointOn(s, 0.5);

/** Whether two elements are equal, in either direction. */
export function sameSegment(a: Segment, b: Segment): boolean {
  const ends = (same(a.from, b.from) && same(a.to, b.to)) || (same(a.from, b.to) && same(a.to, b.from));
  return ends && same(half(a), half(b));
}

/** Side of the squares in which elements are looked up by their middles, mm: much more than the tolerance. */
const SQUARE = 50 * JOINED;

/** Whether a contour has an element; in a long one, too, without looking at all of them. */
function lookupIn(contour: readonly Segment[]): (s: Segment) => boolean {
  const squares = new Map<string, Segment[]>();
  const square = ({ z, r }: Pt, dz = 0, dr = 0) => `${Math.floor(z / SQUARE) + dz} ${Math.floor(r / SQUARE) + dr}`;
  for (const s of contour) {
    const key = square(half(s)),
      there = squares.get(key);
    if (there) there.push(s);
    else squares.set(key, [s]);
  }
  const BESIDE = [0, -1, 1];
  return (s) => {
    const at = half(s);
    return BESIDE.some((dz) =>
      BESIDE.some((dr) => squares.get(square(at, dz, dr))?.some((o) => sameSegment(o, s)) ?? false),
    );
  };
}

/** The parts of a cycle's contour that its typed values determine. */
export function knownOutline(cycle: Cycle, known: SomeValues, given: Given): KnownOutline {
  const params = Object.entries<Param>(cycle.params);
  const positions = params.flatMap(([q, p]): (KnownPosition & { readonly place: string })[] => {
    const value = known[q];
    if (!isPosition(p) || typeof value !== "number") return [];
    return [{ q, axis: p.kind === "diameter" ? "x" : "z", value, place: p.place }];
  });
  const corners = ["start", "end"].flatMap((place) => {
    const [x, z] = (["x", "z"] as const).map(
      (axis) => positions.find((p) => p.axis === axis && p.place === place)?.value,
    );
    return x === undefined || z === undefined ? [] : [{ x, z }];
  });
  const made = completions(cycle, known, given).map(({ outline }) => outline.contour);
  const [first = [], ...others] = new Set(made);
  const lookups = others.map(lookupIn);
  const sure = first.filter((s) => lookups.every((has) => has(s)));
  const whole = sure.length > 0 && made.every((all) => all.length === sure.length);
  // A programmed contour is known even where no cycle can cut it yet.
  const contour = made.length === 0 && cycle.contour === "free" ? (given.contour ?? []) : sure;
  const sketch = whole ? [] : (plainCompletion(cycle, known, given)?.outline.contour ?? []);
  return { positions: positions.map(({ q, axis, value }) => ({ q, axis, value })), corners, contour, sketch, whole };
}
