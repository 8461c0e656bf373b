import { chamferOf, type Site, type ShapeRequest } from "../../cycles/shape-request.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { difference, offset, union } from "../../kernel/area/clip.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { METRIC } from "../../kernel/contour/metric-thread.ts";
import { cutThread } from "../../kernel/thread/named-thread.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { axial, diameter, radians, radius, rounded, toDiameter, toRadius } from "../../kernel/units.ts";
import { newRow, type BlankDraft, type ContourRow } from "./job.ts";
import { positionAsTyped } from "../values/typed-value.ts";

/** Default material around a shape, mm: beside it, behind it, on the far side of a bore. */
const ROUND_IT = 10;
const BEHIND = 30;
/** Extent of the open side of a shape, mm: beyond every blank. */
const OPEN = 10_000;

/** Half section of the requested shape, mm. */
interface Box {
  readonly z1: number;
  readonly z2: number;
  readonly r1: number;
  readonly r2: number;
  /** 1 towards −Z, −1 towards +Z. */
  readonly along: number;
  /** 1 for material towards the axis, −1 in a bore. */
  readonly out: number;
}

export function requestedBox({ from, to, site, shape }: ShapeRequest): Box {
  const [r1, r2] = [toRadius(from.diameter), toRadius(to.diameter)];
  const outer = shape === "thread" ? site !== "inside" : r1 > r2;
  return { z1: from.z, z2: to.z, r1, r2, along: to.z < from.z ? 1 : -1, out: outer ? 1 : -1 };
}

/** Whether a shape is open towards the face: its depth runs along Z. */
const opensAhead = ({ site, shape }: ShapeRequest) => site === "face" && shape !== "step" && shape !== "thread";

function corners(wanted: ShapeRequest): Pt[] {
  const { z1, z2, r1, r2, along, out } = requestedBox(wanted);
  const lean = Math.tan(radians(wanted.angle));
  const [across, down] = [Math.abs(r1 - r2) * lean * along, Math.abs(z1 - z2) * lean * out];
  const second = wanted.shape === "groove" ? 1 : 0;
  if (wanted.shape === "step") {
    const c = chamferOf(wanted);
    const edge = c > 0 ? [at(z1, r2 - c * out), at(z1 - c * along, r2)] : [at(z1, r2)];
    return [...edge, at(z2, r2 + down), at(z2, r1)];
  }
  return opensAhead(wanted)
    ? [at(z1, r1), at(z2, r1 - down), at(z2, r2 + second * down), at(z1, r2)]
    : [at(z1, r1), at(z1 - across, r2), at(z2 + second * across, r2), at(z2, r1)];
}

/** Finished contour of the requested shape, from start to end; empty for a thread. */
export function requestedContour(wanted: ShapeRequest): readonly Segment[] {
  if (wanted.shape === "thread") return [];
  if (wanted.shape === "free") return wanted.contour ?? [];
  const points = corners(wanted);
  return points.slice(1).map((to, i) => part.line(points[i] as Pt, to));
}

/** Corners of a contour, its arcs as chords. */
const pointsOf = (contour: readonly Segment[]): Pt[] => part.flattenedChain(contour, CHORD);

/** Box around a contour section, as the corners of a requested shape: its open side first. */
export function boxAroundContour(contour: readonly Segment[], site: Site): Pick<ShapeRequest, "from" | "to"> {
  const { left, right, low, high } = boxOf(pointsOf(contour));
  const [open, deep] = site === "inside" ? [low, high] : [high, low];
  const corner = (r: number, z: number) => ({
    diameter: diameter(rounded(toDiameter(radius(r)))),
    z: axial(rounded(z)),
  });
  return { from: corner(open, right), to: corner(deep, left) };
}

/**
 * Material to remove: between the finished contour and the open side, up to `open` mm beyond the box. Null without any.
 */
