import { extent, moved, type Convex } from "../reach/convex.ts";
import { heightAt, push, valueAt, type Envelope, type Interval, type Span } from "../reach/envelope.ts";
import { cuttingWidth, isBar, noseRadius } from "../cutter/insert.ts";
import { JOINED, SAME } from "../tolerance.ts";
import type { Tool } from "../plan/tool.ts";
import { length } from "../units.ts";
import type { Flat } from "../geometry/flat.ts";

/*
 * The tool fits a channel of exactly its own width at a single place, which an envelope cannot represent. To close the
 * set of tip positions, the tip gets a slot wherever a tool narrower by SAME goes deeper between two walls.
 */

/**
 * Width of such a slot if nothing deeper adjoins it, mm: wider than the gaps that envelopes join, narrower than any
 * move.
 */
const SLOT = 10 * JOINED;

/** Tolerance of a channel's width, mm: SAME, plus room for the slot in a channel narrower by all of SAME. */
const NARROWER = SAME + 4 * SLOT;

/** A bar or a button narrower by that tolerance; null for other tools, which have no two sides to fit. */
export function narrowerTool(tool: Tool): Tool | null {
  if (isBar(tool) && cuttingWidth(tool) > 2 * NARROWER)
    return { ...tool, CUTWIDTH: length((tool.CUTWIDTH ?? 0) - NARROWER) };
  return tool.TYPE === "BUTTON" && noseRadius(tool) > NARROWER ? { ...tool, RS: length(tool.RS - NARROWER / 2) } : null;
}

/** A shape moved to the middle of another one, on its lowest point. */
export function centredIn(slim: Convex, shape: Convex): Convex {
  const [inner, outer] = [extent(slim), extent(shape)];
  return moved(slim, { u: (outer.minU + outer.maxU - inner.minU - inner.maxU) / 2, v: outer.minV - inner.minV });
}

/** An envelope with these slots, as deep there as the envelope of the slim tool. */
export function withSlots(e: Envelope, slim: Envelope, slots: readonly Interval[]): Envelope {
  return slots.reduce(
    (all, { from, to }) => [
      ...between(all, -Infinity, from),
      ...between(slim, from, to),
      ...between(all, to, Infinity),
    ],
    e,
  );
}

/**
 * The slot at the deepest place of each channel: between two walls that the slim tool passes, no farther apart than the
 * difference, and the tool itself does not. The slot extends to the deepest adjoining place of the tool itself, so that
 * no wall remains in between.
 */
export function channelsOf(e: Envelope, slim: Envelope): Interval[] {
  const found: Interval[] = [];
  for (let i = 1; i < slim.length - 1; i += 1) {
    const [before, from] = [slim[i - 1] as Span, (slim[i] as Span).u0];
    const places: Flat[] = [];
    for (let j = i; j < slim.length - 1; j += 1) {
      const [{ piece, u0, u1 }, after] = [slim[j] as Span, slim[j + 1] as Span];
      if (u1 - from > 2 * NARROWER) break;
      places.push(...[u0, (u0 + u1) / 2, u1].map((u) => ({ u, v: valueAt(piece, u) })));
      const low = Math.min(...places.map((p) => p.v));
      if (Math.min(valueAt(before.piece, before.u1), valueAt(after.piece, after.u0)) <= low + SAME) continue;
      // If a wall is inclined, the floor is not in the middle.
      const floor = places.filter((p) => p.v <= low + SAME).map((p) => p.u);
      const middle = (Math.min(...floor) + Math.max(...floor)) / 2;
      const high = heightAt(e, middle);
      if (high > low + SAME) {
        const [a, b] = [middle - SLOT / 2, middle + SLOT / 2];
        const own = deepestBeside(e, from - NARROWER, u1 + NARROWER);
        found.push(own.v < high - SAME ? { from: Math.min(a, own.u), to: Math.max(b, own.u) } : { from: a, to: b });
      }
      i = j;
      break;
    }
  }
  return found;
}

/** The deepest place of an envelope between two places, at the ends of its pieces. */
function deepestBeside(e: Envelope, from: number, to: number): Flat {
  let deepest: Flat = { u: from, v: Infinity };
  for (const { piece, u0, u1 } of between(e, from, to))
    for (const u of [u0, u1]) {
      const v = valueAt(piece, u);
      if (v < deepest.v) deepest = { u, v };
    }
  return deepest;
}

function between(e: Envelope, from: number, to: number): Span[] {
  const out: Span[] = [];
  for (const s of e) push(out, s.piece, Math.max(s.u0, from), Math.min(s.u1, to));
  return out;
}

/**
 * Ends of a path along a contour: an end next to a slot moves to its far side, so that the path leads through the slot.
 */
export function endsBeyondSlots(start: Flat, end: Flat, slots: readonly Interval[]): readonly [Flat, Flat] {
  const beside = ({ u }: Flat) => slots.find(({ from, to }) => u >= from - NARROWER && u <= to + NARROWER);
  return [
    { ...start, u: Math.min(start.u, beside(start)?.from ?? start.u) },
    { ...end, u: Math.max(end.u, beside(end)?.to ?? end.u) },
  ];
}
