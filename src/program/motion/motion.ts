import { issue } from "../../kernel/plan/issue.ts";
import type { CornerElement } from "../../kernel/contour/corner.ts";
import type { StatementOf } from "../../nc/statement.ts";
import type { Value, Words } from "../../nc/words.ts";
import { isWholePoint, sideBegins } from "../state/control-rule.ts";
import type { Machine } from "../state/machine.ts";
import { machineCoordinateMove, isInMachineCoordinates } from "./machine-moves.ts";
import { cornerGrowth } from "./mill-frame.ts";
import { closeMill, millApproach, millPath } from "./mill-run.ts";
import { cornerBlock, flushPendingElement, pathBlock, pole } from "./path-block.ts";
import { addCorner } from "./plane-guide.ts";
import { closeTurn, guidedPath, isGuided, turnApproach } from "./turn-run.ts";

/** Runs all pending contours. */
export function finish(machine: Machine): void {
  flushPendingElement(machine);
  closeMill(machine);
  closeTurn(machine);
}

/** A mill whose tool axis is not Z moves in a plane that is not simulated. */
function hasOtherToolAxis(machine: Machine, what: string, index: number): boolean {
  const aside = !machine.now.turning && machine.now.mill.otherAxis;
  if (aside) machine.log.leaveUnproved(what, index);
  return aside;
}

/** L, C, CR, CT, CC, RND and the polar forms. */
export function path(machine: Machine, s: StatementOf<"path">, index: number): void {
  const { path: kind, words } = s;
  if (kind !== "CC" && kind !== "RND") sideBegins(machine, kind, words, index);
  if (words.compensation !== undefined) machine.set({ compensation: words.compensation });
  if (isInMachineCoordinates(words)) return machineCoordinateMove(machine, words, index);
  if (hasOtherToolAxis(machine, kind, index)) return;
  if (kind === "RND") return corner(machine, "round", words.radius ?? null, words, index);
  if (kind === "CC") return pole(machine, words, index);
  const isWhole = isWholePoint(kind, words, machine.now.turning);
  if (isWhole !== null) machine.setPlace({ isWhole });
  const block = { path: kind, words };
  if (!machine.now.turning) return millPath(machine, block, index);
  if (isGuided(machine, words)) return guidedPath(machine, block, index);
  pathBlock(machine, block, index);
}

/** CHF. */
export function chamfer(machine: Machine, s: StatementOf<"chamfer">, index: number): void {
  if (!hasOtherToolAxis(machine, "CHF", index)) corner(machine, "chamfer", s.length, s.words, index);
}

/** APPR and DEP. */
export function runApproach(machine: Machine, s: StatementOf<"approach">, index: number): void {
  machine.setPlace({ isWhole: null });
  if (machine.now.turning) return turnApproach(machine, s, index);
  if (!hasOtherToolAxis(machine, s.form, index)) millApproach(machine, s, index);
}

/** A rounding or chamfer behind the last element; its own feed counts for it alone. */
function corner(
  machine: Machine,
  kind: CornerElement["kind"],
  value: Value | null,
  { feed }: Words,
  index: number,
): void {
  const n = value === null ? null : machine.number(value, index);
  if (n === null) return;
  const growth = cornerGrowth(machine, kind === "round" ? "RND" : "CHF", index);
  if (growth === null) return;
  const element: CornerElement = { kind, size: machine.length(n) * growth };
  const guide = machine.now.turning ? machine.turnGuide : machine.millGuide;
  if (machine.now.turning && !guide.chain) return cornerBlock(machine, element, feed, index);
  const own = typeof feed === "object" ? machine.number(feed.value, index) : null;
  const end = guide.chain?.end;
  const added = end && addCorner(guide, { element, feed: own === null ? end.item.feed : machine.feedOf(own), index });
  if (!added)
    machine.log.report(
      issue("cornerElementAlone", "error", { element: Math.max(1, end?.count ?? 0) }, "contour"),
      index,
    );
}
