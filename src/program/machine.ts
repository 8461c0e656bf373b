import type { Issue } from "../kernel/issue.ts";
import type { FeedUnit, Move } from "../kernel/move.ts";
import type { Pt, Ring, Segment } from "../kernel/point.ts";
import type { Spindle, Step, Unproved } from "../kernel/step.ts";
import { secondsOf } from "../kernel/time.ts";
import type { Tool } from "../kernel/tool.ts";
import type { Feed } from "../kernel/units.ts";
import type { NcIssue } from "../nc/issue.ts";
import { blockNumbers, eachIssue, startLines, type Block, type Program } from "../nc/program.ts";
import type { Held } from "./held.ts";
import type { Compensation, Label, Statement, Value } from "../nc/statement.ts";
import { NO_SHIFT, type Datum } from "./datum.ts";
import { KnownValues, type Reason } from "./known-values.ts";
import { formulaOf, valueOf, type Parameters, type Trouble } from "./formula.ts";
import { fewAlike, MOST_ALIKE } from "./alike.ts";
import { programIssue, type ProgramIssue } from "./issue.ts";
import { MillState, type Mill } from "./mill-state.ts";
import { NOWHERE, pointIn, type Pole, type Position } from "./path.ts";
import type { Guide } from "./plane-chain.ts";
import type { ApproachRun, Control } from "./plane-types.ts";
import type { Finding, Operation } from "./run-types.ts";

/** What a run can use. */
export interface Shop {
  readonly tools: readonly Tool[];
  /** Tools whose columns are impossible, with what is wrong. */
  readonly refused?: ReadonlyMap<number, readonly Issue[]>;
  /** Rapid rate for times, mm/min. */
  readonly rapid: number;
  /** Milling tools of the table. */
  readonly mills?: readonly Mill[];
  /** Which control it is: how APPR and DEP move in the tool axis. "TNC 640" when absent. */
  readonly control?: Control;
}

type Correction = NonNullable<Tool["correction"]>;

/** A cycle definition waiting for its call. Numbers as they were when the definition was reached. */
export interface Defined {
  readonly index: number;
  readonly cycle: number;
  readonly values: ReadonlyMap<string, number | "auto" | null>;
  /** Parameters without a number for a reason that has been told. */
  readonly troubled: ReadonlySet<string>;
}

/** Bounds that keep every program finite and its memory small; far above what programs need (docs/performance.md). */
const MOST_BLOCKS = 200_000;
const MOST_MOVES = 400_000;
const MOST_OPERATIONS = 2_000;

/** Everything that changes while a program runs. X is a diameter, mm. */
export class Machine {
  readonly blocks: readonly Block[];
  readonly numbers: readonly number[];
  readonly lines: readonly number[];
  readonly labels = new Map<Label, number>();
  readonly parameters: Parameters = new Map();
  readonly known = new KnownValues(this.parameters);
  /** Millimetres in the program's unit of length. */
  inch = false;
  turning = false;
  /** As FUNCTION MODE said; null while no block has. */
  mode: "TURN" | "MILL" | null = null;
  /** Where the program counts from; all positions below are those of the workpiece. */
  datum: Datum = NO_SHIFT;
  at: Position = NOWHERE;
  /** False after a tool change until the axis is programmed again: nobody knows where the change left it. */
  sure = { x: false, z: false };
  /** Why a coordinate is not known any more, when a block that was not run or a fault that was told is the reason. */
  lost: Reason | null = null;
  /** RL or RR as programmed last. */
  compensation: Compensation = "R0";
  feed: Feed | null = null;
  /** Feed of the last positioning block, null for rapid; undefined before the first. */
  lastFeed: Feed | null | undefined = undefined;
  toolFeed: Feed | null = null;
  /** How the feed in force was written. */
  feedWord: "F" | "FAUTO" = "F";
  /** The feed and unit that were judged last, so that a modal feed is judged once. */
  judged = "";
  perRevolution = false;
  spindle: Spindle | null = null;
  tool: Tool | null = null;
  /** True when a TOOL CALL named a tool that can not be used: that has been told. */
  toolRefused = false;
  pole: Pole | null = null;
  contourLabels: Label[] = [];
  /** File that SEL CONTOUR names, until cycle 14 names labels. */
  contourFile: string | null = null;
  /** FUNCTION TURNDATA CORR of the tool in the spindle, mm. */
  corrections: { readonly TCS?: Correction; readonly WPL?: Correction } = {};
  defined: Defined | null = null;
  /** M89: the defined cycle is called behind every positioning block. */
  modal = false;
  /** Blocks of definitions that were taken up, and of those that were called. */
  readonly definitions = new Set<number>();
  readonly called = new Set<number>();
  /** Blocks that were run or read as part of a contour. */
  readonly visited: Uint8Array;
  held: Held | null = null;
  /** The last path element, for tangential arcs. */
  last: Segment | null = null;
  blank: readonly Ring[] = [];
  /** Compensated contours in turning. */
  readonly guide: Guide = { chain: null, here: null };
  readonly mill = new MillState();
  readonly approaches: ApproachRun[] = [];
  readonly steps: Step[] = [];
  readonly stepBlocks: number[] = [];
  readonly operations: Operation[] = [];
  readonly findings: Finding[] = [];
  readonly unproved: Unproved[] = [];
  private readonly said = new Set<string>();
  private preset: number | null = null;
  private readonly left = new Set<string>();
  /** Blocks executed, those of contours that cycles read included. */
  private executed = 0;
  full = false;

