import type { FeedUnit, Move } from "../../kernel/plan/move.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import { INCH, type Feed } from "../../kernel/units.ts";
import type { Block, Program } from "../../nc/program.ts";
import type { Statement, StatementOf } from "../../nc/statement.ts";
import type { Label, Value } from "../../nc/words.ts";
import { valueOf, type Parameters, type Trouble } from "../values/formula.ts";
import { MOST_BLOCKS, MOST_MOVES, MOST_OPERATIONS, MOST_TURNED } from "../values/bounds.ts";
import { programIssue, type ProgramIssue } from "./issue.ts";
import type { FreeRun } from "./free-contour.ts";
import { KnownValues } from "../values/known-values.ts";
import { MachineClock } from "./machine-clock.ts";
import { Log } from "./log.ts";
import { intents } from "./meant-cuts.ts";
import { AT_START, NOT_PLACED, type Milling, type Modal, type Whereabouts } from "./modal.ts";
import { pointIn } from "./path.ts";
import type { Guide } from "./plane-chain.ts";
import { fileKey } from "./program-files.ts";
import type { RunMoment } from "./run-moment.ts";
import type { Shop } from "./shop.ts";
import { speedFaults } from "./speed-limits.ts";
import { demands, type GivenForStep } from "./spindle-state.ts";
import { stepOf, timed, type TimedSteps } from "./step-of.ts";
import type { TracedBlank } from "./tracing.ts";
import { isSkipped, unitFrom, type Unit } from "./units.ts";

/** A program as it runs: what is in force, what was said and done, and the bounds that end a run. */
export class Machine {
  /** The blocks of the program, and behind them those of the programs that it has called. */
  blocks: readonly Block[];
  readonly log: Log;
  /** The text that runs. */
  unit: Unit;
  readonly units = new Map<Program, Unit>();
  /** The program that the block that runs has called: it runs next. */
  next: Unit | null = null;
  /** Radii of TOOL DEF lines, mm. */
  readonly radii: Map<Label, number>;
  readonly parameters: Parameters;
  readonly known: KnownValues;
  /** What is in force; a block that changes it puts a new one in its place. */
  now: Modal = AT_START;
  /** Where the tool stands; a move puts a new place in its place. */
  place: Whereabouts = NOT_PLACED;
  /** Blocks of definitions that were taken up, and of those that were called. */
  readonly definitions: Set<number>;
  readonly called: Set<number>;
  /**
   * How many blocks had been executed when a block was first run, or read as part of a contour; 0 for one that was not.
   */
  readonly visited: Uint32Array;
  /** The same for a block that was looked at from another one before it. */
  readonly foreseen: Uint32Array;
  /** What the machine makes of rapids and speeds. */
  readonly clock: MachineClock;
  /** The contours that turning and milling are gathering. */
  readonly turnGuide: Guide = { chain: null, here: null };
  readonly millGuide: Guide = { chain: null, here: null };
  /** The blank that is traced, and the first step that has not cut it yet. */
  traced: { readonly blank: TracedBlank; next: number } | null = null;
  /** True once any has been. */
  hasTraced = false;
  /** The free contour that is being run. */
  freeRun: FreeRun | null = null;
  /** FPOL that counts until another does. */
  freePole: StatementOf<"free"> | null = null;
  private readonly intentOf = intents();
  /** Blocks executed, those of contours that cycles read included. */
  executed = 0;
  full = false;

  /** `before`: a run of a program with the same blocks up to a moment, and that moment, from which this one goes on. */
  constructor(
    readonly program: Program,
    readonly shop: Shop,
    before?: { readonly machine: Machine; readonly at: RunMoment },
  ) {
    const { machine, at } = before ?? {};
    this.clock = machine?.clock ?? new MachineClock(shop);
    this.blocks = program.blocks;
    this.log = new Log(program, machine && at && { log: machine.log, at: at.log });
    this.parameters = new Map(at?.parameters);
    this.known = new KnownValues(this.parameters, at?.known);
    this.radii = new Map(at?.radii);
    this.definitions = new Set(at?.definitions);
    this.called = new Set(at?.called);
    const upTo = (counts?: Uint32Array) => counts?.map((count) => (count <= (at?.executed ?? 0) ? count : 0));
    this.visited = upTo(machine?.visited) ?? new Uint32Array(this.blocks.length);
    this.foreseen = upTo(machine?.foreseen) ?? new Uint32Array(this.blocks.length);
    this.unit = this.takeUp(program, null, 0);
    if (!at) return;
    ({ now: this.now, place: this.place, freePole: this.freePole, executed: this.executed } = at);
    [this.turnGuide.here, this.millGuide.here] = at.here;
  }

