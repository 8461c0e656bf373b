import { boxAround } from "../../kernel/area/box.ts";
import { simplified } from "../../kernel/area/clip.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Place } from "../camera.ts";
import { type PrintShape } from "./paper.ts";
import { lineThrough, onPaperGrid } from "../dimensions/strokes.ts";

/** A thread in a surface: its start and end, its root radius, mm, if it has one, and its name. */
export interface PrintThread {
  readonly from: Pt;
  readonly to: Pt;
  readonly ground: number | null;
  readonly name: string;
}

/** Tolerance for a corner of the outline on the silhouette or on the axis, mm. */
const ON = 0.02;
/** Chord tolerance of outlines, mm on paper. */
const FINE = 0.004;
/** Offset of the probes for material beside a corner, mm. */
export const BESIDE = 0.02;
/** Step of the search for the ends of a thread's line, mm. */
const STEP_IN = 0.05;
/** Limit of steps: a part longer than a lathe is searched in coarser ones. */
const MOST_STEPS = 40_000;
/** An edge that is shorter along the axis is upright, mm: the first chord of an arc is a thousandth long there. */
const UPRIGHT = 0.00001;

export const mirroredAt = (p: Pt): Pt => at(p.z, -p.r);

/** Highest and lowest radius of the part at a Z; null where there is no material. */
export function spanAt(rings: readonly Ring[], z: number): { readonly high: number; readonly low: number } | null {
  let [high, low] = [-Infinity, Infinity];
  for (const ring of rings)
    ring.forEach((a, i) => {
      const b = ring[(i + 1) % ring.length] ?? a;
      if (Math.min(a.z, b.z) > z || Math.max(a.z, b.z) < z) return;
      const r = Math.abs(b.z - a.z) < UPRIGHT ? [a.r, b.r] : [a.r + ((z - a.z) / (b.z - a.z)) * (b.r - a.r)];
      high = Math.max(high, ...r);
      low = Math.min(low, ...r);
    });
  return high >= low ? { high, low } : null;
}

/** Whether part of the body is hidden from outside: a bore, or a recess in a face. */
export const isHollow = (body: readonly Ring[]): boolean =>
  body.some((ring) => ring.some((p) => p.r > ON && !isOutmost(body, p)));

/** Lines of rings, except on the axis or on the break. */
function drawnEdges(ring: Ring, broken: number | null): Pt[][] {
  const hidden = (a: Pt, b: Pt) =>
    (Math.abs(a.r) < ON && Math.abs(b.r) < ON) ||
    (broken !== null && Math.abs(a.z - broken) < ON && Math.abs(b.z - broken) < ON);
  const lines: Pt[][] = [];
  const start = Math.max(0, ring.findIndex((p, i) => hidden(p, ring[(i + 1) % ring.length] ?? p)) + 1);
  for (let k = 0; k < ring.length; k += 1) {
    const a = ring[(start + k) % ring.length],
      b = ring[(start + k + 1) % ring.length];
    if (!a || !b || hidden(a, b)) continue;
    const last = lines.at(-1);
    if (last?.at(-1) === a) last.push(b);
    else lines.push([a, b]);
  }
  return lines;
}

/** A freehand break line where the blank continues. */
function breakLine(x: number, top: number, bottom: number): string {
  const step = (bottom - top) / 4,
    by = 1.1;
  const curve = [1, -1, 1, -1].map(
    (side, i) =>
      `Q${onPaperGrid(x + side * by)} ${onPaperGrid(top + (i + 0.5) * step)} ${onPaperGrid(x)} ${onPaperGrid(top + (i + 1) * step)}`,
  );
  return `M${onPaperGrid(x)} ${onPaperGrid(top)}${curve.join("")}`;
}

/** A level line without its ends outside the part, as over a chamfer. */
function within(body: readonly Ring[], ends: readonly [Pt, Pt]): readonly [Pt, Pt] {
  const { left, right } = boxAround([...body]);
  const [a, b] = ends.map(({ z, r }) => at(Math.min(right, Math.max(left, z)), r)) as [Pt, Pt];
  const long = Math.abs(b.z - a.z),
    step = Math.max(STEP_IN, long / MOST_STEPS),
    steps = Math.ceil(long / step);
  const way = Math.sign(b.z - a.z) * step;
  const isIn = (z: number) => {
    const span = spanAt(body, z);
    return span !== null && span.low <= a.r && a.r <= span.high;
  };
  const first = Array.from({ length: steps }, (_, i) => a.z + i * way).find(isIn) ?? a.z;
  const last = Array.from({ length: steps }, (_, i) => b.z - i * way).find(isIn) ?? b.z;
  return [at(first, a.r), at(last, a.r)];
}