function between(wanted: ShapeRequest, open: number): Ring | null {
  const points = pointsOf(requestedContour(wanted));
  const [first, last] = [points[0], points.at(-1)];
  if (!first || !last) return null;
  const { z1, r1, along, out } = requestedBox(wanted);
  if (opensAhead(wanted)) return [...points, at(z1 + along * open, last.r), at(z1 + along * open, first.r)];
  const r = Math.max(0, r1 + out * open);
  const ahead = wanted.shape === "step" ? first.z + along * open : first.z;
  return [...points, at(last.z, r), at(ahead, r), at(ahead, first.r)];
}

export const requestedArea = (wanted: ShapeRequest): Ring | null => between(wanted, 0);

interface CylinderSize {
  readonly outside: number;
  readonly bore: number;
  readonly front: number;
  readonly back: number;
}

const asTyped = ({ outside, bore, front, back }: CylinderSize): BlankDraft => ({
  outside: positionAsTyped(toDiameter(radius(outside))),
  bore: bore > 0 ? positionAsTyped(toDiameter(radius(bore))) : "0",
  length: positionAsTyped(front - back),
  allowance: positionAsTyped(front),
});

/** Cylinder around a stock, as typed. */
export function cylinderAround(stock: readonly Ring[]): BlankDraft {
  const { left, right, low, high } = boxOf(stock.flat());
  return asTyped({ outside: high, bore: Math.max(0, low), front: right, back: left });
}

/** Radius of the bore before a named thread, of a taper at its far end; null for any other shape. */
function coreOf({ thread }: ShapeRequest): number | null {
  if (!thread?.inside) return null;
  const { crest } = cutThread(thread.inside, "middle");
  return toRadius(diameter(crest - (thread.gauge?.usefulInside ?? 0) * thread.taper));
}

/** Cylinder around the requested shape, or around the stock where that is known, as typed. */
export function blankFor(wanted: ShapeRequest, stock: readonly Ring[] | null): BlankDraft {
  if (stock && stock.length > 0) return cylinderAround(stock);
  const { z1, z2, r1, r2, along, out } = requestedBox(wanted);
  const within = opensAhead(wanted);
  const hole = wanted.shape === "thread" ? (coreOf(wanted) ?? r1 - METRIC.inside * wanted.pitch) : r1;
  const begins = wanted.shape === "step" || wanted.site === "face";
  const [near, far] = [begins ? z1 : along > 0 ? Math.max(z1, 0) : z1 - BEHIND, z2 - along * BEHIND];
  return asTyped({
    outside: within ? Math.max(r1, r2) + ROUND_IT : out > 0 ? r1 : r2 + ROUND_IT,
    bore: within || out > 0 ? 0 : Math.max(0, hole),
    front: Math.max(near, far),
    back: Math.min(near, far),
  });
}

/** Blank with the shape plus its allowance; a cylinder where it is solid. */
export function blankRings(wanted: ShapeRequest, cylinder: readonly Ring[]): readonly Ring[] {
  const open = wanted.allowance > 0 ? between(wanted, OPEN) : null;
  return open ? difference(cylinder, offset(union([open]), -wanted.allowance)) : cylinder;
}

/** The contour as table rows. Elements shorter than what is typed are none: an arc back to its own begin is a circle. */
export function rowsOf(contour: readonly Segment[]): ContourRow[] {
  const [first] = contour;
  if (!first) return [];
  const x = ({ r }: Pt) => positionAsTyped(toDiameter(r));
  const row = (i: number, to: Pt, given: Partial<ContourRow> = {}) =>
    newRow(`e${i}`, { x: x(to), z: positionAsTyped(to.z), ...given });
  let last = row(1, first.from);
  return [
    last,
    ...contour.flatMap((s, i): ContourRow[] => {
      const end = row(i + 2, s.to, s.kind === "line" ? {} : { kind: "C", turn: s.turn });
      if (end.x === last.x && end.z === last.z) return [];
      last = end;
      return s.kind === "line"
        ? [end]
        : [newRow(`c${i + 2}`, { kind: "CC", x: x(s.centre), z: positionAsTyped(s.centre.z) }), end];
    }),
  ];
}
