import type { Move } from "../../src/kernel/plan/move.ts";
import type { Plan } from "../../src/kernel/plan/plan.ts";
import type { Pt, Ring, Segment } from "../../src/kernel/geometry/point.ts";
import type { Step } from "../../src/kernel/time/step.ts";
import type { Spindle } from "../../src/kernel/time/step.ts";
import { secondsOf } from "../../src/kernel/time/time.ts";
import { axial, feed, length, radius } from "../../src/kernel/units.ts";
import { NO_TIMING } from "../../src/program/run/run-times.ts";
import type { Operation, Run } from "../../src/program/state/run-types.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { simulate } from "../../src/sim/simulate.ts";

const at = (r: number, z: number): Pt => ({ z: axial(z), r: radius(r) });
const box = (left: number, right: number, low: number, high: number): Ring => [
  at(low, left),
  at(low, right),
  at(high, right),
  at(high, left),
];
const spindle: Spindle = { kind: "surface", cuttingSpeed: 180, limit: 2500 };

/** A shoulder with a rounded inner corner, roughed in even passes and finished, moves written by hand. */
export function handMadeMoves(passes: number, floor: number): Move[] {
  const moves: Move[] = [],
    cut = { feed: feed(0.3), feedUnit: "mm/rev" } as const,
    fine = { feed: feed(0.15), feedUnit: "mm/rev" } as const;
  const infeed = (37 - 25.2) / passes;
  for (let pass = 1; pass <= passes; pass++) {
    const r = 37 - infeed * pass,
      rough = { phase: "rough", run: "rough", pass } as const;
    moves.push({ kind: "rapid", to: at(r, 2), ...rough, step: 1 });
    moves.push({ kind: "feed", to: at(r, -54.6), ...cut, ...rough, step: 2 });
    moves.push({ kind: "feed", to: at(r + infeed, -54.6), ...cut, ...rough, step: 3 });
    moves.push({ kind: "rapid", to: at(r + infeed + 0.6, -54), ...rough, step: 4 });
    moves.push({ kind: "rapid", to: at(r + infeed + 0.6, 2), ...rough, step: 5 });
  }
  const finish = { phase: "finish", run: "finish" } as const;
  moves.push({ kind: "rapid", to: at(24.2, 2), ...finish, step: 1 });
  moves.push({ kind: "feed", to: at(24.2, 0), ...fine, ...finish, step: 2 });
  moves.push({ kind: "feed", to: at(floor, -0.8), ...fine, ...finish, step: 2 });
  moves.push({ kind: "feed", to: at(floor, -52.5), ...fine, ...finish, step: 2 });
  moves.push({
    kind: "arc",
    to: at(27.5, -55),
    centre: at(27.5, -52.5),
    turn: "cw",
    ...fine,
    ...finish,
    step: 2,
    plunging: true,
  });
  moves.push({ kind: "feed", to: at(38, -55), ...fine, ...finish, step: 2 });
  moves.push({ kind: "rapid", to: at(40, 2), ...finish, step: 3 });
  return moves;
}

/** A run of one operation with these moves, and its simulation. */
export function exampleResult({ fault, many }: { readonly fault: boolean; readonly many: boolean }) {
  const tool = shippedTools[0];
  if (!tool) throw new Error("no tools");
  const start = at(40, 2),
    steps: Step[] = [];
  let from = start;
  for (const move of handMadeMoves(many ? 1000 : 5, fault ? 24 : 25)) {
    steps.push({ from, move, tool, block: 12, operation: 0, seconds: secondsOf(from, move, spindle, 10000) });
    from = move.to;
  }
  const line = (a: Pt, b: Pt): Segment => ({ kind: "line", from: a, to: b });
  const contour: Segment[] = [
    line(at(24.2, 0), at(25, -0.8)),
    line(at(25, -0.8), at(25, -52.5)),
    {
      kind: "arc",
      from: at(25, -52.5),
      to: at(27.5, -55),
      centre: at(27.5, -52.5),
      turn: "cw",
    },
    line(at(27.5, -55), at(37.5, -55)),
  ];
  const part: Ring = [at(0, -100), at(0, 0), at(24.2, 0), at(25, -0.8), at(25, -55), at(37.5, -55), at(37.5, -100)];
  const area: Ring = [at(24.2, 0), at(24.2, 2), at(40, 2), at(40, -55), at(25, -55), at(25, -0.8)];
  const plan: Plan = {
    moves: steps.map((s) => s.move),
    issues: [],
    contour,
    passes: many ? 1000 : 5,
    infeed: length(2.36),
    area,
    part,
    openSide: at(1, 0),
    reach: [],
    oversizeReach: [],
    maxInfeed: length(2),
  };
  const seconds = steps.reduce((sum, s) => sum + s.seconds, 0);
  const operation: Operation = {
    block: 12,
    definedIn: 10,
    definedLine: 11,
    cycle: 812,
    tool,
    start,
    feedUnit: "mm/rev",
    spindle,
    plan,
    seconds,
    firstStep: 0,
    lastStep: steps.length - 1,
    issues: [],
    call: null,
  };
  const blank = [box(-100, 2, 0, 38)];
  const run: Run = {
    program: { name: "HAND", unit: "mm", blocks: 20 },
    blank,
    clamping: null,
    cuboid: null,
    stated: [],
    operations: [operation],
    steps,
    stepBlocks: steps.map(() => 11),
    plane: [],
    approaches: [],
    datums: [],
    spindles: [],
    unproved: [],
    issues: [],
    seconds,
    timing: NO_TIMING,
  };
  return { run, simulation: simulate({ blank, steps, operations: [operation], unproved: [] }) };
}
