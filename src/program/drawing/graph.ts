import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { overlap, type Box } from "../../kernel/geometry/segments.ts";
import { splitAt, TOUCHING, type HalfCurve } from "./halves.ts";

/** A line or arc between two nodes; `isAxis`: added along the axis, part of no contour. */
export interface Edge {
  from: number;
  to: number;
  readonly segment: Segment;
  readonly source: number;
  readonly isAxis: boolean;
}

/** A gap between two ends that was closed. */
export interface Join {
  readonly width: number;
  readonly at: Pt;
  readonly node: number;
}

export interface Graph {
  readonly nodes: readonly Pt[];
  readonly edges: readonly Edge[];
  readonly joins: readonly Join[];
}

/** Many loose ends are no outline with gaps: they are joined no farther than this, mm. */
const MOST_LOOSE = 5000,
  NARROW = 0.02;
/** Most points in which curves are divided, and most pairs compared; drawings with more are taken as drawn. */
const MOST_CUTS = 60_000,
  MOST_PAIRS = 400_000;

const wider = (b: Box, by: number): Box => ({
  left: b.left - by,
  right: b.right + by,
  low: b.low - by,
  high: b.high + by,
});

const isIn = (b: Box, p: Pt) => p.z >= b.left && p.z <= b.right && p.r >= b.low && p.r <= b.high;

/** Calls for each pair of curves whose boxes overlap, in order of their left ends; false when it was stopped. */
function pairs(boxes: readonly Box[], call: (a: number, b: number) => boolean): boolean {
  const order = boxes.map((_, i) => i).toSorted((i, j) => (boxes[i]?.left ?? 0) - (boxes[j]?.left ?? 0));
  let open: number[] = [];
  for (const i of order) {
    const box = boxes[i];
    if (!box) continue;
    open = open.filter((j) => (boxes[j]?.right ?? 0) >= box.left);
    for (const j of open) {
      const other = boxes[j];
      if (other && overlap(box, other) && !call(i, j)) return false;
    }
    open.push(i);
  }
  return true;
}

/** Curves divided where others end on them or cross them. */
export function divided(curves: readonly HalfCurve[]): HalfCurve[] {
  const cuts: Pt[][] = curves.map(() => []),
    boxes = curves.map((c) => wider(part.boxOf(c.segment), TOUCHING));
  let [count, compared] = [0, 0];
  const isDone = pairs(boxes, (i, j) => {
    const [a, b] = [curves[i]?.segment, curves[j]?.segment];
    if (!a || !b) return true;
    const cut = (s: Segment, index: number, p: Pt) => {
      const box = boxes[index];
      if (!box || !isIn(box, p)) return;
      if (part.apart(p, s.from) > TOUCHING && part.apart(p, s.to) > TOUCHING && part.distanceTo(s, p) <= TOUCHING) {
        cuts[index]?.push(p);
        count += 1;
      }
    };
    for (const p of [a.from, a.to]) cut(b, j, p);
    for (const p of [b.from, b.to]) cut(a, i, p);
    for (const p of part.meetings(a, b))
      if (part.distanceTo(a, p) <= TOUCHING && part.distanceTo(b, p) <= TOUCHING) {
        cut(a, i, p);
        cut(b, j, p);
      }
    compared += 1;
    return count < MOST_CUTS && compared < MOST_PAIRS;
  });
  if (!isDone) return [...curves];
  return curves.flatMap(({ segment, source }, i) =>
    splitAt(segment, distinct(cuts[i] ?? [])).map((s) => ({ segment: s, source })),
  );
}
const distinct = (points: readonly Pt[]) =>
  points.filter((p, i) => points.findIndex((q) => part.apart(p, q) <= TOUCHING) === i);

/** Rows of a grid are this far apart in its keys; cells that share a key are told apart by their distance. */
const ROW = 4_294_967_291;

/** Points in a grid, so that near ones are found quickly. */
class Places {
  readonly all: Pt[] = [];
  private readonly cells = new Map<number, number[]>();
  private readonly reach: number;

  constructor(reach: number) {
    this.reach = reach;
  }

