import { axial, length as asLength, type Feed } from "../kernel/units.ts";
import type { Tool } from "../kernel/tool.ts";
import type { Program } from "../nc/program.ts";
import type { Statement, Words } from "../nc/statement.ts";
import { cycleByNumber } from "../cycles/index.ts";
import { cylinder, measured } from "./blank-form.ts";
import { callCycle, defineCycle, outlinedBlank } from "./cycle-call.ts";
import { programIssue } from "./issue.ts";
import { Machine, type Shop } from "./machine.ts";
import { cornerBlock, flush, pathBlock, pole } from "./path-block.ts";
import { closePlanes, planeStatement } from "./plane-run.ts";
import type { Run } from "./run-types.ts";
import { blankOfTurnData, correctTool } from "./turn-data.ts";

/** Nesting of subprograms on the control. */
const DEEPEST_CALL = 19;

const PROGRAM_ENDS: ReadonlySet<number> = new Set([2, 30]);

/** Runs a program: executes block after block and plans every cycle that it calls. Never throws, always ends. */
export function run(program: Program, shop: Shop): Run {
  const machine = new Machine(program, shop);
  machine.turning = !states(program, "mode") && turns(program);
  const begin = program.blocks.find((b) => b.statement.kind === "begin")?.statement;
  const frame = begin?.kind === "begin" ? begin : { name: "", unit: "MM" as const };
  machine.inch = frame.unit === "INCH";
  const ended = execute(machine);
  flush(machine);
  closePlanes(machine);
  if (!ended && machine.steps.length > 0) machine.say(programIssue("programEndMissing", "warning", {}), machine.blocks.length - 1);
  if (machine.operations.length > 0 && machine.blank.length === 0) machine.say(programIssue("blankMissing", "warning", {}), null);
  return {
    program: {
      name: frame.name, unit: machine.inch ? "inch" : "mm",
      blocks: program.blocks.filter((b) => b.statement.kind !== "empty" && (b.number !== null || b.statement.kind !== "comment")).length,
    },
    blank: machine.blank, operations: machine.operations, steps: machine.steps, stepBlocks: machine.stepBlocks,
    plane: machine.mill.steps, approaches: machine.approaches, unproved: machine.unproved,
    issues: machine.allFindings(), seconds: [...machine.steps, ...machine.mill.steps].reduce((sum, s) => sum + s.seconds, 0),
  };
}

const states = (program: Program, kind: Statement["kind"]) => program.blocks.some((b) => b.statement.kind === kind);

/** A piece of a program without FUNCTION MODE turns when it has something that only turns. */
const turns = (program: Program) =>
  program.blocks.some(({ statement: s }) => s.kind === "spin" || (s.kind === "cycle" && cycleByNumber(s.cycle) !== undefined));

/** Executes up to the end of the program; true when M2, M30 or END PGM was reached. */
function execute(machine: Machine): boolean {
  const returns: number[] = [];
  const repeats = new Map<number, number>();
  let next = 0;
  while (next < machine.blocks.length) {
    if (!machine.roomForBlock(next)) return true;
    const index = next;
    next += 1;
    const s = machine.blocks[index]?.statement;
    if (!s) continue;
    if (s.kind === "end") return true;
    if (s.kind === "label" && s.label === 0) {
      const back = returns.pop();
      if (back !== undefined) next = back;
    } else if (s.kind === "call") {
      next = call(machine, s, index, returns, repeats);
    } else {
      block(machine, s, index);
      if (endsProgram(s)) return true;
    }
  }
  return false;
}

const wordsOf = (s: Statement): Words | null => ("words" in s && "functions" in s.words ? s.words : null);
const endsProgram = (s: Statement) => wordsOf(s)?.functions.some((m) => PROGRAM_ENDS.has(m)) ?? false;

