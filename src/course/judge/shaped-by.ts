import { isPosition } from "../../cycles/completions.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import type { Param, Params, Values } from "../../cycles/params.ts";
import { parse } from "../../nc/parse.ts";
import { blockNumbers, startLines } from "../../nc/program.ts";
import { REAL_AREA } from "../../kernel/area/real-area.ts";
import { areaOf, areaOfRing } from "../../kernel/area/area.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { difference, intersection } from "../../kernel/area/clip.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { inDegrees } from "../../kernel/units.ts";
import { thicknessOf } from "../../sim/extent.ts";
import type { Operation } from "../../program/state/run-types.ts";
import type { Answer, TaskMark } from "./judgement.ts";
import { coordinateOf } from "./reversed-contour.ts";

/** Change of a value by which its influence on the contour is found, mm or degrees. */
const CHANGE = 0.05;
/** Points on each element at which the contour is compared. */
const SAMPLES = [0, 0.25, 0.5, 0.75, 1];
/** A contour has moved where it is farther away than this, mm. */
const MOVED = 1e-4;
/** Farther from the contour than this, mm, its shape explains nothing. */
const NEAR = 5;
/** Another value explains a region if the area that it moves is the region by more than this share. */
const EXPLAINED = 0.15;

const distanceTo = (contour: readonly Segment[], p: Pt): number =>
  contour.reduce((least, segment) => Math.min(least, part.distanceTo(segment, p)), Infinity);

const nearestOn = (segment: Segment, p: Pt): Pt => {
  const points = Array.from({ length: 41 }, (_, i) => part.pointOn(segment, i / 40));
  return points.reduce((best, each) => (part.apart(each, p) < part.apart(best, p) ? each : best));
};

/** The contour of a cycle by its parameters; null where the program gives the contour. */
function ownContour({ cycle: number, call }: Operation) {
  const cycle = cycleByNumber(number);
  if (!cycle || !call || cycle.contour !== "own") return null;
  const values = call.values as Readonly<Record<string, number | "auto">>;
  return {
    params: Object.entries<Param>(cycle.params),
    values,
    contourWith: (changed: Readonly<Record<string, number>>): readonly Segment[] =>
      cycle.outline({ ...values, ...changed } as Values<Params>, call.given).contour,
  };
}

/** What encloses the area between two contours: each is closed on this side of both. */
const SIDES = ["left", "right", "low", "high"] as const;

/** The area on one side of a contour, up to an edge of a box. */
function areaBeside(contour: readonly Segment[], side: (typeof SIDES)[number], box: Box): Ring {
  const points = part.flattenedChain(contour, CHORD);
  const edge = ({ z, r }: Pt) => (side === "left" || side === "right" ? at(box[side], r) : at(z, box[side]));
  const [first, last] = [points[0], points.at(-1)];
  const ring = first && last ? [...points, edge(last), edge(first)] : [];
  return areaOfRing(ring) < 0 ? ring.toReversed() : ring;
}

/** How well the area between two contours explains a region, 0 to 1: the area of both as a share of all. */
function explains(region: readonly Ring[], contour: readonly Segment[], other: readonly Segment[]): number {
  const box = boxAround([...region, ...[contour, other].map((each) => part.flattenedChain(each, CHORD))]);
  const area = areaOf(region);
  const shares = SIDES.map((side) => {
    const [one, two] = [contour, other].map((each) => [areaBeside(each, side, box)]) as [Ring[], Ring[]];
    const between = [...difference(one, two), ...difference(two, one)];
    const both = areaOf(intersection(region, between));
    return both / (area + areaOf(between) - both);
  });
  return Math.max(...shares);
}

/** The values that a dimension may have been meant to have, by the extent of a region. */
function meantValues(
  q: string,
  param: Param,
  value: number,
  region: readonly Ring[],
  params: readonly (readonly [string, Param])[],
) {
  const box = boxAround(region),
    thick = thicknessOf(region);
  const [wide, high] = [box.right - box.left, box.high - box.low];
  if (isPosition(param)) {
    const [ends, by] =
      param.kind === "axial" ? [[box.left, box.right], thick] : [[2 * box.low, 2 * box.high], 2 * thick];
    return [...ends, value + by, value - by].map((to) => ({ [q]: to }));
  }
  if (param.kind === "choice") {
    const size = params.find(([, { sizes }]) => sizes === q)?.[0];
    const others = (param.choices ?? []).filter((kind) => kind !== value);
    return size === undefined
      ? []
      : others.flatMap((kind) => [{ [q]: kind }, { [q]: kind, [size]: Math.max(wide, high) }]);
  }
  if (param.kind === "angle") {
    const lean = inDegrees(Math.atan2(high, wide));
    return [lean, 90 - lean].flatMap((by) => [value + by, value - by]).map((to) => ({ [q]: to }));
  }
  // A chamfer of 45° that is longer leaves its surface by this.
  const leg = thick * Math.SQRT2;
  return [wide, high, value - leg, value + leg].map((to) => ({ [q]: to }));
}

/**
 * The parameter that explains a region of wrong material: with another value, the contour runs on the other side of the
 * region. Null where none does.
 */
