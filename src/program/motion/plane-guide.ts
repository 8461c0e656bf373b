import { plane, planePoint, type PlanePoint, type PlaneSegment, type Side } from "../../kernel/plane/plane.ts";
import { ARC_END, SAME } from "../../kernel/tolerance.ts";
import type { ApproachForm, Compensation, Words } from "../../nc/words.ts";
import { shapeOf } from "./approach-fields.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import { blockFeed } from "../state/block-feed.ts";
import type { Carrier } from "./carrier.ts";
import {
  chainEnd,
  itemsOf,
  type ApproachCall,
  type ChainItem,
  type Guide,
  type OpenChain,
  type Travel,
} from "../state/plane-chain.ts";
import { pointIn } from "../state/path.ts";
import { breaksRule } from "../state/control-rule.ts";
import { wordOf } from "./path-block.ts";
import { finishChain } from "./plane-finish.ts";

const { apart, lengthOf } = plane;

const SIDES: Readonly<Record<Compensation, Side>> = { R0: "none", RL: "left", RR: "right" };
/** Side of a block; the active one when it names none. */
export const sideOf = (words: Words, now: Side): Side =>
  words.compensation === undefined ? now : SIDES[words.compensation];

/** A path block in the working plane: from the previous programmed point (null: unknown) to its own. */
export interface PathStep extends Travel {
  readonly segment: PlaneSegment | null;
  readonly to: PlanePoint;
}

/** Carrier for a side: compensated with the tool radius, or as programmed. */
export type CarrierFor = (side: Side) => Carrier;

/** A chain as programmed, before its first element. */
const UNCOMPENSATED_CHAIN: OpenChain = { side: "none", start: { kind: "here" }, lifts: [], end: null };

/** Runs the pending chain. */
export function close(guide: Guide, carrier: CarrierFor, departure: ApproachCall | null = null): void {
  const { chain } = guide;
  guide.chain = null;
  if (!chain) return;
  const { end, ...rest } = chain;
  guide.here = finishChain(carrier(chain.side), { ...rest, items: itemsOf(end) }, guide.here, departure);
}

/** A line from the actual end of the previous element, however small the gap to the programmed point. */
function joined(segment: PlaneSegment, before: PlaneSegment | undefined): PlaneSegment {
  if (!before || segment.kind !== "line" || apart(before.to, segment.from) > ARC_END) return segment;
  return { kind: "line", from: before.to, to: segment.to };
}

/** Longest compensated contour. The run ends beyond it: a truncated contour would be another part. */
const LONGEST = 20_000;
/** Most pending elements without compensation; only the last one has to wait for a corner. */
const WAITING = 1000;

/** Runs an uncompensated contour up to its last element, so that a long program is not held in memory. */
function advance(guide: Guide, carrier: CarrierFor): void {
  const { chain } = guide,
    end = chain?.end;
  if (!end?.before || end.count <= WAITING || chain?.side !== "none" || end.before.item.corner) return;
  guide.chain = { ...chain, end: end.before };
  close(guide, carrier);
  guide.chain = { ...UNCOMPENSATED_CHAIN, end: chainEnd(end.item, null) };
}

const NO_LIFTS: readonly Travel[] = [];

function append(machine: Machine, guide: Guide, step: PathStep, programmed: PlaneSegment): void {
  const { chain } = guide;
  if (!chain) return;
  const { end } = chain,
    last = end?.item;
  const segment = joined(programmed, last?.segment);
  const { fromZ, toZ, feed, index } = step;
  if (lengthOf(segment) > SAME) {
    guide.chain = { ...chain, end: chainEnd({ fromZ, toZ, feed, index, segment, lifts: NO_LIFTS }, end) };
    return;
  }
  if (last?.corner && fromZ === toZ) breaksRule(machine, "zeroBehindCorner", wordOf(last.corner.element), index);
  const travel: Travel = { fromZ, toZ, feed, index };
  guide.chain = end
    ? { ...chain, end: chainEnd({ ...end.item, lifts: [...end.item.lifts, travel] }, end.before) }
    : { ...chain, lifts: [...chain.lifts, travel] };
}

/** Adds a path block to the contour: begins one at RL or RR, ends one at R0. */
export function followPath(guide: Guide, carrier: CarrierFor, requested: Side, step: PathStep): void {
  const now = guide.chain?.side ?? "none";
  const { machine } = carrier(requested);
  if (now !== "none" && requested !== "none" && now !== requested)
    machine.log.report(programIssue("sideChanged", "error", {}), step.index);
  if (guide.chain && now !== requested) {
    close(guide, carrier);
    if (requested === "none") return uncompensated(machine, guide, step, guide.here);
  }
  if (requested === "none") {
    uncompensated(machine, guide, step, null);
    return advance(guide, carrier);
  }
  if (guide.chain) {
    if ((guide.chain.end?.count ?? 0) >= LONGEST)
      return machine.stop(programIssue("contourTooLong", "error", { limit: LONGEST }), step.index);
    append(machine, guide, step, step.segment ?? { kind: "line", from: step.to, to: step.to });
    return;
  }
  const arc = step.segment?.kind === "arc" ? step.segment : null;
  guide.chain = {
    side: requested,
    start: { ...step, kind: "line", to: arc ? arc.from : step.to, ...(arc && { toZ: step.fromZ }) },
    lifts: [],
    end: null,
  };
  if (arc) append(machine, guide, step, arc);
}

