import { curvatureUnknown } from "../kernel/cutter/insert.ts";
import { AnswerCache } from "../kernel/answer-cache.ts";
import { areaOf } from "../kernel/area/area.ts";
import { packed } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { check, MOST_CONTACTS, type CheckContext } from "./check.ts";
import { clampContacts } from "./clamp-contacts.ts";
import { collector } from "./collect.ts";
import { inStock } from "./contact.ts";
import { cutsAtRear, unheldAt } from "./behind-blank.ts";
import { cutting, piecesMeeting, type Cutting } from "./cutting.ts";
import { thicknessOf } from "./extent.ts";
import { cutEnds, holding, loosePieces, onLoosePieces, partedOffPieces, type Parted } from "./work-holding.ts";
import { isCheckpointDue, marksOf } from "./marks.ts";
import { measuring } from "./measure.ts";
import { outlinesOf } from "./outlines.ts";
import { setupsOf } from "./setups.ts";
import { residualOf, type KnownShapes } from "./residual.ts";
import { unknownHolders } from "./known-holders.ts";
import { hasClamping, nearestRun, resumePoint, snapshotSteps, type PreviousRun, type ResumePoint } from "./resume.ts";
import type {
  AnyFinding,
  Depth,
  LoosePiece,
  StockFinding,
  StockRemark,
  Proof,
  Simulation,
  SimulationInput,
  Unheld,
} from "./simulation.ts";
import { statedBlanks } from "./stated-blanks.ts";
import { sweptBy, type Sweep } from "./sweep.ts";

function startTimesOf(steps: readonly Step[]): Float64Array {
  const times = new Float64Array(steps.length + 1);
  steps.forEach((s, i) => {
    times[i + 1] = (times[i] ?? 0) + (Number.isFinite(s.seconds) && s.seconds > 0 ? s.seconds : 0);
  });
  return times;
}

const total = (findings: readonly StockFinding[], kind: StockFinding["kind"]) =>
  findings.reduce((sum, f) => (f.kind === kind ? sum + f.area : sum), 0);

/** Cutting that recomputes its stock periodically, always after the same steps. */
function walk(from: Cutting, marked: number) {
  let [cut, begun] = [from, marked];
  const begin = (step: number, stock: readonly Ring[]): Cutting => {
    [cut, begun] = [cutting(stock), step];
    return cut;
  };
  return {
    begin,
    /** The stock before a step; calls `mark` when it is recomputed there. */
    before(step: number, mark?: (stock: readonly Ring[]) => void): Cutting {
      if (!isCheckpointDue(step, begun, cut.pieces)) return cut;
      begin(step, cut.stock());
      mark?.(cut.initial);
      return cut;
    },
    present: () => ({ cut, marked: begun }),
  };
}

/** The damage of the steps before the resumed one, with the steps in `recheck` checked again. */
function damageBefore(
  { from, recheck }: ResumePoint,
  former: PreviousRun,
  { blank, steps }: SimulationInput,
  look: Look,
): Map<number, readonly AnyFinding[]> {
  const again = new Map<number, readonly AnyFinding[]>();
  const parted = new Map(former.parted.map((p) => [p.step, p.held]));
  let [next, at] = [0, walk(cutting(blank), 0)];
  for (const step of recheck) {
    const nearest = former.snapshots.findLast((s) => s.step <= step);
    if (nearest && next < nearest.step) [next, at] = [nearest.step, walk(nearest.cut.copy(), nearest.marked)];
    for (; next <= step; next += 1) {
      const held = parted.get(next);
      if (held) at.begin(next, held);
      const cut = at.before(next);
      const { sweep, check } = look(steps[next] as Step, next);
      if (next === step) again.set(step, check(cut));
      cut.add(sweep);
    }
  }
  const damage = new Map<number, readonly AnyFinding[]>();
  const ordered = [...new Set([...former.damage.keys(), ...again.keys()])]
    .filter((i) => i < from.step)
    .sort((a, b) => a - b);
  const byBringing = (f: AnyFinding) => f.block === former.input.steps[f.step]?.positionedBy;
  for (const i of ordered) {
    const blockOf = (f: AnyFinding) => (byBringing(f) ? steps[i]?.positionedBy : steps[i]?.block) ?? f.block;
    const found = again.get(i) ?? former.damage.get(i)?.map((f) => ({ ...f, block: blockOf(f) })) ?? [];
    if (found.length > 0) damage.set(i, found);
  }
  return damage;
}

