import { blockNumbers, startLines, type Program } from "../../nc/program.ts";
import { MachineClock } from "./machine-clock.ts";
import type { Shop } from "./shop.ts";
import { unitFrom, type Unit } from "./units.ts";

/**
 * When a run first looked at each block of its program: how many blocks had been executed then; 0 for one that it did
 * not look at.
 */
export interface Looks {
  /** Blocks that were run, or read as part of a contour. */
  readonly visited: Uint32Array;
  /** Blocks that were looked at from another one before them. */
  readonly foreseen: Uint32Array;
}

/** What a run is made of, and what follows from that alone. */
export interface RunInput {
  readonly program: Program;
  readonly shop: Shop;
  /** What the machine makes of rapids and speeds. */
  readonly clock: MachineClock;
  /** The program as the text that runs first. */
  readonly unit: Unit;
  /** Number of each block, and its line in the text. */
  readonly numbers: readonly number[];
  readonly lines: readonly number[];
  /** Filled in while it runs. */
  readonly looks: Looks;
}

/** `before`: what a run that this one goes on from was made of, and how many blocks that one had executed there. */
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
    looks: { visited: until(before?.input.looks.visited), foreseen: until(before?.input.looks.foreseen) },
  };
}

/** How many blocks had been executed when a run first looked at a block; Infinity where it did not. */
export function firstLook({ looks: { visited, foreseen } }: RunInput, index: number): number {
  return Math.min(visited[index] || Infinity, foreseen[index] || Infinity);
}
