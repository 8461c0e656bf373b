import { isPosition } from "../../cycles/completions.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import type { Param, Params, Values } from "../../cycles/params.ts";
import { parse } from "../../nc/parse.ts";
import { blockNumbers, startLines } from "../../nc/program.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Operation } from "../../program/state/run-types.ts";
import type { Answer, TaskMark } from "./judgement.ts";

/** Change of a value by which its influence on the contour is found, mm or degrees. */
const CHANGE = 0.05;
/** Points on each element at which the contour is compared. */
const SAMPLES = [0, 0.25, 0.5, 0.75, 1];
/** A contour has moved where it is farther away than this, mm. */
const MOVED = 1e-4;
/** Farther from the contour than this, mm, its shape explains nothing. */
const NEAR = 5;
/** A contour explains a region if the region lies nearer to it than this share of its distance from the present one. */
const EXPLAINED = 0.1;

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

/** The lines between the beginnings and between the ends of two contours: there a face limits what lies between them. */
const endsBetween = (one: readonly Segment[], other: readonly Segment[]): readonly Segment[] =>
  (["from", "to"] as const).flatMap((end) => {
    const [a, b] = [one, other].map((each) => (end === "from" ? each[0] : each.at(-1))?.[end]);
    return a && b ? [part.line(a, b)] : [];
  });

/**
 * The choice of an edge element that explains why a region was left: the region lies between the contour and the one of
 * another choice. Null where none does. A size that is not entered is taken from the region.
 */
function wrongElement(operation: Operation, region: Ring): string | null {
  const own = ownContour(operation);
  if (!own) return null;
  const { params, values, contourWith } = own;
  const contour = contourWith({}),
    { left, right, low, high } = boxOf(region);
  const size = Math.max(right - left, high - low);
  // All corners of a chamfer that was left out are on the contour: the middles of its edges are not.
  const points = region.flatMap((to, i) => [to, part.pointOn(part.line(region.at(i - 1) as Pt, to), 1 / 2)]);
  const apartFrom = (outlines: readonly Segment[]) => Math.max(...points.map((p) => distanceTo(outlines, p)));
  const trials = params.flatMap(([q, { sizes }]) => {
    const choice = params.find(([each]) => each === sizes);
    if (!choice) return [];
    return (choice[1].choices ?? [])
      .filter((kind) => kind !== values[choice[0]])
      .map((kind) => {
        const other = contourWith({ [choice[0]]: kind, [q]: Number(values[q]) || size });
        return { q: choice[0], apart: apartFrom([...contour, ...other, ...endsBetween(contour, other)]) };
      });
  });
  const [best] = trials.toSorted((a, b) => a.apart - b.apart);
  return best && best.apart < EXPLAINED * apartFrom(contour) ? best.q : null;
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

/** The block of the element of a programmed contour nearest to a place; null where it is in another file. */
function shapingBlock({ contourLines, plan }: Operation, place: Pt, text: string): number | null {
  const apart = plan.contour.map((segment) => part.distanceTo(segment, place));
  const least = Math.min(...apart),
    line = contourLines?.[apart.indexOf(least)];
  if (!line || line.file !== undefined || least > NEAR) return null;
  const program = parse(text);
  const index = startLines(program).findLastIndex((start) => start <= line.line);
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
  { run, text }: Answer,
  { rule, operation, place, about, rings }: TaskMark,
): Pick<TaskMark, "shapedBy"> {
  if (!place || about !== undefined) return {};
  const [nearest] = run.operations.toSorted(
    (a, b) => distanceTo(a.plan.contour, place) - distanceTo(b.plan.contour, place),
  );
  const called = operation === undefined ? nearest : run.operations[operation];
  if (!called) return {};
  const { x = 0, z = 0 } = called.call?.datum ?? {};
  const region = rule === "residue" ? rings?.[0]?.map((p) => at(p.z - z, p.r - x)) : undefined;
  const q = (region && wrongElement(called, region)) ?? shapingParameter(called, at(place.z - z, place.r - x));
  if (q !== null) return { shapedBy: { q } };
  const block = shapingBlock(called, place, text);
  return block === null ? {} : { shapedBy: { block } };
}
