import type { P } from "./insert.ts";

/*
 * Areas as fine columns, each with the filled stretches at its middle. No polygons are clipped, so only the blank and
 * the moves are shared with the simulation. Columns run across z or across r; walls along a column are resolved only to
 * its width.
 */

/** Filled stretches of one column, from below: start, end, start, end … */
export type Spans = readonly number[];

/** A row of columns: start of the first, width and number. */
export interface Grid {
  readonly from: number;
  readonly width: number;
  readonly count: number;
  /** "z": columns are side by side along z and filled along r; "r": the other way round. */
  readonly along: "z" | "r";
}
export type Field = Spans[];

const across = (g: Grid, p: P) => (g.along === "z" ? p.z : p.r);
const height = (g: Grid, p: P) => (g.along === "z" ? p.r : p.z);
const middle = (g: Grid, i: number) => g.from + (i + 0.5) * g.width;

export const empty = (g: Grid): Field => Array.from({ length: g.count }, () => []);

const turnOf = (ring: readonly P[]) =>
  ring.reduce((sum, p, i) => {
    const q = ring[(i + 1) % ring.length] as P;
    return sum + p.z * q.r - q.z * p.r;
  }, 0);

/**
 * The union of closed polygons: places with a winding in the direction of most of their area. Holes have the other
 * direction. `either`: both directions count, as where a ring crosses itself.
 */
export function filled(g: Grid, rings: readonly (readonly P[])[], either = false): Field {
  const way = rings.reduce((sum, ring) => sum + turnOf(ring), 0) * (g.along === "z" ? 1 : -1);
  const crossings: { at: number; by: number }[][] = Array.from({ length: g.count }, () => []);
  for (const ring of rings) {
    let a = ring[ring.length - 1] as P;
    for (const b of ring) {
      const [x0, x1] = [across(g, a), across(g, b)];
      // One more column on both sides: rounding must not decide where a side ends exactly in the middle of a column.
      const first = Math.max(0, Math.ceil((Math.min(x0, x1) - g.from) / g.width - 0.5) - 1);
      const last = Math.min(g.count - 1, Math.floor((Math.max(x0, x1) - g.from) / g.width - 0.5) + 1);
      for (let i = first; i <= last; i += 1) {
        const x = middle(g, i);
        const by = x1 > x0 === way > 0 ? 1 : -1;
        if (x0 <= x !== x1 <= x)
          crossings[i]?.push({ at: height(g, a) + ((height(g, b) - height(g, a)) * (x - x0)) / (x1 - x0), by });
      }
      a = b;
    }
  }
  return crossings.map((column) => {
    const out: number[] = [];
    let winding = 0;
    for (const { at, by } of column.sort((p, q) => p.at - q.at)) {
      const before = winding;
      winding += by;
      const outside = (n: number) => (either ? n === 0 : n <= 0);
      if (outside(before) !== outside(winding)) out.push(at);
    }
    return out;
  });
}

/** Calls `each` for every column that a convex polygon crosses, with the crossed stretch. */
export function crossed(
  g: Grid,
  convex: readonly P[],
  each: (column: number, low: number, high: number) => void,
): void {
  const size = convex.length;
  let [start, end] = [0, 0];
  for (let i = 1; i < size; i += 1) {
    if (across(g, convex[i] as P) < across(g, convex[start] as P)) start = i;
    if (across(g, convex[i] as P) > across(g, convex[end] as P)) end = i;
  }
  const [left, right] = [across(g, convex[start] as P), across(g, convex[end] as P)];
  const first = Math.max(0, Math.ceil((left - g.from) / g.width - 0.5));
  const last = Math.min(g.count - 1, Math.floor((right - g.from) / g.width - 0.5));
  // Two walks from the first column to the last, one along each side.
  let [one, other] = [start, start];
  const on = (x: number, at: number, way: 1 | -1): [number, number] => {
    let i = at;
    for (;;) {
      const next = (i + way + size) % size;
      const [p, q] = [convex[i] as P, convex[next] as P];
      if (across(g, q) >= x || next === end) {
        const step = across(g, q) - across(g, p);
        const k = step > 0 ? Math.min(1, Math.max(0, (x - across(g, p)) / step)) : 1;
        return [height(g, p) + (height(g, q) - height(g, p)) * k, i];
      }
      i = next;
    }
  };
  for (let i = first; i <= last; i += 1) {
    const x = middle(g, i);
    let [a, b]: [number, number] = [0, 0];
    [a, one] = on(x, one, 1);
    [b, other] = on(x, other, -1);
    each(i, Math.min(a, b), Math.max(a, b));
  }
}

