import type { Statement } from "../../nc/statement.ts";
import type { Label, Parameter, Value, Words } from "../../nc/words.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
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

/** Where a call goes on when it comes back. */
interface Return {
  readonly on: number;
  /** Of a program that was called: what it goes back to. */
  readonly caller: { readonly unit: Unit; readonly inch: boolean; readonly locals: () => void } | null;
}

interface Flow {
  readonly machine: Machine;
  readonly returns: Return[];
  readonly repeats: Map<number, number>;
  /** A jump hung on a value that nobody knows: the control may have gone another way. */
  guessed: boolean;
}

const isText = (parameter: string) => parameter.startsWith("QS");

/**
 * How a program came to its end: the block that ended it and its word, or none when the text ran out or a bound was
 * met.
 */
export interface Ending {
  readonly index: number;
  readonly word: string | null;
  /** A fault that has been told stopped it, or took the end away. */
  readonly told: boolean;
}

/**
 * Where a run begins, and who sees it before each block while no call has to return and nothing was guessed or told.
 */
export interface RunCourse {
  readonly from: number;
  readonly watch?: (next: number) => void;
}

/** Runs block after block, with calls, repetitions, jumps and the programs that are called. */
export function execute(
  machine: Machine,
  block: (s: Statement, index: number) => void,
  { from, watch }: RunCourse,
): Ending {
  const flow: Flow = { machine, returns: [], repeats: new Map(), guessed: false };
  let [next, told] = [from, false];
  for (;;) {
    if (watch && flow.returns.length === 0 && flow.repeats.size === 0 && !flow.guessed && !told) watch(next);
    if (next >= machine.unit.to) {
      const on = back(flow);
      if (on === null) return { index: next, word: null, told };
      next = on;
      continue;
    }
    if (!machine.roomForBlock(next)) return { index: next, word: null, told: true };
    const index = next;
    next += 1;
    const s = machine.blocks[index]?.statement;
    if (!s) continue;
    machine.visit(index);
    if (machine.isSkipped(index)) continue;
    if (s.kind === "label" && s.label === 0) next = fromLabel(flow, next);
    else if (s.kind === "label" && machine.unit.contours.has(s.label) && machine.labels.get(s.label) === index) {
      machine.log.say(programIssue("runsIntoLabel", "error", { label: String(s.label) }), index);
      told = true;
      next = behindLabel(machine, index);
    } else if (s.kind === "call") next = call(flow, s, index);
    else if (s.kind === "jump") next = jump(flow, s, index);
    else if (s.kind === "raise") {
      if (raises(flow, s, index)) return { index, word: null, told: true };
    } else if (s.kind !== "end") block(s, index);
    if (machine.next) next = enter(flow, machine.next, next);
    const word = endOf(s);
    if (word === null) continue;
    const on = back(flow);
    if (on === null) return { index, word, told };
    if (s.kind !== "end") machine.log.say(programIssue("endInCalled", "warning", { word }), index);
    next = on;
  }
}

/** LBL 0 goes back behind the call of its label, but not out of a program. */
function fromLabel({ returns }: Flow, next: number): number {
  if (returns.at(-1)?.caller !== null) return next;
  return returns.pop()?.on ?? next;
}

/** Goes into a program that was called: it has its own blocks, labels, local parameters and unit. */
function enter({ machine, returns }: Flow, unit: Unit, on: number): number {
  machine.next = null;
  if (returns.filter((r) => r.caller).length >= DEEPEST_CALL) {
    machine.stop(programIssue("programsTooDeep", "error", { limit: DEEPEST_CALL }), on - 1);
    return on;
  }
  returns.push({ on, caller: { unit: machine.unit, inch: machine.now.inch, locals: machine.known.withoutLocals() } });
  machine.unit = unit;
  machine.set({ inch: unit.inch });
  return unit.from;
}

