import { areaOf } from "../kernel/area.ts";
import { boxAround, inBox } from "../kernel/box.ts";
import { difference, intersection, isInside, offset } from "../kernel/clip.ts";
import { isDrill } from "../kernel/drill.ts";
import { hypotenuse } from "../kernel/geometry/vectors.ts";
import { isBar, tipDirection } from "../kernel/insert.ts";
import { at, part, type Pt, type Ring } from "../kernel/point.ts";
import { REAL_AREA, real } from "../kernel/real-area.ts";
import type { Step } from "../kernel/step.ts";
import { CHORD } from "../kernel/tolerance.ts";
import type { Tool } from "../kernel/tool.ts";
import { merged, type Cutting } from "./cutting.ts";
import type { Outlines } from "./outlines.ts";
import type { SimulatedOperation } from "./simulation.ts";
import { sweptBy, turned } from "./sweep.ts";

/*
 * Feed moves outside cycles cut what the program wants cut: whether one that goes below the contour of a cycle may be meant is told here.
 */

/** A region lies against a surface where they are this near, mm; both carry chord errors, and the finished part is shrunk. */
const AGAINST = 0.02;
/** Moves that are looked at for a face: a face is cut in few. */
const FACING = 40;
/** Less of a surface than this is the corner at which it ends, mm. */
const LEAST_SURFACE = 0.1;

/** The contour of an operation as a line. */
export interface Surface {
  readonly operation: number;
  readonly line: readonly Pt[];
}

/** The surfaces that operations make; `first` is the index of the first of them in the run. */
export const contourSurfaces = (operations: readonly SimulatedOperation[], first: number): Surface[] =>
  operations.flatMap(({ plan }, i) =>
    plan.contour.length === 0 || plan.moves.length === 0 ? [] : [{ operation: first + i, line: part.flattenedChain(plan.contour, CHORD) }]
  );

/** A feed move outside cycles. */
export const isPlainCut = (step: Step | undefined): step is Step =>
  step !== undefined && step.operation === null && step.move.kind !== "rapid";

/** Where the run of plain cuts begins and ends that a step belongs to, both included: a rapid, a cycle or another tool ends it. */
export function plainRun(steps: readonly Step[], index: number): readonly [first: number, last: number] {
  const belongs = (i: number) => isPlainCut(steps[i]) && steps[i]?.tool === steps[index]?.tool;
  let [first, last] = [index, index];
  while (belongs(first - 1)) first -= 1;
  while (belongs(last + 1)) last += 1;
  return [first, last];
}

/** Tools that make a shape by themselves: blades, threads, drills and what bores. A boring bar points away from the axis. */
const makesShape = (tool: Tool): boolean => isBar(tool) || tool.TYPE === "THREAD" || isDrill(tool) || tipDirection(tool.TO).v > 0;

/** How much of a surface lies against an area, mm. */
function lengthAgainst({ line }: Surface, wide: readonly Ring[]): number {
  const box = boxAround(wide);
  const holds = (p: Pt) =>
    p.z >= box.left && p.z <= box.right && p.r >= box.low && p.r <= box.high && wide.some((ring) => isInside(ring, p));
  let length = 0;
  line.slice(1).forEach((q, i) => {
    const p = line[i] as Pt, size = hypotenuse(q.z - p.z, q.r - p.r);
    if (Math.max(p.z, q.z) < box.left || Math.min(p.z, q.z) > box.right || Math.max(p.r, q.r) < box.low || Math.min(p.r, q.r) > box.high)
      return;
    const parts = Math.max(1, Math.ceil(size / AGAINST));
    for (let k = 0; k < parts; k += 1) {
      const t = (k + 0.5) / parts;
      if (holds(at(p.z + (q.z - p.z) * t, p.r + (q.r - p.r) * t))) length += size / parts;
    }
  });
  return length;
}

/** The surfaces that an area takes away. */
export function surfacesIn(area: readonly Ring[], surfaces: readonly Surface[]): Surface[] {
  const wide = offset(area, AGAINST);
  return surfaces.filter((surface) => lengthAgainst(surface, wide) >= LEAST_SURFACE);
}

const crossProduct = (o: Pt, a: Pt, b: Pt) => (a.z - o.z) * (b.r - o.r) - (a.r - o.r) * (b.z - o.z);
const crosses = (a: Pt, b: Pt, c: Pt, d: Pt): boolean =>
  crossProduct(a, b, c) * crossProduct(a, b, d) < 0 && crossProduct(c, d, a) * crossProduct(c, d, b) < 0;

/** Whether the insert goes through a surface from one side to the other: one that runs along below it does not. */
function goesThrough({ line }: Surface, step: Step, insert: Ring): boolean {
  const ways = [at(0, 0), ...insert].map((p) =>
    [at(step.from.z + p.z, step.from.r + p.r), at(step.move.to.z + p.z, step.move.to.r + p.r)] as const
  );
  return line.slice(1).some((q, i) => ways.some(([a, b]) => crosses(a, b, line[i] as Pt, q)));
}

/** What a plain cut below a finished contour is; "meant" is no fault, unless what follows it changes; null: it is not below one. */
export type PlainCut = "gouge" | "cutBelowContour" | "meant" | null;

/**
 * Judges a plain cut that takes `area` of the finished part in a stock. Inside the part, where no contour of a cycle is taken away, it makes
 * a surface of its own. A face in front of which nothing stays is meant, as is what the program says to be. It goes
 * through a finished surface by mistake when it makes none of the shapes that are cut on purpose: compensated, with a tool that does not rough, or
 * from outside the stock to outside of it.
 */
export function judgePlainCut(
  index: number,
  area: readonly Ring[],
  { steps, surfaces, outlines, cut }: { readonly steps: readonly Step[]; readonly surfaces: readonly Surface[];
    readonly outlines: (tool: Tool) => Outlines; readonly cut: Cutting },
): PlainCut {
  const step = steps[index] as Step;
  const touched = surfacesIn(area, surfaces);
  if (touched.length === 0) return null;
  if (step.intent === "meant") return "meant";
  const { insert } = outlines(step.tool);
  const [, last] = plainRun(steps, index);
  const stock = cut.stock();
  const rest = steps.slice(index, Math.min(last + 1, index + FACING)).flatMap((s) => sweptBy(insert, s).rings);
  if (isFace(stock, merged(rest), area)) return "meant";
  const end = (steps[last] as Step).move.to;
  const isOutside = () => real(intersection(stock, turned(insert.map((p) => at(p.z + end.z, p.r + end.r))))).length === 0;
  const isShape = step.intent === "compensated" || makesShape(step.tool) || isOutside();
  return !isShape && touched.some((surface) => goesThrough(surface, step, insert)) ? "gouge" : "cutBelowContour";
}

/** True when nothing stays in front of what is cut. */
function isFace(stock: readonly Ring[], swept: readonly Ring[], area: readonly Ring[]): boolean {
  const front = { left: boxAround(area).left + AGAINST, right: Infinity, low: -Infinity, high: Infinity };
  return areaOf(real(inBox(difference(stock, swept), front))) < REAL_AREA;
}

/** The operation whose contour a cut goes below: that of the surface which is taken first. */
export const operationBelow = (area: readonly Ring[], surfaces: readonly Surface[]): number | null =>
  surfacesIn(area, surfaces)[0]?.operation ?? null;