/** Where a label call goes on. A call with REP repeats the blocks between label and call; one without returns at LBL 0. */
function call(machine: Machine, s: Extract<Statement, { kind: "call" }>, index: number, returns: number[], repeats: Map<number, number>): number {
  const on = index + 1;
  const label = typeof s.label === "object" ? machine.number(s.label, index) : s.label;
  if (label === null) return on;
  const target = machine.labels.get(label);
  if (target === undefined) {
    machine.say(programIssue("labelMissing", "error", { label: String(label) }), index);
    return on;
  }
  if (s.repeat !== null) {
    const left = repeats.get(index) ?? machine.number(s.repeat, index) ?? 0;
    repeats.delete(index);
    if (!(left >= 1)) return on;
    repeats.set(index, left - 1);
    return target;
  }
  if (returns.length >= DEEPEST_CALL) {
    machine.say(programIssue("callsTooDeep", "error", { limit: DEEPEST_CALL }), index);
    return on;
  }
  returns.push(on);
  return target;
}

function block(machine: Machine, s: Statement, index: number): void {
  if (s.kind !== "path" && s.kind !== "chamfer" && s.kind !== "empty" && s.kind !== "comment" && s.kind !== "structure") flush(machine);
  const words = wordsOf(s);
  if (words) functions(machine, words, index);
  statement(machine, s, index);
  if (words?.functions.includes(99)) {
    flush(machine);
    closePlanes(machine);
    callCycle(machine, index);
  }
}

function functions(machine: Machine, words: Words, index: number): void {
  for (const m of words.functions) {
    if (m === 136 || m === 137) {
      flush(machine);
      machine.perRevolution = m === 136;
    } else if (m === 91 || m === 92 || m === 140) machine.notSimulated(`M${m}`, index, "warning");
  }
}

function statement(machine: Machine, s: Statement, index: number): void {
  if (planeStatement(machine, s, index)) return;
  switch (s.kind) {
    case "path":
      if (s.path === "CC") {
        flush(machine);
        return pole(machine, s.words, index);
      }
      if (s.path !== "RND") return pathBlock(machine, s.path, s.words, index);
      return corner(machine, "round", s.words.radius, s.words, index);
    case "chamfer":
      return corner(machine, "chamfer", s.length ?? undefined, s.words, index);
    case "mode": {
      machine.turning = s.mode === "TURN";
      return;
    }
    case "spin": return spin(machine, s, index);
    case "toolCall": return toolCall(machine, s, index);
    case "assign": return machine.assign(s, index);
    case "cycle": return defineCycle(machine, index);
    case "cycleLine": return cycleLine(machine, s, index);
    case "cycleCall": return s.how === "" ? callCycle(machine, index) : machine.notSimulated(`CYCL CALL ${s.how}`, index, "warning");
    case "blankCylinder": case "blankRotation": case "blankBox": return blank(machine, s, index);
    case "selectContour": {
      machine.contourLabels = [];
      machine.contourFile = s.file;
      return machine.notSimulated(`SEL CONTOUR "${s.file}"`, index, "warning");
    }
    case "turnCorrection": return correctTool(machine, s, index);
    case "turnBlank": return blankOfTurnData(machine, s, index);
    case "undercut": return machine.notSimulated(`UDC ${s.form}`, index, "warning");
    case "groove": return machine.notSimulated(`GRV ${s.form}`, index, "warning");
    default: return;
  }
}

function corner(machine: Machine, kind: "round" | "chamfer", size: Words["radius"], words: Words, index: number): void {
  const n = size === undefined ? null : machine.number(size, index);
  cornerBlock(machine, n === null ? null : { kind, size: machine.length(n) }, words.feed, index);
}

function spin(machine: Machine, s: Extract<Statement, { kind: "spin" }>, index: number): void {
  const read = (v: typeof s.speed) => (v === null ? null : machine.number(v, index));
  const [speed, cuttingSpeed, limit] = [read(s.speed), read(s.cuttingSpeed), read(s.limit)];
  if (s.constantSurface && cuttingSpeed !== null && cuttingSpeed > 0) {
    machine.spindle = { kind: "surface", cuttingSpeed, limit: Math.max(0, limit ?? 0) };
  } else if (!s.constantSurface && speed !== null && speed > 0) machine.spindle = { kind: "constant", speed };
  else machine.say(programIssue("spindleMissing", "error", {}), index);
}

