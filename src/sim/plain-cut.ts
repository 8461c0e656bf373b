import { areaOf } from "../kernel/area/area.ts";
import { boxAround, inBox } from "../kernel/area/box.ts";
import { difference, intersection, isInside, offset } from "../kernel/area/clip.ts";
import { hypotenuse } from "../kernel/geometry/vectors.ts";
import { isBar, tipDirection } from "../kernel/cutter/insert.ts";
import { at, part, type Pt, type Ring } from "../kernel/geometry/point.ts";
import { REAL_AREA, real } from "../kernel/area/real-area.ts";
import type { Step } from "../kernel/time/step.ts";
import { CHORD } from "../kernel/tolerance.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { merged, type Cutting } from "./cutting.ts";
import { brokenApart, type WorkHold } from "./held.ts";
import type { Outlines } from "./outlines.ts";
import type { SimulatedOperation } from "./simulation.ts";
import { sweptBy, turned } from "./sweep.ts";

/*
 * Feed moves outside cycles cut what the program wants cut: whether one that goes below the contour of a cycle may be
 * meant is told here.
 */

/**
 * A region lies against a surface where they are this near, mm; both carry chord errors, and the finished part is
 * shrunk.
 */
const AGAINST = 0.02;
/** Moves that are looked at for an end of the part: it is cut in few. */
const FEW = 40;
/** Less of a surface than this is the corner at which it ends, mm. */
const LEAST_SURFACE = 0.1;

/** The contour of an operation as a line. */
export interface Surface {
  readonly operation: number;
  readonly line: readonly Pt[];
  /** It lies in a bore. */
  readonly isInside: boolean;
}

/** The surfaces that operations make; `first` is the index of the first of them in the run. */
export const contourSurfaces = (operations: readonly SimulatedOperation[], first: number): Surface[] =>
  operations.flatMap(({ plan }, i) =>
    plan.contour.length === 0 || plan.moves.length === 0
      ? []
      : [{ operation: first + i, line: part.flattenedChain(plan.contour, CHORD), isInside: plan.openSide.r < 0 }],
  );

/** A feed move outside cycles. */
export const isPlainCut = (step: Step | undefined): step is Step =>
  step !== undefined && step.operation === null && step.move.kind !== "rapid";

/**
 * Where the run of plain cuts begins and ends that a step belongs to, both included: a rapid, a cycle or another tool
 * ends it.
 */
export function plainRun(steps: readonly Step[], index: number): readonly [first: number, last: number] {
  const belongs = (i: number) => isPlainCut(steps[i]) && steps[i]?.tool === steps[index]?.tool;
  let [first, last] = [index, index];
  while (belongs(first - 1)) first -= 1;
  while (belongs(last + 1)) last += 1;
  return [first, last];
}

/** The first of the steps outside cycles that the same tool makes up to a step. */
export function plainSince(steps: readonly Step[], index: number): number {
  let first = index;
  while (steps[first - 1]?.operation === null && steps[first - 1]?.tool === steps[index]?.tool) first -= 1;
  return first;
}

/** A boring bar points away from the axis. */
const bores = (tool: Tool): boolean => tipDirection(tool.TO).v > 0;
/** Tools that make a shape by themselves. */
const makesShape = (tool: Tool): boolean => isBar(tool) || tool.TYPE === "THREAD" || bores(tool);

/** What a cut takes, and which faces are none of a surface for it. */
interface Taking {
  readonly area: readonly Ring[];
  readonly tool: Tool;
  readonly stock: readonly Ring[];
}

/**
 * From which Z on faces are not looked at: a face ends where a bore begins, so that boring takes nothing of any, and
 * the one in front ends where the outside is turned.
 */
function facesEndAt({ area, tool, stock }: Taking): number {
  if (bores(tool)) return -Infinity;
  const own = boxAround(area),
    outside = boxAround(inBox(stock, { ...own, low: 0, high: Infinity })).high;
  return own.high >= outside - AGAINST ? boxAround(stock).right - AGAINST : Infinity;
}

/** How much of a surface lies against an area, mm; faces from a Z on are left out. */
function lengthAgainst({ line, isInside: inBore }: Surface, wide: readonly Ring[], faces: number): number {
  const box = boxAround(wide);
  const holds = (p: Pt) =>
    p.z >= box.left && p.z <= box.right && p.r >= box.low && p.r <= box.high && wide.some((ring) => isInside(ring, p));
  let length = 0;
  line.slice(1).forEach((q, i) => {
    const p = line[i] as Pt,
      size = hypotenuse(q.z - p.z, q.r - p.r);
    if (!inBore && Math.abs(q.r - p.r) > Math.abs(q.z - p.z) && Math.min(p.z, q.z) >= faces) return;
    if (
      Math.max(p.z, q.z) < box.left ||
      Math.min(p.z, q.z) > box.right ||
      Math.max(p.r, q.r) < box.low ||
      Math.min(p.r, q.r) > box.high
    )
      return;
    const parts = Math.max(1, Math.ceil(size / AGAINST));
    for (let k = 0; k < parts; k += 1) {
      const t = (k + 0.5) / parts;
      if (holds(at(p.z + (q.z - p.z) * t, p.r + (q.r - p.r) * t))) length += size / parts;
    }
  });
  return length;
}

