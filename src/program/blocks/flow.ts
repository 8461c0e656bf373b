import type { Statement } from "../../nc/statement.ts";
import type { Label, Parameter, Value, Words } from "../../nc/words.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import type { Ending, Return } from "../state/run-state.ts";
import type { Unit } from "../state/units.ts";

/** Nesting of subprograms on the control. */
const DEEPEST_CALL = 19;
const PROGRAM_ENDS: ReadonlySet<number> = new Set([2, 30]);

export const wordsOf = (s: Statement): Words | null => ("words" in s && "functions" in s.words ? s.words : null);
const endOf = (s: Statement): string | null => {
  if (s.kind === "end") return "END PGM";
  const m = wordsOf(s)?.functions.find((each) => PROGRAM_ENDS.has(each));
  return m === undefined ? null : `M${m}`;
};

const isText = (parameter: string) => parameter.startsWith("QS");

/**
 * Executes the next block with its call, repetition or jump, or the end of the text. After the program end the flow has
 * an ending.
 */
export function advance(machine: Machine, block: (s: Statement, index: number) => void): void {
  const index = machine.run.next;
  if (index >= machine.unit.to) return back(machine, { index, word: null });
  if (!machine.roomForBlock(index)) return machine.setFlow({ isFaultReported: true, ending: { index, word: null } });
  const s = machine.blocks[index]?.statement;
  machine.goTo(index + 1);
  if (!s) return;
  machine.visit(index);
  if (machine.isSkipped(index)) return;
  if (s.kind === "label") label(machine, s.label, index);
  else if (s.kind === "call") call(machine, s, index);
  else if (s.kind === "jump") jump(machine, s, index);
  else if (s.kind === "raise") raise(machine, s, index);
  else if (s.kind !== "end") block(s, index);
  const { enters } = machine.run;
  if (enters) enter(machine, enters);
  const word = machine.run.flow.ending ? null : endOf(s);
  if (word === null) return;
  back(machine, { index, word });
  if (!machine.run.flow.ending && s.kind !== "end")
    machine.log.report(programIssue("endInCalled", "warning", { word }), index);
}

/** LBL 0 returns to its call, but not out of a program; no program runs into a contour. */
function label(machine: Machine, named: Label, index: number): void {
  const { returns } = machine.run.flow;
  if (named === 0) {
    if (returns?.caller === null) goBack(machine, returns);
  } else if (machine.unit.contours.has(named) && machine.labels.get(named) === index) {
    machine.log.report(programIssue("runsIntoLabel", "error", { label: String(named) }), index);
    machine.setFlow({ isFaultReported: true });
    machine.goTo(behindLabel(machine, index));
  }
}

function goBack(machine: Machine, { on, outer: returns }: Return): void {
  machine.setFlow({ returns });
  machine.goTo(on);
}

const callsIn = (returns: Return | null): readonly Return[] => (returns ? [returns, ...callsIn(returns.outer)] : []);

/** Enters a called program, which has its own blocks, labels, local parameters and unit. */
function enter(machine: Machine, unit: Unit): void {
  const { next: on } = machine.run,
    { returns: outer } = machine.run.flow;
  machine.change({ enters: null });
  if (callsIn(outer).filter(({ caller }) => caller).length >= DEEPEST_CALL)
    return machine.stop(programIssue("programsTooDeep", "error", { limit: DEEPEST_CALL }), on - 1);
  const caller = { unit: machine.unit, inch: machine.now.inch, locals: machine.known.takeLocals() };
  machine.change({ unit });
  machine.set({ inch: unit.inch });
  machine.setFlow({ returns: { on, caller, outer } });
  machine.goTo(unit.from);
}

/** At its end, a program returns to its caller or ends the run. */
function back(machine: Machine, ending: Ending): void {
  const called = callsIn(machine.run.flow.returns).find(({ caller }) => caller);
  if (!called?.caller) return machine.setFlow({ returns: null, ending });
  machine.change({ unit: called.caller.unit });
  machine.set({ inch: called.caller.inch });
  machine.known.putLocals(called.caller.locals);
  goBack(machine, called);
}

/** The block behind the LBL 0 that closes a label. */
function behindLabel(machine: Machine, index: number): number {
  let i = index + 1;
  for (; i < machine.unit.to; i += 1) {
    const s = machine.blocks[i]?.statement;
    machine.visit(i);
    if (s?.kind === "end") return i;
    if (s?.kind === "label" && s.label === 0) return i + 1;
  }
  return i;
}

/** Label as written, or as held by a parameter. */
function labelOf(machine: Machine, named: Label | Parameter, index: number): Label | null {
  if (typeof named !== "object") return named;
  const { parameter } = named;
  if (!isText(parameter)) return machine.number(named, index);
  // A label may carry the name of the parameter itself.
  return machine.labels.has(parameter) ? parameter : machine.text(parameter, index);
}