  constructor(readonly program: Program, readonly shop: Shop) {
    this.blocks = program.blocks;
    this.numbers = blockNumbers(program);
    this.lines = startLines(program);
    this.visited = new Uint8Array(this.blocks.length);
    this.blocks.forEach((b, i) => {
      if (b.statement.kind !== "label" || b.statement.label === 0) return;
      const { label } = b.statement;
      if (this.labels.has(label)) this.say(programIssue("labelTwice", "error", { label: String(label) }), i);
      else this.labels.set(label, i);
    });
  }

  /** Notes a finding at a block, once however often the block runs. `within` counts lines inside the block. */
  say(issue: Issue | ProgramIssue, index: number | null, within = 0, operation: number | null = null): void {
    const key = `${index} ${issue.code} ${issue.at ?? ""} ${operation ?? ""} ${operation === null ? "" : JSON.stringify(issue.data)}`;
    if (this.said.has(key)) return;
    this.said.add(key);
    const place = index === null ? { block: null, line: null } : { block: this.numbers[index] ?? 0, line: (this.lines[index] ?? 1) + within };
    this.findings.push({ issue, ...place, operation });
  }

  notSimulated(what: string, index: number, severity: "info" | "warning" = "info"): void {
    this.say(programIssue("notSimulated", severity, { what }), index);
  }

  /** Notes a finding where it is met first, and nowhere else. */
  sayOnce(issue: Issue | ProgramIssue, index: number): void {
    const key = `once ${issue.code} ${issue.at ?? ""}`;
    if (this.said.has(key)) return;
    this.said.add(key);
    this.say(issue, index);
  }

  /** Notes that from here on nothing is proved, once for each block. `what` as the program spells it. */
  leaveUnproved(what: string, index: number): void {
    const block = this.numbers[index] ?? 0;
    const key = `${block} ${what}`;
    if (this.left.has(key)) return;
    this.left.add(key);
    // The first of all says from where on nothing is proved; a list of all that follow would fill the memory.
    if (this.unproved.length < MOST_ALIKE) this.unproved.push({ step: this.steps.length, block, what });
    this.say(programIssue("notProved", "warning", { what }), index);
  }

  /** The number of a value, or null with an issue at the block. */
  number(value: Value, index: number): number | null {
    return this.settle(valueOf(value, this.parameters), index);
  }

  assign(s: Extract<Statement, { kind: "assign" }>, index: number): void {
    const result = formulaOf(s.formula, this.parameters);
    const passedOn = typeof result !== "number" && result.kind === "unset" ? this.known.reasonOf(result.name) : null;
    const n = passedOn ? null : this.settle(result, index);
    if (n === null) this.known.forget(s.target, passedOn ?? "told");
    else this.known.set(s.target, n);
  }

  /** Something else has moved the machine: no position is known. */
  loseAll(): void {
    this.at = this.mill.at = NOWHERE;
    this.sure = { x: false, z: false };
    this.mill.here = null;
    this.last = null;
    this.lost = "unproved";
  }

  /** A preset takes the datum back; another one than before moves the workpiece against what was cut already. */
  usePreset(n: number | null, what: string, index: number): void {
    this.datum = NO_SHIFT;
    if (n === null || (this.preset !== null && this.preset !== n)) this.leaveUnproved(what, index);
    this.preset = n;
  }