  /** A block is run, or read as part of a contour. */
  visit(index: number): void {
    if (this.visited[index] === 0) this.visited[index] = this.executed;
  }

  /** The statement of a block that does not run yet, for one that hangs on what comes. */
  foresee(index: number): Statement | undefined {
    if (this.foreseen[index] === 0) this.foreseen[index] = this.executed;
    return this.blocks[index]?.statement;
  }

  private takeUp(program: Program, file: string | null, from: number): Unit {
    const unit = unitFrom(program, { file, from, skipMarked: this.shop.skipMarked ?? false }, (label, index) =>
      this.log.say(programIssue("labelTwice", "error", { label: String(label) }), index),
    );
    this.units.set(program, unit);
    return unit;
  }

  get labels(): ReadonlyMap<Label, number> {
    return this.unit.labels;
  }

  /** The text of a file beside the program, for a block that names it; null when it was not opened with it. */
  unitOfFile(name: string, index: number): Unit | null {
    const found = this.shop.files?.find(fileKey(name));
    if (!found) return null;
    const known = this.units.get(found.program);
    const from = known?.from ?? this.blocks.length;
    if (!known) {
      this.blocks = [...this.blocks, ...found.program.blocks];
      this.log.append(found, from);
    }
    this.log.calledBy(index, from);
    return known ?? this.takeUp(found.program, found.name, from);
  }

  /** True when a block is left out because of its skip mark. */
  isSkipped(index: number): boolean {
    return isSkipped(this.blocks[index], this.shop.skipMarked ?? false);
  }

  /** The text of a QS parameter, or null with an issue at the block. */
  text(name: string, index: number): string | null {
    const held = this.known.texts.get(name);
    if (held !== undefined) return held;
    this.settle({ kind: "unset", name }, index);
    return null;
  }

  /** Changes what is in force. Most blocks leave most of it as it is, and a long program has many blocks. */
  set(change: Partial<Modal>): void {
    const names = Object.keys(change) as (keyof Modal)[];
    if (names.some((name) => change[name] !== this.now[name])) this.now = { ...this.now, ...change };
  }

  /** Changes where the tool stands. */
  setPlace(change: Partial<Whereabouts>): void {
    this.place = { ...this.place, ...change };
  }

  /** Changes what is in force for a mill. */
  setMill(change: Partial<Milling>): void {
    this.set({ mill: { ...this.now.mill, ...change } });
  }

  /** The number of a value, or null with an issue at the block. */
  number(value: Value, index: number): number | null {
    return this.settle(valueOf(value, this.parameters), index);
  }

  /** Something else has moved the machine: no position is known. */
  loseAll(): void {
    this.endBrought();
    this.setPlace({ ...NOT_PLACED, lost: "unproved", held: this.place.held, milled: this.place.milled });
    this.millGuide.here = null;
  }

  /** A number that was worked out, or null with an issue at the block. */
  settle(result: number | Trouble, index: number): number | null {
    if (typeof result === "number") return result;
    const unknown = result.kind === "unset" ? this.known.reasonOf(result.name) : null;
    this.known.trouble = unknown ?? "told";
    if (unknown === "told") return null;
    if (result.kind === "unset" && unknown) this.log.leaveUnproved(result.name, index);
    else if (result.kind === "unset")
      this.log.sayOnce(programIssue("parameterUnset", "error", { name: result.name }, result.name), index);
    else if (result.kind === "zero") this.log.say(programIssue("divisionByZero", "error", {}), index);
    else
      this.log.say(
        programIssue("notFinite", "error", { text: this.blocks[index]?.raw.trim().slice(0, 60) ?? "" }),
        index,
      );
    return null;
  }

  /** A length of the program in mm. */
  length(n: number): number {
    return this.now.inch ? n * INCH : n;
  }

