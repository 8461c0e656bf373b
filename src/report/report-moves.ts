import type { Move } from "../kernel/plan/move.ts";
import { toDiameter } from "../kernel/units.ts";
import type { PlaneStep } from "../program/tools/plane-types.ts";
import type { Run } from "../program/state/run-types.ts";

/**
 * End points of the theoretical tip; X and centre X are diameters. In milling: end points of the tool centre, X and Y
 * as programmed, no Z before the program sets one.
 */
export interface ReportMove {
  readonly kind: Move["kind"];
  readonly x: number;
  readonly y?: number;
  readonly z?: number;
  readonly cx?: number;
  readonly cy?: number;
  readonly cz?: number;
  readonly dir?: "cw" | "ccw";
  readonly feed?: number;
  readonly feedUnit?: "mm/rev" | "mm/min";
  /** Dwell in spindle revolutions; absent in all other moves. */
  readonly dwell?: number;
  readonly phase: Move["phase"];
  readonly pass?: number;
  readonly block: number;
  /** File of the called program; `block` is then that of the call. */
  readonly file?: string;
}

/** A turning move as reported. */
export function reportedMove(move: Move, block: number): ReportMove {
  const { phase, pass } = move;
  const common = { x: toDiameter(move.to.r), z: move.to.z, phase, ...(pass !== undefined && { pass }), block };
  switch (move.kind) {
    case "rapid":
      return { kind: move.kind, ...common };
    case "feed":
      return {
        kind: move.kind,
        ...common,
        feed: move.feed,
        feedUnit: move.feedUnit,
        ...(move.dwell !== undefined && { dwell: move.dwell }),
      };
    case "arc":
      return {
        kind: move.kind,
        ...common,
        cx: toDiameter(move.centre.r),
        cz: move.centre.z,
        dir: move.turn,
        feed: move.feed,
        feedUnit: move.feedUnit,
      };
    case "thread":
      return { kind: move.kind, ...common, feed: Math.abs(move.pitch), feedUnit: "mm/rev" };
  }
}

function planeMoveOf(s: PlaneStep): ReportMove {
  const {
    kind,
    to: { x, y, z },
    block,
    feed,
    feedUnit,
  } = s;
  if (kind === "feed" && z !== null && feed !== undefined && feedUnit)
    return { kind, x, y, z, phase: "position", block, feed, feedUnit };
  return {
    kind: s.kind,
    x: s.to.x,
    y: s.to.y,
    ...(s.to.z !== null && { z: s.to.z }),
    phase: "position",
    block: s.block,
    ...(s.side && {
      ...(s.side.centre.x !== undefined && { cx: s.side.centre.x }),
      ...(s.side.centre.y !== undefined && { cy: s.side.centre.y }),
      ...(s.side.centre.z !== undefined && { cz: s.side.centre.z }),
      dir: s.side.turn,
    }),
    ...(s.centre && { cx: s.centre.x, cy: s.centre.y }),
    ...(s.turn && { dir: s.turn }),
    ...(s.feed !== undefined && { feed: s.feed }),
    ...(s.feedUnit && { feedUnit: s.feedUnit }),
  };
}

/** Motion outside cycles in execution order, turning and milling mixed. */
export function outsideCycles(run: Run): ReportMove[] {
  const out: ReportMove[] = [];
  let next = 0;
  const mill = (before: number) => {
    for (let s = run.plane[next]; s && s.turned <= before; s = run.plane[next]) {
      out.push(planeMoveOf(s));
      next += 1;
    }
  };
  run.steps.forEach((s, i) => {
    mill(i);
    if (s.operation === null)
      out.push({ ...reportedMove(s.move, s.block), ...(s.file !== undefined && { file: s.file }) });
  });
  mill(run.steps.length);
  return out;
}