  private cell = (n: number) => Math.floor(n / this.reach);

  add(p: Pt): number {
    const index = this.all.push(p) - 1,
      key = this.cell(p.z) * ROW + this.cell(p.r),
      there = this.cells.get(key);
    if (there) there.push(index);
    else this.cells.set(key, [index]);
    return index;
  }

  /** Points within the reach, the nearest first. */
  near(p: Pt): { readonly index: number; readonly far: number }[] {
    const found: { index: number; far: number }[] = [],
      [column, row] = [this.cell(p.z), this.cell(p.r)];
    for (let z = column - 1; z <= column + 1; z += 1)
      for (let r = row - 1; r <= row + 1; r += 1)
        for (const index of this.cells.get(z * ROW + r) ?? []) {
          const far = part.apart(p, this.all[index] ?? p);
          if (far <= this.reach) found.push({ index, far });
        }
    return found.sort((a, b) => a.far - b.far);
  }
}

/** Number of edges at each node. */
export function degreesOf(nodes: readonly Pt[], edges: readonly Edge[]): number[] {
  const degree = nodes.map(() => 0);
  for (const e of edges) for (const n of [e.from, e.to]) degree[n] = (degree[n] ?? 0) + 1;
  return degree;
}

/** A loose end that stops short of a curve, and the nearest point of it. */
interface End {
  readonly node: number;
  readonly on: Pt;
  readonly far: number;
}

/** For each edge, the loose ends to which it is the nearest within the gap. */
function stopsAt(
  nodes: readonly Pt[],
  edges: readonly Edge[],
  loose: readonly number[],
  gap: number,
): Map<number, End[]> {
  const z = (n: number) => nodes[n]?.z ?? 0,
    sorted = loose.toSorted((a, b) => z(a) - z(b)),
    best = new Map<number, End & { readonly edge: number }>();
  edges.forEach((e, edge) => {
    const box = wider(part.boxOf(e.segment), gap);
    let [low, high] = [0, sorted.length];
    while (low < high) {
      const half = (low + high) >> 1;
      if (z(sorted[half] ?? 0) < box.left) low = half + 1;
      else high = half;
    }
    for (let i = low; i < sorted.length; i += 1) {
      const node = sorted[i] ?? 0,
        p = nodes[node];
      if (!p || p.z > box.right) break;
      if (p.r < box.low || p.r > box.high || e.from === node || e.to === node) continue;
      const on = part.nearestOn(e.segment, p),
        far = part.apart(on, p);
      if (far <= gap && far < (best.get(node)?.far ?? Infinity)) best.set(node, { node, on, far, edge });
    }
  });
  const stops = new Map<number, End[]>();
  for (const { edge, ...end } of best.values()) {
    const there = stops.get(edge);
    if (there) there.push(end);
    else stops.set(edge, [end]);
  }
  return stops;
}

