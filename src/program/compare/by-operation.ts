import { blockNumbers, type Program } from "../../nc/program.ts";
import { operationsOf, wholeOf } from "../edits/operations.ts";
import type { BlockDifference, ProgramComparison } from "./compare.ts";

/** Outcome of an operation in the comparison. */
export type OperationOutcome = "kept" | "added" | "removed" | "moved";

/** One operation in one of the programs. */
export interface ComparedUnit {
  /** Words of its structure comment; null where it has none. */
  readonly title: string | null;
  readonly cycles: readonly number[];
  /** Number of its first block. */
  readonly block: number;
  /** Its index among all operations, from 0. */
  readonly place: number;
}

/** An operation of one or both programs, with its differences; both null: blocks outside of operations. */
export interface ComparedOperation {
  readonly outcome: OperationOutcome;
  readonly a: ComparedUnit | null;
  readonly b: ComparedUnit | null;
  readonly differences: readonly BlockDifference[];
}

/** Operation of each block, -1 for none. */
interface Placed {
  readonly of: Int32Array;
  readonly units: readonly ComparedUnit[];
  /** Blocks that identify the operation best. */
  readonly telling: readonly (readonly number[])[];
}

function placed(program: Program): Placed {
  const all = operationsOf(program);
  const numbers = blockNumbers(program);
  const of = new Int32Array(program.blocks.length).fill(-1);
  const units = all.units.map((own, place): ComparedUnit => {
    const { from, to } = wholeOf(all, place);
    of.fill(place, from, to);
    const cycles = own.definitions.flatMap((i) => {
      const s = program.blocks[i]?.statement;
      return s?.kind === "cycle" || s?.kind === "cycleLine" ? [s.cycle] : [];
    });
    return { title: own.title, cycles, block: numbers[from] ?? 0, place };
  });
  const telling = all.units.map((own) =>
    own.definitions.length > 0 ? own.definitions : Array.from({ length: own.to - own.from }, (_, i) => own.from + i),
  );
  return { of, units, telling };
}

/** Partner of each first operation in the second program, -1 for none: the one with most of its identifying blocks. */
function partnersOf(a: Placed, b: Placed, partners: Int32Array): Int32Array {
  const taken = new Set<number>();
  return Int32Array.from(a.telling, (blocks) => {
    const votes = new Map<number, number>();
    for (const block of blocks) {
      const unit = b.of[partners[block] ?? -1] ?? -1;
      if (unit >= 0 && !taken.has(unit)) votes.set(unit, (votes.get(unit) ?? 0) + 1);
    }
    const [best] = [...votes].sort(([, one], [, other]) => other - one);
    if (!best) return -1;
    taken.add(best[0]);
    return best[0];
  });
}

/** The first number below `count` from which on a condition holds; `count` if it never does. */
function firstWhere(count: number, holds: (at: number) => boolean): number {
  let [low, high] = [0, count];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (holds(middle)) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** Moved operations: all outside the longest subsequence in unchanged order. */
function outOfOrder(partner: Int32Array): ReadonlySet<number> {
  const kept = [...partner.keys()].filter((i) => (partner[i] ?? -1) >= 0);
  const of = (i: number | undefined) => partner[i ?? -1] ?? 0;
  // The ends of ascending rows of each length; the partners of those of one length descend.
  const ends: number[][] = [];
  const before = new Map<number, number | undefined>();
  for (const i of kept) {
    const length = firstWhere(ends.length, (row) => of(ends[row]?.at(-1)) >= of(i));
    const shorter = ends[length - 1] ?? [];
    before.set(i, shorter[firstWhere(shorter.length, (at) => of(shorter[at]) < of(i))]);
    (ends[length] ??= []).push(i);
  }
  const stays = new Set<number>();
  for (let last = ends.at(-1)?.[0]; last !== undefined; last = before.get(last)) stays.add(last);
  return new Set(kept.filter((i) => !stays.has(i)));
}

/**
 * Groups the differences by operation, in the order of the second program. Unchanged operations are included, since
 * they may still run differently. Blocks outside of operations come first.
 */
export function byOperation(
  a: Program,
  b: Program,
  { differences, partners }: ProgramComparison,
): readonly ComparedOperation[] {
  const [inA, inB] = [placed(a), placed(b)];
  const partner = partnersOf(inA, inB, partners);
  const moved = outOfOrder(partner);
  const comesFrom = new Map([...partner].map((unit, i) => [unit, i] as const));
  const own = new Map<string, BlockDifference[]>();
  const nameOf = (unitA: number, unitB: number) => `${unitA} ${unitB}`;
  for (const each of differences) {
    const unitB = each.b === null ? -1 : (inB.of[each.b] ?? -1);
    const unitA = each.a === null ? -1 : (inA.of[each.a] ?? -1);
    const name =
      each.b === null
        ? nameOf(unitA, unitA < 0 ? -1 : (partner[unitA] ?? -1))
        : nameOf(unitB < 0 ? -1 : (comesFrom.get(unitB) ?? -1), unitB);
    const list = own.get(name);
    if (list) list.push(each);
    else own.set(name, [each]);
  }
  const fateOf = (unitA: number, unitB: number): OperationOutcome => {
    if (unitA < 0 && unitB < 0) return "kept";
    if (unitA < 0) return "added";
    if (unitB < 0) return "removed";
    return moved.has(unitA) ? "moved" : "kept";
  };
  const made = (unitA: number, unitB: number): ComparedOperation => ({
    outcome: fateOf(unitA, unitB),
    a: inA.units[unitA] ?? null,
    b: inB.units[unitB] ?? null,
    differences: own.get(nameOf(unitA, unitB)) ?? [],
  });
  const list = inB.units.map(({ place }) => made(comesFrom.get(place) ?? -1, place));
  for (const { place } of inA.units) {
    if ((partner[place] ?? -1) >= 0) continue;
    // A removed operation keeps its place behind its predecessor.
    const before = place === 0 ? -1 : list.findIndex(({ a: one }) => one?.place === place - 1);
    list.splice(before + 1, 0, made(place, -1));
  }
  return [made(-1, -1), ...list];
}
