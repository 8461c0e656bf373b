import { areaOf } from "../kernel/area.ts";
import type { Ring } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { check, MOST_CONTACTS, type Finished } from "./check.ts";
import { collector } from "./collect.ts";
import { inStock } from "./contact.ts";
import { cutting } from "./cutting.ts";
import { sidesOf } from "./edges.ts";
import { finishedPart } from "./finished.ts";
import { marksOf } from "./marks.ts";
import { measuring } from "./measure.ts";
import { outlinesOf } from "./outlines.ts";
import { residualOf } from "./residual.ts";
import type { Depth, StockFinding, Proof, Residual, SimulatedOperation, Simulation, SimulationInput } from "./simulation.ts";
import { statedBlanks } from "./stated.ts";
import { sweptBy } from "./sweep.ts";

/** Moves from one checkpoint to the next. */
export const CHECKPOINT_STEPS = 50;
/** Convex pieces after which a checkpoint comes sooner: long arcs have many. */
export const CHECKPOINT_PIECES = 400;

function startTimesOf(steps: readonly Step[]): Float64Array {
  const times = new Float64Array(steps.length + 1);
  steps.forEach((s, i) => {
    times[i + 1] = (times[i] ?? 0) + (Number.isFinite(s.seconds) && s.seconds > 0 ? s.seconds : 0);
  });
  return times;
}

const total = (findings: readonly StockFinding[], kind: StockFinding["kind"]) =>
  findings.reduce((sum, f) => (f.kind === kind ? sum + f.area : sum), 0);

/**
 * The work as it is held: what an outline that is stated later takes the place of is judged as it stood until then, and the contours
 * of before say nothing of what comes behind.
 */
function setupsOf(operations: readonly SimulatedOperation[], outlines: ReturnType<typeof outlinesOf>) {
  const left: Residual[] = [];
  let first = 0;
  const known = (from: number): Finished => {
    const rings = finishedPart(operations.slice(from));
    return { rings, edges: sidesOf(rings) };
  };
  let finished = known(0);
  const until = (stock: readonly Ring[], end: number): Residual[] =>
    residualOf(stock, operations.slice(first, end), outlines).map((r) => ({ ...r, operation: r.operation + first }));
  return {
    finished: () => finished,
    change(stock: readonly Ring[], step: number): void {
      const next = operations.findIndex((o) => o.firstStep >= step);
      const end = next < 0 ? operations.length : next;
      left.push(...until(stock, end));
      first = end;
      finished = known(first);
    },
    residual: (stock: readonly Ring[]): readonly Residual[] => [...left, ...until(stock, operations.length)],
  };
}

/** Cuts the blank by every step and looks at each before it cuts. */
export function simulate(input: SimulationInput): Simulation {
  const { blank, steps, operations, unproved } = input;
  const outlines = outlinesOf();
  const setups = setupsOf(operations, outlines);
  const marks = marksOf();
  marks.add(0, blank);
  const found = collector();
  const measure = measuring(operations, blank);
  let byRapids = 0;
  let contacts = 0;
  let unlooked: Proof["unlooked"] = null;
  let cut = cutting(blank);
  let marked = 0;
  const statements = statedBlanks(input.stated ?? []);
  steps.forEach((step, i) => {
    const now = statements.at(i, cut);
    if (now) {
      setups.change(cut.stock(), i);
      cut = cutting(now);
      marks.add(i, now, true);
      marked = i;
    }
    if (i - marked >= CHECKPOINT_STEPS || cut.pieces >= CHECKPOINT_PIECES) {
      cut = cutting(cut.stock());
      marks.add(i, cut.initial);
      marked = i;
    }
    const shapes = outlines(step.tool);
    const sweep = sweptBy(shapes.insert, step);
    const touching = shapes.checked === shapes.insert ? sweep : sweptBy(shapes.checked, step);
    if (contacts < MOST_CONTACTS) {
      const damage = check(step, i, shapes, touching, cut, setups.finished());
      found.add(damage);
      if (damage.length > 0) contacts += 1;
    } else unlooked ??= { step: i, block: step.block };
    measure.add(step, i, sweep, shapes, cut);
    if (step.move.kind === "rapid" && !unlooked) byRapids += areaOf(inStock([sweep], cut.present()));
    cut.add(sweep);
  });
  const last = statements.at(steps.length, cut);
  if (last) {
    setups.change(cut.stock(), steps.length);
    marks.add(steps.length, last, true);
  }
  const final = last ?? cut.stock();
  const findings = found.all();
  const measured = measure.results();
  const startTimes = startTimesOf(steps);
  return {
    blank,
    steps,
    checkpoints: marks.all(),
    final,
    startTimes,
    findings,
    totalSeconds: startTimes[steps.length] ?? 0,
    proof: {
      gouge: total(findings, "gouge"),
      rapidInStock: total(findings, "rapidInStock"),
      residual: setups.residual(final),
      cut: Math.max(0, areaOf(blank) + statements.added() - areaOf(final) - byRapids),
      airPasses: measured.reduce((sum, o) => sum + o.airPasses, 0),
      deepest: measured.reduce<Depth | null>((best, { deepest }) => (deepest && deepest.depth > (best?.depth ?? 0) ? deepest : best), null),
      holder: findings.some((f) => f.kind === "holderContact") ? "contact" : steps.some((s) => !s.tool.holder) ? "unknown" : "clear",
      unproved: [...unproved, ...statements.unproved()],
      stated: statements.all(),
      unlooked,
      operations: measured,
    },
  };
}
