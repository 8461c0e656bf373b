import { cycleByNumber } from "../../cycles/index.ts";
import { issue } from "../../kernel/plan/issue.ts";
import { klartext } from "../../nc/blocks/klartext.ts";
import type { Block, Program } from "../../nc/program.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Statement, StatementOf } from "../../nc/statement.ts";
import type { Words } from "../../nc/words.ts";
import { assign, assignText } from "../blocks/assign.ts";
import {
  blankBox,
  blankCylinder,
  blankFile,
  blankOfTurnData,
  blankRotation,
  cuboidOf,
  reportTurnedBox,
  reportMissingBlank,
  turnBlank,
} from "../blocks/blank-block.ts";
import { clampedOf, takeComment } from "../clamping/read-clamping.ts";
import { contourCycle, contourDefinition, selectContour } from "../blocks/contour-choice.ts";
import { CONTOUR_CYCLE, PROGRAM_CYCLE } from "../../nc/blocks/cycle-line.ts";
import { callCycle, cycleDefinition } from "../blocks/cycle-call.ts";
import { datumLine, DATUM_CYCLE, resetDatum, shiftDatum, tableDatum } from "../motion/datum.ts";
import { advance, reportUnreached, wordsOf } from "../blocks/flow.ts";
import { runFree } from "../blocks/free-run.ts";
import { programIssue } from "../state/issue.ts";
import { Machine } from "../state/machine.ts";
import { isInMachineCoordinates, retract, retracts } from "../motion/machine-moves.ts";
import { runApproach, chamfer, finish, path } from "../motion/motion.ts";
import { callProgram, callSelected, programCycle, selectProgram } from "../blocks/program-calls.ts";
import { flushPendingElement } from "../motion/path-block.ts";
import { NOWHERE } from "../state/path.ts";
import { timingOf } from "./run-times.ts";
import { reportUncalledCycles } from "../state/preconditions.ts";
import { applySpindleStart, applySpindleStop } from "../blocks/spindle-start.ts";
import { runInput, type RunInput } from "../state/run-input.ts";
import type { RunState } from "../state/run-state.ts";
import type { Run } from "../state/run-types.ts";
import type { Shop } from "../state/shop.ts";
import { correctTool, toolCall, toolDefinition } from "../blocks/tool-call.ts";
import {
  mirrorAxes,
  scaleAxes,
  transformedTurning,
  transformLine,
  transforms,
  turnPlane,
} from "../motion/transform-blocks.ts";
import { actingLine, actsAtOnce, isSilent, textBlock } from "../blocks/unproved-blocks.ts";

/** Runs a program: executes block after block and plans every cycle that it calls. Never throws, always ends. */
export function run(program: Program, shop: Shop): Run {
  const input = runInput(program, shop);
  return finishedRun(input, step(input, firstState(input)));
}

/** Runs a program without a blank on the stock that the cuts of other programs have left in the chuck. */
export function runOn(standing: readonly Ring[], program: Program, shop: Shop): Run {
  const input = runInput(program, shop);
  return finishedRun(input, step(input, firstState(input, standing)));
}

const frameOf = ({ blocks }: Program) => {
  const begin = blocks.find((b) => b.statement.kind === "begin")?.statement;
  return begin?.kind === "begin" ? begin : { name: "", unit: "MM" as const };
};

/** No count of this run: a stock that stood before it has been cut. */
const EARLIER = { operations: -1, steps: 0 } as const;

/** The state before the first block. */
export function firstState(input: RunInput, standing?: readonly Ring[]): RunState {
  const machine = new Machine(input);
  const inch = frameOf(input.program).unit === "INCH";
  machine.set({ turning: beginsTurning(input.program), inch });
  if (standing)
    machine.set({
      blank: standing,
      blankSince: EARLIER,
      bored: { since: EARLIER, steps: 0, operations: 0, below: Infinity, isBored: true },
    });
  machine.known.setUnit(inch);
  return machine.state;
}

/** Runs blocks up to the next snapshot that `isDue` requests, else up to the ending. */
export function step(input: RunInput, state: RunState, isDue?: (next: number, executed: number) => boolean): RunState {
  const machine = new Machine(input, state);
  do advance(machine, (s, index) => block(machine, s, index));
  while (!machine.run.flow.ending && !isDue?.(machine.run.next, machine.run.executed));
  return machine.state;
}

