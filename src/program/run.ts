import { axial, length as asLength, type Feed } from "../kernel/units.ts";
import type { Tool } from "../kernel/tool.ts";
import type { Block, Program } from "../nc/program.ts";
import type { Statement, Words } from "../nc/statement.ts";
import { cycleByNumber } from "../cycles/index.ts";
import { cylinder, measured } from "./blank-form.ts";
import { CONTOUR_CYCLE, contourLabels } from "./contour-names.ts";
import { callCycle, defineCycle, outlinedBlank } from "./cycle-call.ts";
import { datumLine, DATUM_CYCLE, NO_SHIFT, shiftDatum } from "./datum.ts";
import { execute, neverReached, wordsOf } from "./flow.ts";
import { programIssue } from "./issue.ts";
import { Machine, type Shop } from "./machine.ts";
import { elsewhere, isElsewhere, retract, retracts } from "./machine-moves.ts";
import { NOWHERE } from "./path.ts";
import { cornerBlock, flush, pathBlock, pole } from "./path-block.ts";
import { closePlanes, planeStatement } from "./plane-run.ts";
import { neverCalled } from "./preconditions.ts";
import type { Run } from "./run-types.ts";
import { blankOfTurnData, correctTool } from "./turn-data.ts";
import { ACTIVE_AT_ONCE, actingLine, textBlock } from "./unproved-blocks.ts";