/** Where a program goes on that has come to its end; null when it is the one that was started. */
function back({ machine, returns }: Flow): number | null {
  for (let r = returns.pop(); r; r = returns.pop()) {
    if (!r.caller) continue;
    machine.unit = r.caller.unit;
    machine.set({ inch: r.caller.inch });
    r.caller.locals();
    return r.on;
  }
  return null;
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

/** The label that is meant: as it is written, or what a parameter holds. */
function labelOf(machine: Machine, named: Label | Parameter, index: number): Label | null {
  if (typeof named !== "object") return named;
  const { parameter } = named;
  if (!isText(parameter)) return machine.number(named, index);
  // A label may carry the name of the parameter itself.
  return machine.labels.has(parameter) ? parameter : machine.text(parameter, index);
}

/** The block of a label; null when there is none, or none that is known. */
function target(
  machine: Machine,
  named: Extract<Statement, { kind: "call" | "jump" }>["label"],
  index: number,
): number | null {
  const label = labelOf(machine, named, index);
  if (label === null) return null;
  const found = machine.labels.get(label);
  if (found === undefined) machine.log.say(programIssue("labelMissing", "error", { label: String(label) }), index);
  return found ?? null;
}

/** How many labels of the program that runs have called each other. */
const depthOf = (returns: readonly Return[]) => returns.length - 1 - returns.findLastIndex((r) => r.caller !== null);

/**
 * Where a label call goes on. A call with REP repeats the blocks between label and call; one without returns at LBL 0.
 */
function call({ machine, returns, repeats }: Flow, s: Extract<Statement, { kind: "call" }>, index: number): number {
  const on = index + 1;
  const to = target(machine, s.label, index);
  if (to === null) return on;
  if (s.repeat !== null) {
    const left = repeats.get(index) ?? machine.number(s.repeat, index) ?? 0;
    repeats.delete(index);
    if (!(left >= 1)) return on;
    repeats.set(index, left - 1);
    return to + 1;
  }
  if (depthOf(returns) >= DEEPEST_CALL) {
    machine.log.say(programIssue("callsTooDeep", "error", { limit: DEEPEST_CALL }), index);
    return on;
  }
  returns.push({ on, caller: null });
  return to + 1;
}

/** Where a jump goes on. One that hangs on a value nobody knows goes on behind it, and nothing is proved from there. */
function jump(flow: Flow, s: Extract<Statement, { kind: "jump" }>, index: number): number {
  const { machine } = flow;
  const on = index + 1;
  const holds = compare(machine, s, index);
  flow.guessed ||= holds === null;
  return holds ? (target(machine, s.label, index) ?? on) : on;
}

/** FN 14: the control stops here with an error. True, unless it may have gone another way before. */
function raises({ machine, guessed }: Flow, s: Extract<Statement, { kind: "raise" }>, index: number): boolean {
  if (guessed) machine.log.leaveUnproved("FN 14", index);
  else machine.log.say(programIssue("errorRaised", "error", { error: machine.number(s.error, index) }), index);
  return !guessed;
}

/** Whether a comparison holds; null when that hangs on a value that is not known. */
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

/**
 * Motion and calls behind the end of the program that nothing has run: the first of them is named. True when there is
 * one.
 */
export function neverReached(machine: Machine, ending: Ending): boolean {
  if (ending.word === null) return false;
  const used = usedLabels(machine);
  for (let i = ending.index + 1; i < machine.unit.to; i += 1) {
    const s = machine.blocks[i]?.statement;
    if (!s || machine.visited[i] || machine.isSkipped(i)) continue;
    if (s.kind === "label" && s.label !== 0 && (used === "all" || used.has(s.label))) i = behindLabel(machine, i) - 1;
    else if (runs(s)) {
      machine.log.say(programIssue("neverReached", "warning", { by: ending.word }), i);
      return true;
    }
  }
  return false;
}

/** Labels that a block of the program names: why they were not run is another matter. */
function usedLabels(machine: Machine): ReadonlySet<Label> | "all" {
  const used = new Set<Label>(machine.unit.contours);
  for (const { statement: s } of machine.program.blocks) {
    if (s.kind !== "call" && s.kind !== "jump") continue;
    if (typeof s.label === "object") return "all";
    used.add(s.label);
  }
  return used;
}