  private settle(result: number | Trouble, index: number): number | null {
    if (typeof result === "number") return result;
    const unknown = result.kind === "unset" ? this.known.reasonOf(result.name) : null;
    this.known.trouble = unknown ?? "told";
    if (unknown === "told") return null;
    if (result.kind === "unset" && unknown) this.leaveUnproved(result.name, index);
    else if (result.kind === "unset") this.sayOnce(programIssue("parameterUnset", "error", { name: result.name }, result.name), index);
    else if (result.kind === "zero") this.say(programIssue("divisionByZero", "error", {}), index);
    else this.say(programIssue("notFinite", "error", { text: this.blocks[index]?.raw.trim().slice(0, 60) ?? "" }), index);
    return null;
  }

  /** A length of the program in mm. */
  length(n: number): number {
    return this.inch ? n * 25.4 : n;
  }

  /** A feed word as mm/rev or mm/min; inch programs count tenths of an inch per minute, or inches per revolution. */
  feedOf(n: number): Feed {
    return (this.inch ? n * (this.perRevolution ? 25.4 : 2.54) : n) as Feed;
  }

  get feedUnit(): FeedUnit {
    return this.perRevolution ? "mm/rev" : "mm/min";
  }

  /** The tip, when both coordinates are known. */
  get tip(): Pt | null {
    return pointIn("lathe", this.at);
  }

  /** Ends the run at a block, because the program goes beyond what is simulated: what follows is not proved. */
  stop(why: ProgramIssue, index: number): void {
    if (this.full) return;
    this.full = true;
    this.say(why, index);
    // An element that waits for a corner stands before the end and is still run.
    const step = this.steps.length + (this.held ? 1 : 0);
    this.unproved.push({ step, block: this.numbers[index] ?? 0, what: this.blocks[index]?.raw.trim().split(/[\r\n]/)[0]?.slice(0, 60) ?? "" });
  }

  /** Whether one more block may be executed or read as a contour; ends the run when not. */
  roomForBlock(index: number): boolean {
    this.executed += 1;
    if (this.executed > MOST_BLOCKS) this.stop(programIssue("tooManyBlocks", "error", { limit: MOST_BLOCKS }), index);
    return !this.full;
  }

  /** Whether a cycle may be called once more; ends the run when not. */
  roomForOperation(index: number): boolean {
    if (this.operations.length >= MOST_OPERATIONS) this.stop(programIssue("tooManyOperations", "error", { limit: MOST_OPERATIONS }), index);
    return !this.full;
  }

  /** Whether turning and milling together may move once more; ends the run when not. */
  roomForMove(index: number): boolean {
    if (this.steps.length + this.mill.steps.length < MOST_MOVES) return true;
    this.stop(programIssue("tooManyMoves", "error", { limit: MOST_MOVES }), index);
    return false;
  }

  /** Adds one motion of the current tool, or of that tool as a cycle adapts it. */
  step(from: Pt, move: Move, index: number, operation: number | null, adapted: Tool | null = this.tool): number {
    if (!this.roomForMove(index)) return 0;
    if (!adapted) return 0;
    const spindle = this.spindle ?? { kind: "constant" as const, speed: 0 };
    const seconds = secondsOf(from, move, spindle, this.shop.rapid);
    this.steps.push({ from, move, tool: adapted, block: this.numbers[index] ?? 0, operation, seconds });
    this.stepBlocks.push(index);
    return seconds;
  }

  /** All findings in the order of the text, those of the reader included. */
  allFindings(): Finding[] {
    const missing = new Set(this.findings.filter((f) => f.issue.code === "missing").map((f) => f.line));
    const order = (a: Finding, b: Finding) => (a.line ?? 0) - (b.line ?? 0);
    return [...fewAlike(this.read(missing)), ...fewAlike(this.findings.sort(order))].sort(order);
  }

  /** What the reader found, less what is also said as a missing parameter. */
  private *read(missing: ReadonlySet<number | null>): Generator<Finding> {
    for (const i of eachIssue(this.program)) if (!(i.code === "wordMissing" && missing.has(i.line))) yield this.located(i);
  }

  private located(issue: NcIssue): Finding {
    let [low, high] = [0, this.lines.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((this.lines[middle] ?? 0) <= issue.line) low = middle;
      else high = middle - 1;
    }
    return { issue, block: this.numbers[low] ?? null, line: issue.line, operation: null };
  }
}
