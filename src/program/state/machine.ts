import type { FeedUnit, Move } from "../../kernel/plan/move.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import type { Spindle, Step } from "../../kernel/time/step.ts";
import { INCH, inchFeedUnit, type Feed } from "../../kernel/units.ts";
import type { Statement } from "../../nc/statement.ts";
import type { Label, Value } from "../../nc/words.ts";
import { valueOf, type EvaluationError } from "../values/formula.ts";
import {
  LEAST_NUMBER,
  MOST_BLOCKS,
  MOST_MOVES,
  MOST_NUMBER,
  MOST_OPERATIONS,
  MOST_REPEATED,
  MOST_TURNED,
} from "../values/bounds.ts";
import { programIssue, type ProgramIssue } from "./issue.ts";
import type { Mutable } from "../values/persistent.ts";
import { ParameterStore } from "../values/known-values.ts";
import type { MachineClock } from "./machine-clock.ts";
import { Log } from "./log.ts";
import { intentOf, cutIntentAt } from "./intended-cuts.ts";
import { NOT_PLACED, type Milling, type Modal, type ToolPosition } from "./modal.ts";
import { pointIn, type Position } from "./path.ts";
import type { Guide } from "./plane-chain.ts";
import { fileKey } from "./program-files.ts";
import type { RunInput } from "./run-input.ts";
import { startOf, type Flow, type RunState } from "./run-state.ts";
import type { Shop } from "./shop.ts";
import { speedFaults } from "./speed-limits.ts";
import { demands, type GivenForStep } from "./spindle-state.ts";
import { stepOf, timed, type TimedSteps } from "./step-of.ts";
import { isSkipped, unitFrom, type Unit } from "./units.ts";

/**
 * A run while blocks are executed: starts from a state; `state` is the current one. Its members are immutable values
 * that are replaced, so earlier states never change.
 */
export class Machine {
  readonly log: Log;
  readonly known: ParameterStore;
  /** Contours under construction, of turning and milling. */
  readonly turnGuide: Guide;
  readonly millGuide: Guide;

  private readonly draft: Mutable<RunState>;
  private stood: { readonly at: Position; readonly tip: Pt | null } | null = null;

  constructor(
    readonly input: RunInput,
    state: RunState = startOf(input),
  ) {
    this.draft = { ...state };
    this.log = new Log(input, state.log);
    this.known = new ParameterStore(state.known);
    this.turnGuide = { ...state.turnGuide };
    this.millGuide = { ...state.millGuide };
  }

  /** Snapshot of the current state. */
  get state(): RunState {
    const { draft, log, known, turnGuide, millGuide } = this;
    return {
      ...draft,
      log: log.state,
      known: known.state,
      turnGuide: { ...turnGuide },
      millGuide: { ...millGuide },
    };
  }

  /** Replaces members of the state. */
  change(change: Partial<Omit<RunState, "log" | "known" | "turnGuide" | "millGuide">>): void {
    Object.assign(this.draft, change);
  }

  /** The state without the parts held by log, parameters and guides. */
  get run(): Omit<RunState, "log" | "known" | "turnGuide" | "millGuide"> {
    return this.draft;
  }

  get shop(): Shop {
    return this.input.shop;
  }

  get clock(): MachineClock {
    return this.input.clock;
  }

  get blocks(): RunState["blocks"] {
    return this.draft.blocks;
  }

  get unit(): Unit {
    return this.draft.unit;
  }

  /** Modal state. */
  get now(): Modal {
    return this.draft.now;
  }

  /** Tool position. */
  get place(): ToolPosition {
    return this.draft.place;
  }

  get parameters(): ParameterStore["parameters"] {
    return this.known.parameters;
  }

  /** Records that a block is run, or read as part of a contour. */
  visit(index: number): void {
    const { visited } = this.input.firstReads;
    if (visited[index] === 0) visited[index] = this.draft.executed;
  }

  /** Statement of a later block, for a block that depends on what follows. */
  peek(index: number): Statement | undefined {
    const { lookedAhead } = this.input.firstReads;
    if (lookedAhead[index] === 0) lookedAhead[index] = this.draft.executed;
    return this.blocks[index]?.statement;
  }

  /** Records that a cycle definition was reached, or called. */
  markDefined(index: number): void {
    this.change({ definitions: this.draft.definitions.with(index) });
  }

  markCalled(index: number): void {
    this.change({ called: this.draft.called.with(index) });
  }

  /** The block of this index comes next. */
  goTo(next: number): void {
    this.draft.next = next;
  }

  /** Changes the flow: returns, repetitions, ending. */
  setFlow(change: Partial<Flow>): void {
    this.draft.flow = { ...this.draft.flow, ...change };
  }