  /** A feed word as mm/rev or mm/min; inch programs count tenths of an inch per minute, or inches per revolution. */
  feedOf(n: number): Feed {
    return (this.now.inch ? n * (this.now.perRevolution ? INCH : INCH / 10) : n) as Feed;
  }

  /** The spindle as it turns: as programmed, and no faster than the machine lets it. */
  get spindle(): Spindle | null {
    return this.clock.limited(this.now.spindle);
  }

  get feedUnit(): FeedUnit {
    return this.now.perRevolution ? "mm/rev" : "mm/min";
  }

  /** The tip, when both coordinates are known. */
  get tip(): Pt | null {
    return pointIn("lathe", this.place.at);
  }

  /** Ends the run at a block, because the program goes beyond what is simulated: what follows is not proved. */
  stop(why: ProgramIssue, index: number): void {
    if (this.full) return;
    this.full = true;
    this.log.say(why, index);
    // An element that waits for a corner stands before the end and is still run.
    const step = this.log.steps.length + (this.place.held ? 1 : 0);
    this.log.unproved.push({
      step,
      block: this.log.numbers[index] ?? 0,
      what:
        this.blocks[index]?.raw
          .trim()
          .split(/[\r\n]/)[0]
          ?.slice(0, 60) ?? "",
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

  /** How many moves a tool may still turn. */
  get room(): number {
    const turned = this.log.steps.length;
    return Math.min(MOST_TURNED, MOST_MOVES - this.log.milled.length) - turned;
  }

  /** Whether turning and milling together may move once more; ends the run when not. */
  roomForMove(index: number): boolean {
    if (this.room > 0) return true;
    const limit = this.log.steps.length < MOST_TURNED ? MOST_MOVES : MOST_TURNED;
    this.stop(programIssue("tooManyMoves", "error", { limit }), index);
    return false;
  }

  /** A tool that was brought somewhere and does not go on from there is judged where it stands. */
  endBrought(): void {
    const { brought, sure } = this.place;
    if (brought === null) return;
    const at = sure.x && sure.z ? this.tip : null;
    if (at) this.step(at, { kind: "rapid", to: at, phase: "position", run: "rough", step: 0 }, brought);
    this.setPlace({ brought: null });
  }

  /** Adds one motion of the current tool outside the operations; `hole` is one that has to be there for it. */
  step(from: Pt, move: Move, index: number, given: GivenForStep = {}): void {
    const { tool } = this.now;
    if (!this.roomForMove(index) || !tool) return;
    const intent = move.kind === "rapid" ? {} : this.intentOf(this.blocks, index, given.isCompensated ?? false);
    const asks = move.kind === "rapid" ? {} : demands(this.now, this.log, tool, given.hole ?? null);
    const motion = {
      from,
      move,
      tool,
      block: this.log.numbers[index] ?? 0,
      operation: null,
      ...intent,
      ...this.log.lineOf(index),
      ...asks,
    };
    this.take(timed([stepOf(motion, this.spindle, this.clock.rapid)]), index);
  }

  /**
   * Adds motions of the tool, for which there is room, and what they take: the first of them goes on from where it was
   * brought.
   */
  take({ steps, seconds }: TimedSteps, index: number): void {
    const [first] = steps;
    if (!first) return;
    this.log.seconds += seconds;
    this.log.countsFrom(this.now.datum.x, this.now.datum.z);
    this.log.turnsAt(this.spindle, this.now.backwards);
    const runUp = this.clock.runUp(this.now, first.from.r);
    if (runUp) {
      this.log.takes("spindle", runUp.seconds);
      this.set({ runsAs: runUp.runsAs });
    }
    for (const fault of speedFaults(this.now, steps, this.shop.machine?.spindle?.most))
      this.log.say(fault, this.now.spunBy ?? index);
    const { brought, home } = this.place;
    if (home && steps.some(({ move }) => move.kind !== "rapid")) {
      this.log.leaveUnproved(home.what, home.index);
      this.setPlace({ home: null });
    }
    const block = this.log.inProgram(index);
    for (const step of steps) {
      this.log.steps.push(
        step === first && brought !== null ? { ...first, broughtBy: this.log.numbers[brought] ?? 0 } : step,
      );
      this.log.stepBlocks.push(block);
    }
    if (brought !== null) this.setPlace({ brought: null });
  }
}
