import { noseRadius, tipOffset } from "../../kernel/cutter/insert.ts";
import { partPoint, partSegment, planePoint, planeSegment } from "../../kernel/plane/plane.ts";
import { part } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Statement } from "../../nc/statement.ts";
import type { Words } from "../../nc/words.ts";
import type { TipOrientation } from "../../kernel/plan/tool.ts";
import type { Side } from "../../kernel/plane/plane.ts";
import { isPolar } from "./approach-fields.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import { blockFeed, takeFeed } from "../state/block-feed.ts";
import { offCentre } from "./off-centre.ts";
import { noTool } from "../state/preconditions.ts";
import { isDrillType } from "../tools/tool-columns.ts";
import { elementBetween, flushPendingElement, moveOf, standAt, targetOf } from "./path-block.ts";
import { coordinatesIn, type PathBlock } from "../state/path.ts";
import type { Carrier } from "./carrier.ts";
import { beginApproach, close, endWithDeparture, followPath, sideOf, type CarrierFor } from "./plane-guide.ts";

/**
 * Carrier of a turning tool: compensated by its nose radius, or as programmed; the program moves the theoretical tip.
 */
const carrierOf =
  (machine: Machine): CarrierFor =>
  (side): Carrier => {
    const { tool } = machine.now;
    const tip = side === "none" || !tool ? { u: 0, v: 0 } : tipOffset(tool);
    return {
      machine,
      plane: "ZX",
      toolRadius: tool ? noseRadius(tool) : 0,
      tip: { x: tip.u, y: tip.v },
      top: null,
      emit: (s, { feed, index }) => {
        const path = partSegment(s);
        const isCompensated = side !== "none" && feed !== null;
        if (part.lengthOf(path) > SAME) machine.step(path.from, moveOf(machine, path, feed), index, { isCompensated });
      },
      arrive: () => undefined,
      note: (run) => machine.log.note("approaches", run),
    };
  };

/** Runs the pending contour between RL or RR and its end. */
export const closeTurn = (machine: Machine): void => {
  if (machine.turnGuide.chain) close(machine.turnGuide, carrierOf(machine));
};

/** True when a path block belongs to a compensated contour. */
export const isGuided = (machine: Machine, words: Words): boolean =>
  machine.now.tool !== null &&
  (machine.turnGuide.chain !== null || words.compensation === "RL" || words.compensation === "RR");

/** Tip orientations along one axis, with the insert on neither side. */
const NEUTRAL: ReadonlySet<TipOrientation> = new Set([2, 4, 6, 8]);

/**
 * Reports RL or RR with a neutral tip: its direction is printed as unclear (TNC7, 81762x-17, tool radius compensation
 * of turning tools). Cycles compensate on their own and are not concerned.
 */
function sayNeutralTip(machine: Machine, side: Side, index: number): void {
  const { tool } = machine.now;
  if (side === "none" || !tool || isDrillType(tool.TYPE) || !NEUTRAL.has(tool.TO)) return;
  const word = side === "left" ? "RL" : "RR";
  machine.log.report(
    programIssue("compensationUndefined", "warning", { side: word, orientation: tool.TO }, "tool"),
    index,
  );
}

/** Starts a contour at the tip, unless one is under way. */
function start(machine: Machine): void {
  if (machine.turnGuide.chain) return;
  flushPendingElement(machine);
  const tip = machine.place.sure.x && machine.place.sure.z ? machine.tip : null;
  machine.turnGuide.here = tip && planePoint(tip);
}

/** A path block from RL or RR on, up to and with the R0 that ends it. */
export function guidedPath(machine: Machine, block: PathBlock, index: number): void {
  const { words } = block;
  start(machine);
  const { turnGuide: guide } = machine;
  const from = machine.place.sure.x && machine.place.sure.z ? machine.tip : null;
  const target = targetOf(machine, block, index);
  const requested = sideOf(words, guide.chain?.side ?? "none");
  if (!target && requested === (guide.chain?.side ?? "none")) {
    takeFeed(machine, words.feed, index);
    return;
  }
  const feed = target ? blockFeed(machine, words.feed, index) : machine.now.feed;
  if (feed !== null) offCentre(machine, index);
  standAt(machine, block, target ?? machine.place.at);
  const to = machine.tip;
  if (!to) return closeTurn(machine);
  if (requested !== (guide.chain?.side ?? "none")) sayNeutralTip(machine, requested, index);
  const path = from && elementBetween(machine, block, from, to, index);
  if (!path) machine.setPlace({ last: null });
  followPath(guide, carrierOf(machine), requested, {
    fromZ: null,
    toZ: null,
    feed,
    index,
    segment: path && planeSegment(path),
    to: planePoint(to),
  });
  if (requested === "none" && words.compensation !== undefined) closeTurn(machine);
}

/** Reports a block with an unknown start, unless a reported block lost the position. */
export function startUnknown(machine: Machine, index: number): void {
  if (machine.place.lostReason === null) machine.log.report(programIssue("startUnknown", "error", {}), index);
}

/** APPR and DEP in the Z/X plane. */
export function turnApproach(machine: Machine, s: Extract<Statement, { kind: "approach" }>, index: number): void {
  if (!machine.now.tool) return noTool(machine, index);
  start(machine);
  const { departing, form, words } = s;
  if (!departing) sayNeutralTip(machine, sideOf(words, "none"), index);
  const isEnd = !departing || form === "LCT" || form === "PLCT";
  const path: PathBlock = { path: isPolar(form) ? "LP" : "L", words };
  const to = isEnd ? targetOf(machine, path, index) : machine.place.at;
  if (isPolar(form) && !to) return;
  if (!departing) standAt(machine, path, to ?? machine.place.at);
  else if (to) machine.setPlace({ at: to });
  const tip = machine.tip;
  if (isEnd && !tip) return startUnknown(machine, index);
  const block = {
    departing,
    form,
    words,
    index,
    target: isEnd && tip ? planePoint(tip) : null,
    fromZ: null,
    toZ: null,
  };
  if (departing) endWithDeparture(machine.turnGuide, carrierOf(machine), block);
  else beginApproach(machine.turnGuide, carrierOf(machine), block);
  const { here } = machine.turnGuide;
  if (departing && here) machine.setPlace({ at: { ...machine.place.at, ...coordinatesIn("lathe", partPoint(here)) } });
  machine.setPlace({ last: null });
}
