import { heightAt, lowest, pathAlong } from "../envelope.ts";
import { flat, type FlatSegment } from "../flat.ts";
import { SAME } from "../tolerance.ts";
import type { Purpose } from "../track.ts";
import type { Ground } from "./ground.ts";
import type { Cutter } from "./link.ts";
import { containing, deepestIn, RECESS_CLEARANCE } from "./valley.ts";

export interface RecessFinish {
  readonly ground: Ground;
  /** Height in front of the recess at which the tool may travel. */
  readonly top: number;
  readonly feed: number;
  /** The whole groove in one cut; otherwise from both walls, meeting on the floor. */
  readonly oneGo: boolean;
  /** Distance to keep from the second wall while its oversize still stands, mm. */
  readonly apart: number;
  readonly span: { readonly from: number; readonly to: number };
}

const p = (step: number): Purpose => ({ phase: "finish", run: "finish", step });

/** The printed finishing steps 1 to 6 of a recess; going back to the cycle start is the caller's. */
export function finishRecess(cutter: Cutter, f: RecessFinish): void {
  const e = f.ground.envelope;
  const bottom = lowest(e, f.span.from, f.span.to);
  const floor = containing(e, bottom, f.span, deepestIn(e, bottom, f.span));
  const [left, right] = [f.ground.start.u, f.ground.end.u];
  const onFloor = (s: FlatSegment) => s.kind === "line" && Math.abs(s.from.v - bottom) < SAME && Math.abs(s.to.v - bottom) < SAME;
  const link = (step: number) => ({ gap: RECESS_CLEARANCE, feed: f.feed, out: p(step), down: p(step), enter: p(step) });

  /** To the clearance over the beginning of a wall, at the most as high as the tool travels. */
  const into = (u: number, height: number, step: number) =>
    cutter.link({ u, v: Math.min(f.top + RECESS_CLEARANCE, Math.max(height, heightAt(e, u)) + RECESS_CLEARANCE) }, link(step));
  const out = (step: number) => cutter.link({ u: cutter.at.u, v: f.top + RECESS_CLEARANCE }, link(step));
  const cut = (path: readonly FlatSegment[], wallStep: number, floorStep: number) =>
    cutter.along(path, (s) => ({ feed: f.feed, purpose: p(onFloor(s) ? floorStep : wallStep) }));
  const segments = (from: number, to: number) => pathAlong(e, from, to).map((s) => s.segment);

  into(left, f.ground.start.v, 1);
  if (f.oneGo) {
    cut(segments(left, right), 2, 3);
    cutter.feed({ u: right, v: Math.max(cutter.at.v, f.ground.end.v) }, f.feed, p(3));
    return out(4);
  }
  const width = floor.to - floor.from;
  const meet = Math.max(floor.from + width / 2, floor.to - f.apart - RECESS_CLEARANCE / 2);
  const leave = (step: number) => {
    cutter.leave(RECESS_CLEARANCE, -1, e, f.feed, p(step), meet - floor.from);
    out(step);
  };
  cut(segments(left, meet), 2, 3);
  if (width <= SAME) cutter.feed({ u: meet, v: bottom }, f.feed, p(2));
  leave(4);
  into(right, f.ground.end.v, 5);
  cut(segments(meet, right).map(flat.reversed).reverse(), 6, 6);
  leave(6);
}
