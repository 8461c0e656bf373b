import type { PathKind, Value, Words } from "../../nc/words.ts";
import { growthIn, isFlipped, NO_TRANSFORM } from "../tools/coordinates-frame.ts";
import type { Machine } from "../state/machine.ts";
import { isPolarPath, type MillPlane, type PathBlock } from "../state/path.ts";

const OTHER_SIDE = { RL: "RR", RR: "RL", R0: "R0" } as const;
const OTHER_WAY = { cw: "ccw", ccw: "cw" } as const;
const ARCS: ReadonlySet<PathKind> = new Set(["C", "CR", "CT", "CP", "CTP"]);

/** A program length scaled to the workpiece; an unknown value stays as written. */
function grown(machine: Machine, value: Value, by: number, index: number): Value {
  const n = by === 1 ? null : machine.number(value, index);
  return n === null ? value : n * by;
}

/** Words of a block in workpiece terms: side, direction and lengths; never the tool radius. */
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

/** Some arcs cannot be mirrored, rotated or scaled into a circle of a plane: these are unverified and run straight. */
export function millBlock(machine: Machine, block: PathBlock, plane: MillPlane, index: number): PathBlock {
  const { transform } = machine.now;
  if (transform === NO_TRANSFORM) return block;
  const made = { ...block, words: wordsOn(machine, block.words, plane, index) };
  const bends = ARCS.has(block.path) && growthIn(transform, plane) === null;
  const leaves = plane !== "XY" && transform.rotation !== 0;
  if (bends || leaves) machine.log.leaveUnproved(block.path, index);
  return !bends ? made : { ...made, path: isPolarPath(block.path) ? "LP" : "L" };
}

/** Words of APPR or DEP in workpiece terms. */
export function millApproachWords(machine: Machine, words: Words, form: string, index: number): Words {
  const { transform } = machine.now;
  if (transform === NO_TRANSFORM) return words;
  if (growthIn(transform, "XY") === null) machine.log.leaveUnproved(form, index);
  return wordsOn(machine, words, "XY", index);
}

/** Scale factor of a rounding or chamfer; null where it is not a single number, which leaves it unverified. */
export function cornerGrowth(machine: Machine, what: string, index: number): number | null {
  const by = machine.now.turning ? 1 : growthIn(machine.now.transform, "XY");
  if (by === null) machine.log.leaveUnproved(what, index);
  return by;
}
