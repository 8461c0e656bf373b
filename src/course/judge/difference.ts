import { areaOf, areaOfRing } from "../../kernel/area/area.ts";
import { boxAround, gapBetween } from "../../kernel/area/box.ts";
import { difference, intersection, isInside, opened } from "../../kernel/area/clip.ts";
import { part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { REAL_AREA } from "../../kernel/area/real-area.ts";
import { pathOf } from "../../kernel/time/time.ts";
import { SLIVER } from "../../kernel/tolerance.ts";
import { outlinesOf } from "../../sim/outlines.ts";
import { thicknessOf } from "../../sim/extent.ts";
import { regionsOf } from "../../sim/region.ts";
import { sweptBy } from "../../sim/sweep.ts";
import { middleOf } from "./middle.ts";
import type { Answer, TaskMark } from "./judgement.ts";

/** Smaller regions are not marked one by one, mm²; of the larger ones, at most this many. */
const LEAST = 0.005;
const MOST = 12;

/** The area of one half section outside another, without slivers of chords and grid. */
export const areaBeyond = (one: readonly Ring[], other: readonly Ring[]): Ring[] =>
  opened(difference(one, other), SLIVER);

/** How far a point is from an area, mm; 0 inside it. */
export function distanceTo(rings: readonly Ring[], p: Pt): number {
  const inside = rings.reduce((sum, ring) => sum + (isInside(ring, p) ? Math.sign(areaOfRing(ring)) : 0), 0);
  if (inside > 0) return 0;
  const edges = rings.flatMap((ring) => ring.map((to, i) => part.line(ring.at(i - 1) as Pt, to)));
  return edges.reduce((least, edge) => Math.min(least, part.distanceTo(edge, p)), Infinity);
}

const shared = (one: readonly Ring[], other: readonly Ring[]): number => areaOf(intersection(one, other));

/** The first step that removed part of an area, and its block; empty where no tool came there. */
export function firstStepInto(
  area: readonly Ring[],
  { run, simulation }: Answer,
): Pick<TaskMark, "step" | "block" | "operation"> {
  const outlines = outlinesOf();
  const box = boxAround(area);
  const enough = Math.min(REAL_AREA, areaOf(area) / 4);
  const index = simulation.steps.findIndex((step) => {
    const { insert } = outlines(step.tool);
    if (insert.length < 3) return false;
    const [path, own] = [part.boxOf(pathOf(step.from, step.move)), boxAround([insert])];
    // A sweep across the axis also cuts on this side.
    const low = path.low + own.low;
    const reached = {
      left: path.left + own.left,
      right: path.right + own.right,
      low: Math.min(low, 0),
      high: path.high + own.high,
    };
    if (gapBetween({ ...reached, low: low < 0 ? 0 : low, high: Math.max(reached.high, -low) }, box) > 0) return false;
    const { pieces, rings } = sweptBy(insert, step);
    return pieces.some((piece) => gapBetween(piece.box, box) === 0) && shared(area, rings) >= enough;
  });
  const step = simulation.steps[index];
  if (step) return { step: index, block: step.block, ...(step.operation !== null && { operation: step.operation }) };
  const stated = run.stated[0];
  return stated ? { step: stated.step, block: stated.block } : {};
}

/** The cycle call whose contour passes nearest to a place; the last call where none has a contour. */
function nearestCall({ run }: Answer, place: Pt): number {
  const apart = run.operations.map(({ plan }) =>
    plan.contour.reduce((least, segment) => Math.min(least, part.distanceTo(segment, place)), Infinity),
  );
  const least = Math.min(...apart);
  return Number.isFinite(least) ? apart.lastIndexOf(least) : run.operations.length - 1;
}

/** A reason is given only where it explains at least this share of the material left. */
const EXPLAINED = 0.5;

/** The operation that should have cut an area, with the reason why it did not; empty without a cycle call. */
function ownerOf(outline: Ring, answer: Answer): Pick<TaskMark, "operation" | "block" | "reason"> {
  const { run, simulation } = answer;
  const told = simulation.proof.residual
    .map((r) => ({ r, area: shared([outline], [r.ring]) }))
    .filter(({ area }) => area > LEAST);
  const greatest = told.toSorted((a, b) => b.area - a.area)[0],
    most = greatest?.r;
  const isExplained = (greatest?.area ?? 0) >= EXPLAINED * areaOf([outline]);
  const place = middleOf([outline]);
  const own = most?.operation ?? run.operations.findLastIndex((o) => isInside(o.plan.area, place));
  const operation = own >= 0 ? own : nearestCall(answer, place);
  const called = run.operations[operation];
  if (!called) return nearestCut([outline], answer);
  return { operation, block: called.block, ...(most && isExplained && { reason: most.reason }) };
}

/** Without a cycle, more than this is no inaccurate cut but a missing one, mm: the cut beside it is not to blame. */
const INACCURATE = 1.2;

/** Without a cycle: the cut that ran nearest along a region, with its block. */
function nearestCut(region: readonly Ring[], { simulation: { steps } }: Answer): Pick<TaskMark, "step" | "block"> {
  if (thicknessOf(region) > INACCURATE) return {};
  const place = middleOf(region);
  const apart = steps.map(({ from, move }) =>
    move.kind === "rapid" ? Infinity : part.distanceTo(part.line(from, move.to), place),
  );
  const index = apart.indexOf(Math.min(...apart)),
    step = steps[index];
  return step && Number.isFinite(apart[index]) ? { step: index, block: step.block } : {};
}

/** One failed mark per region where the areas exceed the limit, else one passed mark. */
function marksOf(
  rule: "missing" | "residue",
  area: readonly Ring[],
  limit: number,
  because: (outline: Ring) => Partial<TaskMark>,
): TaskMark[] {
  const value = areaOf(area);
  if (value <= limit) return [{ rule, passed: true, value, limit }];
  const found = regionsOf(area, LEAST),
    regions = (found.length > 0 ? found : regionsOf(area, 0)).toSorted((a, b) => b.area - a.area);
  // Regions within the limit are allowed, such as the fillet in a corner; they are not marked beside a forgotten
  // shoulder.
  const counts = regions.filter((_, i) => regions.slice(i).reduce((sum, region) => sum + region.area, 0) > limit);
  return counts.slice(0, MOST).map((region) => ({
    rule,
    passed: false,
    value: region.area,
    limit,
    place: middleOf([region.outline, ...region.holes]),
    rings: [region.outline, ...region.holes],
    ...because(region.outline),
  }));
}

/** Points on an edge of a region: where a corner is cut off, all corners of the region are on the surface. */
const ALONG_EDGE = [0.25, 0.5, 0.75, 1];

/** How far a cut reaches into an area, mm: the greatest distance of the missing region from its surface. */
function depthInto(wanted: readonly Ring[], region: Ring): number {
  const surface = wanted.flatMap((ring) => ring.map((to, i) => part.line(ring.at(i - 1) as Pt, to)));
  const toSurface = (p: Pt) => surface.reduce((least, edge) => Math.min(least, part.distanceTo(edge, p)), Infinity);
  const edges = region.map((to, i) => part.line(region.at(i - 1) as Pt, to));
  const points = edges.flatMap((edge) => ALONG_EDGE.map((share) => part.pointOn(edge, share)));
  return points.reduce((most, p) => Math.max(most, toSurface(p)), 0);
}

/** Material missing from the target part: each place with the first move that cut there. */
export const missingMarks = (
  wanted: readonly Ring[],
  made: readonly Ring[],
  limit: number,
  answer: Answer,
): TaskMark[] =>
  marksOf("missing", areaBeyond(wanted, made), limit, (outline) => ({
    depth: depthInto(wanted, outline),
    ...firstStepInto([outline], answer),
  }));

/** Excess material on the target part: each place with the operation that should have cut it. */
export const residueMarks = (
  wanted: readonly Ring[],
  made: readonly Ring[],
  limit: number,
  answer: Answer,
): TaskMark[] => marksOf("residue", areaBeyond(made, wanted), limit, (outline) => ownerOf(outline, answer));
