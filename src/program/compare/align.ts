/** A pair of equal members: index in the first and in the second list. */
export type Pair = readonly [a: number, b: number];

/** Step limit of one search, after which the best path so far is taken: keeps lists with little in common fast. */
const MOST_STEPS = 400;

/** Furthest position of a search, and the reach of each diagonal before each step. */
interface Way {
  readonly end: Pair;
  readonly steps: number;
  readonly before: readonly Int32Array[];
}

/** True for a position further on; at equal distance, the one that advances both lists more evenly. */
function isFurther([x, y]: Pair, [otherX, otherY]: Pair): boolean {
  const more = x + y - otherX - otherY;
  return more > 0 || (more === 0 && Math.abs(x - y) < Math.abs(otherX - otherY));
}

/** Shortest path from a position of both lists, or the furthest one within the step limit. */
function search(a: Int32Array, b: Int32Array, [fromA, fromB]: Pair): Way {
  const [n, m] = [a.length - fromA, b.length - fromB];
  const most = Math.min(n + m, MOST_STEPS);
  const front = new Int32Array(2 * most + 3);
  const at = (k: number): number => front[most + 1 + k] ?? 0;
  const before: Int32Array[] = [];
  let way: Omit<Way, "before"> = { end: [fromA, fromB], steps: 0 };
  for (let d = 0; d <= most; d += 1) {
    before.push(front.slice(most - d, most + d + 3));
    for (let k = -d; k <= d; k += 2) {
      let x = d === 0 ? 0 : k === -d || (k !== d && at(k - 1) < at(k + 1)) ? at(k + 1) : at(k - 1) + 1;
      while (x < n && x - k < m && a[fromA + x] === b[fromB + x - k]) x += 1;
      front[most + 1 + k] = x;
      const y = x - k;
      if (x <= n && y <= m && isFurther([x, y], [way.end[0] - fromA, way.end[1] - fromB]))
        way = { end: [fromA + x, fromB + y], steps: d };
      if (x >= n && y >= m) return { ...way, before };
    }
  }
  return { ...way, before };
}

/** Equal pairs along a path, last first. */
function equalsOn({ end, steps, before }: Way, [fromA, fromB]: Pair): Pair[] {
  const pairs: Pair[] = [];
  let [x, y] = [end[0] - fromA, end[1] - fromB];
  for (let d = steps; d >= 0; d -= 1) {
    const at = (k: number): number => before[d]?.[d + 1 + k] ?? 0;
    const k = x - y;
    const comesDown = k === -d || (k !== d && at(k - 1) < at(k + 1));
    const fromX = d === 0 ? 0 : at(comesDown ? k + 1 : k - 1);
    const fromY = d === 0 ? 0 : fromX - (comesDown ? k + 1 : k - 1);
    while (x > fromX && y > fromY) {
      x -= 1;
      y -= 1;
      pairs.push([fromA + x, fromB + y]);
    }
    [x, y] = [fromX, fromY];
  }
  return pairs;
}

/**
 * Equal members of two lists in order: as many as possible (Myers 1986), or a good part of them where the lists have
 * little in common. The time is always proportional to the length of the lists.
 */
export function aligned(a: Int32Array, b: Int32Array): readonly Pair[] {
  const shorter = Math.min(a.length, b.length);
  let [first, last] = [0, 0];
  while (first < shorter && a[first] === b[first]) first += 1;
  while (last < shorter - first && a.at(-1 - last) === b.at(-1 - last)) last += 1;
  const pairs: Pair[] = Array.from({ length: first }, (_, i) => [i, i]);
  const [restA, restB] = [a.subarray(0, a.length - last), b.subarray(0, b.length - last)];
  let at: Pair = [first, first];
  while (at[0] < restA.length && at[1] < restB.length) {
    const way = search(restA, restB, at);
    for (const pair of equalsOn(way, at).reverse()) pairs.push(pair);
    at = way.end;
  }
  for (let i = last; i > 0; i -= 1) pairs.push([a.length - i, b.length - i]);
  return pairs;
}
