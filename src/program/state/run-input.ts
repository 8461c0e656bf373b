import { blockNumbers, startLines, type Program } from "../../nc/program.ts";
import { MachineClock } from "./machine-clock.ts";
import type { Shop } from "./shop.ts";
import { unitFrom, type Unit } from "./units.ts";

/** Number of executed blocks when a run first read each block; 0 for unread blocks. */
export interface FirstReads {
  /** Blocks that were run, or read as part of a contour. */
  readonly visited: Uint32Array;
  /** Blocks read ahead by an earlier block. */
  readonly lookedAhead: Uint32Array;
}

/** Inputs of a run, and what follows from them alone. */
export interface RunInput {
  readonly program: Program;
  readonly shop: Shop;
  /** Times and speeds of the machine. */
  readonly clock: MachineClock;
  /** The program as the text that runs first. */
  readonly unit: Unit;
  /** Number of each block, and its line in the text. */
  readonly numbers: readonly number[];
  readonly lines: readonly number[];
  /** Filled during the run. */
  readonly firstReads: FirstReads;
}

/** `before`: input of the run that this one continues, and its number of executed blocks there. */
export function runInput(
  program: Program,
  shop: Shop,
  before?: { readonly input: RunInput; readonly executed: number },
): RunInput {
  const until = (looks: Uint32Array | undefined) =>
    looks?.map((count) => (count <= (before?.executed ?? 0) ? count : 0)) ?? new Uint32Array(program.blocks.length);
  return {
    program,
    shop,
    clock: before?.input.clock ?? new MachineClock(shop),
    unit: unitFrom(program, { file: null, from: 0, skipMarked: shop.skipMarked ?? false }),
    numbers: blockNumbers(program),
    lines: startLines(program),
    firstReads: {
      visited: until(before?.input.firstReads.visited),
      lookedAhead: until(before?.input.firstReads.lookedAhead),
    },
  };
}

/** Number of executed blocks when a run first read a block; Infinity for an unread block. */
export function firstReadAt({ firstReads: { visited, lookedAhead } }: RunInput, index: number): number {
  return Math.min(visited[index] || Infinity, lookedAhead[index] || Infinity);
}
