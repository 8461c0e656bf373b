import type { Label, Statement, Words } from "../nc/statement.ts";
import { namesIn } from "./contour-names.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";

/** Nesting of subprograms on the control. */
const DEEPEST_CALL = 19;
const PROGRAM_ENDS: ReadonlySet<number> = new Set([2, 30]);

export const wordsOf = (s: Statement): Words | null => ("words" in s && "functions" in s.words ? s.words : null);
const endOf = (s: Statement): string | null => {
  if (s.kind === "end") return "END PGM";
  const m = wordsOf(s)?.functions.find((each) => PROGRAM_ENDS.has(each));
  return m === undefined ? null : `M${m}`;
};

interface Flow {
  readonly machine: Machine;
  readonly returns: number[];
  readonly repeats: Map<number, number>;
  /** Labels of contours: a program never runs into them. */
  readonly contours: ReadonlySet<Label>;
}

/** How a program came to its end: the block that ended it and its word, or none when the text ran out or a bound was met. */
export interface Ending {
  readonly index: number;
  readonly word: string | null;
  /** A fault that has been told stopped it, or took the end away. */
  readonly told: boolean;
}

/** Runs block after block, with calls, repetitions and jumps. */
export function execute(machine: Machine, block: (s: Statement, index: number) => void): Ending {
  const flow: Flow = { machine, returns: [], repeats: new Map(), contours: namesIn(machine.blocks) };
  let [next, told] = [0, false];
  while (next < machine.blocks.length) {
    if (!machine.roomForBlock(next)) return { index: next, word: null, told: true };
    const index = next;
    next += 1;
    const s = machine.blocks[index]?.statement;
    if (!s) continue;
    machine.visited[index] = 1;
    if (s.kind === "label" && s.label === 0) next = flow.returns.pop() ?? next;
    else if (s.kind === "label" && flow.contours.has(s.label) && machine.labels.get(s.label) === index) {
      machine.log.say(programIssue("runsIntoLabel", "error", { label: String(s.label) }), index);
      told = true;
      next = behindLabel(machine, index);
    } else if (s.kind === "call") next = call(flow, s, index);
    else if (s.kind === "jump") next = jump(machine, s, index);
    else if (s.kind !== "end") block(s, index);
    const word = endOf(s);
    if (word !== null) return { index, word, told };
  }
  return { index: machine.blocks.length, word: null, told };
}

/** The block behind the LBL 0 that closes a label. */
function behindLabel(machine: Machine, index: number): number {
  let i = index + 1;
  for (; i < machine.blocks.length; i += 1) {
    const s = machine.blocks[i]?.statement;
    machine.visited[i] = 1;
    if (s?.kind === "end") return i;
    if (s?.kind === "label" && s.label === 0) return i + 1;
  }
  return i;
}

/** The block of a label; null when there is none, or none that is known. */
function target(machine: Machine, named: Extract<Statement, { kind: "call" | "jump" }>["label"], index: number): number | null {
  const label = typeof named === "object" ? machine.number(named, index) : named;
  if (label === null) return null;
  const found = machine.labels.get(label);
  if (found === undefined) machine.log.say(programIssue("labelMissing", "error", { label: String(label) }), index);
  return found ?? null;
}

/** Where a label call goes on. A call with REP repeats the blocks between label and call; one without returns at LBL 0. */
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
  if (returns.length >= DEEPEST_CALL) {
    machine.log.say(programIssue("callsTooDeep", "error", { limit: DEEPEST_CALL }), index);
    return on;
  }
  returns.push(on);
  return to + 1;
}

/** Where a jump goes on. One that hangs on a value nobody knows goes on behind it, and nothing is proved from there. */
function jump(machine: Machine, s: Extract<Statement, { kind: "jump" }>, index: number): number {
  const on = index + 1;
  const holds = compare(machine, s, index);
  return holds ? (target(machine, s.label, index) ?? on) : on;
}

function compare(machine: Machine, s: Extract<Statement, { kind: "jump" }>, index: number): boolean {
  if (s.right === null) {
    const set = typeof s.left === "number" || machine.known.isSet(s.left.parameter);
    if (set === null) machine.log.leaveUnproved(s.fn === null ? "IF" : `FN ${s.fn}`, index);
    return set !== null && set === (s.compare === "IS DEFINED");
  }
  const [left, right] = [machine.number(s.left, index), machine.number(s.right, index)];
  if (left === null || right === null) {
    if (machine.known.isUnproved) machine.log.leaveUnproved(s.fn === null ? "IF" : `FN ${s.fn}`, index);
    return false;
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
  s.kind === "cycleCall" || s.kind === "call" || s.kind === "approach" || (s.kind === "path" && s.path !== "CC")
  || (wordsOf(s)?.functions.includes(99) ?? false);

/** Motion and calls behind the end of the program that nothing has run: the first of them is named. True when there is one. */
export function neverReached(machine: Machine, ending: Ending): boolean {
  if (ending.word === null) return false;
  const used = usedLabels(machine);
  for (let i = ending.index + 1; i < machine.blocks.length; i += 1) {
    const s = machine.blocks[i]?.statement;
    if (!s || machine.visited[i]) continue;
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
  const used = new Set<Label>(namesIn(machine.blocks));
  for (const { statement: s } of machine.blocks) {
    if (s.kind !== "call" && s.kind !== "jump") continue;
    if (typeof s.label === "object") return "all";
    used.add(s.label);
  }
  return used;
}