  get labels(): ReadonlyMap<Label, number> {
    return this.unit.labels;
  }

  /** Unit of a file that a block names; null when it was not opened. */
  unitOfFile(name: string, index: number): Unit | null {
    const found = this.shop.files?.find(fileKey(name));
    if (!found) return null;
    const known = this.log.unitOf(found.program);
    const { name: file, program } = found;
    const unit =
      known ?? unitFrom(program, { file, from: this.blocks.length, skipMarked: this.shop.skipMarked ?? false });
    if (!known) {
      this.change({ blocks: [...this.blocks, ...program.blocks] });
      this.log.append(found, unit);
    }
    this.log.calledBy(index, unit);
    if (!known) this.log.reportDuplicateLabels(unit);
    return unit;
  }

  /** True when a block is left out because of its skip mark. */
  isSkipped(index: number): boolean {
    return isSkipped(this.blocks[index], this.shop.skipMarked ?? false);
  }

  /** The text of a QS parameter, or null with an issue at the block. */
  text(name: string, index: number): string | null {
    const held = this.known.texts.get(name);
    if (held !== undefined) return held;
    this.resolveNumber({ kind: "unset", name }, index);
    return null;
  }

  /** Changes the modal state. Most blocks leave most of it unchanged, and a long program has many blocks. */
  set(change: Partial<Modal>): void {
    const names = Object.keys(change) as (keyof Modal)[];
    if (names.some((name) => change[name] !== this.now[name])) this.draft.now = { ...this.now, ...change };
  }

  /** Changes the tool position. */
  setPlace(change: Partial<ToolPosition>): void {
    this.draft.place = { ...this.place, ...change };
  }

  /** Changes the modal state of milling. */
  setMill(change: Partial<Milling>): void {
    this.set({ mill: { ...this.now.mill, ...change } });
  }

  /** Number of a value, or null with an issue at the block. */
  number(value: Value, index: number): number | null {
    return this.resolveNumber(valueOf(value, this.parameters), index);
  }

  /** The machine moved in an unknown way: all positions are unknown. */
  losePosition(): void {
    this.closeArrival();
    this.setPlace({
      ...NOT_PLACED,
      lostReason: "unproved",
      pendingElement: this.place.pendingElement,
      milled: this.place.milled,
    });
    this.millGuide.here = null;
  }

  /** A computed number, or null with an issue at the block. */
  resolveNumber(result: number | EvaluationError, index: number): number | null {
    if (typeof result === "number" && Math.abs(result) <= MOST_NUMBER)
      return Math.abs(result) < LEAST_NUMBER && result !== 0 ? 0 : result;
    if (typeof result === "number") return this.resolveNumber({ kind: "notFinite" }, index);
    const unknown = result.kind === "unset" ? this.known.reasonOf(result.name) : null;
    this.known.lastUnknownReason = unknown ?? "told";
    if (unknown === "told") return null;
    if (result.kind === "unset" && unknown) this.log.leaveUnproved(result.name, index);
    else if (result.kind === "unset")
      this.log.reportOnce(programIssue("parameterUnset", "error", { name: result.name }, result.name), index);
    else if (result.kind === "zero") this.log.report(programIssue("divisionByZero", "error", {}), index);
    else
      this.log.report(
        programIssue("notFinite", "error", { text: this.blocks[index]?.raw.trim().slice(0, 60) ?? "" }),
        index,
      );
    return null;
  }

  /** A length of the program in mm. */
  length(n: number): number {
    return this.now.inch ? n * INCH : n;
  }

  /** A feed word as mm/rev or mm/min. */
  feedOf(n: number): Feed {
    return (this.now.inch ? n * inchFeedUnit(this.now.perRevolution) : n) as Feed;
  }

  /** The programmed spindle, limited to the machine's maximum speed. */
  get spindle(): Spindle | null {
    return this.clock.limited(this.now.spindle);
  }

  get feedUnit(): FeedUnit {
    return this.now.perRevolution ? "mm/rev" : "mm/min";
  }

  /** The tip, when both coordinates are known: one point at one position, so that moves share their ends. */
  get tip(): Pt | null {
    const { at } = this.place;
    if (this.stood?.at !== at) this.stood = { at, tip: pointIn("lathe", at) };
    return this.stood.tip;
  }

