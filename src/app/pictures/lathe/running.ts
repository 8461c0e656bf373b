import { cycleByNumber } from "../../../cycles/index.ts";
import type { Texts } from "../../../i18n/index.ts";
import type { CyclesTexts } from "../../../i18n/cycle-text.ts";
import type { Lengths } from "../../../i18n/lengths.ts";
import { formatNumber } from "../../../i18n/number.ts";
import type { Move } from "../../../kernel/plan/move.ts";
import type { Pt } from "../../../kernel/geometry/point.ts";
import { toDiameter } from "../../../kernel/units.ts";
import type { Operation, Run } from "../../../program/state/run-types.ts";
import type { Chip } from "../../../sim/chip/chip.ts";
import { rpmAt, spindleAt } from "../../../sim/load/spindles.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { tipAt } from "../../../view/tip.ts";

/**
 * Texts about a moment of a run, as words and numbers of the screen language; `step`: that of the manual, "Step 3 of 6:
 * …".
 */
type Running = Readonly<Record<"x" | "z" | "feed" | "speed" | "phase" | "pass" | "step" | "block", string>>;

/** A position as the control shows it: X as diameter. */
export const placeText = (lengths: Lengths, p: Pt) => ({
  x: lengths.position(toDiameter(p.r)),
  z: lengths.position(p.z),
});

/** Feed with its unit, rapid traverse, or the duration of a dwell. */
export function runningFeed(t: Texts["lathe"], lengths: Lengths, move: Move): string {
  if (move.kind === "rapid") return t.rapid;
  if (move.kind === "thread") return `${lengths.number(Math.abs(move.pitch))} ${lengths.words(t.perTurn)}`;
  if (move.kind === "feed" && move.dwell !== undefined) return t.turns(formatNumber(lengths.language, move.dwell));
  return `${lengths.number(move.feed)} ${lengths.words(move.feedUnit === "mm/rev" ? t.perTurn : t.perMinute)}`;
}

/** Kind of a move, in a word. */
export const kindText = (t: Texts["lathe"], move: Move): string =>
  move.kind === "feed" && move.dwell !== undefined ? t.kinds.dwell : t.kinds[move.kind];

/** Phase in words, including plunging. */
export const phaseText = (t: Texts["lathe"], move: Move): string =>
  move.plunging ? `${t.phases[move.phase]}, ${t.plunging}` : t.phases[move.phase];

/** The sentence of the manual's step that a move belongs to. */
export function stepText(t: Texts, operation: Operation | undefined, move: Move): string {
  if (!operation) return t.lathe.outside;
  if (move.step <= 0) return t.cycles.positioning;
  const count = cycleByNumber(operation.cycle)?.steps[move.run];
  const all: Partial<Record<number, CyclesTexts["of"][keyof CyclesTexts["of"]]>> = t.cycles.of;
  const words = all[operation.cycle]?.[move.run][move.step - 1];
  if (count === undefined || words === undefined)
    return t.lathe.stepOnly(String(move.step), String(count ?? move.step));
  return (move.run === "rough" ? t.cycles.roughStep : t.cycles.finishStep)(move.step, count, words);
}

/** One of the numbered steps of the manual. */
export interface ManualStep {
  readonly number: number;
  readonly words: string;
  /** Its first move in the running phase; null if it has none. */
  readonly first: number | null;
  readonly runs: boolean;
}

/**
 * Per step, the first step of its phase; between two cycles, that of the next one. Cached, since each frame looks it
 * up.
 */
const phases = new WeakMap<Run["steps"], Int32Array>();
const NO_PHASE = -1;

