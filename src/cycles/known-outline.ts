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

/** What of a contour a few values determine. */
export interface KnownOutline {
  readonly positions: readonly KnownPosition[];
  /** The corners whose diameter and Z are both typed, start and end: X as diameter, mm. */
  readonly corners: readonly { readonly x: number; readonly z: number }[];
  /** The elements that are as they are drawn, whatever is still missing. */
  readonly contour: readonly Segment[];
  /** The contour with square walls and sharp corners where nothing is typed yet; empty while a position is missing. */
  readonly sketch: readonly Segment[];
  /** Nothing that is missing changes the contour. */
  readonly whole: boolean;
}

const same = (a: Pt, b: Pt): boolean => Math.hypot(a.z - b.z, a.r - b.r) < JOINED;

/** Whether two elements are one, in whatever direction they run. */
export function sameSegment(a: Segment, b: Segment): boolean {
  const half = (s: Segment) => part.pointOn(s, 0.5);
  const ends = (same(a.from, b.from) && same(a.to, b.to)) || (same(a.from, b.to) && same(a.to, b.from));
  return ends && same(half(a), half(b));
}

/** What is determined of the contour of a cycle by those of its values that are typed. */
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
  const [first = [], ...others] = made;
  const sure = first.filter((s) => others.every((all) => all.some((o) => sameSegment(o, s))));
  const whole = sure.length > 0 && made.every((all) => all.length === sure.length);
  // A programmed contour is typed by itself: it is known even where no cycle can cut it yet.
  const contour = made.length === 0 && cycle.contour === "free" ? (given.contour ?? []) : sure;
  const sketch = whole ? [] : (plainCompletion(cycle, known, given)?.outline.contour ?? []);
  return { positions: positions.map(({ q, axis, value }) => ({ q, axis, value })), corners, contour, sketch, whole };
}
