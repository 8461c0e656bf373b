import { heightAt, lowest, pathAlong, staysAbove } from "../envelope.ts";
import { reversed, type FlatSegment } from "../flat.ts";
import { SAME } from "../tolerance.ts";
import type { Purpose, Track } from "../track.ts";
import type { Ground } from "./ground.ts";
import { containing, deepestIn, RECESS_CLEARANCE } from "./valley.ts";

export interface RecessFinish {
  readonly ground: Ground;
  /** Height in front of the recess at which the tool may travel. */
  readonly top: number;
  readonly feed: number;
  /** The whole groove in one cut; otherwise from both walls, meeting on the floor. */
  readonly oneGo: boolean;
  /** Shift of the floor, mm, positive out of the material. */
  readonly compensation: number;
  /** Distance to keep from the second wall while its oversize still stands, mm. */
  readonly apart: number;
  readonly span: { readonly from: number; readonly to: number };
}

const p = (step: number): Purpose => ({ phase: "finish", run: "finish", step });

/** The printed finishing steps 1 to 6 of a recess; going back to the cycle start is the caller's. */
export function finishRecess(track: Track, f: RecessFinish): void {
  const e = f.ground.envelope;
  const bottom = lowest(e, f.span.from, f.span.to);
  const floor = containing(e, bottom, f.span, deepestIn(e, bottom, f.span));
  const clear = f.top + RECESS_CLEARANCE;
  const left = f.ground.start.u;
  const right = f.ground.end.u;
  const onFloor = (s: FlatSegment) => s.kind === "line" && Math.abs(s.from.v - bottom) < SAME && Math.abs(s.to.v - bottom) < SAME;

  const into = (u: number, height: number, step: number) => {
    if (track.at.v < clear) track.rapid("v", clear, p(step));
    track.rapid("u", u, p(step));
    track.rapid("v", Math.min(clear, Math.max(height, heightAt(e, u)) + RECESS_CLEARANCE), p(step));
  };
  const cut = (path: readonly FlatSegment[], wallStep: number, floorStep: number) => {
    const first = path[0];
    if (first) track.feed(first.from, f.feed, p(wallStep));
    for (const s of path) {
      if (!onFloor(s) || f.compensation === 0) {
        track.follow(s, f.feed, p(onFloor(s) ? floorStep : wallStep));
        continue;
      }
      track.feed({ u: s.from.u, v: bottom + f.compensation }, f.feed, p(floorStep));
      track.feed({ u: s.to.u, v: bottom + f.compensation }, f.feed, p(floorStep));
      track.feed(s.to, f.feed, p(floorStep));
    }
  };
  const segments = (from: number, to: number) => pathAlong(e, from, to).map((s) => s.segment);

  into(left, f.ground.start.v, 1);
  if (f.oneGo) {
    cut(segments(left, right), 2, 3);
    track.feed({ u: right, v: Math.max(track.at.v, f.ground.end.v) }, f.feed, p(3));
    track.rapid("v", clear, p(4));
    return;
  }
  const width = floor.to - floor.from;
  const meet = Math.max(floor.from + width / 2, floor.to - f.apart - RECESS_CLEARANCE / 2);
  const leave = (step: number) => {
    const d = Math.min(RECESS_CLEARANCE, meet - floor.from);
    const leaning = { u: meet - d, v: bottom + d };
    track.feed(staysAbove(e, leaning, track.at) ? leaning : { u: meet, v: bottom + d }, f.feed, p(step));
    track.rapid("v", clear, p(step));
  };
  cut(segments(left, meet), 2, 3);
  if (width <= SAME) track.feed({ u: meet, v: bottom }, f.feed, p(2));
  leave(4);
  into(right, f.ground.end.v, 5);
  cut(segments(meet, right).map(reversed).reverse(), 6, 6);
  leave(6);
}