function phasesOf(steps: Run["steps"]): Int32Array {
  const first = new Int32Array(steps.length).fill(NO_PHASE);
  let last = NO_PHASE;
  steps.forEach(({ operation, move }, i) => {
    const before = steps[i - 1];
    if (operation === null) return;
    if (before?.operation !== operation || before.move.run !== move.run) last = i;
    first[i] = last;
  });
  let next = last;
  for (let i = steps.length - 1; i >= 0; i -= 1) {
    if (first[i] === NO_PHASE) first[i] = next;
    else next = first[i] ?? NO_PHASE;
  }
  return first;
}

/** A step of the running phase, or between two cycles the first step of the next one; null if no cycle has any. */
export function nearestCycle(run: Run, step: number): number | null {
  const known = phases.get(run.steps) ?? phasesOf(run.steps);
  phases.set(run.steps, known);
  const first = known[Math.min(step, known.length - 1)] ?? NO_PHASE;
  return first === NO_PHASE ? null : first;
}

/** The manual's numbered steps of the sequence of a move; none outside the cycles. `now`: the running move. */
export function runningSteps(t: Texts, run: Run, index: number, now: number | null): readonly ManualStep[] {
  const { operation: at, move } = run.steps[index] ?? {};
  const running = now === null ? undefined : run.steps[now]?.move.step;
  const operation = at === null || at === undefined ? undefined : run.operations[at];
  if (!operation || !move) return [];
  const all: Partial<Record<number, CyclesTexts["of"][keyof CyclesTexts["of"]]>> = t.cycles.of;
  const firsts = new Map<number, number>();
  for (let i = operation.firstStep; i <= operation.lastStep; i += 1) {
    const made = run.steps[i]?.move;
    if (made?.run === move.run && !firsts.has(made.step)) firsts.set(made.step, i);
  }
  return (all[operation.cycle]?.[move.run] ?? []).map((words, i) => ({
    number: i + 1,
    words,
    first: firsts.get(i + 1) ?? null,
    runs: running === i + 1,
  }));
}

/** Largest number of steps of any cycle in a run. */
export function mostSteps(t: Texts, { operations }: Run): number {
  const all: Partial<Record<number, CyclesTexts["of"][keyof CyclesTexts["of"]]>> = t.cycles.of;
  return operations.reduce(
    (most, { cycle }) => Math.max(most, all[cycle]?.rough.length ?? 0, all[cycle]?.finish.length ?? 0),
    0,
  );
}

/**
 * The chip of a moment in one line; empty without one. It includes the feed per revolution if the readout shows the
 * feed per minute.
 */
export function chipText(lengths: Lengths, chip: Chip | null, move: Move | undefined): string {
  if (!chip || !move) return "";
  const said = (size: number) => lengths.fixed(size, 3);
  const feed =
    (move.kind === "feed" || move.kind === "arc") && move.feedUnit === "mm/min" ? ` · f ${said(chip.feed)}` : "";
  return lengths.words(
    `ap ${said(chip.depth)}${feed} · h ${said(chip.thickest.size)} mm · A ${lengths.fixedArea(chip.area, 3)} mm²`,
  );
}

/** Texts about a position; null if the run has no moves. */
export function runningText(t: Texts, lengths: Lengths, run: Run, position: PlayPosition): Running | null {
  const index = Math.min(position.step, run.steps.length - 1),
    step = run.steps[index],
    tip = tipAt(run.steps, position);
  if (!step || !tip) return null;
  const operation = step.operation === null ? undefined : run.operations[step.operation],
    speed = rpmAt(spindleAt(run.spindles, index), tip.r);
  const { pass } = step.move;
  return {
    ...placeText(lengths, tip),
    feed: runningFeed(t.lathe, lengths, step.move),
    speed: Number.isNaN(speed) ? "–" : `${formatNumber(lengths.language, speed, 0)} ${t.lathe.rpm}`,
    phase: phaseText(t.lathe, step.move),
    pass:
      pass !== undefined && operation ? t.lathe.pass(String(pass), String(Math.max(pass, operation.plan.passes))) : "",
    step: stepText(t, operation, step.move),
    block: t.lathe.block(String(step.block)),
  };
}
