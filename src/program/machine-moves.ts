import { axial } from "../kernel/units.ts";
import type { Words } from "../nc/statement.ts";
import { functionFeed, takeFeed } from "./block-feed.ts";
import type { Machine } from "./machine.ts";
import { centreOf, millStep } from "./mill-moves.ts";
import { moveOf } from "./path-block.ts";
import { part } from "../kernel/point.ts";

/** Machine coordinates: where that is on the workpiece, nobody here knows. */
const MACHINE_COORDINATES: ReadonlySet<number> = new Set([91, 92]);
const RETRACT = 140;
/** How far beyond the blank a tool stands after M140 MB MAX, mm: the end of the travel is farther, and nothing stands between. */
const BEYOND_BLANK = 20;

export const isElsewhere = (words: Words): boolean => words.functions.some((m) => MACHINE_COORDINATES.has(m));
export const retracts = (words: Words): boolean => words.functions.includes(RETRACT);

/** A block in machine coordinates: the axes that it names are not known behind it. The way there, from a known place, is not proved. */
export function elsewhere(machine: Machine, words: Words, index: number): void {
  const { mill } = machine.place;
  const wasKnown = machine.now.turning
    ? machine.tip !== null && machine.place.sure.x && machine.place.sure.z
    : mill.z !== null && centreOf(mill) !== null;
  takeFeed(machine, words.feed, index);
  for (const { axis } of words.axes) {
    if (axis !== "X" && axis !== "Y" && axis !== "Z") continue;
    const unknown = { [axis.toLowerCase()]: null };
    machine.setPlace({ at: { ...machine.place.at, ...unknown }, mill: { ...machine.place.mill, ...unknown } });
  }
  const { at, sure } = machine.place;
  machine.setPlace({ sure: { x: sure.x && at.x !== null, z: sure.z && at.z !== null }, last: null, milled: null });
  machine.millGuide.here = centreOf(machine.place.mill);
  const what = words.functions.filter((m) => MACHINE_COORDINATES.has(m)).map((m) => `M${m}`).join(" ");
  if (wasKnown) machine.log.leaveUnproved(what, index);
  else machine.log.notSimulated(what, index);
}

/** M140: back along the tool axis, at the beginning of its block, by MB or to the end of the travel; at its own feed, or at rapid. */
export function retract(machine: Machine, words: Words, index: number): void {
  const feed = functionFeed(machine, words.functionFeed, index);
  const by = words.retract === undefined || words.retract === "max" ? null : machine.number(words.retract, index);
  if (words.retract === undefined || (words.retract !== "max" && by === null)) machine.log.leaveUnproved(`M${RETRACT}`, index);
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
  const z = far !== null && from ? from.z + far : from && Number.isFinite(blankEnd) ? Math.max(from.z, blankEnd + BEYOND_BLANK) : null;
  if (from && z !== null) {
    const to = { z: axial(z), r: from.r };
    if (z !== from.z) machine.step(from, moveOf(machine, part.line(from, to), feed), index);
  }
  const { at, sure } = machine.place;
  machine.setPlace({ at: { ...at, z }, sure: { ...sure, z: z !== null } });
}

function milled(machine: Machine, far: number | null, feed: Travel["feed"], index: number): void {
  const { now, place: { mill }, millGuide: { here } } = machine;
  if (now.mill.otherAxis) return machine.log.leaveUnproved(`M${RETRACT}`, index);
  const [at, from] = [here ?? centreOf(mill), mill.z];
  const to = far === null || from === null ? null : from + far;
  if (at && from !== null && to !== null) millStep(machine, { kind: "line", from: at, to: at }, { fromZ: from, toZ: to, feed, index });
  machine.setPlace({ mill: { ...mill, z: to } });
}