  /** Ends the run at a block, because the program exceeds a limit: the rest is unverified. */
  stop(why: ProgramIssue, index: number): void {
    if (this.draft.full) return;
    this.change({ full: true });
    this.log.report(why, index);
    // An element waiting for a corner precedes the end and is still run.
    const addStep = this.log.steps.length + (this.place.pendingElement ? 1 : 0);
    this.log.note("unproved", {
      step: addStep,
      block: this.log.numberOf(index) ?? 0,
      what:
        this.blocks[index]?.raw
          .trim()
          .split(/[\r\n]/)[0]
          ?.slice(0, 60) ?? "",
    });
  }

  /** Whether one more block may be executed or read as a contour; ends the run when not. */
  roomForBlock(index: number): boolean {
    const { draft } = this;
    draft.executed += 1;
    draft.farthest = Math.max(draft.farthest, index + 1);
    if (draft.executed > MOST_BLOCKS) this.stop(programIssue("tooManyBlocks", "error", { limit: MOST_BLOCKS }), index);
    else if (draft.executed > draft.farthest + MOST_REPEATED)
      this.stop(programIssue("tooManyRepeated", "error", { limit: MOST_REPEATED }), index);
    return !this.draft.full;
  }

  /** Whether a cycle may be called once more; ends the run when not. */
  roomForOperation(index: number): boolean {
    if (this.log.operations.length >= MOST_OPERATIONS)
      this.stop(programIssue("tooManyOperations", "error", { limit: MOST_OPERATIONS }), index);
    return !this.draft.full;
  }

  /** Turning moves left before the limit. */
  get room(): number {
    const turned = this.log.steps.length;
    return Math.min(MOST_TURNED, MOST_MOVES - this.log.milled.length) - turned;
  }

  /** Whether one more turning move fits the common limit; ends the run when not. */
  roomForMove(index: number): boolean {
    if (this.room > 0) return true;
    const limit = this.log.steps.length < MOST_TURNED ? MOST_MOVES : MOST_TURNED;
    this.stop(programIssue("tooManyMoves", "error", { limit }), index);
    return false;
  }

  /** A tool that arrived somewhere without moving on is checked at that position. */
  closeArrival(): void {
    const { positionedBy, sure } = this.place;
    if (positionedBy === null) return;
    const at = sure.x && sure.z ? this.tip : null;
    if (at) this.step(at, { kind: "rapid", to: at, phase: "position", run: "rough", step: 0 }, positionedBy);
    this.setPlace({ positionedBy: null });
  }

  /** Intent of a cut at a block. */
  private intentOf(index: number, isCompensated: boolean): Pick<Step, "intent"> {
    this.draft.cutIntent = cutIntentAt(this.blocks, index, this.draft.cutIntent);
    return intentOf(this.blocks, this.draft.cutIntent, isCompensated);
  }

  /** Adds one motion of the current tool outside the operations; `hole` is one that has to be there for it. */
  step(from: Pt, move: Move, index: number, given: GivenForStep = {}): void {
    const { tool } = this.now;
    if (!this.roomForMove(index) || !tool) return;
    const intent = move.kind === "rapid" ? {} : this.intentOf(index, given.isCompensated ?? false);
    const asks = move.kind === "rapid" ? {} : demands(this.now, this.log, tool, given.hole ?? null);
    const motion = {
      from,
      move,
      tool,
      block: this.log.numberOf(index) ?? 0,
      operation: null,
      ...intent,
      ...this.log.lineOf(index),
      ...asks,
    };
    this.addSteps(timed([stepOf(motion, this.spindle, this.clock.rapid)]), index);
  }

  /** Adds motions within the limit, and their time: the first one continues from where the tool arrived. */
  addSteps({ steps, seconds }: TimedSteps, index: number): void {
    const [first] = steps;
    if (!first) return;
    this.log.noteDatum(this.now.datum.x, this.now.datum.z);
    this.log.turnsAt(this.spindle, this.now.backwards);
    const runUp = this.clock.runUp(this.now, first.from.r);
    if (runUp) {
      this.log.addSeconds("spindle", runUp.seconds);
      this.set({ lastTurns: runUp.runsAs });
    }
    for (const fault of speedFaults(this.now, steps, this.shop.machine?.spindle?.most))
      this.log.report(fault, this.now.spinBlock ?? index);
    const { positionedBy, homedBy } = this.place;
    if (homedBy && steps.some(({ move }) => move.kind !== "rapid")) {
      this.log.leaveUnproved(homedBy.what, homedBy.index);
      this.setPlace({ homedBy: null });
    }
    const isBrought = positionedBy !== null ? { positionedBy: this.log.numberOf(positionedBy) ?? 0 } : null;
    this.log.move(isBrought ? [{ ...first, ...isBrought }, ...steps.slice(1)] : steps, seconds, index);
    if (positionedBy !== null) this.setPlace({ positionedBy: null });
  }
}