/** Result of a run at its ending. */
export function finishedRun(input: RunInput, state: RunState): Run {
  const machine = new Machine(input, state);
  const { program } = input,
    { log } = machine;
  finish(machine);
  machine.closeArrival();
  reportTurnedBox(machine);
  const hasTurned = log.steps.length > 0;
  if (machine.now.turning && hasTurned) log.noteDatum(machine.now.datum.x, machine.now.datum.z);
  const { ending, isFaultReported } = state.flow;
  if (!(ending && reportUnreached(machine, ending)) && !isFaultReported) reportUncalledCycles(machine);
  if (!ending?.word && !isFaultReported && hasTurned)
    log.report(programIssue("programEndMissing", "warning", {}), program.blocks.length - 1);
  if (log.operations.length > 0 && machine.now.blank.length === 0) reportMissingBlank(machine);
  const { nonMotion, firstBlank, ...noted } = log.state;
  const { toolChange, spindle, dwell } = nonMotion;
  const blank = firstBlank ?? machine.now.blank,
    clamping = clampedOf(machine, blank),
    plane = noted.milled.all();
  return {
    program: {
      name: frameOf(program).name,
      unit: machine.now.inch ? "inch" : "mm",
      blocks: program.blocks.filter(
        (b) => b.statement.kind !== "empty" && (b.number !== null || b.statement.kind !== "comment"),
      ).length,
    },
    blank,
    clamping,
    cuboid: cuboidOf(machine),
    stated: noted.stated.all(),
    operations: noted.operations.all(),
    steps: noted.steps.all(),
    stepBlocks: noted.stepBlocks.all(),
    plane,
    approaches: noted.approaches.all(),
    datums: noted.datums.all(),
    spindles: noted.spindles.all(),
    unproved: noted.unproved.all(),
    issues: log.allFindings(),
    seconds: plane.reduce((sum, s) => sum + s.seconds, noted.seconds + toolChange + spindle + dwell),
    timing: timingOf(input.shop, nonMotion),
  };
}

/** True for turning only: its spindle, and its cycles. */
const isTurned = ({ statement: s }: Block) =>
  s.kind === "spin" || (s.kind === "cycle" && cycleByNumber(s.cycle) !== undefined);

/** A program section without FUNCTION MODE before its first turning block is read as turning. */
const beginsTurning = (program: Program) => {
  const first = program.blocks.find((b) => b.statement.kind === "mode" || isTurned(b));
  return first !== undefined && first.statement.kind !== "mode";
};

/** Effect of each kind of block. "order": handled by the block order or by its M functions. */
type Handler<K extends Statement["kind"]> =
  | ((machine: Machine, s: StatementOf<K>, index: number) => void)
  | "order"
  | "nothing";
const HANDLERS: { readonly [K in Statement["kind"]]: Handler<K> } = {
  begin: "order",
  end: "order",
  label: "order",
  call: "order",
  jump: "order",
  raise: "order",
  functions: "order",
  stop: "order",
  empty: "nothing",
  structure: "nothing",
  declareContour: "nothing",
  contourFormula: "nothing",
  comment: (machine, s, index) => takeComment(machine, s.text, index),
  path,
  chamfer,
  free: runFree,
  approach: runApproach,
  toolDefinition,
  toolCall,
  blankBox,
  blankCylinder,
  blankRotation,
  blankFile,
  turnBlank: blankOfTurnData,
  turnCorrection: correctTool,
  mode: (machine, s, index) => mode(machine, s.mode, index),
  datum: (machine, s, index) => {
    if (s.shift === "reset") resetDatum(machine);
    else shiftDatum(machine, s.shift, "TRANS DATUM", index);
  },
  datumTable: (machine, s, index) => tableDatum(machine, `TRANS DATUM TABLE ${s.row}`.trim(), index),
  mirror: (machine, s, index) => mirrorAxes(machine, s.axes, { what: "TRANS MIRROR", index }),
  rotation: (machine, s, index) => turnPlane(machine, s.angle, { what: "TRANS ROTATION", index }),
  scale: (machine, s, index) => scaleAxes(machine, s.factor, { what: "TRANS SCALE", index }),
  plane: (machine, s, index) => textBlock(machine, s.text, index),
  spin,
  assign,
  assignText,
  cycle: (machine, _, index) => cycleDefinition(machine, index),
  cycleLine,
  cycleCall: (machine, s, index) => (s.how === "" ? callCycle(machine, index) : callPattern(machine, s.how, index)),
  selectContour,
  contourDefinition,
  callProgram,
  selectProgram,
  callSelected: (machine, _, index) => callSelected(machine, index),
  undercut: (machine, s, index) => machine.log.leaveUnproved(`UDC ${s.form}`, index),
  groove: (machine, s, index) => machine.log.leaveUnproved(`GRV ${s.form}`, index),
  unknown: (machine, s, index) => textBlock(machine, s.text, index),
};

/** Whether a kind of block has an effect; of comments only the clamping comment has one. */
export const hasEffect = (kind: Statement["kind"]): boolean => kind !== "comment" && HANDLERS[kind] !== "nothing";

/** Feed per revolution, and per minute. */
const FEED_UNITS: readonly number[] = [136, 137];

