import { extent, moved, type Convex } from "../convex.ts";
import { heightAt, push, valueAt, type Envelope, type Span } from "../envelope.ts";
import { cuttingWidth, isBar, noseRadius } from "../insert.ts";
import { JOINED, SAME } from "../tolerance.ts";
import type { Tool } from "../tool.ts";
import { length } from "../units.ts";
import type { Flat } from "../flat.ts";

/*
 * A channel exactly as wide as the tool lets it in at one single place, and an envelope has none without a width. So the set of tip
 * positions is closed: where a tool narrower by SAME goes deeper between two walls than the tool itself, the tip has a slot.
 */

/** Width of such a slot, mm: wider than what envelopes join, narrower than any move. */
export const SLOT = 10 * JOINED;

/** How much narrower than the tool a channel may be, mm, with room for the slot in one that is narrower by all of SAME. */
const NARROWER = SAME + 4 * SLOT;

/** A bar or a button that is narrower by that; null where no other tool has two sides to fit with. */
export function slimmed(tool: Tool): Tool | null {
  if (isBar(tool) && cuttingWidth(tool) > 2 * NARROWER) return { ...tool, CUTWIDTH: length((tool.CUTWIDTH ?? 0) - NARROWER) };
  return tool.TYPE === "BUTTON" && noseRadius(tool) > NARROWER ? { ...tool, RS: length(tool.RS - NARROWER / 2) } : null;
}

/** A shape moved to stand in the middle of another one, on its lowest point. */
export function centredIn(slim: Convex, shape: Convex): Convex {
  const [inner, outer] = [extent(slim), extent(shape)];
  return moved(slim, { u: (outer.minU + outer.maxU - inner.minU - inner.maxU) / 2, v: outer.minV - inner.minV });
}

/** An envelope with slots at these places, as deep as the envelope of the slim tool is there. */
export function withSlots(e: Envelope, slim: Envelope, places: readonly number[]): Envelope {
  return places.reduce((all, u) => {
    const [from, to] = [u - SLOT / 2, u + SLOT / 2];
    return [...between(all, -Infinity, from), ...between(slim, from, to), ...between(all, to, Infinity)];
  }, e);
}

/** The middle of each channel: between two walls that the slim tool passes, no farther apart than the difference, and the tool does not. */
export function channelsOf(e: Envelope, slim: Envelope): number[] {
  const found: number[] = [];
  for (let i = 1; i < slim.length - 1; i += 1) {
    const [before, from] = [slim[i - 1] as Span, (slim[i] as Span).u0];
    let low = Infinity;
    for (let j = i; j < slim.length - 1; j += 1) {
      const [{ piece, u0, u1 }, after] = [slim[j] as Span, slim[j + 1] as Span];
      if (u1 - from > 2 * NARROWER) break;
      low = Math.min(low, valueAt(piece, u0), valueAt(piece, (u0 + u1) / 2), valueAt(piece, u1));
      if (Math.min(valueAt(before.piece, before.u1), valueAt(after.piece, after.u0)) <= low + SAME) continue;
      const middle = (from + u1) / 2;
      if (heightAt(e, middle) > low + SAME) found.push(middle);
      i = j;
      break;
    }
  }
  return found;
}

function between(e: Envelope, from: number, to: number): Span[] {
  const out: Span[] = [];
  for (const s of e) push(out, s.piece, Math.max(s.u0, from), Math.min(s.u1, to));
  return out;
}

/** The ends of a path along a contour; where the tool fits exactly between them, they lie on either side of its slot. */
export function besideSlot(start: Flat, end: Flat, places: readonly number[]): readonly [Flat, Flat] {
  const u = places.find((place) => Math.max(Math.abs(place - start.u), Math.abs(place - end.u)) <= NARROWER);
  return u === undefined ? [start, end] : [{ ...start, u: u - SLOT / 2 }, { ...end, u: u + SLOT / 2 }];
}