/** Findings that count towards MOST_CONTACTS. */
const CONTACTS: ReadonlySet<AnyFinding["kind"]> = new Set(["gouge", "rapidInStock", "holderContact"]);

/** The sweep of a step, and the check for its damage in a stock. */
type Look = (step: Step, index: number) => { readonly sweep: Sweep; readonly check: (cut: Cutting) => AnyFinding[] };

/** Measurements of shapes: computed, or cached from earlier simulations. `thickerThan`: see `measuring`. */
interface Measuring {
  readonly thickness: KnownShapes["thickness"];
  readonly residual: typeof residualOf;
  readonly thickerThan: number | null;
  /** Whether a later run may resume, so that states in between are kept. */
  readonly isResumed: boolean;
}
const COMPUTED: Measuring = { thickness: thicknessOf, residual: residualOf, thickerThan: null, isResumed: false };

/** Cached measurements. Reused plans are the same objects, as tools are. */
const cachedIn = (answers: AnswerCache): Measuring => ({
  thickness: (area) => answers.cached(`thickness ${answers.serialized(area)}`, () => thicknessOf(area)),
  residual(final, all, shapes) {
    const operations = all.map(({ plan, tool }) => `${answers.labelOf(plan)} ${answers.labelOf(tool)}`);
    return answers.cached(`residual ${operations.join()} ${answers.serialized(final)}`, () =>
      residualOf(final, all, shapes),
    );
  },
  thickerThan: null,
  isResumed: true,
});

/**
 * The same for many tries: of the operations is measured only whether threads cut, and finishing cuts thicker than a
 * length, mm.
 */
export const simulateCuts = (input: SimulationInput, thickerThan: number): Simulation =>
  runSimulation(input, null, { ...COMPUTED, thickness: () => 0, residual: () => [], thickerThan }).simulation;

/** Called again and again in a long run, with the share of its steps that are done, 0 to 1. */
export type AtShare = (share: number) => void;
/** Steps from one such call to the next. */
const STEPS_OF_SHARE = 2000;

/** Cuts the blank step by step, checking each before its cut. */
export const simulate = (input: SimulationInput, atShare?: AtShare): Simulation =>
  runSimulation(input, null, COMPUTED, atShare).simulation;

/** Most cached runs, the newest first, and the most steps of all but the newest. */
const [MOST_KNOWN, MOST_KNOWN_STEPS] = [4, 200_000];

/** The cached runs after adding the newest. */
function withNewest(newest: PreviousRun | null, known: readonly PreviousRun[]): readonly PreviousRun[] {
  let steps = 0;
  const others = known.filter(({ input }) => (steps += input.steps.length) <= MOST_KNOWN_STEPS);
  return newest ? [newest, ...others].slice(0, MOST_KNOWN) : others;
}

/**
 * Simulates successive runs with the results of `simulate`. A beginning in common with a recent run is neither cut nor
 * checked again.
 */
export function incrementalSimulator(answers = new AnswerCache()): typeof simulate {
  let known: readonly PreviousRun[] = [];
  const measuring = cachedIn(answers);
  return (input, atShare) => {
    const before = nearestRun(known, input);
    const { simulation, kept } = runSimulation(input, before, measuring, atShare);
    known = withNewest(kept, known);
    return simulation;
  };
}

/**
 * Simulates variants of one run with the results of `simulate`: what a variant has in common with that run up to its
 * first change is neither cut nor checked again, however many variants there have been.
 */
export function variantSimulator(
  input: SimulationInput,
  answers = new AnswerCache(),
): { readonly simulation: Simulation; readonly of: (variant: SimulationInput) => Simulation } {
  const measuring = cachedIn(answers);
  const { simulation, kept } = runSimulation(input, null, measuring);
  return { simulation, of: (variant) => runSimulation(variant, kept, measuring).simulation };
}

const separatedArea = (parted: readonly Parted[]): number =>
  parted.reduce((sum, { loose }) => sum + loose.reduce((all, { area }) => all + area, 0), 0);

