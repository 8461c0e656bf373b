import { areaOf } from "../kernel/area/area.ts";
import { intersection } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { LEAST_REGION } from "./open-regions.ts";

/** The stretch of a thread along Z, mm, on one side of the part. Its grooves are no area. */
export interface ThreadStretch {
  readonly front: number;
  readonly rear: number;
  readonly isInside: boolean;
}

/** One operation of a working plan, whoever wrote it. */
export interface ComparedOperation {
  /** Null for path blocks. */
  readonly cycle: number | null;
  readonly tool: number;
  /** Time with its tool change, s. */
  readonly seconds: number;
  /** Stock that it took; empty for a thread. */
  readonly taken: readonly Ring[];
  readonly thread: ThreadStretch | null;
}

/** Operations of two plans that take the same stock: usually one of each, or none where only one plan has them. */
export interface ComparedRow {
  /** Indices into the two plans, in their order. */
  readonly own: readonly number[];
  readonly other: readonly number[];
  readonly isSameTool: boolean;
  readonly isSameCycle: boolean;
  /** Time of the own operations minus that of the others, s. */
  readonly longer: number;
  /** The other plan does it earlier, or later, among the rows that both have. */
  readonly moved: "earlier" | "later" | null;
}

/** Part of the smaller of two cuts that both have to share. */
const SHARED = 0.5;

/** How much two operations do the same: 0 nothing, 1 exactly the same. */
function likeness(a: ComparedOperation, b: ComparedOperation): number {
  if (a.thread && b.thread) {
    const both = Math.min(a.thread.front, b.thread.front) - Math.max(a.thread.rear, b.thread.rear);
    const [one, two] = [a.thread, b.thread].map(({ front, rear }) => front - rear) as [number, number];
    const isSame = a.thread.isInside === b.thread.isInside && both >= SHARED * Math.min(one, two);
    return isSame ? both / Math.max(one, two) : 0;
  }
  if (a.thread || b.thread) return 0;
  const [one, two, both] = [areaOf(a.taken), areaOf(b.taken), areaOf(intersection(a.taken, b.taken))];
  return both < Math.min(LEAST_REGION, one, two) || both < SHARED * Math.min(one, two) ? 0 : both / (one + two - both);
}

/** The index of the greatest value above 0; -1 without one. */
const greatest = (values: readonly number[]): number => {
  const most = Math.max(0, ...values);
  return most > 0 ? values.indexOf(most) : -1;
};

/** A row before its comparison. */
interface Group {
  readonly own: number[];
  readonly other: number[];
}

/**
 * Operations grouped by what they take: each goes with the operation of the other plan that is most like it, so that two
 * operations may stand beside one that does the work of both.
 */
function grouped(own: readonly ComparedOperation[], others: readonly ComparedOperation[]): readonly Group[] {
  const like = own.map((a) => others.map((b) => likeness(a, b)));
  const links = new Set([
    ...like.map((row, i) => [i, greatest(row)].join()),
    ...others.map((_, j) => [greatest(like.map((row) => row[j] ?? 0)), j].join()),
  ]);
  const groups: Group[] = [];
  const take = (group: Group, side: keyof Group, index: number): void => {
    if (group[side].includes(index)) return;
    group[side].push(index);
    const across = side === "own" ? others : own;
    across.forEach((_, k) => {
      const link = side === "own" ? [index, k] : [k, index];
      if (links.has(link.join())) take(group, side === "own" ? "other" : "own", k);
    });
  };
  const has = (side: keyof Group, index: number) => groups.some((group) => group[side].includes(index));
  for (const side of ["own", "other"] as const)
    (side === "own" ? own : others).forEach((_, i) => {
      if (has(side, i)) return;
      const group: Group = { own: [], other: [] };
      take(group, side, i);
      groups.push({ own: group.own.toSorted((a, b) => a - b), other: group.other.toSorted((a, b) => a - b) });
    });
  return groups;
}

/** Indices of the longest increasing part of a sequence. */
function increasing(values: readonly number[]): ReadonlySet<number> {
  const runs: (readonly number[])[] = [];
  values.forEach((value, i) => {
    const before = runs
      .slice(0, i)
      .filter((run) => (values[run.at(-1) ?? 0] ?? 0) < value)
      .reduce<readonly number[]>((best, run) => (run.length > best.length ? run : best), []);
    runs.push([...before, i]);
  });
  return new Set(runs.reduce<readonly number[]>((best, run) => (run.length > best.length ? run : best), []));
}

/** Groups in the order of the own plan; one that only the other plan has stands behind its operation before. */
function inOrder(groups: readonly Group[]): readonly Group[] {
  const rows = groups.filter(({ own }) => own.length > 0).toSorted((a, b) => (a.own[0] ?? 0) - (b.own[0] ?? 0));
  const lone = groups.filter(({ own }) => own.length === 0);
  for (const group of lone.toSorted((a, b) => (a.other[0] ?? 0) - (b.other[0] ?? 0))) {
    const before = (group.other[0] ?? 0) - 1;
    rows.splice(rows.findIndex(({ other }) => other.includes(before)) + 1, 0, group);
  }
  return rows;
}

const isSame = (a: readonly unknown[], b: readonly unknown[]): boolean =>
  new Set(a).size === new Set(b).size && a.every((each) => b.includes(each));

/**
 * Two working plans of the same part side by side: their operations by the stock that each takes, not by their names.
 * Neither plan counts as the right one.
 */
export function comparePlans(
  own: readonly ComparedOperation[],
  others: readonly ComparedOperation[],
): readonly ComparedRow[] {
  const rows = inOrder(grouped(own, others));
  const both = rows.filter((row) => row.own.length > 0 && row.other.length > 0);
  const kept = increasing(both.map(({ other }) => other[0] ?? 0));
  const movedOf = (row: Group): ComparedRow["moved"] => {
    const at = both.indexOf(row);
    if (at < 0 || kept.has(at)) return null;
    const isBehind = both.slice(0, at).some(({ other }) => (other[0] ?? 0) > (row.other[0] ?? 0));
    return isBehind ? "earlier" : "later";
  };
  return rows.map((row): ComparedRow => {
    const [mine, theirs] = [row.own.map((i) => own[i]), row.other.map((i) => others[i])];
    const sum = (all: readonly (ComparedOperation | undefined)[]) =>
      all.reduce((seconds, each) => seconds + (each?.seconds ?? 0), 0);
    return {
      ...row,
      isSameTool: isSame(
        mine.map((each) => each?.tool),
        theirs.map((each) => each?.tool),
      ),
      isSameCycle: isSame(
        mine.map((each) => each?.cycle),
        theirs.map((each) => each?.cycle),
      ),
      longer: sum(mine) - sum(theirs),
      moved: movedOf(row),
    };
  });
}