/** R0: as programmed. After RL or RR the tool leaves from its actual position. */
function uncompensated(machine: Machine, guide: Guide, step: PathStep, standing: PlanePoint | null): void {
  guide.chain ??= UNCOMPENSATED_CHAIN;
  append(
    machine,
    guide,
    step,
    standing
      ? { kind: "line", from: standing, to: step.to }
      : (step.segment ?? { kind: "line", from: step.to, to: step.to }),
  );
}

/** A rounding or chamfer behind the last element; false when there is none. */
export function addCorner(guide: Guide, corner: NonNullable<ChainItem["corner"]>): boolean {
  const { chain } = guide,
    end = chain?.end;
  if (!end || end.item.corner || end.item.lifts.length > 0) return false;
  guide.chain = { ...chain, end: chainEnd({ ...end.item, corner }, end.before) };
  return true;
}

/** LEN, R and CCA of an APPR or DEP block, in mm and degrees. */
function approachWords(machine: Machine, words: Words, index: number): ApproachCall["words"] {
  const read = (v: Words["length"]) => (v === undefined ? null : machine.number(v, index));
  const [length, radius, centreAngle] = [read(words.length), read(words.radius), read(words.centreAngle)];
  return {
    ...(length !== null && { length: machine.length(length) }),
    ...(radius !== null && { radius: machine.length(radius) }),
    ...(centreAngle !== null && { centreAngle }),
  };
}

/** Target and words of an APPR or DEP block. */
export interface WrittenApproach {
  readonly departing: boolean;
  readonly form: ApproachForm;
  readonly words: Words;
  readonly index: number;
  /** PA, or PN of DEP LCT; null without one. */
  readonly target: PlanePoint | null;
  readonly fromZ: number | null;
  readonly toZ: number | null;
}

function callOf(
  machine: Machine,
  b: WrittenApproach,
  feed: Travel["feed"],
  known: Travel["feed"] | undefined,
): ApproachCall {
  const { form, departing, index, target, fromZ, toZ } = b;
  const pole = machine.now.pole && pointIn(machine.now.turning ? "lathe" : "XY", machine.now.pole.at);
  return {
    form,
    shape: shapeOf(form),
    departing,
    index,
    target,
    fromZ,
    toZ,
    feed,
    words: approachWords(machine, b.words, index),
    pole: pole && planePoint(pole),
    before: known === undefined ? null : (known ?? "rapid"),
  };
}

/** Feed of the previous block: null is rapid; undefined when none is programmed. */
const feedBefore = (machine: Machine) =>
  machine.now.lastFeed === undefined ? (machine.now.feed ?? undefined) : machine.now.lastFeed;

/** Forms that run without a side and without a finding. */
const UNCOMPENSATED: ReadonlySet<ApproachCall["shape"]> = new Set(["LT", "LCT"]);

/** APPR: the contour begins; the approach is run when the first element is known. */
export function beginApproach(guide: Guide, carrier: CarrierFor, b: WrittenApproach): void {
  const side = sideOf(b.words, "none");
  const { machine } = carrier(side);
  const now = machine.now.compensation;
  if (now !== "R0") machine.log.report(programIssue("compensationActive", "error", { side: now }), b.index);
  machine.set({ compensation: b.words.compensation ?? "R0" });
  if (side === "none" && UNCOMPENSATED.has(shapeOf(b.form)))
    machine.log.report(programIssue("approachUncompensated", "warning", { form: `APPR ${b.form}` }), b.index);
  close(guide, carrier);
  const known = feedBefore(machine);
  if (known === undefined) machine.log.reportOnce(programIssue("feedMissing", "error", {}), b.index);
  if (!guide.here && machine.place.lostReason === null)
    machine.log.report(programIssue("startUnknown", "error", {}), b.index);
  const feed = blockFeed(machine, b.words.feed, b.index);
  const before = known === undefined ? feed : known;
  guide.chain = {
    side,
    start: { kind: "approach", call: callOf(machine, b, feed, known), before },
    lifts: [],
    end: null,
  };
}

/** DEP: the contour ends, and compensation with it. */
export function endWithDeparture(guide: Guide, carrier: CarrierFor, b: WrittenApproach): void {
  const { machine } = carrier("none");
  machine.set({ compensation: "R0" });
  const known = feedBefore(machine);
  const call = callOf(machine, b, blockFeed(machine, b.words.feed, b.index), known);
  guide.chain ??= UNCOMPENSATED_CHAIN;
  close(guide, carrier, call);
}