function explainingParameter(operation: Operation, region: readonly Ring[]): string | null {
  const own = ownContour(operation);
  if (!own) return null;
  const { params, values, contourWith } = own;
  const contour = contourWith({});
  const trials = params.flatMap(([q, param]) => {
    const value = values[q];
    if (typeof value !== "number" || !(param.drawn || params.some(([, { sizes }]) => sizes === q))) return [];
    const shares = meantValues(q, param, value, region, params).map((meant) => {
      const other = contourWith(meant);
      return other.length === 0 ? 0 : explains(region, contour, other);
    });
    return [{ q, share: Math.max(0, ...shares) }];
  });
  const [best] = trials.toSorted((a, b) => b.share - a.share);
  return best && best.share > EXPLAINED ? best.q : null;
}

/**
 * The parameter that moves the contour at a place and as little as possible of it elsewhere; null where none does. Sizes
 * and angles of an element come before positions. Those with value 0 make no element.
 */
function shapingParameter(operation: Operation, place: Pt): string | null {
  const own = ownContour(operation);
  if (!own) return null;
  const { params, values, contourWith } = own;
  const contour = contourWith({});
  const [nearest] = contour.toSorted((a, b) => part.distanceTo(a, place) - part.distanceTo(b, place));
  if (!nearest || part.distanceTo(nearest, place) > NEAR) return null;
  const point = nearestOn(nearest, place);
  const samples = contour.flatMap((segment) => SAMPLES.map((share) => part.pointOn(segment, share)));
  const found = params.flatMap(([q, param]) => {
    const value = values[q],
      ofPosition = isPosition(param);
    if (!param.drawn || typeof value !== "number" || param.kind === "choice" || (value === 0 && !ofPosition)) return [];
    const moved = contourWith({ [q]: value + CHANGE });
    if (moved.length === 0 || distanceTo(moved, point) < MOVED) return [];
    const reach = samples.filter((sample) => distanceTo(moved, sample) > MOVED).length;
    return [{ q, reach: reach + (ofPosition ? samples.length : 0) }];
  });
  return found.toSorted((a, b) => a.reach - b.reach)[0]?.q ?? null;
}

/** An element is parallel to an axis within this, mm. */
const PARALLEL = 0.001;

/** The axis whose coordinate places an element that is parallel to the other one; null for other elements. */
const placingAxis = ({ from, to }: Segment): "X" | "Z" | null =>
  Math.abs(from.r - to.r) < PARALLEL ? "X" : Math.abs(from.z - to.z) < PARALLEL ? "Z" : null;

/**
 * The block of the element of a programmed contour nearest to a place; null where it is in another file. A cylinder and
 * a face are placed by the last block with their X or Z.
 */
function shapingBlock({ contourLines, plan }: Operation, place: Pt, text: string): number | null {
  const apart = plan.contour.map((segment) => part.distanceTo(segment, place));
  const least = Math.min(...apart),
    element = plan.contour[apart.indexOf(least)],
    line = contourLines?.[apart.indexOf(least)];
  if (!line || !element || line.file !== undefined || least > NEAR) return null;
  const program = parse(text),
    { blocks } = program;
  const own = startLines(program).findLastIndex((start) => start <= line.line);
  const axis = blocks[own]?.statement.kind === "path" && placingAxis(element);
  const placing = axis
    ? blocks.findLastIndex(
        ({ statement: s, raw }, i) =>
          i <= own && (s.kind === "label" || (s.kind === "path" && coordinateOf(raw, axis) !== null)),
      )
    : -1;
  const index = blocks[placing]?.statement.kind === "path" ? placing : own;
  return blockNumbers(program)[index] ?? null;
}

/** The elements of the contours that a parameter shapes: in the middle of them it moves the contour most. */
export const elementShapedBy = ({ run }: Answer, q: string): readonly Segment[] =>
  run.operations.flatMap((operation) => {
    const { x = 0, z = 0 } = operation.call?.datum ?? {};
    return operation.plan.contour.filter((each) => {
      const middle = part.pointOn(each, 1 / 2);
      return shapingParameter(operation, at(middle.z - z, middle.r - x)) === q;
    });
  });

/** What shapes the contour at the place of a mark: a parameter of its cycle, or a block of its contour. */
export function shapedBy(
  { run, simulation, text }: Answer,
  { rule, operation, place, about, rings }: TaskMark,
): Pick<TaskMark, "shapedBy"> {
  if (!place || about !== undefined) return {};
  const [nearest] = run.operations.toSorted(
    (a, b) => distanceTo(a.plan.contour, place) - distanceTo(b.plan.contour, place),
  );
  const called = operation === undefined ? nearest : run.operations[operation];
  if (!called) return {};
  // Where nothing was cut at all, no dimension is the reason.
  const cut = simulation.proof.operations[run.operations.indexOf(called)]?.cut ?? 0;
  if (rule !== "missing" && cut < REAL_AREA) return {};
  const { x = 0, z = 0 } = called.call?.datum ?? {};
  const region = rings?.map((ring) => ring.map((p) => at(p.z - z, p.r - x)));
  const q = (region && explainingParameter(called, region)) ?? shapingParameter(called, at(place.z - z, place.r - x));
  if (q !== null) return { shapedBy: { q } };
  const block = shapingBlock(called, place, text);
  return block === null ? {} : { shapedBy: { block } };
}
