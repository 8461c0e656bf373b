import { insertOutline } from "../../kernel/cutter/insert.ts";
import { at, part } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { pathOf } from "../../kernel/time/time.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { boundsOf, grownBounds, joined } from "../bounds.ts";
import { toScreen, type Bounds, type Camera } from "../camera.ts";
import type { ChuckDrawing } from "./chuck.ts";
import type { Patch } from "./pen.ts";

/** Chord tolerance of inserts, mm; the boxes are larger by it. */
const COARSE = 0.05;
const NOTHING: Bounds = { left: 0, right: 0, low: 0, high: 0 };
const inserts = new WeakMap<Tool, Bounds>();

function insertBox(tool: Tool): Bounds {
  const known = inserts.get(tool);
  if (known) return known;
  const made = grownBounds(boundsOf(insertOutline(tool, COARSE)) ?? NOTHING, COARSE);
  inserts.set(tool, made);
  return made;
}

/** Samples of an arc, and the share of their box's size by which the arc may leave the box. */
const ARC_LOOKS = 8;
const BULGE = 0.05;

/** The box round the tip's path through a step between two fractions. */
function wayBox({ from, move }: Step, begin: number, end: number): Bounds | null {
  const path = pathOf(from, move);
  if (path.kind !== "arc") return boundsOf([part.pointOn(path, begin), part.pointOn(path, end)]);
  const looks = Array.from({ length: ARC_LOOKS + 1 }, (_, i) =>
    part.pointOn(path, begin + ((end - begin) * i) / ARC_LOOKS),
  );
  const box = boundsOf(looks);
  return box && grownBounds(box, BULGE * Math.max(box.right - box.left, box.high - box.low));
}

/** Limit of moves between two moments that are checked one by one; with more, everything counts as touched. */
const MOST_STEPS = 400;

/**
 * The box in which the stock of two moments of a run may differ, mm: the area of the inserts between them. Null if
 * there is none, "all" if the moments are too far apart to check.
 */
export function changedBox(steps: readonly Step[], one: PlayPosition, other: PlayPosition): Bounds | "all" | null {
  const swap = other.step < one.step || (other.step === one.step && other.fraction < one.fraction);
  const [a, b] = swap ? [other, one] : [one, other];
  if (b.step - a.step > MOST_STEPS) return "all";
  let box: Bounds | null = null;
  for (let i = a.step; i <= b.step && i < steps.length; i += 1) {
    const step = steps[i] as Step;
    const end = i === b.step ? b.fraction : 1;
    if (end <= 0) continue;
    const way = wayBox(step, i === a.step ? a.fraction : 0, end);
    const insert = insertBox(step.tool);
    if (way) {
      box = joined(box, {
        left: way.left + insert.left,
        right: way.right + insert.right,
        low: way.low + insert.low,
        high: way.high + insert.high,
      });
    }
  }
  return box;
}

/** Margin of a box for its edge lines, pixels. */
const EDGE = 3;

/** Limit of CSS pixels tried for a whole number of device pixels, and the tolerance of that number. */
const MOST_WHOLE = 20,
  MISSES = 1 / 1000;

/**
 * The fewest CSS pixels that are whole device pixels at `ratio`: a canvas that begins between two pixels is drawn off
 * its place, and leaves a seam to the canvas below.
 */
export function wholePixels(ratio: number): number {
  for (let n = 1; n <= MOST_WHOLE; n += 1) if (Math.abs(n * ratio - Math.round(n * ratio)) < MISSES) return n;
  return 1 / ratio;
}

/**
 * The part of the picture that shows a box, with room for edge lines; on whole device pixels at `ratio`, or on
 * multiples of `whole` CSS pixels.
 */
export function patchOf({ left, right, low, high }: Bounds, camera: Camera, ratio: number, whole = 1 / ratio): Patch {
  const [a, b] = [toScreen(camera, at(left, low)), toScreen(camera, at(right, high))];
  const before = (v: number) => Math.floor((v - EDGE) / whole) * whole;
  const after = (v: number) => Math.ceil((v + EDGE) / whole) * whole;
  const x = before(Math.min(a.x, b.x)),
    y = before(Math.min(a.y, b.y));
  return { x, y, width: after(Math.max(a.x, b.x)) - x, height: after(Math.max(a.y, b.y)) - y };
}

/**
 * The patch that changes if the stock changes in a box. Round steel is shaded from the axis to its edge on both sides,
 * no farther out than `outer` mm, and a thread shows on its other side up to `along` mm away.
 */
export function turnedPatchOf(
  { left, right, high }: Bounds,
  camera: Camera,
  { outer, along }: { readonly outer: number; readonly along: number },
  ratio: number,
): Patch {
  const far = Math.min(high, outer);
  return patchOf({ left: left - along, right: right + along, low: -far, high: far }, camera, ratio, wholePixels(ratio));
}

/** The patch that shows the clamping. */
export const chuckPatch = ({ all, limit }: ChuckDrawing, camera: Camera, ratio: number): Patch => {
  const far = limit ? all.high * 1.5 : all.high,
    right = Math.max(all.right, limit?.z ?? all.right);
  return patchOf(
    { left: Math.min(all.left, limit?.z ?? all.left), right, low: -far, high: far },
    camera,
    ratio,
    wholePixels(ratio),
  );
};

/** The part of a patch inside another one; null if there is none. */
export function patchWithin(patch: Patch, room: Patch): Patch | null {
  const x = Math.max(room.x, patch.x),
    y = Math.max(room.y, patch.y);
  const width = Math.min(room.x + room.width, patch.x + patch.width) - x;
  const height = Math.min(room.y + room.height, patch.y + patch.height) - y;
  return width > 0 && height > 0 ? { x, y, width, height } : null;
}
