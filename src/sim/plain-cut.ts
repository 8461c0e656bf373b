import { areaOf } from "../kernel/area/area.ts";
import { boxAround, inBox } from "../kernel/area/box.ts";
import { difference, intersection, isInside, offset } from "../kernel/area/clip.ts";
import { hypotenuse } from "../kernel/geometry/vectors.ts";
import { isBar, tipDirection } from "../kernel/cutter/insert.ts";
import { at, part, type Pt, type Ring } from "../kernel/geometry/point.ts";
import { REAL_AREA, withoutSlivers } from "../kernel/area/real-area.ts";
import type { Step } from "../kernel/time/step.ts";
import { CHORD } from "../kernel/tolerance.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { merged, type Cutting } from "./cutting.ts";
import { brokenApart, type WorkHold } from "./work-holding.ts";
import type { Outlines } from "./outlines.ts";
import type { SimulatedOperation } from "./simulation.ts";
import { sweptBy, foldedAtAxis } from "./sweep.ts";

/* Feed moves outside cycles may cut below the contour of a cycle on purpose. This module decides which of them do. */

/** Distance at which a region touches a surface, mm: both carry chord errors, and the finished part is shrunk. */
const AGAINST = 0.02;
/** Most moves that make an end of the part. */
const FEW = 40;
/** Shorter contact with a surface is only its end corner, mm. */
const LEAST_SURFACE = 0.1;

/** The contour of an operation as a line. */
export interface Surface {
  readonly operation: number;
  readonly line: readonly Pt[];
  /** It lies in a bore. */
  readonly isInside: boolean;
}

/** The contour surfaces of operations; `first`: index of the first operation in the run. */
export const contourSurfaces = (operations: readonly SimulatedOperation[], first: number): Surface[] =>
  operations.flatMap(({ plan }, i) =>
    plan.contour.length === 0 || plan.moves.length === 0
      ? []
      : [{ operation: first + i, line: part.flattenedChain(plan.contour, CHORD), isInside: plan.openSide.r < 0 }],
  );

/** A feed move outside cycles. */
export const isPlainCut = (step: Step | undefined): step is Step =>
  step !== undefined && step.operation === null && step.move.kind !== "rapid";

/** First and last step of the run of plain cuts around a step: a rapid, a cycle or another tool ends it. */
export function plainRun(steps: readonly Step[], index: number): readonly [first: number, last: number] {
  const belongs = (i: number) => isPlainCut(steps[i]) && steps[i]?.tool === steps[index]?.tool;
  let [first, last] = [index, index];
  while (belongs(first - 1)) first -= 1;
  while (belongs(last + 1)) last += 1;
  return [first, last];
}

/** The first step of the same tool outside cycles, back from a step. */
export function plainSince(steps: readonly Step[], index: number): number {
  let first = index;
  while (steps[first - 1]?.operation === null && steps[first - 1]?.tool === steps[index]?.tool) first -= 1;
  return first;
}

/** A boring bar points away from the axis. */
const bores = (tool: Tool): boolean => tipDirection(tool.TO).v > 0;
/** Tools whose own shape makes the contour. */
const makesShape = (tool: Tool): boolean => isBar(tool) || tool.TYPE === "THREAD" || bores(tool);

/** The area of a plain cut with its tool and stock. */
interface Taking {
  readonly area: readonly Ring[];
  readonly tool: Tool;
  readonly stock: readonly Ring[];
}

/**
 * The Z from which faces are ignored: boring cuts only where a face ends, and the front face ends where the outside is
 * turned.
 */
function facesEndAt({ area, tool, stock }: Taking): number {
  if (bores(tool)) return -Infinity;
  const own = boxAround(area),
    outside = boxAround(inBox(stock, { ...own, low: 0, high: Infinity })).high;
  return own.high >= outside - AGAINST ? boxAround(stock).right - AGAINST : Infinity;
}

/** Contact length of a surface with an area, mm, without faces from a Z on. */
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

