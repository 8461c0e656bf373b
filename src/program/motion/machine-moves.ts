import { boxAround } from "../../kernel/area/box.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { axial, radius } from "../../kernel/units.ts";
import type { Words } from "../../nc/words.ts";
import { functionFeed, takeFeed } from "../state/block-feed.ts";
import type { Machine } from "../state/machine.ts";
import { centreOf, millStep } from "./mill-moves.ts";
import { moveOf } from "./path-block.ts";
import { part } from "../../kernel/geometry/point.ts";

/** Machine coordinates: their relation to the workpiece is unknown. */
const MACHINE_COORDINATES: ReadonlySet<number> = new Set([91, 92]);
const RETRACT = 140;
/** Distance from the blank after M140 MB MAX, mm: the limit of travel is farther, with nothing in between. */
const BEYOND_BLANK = 20;

export const isInMachineCoordinates = (words: Words): boolean =>
  words.functions.some((m) => MACHINE_COORDINATES.has(m));
export const retracts = (words: Words): boolean => words.functions.includes(RETRACT);

/** M91 counts from machine zero; M92 from a point set by the machine builder. */
const isMachineZero = (words: Words): boolean => words.functions.includes(91);
/** A machine coordinate this close to 0 counts as the limit of travel, mm. */
const HOME = 10;

/**
 * Whether a block moves a turning tool home at rapid, away from the work. A single axis runs straight until it clears
 * the blank. With several axes the path is unknown, so the tool must be clear already.
 */
function goesHome(machine: Machine, words: Words, index: number): boolean {
  const { blank, tool } = machine.now;
  const from = machine.tip;
  const isAtHome = words.axes.every(({ value, incremental }) => {
    const n = incremental ? null : machine.number(value, index);
    return n !== null && Math.abs(machine.length(n)) <= HOME;
  });
  if (words.feed !== "max" || !isAtHome || !from || !tool || blank.length === 0) return false;
  const { right, high } = boxAround(blank);
  const [only] = words.axes;
  if (words.axes.length > 1 || (only?.axis !== "X" && only?.axis !== "Z"))
    return from.z > right || Math.abs(from.r) > high;
  const to =
    only.axis === "Z"
      ? { z: axial(Math.max(from.z, right + BEYOND_BLANK)), r: from.r }
      : { z: from.z, r: radius(Math.max(from.r, high + BEYOND_BLANK)) };
  if (part.lengthOf(part.line(from, to)) > SAME) machine.step(from, moveOf(machine, part.line(from, to), null), index);
  return true;
}

/**
 * A block in machine coordinates: its axes are unknown afterwards. The path there is unverified, except a move home.
 */
export function machineCoordinateMove(machine: Machine, words: Words, index: number): void {
  const { mill } = machine.place;
  const wasKnown = machine.now.turning
    ? machine.tip !== null && machine.place.sure.x && machine.place.sure.z
    : mill.z !== null && centreOf(mill) !== null;
  takeFeed(machine, words.feed, index);
  const isHome = wasKnown && machine.now.turning && isMachineZero(words) && goesHome(machine, words, index);
  for (const { axis } of words.axes) {
    if (axis !== "X" && axis !== "Y" && axis !== "Z") continue;
    const unknown = { [axis.toLowerCase()]: null };
    machine.setPlace({ at: { ...machine.place.at, ...unknown }, mill: { ...machine.place.mill, ...unknown } });
  }
  const { at, sure } = machine.place;
  machine.setPlace({ sure: { x: sure.x && at.x !== null, z: sure.z && at.z !== null }, last: null, milled: null });
  machine.millGuide.here = centreOf(machine.place.mill);
  const what = words.functions
    .filter((m) => MACHINE_COORDINATES.has(m))
    .map((m) => `M${m}`)
    .join(" ");
  if (isHome) machine.setPlace({ homedBy: { index, what } });
  else if (wasKnown) machine.log.leaveUnproved(what, index);
  else machine.log.notSimulated(what, index);
}

/**
 * M140: retracts along the tool axis at the start of its block, by MB or to the limit of travel; at its own feed, or at
 * rapid.
 */
export function retract(machine: Machine, words: Words, index: number): void {
  const feed = functionFeed(machine, words.functionFeed, index);
  const by = words.retract === undefined || words.retract === "max" ? null : machine.number(words.retract, index);
  if (words.retract === undefined || (words.retract !== "max" && by === null))
    machine.log.leaveUnproved(`M${RETRACT}`, index);
  const far = by === null ? null : machine.length(by);
  machine.setPlace({ milled: null, last: null });
  if (machine.now.turning) turned(machine, far, feed, index);
  else milled(machine, far, feed, index);
}

type Travel = Parameters<typeof millStep>[2];

function turned(machine: Machine, far: number | null, feed: Travel["feed"], index: number): void {
  const from = machine.place.sure.x && machine.place.sure.z ? machine.tip : null;
  const ends = machine.now.blank.flat().map((p) => p.z);
  const blankEnd = ends.reduce((a, b) => Math.max(a, b), -Infinity);
  const z =
    far !== null && from
      ? from.z + far
      : from && Number.isFinite(blankEnd)
        ? Math.max(from.z, blankEnd + BEYOND_BLANK)
        : null;
  if (from && z !== null) {
    const to = { z: axial(z), r: from.r };
    if (z !== from.z) machine.step(from, moveOf(machine, part.line(from, to), feed), index);
  }
  const { at, sure } = machine.place;
  machine.setPlace({ at: { ...at, z }, sure: { ...sure, z: z !== null } });
}

function milled(machine: Machine, far: number | null, feed: Travel["feed"], index: number): void {
  const {
    now,
    place: { mill },
    millGuide: { here },
  } = machine;
  if (now.mill.otherAxis) return machine.log.leaveUnproved(`M${RETRACT}`, index);
  const [at, from] = [here ?? centreOf(mill), mill.z];
  const to = far === null || from === null ? null : from + far;
  if (at && from !== null && to !== null)
    millStep(machine, { kind: "line", from: at, to: at }, { fromZ: from, toZ: to, feed, index });
  machine.setPlace({ mill: { ...mill, z: to } });
}
