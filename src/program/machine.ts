import type { Issue } from "../kernel/issue.ts";
import type { FeedUnit, Move } from "../kernel/move.ts";
import type { Pt, Ring, Segment } from "../kernel/point.ts";
import type { Spindle } from "../kernel/step.ts";
import { secondsOf } from "../kernel/time.ts";
import type { Tool } from "../kernel/tool.ts";
import type { Feed } from "../kernel/units.ts";
import type { Block, Program } from "../nc/program.ts";
import type { Compensation, Label, Statement, Value } from "../nc/statement.ts";
import { NO_SHIFT, type Datum } from "./datum.ts";
import { formulaOf, valueOf, type Parameters, type Trouble } from "./formula.ts";
import type { Held } from "./held.ts";
import { programIssue, type ProgramIssue } from "./issue.ts";
import { KnownValues, type UnknownReason } from "./known-values.ts";
import { Log } from "./log.ts";
import { MillState, type Mill } from "./mill-state.ts";
import { NOWHERE, pointIn, type Pole, type Position } from "./path.ts";
import type { Guide } from "./plane-chain.ts";
import type { Control } from "./plane-types.ts";
import { INCH } from "../kernel/units.ts";

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
  readonly log: Log;
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
  lost: UnknownReason | null = null;
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
  private preset: number | null = null;
  /** Blocks executed, those of contours that cycles read included. */
  private executed = 0;
  full = false;

  constructor(readonly program: Program, readonly shop: Shop) {
    this.blocks = program.blocks;
    this.log = new Log(program);
    this.visited = new Uint8Array(this.blocks.length);
    this.blocks.forEach((b, i) => {
      if (b.statement.kind !== "label" || b.statement.label === 0) return;
      const { label } = b.statement;
      if (this.labels.has(label)) this.log.say(programIssue("labelTwice", "error", { label: String(label) }), i);
      else this.labels.set(label, i);
    });
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
    if (n === null || (this.preset !== null && this.preset !== n)) this.log.leaveUnproved(what, index);
    this.preset = n;
  }

  private settle(result: number | Trouble, index: number): number | null {
    if (typeof result === "number") return result;
    const unknown = result.kind === "unset" ? this.known.reasonOf(result.name) : null;
    this.known.trouble = unknown ?? "told";
    if (unknown === "told") return null;
    if (result.kind === "unset" && unknown) this.log.leaveUnproved(result.name, index);
    else if (result.kind === "unset") this.log.sayOnce(programIssue("parameterUnset", "error", { name: result.name }, result.name), index);
    else if (result.kind === "zero") this.log.say(programIssue("divisionByZero", "error", {}), index);
    else this.log.say(programIssue("notFinite", "error", { text: this.blocks[index]?.raw.trim().slice(0, 60) ?? "" }), index);
    return null;
  }

  /** A length of the program in mm. */
  length(n: number): number {
    return this.inch ? n * INCH : n;
  }

  /** A feed word as mm/rev or mm/min; inch programs count tenths of an inch per minute, or inches per revolution. */
  feedOf(n: number): Feed {
    return (this.inch ? n * (this.perRevolution ? INCH : INCH / 10) : n) as Feed;
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
    this.log.say(why, index);
    // An element that waits for a corner stands before the end and is still run.
    const step = this.log.steps.length + (this.held ? 1 : 0);
    this.log.unproved.push({
      step,
      block: this.log.numbers[index] ?? 0,
      what: this.blocks[index]?.raw.trim().split(/[\r\n]/)[0]?.slice(0, 60) ?? "",
    });
  }

  /** Whether one more block may be executed or read as a contour; ends the run when not. */
  roomForBlock(index: number): boolean {
    this.executed += 1;
    if (this.executed > MOST_BLOCKS) this.stop(programIssue("tooManyBlocks", "error", { limit: MOST_BLOCKS }), index);
    return !this.full;
  }

  /** Whether a cycle may be called once more; ends the run when not. */
  roomForOperation(index: number): boolean {
    if (this.log.operations.length >= MOST_OPERATIONS)
      this.stop(programIssue("tooManyOperations", "error", { limit: MOST_OPERATIONS }), index);
    return !this.full;
  }

  /** Whether turning and milling together may move once more; ends the run when not. */
  roomForMove(index: number): boolean {
    if (this.log.steps.length + this.log.milled.length < MOST_MOVES) return true;
    this.stop(programIssue("tooManyMoves", "error", { limit: MOST_MOVES }), index);
    return false;
  }

  /** Adds one motion of the current tool, or of that tool as a cycle adapts it. */
  step(from: Pt, move: Move, index: number, operation: number | null, adapted: Tool | null = this.tool): number {
    if (!this.roomForMove(index)) return 0;
    if (!adapted) return 0;
    const spindle = this.spindle ?? { kind: "constant" as const, speed: 0 };
    const seconds = secondsOf(from, move, spindle, this.shop.rapid);
    this.log.steps.push({ from, move, tool: adapted, block: this.log.numbers[index] ?? 0, operation, seconds });
    this.log.stepBlocks.push(index);
    return seconds;
  }
}
