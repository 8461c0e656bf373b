import { areaOf } from "../kernel/area.ts";
import { packed } from "../kernel/clip.ts";
import type { Ring } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { check, MOST_CONTACTS, type Finished } from "./check.ts";
import { collector } from "./collect.ts";
import { inStock } from "./contact.ts";
import { cutting, type Cutting } from "./cutting.ts";
import { sidesOf } from "./edges.ts";
import { thicknessOf } from "./extent.ts";
import { finishedPart } from "./finished.ts";
import { marksOf } from "./marks.ts";
import { measuring } from "./measure.ts";
import { outlinesOf } from "./outlines.ts";
import { recalling } from "./recall.ts";
import { residualAgain, residualOf, type KnownShapes } from "./residual.ts";
import { nearestRun, resumed, snapshotSteps, type Former, type Resumed } from "./resume.ts";
import type { Depth, StockFinding, Proof, Residual, SimulatedOperation, Simulation, SimulationInput } from "./simulation.ts";
import { statedBlanks } from "./stated.ts";
import { sweptBy, type Sweep } from "./sweep.ts";

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
function setupsOf(
  operations: readonly SimulatedOperation[],
  residual: (stock: readonly Ring[], of: readonly SimulatedOperation[]) => readonly Residual[],
) {
  const left: Residual[] = [];
  let first = 0;
  const known = (from: number): Finished => {
    const rings = finishedPart(operations.slice(from));
    return { rings, edges: sidesOf(rings) };
  };
  const atFirst = known(0);
  let finished = atFirst;
  const until = (stock: readonly Ring[], end: number): Residual[] =>
    residual(stock, operations.slice(first, end)).map((r) => ({ ...r, operation: r.operation + first }));
  return {
    atFirst,
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

/** Cutting that begins anew now and then, always after the same steps. */
function walk(from: Cutting, marked: number) {
  let [cut, begun] = [from, marked];
  const begin = (step: number, stock: readonly Ring[]): Cutting => {
    [cut, begun] = [cutting(stock), step];
    return cut;
  };
  return {
    begin,
    /** What is cut by a step; `marks` is told when cutting begins anew there. */
    before(step: number, mark?: (stock: readonly Ring[]) => void): Cutting {
      if (step - begun < CHECKPOINT_STEPS && cut.pieces < CHECKPOINT_PIECES) return cut;
      begin(step, cut.stock());
      mark?.(cut.initial);
      return cut;
    },
    present: () => ({ cut, marked: begun }),
  };
}

/** The damage of the steps before the one that a run goes on from; steps that have to be looked at again are. */
function damageBefore(
  { from, recheck }: Resumed,
  former: Former,
  { blank, steps }: SimulationInput,
  look: Look,
): Map<number, readonly StockFinding[]> {
  const again = new Map<number, readonly StockFinding[]>();
  let [next, at] = [0, walk(cutting(blank), 0)];
  for (const step of recheck) {
    const nearest = former.snapshots.findLast((s) => s.step <= step);
    if (nearest && next < nearest.step) [next, at] = [nearest.step, walk(nearest.cut.copy(), nearest.marked)];
    for (; next <= step; next += 1) {
      const cut = at.before(next);
      const { sweep, check } = look(steps[next] as Step, next);
      if (next === step) again.set(step, check(cut));
      cut.add(sweep);
    }
  }
  const damage = new Map<number, readonly StockFinding[]>();
  const ordered = [...new Set([...former.damage.keys(), ...again.keys()])].filter((i) => i < from.step).sort((a, b) => a - b);
  const byBringing = (f: StockFinding) => f.block === former.input.steps[f.step]?.broughtBy;
  for (const i of ordered) {
    const blockOf = (f: StockFinding) => (byBringing(f) ? steps[i]?.broughtBy : steps[i]?.block) ?? f.block;
    const found = again.get(i) ?? former.damage.get(i)?.map((f) => ({ ...f, block: blockOf(f) })) ?? [];
    if (found.length > 0) damage.set(i, found);
  }
  return damage;
}

/** What a step sweeps, and what it does wrong in a stock. */
type Look = (step: Step, index: number) => { readonly sweep: Sweep; readonly check: (cut: Cutting) => StockFinding[] };

/** What is made of shapes: anew each time, or known from simulations before. */
interface Measuring {
  readonly thickness: KnownShapes["thickness"];
  readonly residual: typeof residualOf;
}
const ANEW: Measuring = { thickness: thicknessOf, residual: residualOf };

/** Cuts the blank by every step and looks at each before it cuts. */
export const simulate = (input: SimulationInput): Simulation => simulated(input, null, ANEW).simulation;

/** How many runs are known, the newest first, and the steps that all of them may have but for the newest. */
const [MOST_KNOWN, MOST_KNOWN_STEPS] = [4, 200_000];

/** The runs that stay known when another one comes. */
function withNewest(newest: Former | null, known: readonly Former[]): readonly Former[] {
  let steps = 0;
  const others = known.filter(({ input }) => (steps += input.steps.length) <= MOST_KNOWN_STEPS);
  return newest ? [newest, ...others].slice(0, MOST_KNOWN) : others;
}

/**
 * Simulates runs one after the other. What comes is the same as of `simulate`; what the beginning of a run has in common with one of
 * the last runs is not cut and not looked at again.
 */
export function simulating(): (input: SimulationInput) => Simulation {
  let known: readonly Former[] = [];
  const thickness = recalling(thicknessOf);
  const measuring: Measuring = { thickness: thickness.of, residual: residualAgain() };
  return (input) => {
    const before = nearestRun(known, input);
    thickness.next();
    const { simulation, kept } = simulated(input, before, measuring);
    known = withNewest(kept, known);
    return simulation;
  };
}

function simulated(
  input: SimulationInput,
  former: Former | null,
  { thickness, residual }: Measuring,
): { readonly simulation: Simulation; readonly kept: Former | null } {
  const { blank, steps, operations, unproved } = input;
  const outlines = outlinesOf();
  const setups = setupsOf(operations, (stock, of) => residual(stock, of, { outlines, thickness }));
  const look: Look = (step, index) => {
    const shapes = outlines(step.tool);
    const sweep = sweptBy(shapes.insert, step);
    const touching = shapes.checked === shapes.insert ? sweep : sweptBy(shapes.checked, step);
    return { sweep, check: (cut) => check(step, index, shapes, touching, cut, setups.finished()) };
  };
  const resume = former && resumed(former, input, setups.atFirst.rings, outlines);
  const from = resume?.from;
  const damage = former && resume ? damageBefore(resume, former, input, look) : new Map<number, readonly StockFinding[]>();
  // Where nobody looks any more depends on all that was found before.
  if (damage.size >= MOST_CONTACTS && resume) return simulated(input, null, { thickness, residual });
  const marks = marksOf(former && from ? former.marks.slice(0, from.marks) : [{ step: 0, stock: packed(blank) }]);
  const measure = measuring(operations, blank, former && from ? { state: from.measure, step: from.step, sums: former.sums } : null);
  const snapshots = former && from ? former.snapshots.filter(({ step }) => step <= from.step) : [];
  const isKept = snapshotSteps(input);
  let byRapids = from?.byRapids ?? 0;
  let unlooked: Proof["unlooked"] = null;
  const at = walk(from?.cut.copy() ?? cutting(blank), from?.marked ?? 0);
  const statements = statedBlanks(input.stated ?? []);
  for (let i = from?.step ?? 0; i < steps.length; i += 1) {
    const step = steps[i] as Step;
    if (isKept(i) && i > (from?.step ?? 0)) {
      const { cut, marked } = at.present();
      snapshots.push({ step: i, cut: cut.copy(), marked, marks: marks.all().length, byRapids, measure: measure.state(step.operation) });
    }
    const now = statements.at(i, at.present().cut);
    if (now) {
      setups.change(at.present().cut.stock(), i);
      at.begin(i, now);
      marks.add(i, now, true);
    }
    const cut = at.before(i, (stock) => marks.add(i, stock));
    const { sweep, check: checked } = look(step, i);
    if (damage.size < MOST_CONTACTS) {
      const found = checked(cut);
      if (found.length > 0) damage.set(i, found);
    } else unlooked ??= { step: i, block: step.block };
    measure.add(step, i, sweep, outlines(step.tool), cut);
    if (step.move.kind === "rapid" && !unlooked) byRapids += areaOf(inStock([sweep], cut.present()));
    cut.add(sweep);
  }
  const { cut, marked } = at.present();
  if (steps.length > (from?.step ?? 0))
    snapshots.push({ step: steps.length, cut: cut.copy(), marked, marks: marks.all().length, byRapids, measure: measure.state(null) });
  const last = statements.at(steps.length, cut);
  if (last) {
    setups.change(cut.stock(), steps.length);
    marks.add(steps.length, last, true);
  }
  const final = last ?? cut.stock();
  const found = collector();
  for (const each of damage.values()) found.add(each);
  const findings = found.all();
  const measured = measure.results(steps);
  const startTimes = startTimesOf(steps);
  const checkpoints = marks.all();
  const isWhole = unlooked === null && checkpoints.every(({ stock }) => stock !== null);
  const simulation: Simulation = {
    blank,
    steps,
    checkpoints,
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
  const { atFirst } = setups;
  const kept = { input, snapshots, marks: checkpoints, damage, sums: measure.sums(), finished: atFirst.rings };
  return { simulation, kept: isWhole ? kept : null };
}
