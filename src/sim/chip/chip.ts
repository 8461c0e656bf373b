import { areaOf } from "../../kernel/area/area.ts";
import { boxAround, boxBeyond, inBox } from "../../kernel/area/box.ts";
import { difference, intersection } from "../../kernel/area/clip.ts";
import { at, part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { stampsOf } from "../../kernel/time/thread-turns.ts";
import { pathOf } from "../../kernel/time/time.ts";
import { SLIVER } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Present } from "../cutting.ts";
import { feedPerTurn, rpmAt, spindleAt, type SpindleFrom } from "../load/spindles.ts";
import { convexPieceOf } from "../piece.ts";
import type { PlayPosition } from "../simulation.ts";
import { sweptBy } from "../sweep.ts";
import { boundsOfChip, contactLength, reachAlong, thickestOf, type Thickness } from "./edge.ts";
import { oneTurnBack } from "./one-turn.ts";

/**
 * The chip at one moment in the half plane: stock under the insert now that it did not cover one spindle revolution
 * earlier. Places are relative to the tip, so that the chip of an even cut does not change. mm.
 */
export interface Chip {
  readonly rings: readonly Ring[];
  /** The engaged parts of the cutting edge. */
  readonly contact: readonly (readonly Pt[])[];
  /** The greatest thickness, square to the edge. */
  readonly thickest: Thickness;
  /** Length of the engaged edge. */
  readonly width: number;
  /** Depth of cut: the extent square to the feed. Width of a plunging blade, infeed of a thread. */
  readonly depth: number;
  /** Feed per revolution; the lead of a thread. */
  readonly feed: number;
  /** mm². */
  readonly area: number;
}

/** Inputs for the chip at any moment. */
export interface ChipWork {
  readonly steps: readonly Step[];
  /** Convex, counter-clockwise, relative to the tip. */
  readonly outlineOf: (tool: Tool) => Ring;
  readonly spindles: readonly SpindleFrom[];
  /** The stock at the start of a step. */
  readonly before: (step: number) => Present;
}

const movedBy = (ring: Ring, z: number, r: number): Ring => ring.map((p) => at(p.z + z, p.r + r));

/** The stock under an insert at the start of a step, less what the step covers up to a fraction. */
function taken(insert: Ring, now: Present, step: Step, outline: Ring, fraction: number): Ring[] {
  if (!now.meets(convexPieceOf(insert))) return [];
  const there = intersection(inBox(now.base, boxBeyond([insert])), [insert]);
  if (there.length === 0) return [];
  const box = boxBeyond(there);
  const gone = [...inBox(now.gone, box), ...inBox(sweptBy(outline, step, fraction).rings, box)];
  return gone.length === 0 ? there : difference(there, gone);
}

/** Extent of rings along a direction, mm. */
function extentAlong(rings: readonly Ring[], way: Pt): number {
  let [least, most] = [Infinity, -Infinity];
  for (const ring of rings)
    for (const p of ring) {
      const far = part.dot(p, way);
      least = Math.min(least, far);
      most = Math.max(most, far);
    }
  return Math.max(0, most - least);
}

/** Rings without slivers that are only chord and grid error. */
const thick = (rings: readonly Ring[]): Ring[] =>
  rings.filter(
    (ring) => areaOf([ring]) > SLIVER * SLIVER && areaOf([ring]) > (SLIVER * part.apart(...diagonal(ring))) / 2,
  );

function diagonal(ring: Ring): [Pt, Pt] {
  const { left, right, low, high } = boxAround([ring]);
  return [at(left, low), at(right, high)];
}

/** The chip of a piece of the stock under the insert at `tip`; null where there is none. */
function chipOf(
  found: readonly Ring[],
  outline: Ring,
  tip: Pt,
  step: Step,
  path: { readonly feed: number; readonly along: Pt },
): Chip | null {
  const cut = thick(found);
  if (cut.length === 0) return null;
  const rings = cut.map((ring) => movedBy(ring, -tip.z, -tip.r));
  const bounded = boundsOfChip(rings, outline),
    thickest = thickestOf(bounded);
  if (!thickest || thickest.size < SLIVER) return null;
  const across = part.leftOf(path.along);
  return {
    rings,
    contact: bounded.contact,
    thickest,
    width: contactLength(bounded),
    depth: step.move.kind === "thread" ? reachAlong(bounded, across) : extentAlong(rings, across),
    feed: path.feed,
    area: areaOf(rings),
  };
}

/** The chip at a moment of a run; null on rapids, in the air, and where the feed of a turn is not known. */
export function chipAt({ steps, outlineOf, spindles, before }: ChipWork, position: PlayPosition): Chip | null {
  const step = steps[position.step];
  if (!step || step.move.kind === "rapid") return null;
  const path = pathOf(step.from, step.move),
    outline = outlineOf(step.tool);
  if (outline.length < 3) return null;
  if (step.move.kind === "thread") {
    const passed = stampsOf(step.from, step.move).filter(({ fraction }) => fraction <= position.fraction),
      last = passed.at(-1);
    if (!last) return null;
    const found = taken(
      movedBy(outline, last.at.z, last.at.r),
      before(position.step),
      step,
      outline,
      passed.at(-2)?.fraction ?? 0,
    );
    return chipOf(found, outline, last.at, step, {
      feed: Math.abs(step.move.pitch),
      along: part.direction(path, last.at),
    });
  }
  const tip = part.pointOn(path, position.fraction),
    feed = feedPerTurn(step.move, rpmAt(spindleAt(spindles, position.step), tip.r));
  const stands = step.move.kind === "feed" && step.move.dwell !== undefined;
  const back = stands ? null : oneTurnBack(steps, position, spindles),
    earlier = back && steps[back.step];
  if (!earlier) return null;
  const found = taken(movedBy(outline, tip.z, tip.r), before(back.step), earlier, outline, back.fraction);
  return chipOf(found, outline, tip, step, { feed, along: part.direction(path, tip) });
}

/** Chips that differ by more than this are redrawn, mm. */
const ALIKE = 5e-4;

/** Whether two chips look the same: the chips of an even cut differ only by the grid. */
export function sameChip(a: Chip | null, b: Chip | null): boolean {
  if (!a || !b) return a === b;
  const near = (p: number, q: number) => Math.abs(p - q) <= ALIKE;
  return (
    near(a.area, b.area) &&
    near(a.width, b.width) &&
    near(a.depth, b.depth) &&
    near(a.feed, b.feed) &&
    a.rings.length === b.rings.length &&
    a.rings.every((ring, i) => {
      const other = b.rings[i];
      return (
        other?.length === ring.length &&
        ring.every((p, k) => near(p.z, other[k]?.z ?? NaN) && near(p.r, other[k]?.r ?? NaN))
      );
    })
  );
}
