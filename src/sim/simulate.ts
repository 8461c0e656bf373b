import { areaOf, packed } from "../kernel/clip.ts";
import type { Step } from "../kernel/step.ts";
import { check, inStock } from "./check.ts";
import { cutting } from "./cutting.ts";
import { edgesOf } from "./edges.ts";
import { finishedPart } from "./finished.ts";
import { outlinesOf } from "./outlines.ts";
import { piecesOf } from "./piece.ts";
import { residualOf } from "./residual.ts";
import type { Checkpoint, Finding, Simulation, SimulationInput } from "./simulation.ts";
import { sweepOf } from "./sweep.ts";

/** Moves from one checkpoint to the next. */
export const CHECKPOINT_STEPS = 50;
/** Convex pieces after which a checkpoint comes sooner: long arcs have many. */
const CHECKPOINT_PIECES = 400;

function startTimesOf(steps: readonly Step[]): Float64Array {
  const times = new Float64Array(steps.length + 1);
  steps.forEach((s, i) => {
    times[i + 1] = (times[i] ?? 0) + (Number.isFinite(s.seconds) && s.seconds > 0 ? s.seconds : 0);
  });
  return times;
}

const total = (findings: readonly Finding[], kind: Finding["kind"]) =>
  findings.reduce((sum, f) => (f.kind === kind ? sum + f.area : sum), 0);

/** Cuts the blank by every step and looks at each before it cuts. */
export function simulate(input: SimulationInput): Simulation {
  const { blank, steps, operations, unproved } = input;
  const outlines = outlinesOf();
  const part = finishedPart(operations);
  const finished = { rings: part, edges: edgesOf(part) };
  const checkpoints: Checkpoint[] = [{ step: 0, stock: packed(blank) }];
  const findings: Finding[] = [];
  const removed: number[] = [];
  let cut = cutting(blank);
  let last = 0;
  steps.forEach((step, i) => {
    if (i - last >= CHECKPOINT_STEPS || cut.pieces >= CHECKPOINT_PIECES) {
      cut = cutting(cut.stock());
      checkpoints.push({ step: i, stock: packed(cut.initial) });
      last = i;
    }
    const shapes = outlines(step.tool);
    const sweep = piecesOf(sweepOf(shapes.insert, step));
    const touching = shapes.checked === shapes.insert ? sweep : piecesOf(sweepOf(shapes.checked, step));
    findings.push(...check(step, i, shapes, touching, cut, finished));
    const own = step.operation !== null && step.move.kind !== "rapid" ? step.operation : null;
    if (own !== null) removed[own] = (removed[own] ?? 0) + areaOf(inStock(sweep, cut));
    cut.add(sweep);
  });
  const final = cut.stock();
  const startTimes = startTimesOf(steps);
  return {
    blank, steps, checkpoints, final, startTimes, findings,
    totalSeconds: startTimes[steps.length] ?? 0,
    proof: {
      gouge: total(findings, "gouge"),
      rapidInStock: total(findings, "rapidInStock"),
      residual: residualOf(final, operations, outlines),
      cut: areaOf(blank) - areaOf(final), airPasses: 0, deepest: null,
      holder: findings.some((f) => f.kind === "holderContact") ? "contact" : steps.some((s) => !s.tool.holder) ? "unknown" : "clear",
      unproved,
      operations: operations.map((_, o) => ({ cut: removed[o] ?? 0, airPasses: 0, deepest: null, thickest: null, startInMaterial: null })),
    },
  };
}