/** Joins loose ends to the nearest loose end, then to the nearest curve, no farther than the gap; changes the edges. */
function joined(nodes: readonly Pt[], edges: Edge[], widest: number): Join[] {
  const joins: Join[] = [],
    degree = degreesOf(nodes, edges),
    gap = degree.filter((d) => d === 1).length > MOST_LOOSE ? Math.min(widest, NARROW) : widest;
  const places = new Places(gap),
    numbers: number[] = [];
  nodes.forEach((p, n) => {
    if (degree[n] === 1) numbers[places.add(p)] = n;
  });
  // A loose end has one edge: the ends of a short line are not joined with each other.
  const otherEnd = new Map(edges.flatMap((e) => [[e.from, e.to] as const, [e.to, e.from] as const]));
  const candidates = places.all
    .flatMap((p, i) =>
      places
        .near(p)
        .flatMap(({ index, far }) => (index > i ? [{ a: numbers[i] ?? 0, b: numbers[index] ?? 0, far }] : [])),
    )
    .toSorted((x, y) => x.far - y.far);
  const done = new Set<number>();
  const moved = new Map<number, number>();
  for (const { a, b, far } of candidates) {
    if (done.has(a) || done.has(b) || otherEnd.get(a) === b) continue;
    done.add(a).add(b);
    moved.set(b, a);
    joins.push({ width: far, at: middle(nodes[a], nodes[b]), node: a });
  }
  const loose = numbers.filter((n) => !done.has(n));
  const stops = stopsAt(nodes, edges, loose, gap);
  stops.forEach((ends, index) => {
    const e = edges[index];
    if (!e) return;
    const between: End[] = [];
    for (const end of ends) {
      joins.push({ width: end.far, at: middle(nodes[end.node], end.on), node: end.node });
      if (part.apart(end.on, e.segment.from) <= TOUCHING) moved.set(end.node, e.from);
      else if (part.apart(end.on, e.segment.to) <= TOUCHING) moved.set(end.node, e.to);
      else between.push(end);
    }
    const along = between.toSorted((a, b) => part.along(e.segment, a.on) - part.along(e.segment, b.on)),
      pieces = splitAt(
        e.segment,
        along.map((end) => end.on),
      );
    if (pieces.length !== along.length + 1) return;
    const chain = [e.from, ...along.map((end) => end.node), e.to];
    pieces.forEach((segment, k) => {
      const piece = { ...e, segment, from: chain[k] ?? e.from, to: chain[k + 1] ?? e.to };
      if (k === 0) edges[index] = piece;
      else edges.push(piece);
    });
  });
  const target = (n: number): number => {
    let to = n;
    for (let i = 0; i < 4 && moved.has(to); i += 1) to = moved.get(to) ?? to;
    return to;
  };
  for (const e of edges) {
    e.from = target(e.from);
    e.to = target(e.to);
  }
  return joins.map((j) => ({ ...j, node: target(j.node) }));
}
const middle = (a: Pt | undefined, b: Pt | undefined): Pt =>
  a && b ? part.scaled(part.sum(a, b), 1 / 2) : (a ?? b ?? at(0, 0));

/** Nodes and edges of the curves of a half that were divided, with loose ends joined up to the gap (mm). */
export function graphOf(curves: readonly HalfCurve[], gap: number): Graph {
  const places = new Places(TOUCHING);
  const nodeAt = (p: Pt) => places.near(p)[0]?.index ?? places.add(p);
  const edges: Edge[] = curves.flatMap(({ segment, source }) => {
    const [from, to] = [nodeAt(segment.from), nodeAt(segment.to)];
    return from === to && part.lengthOf(segment) <= 2 * TOUCHING ? [] : [{ from, to, segment, source, isAxis: false }];
  });
  const joins = gap > TOUCHING ? joined(places.all, edges, gap) : [];
  return { nodes: places.all, edges: edges.filter((e) => e.from !== e.to), joins };
}

/** Edges that hang together, as lists of indexes, and the pieces of the axis between the nodes of each on it. */
export function componentsOf({ nodes, edges }: Graph): Edge[][] {
  const parent = nodes.map((_, i) => i);
  const root = (n: number): number => {
    let at = n;
    while (parent[at] !== at) {
      const up = parent[parent[at] ?? at] ?? at;
      parent[at] = up;
      at = up;
    }
    return at;
  };
  for (const e of edges) parent[root(e.from)] = root(e.to);
  const groups = new Map<number, Edge[]>();
  for (const e of edges) {
    const key = root(e.from),
      there = groups.get(key);
    if (there) there.push(e);
    else groups.set(key, [e]);
  }
  return [...groups.values()].map((group) => {
    const axis = [...new Set(group.flatMap((e) => [e.from, e.to]))]
      .filter((n) => (nodes[n]?.r ?? 1) <= TOUCHING)
      .toSorted((a, b) => (nodes[a]?.z ?? 0) - (nodes[b]?.z ?? 0));
    const along = axis.slice(1).map((to, i): Edge => {
      const from = axis[i] ?? to,
        [p, q] = [nodes[from] ?? at(0, 0), nodes[to] ?? at(0, 0)];
      return { from, to, segment: part.line(p, q), source: -1, isAxis: true };
    });
    return [...group, ...along];
  });
}
