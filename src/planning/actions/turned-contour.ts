import type { Cycle } from "../../cycles/define.ts";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import type { Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { toDiameter, radius } from "../../kernel/units.ts";
import { boxAroundContour } from "../../program/job/requested-shape.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Chain, PlanRequest } from "../types.ts";
import type { OutsideWork, Piece } from "./outside-work.ts";
import { bridgedOver, type Pocket } from "./pockets.ts";
import { workOf, type CutRequest } from "./values-of-job.ts";

/** A chain without the faces in front of it, which facing takes. */
export function withoutFront({ segments, marks }: Chain): Chain {
  const first = segments.findIndex((s) => Math.abs(s.to.z - s.from.z) > SAME);
  return first < 0 ? { segments: [], marks: [] } : { segments: segments.slice(first), marks: marks.slice(first) };
}

/** Turning cycles for a section of the contour that are not excluded. `allowance`: of stock along the contour, mm. */
export function turningCycles(
  segments: readonly Segment[],
  { withoutCycles }: PlanRequest,
  allowance = 0,
): readonly Cycle[] {
  const wanted = {
    site: "outside",
    shape: "free",
    angle: 0,
    pitch: 1,
    contour: segments,
    allowance: allowance as ShapeRequest["allowance"],
    ...boxAroundContour(segments, "outside"),
  } as const;
  return cyclesFor(wanted).filter(
    (c) => (c.group === "longitudinal" || c.group === "transverse") && !withoutCycles.includes(c.number),
  );
}

/** Share of a pocket's wall that a tool may miss and still be sent into it. */
const MOST_MISSED = 0.5;
const BY_TOOL: ReadonlySet<string | null> = new Set(["mainEdge", "secondaryEdge", "toolWidth", "cutLength"]);

/** Length of the path over a pocket that the shape of a tool keeps off its contour, as a share of its mouth. */
function missed({ reach }: Plan, { segments }: Pocket): number {
  const [from, to] = [segments[0]?.from.z ?? 0, segments.at(-1)?.to.z ?? 0];
  const over = ({ path }: Plan["reach"][number]) =>
    Math.max(0, Math.min(from, Math.max(path.from.z, path.to.z)) - Math.max(to, Math.min(path.from.z, path.to.z)));
  const width = Math.max(SAME, from - to);
  return reach.reduce((sum, part) => sum + (BY_TOOL.has(part.reason) ? over(part) : 0), 0) / width;
}

/** The pockets that a tool is not sent into: it would not reach most of them. */
const unsuited = (plan: Plan, pockets: readonly Pocket[]): readonly Pocket[] =>
  pockets.flatMap((pocket) => (missed(plan, pocket) > MOST_MISSED ? [pocket] : unsuited(plan, pocket.inner)));

/** The chain of a work over some of its pockets, the same object each time. */
function bridgedIn(work: OutsideWork, pockets: readonly Pocket[]): Chain {
  const known = bridgedWorks.get(work) ?? new Map<string, Chain>();
  bridgedWorks.set(work, known);
  const name = pockets.map(({ axis, first, last, level }) => [axis, first, last, level].join(" ")).join();
  const chain = known.get(name) ?? withoutFront(bridgedOver(work.chain, pockets));
  known.set(name, chain);
  return chain;
}

const bridgedWorks = new WeakMap<OutsideWork, Map<string, Chain>>();

/**
 * The chain as a tool turns it: without the grooves in its faces, those with nothing left in them, and those that it
 * does not reach.
 */
export function turnedChain(work: OutsideWork, planWith: (segments: readonly Segment[]) => Plan | null): Chain {
  const { pockets, pieces } = work;
  const radial = pockets.filter(({ axis }) => axis === "r");
  const done = radial.filter(({ first, last }) => !pieces.some(({ borders: [a, b] }) => a < last && b > first));
  const closed = [...pockets.filter(({ axis }) => axis === "z"), ...done];
  const plain = bridgedIn(work, closed);
  const open = radial.filter((pocket) => !done.includes(pocket));
  if (open.length === 0) return plain;
  const plan = planWith(plain.segments);
  const skipped = plan ? unsuited(plan, open) : open;
  return skipped.length === 0 ? plain : bridgedIn(work, [...closed, ...skipped]);
}

/** What the values of a cut of a section depend on. */
export const cutOf = (
  cycle: Cycle,
  operation: CutRequest["operation"],
  { box, stock, roughness }: Pick<Piece, "box"> & Pick<CutRequest, "stock" | "roughness">,
): CutRequest => ({
  operation,
  work: workOf(cycle.group, operation),
  smallest: toDiameter(radius(box.low)),
  largest: toDiameter(radius(box.high)),
  stock,
  ...(roughness !== undefined && { roughness }),
});

/** Tools of these types first, in this order. */
export const typesFirst =
  (...types: readonly Tool["TYPE"][]) =>
  (a: Tool, b: Tool): number => {
    const place = ({ TYPE }: Tool) => (types.includes(TYPE) ? types.indexOf(TYPE) : types.length);
    return place(a) - place(b);
  };
