import { isPosition } from "../../../cycles/completions.ts";
import { cycleByNumber } from "../../../cycles/index.ts";
import type { SomeValues } from "../../../cycles/effect.ts";
import type { Param, Params } from "../../../cycles/params.ts";
import { part, type Pt, type Segment } from "../../../kernel/geometry/point.ts";
import { pathOf } from "../../../kernel/time/time.ts";
import { axial, diameter, radius, toRadius } from "../../../kernel/units.ts";
import type { ContourRow } from "../../../program/job/job.ts";
import { readRows } from "../../../program/job/contour-rows.ts";
import { contourOf, type MoveSpan } from "../../../program/run/path-index.ts";
import type { Run } from "../../../program/state/run-types.ts";
import {
  isSameLength,
  isWithin,
  measuredSegments,
  type MeasuredFeature,
} from "../../../view/drawing/measured-feature.ts";

/** Where a program states a size of a drawing: a value of a cycle, or a block of a contour or of a path. */
export interface SizeSource {
  /** Line of the block in the main program, from 1; or its index. */
  readonly at: { readonly line: number } | { readonly index: number };
  readonly q: string | null;
}

const valueOf = (values: SomeValues, q: string): number | null => {
  const value = values[q];
  return typeof value === "number" ? value : null;
};

/** Whether a value of a cycle is the size of a feature. */
function states(feature: MeasuredFeature, param: Param, value: number, values: SomeValues): boolean {
  switch (feature.kind) {
    case "diameter":
      return isPosition(param) && param.kind === "diameter" && isWithin(feature.limits, toRadius(diameter(value)));
    case "length":
      return isPosition(param) && param.kind === "axial" && isWithin(feature.limits, value);
    case "corner": {
      const isElement = param.sizes !== undefined && valueOf(values, param.sizes) !== 0;
      return (isElement || param.rounds) && isSameLength(value, feature.size);
    }
    // The angle of a face counts from across the axis.
    case "angle":
      return (
        param.kind === "angle" && [feature.degrees, 90 - feature.degrees].some((each) => isSameLength(value, each))
      );
  }
}

/** The corner of a contour that the positions of a cycle make at one of its ends; null while one is missing. */
function cornerAt(params: Params, values: SomeValues, place: Param["place"]): Pt | null {
  const find = (kind: Param["kind"]) => {
    const found = Object.entries<Param>(params).find(([, p]) => isPosition(p) && p.kind === kind && p.place === place);
    return found ? valueOf(values, found[0]) : null;
  };
  const [x, z] = [find("diameter"), find("axial")];
  return x === null || z === null ? null : { z: axial(z), r: toRadius(diameter(x)) };
}

/** The place on the part that stands for a feature; null for a length, which is the same all round. */
function placeOf(feature: MeasuredFeature): Pt | null {
  if (feature.kind === "length") return null;
  if (feature.kind === "corner" || feature.kind === "angle") return feature.places[0] ?? null;
  return { z: axial((feature.left + feature.right) / 2), r: radius(feature.r) };
}

/**
 * The prompt of a cycle whose value a size of the drawing is. Of several with that value it is the one for the nearer
 * end of the contour. Null if no value is this size.
 */
export function promptOfSize(params: Params, values: SomeValues, feature: MeasuredFeature): string | null {
  const place = placeOf(feature);
  const distance = (param: Param): number => {
    const corner = place && cornerAt(params, values, param.place);
    return corner ? part.apart(corner, place) : 0;
  };
  const found = Object.entries<Param>(params).flatMap(([q, param]) => {
    const value = valueOf(values, q);
    return value !== null && states(feature, param, value, values) ? [{ q, far: distance(param) }] : [];
  });
  return found.sort((a, b) => a.far - b.far)[0]?.q ?? null;
}

/** The id of the row of a contour table that makes a size, and its number from 1; null if none does. */
export function rowOfSize(
  rows: readonly ContourRow[],
  feature: MeasuredFeature,
): { id: string; number: number } | null {
  const { rowOfSegment, contour } = readRows(rows);
  const [segment] = measuredSegments(feature, contour.segments);
  const index = segment === undefined ? undefined : rowOfSegment[segment];
  const row = index === undefined ? undefined : rows[index];
  return row && index !== undefined ? { id: row.id, number: index + 1 } : null;
}

/** Feed moves outside of cycles, within some steps or in the whole run, with their steps. */
export function writtenMoves(
  { steps }: Run,
  within?: readonly MoveSpan[],
): readonly { segment: Segment; step: number }[] {
  const spans = within ?? [{ first: 0, last: steps.length - 1 }];
  return spans.flatMap(({ first, last }) =>
    steps
      .slice(first, last + 1)
      .flatMap(({ from, move, operation }, i) =>
        operation === null && move.kind !== "rapid" ? [{ segment: pathOf(from, move), step: first + i }] : [],
      ),
  );
}

/** What makes a size in a program: a value of a called cycle, an element of its contour, or a block of the path. */
export function sourceOfSize(run: Run, feature: MeasuredFeature): SizeSource | null {
  for (const operation of run.operations) {
    if (operation.definedFile !== undefined || !operation.call) continue;
    const params = cycleByNumber(operation.cycle)?.params;
    const q = params ? promptOfSize(params, operation.call.values as SomeValues, feature) : null;
    if (q !== null) return { at: { line: operation.definedLine }, q };
    const [segment] = measuredSegments(feature, contourOf(operation));
    const line = segment === undefined ? undefined : operation.contourLines?.[segment];
    if (line && line.file === undefined) return { at: { line: line.line }, q: null };
    // A size that follows from several values: the end of a cone.
    if (measuredSegments(feature, operation.plan.contour).length > 0)
      return { at: { line: operation.definedLine }, q: null };
  }
  const moves = writtenMoves(run);
  const [found] = measuredSegments(
    feature,
    moves.map(({ segment }) => segment),
  );
  const index = found === undefined ? undefined : run.stepBlocks[moves[found]?.step ?? -1];
  return index === undefined ? null : { at: { index }, q: null };
}