/** Block of a label; null when it is missing or unknown. */
function target(
  machine: Machine,
  named: Extract<Statement, { kind: "call" | "jump" }>["label"],
  index: number,
): number | null {
  const label = labelOf(machine, named, index);
  if (label === null) return null;
  const found = machine.labels.get(label);
  if (found === undefined) machine.log.report(programIssue("labelMissing", "error", { label: String(label) }), index);
  return found ?? null;
}

/** Nesting depth of label calls in the running program. */
function depthOf(returns: Return | null): number {
  const depth = callsIn(returns).findIndex(({ caller }) => caller);
  return depth < 0 ? callsIn(returns).length : depth;
}

/**
 * Continues at the called label. REP repeats the blocks between label and call; a call without REP returns at LBL 0.
 */
function call(machine: Machine, s: Extract<Statement, { kind: "call" }>, index: number): void {
  const { returns: outer, repeats } = machine.run.flow;
  const to = target(machine, s.label, index);
  if (to === null) return;
  if (s.repeat !== null) {
    const left = repeats.get(index) ?? machine.number(s.repeat, index) ?? 0;
    const others = new Map(repeats);
    others.delete(index);
    if (left >= 1) others.set(index, left - 1);
    machine.setFlow({ repeats: others });
    if (left >= 1) machine.goTo(to + 1);
  } else if (depthOf(outer) >= DEEPEST_CALL)
    machine.log.report(programIssue("callsTooDeep", "error", { limit: DEEPEST_CALL }), index);
  else {
    machine.setFlow({ returns: { on: index + 1, caller: null, outer } });
    machine.goTo(to + 1);
  }
}

/** A jump. With an unknown condition the run continues behind it, unverified from there. */
function jump(machine: Machine, s: Extract<Statement, { kind: "jump" }>, index: number): void {
  const holds = compare(machine, s, index);
  if (holds === null) machine.setFlow({ hasUnknownJump: true });
  const to = holds ? target(machine, s.label, index) : null;
  if (to !== null) machine.goTo(to);
}

/** FN 14: the control stops here with an error, unless an unknown jump may have bypassed it. */
function raise(machine: Machine, s: Extract<Statement, { kind: "raise" }>, index: number): void {
  if (machine.run.flow.hasUnknownJump) return machine.log.leaveUnproved("FN 14", index);
  machine.log.report(programIssue("errorRaised", "error", { error: machine.number(s.error, index) }), index);
  machine.setFlow({ isFaultReported: true, ending: { index, word: null } });
}

/** Whether a comparison holds; null when a value is unknown. */
function compare(machine: Machine, s: Extract<Statement, { kind: "jump" }>, index: number): boolean | null {
  if (s.right === null) {
    const set = typeof s.left === "number" || machine.known.isSet(s.left.parameter);
    if (set === null) machine.log.leaveUnproved(s.fn === null ? "IF" : `FN ${s.fn}`, index);
    return set === null ? null : set === (s.compare === "IS DEFINED");
  }
  const read = (value: Value) =>
    typeof value === "object" && isText(value.parameter)
      ? machine.text(value.parameter, index)
      : machine.number(value, index);
  const [left, right] = [read(s.left), read(s.right)];
  if (left === null || right === null) {
    if (machine.known.isUnproved) machine.log.leaveUnproved(s.fn === null ? "IF" : `FN ${s.fn}`, index);
    return null;
  }
  switch (s.compare) {
    case "EQU":
      return left === right;
    case "NE":
      return left !== right;
    case "GT":
      return left > right;
    case "LT":
      return left < right;
    default:
      return false;
  }
}

const runs = (s: Statement) =>
  s.kind === "cycleCall" ||
  s.kind === "call" ||
  s.kind === "callProgram" ||
  s.kind === "callSelected" ||
  s.kind === "approach" ||
  s.kind === "free" ||
  (s.kind === "path" && s.path !== "CC") ||
  (wordsOf(s)?.functions.includes(99) ?? false);

/** Reports the first motion or call behind the program end that never runs. True when there is one. */
export function reportUnreached(machine: Machine, ending: Ending): boolean {
  if (ending.word === null) return false;
  const used = usedLabels(machine);
  const { visited } = machine.input.firstReads;
  for (let i = ending.index + 1; i < machine.unit.to; i += 1) {
    const s = machine.blocks[i]?.statement;
    if (!s || visited[i] || machine.isSkipped(i)) continue;
    if (s.kind === "label" && s.label !== 0 && (used === "all" || used.has(s.label))) i = behindLabel(machine, i) - 1;
    else if (runs(s)) {
      machine.log.report(programIssue("neverReached", "warning", { by: ending.word }), i);
      return true;
    }
  }
  return false;
}

/** Labels that the program calls: a called label that never ran is another fault. */
function usedLabels(machine: Machine): ReadonlySet<Label> | "all" {
  const used = new Set<Label>(machine.unit.contours);
  for (const { statement: s } of machine.input.program.blocks) {
    if (s.kind !== "call" && s.kind !== "jump") continue;
    if (typeof s.label === "object") return "all";
    used.add(s.label);
  }
  return used;
}
