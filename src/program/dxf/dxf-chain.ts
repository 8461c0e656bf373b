import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";

/** Consecutive curves, and the gaps between them that were closed. */
export interface DxfChain {
  readonly segments: readonly Segment[];
  /** Width of the widest closed gap, and the number of closed gaps; mm. */
  readonly widest: number;
  readonly gaps: number;
  readonly closed: boolean;
  /** Points at which more than two curves meet. */
  readonly branches: readonly Pt[];
  readonly length: number;
}

const apart = (a: Pt, b: Pt) => Math.hypot(a.z - b.z, a.r - b.r);
/** The curve in reverse direction. */
export const turnedAround = (s: Segment): Segment =>
  s.kind === "line"
    ? { kind: "line", from: s.to, to: s.from }
    : { ...s, from: s.to, to: s.from, turn: s.turn === "cw" ? "ccw" : "cw" };

/** Ends of curves in a grid, so that near ones are found quickly. */
class Ends {
  private readonly squares = new Map<string, { index: number; start: boolean }[]>();
  private readonly curves: readonly Segment[];
  private readonly reach: number;

  constructor(curves: readonly Segment[], reach: number) {
    this.curves = curves;
    this.reach = Math.max(reach, SAME);
    curves.forEach((s, index) => {
      for (const start of [true, false]) {
        const key = this.key(start ? s.from : s.to, 0, 0);
        this.squares.set(key, [...(this.squares.get(key) ?? []), { index, start }]);
      }
    });
  }

  private key(p: Pt, dz: number, dr: number) {
    return `${Math.floor(p.z / this.reach) + dz} ${Math.floor(p.r / this.reach) + dr}`;
  }

  /** Ends of unused curves within the tolerance, the nearest first. */
  near(p: Pt, used: ReadonlySet<number>) {
    const found: { index: number; start: boolean; far: number }[] = [];
    for (const dz of [-1, 0, 1])
      for (const dr of [-1, 0, 1])
        for (const end of this.squares.get(this.key(p, dz, dr)) ?? []) {
          const s = this.curves[end.index];
          if (!s || used.has(end.index)) continue;
          const far = apart(end.start ? s.from : s.to, p);
          if (far <= this.reach) found.push({ ...end, far });
        }
    return found.sort((a, b) => a.far - b.far || a.index - b.index);
  }
}

/** Joins curves whose ends are no farther apart than the tolerance (mm) into chains, the longest first. */
export function chainsOf(curves: readonly Segment[], tolerance: number): DxfChain[] {
  const ends = new Ends(curves, tolerance),
    used = new Set<number>();
  const chains: DxfChain[] = [];
  const others = (index: number, p: Pt) => ends.near(p, used).filter((n) => n.index !== index);
  // Open ends first: a chain started in its middle would be split.
  const begin = (i: number): Segment | null => {
    const s = curves[i];
    if (!s) return null;
    if (others(i, s.from).length === 0) return s;
    return others(i, s.to).length === 0 ? turnedAround(s) : null;
  };
  for (const openOnly of [true, false])
    curves.forEach((s, i) => {
      if (used.has(i)) return;
      const first = openOnly ? begin(i) : s;
      if (!first) return;
      used.add(i);
      const segments = [first],
        branches: Pt[] = [];
      let widest = 0,
        gaps = 0;
      for (let last = first; ;) {
        const near = ends.near(last.to, used),
          [next] = near,
          found = next && curves[next.index];
        if (!next || !found) break;
        if (new Set(near.map((n) => n.index)).size > 1) branches.push(last.to);
        used.add(next.index);
        widest = Math.max(widest, next.far);
        if (next.far > SAME) gaps += 1;
        last = next.start ? found : turnedAround(found);
        segments.push(last);
      }
      const end = segments.at(-1)?.to;
      const closed = segments.length > 1 && end !== undefined && apart(end, first.from) <= Math.max(tolerance, SAME);
      chains.push({
        segments,
        widest,
        gaps,
        closed,
        branches,
        length: segments.reduce((sum, x) => sum + part.lengthOf(x), 0),
      });
    });
  return chains.sort((a, b) => b.length - a.length);
}
