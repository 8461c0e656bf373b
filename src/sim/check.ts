import { areaOf, difference, intersection, opened } from "../kernel/clip.ts";
import type { Ring } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { boxAround, inBox } from "./box.ts";
import type { Cutting } from "./cutting.ts";
import type { Edges } from "./edges.ts";
import type { Outlines } from "./outlines.ts";
import { piecesOf, type Piece } from "./piece.ts";
import { largest, placeIn } from "./region.ts";
import type { Finding } from "./simulation.ts";
import { sweepOf } from "./sweep.ts";

/** Smaller areas are chord and grid errors of two curves that touch, mm². */
export const REAL_AREA = 0.01;
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
export function inStock(pieces: readonly Piece[], cut: Pick<Cutting, "initial" | "meets" | "swept">, within: readonly Ring[] | null = null, also: readonly Ring[] = []): Ring[] {
  const near = pieces.filter((p) => cut.meets(p)).map((p) => p.ring);
  if (near.length === 0) return [];
  const box = boxAround(near);
  const area = within ? intersection(inBox(within, box), near) : near;
  if (area.length === 0) return [];
  const there = intersection(inBox(cut.initial, box), area);
  const gone = inBox([...cut.swept(), ...also], box);
  return gone.length === 0 || there.length === 0 ? there : difference(there, gone);
}

/** The holder touches what neither the moves before nor this one, up to the same moment, have cut away. */
function holderHits(step: Step, outlines: Outlines, cut: Cutting): Ring[] {
  const parts = (fraction?: number) => piecesOf(outlines.holder.flatMap((part) => sweepOf(part, step, fraction)));
  const whole = parts();
  if (real(inStock(whole, cut)).length === 0) return [];
  for (let i = 1; i <= PARTS; i += 1) {
    const hit = real(inStock(parts(i / PARTS), cut, null, sweepOf(outlines.insert, step, i / PARTS)));
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
  // The quick look joins many pieces at once; what it finds is looked at again in the stock itself.
  const sure = (area: Ring[]) => (area.length === 0 ? area : real(intersection(cut.stock(), area)));
  if (step.move.kind === "rapid") report("rapidInStock", sure(real(inStock(sweep, cut))));
  const deep = sweep.filter((p) => finished.edges.meets(p));
  if (deep.length > 0) report("gouge", sure(real(inStock(deep, cut, finished.rings))));
  report("holderContact", sure(holderHits(step, outlines, cut)));
  return found;
}
