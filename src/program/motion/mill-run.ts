import { partPoint, planeSegment, type PlanePoint, type PlaneSegment, type Side } from "../../kernel/plane/plane.ts";
import type { Statement } from "../../nc/statement.ts";
import { isPolar } from "./approach-fields.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import { blockFeed, takeFeed } from "../state/block-feed.ts";
import { millSideArc, planeOf, type SideBlock } from "./mill-arc.ts";
import { centreOf, millArrives, millCarrier, type SidePlane } from "./mill-moves.ts";
import { millApproachWords, millBlock } from "./mill-frame.ts";
import { standing, wordReader } from "./path-block.ts";
import type { ToolPosition } from "../state/modal.ts";
import { endOf, isPolarPath, segmentOf, type MillPlane, type PathBlock } from "../state/path.ts";
import { startUnknown } from "./turn-run.ts";
import { beginApproach, close, endWithDeparture, followPath, sideOf } from "./plane-guide.ts";
import { ROUND } from "../../kernel/tolerance.ts";

const carrierOf = (machine: Machine) => () => millCarrier(machine);

/** Runs the pending contour; called before anything that does not belong to it. */
export const closeMill = (machine: Machine): void => close(machine.millGuide, carrierOf(machine));

/** Plane of the words of a block: LP stays in the plane of its pole. */
const planeOfWords = (machine: Machine, block: PathBlock): MillPlane =>
  block.path === "LP" ? (machine.now.pole?.plane ?? "XY") : planeOf(machine, block);

/** One path block: L, C, CR, CT and the polar forms. */
export function millPath(machine: Machine, written: PathBlock, index: number): void {
  const block = millBlock(machine, written, planeOfWords(machine, written), index);
  const {
    place: { mill: before },
    millGuide: guide,
  } = machine;
  const { words } = block;
  const requested = sideOf(words, guide.chain?.side ?? "none");
  const to = endOf(wordReader(machine, index), block, standing(machine, planeOfWords(machine, block)));
  const isMoving = isPolarPath(block.path) || words.axes.length > 0;
  if (!to || (!isMoving && words.compensation === undefined)) return takeFeed(machine, words.feed, index);
  if (words.compensation !== undefined) needsRadius(machine, requested, index);
  const [start, end] = [centreOf(before), centreOf(to)];
  machine.setPlace(end && to.z !== null ? { mill: to, lostReason: null } : { mill: to });
  if (!end) {
    closeMill(machine);
    guide.here = null;
    return takeFeed(machine, words.feed, index);
  }
  const feed = isMoving ? blockFeed(machine, words.feed, index) : machine.now.feed;
  const [fromZ, toZ] = [before.z ?? to.z, to.z];
  if (!start && requested === "none") {
    closeMill(machine);
    millArrives(machine, end, { fromZ, toZ, feed, index });
    guide.here = end;
    machine.setPlace({ last: null });
    return;
  }
  const plane = planeOf(machine, block);
  if (plane !== "XY" && start) return sideArc(machine, plane, { block, before, to, feed, index, requested });
  const milled = { from: before, to, plane: "XY" } as const;
  if (!start) machine.setPlace({ milled: { ...milled, segment: null } });
  const segment = start && elementBetween(machine, block, { start, end, milled }, index);
  if (segment?.kind !== "arc")
    return followPath(guide, carrierOf(machine), requested, { fromZ, toZ, feed, index, segment, to: end });
  const pieces = around(machine, block, segment, index);
  const z = (k: number) => (fromZ === null || toZ === null ? toZ : fromZ + ((toZ - fromZ) * k) / pieces.length);
  pieces.forEach((piece, i) =>
    followPath(guide, carrierOf(machine), requested, {
      fromZ: z(i),
      toZ: z(i + 1),
      feed,
      index,
      segment: piece,
      to: piece.to,
    }),
  );
}

/**
 * An arc in a plane that contains the tool axis. The pending path is finished first: compensation does not apply here.
 */
function sideArc(machine: Machine, plane: SidePlane, side: SideBlock & { readonly requested: Side }): void {
  const { requested, index, to } = side;
  closeMill(machine);
  if (requested !== "none") machine.log.leaveUnproved(side.block.path, index);
  millSideArc(machine, plane, side);
  machine.millGuide.here = centreOf(to);
}

/** Start and end of a milling block, as points of the plane and as positions. */
interface Between {
  readonly start: PlanePoint;
  readonly end: PlanePoint;
  readonly milled: Pick<NonNullable<ToolPosition["milled"]>, "from" | "to" | "plane">;
}

function elementBetween(
  machine: Machine,
  block: PathBlock,
  { start, end, milled }: Between,
  index: number,
): PlaneSegment {
  const { pole } = standing(machine, "XY");
  const made = segmentOf(wordReader(machine, index), block, {
    from: partPoint(start),
    to: partPoint(end),
    pole,
    before: machine.place.last,
  });
  const { from, to, plane } = milled;
  machine.setPlace({ last: made, milled: { from, to, plane, segment: made.kind === "arc" ? made : null } });
  return planeSegment(made);
}

/** CP with more than one turn: whole circles first. */
function around(machine: Machine, { path, words }: PathBlock, s: PlaneSegment, index: number): PlaneSegment[] {
  const angle = path === "CP" && words.polarAngle?.incremental ? machine.number(words.polarAngle.value, index) : null;
  if (s.kind !== "arc" || angle === null || Math.abs(angle) <= 360) return [s];
  const turns = Math.min(1000, Math.ceil(Math.abs(angle) / 360 - ROUND) - 1);
  return [...Array.from({ length: turns }, (): PlaneSegment => ({ ...s, to: s.from })), s];
}

function needsRadius(machine: Machine, side: Side, index: number): void {
  if (side !== "none" && machine.now.mill.radius === null)
    machine.log.report(programIssue("toolRadiusUnknown", "warning", { tool: machine.now.mill.tool }), index);
}

/** APPR and DEP. */
export function millApproach(machine: Machine, s: Extract<Statement, { kind: "approach" }>, index: number): void {
  const {
    place: { mill },
    millGuide: guide,
  } = machine;
  const { departing, form } = s;
  const words = millApproachWords(machine, s.words, form, index);
  const path: PathBlock = { path: isPolar(form) ? "LP" : "L", words };
  const fromZ = mill.z;
  const to = endOf(wordReader(machine, index), path, standing(machine, "XY"));
  if (!to) return;
  needsRadius(machine, departing ? "none" : sideOf(words, "none"), index);
  const isEnd = !departing || form === "LCT" || form === "PLCT";
  const target = isEnd ? centreOf(to) : null;
  if (isEnd && !target) return startUnknown(machine, index);
  const block = { departing, form, words, index, target, fromZ: fromZ ?? to.z, toZ: to.z };
  if (departing) endWithDeparture(guide, carrierOf(machine), block);
  else {
    beginApproach(guide, carrierOf(machine), block);
    machine.set({ compensation: s.words.compensation ?? "R0" });
  }
  const end = departing ? guide.here : target;
  machine.setPlace({ mill: { x: end?.x ?? mill.x, y: end?.y ?? mill.y, z: to.z }, last: null });
}