/** Runs a program: executes block after block and plans every cycle that it calls. Never throws, always ends. */
export function run(program: Program, shop: Shop): Run {
  const machine = new Machine(program, shop);
  machine.turning = beginsTurning(program);
  const begin = program.blocks.find((b) => b.statement.kind === "begin")?.statement;
  const frame = begin?.kind === "begin" ? begin : { name: "", unit: "MM" as const };
  machine.inch = frame.unit === "INCH";
  const ending = execute(machine, (s, index) => block(machine, s, index));
  flush(machine);
  closePlanes(machine);
  if (!neverReached(machine, ending) && !ending.told) neverCalled(machine);
  if (ending.word === null && !ending.told && machine.steps.length > 0) machine.say(programIssue("programEndMissing", "warning", {}), machine.blocks.length - 1);
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

/** True for what only turns: its spindle, and its cycles. */
const isTurned = ({ statement: s }: Block) => s.kind === "spin" || (s.kind === "cycle" && cycleByNumber(s.cycle) !== undefined);

/** A piece of a program without FUNCTION MODE before its first turned block is read as turning. */
const beginsTurning = (program: Program) => {
  const first = program.blocks.find((b) => b.statement.kind === "mode" || isTurned(b));
  return first !== undefined && first.statement.kind !== "mode";
};

/** Blocks that stand between two elements of a contour without ending it. */
const STILL: ReadonlySet<Statement["kind"]> = new Set(["path", "chamfer", "empty", "comment", "structure"]);

function block(machine: Machine, s: Statement, index: number): void {
  if (!STILL.has(s.kind)) flush(machine);
  const words = wordsOf(s);
  if (words) functions(machine, words, index);
  statement(machine, s, index);
  if (!words) return;
  const [once, on] = [words.functions.includes(99), words.functions.includes(89)];
  if (once || on || (machine.modal && s.kind === "path" && words.axes.length > 0)) {
    flush(machine);
    closePlanes(machine);
    callCycle(machine, index);
  }
  machine.modal = !once && (on || machine.modal);
}

function functions(machine: Machine, words: Words, index: number): void {
  for (const m of words.functions) {
    if (m !== 136 && m !== 137) continue;
    flush(machine);
    machine.perRevolution = m === 136;
  }
  if (words.extra.length > 0) machine.leaveUnproved(words.extra.join(" ").slice(0, 40), index);
  if (retracts(words)) retract(machine, words, index);
}

function statement(machine: Machine, s: Statement, index: number): void {
  if (s.kind === "path" && s.words.compensation !== undefined) machine.compensation = s.words.compensation;
  if (s.kind === "path" && isElsewhere(s.words)) return elsewhere(machine, s.words, index);
  if (planeStatement(machine, s, index)) return;
  switch (s.kind) {
    case "path":
      if (s.path === "CC") {
        flush(machine);
        return pole(machine, s.words, index);
      }
      if (s.path !== "RND") return pathBlock(machine, { path: s.path, words: s.words }, index);
      return corner(machine, "round", s.words.radius, s.words, index);
    case "chamfer":
      return corner(machine, "chamfer", s.length ?? undefined, s.words, index);
    case "mode": return mode(machine, s.mode);
    case "datum": return s.shift === "reset" ? void (machine.datum = NO_SHIFT) : shiftDatum(machine, s.shift, "TRANS DATUM", index);
    case "unknown": return textBlock(machine, s.text, index);
    case "spin": return spin(machine, s, index);
    case "toolCall": return toolCall(machine, s, index);
    case "assign": return machine.assign(s, index);
    case "cycle": return defineCycle(machine, index);
    case "cycleLine": return cycleLine(machine, s, index);
    case "cycleCall": return s.how === "" ? callCycle(machine, index) : callPattern(machine, s.how, index);
    case "blankCylinder": case "blankRotation": case "blankBox": return blank(machine, s, index);
    case "selectContour": {
      machine.contourLabels = [];
      machine.contourFile = s.file;
      return machine.notSimulated(`SEL CONTOUR "${s.file}"`, index, "warning");
    }
    case "turnCorrection": return correctTool(machine, s, index);
    case "turnBlank": return blankOfTurnData(machine, s, index);
    case "undercut": return machine.leaveUnproved(`UDC ${s.form}`, index);
    case "groove": return machine.leaveUnproved(`GRV ${s.form}`, index);
    default: return;
  }
}

/** Another kind of machining has other kinematics: where the tool stands in its coordinates, nobody knows. */
function mode(machine: Machine, wanted: "TURN" | "MILL"): void {
  machine.mode = wanted;
  if (machine.turning === (wanted === "TURN")) return;
  machine.turning = wanted === "TURN";
  machine.pole = null;
  machine.sure = { x: false, z: false };
  machine.mill.at = NOWHERE;
  machine.mill.here = null;
}

/** CYCL CALL POS and PAT: the positions at which the cycle would run are not run. */
function callPattern(machine: Machine, how: string, index: number): void {
  if (machine.defined) machine.called.add(machine.defined.index);
  machine.loseAll();
  machine.leaveUnproved(`CYCL CALL ${how}`, index);
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
    machine.feedWord = "F";
  }
  if (s.tool === null) return;
  const wanted = typeof s.tool === "object" ? machine.number(s.tool, index) : s.tool;
  if (wanted === null) return;
  const tool = machine.shop.refused?.has(Number(wanted)) ? undefined : find(machine.shop.tools, wanted);
  machine.sure = { x: false, z: false };
  machine.last = null;
  machine.compensation = "R0";
  machine.tool = tool ?? null;
  machine.toolRefused = !tool;
  machine.corrections = {};
  const refused = typeof wanted === "number" ? machine.shop.refused?.get(wanted) : undefined;
  if (refused) for (const i of refused) machine.say(i, index);
  else if (!tool && (machine.turning || turnsLater(machine, index)))
    machine.say(programIssue("toolUnknown", "error", { tool: String(wanted) }, "tool"), index);
  if (tool && ((tool.DZL ?? 0) !== 0 || (tool.DXL ?? 0) !== 0))
    machine.say(programIssue("lengthDelta", "info", { tool: tool.T }, "tool"), index);
  const deltas = (["deltaLength", "deltaRadius"] as const).some((d) => s[d] !== null && s[d] !== 0);
  if (deltas && tool && machine.turning) machine.leaveUnproved("DL DR", index);
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

/** One line of an older cycle: the datum shift is run, the contour's labels are noted, what else moves coordinates is told. */
function cycleLine(machine: Machine, s: Extract<Statement, { kind: "cycleLine" }>, index: number): void {
  const { cycle, line, text } = s;
  if (cycle === CONTOUR_CYCLE) {
    machine.contourFile = null;
    machine.contourLabels = line === 0 ? [] : contourLabels(text);
  } else if (cycle === DATUM_CYCLE) {
    if (line > 0) datumLine(machine, text, `CYCL DEF ${cycle}`, index);
  } else {
    machine.say(programIssue("cycleNotSimulated", "info", { cycle, name: text }), index);
    if (ACTIVE_AT_ONCE.has(cycle)) actingLine(machine, s, index);
    else if (line === 0) machine.defined = { index, cycle, values: new Map(), troubled: new Set() };
  }
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
