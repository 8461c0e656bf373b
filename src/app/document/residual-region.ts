import { part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Operation } from "../../program/state/run-types.ts";
import type { Residual } from "../../sim/simulation.ts";
import type { WhichRegion } from "../place/place.ts";
import { siteOfOperation } from "./region.ts";

/** Largest distance between residual material and its contour, mm: the chord error and slivers of the simulation. */
const TOUCHES = 0.05;

/** Splits a straight element at a point on it; an arc, or a point at one of its ends, leaves it whole. */
function splitAt(s: Segment, p: Pt): readonly Segment[] {
  if (s.kind === "arc" || part.apart(s.from, p) < TOUCHES || part.apart(s.to, p) < TOUCHES) return [s];
  return [part.line(s.from, p), part.line(p, s.to)];
}

/** The point of a ring that is farthest back or forward along an element. */
function farthest(s: Segment, ring: Ring, way: 1 | -1): Pt {
  const near = ring.filter((p) => part.distanceTo(s, p) < TOUCHES).map((p) => part.nearestOn(s, p));
  return near.reduce(
    (best, p) => ((part.apart(s.from, p) - part.apart(s.from, best)) * way > 0 ? p : best),
    near[0] ?? s.from,
  );
}

/** The contour section that residual material lies on. */
export function regionOfResidual({ ring }: Residual, operation: Operation, stock: readonly Ring[]): WhichRegion | null {
  const { contour } = operation.plan;
  const touched = contour.flatMap((s, i) => (ring.some((p) => part.distanceTo(s, p) < TOUCHES) ? [i] : []));
  const [first, last] = [touched[0], touched.at(-1)];
  const rest = { site: siteOfOperation(operation), stock, initialStock: "now" } as const;
  if (contour.length === 0) return null;
  if (first === undefined || last === undefined) return { ...rest, contour, first: 0, last: contour.length - 1 };
  const [opening, closing] = [contour[first] as Segment, contour[last] as Segment];
  const ending = splitAt(closing, farthest(closing, ring, 1));
  const split = [...contour.slice(0, last), ...ending, ...contour.slice(last + 1)];
  const starting = splitAt(first === last ? (ending[0] as Segment) : opening, farthest(opening, ring, -1));
  const shift = starting.length - 1;
  return {
    ...rest,
    contour: [...split.slice(0, first), ...starting, ...split.slice(first + 1)],
    first: first + shift,
    last: last + shift,
  };
}