/** The surfaces that a cut removes. */
export function surfacesIn(taking: Taking, surfaces: readonly Surface[]): Surface[] {
  const wide = offset(taking.area, AGAINST),
    faces = facesEndAt(taking);
  return surfaces.filter((surface) => lengthAgainst(surface, wide, faces) >= LEAST_SURFACE);
}

const crossProduct = (o: Pt, a: Pt, b: Pt) => (a.z - o.z) * (b.r - o.r) - (a.r - o.r) * (b.z - o.z);
const crosses = (a: Pt, b: Pt, c: Pt, d: Pt): boolean =>
  crossProduct(a, b, c) * crossProduct(a, b, d) < 0 && crossProduct(c, d, a) * crossProduct(c, d, b) < 0;

/** Whether the insert crosses a surface; running along below it does not count. */
function goesThrough({ line }: Surface, step: Step, insert: Ring): boolean {
  const ways = [at(0, 0), ...insert].map(
    (p) => [at(step.from.z + p.z, step.from.r + p.r), at(step.move.to.z + p.z, step.move.to.r + p.r)] as const,
  );
  return line.slice(1).some((q, i) => ways.some(([a, b]) => crosses(a, b, line[i] as Pt, q)));
}

/** What a plain cut is checked against, besides the stock. */
export interface PlainCutContext {
  readonly steps: readonly Step[];
  readonly surfaces: readonly Surface[];
  readonly hold: WorkHold | null;
  readonly outlines: (tool: Tool) => Outlines;
}

/**
 * The verdict on a plain cut below a contour. "intendedCut": only its comment makes it no fault. "meant" is no fault by
 * its shape, unless later moves change it.
 */
export interface PlainCut {
  readonly kind: "gouge" | "cutBelowContour" | "intendedCut" | "meant";
  /** The first operation whose contour is cut. */
  readonly below: number;
}

/**
 * Judges a plain cut that removes `area` of the finished part. Inside the part, where it removes no contour of a cycle,
 * it makes a surface of its own. An end of the part, a broken edge and a stated intention are meant. It crosses a
 * finished surface by mistake when it makes none of the shapes that are cut on purpose: compensated, with a tool that
 * does not rough, or from outside the stock to outside of it.
 */
export function judgePlainCut(
  index: number,
  area: readonly Ring[],
  cut: Cutting,
  beside: PlainCutContext,
): PlainCut | null {
  const { steps, surfaces, outlines } = beside;
  const step = steps[index] as Step;
  const stock = cut.stock();
  const touched = surfacesIn({ area, tool: step.tool, stock }, surfaces);
  const [first] = touched;
  if (!first) return null;
  const as = (kind: PlainCut["kind"]): PlainCut => ({ kind, below: first.operation });
  if (makesEnd(index, area, stock, beside)) return as("meant");
  const { insert } = outlines(step.tool);
  const [, last] = plainRun(steps, index);
  const end = (steps[last] as Step).move.to;
  const isOutside = () =>
    withoutSlivers(intersection(stock, foldedAtAxis(insert.map((p) => at(p.z + end.z, p.r + end.r))))).length === 0;
  const isShape = step.intent === "compensated" || makesShape(step.tool) || isOutside();
  if (isShape && breaksEdge(area, stock)) return as("meant");
  if (step.intent === "meant") return as("intendedCut");
  return as(!isShape && touched.some((surface) => goesThrough(surface, step, insert)) ? "gouge" : "cutBelowContour");
}

/**
 * Whether a cut makes an end of the part: after the cuts of its tool there, up to the next operation or tool, no held
 * material is left in front. This is facing or parting, which may cut a groove and a chamfer first.
 */
function makesEnd(
  index: number,
  area: readonly Ring[],
  stock: readonly Ring[],
  { steps, hold, outlines }: PlainCutContext,
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
  return areaOf(withoutSlivers(inBox(held, front))) < REAL_AREA;
}

/** Greatest length-to-width ratio of a chamfer or rounding, and the least turn of an edge, as a sine. */
const [SLIM, EDGE] = [4, 0.25];

/** Whether a cut removes an outer edge of the stock, as a chamfer does. */
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