/** A finding completed by the whole run; none where that shows it to be no fault. */
function finalFindings(
  f: AnyFinding,
  loose: readonly LoosePiece[],
  blockOf: (operation?: number) => number | undefined,
): AnyFinding[] {
  if (f.isMeant) return [];
  if (f.kind === "cutOnLoosePiece") return onLoosePieces(f, loose);
  return [f.kind === "cutBelowContour" ? { ...f, other: blockOf(f.below) ?? f.block } : f];
}

const isRemark = (f: AnyFinding): f is StockFinding<StockRemark> =>
  f.kind === "cutBelowContour" || f.kind === "intendedCut" || f.kind === "feedBehindBlank";
const isFault = (f: AnyFinding): f is StockFinding => !isRemark(f);

function runSimulation(
  input: SimulationInput,
  former: PreviousRun | null,
  measures: Measuring,
  atShare?: AtShare,
): { readonly simulation: Simulation; readonly kept: PreviousRun | null } {
  const { blank, steps, operations, unproved } = input;
  const { thickness, residual, thickerThan } = measures;
  const outlines = outlinesOf();
  const setups = setupsOf(operations, (stock, of) => residual(stock, of, { outlines, thickness }));
  const look: Look = (step, index) => {
    const shapes = outlines(step.tool);
    const sweep = sweptBy(shapes.insert, step);
    const touching = shapes.checked === shapes.insert ? sweep : sweptBy(shapes.checked, step);
    return { sweep, check: (cut) => check(index, touching, cut, against) };
  };
  const resume = former && resumePoint(former, input, setups.atFirst, outlines);
  const from = resume?.from;
  const held = holding(
    blank,
    input.clamping?.clamping ?? null,
    former && from ? former.parted.filter(({ step }) => step < from.step) : [],
    input.held,
  );
  const against: CheckContext = {
    steps,
    operations,
    outlines,
    isClamped: hasClamping(input),
    get finished() {
      return setups.finished();
    },
    get hold() {
      return held.hold();
    },
    loose: held.loose,
  };
  const damage =
    former && resume ? damageBefore(resume, former, input, look) : new Map<number, readonly AnyFinding[]>();
  const isContact = (found: readonly AnyFinding[]) => found.some((f) => CONTACTS.has(f.kind));
  let contacts = [...damage.values()].filter(isContact).length;
  // Where the check stops depends on all earlier findings, so this run cannot resume.
  if (contacts >= MOST_CONTACTS && resume) return runSimulation(input, null, measures, atShare);
  const marks = marksOf(former && from ? former.marks.slice(0, from.marks) : [{ step: 0, stock: packed(blank) }]);
  const measure = measuring(operations, blank, from?.measure ?? null, thickerThan);
  const snapshots = former && from ? former.snapshots.filter(({ step }) => step <= from.step) : [];
  const isKept = measures.isResumed ? snapshotSteps(input) : () => false;
  let byRapids = from?.byRapids ?? 0;
  let uncheckedFrom: Proof["uncheckedFrom"] = null;
  const at = walk(from?.cut.copy() ?? cutting(blank), from?.marked ?? 0);
  const statements = statedBlanks(input.stated ?? []);
  for (const parted of held.parted()) setups.partOff(partedOffPieces(parted), parted.step);
  const unheld: Omit<Unheld, "block">[] = [];
  /** Whether nothing was cut since the last check for loose pieces. */
  let isWhole = false;

  /** Splits off loose pieces after a cut has ended. */
  function separateLoose(i: number, isReplaced: boolean): void {
    if (isWhole || !cutEnds(steps, i)) return;
    isWhole = true;
    const parted = held.separate(i, at.present().cut.stock());
    if (!parted) return;
    setups.partOff(partedOffPieces(parted), i);
    if (isReplaced) return;
    at.begin(i, parted.held);
    marks.add(i, parted.held, "isParted");
  }
  /** Checks that enough is left to grip, before another blank is stated or at the end. */
  function checkGrip(stock: readonly Ring[], end: number): void {
    const rear = held.hold()?.rear ?? null,
      place = unheldAt(held.blank(), stock, rear);
    const lastCut = place ? steps.findLastIndex(({ move }, k) => k < end && move.kind !== "rapid") : -1;
    if (!rear || !place || lastCut < 0 || hasClamping(input)) return;
    const operation = cutsAtRear(operations.slice(0, setups.begunBefore(end)), rear);
    unheld.push({
      step: operation === null ? lastCut : (operations[operation]?.firstStep ?? 0),
      operation,
      place,
      rear: rear.z,
    });
  }
  /** Stores a snapshot before a step of an operation, from which another program may resume. */
  function note(step: number, operation: number | null): void {
    const { cut, marked } = at.present();
    const measured = { byRapids, measure: measure.state(operation) };
    snapshots.push({ step, cut: cut.copy(), marked, marks: marks.all().length, ...measured });
  }
  for (let i = from?.step ?? 0; i < steps.length; i += 1) {
    const step = steps[i] as Step;
    if (i > 0 && i % STEPS_OF_SHARE === 0) atShare?.(i / steps.length);
    if (isKept(i) && i > (from?.step ?? 0)) note(i, step.operation);
    const now = statements.at(i, at.present().cut);
    separateLoose(i, now !== null);
    if (now) {
      checkGrip(at.present().cut.stock(), i);
      setups.change(at.present().cut.stock(), i);
      held.change(now);
      at.begin(i, now);
      marks.add(i, now, "isStated");
    }
    const cut = at.before(i, (stock) => marks.add(i, stock));
    const { sweep, check: checked } = look(step, i);
    if (contacts < MOST_CONTACTS) {
      const found = checked(cut);
      if (found.length > 0) damage.set(i, found);
      if (isContact(found)) contacts += 1;
    } else uncheckedFrom ??= { step: i, block: step.block };
    measure.add(step, i, sweep, outlines(step.tool), cut);
    if (step.move.kind === "rapid" && !uncheckedFrom) byRapids += areaOf(inStock([sweep], cut.present()));
    isWhole &&= piecesMeeting(sweep, cut.present().meets).length === 0;
    cut.add(sweep);
  }
  if (steps.length > (from?.step ?? 0)) note(steps.length, null);
  separateLoose(steps.length, false);
  const { cut } = at.present();
  checkGrip(cut.stock(), steps.length);
  const last = statements.at(steps.length, cut);
  if (last) {
    setups.change(cut.stock(), steps.length);
    marks.add(steps.length, last, "isStated");
  }
  const final = last ?? cut.stock();
  const found = collector();
  for (const each of damage.values()) found.add(each);
  found.add(clampContacts(steps, input.clamping, outlines));
  const loose = held.parted().flatMap((parted) => loosePieces(parted, steps));
  const blockOf = (operation = -1) => steps[operations[operation]?.firstStep ?? -1]?.block;
  const all = found.all().flatMap((f) => finalFindings(f, loose, blockOf));
  const findings = all.filter(isFault);
  const measured = measure.results(steps);
  const startTimes = startTimesOf(steps);
  const checkpoints = marks.all();
  const isKnown = uncheckedFrom === null && checkpoints.every(({ stock }) => stock !== null);
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
      cut: Math.max(0, areaOf(blank) + statements.added() - areaOf(final) - byRapids - separatedArea(held.parted())),
      airPasses: measured.reduce((sum, o) => sum + o.airPasses, 0),
      deepest: measured.reduce<Depth | null>(
        (best, { deepest }) => (deepest && deepest.depth > (best?.depth ?? 0) ? deepest : best),
        null,
      ),
      holder: findings.some((f) => f.kind === "holderContact" || f.clamp?.by === "holder")
        ? "contact"
        : unknownHolders(input).size > 0 || steps.some((s) => curvatureUnknown(s.tool))
          ? "unknown"
          : "clear",
      unproved: [...unproved, ...statements.unproved()],
      stated: statements.all(),
      loose,
      remarks: all.filter(isRemark),
      unheld: unheld.map((u) => ({ ...u, block: steps[u.step]?.block ?? 0 }))[0] ?? null,
      uncheckedFrom,
      operations: measured,
    },
  };
  const kept = {
    input,
    snapshots,
    marks: checkpoints,
    damage,
    finished: setups.atFirst,
    parted: held.parted(),
  };
  return { simulation, kept: isKnown ? kept : null };
}
