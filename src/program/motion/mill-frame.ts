import type { PathKind, Value, Words } from "../../nc/words.ts";
import { growthIn, isFlipped, NO_TRANSFORM } from "../tools/coordinates-frame.ts";
import type { Machine } from "../state/machine.ts";
import { isPolarPath, type MillPlane, type PathBlock } from "../state/path.ts";

const OTHER_SIDE = { RL: "RR", RR: "RL", R0: "R0" } as const;
const OTHER_WAY = { cw: "ccw", ccw: "cw" } as const;
const ARCS: ReadonlySet<PathKind> = new Set(["C", "CR", "CT", "CP", "CTP"]);

/** A length of the program as long as it is on the workpiece; one that nobody knows stays as it is written. */
function grown(machine: Machine, value: Value, by: number, index: number): Value {
  const n = by === 1 ? null : machine.number(value, index);
  return n === null ? value : n * by;
}

/** The words of a block as they are on the workpiece: side, way round and lengths; never the tool's radius. */
function wordsOn(machine: Machine, words: Words, plane: MillPlane, index: number): Words {
  const { transform } = machine.now;
  const flipped = isFlipped(transform, plane);
  const by = growthIn(transform, plane) ?? 1;
  return {
    ...words,
    ...(flipped && words.compensation && { compensation: OTHER_SIDE[words.compensation] }),
    ...(flipped && { turn: OTHER_WAY[words.turn ?? "ccw"] }),
    ...(words.radius !== undefined && { radius: grown(machine, words.radius, by, index) }),
    ...(words.length !== undefined && { length: grown(machine, words.length, by, index) }),
  };
}

/**
 * Mirrored, turned and scaled coordinates bend some arcs out of shape or out of their plane: those are not proved, and
 * run straight.
 */
export function millBlock(machine: Machine, block: PathBlock, plane: MillPlane, index: number): PathBlock {
  const { transform } = machine.now;
  if (transform === NO_TRANSFORM) return block;
  const made = { ...block, words: wordsOn(machine, block.words, plane, index) };
  const bends = ARCS.has(block.path) && growthIn(transform, plane) === null;
  const leaves = plane !== "XY" && transform.rotation !== 0;
  if (bends || leaves) machine.log.leaveUnproved(block.path, index);
  return !bends ? made : { ...made, path: isPolarPath(block.path) ? "LP" : "L" };
}

/** The words of APPR or DEP on the workpiece. */
export function millApproachWords(machine: Machine, words: Words, form: string, index: number): Words {
  const { transform } = machine.now;
  if (transform === NO_TRANSFORM) return words;
  if (growthIn(transform, "XY") === null) machine.log.leaveUnproved(form, index);
  return wordsOn(machine, words, "XY", index);
}

/** What a rounding or a chamfer of a mill grows by; null where that is not one number, and it is not proved. */
export function cornerGrowth(machine: Machine, what: string, index: number): number | null {
  const by = machine.now.turning ? 1 : growthIn(machine.now.transform, "XY");
  if (by === null) machine.log.leaveUnproved(what, index);
  return by;
}
