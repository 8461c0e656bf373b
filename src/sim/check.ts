import { areaOf, difference, intersection, opened } from "../kernel/clip.ts";
import type { Ring } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { boxAround, inBox } from "./box.ts";
import { merged, type Cutting, type Present } from "./cutting.ts";
import type { Edges } from "./edges.ts";
import type { Outlines } from "./outlines.ts";
import { piecesOf, type Piece } from "./piece.ts";
import { largest, placeIn } from "./region.ts";
import type { Finding } from "./simulation.ts";
import { notBehind, sweepOf } from "./sweep.ts";

/** Smaller areas are chord and grid errors of two curves that touch, mm². */
export const REAL_AREA = 0.01;
/** Moves that do damage, after which damage is no longer looked for: looking costs far more where there is some. */
export const MOST_CONTACTS = 1000;
/** A holder on an arc is looked at along chords this near to it, mm. */
const HOLDER_CHORD = 0.01;
/** A move is looked at in this many parts to tell whether the holder or the edge comes first. */
const PARTS = 16;

/** The finished part (shrunk) with its edges, to see gouges. */
export interface Finished {
  readonly rings: readonly Ring[];
  readonly edges: Edges;
}

/** An area without slivers; nothing when that is too small to be true. */
export const real = (area: Ring[]): Ring[] => {
  if (areaOf(area) < REAL_AREA) return [];
  const thick = opened(area, SLIVER);
  return areaOf(thick) < REAL_AREA ? [] : thick;
};

/** What pieces have in common with an area and with the stock as it is now. */
export function inStock(pieces: readonly Piece[], now: Present, within: readonly Ring[] | null = null): Ring[] {
  const near = pieces.filter((p) => now.meets(p)).map((p) => p.ring);
  if (near.length === 0) return [];
  const box = boxAround(near);
  const whole = merged(near);
  const area = within ? intersection(inBox(within, box), whole) : whole;
  if (area.length === 0) return [];
  const there = intersection(inBox(now.base, box), area);
  const gone = inBox(now.gone, box);
  return gone.length === 0 || there.length === 0 ? there : difference(there, gone);
}

/**
 * The holder touches what neither the moves before nor this one, up to the same moment, have cut away. On a straight way the
 * insert is there first where a point of the holder lies behind it; on an arc it is looked at part by part.
 */
function holderHits(step: Step, outlines: Outlines, now: Present): Ring[] {
  const rings = (parts: readonly Ring[], fraction = 1) => parts.flatMap((part) => sweepOf(part, step, fraction, HOLDER_CHORD));
  const swept = (parts: readonly Ring[], fraction?: number) => merged(rings(parts, fraction));
  const touched = inStock(piecesOf(rings(outlines.holder)), now);
  if (areaOf(touched) < REAL_AREA) return [];
  const left = real(difference(touched, swept([outlines.insert])));
  if (left.length > 0) return left;
  if (step.move.kind !== "arc") {
    const ahead = outlines.holder.flatMap((part) => notBehind(part, outlines.insert, step.from, step.move.to));
    return ahead.length === 0 ? [] : real(intersection(touched, swept(ahead)));
  }
  for (let i = 1; i <= PARTS; i += 1) {
    const reached = intersection(touched, swept(outlines.holder, i / PARTS));
    const hit = reached.length === 0 ? [] : real(difference(reached, swept([outlines.insert], i / PARTS)));
    if (hit.length > 0) return hit;
  }
  return [];
}

/** What goes wrong in a step, before its sweep is taken from the stock. */
export function check(
  step: Step, index: number, outlines: Outlines, sweep: readonly Piece[], cut: Cutting, finished: Finished,
): Finding[] {
  const found: Finding[] = [];
  const report = (kind: Finding["kind"], rings: Ring[]) => {
    if (rings.length > 0)
      found.push({ kind, step: index, block: step.block, operation: step.operation, place: placeIn(largest(rings)), area: areaOf(rings), rings, moves: 1 });
  };
  const now = cut.present();
  // The quick look joins many pieces at once; what it finds is looked at again in the stock itself.
  const sure = (area: Ring[]) => (area.length === 0 ? area : real(intersection(cut.stock(), area)));
  if (step.move.kind === "rapid") report("rapidInStock", sure(real(inStock(sweep, now))));
  const deep = sweep.filter((p) => finished.edges.meets(p));
  if (deep.length > 0) report("gouge", sure(real(inStock(deep, now, finished.rings))));
  report("holderContact", sure(holderHits(step, outlines, now)));
  return found;
}
