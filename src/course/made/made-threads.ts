import { producedParts } from "../../sim/produced-parts.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { at, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { axial, diameter, radius, rounded, toDiameter, toRadius } from "../../kernel/units.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { scanCrossings } from "../../sim/scan.ts";
import { threadMarks } from "../judge/threads.ts";
import type { Answer } from "../judge/judgement.ts";
import type { TargetThread } from "../target-part.ts";

/**
 * A thread that the task may require: its numbers come from the program, its name can be edited. A pitch of 0 is any
 * pitch.
 */
export interface ThreadDraft extends TargetThread {
  readonly pitch: number;
  readonly on: boolean;
}

/** Sampling distance along a thread on the profile of a part, mm. */
const STEP = 0.02;

const linesAlong = (left: number, right: number): readonly number[] =>
  Array.from({ length: Math.max(1, Math.floor((right - left) / STEP)) }, (_, i) => left + (i + 0.5) * STEP);

/**
 * The surface of a part at each line, mm on the radius: the farthest point outside, the nearest inside; undefined past
 * the part.
 */
const surfaceAt = (
  part: readonly Ring[],
  lines: readonly number[],
  isInside: boolean,
): readonly (number | undefined)[] =>
  scanCrossings(part, "r", lines).map((found) => (isInside ? found[0] : found.at(-1)));

/** The actual crest between two Z, mm on the radius; null without material. */
function crestIn(part: readonly Ring[], [left, right]: readonly [number, number], isInside: boolean): number | null {
  const found = surfaceAt(part, linesAlong(left, right), isInside).filter((r) => r !== undefined);
  if (found.length === 0) return null;
  return isInside ? Math.min(...found) : Math.max(...found);
}

/** The maximum of each value and its neighbours. */
const greatestNear = (values: readonly number[], reach: number): readonly number[] =>
  values.map((_, i) => Math.max(...values.slice(Math.max(0, i - reach), i + reach + 1)));

/**
 * The grooves of a thread as an area: up to the crest, and no higher than the material on both sides within a pitch, so
 * that a chamfer at the end is kept.
 */
export function grooveFilling({ from, to, crest, root, pitch }: ThreadDraft, part: readonly Ring[]): Ring {
  const isInside = root > crest,
    sign = isInside ? -1 : 1;
  const lines = linesAlong(Math.min(from, to) - 2 * pitch, Math.max(from, to) + 2 * pitch),
    reach = Math.ceil(pitch / STEP);
  const surface = surfaceAt(part, lines, isInside).map((r) => (r === undefined ? -Infinity : sign * r));
  const over = greatestNear(surface, reach),
    closed = greatestNear(
      over.map((r) => -r),
      reach,
    ).map((r) => sign * -r);
  const [top, bottom] = [toRadius(diameter(crest)), toRadius(diameter(root))];
  const shown = lines.flatMap((z, i) => {
    const r = closed[i] ?? NaN,
      so = isInside ? Math.max(r, top) : Math.min(r, top);
    return z > Math.min(from, to) && z < Math.max(from, to) && Number.isFinite(r) && sign * so > sign * bottom
      ? [{ z, r: so }]
      : [];
  });
  const [first, last] = [shown[0], shown.at(-1)];
  if (!first || !last) return [];
  const upper = shown.map(({ z, r }) => at(axial(z), radius(r)));
  const ring = [...upper, at(axial(last.z), bottom), at(axial(first.z), bottom)];
  return areaOf([ring]) < 0 ? ring.toReversed() : ring;
}

/** Greatest deviation of a thread on a cylinder, mm. */
const EVEN = 0.01;

/** The smallest and the greatest radius of a profile. */
function reachOf(profile: readonly Segment[]): readonly [number, number] {
  const all = profile.flatMap(({ from, to }) => [from.r, to.r]);
  return [Math.min(...all), Math.max(...all)];
}

const rough = (value: number): number => Math.round(value * 100) / 100;

/**
 * The threads that a program cuts along the axis, for a target part: from the start of the material to the end of the
 * cycle, from the actual crest to the root of the cycle. Threads on a cone or a face are not included: they remain a
 * shape.
 */
export function threadsOf(answer: Answer): readonly ThreadDraft[] {
  const { run, simulation } = answer;
  const body = boxAround([...producedParts(simulation)]);
  const found = new Map<string, ThreadDraft>();
  for (const { plan } of run.operations) {
    const { thread, contour, openSide } = plan,
      first = contour[0],
      last = contour.at(-1);
    if (!thread || !first || !last || Math.abs(openSide.r) < SAME) continue;
    const isInside = openSide.r < 0,
      [low, high] = reachOf(contour);
    // The contour of a thread is its profile: on a cylinder both halves have the same height and depth.
    const halves = [contour.slice(0, contour.length / 2), contour.slice(contour.length / 2)].map(reachOf);
    if (halves.some(([under, over]) => Math.abs(under - low) > EVEN || Math.abs(over - high) > EVEN)) continue;
    const [nominal, root] = isInside ? [low, high] : [high, low];
    const [from, to] = [Math.min(first.from.z, body.right), Math.max(last.to.z, body.left)];
    const crest = crestIn(producedParts(simulation), [Math.min(from, to), Math.max(from, to)], isInside);
    if (crest === null || Math.abs(from - to) < thread.pitch) continue;
    const across = (r: number) => rounded(toDiameter(radius(r)));
    const real = isInside ? Math.max(crest, nominal) : Math.min(crest, nominal);
    const made: ThreadDraft = {
      from: rounded(from),
      to: rounded(to),
      crest: across(real),
      root: across(root),
      pitch: rounded(thread.pitch),
      name: `M${rough(across(high))}×${rough(thread.pitch)}`,
      on: true,
    };
    // A thread that several calls cut is one thread, as deep as the deepest call.
    const place = `${made.from} ${made.to} ${made.pitch}`,
      other = found.get(place);
    if (!other || Math.abs(made.root - made.crest) > Math.abs(other.root - other.crest)) found.set(place, made);
  }
  return [...found.values()].map((thread) => ({
    ...thread,
    on: threadMarks([thread], answer).every(({ passed }) => passed),
  }));
}

/** A thread as a task states it. */
export const targetThread = ({ on: _, pitch, ...thread }: ThreadDraft): TargetThread => ({
  ...thread,
  ...(pitch > 0 && { pitch }),
});