/** Finishes pending contours and elements that a block cannot continue. */
function before(machine: Machine, s: Statement, words: Words | null): void {
  const ends =
    klartext.has(s, "endsContour") ||
    (words && (retracts(words) || (s.kind === "path" && isInMachineCoordinates(words))));
  if (ends) return finish(machine);
  const waits = klartext.has(s, "waits") && !(s.kind === "path" && s.path === "CC");
  if (!waits || words?.functions.some((m) => FEED_UNITS.includes(m))) flushPendingElement(machine);
}

function handle<K extends Statement["kind"]>(machine: Machine, kind: K, s: StatementOf<K>, index: number): void {
  const handler: Handler<K> = HANDLERS[kind];
  if (typeof handler === "function") handler(machine, s, index);
}

function block(machine: Machine, s: Statement, index: number): void {
  const words = wordsOf(s),
    { comment } = machine.blocks[index] ?? {};
  if (comment !== undefined) takeComment(machine, comment, index);
  before(machine, s, words);
  if (words) functions(machine, words, index);
  handle(machine, s.kind, s, index);
  if (!words) return;
  const [once, on] = [words.functions.includes(99), words.functions.includes(89)];
  if (once || on || (machine.now.callsBehindMoves && s.kind === "path" && words.axes.length > 0)) {
    finish(machine);
    callCycle(machine, index);
  }
  applySpindleStop(machine, words, index);
  machine.set({ callsBehindMoves: !once && (on || machine.now.callsBehindMoves) });
}

function functions(machine: Machine, words: Words, index: number): void {
  for (const m of words.functions) if (FEED_UNITS.includes(m)) machine.set({ perRevolution: m === 136 });
  applySpindleStart(machine, words, index);
  if (words.extra) machine.log.leaveUnproved(words.extra.join(" ").slice(0, 40), index);
  if (retracts(words)) retract(machine, words, index);
}

/** Another mode has other kinematics: the tool position in its coordinates is unknown. */
function mode(machine: Machine, wanted: "TURN" | "MILL", index: number): void {
  machine.set({ mode: wanted });
  if (wanted === "TURN") {
    transformedTurning(machine, index);
    turnBlank(machine);
  } else machine.change({ traced: null });
  machine.setPlace({ last: null });
  if (machine.now.turning === (wanted === "TURN")) return;
  machine.closeArrival();
  machine.set({ turning: wanted === "TURN", pole: null, offsetY: null });
  machine.setPlace({ sure: { x: false, z: false }, positionedBy: null, mill: NOWHERE });
  machine.millGuide.here = null;
}

/** CYCL CALL POS and PAT: their positions are not simulated. */
function callPattern(machine: Machine, how: string, index: number): void {
  if (machine.now.defined) machine.markCalled(machine.now.defined.index);
  machine.losePosition();
  machine.log.leaveUnproved(`CYCL CALL ${how}`, index);
}

/** Input range of a spindle speed, rpm. */
const FASTEST_SPINDLE = 99_999.999;

function spin(machine: Machine, s: StatementOf<"spin">, index: number): void {
  const read = (v: typeof s.speed) => (v === null ? null : machine.number(v, index));
  const [speed, cuttingSpeed, limit] = [read(s.speed), read(s.cuttingSpeed), read(s.limit)];
  if (limit !== null && limit < 0)
    machine.log.report(issue("outOfRange", "error", { value: limit, min: 0, max: FASTEST_SPINDLE }, "SMAX"), index);
  if (s.constantSurface && cuttingSpeed !== null && cuttingSpeed > 0) {
    machine.set({ spindle: { kind: "surface", cuttingSpeed, limit: Math.max(0, limit ?? 0) }, spinBlock: index });
  } else if (!s.constantSurface && speed !== null && speed > 0)
    machine.set({ spindle: { kind: "constant", speed }, spinBlock: index });
  else {
    machine.log.report(programIssue("spindleMissing", "error", {}), index);
    machine.set({ speedElsewhere: "told" });
  }
}

/**
 * One line of an older cycle: shift, mirror, rotation and scale are run, contour labels are recorded, other cycles are
 * reported.
 */
function cycleLine(machine: Machine, s: StatementOf<"cycleLine">, index: number): void {
  const { cycle, line, text } = s;
  if (cycle === CONTOUR_CYCLE) contourCycle(machine, s, index);
  else if (cycle === PROGRAM_CYCLE) programCycle(machine, s, index);
  else if (cycle === DATUM_CYCLE) {
    if (line > 0) datumLine(machine, text, `CYCL DEF ${cycle}`, index);
  } else if (transforms(cycle)) transformLine(machine, s, index);
  else {
    if (!isSilent(cycle)) machine.log.report(programIssue("cycleNotSimulated", "info", { cycle, name: text }), index);
    if (actsAtOnce(cycle)) actingLine(machine, s, index);
    else if (line === 0) machine.set({ defined: { index, cycle, values: new Map(), unknownParameters: new Set() } });
  }
}
