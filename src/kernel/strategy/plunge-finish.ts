import { heightAt, pathAlong } from "../reach/envelope.ts";
import { flat, type FlatSegment } from "../geometry/flat.ts";
import { SAME } from "../tolerance.ts";
import type { Purpose } from "../plan/track.ts";
import type { Basin } from "./basins.ts";
import type { TipEnvelope } from "./tip-envelope.ts";
import type { Cutter } from "./link.ts";
import { liftUnder } from "./valley.ts";

export interface PlungeFinish {
  readonly ground: TipEnvelope;
  readonly basins: readonly Basin[];
  /** Height in front of the recess at which the tool may travel. */
  readonly top: number;
  readonly clearance: number;
  readonly feed: number;
}

const p = (step: number): Purpose => ({ phase: "finish", run: "finish", step });

/**
 * The steps 1 to 7 of finishing by plunging: in each section down one wall and along half of its floor, then down the
 * other wall.
 */
export function finishByHalves(cutter: Cutter, f: PlungeFinish): void {
  const e = f.ground.envelope;
  const link = (step: number) => ({ gap: f.clearance, feed: f.feed, out: p(step), down: p(step), enter: p(step) });
  const out = (step: number) => cutter.link({ u: cutter.at.u, v: f.top }, link(step));
  for (const { from, to, floor, bottom } of f.basins) {
    const middle = (floor.from + floor.to) / 2;
    const level = (s: FlatSegment) => Math.abs(s.from.v - bottom) < SAME && Math.abs(s.to.v - bottom) < SAME;
    const half = (begin: number, path: readonly FlatSegment[], step: number, away: 1 | -1) => {
      const high = Math.max(heightAt(e, begin), path[0]?.from.v ?? bottom);
      cutter.link({ u: begin, v: Math.min(f.top, high + f.clearance) }, link(step));
      cutter.along(path, (s) => ({ feed: f.feed, purpose: p(level(s) ? step + 2 : step + 1) }));
      cutter.feed({ u: middle, v: bottom }, f.feed, p(step + 2));
      cutter.leave(liftUnder(f.top, cutter.at.v, f.clearance), away, e, f.feed, p(step + 2), Math.abs(middle - begin));
      out(step + 3);
    };
    half(
      from,
      pathAlong(e, from, middle).map((s) => s.segment),
      1,
      -1,
    );
    // A tool as wide as the groove has finished both walls and the floor.
    if (to - from > SAME)
      half(
        to,
        pathAlong(e, middle, to)
          .map((s) => flat.reversed(s.segment))
          .reverse(),
        5,
        1,
      );
  }
}