/** How a part is drawn. */
export interface BodyView {
  readonly broken: number | null;
  /** Both halves in section, the upper one, or none. */
  readonly section: "whole" | "upper" | "none";
  /** Whether the edge at a corner of the outline is drawn; all if left out. */
  readonly hasEdge?: (corner: Pt) => boolean;
  readonly onPaper: (p: Pt) => Place;
  readonly scale: number;
  readonly threads: readonly PrintThread[];
}

/** The part itself: hatched where it is in section, its outline, and its visible edges. */
export function bodyShapes(
  body: readonly Ring[],
  { broken, section, hasEdge, onPaper, scale, threads }: BodyView,
): PrintShape[] {
  const fine = simplified([...body], FINE / scale);
  const shapes: PrintShape[] = [];
  const isWhole = section === "whole",
    hollow = section === "upper";
  const closed = (ring: Ring) => `${lineThrough(ring.map(onPaper))}Z`;
  const cut = section === "none" ? [] : isWhole ? [...fine, ...fine.map((ring) => ring.map(mirroredAt))] : fine;
  if (cut.length > 0) shapes.push({ role: "section", d: cut.map(closed).join("") });
  const edges = fine.flatMap((ring) => drawnEdges(ring, broken));
  // From outside the bore is hidden: below the axis, only points without material above them.
  const isSilhouette = (line: readonly Pt[]) => line.filter((p) => isOutmost(body, p));
  const lower = edges
    .map((line) => (hollow ? isSilhouette(line) : line).map(mirroredAt))
    .filter((line) => line.length > 1);
  shapes.push({ role: "outline", d: [...edges, ...lower].map((line) => lineThrough(line.map(onPaper))).join("") });
  const corners = edges.flatMap((line) =>
    line.filter((p, i) => isSharp(line[i - 1], p, line[i + 1]) && !(broken !== null && Math.abs(p.z - broken) < ON)),
  );
  const across = (p: Pt, ends: readonly [number, number]) => lineThrough(ends.map((r) => onPaper(at(p.z, r))));
  const seen = corners.flatMap((p) => {
    if (p.r < ON || hasEdge?.(p) === false) return [];
    if (isWhole) return isInmost(body, p) ? [across(p, [p.r, -p.r])] : [];
    if (isOutmost(body, p)) return [across(p, [hollow ? 0 : p.r, -p.r])];
    return hollow && isInmost(body, p) ? [across(p, [0, p.r])] : [];
  });
  shapes.push({ role: "edge", d: [...new Set(seen)].join("") });
  for (const { from, to, ground } of threads) {
    if (ground === null) continue;
    const line = within(body, [at(from.z, ground), at(to.z, ground)]);
    // The thread of a bore is hidden from outside.
    const below = hollow && ground > from.r ? "" : lineThrough(line.map((p) => onPaper(mirroredAt(p))));
    shapes.push({ role: "thin", d: lineThrough(line.map(onPaper)) + below });
  }
  if (broken !== null) {
    const high = onPaper(at(broken, spanAt(body, broken + BESIDE)?.high ?? 0)),
      low = onPaper(at(broken, 0));
    shapes.push({ role: "break", d: breakLine(high.x, high.y, low.y + (low.y - high.y)) });
  }
  return shapes;
}

/** Whether no material lies above a point, to one side of it at least. */
export const isOutmost = (body: readonly Ring[], p: Pt): boolean =>
  [p.z - BESIDE, p.z, p.z + BESIDE].some((z) => (spanAt(body, z)?.high ?? Infinity) - p.r < ON + BESIDE);
const isInmost = (body: readonly Ring[], p: Pt): boolean =>
  [p.z - BESIDE, p.z, p.z + BESIDE].some((z) => Math.abs((spanAt(body, z)?.low ?? Infinity) - p.r) < ON + BESIDE);

/** The turn at a corner, radians: less is a point of a flattened arc. */
const SHARP = 0.5;

function isSharp(a: Pt | undefined, p: Pt, b: Pt | undefined): boolean {
  if (!a || !b) return a !== b;
  const turn = Math.abs(Math.atan2(b.r - p.r, b.z - p.z) - Math.atan2(p.r - a.r, p.z - a.z));
  return Math.min(turn, Math.PI + Math.PI - turn) > SHARP;
}