function toolCall(machine: Machine, s: Extract<Statement, { kind: "toolCall" }>, index: number): void {
  if (typeof s.feed === "object" && s.feed) {
    const n = machine.number(s.feed.value, index);
    if (n !== null) machine.toolFeed = machine.feed = machine.feedOf(n) as Feed;
  }
  if (s.tool === null) return;
  const wanted = typeof s.tool === "object" ? machine.number(s.tool, index) : s.tool;
  if (wanted === null) return;
  const tool = machine.shop.refused?.has(Number(wanted)) ? undefined : find(machine.shop.tools, wanted);
  machine.sure = { x: false, z: false };
  machine.last = null;
  machine.tool = tool ?? null;
  machine.corrections = {};
  const refused = typeof wanted === "number" ? machine.shop.refused?.get(wanted) : undefined;
  if (refused) for (const i of refused) machine.say(i, index);
  else if (!tool && (machine.turning || turnsLater(machine, index)))
    machine.say(programIssue("toolUnknown", "error", { tool: String(wanted) }, "tool"), index);
  const deltas = (["deltaLength", "deltaRadius"] as const).some((d) => s[d] !== null && s[d] !== 0);
  if (deltas && tool && machine.turning) machine.notSimulated("DL DR", index, "warning");
}

/** A tool of another table is no fault while only milling follows. */
const turnsLater = (machine: Machine, index: number) => {
  for (let i = index + 1; i < machine.blocks.length; i += 1) {
    const s = machine.blocks[i]?.statement;
    if (s?.kind === "mode") return s.mode === "TURN";
    if (s?.kind === "toolCall") return false;
  }
  return false;
};

/** By number, the index behind the point aside, or by name. */
const find = (tools: readonly Tool[], wanted: number | string) =>
  typeof wanted === "number"
    ? (tools.find((t) => t.T === wanted) ?? tools.find((t) => t.T === Math.floor(wanted)))
    : tools.find((t) => t.NAME === wanted) ?? tools.find((t) => t.NAME.toUpperCase() === wanted.trim().toUpperCase());

/** Cycle 14 names the labels of the contour behind a word of any language: LABEL2, KONTURLABEL1 /2. */
function cycleLine(machine: Machine, s: Extract<Statement, { kind: "cycleLine" }>, index: number): void {
  if (s.cycle !== 14) return machine.say(programIssue("cycleNotSimulated", "info", { cycle: s.cycle, name: s.text }), index);
  machine.contourFile = null;
  if (s.line === 0) machine.contourLabels = [];
  else machine.contourLabels = [...s.text.matchAll(/"([^"]+)"|(\d{1,9})/g)].map((m) => m[1] ?? Number(m[2]));
}

function blank(machine: Machine, s: Extract<Statement, { kind: "blankCylinder" | "blankRotation" | "blankBox" }>, index: number): void {
  if (s.kind === "blankBox") {
    if (machine.turning) machine.say(programIssue("blankNotTurned", "info", { form: "BLK FORM 0.1" }), index);
    return;
  }
  if (s.kind === "blankRotation") return outlinedBlank(machine, s.label, s.measure === "R", index);
  const read = (v: typeof s.length) => {
    const n = v === null ? null : machine.number(v, index);
    return n === null ? null : machine.length(n);
  };
  const [outside, inside, long, distance] = [read(s.outside?.value ?? null), read(s.inside?.value ?? null), read(s.length), read(s.distance)];
  const rings = outside !== null && long !== null && cylinder({
    outside: measured(outside, s.outside?.measure === "D"), inside: measured(inside ?? 0, s.inside?.measure === "DI"),
    length: asLength(long), front: axial(distance ?? 0),
  });
  if (rings) machine.blank = rings;
  else machine.say(programIssue("blankImpossible", "error", {}), index);
}