/** The surfaces that a cut takes away. */
export function surfacesIn(taking: Taking, surfaces: readonly Surface[]): Surface[] {
  const wide = offset(taking.area, AGAINST),
    faces = facesEndAt(taking);
  return surfaces.filter((surface) => lengthAgainst(surface, wide, faces) >= LEAST_SURFACE);
}

const crossProduct = (o: Pt, a: Pt, b: Pt) => (a.z - o.z) * (b.r - o.r) - (a.r - o.r) * (b.z - o.z);
const crosses = (a: Pt, b: Pt, c: Pt, d: Pt): boolean =>
  crossProduct(a, b, c) * crossProduct(a, b, d) < 0 && crossProduct(c, d, a) * crossProduct(c, d, b) < 0;

/** Whether the insert goes through a surface from one side to the other: one that runs along below it does not. */
function goesThrough({ line }: Surface, step: Step, insert: Ring): boolean {
  const ways = [at(0, 0), ...insert].map(
    (p) => [at(step.from.z + p.z, step.from.r + p.r), at(step.move.to.z + p.z, step.move.to.r + p.r)] as const,
  );
  return line.slice(1).some((q, i) => ways.some(([a, b]) => crosses(a, b, line[i] as Pt, q)));
}

/** What a plain cut is held against beside the stock. */
export interface Beside {
  readonly steps: readonly Step[];
  readonly surfaces: readonly Surface[];
  readonly hold: WorkHold | null;
  readonly outlines: (tool: Tool) => Outlines;
}

/** What a plain cut below the contour of an operation is; "meant" is no fault, unless what follows it changes. */
export interface PlainCut {
  readonly kind: "gouge" | "cutBelowContour" | "meant";
  /** The operation whose contour is taken first. */
  readonly below: number;
}

/**
 * Judges a plain cut that takes `area` of the finished part in a stock. Inside the part, where no contour of a cycle is
 * taken away, it makes a surface of its own. An end of the part or a broken edge is meant, as is what the program says
 * to be. It goes through a finished surface by mistake when it makes none of the shapes that are cut on purpose:
 * compensated, with a tool that does not rough, or from outside the stock to outside of it.
 */
export function judgePlainCut(index: number, area: readonly Ring[], cut: Cutting, beside: Beside): PlainCut | null {
  const { steps, surfaces, outlines } = beside;
  const step = steps[index] as Step;
  const stock = cut.stock();
  const touched = surfacesIn({ area, tool: step.tool, stock }, surfaces);
  const [first] = touched;
  if (!first) return null;
  const as = (kind: PlainCut["kind"]): PlainCut => ({ kind, below: first.operation });
  if (step.intent === "meant") return as("meant");
  if (makesEnd(index, area, stock, beside)) return as("meant");
  const { insert } = outlines(step.tool);
  const [, last] = plainRun(steps, index);
  const end = (steps[last] as Step).move.to;
  const isOutside = () =>
    real(intersection(stock, turned(insert.map((p) => at(p.z + end.z, p.r + end.r))))).length === 0;
  const isShape = step.intent === "compensated" || makesShape(step.tool) || isOutside();
  if (isShape && breaksEdge(area, stock)) return as("meant");
  return as(!isShape && touched.some((surface) => goesThrough(surface, step, insert)) ? "gouge" : "cutBelowContour");
}

/**
 * Whether a cut makes an end of the part: what its tool cuts there before anything else leaves nothing in front of it
 * that is still held. A part is faced so, and parted off, which may take a groove and a chamfer before.
 */
function makesEnd(
  index: number,
  area: readonly Ring[],
  stock: readonly Ring[],
  { steps, hold, outlines }: Beside,
): boolean {
  const step = steps[index] as Step,
    { insert } = outlines(step.tool),
    own = boxAround(area);
  const after: Ring[] = [];
  for (let i = index, few = 0; i < steps.length && few < FEW; i += 1) {
    const next = steps[i] as Step;
    if (next.operation !== null || next.tool !== step.tool) break;
    if (next.move.kind === "rapid") continue;
    few += 1;
    const { rings } = sweptBy(insert, next),
      box = boxAround(rings);
    if (box.left < own.right + AGAINST && box.right > own.left - AGAINST) after.push(...rings);
  }
  const left = difference(stock, merged(after));
  const held = (hold && brokenApart(left, hold)?.held) ?? left;
  const front = { left: own.left + AGAINST, right: Infinity, low: -Infinity, high: Infinity };
  return areaOf(real(inBox(held, front))) < REAL_AREA;
}

/**
 * A chamfer or a rounding is at most so many times as long as it is wide, and an edge turns by more than this, as a
 * sine.
 */
const [SLIM, EDGE] = [4, 0.25];

/** Whether a cut takes an outer edge of the stock away, as a chamfer does. */
function breaksEdge(area: readonly Ring[], stock: readonly Ring[]): boolean {
  const wide = offset(area, AGAINST),
    { left, right, low, high } = boxAround(area);
  if (right - left > SLIM * (high - low) || high - low > SLIM * (right - left)) return false;
  return stock.some((ring) =>
    ring.some((p, i) => {
      const [before, next] = [ring.at(i - 1) as Pt, ring[(i + 1) % ring.length] as Pt];
      const turn = crossProduct(before, p, next),
        sides = hypotenuse(p.z - before.z, p.r - before.r) * hypotenuse(next.z - p.z, next.r - p.r);
      return turn > EDGE * sides && wide.some((outline) => isInside(outline, p));
    }),
  );
}