/** The intersection of two columns. */
export function common(a: Spans, b: Spans): number[] {
  const out: number[] = [];
  for (let i = 0, j = 0; i < a.length && j < b.length;) {
    const [low, high] = [Math.max(a[i] as number, b[j] as number), Math.min(a[i + 1] as number, b[j + 1] as number)];
    if (high > low) out.push(low, high);
    if ((a[i + 1] as number) < (b[j + 1] as number)) i += 2;
    else j += 2;
  }
  return out;
}

/** A column minus another. */
export function without(a: Spans, b: Spans): number[] {
  let left = [...a];
  for (let j = 0; j < b.length; j += 2) {
    const [low, high] = [b[j] as number, b[j + 1] as number];
    const next: number[] = [];
    for (let i = 0; i < left.length; i += 2) {
      const [from, to] = [left[i] as number, left[i + 1] as number];
      if (to <= low || from >= high) next.push(from, to);
      else {
        if (from < low) next.push(from, low);
        if (to > high) next.push(high, to);
      }
    }
    left = next;
  }
  return left;
}

/** Filled length of a column. */
export const lengthOf = (a: Spans): number => {
  let sum = 0;
  for (let i = 0; i < a.length; i += 2) sum += (a[i + 1] as number) - (a[i] as number);
  return sum;
};

/** mm² of a field. */
export const areaOf = (g: Grid, f: Field): number => f.reduce((sum, column) => sum + lengthOf(column), 0) * g.width;

const merged = (all: readonly number[]): number[] => {
  const pairs = Array.from(
    { length: all.length / 2 },
    (_, i) => [all[2 * i] as number, all[2 * i + 1] as number] as const,
  ).sort((a, b) => a[0] - b[0]);
  const out: number[] = [];
  for (const [low, high] of pairs) {
    const last = out.length - 1;
    if (last > 0 && low <= (out[last] as number)) out[last] = Math.max(out[last] as number, high);
    else out.push(low, high);
  }
  return out;
};
const moved = (a: Spans, by: number) => a.map((n, i) => (i % 2 === 0 ? n - by : n + by));

/** One column of a field that is grown by one column on both sides and by `by` mm along the columns. */
const grownAt = (f: Field, i: number, by: number): Spans =>
  merged(moved([...(f[i - 1] ?? []), ...(f[i] ?? []), ...(f[i + 1] ?? [])], by));

/** A field grown so: its tolerance zone. */
export const grown = (f: Field, by: number): Field => f.map((_, i) => grownAt(f, i, by));

/** A field without another one and its tolerance zone, which is made only where the first stands out. */
export const beyondGrown = (a: Field, b: Field, by: number): Field =>
  a.map((column, i) => (without(column, b[i] ?? []).length === 0 ? [] : without(column, grownAt(b, i, by))));

/**
 * A field shrunk likewise: the rest is certainly inside. The first and the last column have only one neighbour and are
 * unchanged.
 */
export const shrunk = (f: Field, by: number): Field =>
  f.map((column, i) =>
    moved(common(common(f[i - 1] ?? column, column), f[i + 1] ?? column), -by).flatMap((n, k, all) =>
      k % 2 === 0 && (all[k + 1] as number) > n ? [n, all[k + 1] as number] : [],
    ),
  );

/** Combines two fields column by column. */
export const each = (a: Field, b: Field, make: (a: Spans, b: Spans) => number[]): Field =>
  a.map((column, i) => make(column, b[i] ?? []));

/** Removes pieces smaller than `least` mm². Overlapping stretches of neighbouring columns are one piece. */
export function withoutCrumbs(g: Grid, f: Field, least: number): Field {
  const columns = f.map((column, i) =>
    column.flatMap((low, k) => (k % 2 === 0 ? [{ i, low, high: column[k + 1] as number, piece: -1 }] : [])),
  );
  const areas: number[] = [];
  for (const seed of columns.flat()) {
    if (seed.piece >= 0) continue;
    const piece = areas.push(0) - 1;
    seed.piece = piece;
    for (const open = [seed]; open.length > 0;) {
      const s = open.pop() as typeof seed;
      areas[piece] = (areas[piece] as number) + (s.high - s.low) * g.width;
      for (const n of [s.i - 1, s.i, s.i + 1].flatMap((i) => columns[i] ?? [])) {
        if (n.piece >= 0 || n.low > s.high || n.high < s.low) continue;
        n.piece = piece;
        open.push(n);
      }
    }
  }
  return columns.map((column) =>
    column.filter((s) => (areas[s.piece] as number) >= least).flatMap((s) => [s.low, s.high]),
  );
}
