import { extent, type Convex } from "../reach/convex.ts";
import { aboveBy, besideAt, loweredBy, pieceOf, raised } from "../reach/cut-envelope.ts";
import {
  highest,
  higherOf,
  linePiece,
  type Envelope,
  type EnvelopePiece,
  type Interval,
  type Origin,
} from "../reach/envelope.ts";
import { toFlat, type Flat, type FlatSegment, type Frame } from "../geometry/flat.ts";
import type { Ring } from "../geometry/point.ts";
import { reachOver, type Bound } from "../reach/reach.ts";
import { ROUND, SAME } from "../tolerance.ts";

const CUT: Origin = { feature: "nose", on: "edge", corner: false };

/**
 * The material that still stands, as the tool meets it: for every u the height of the tip from which on the insert is
 * clear of it. At first the blank, or the area where no blank is known; every cut lowers it. Strategy space, mm.
 */
export class Frontier {
  private settled: Envelope;
  /** What has been cut since: a path is taken off in one go when somebody asks. */
  private cuts: EnvelopePiece[] = [];
  /** Between which heights the tip went straight up or down: free for it in that very column. */
  private readonly columns = new Map<number, readonly [low: number, top: number]>();
  private readonly before: number;
  private readonly behind: number;
  private readonly height: number;

  /**
   * `first`: what stands at the beginning. `roof`: height above which nothing may be cut although material stands there
   * (a machining limit); without one Infinity.
   */
  constructor(
    private readonly first: Envelope,
    insert: Convex,
    private readonly roof = Infinity,
  ) {
    this.settled = first;
    [this.behind, this.before] = overhang(insert);
    const { minV, maxV } = extent(insert);
    this.height = maxV - minV;
  }

  /** Highest tip position between two places (the ends aside) at which material may stand; −∞ in air. */
  over(u0: number, u1: number): number {
    const [a, b] = [Math.min(u0, u1) + SAME, Math.max(u0, u1) - SAME];
    return b > a ? Math.min(this.roof, highest(this.now, a, b).v) : -Infinity;
  }

  /**
   * Whether the tip, standing free at u0, may cross to u1 at a height without touching what stands. A wall in front of
   * u1 that a cut lower down has left may hang over there; one behind u0 only falls back.
   */
  clear(u0: number, u1: number, v: number): boolean {
    if (v < this.over(u0, u1) - SAME || this.roofed(Math.min(u0, u1), Math.max(u0, u1))) return false;
    const [low, top] = this.columns.get(columnOf(u1)) ?? [Infinity, -Infinity];
    if (v <= besideAt(this.now, u1) + SAME || (v >= low - SAME && v <= top + SAME)) return true;
    return v >= this.hangs(u1, u1 > u0 ? 0 : this.behind, u1 > u0 ? this.before : 0) - SAME;
  }

  /**
   * The height from which on the tip may go straight up or down. Beside a wall that a cut has left, an edge that leans
   * back from the nose has left more than the nose shows, so the wall counts there too.
   */
  freeFrom(u: number): number {
    if (this.roofed(u, u)) return Infinity;
    const beside = besideAt(this.now, u);
    const [low, top] = this.columns.get(columnOf(u)) ?? [Infinity, -Infinity];
    // A column that ends under what an insert lower than its cut has left standing leads nowhere.
    return Math.max(top >= beside - SAME ? Math.min(beside, low) : beside, this.hangs(u, this.behind, this.before));
  }

  /** How high walls stand that hang over a place from so far behind and before it, where something stood there once. */
  private hangs(u: number, behind: number, before: number): number {
    return behind + before > 0
      ? Math.min(besideAt(this.first, u), highest(this.now, u - behind, u + before).v)
      : -Infinity;
  }

  /** Between which places material stands more than `by` mm over an envelope; null where none does. */
  standsOver(e: Envelope, { from, to }: Interval, by: number): Interval | null {
    const above = aboveBy(this.now, e, from, to, by);
    const [first, last] = [above[0], above.at(-1)];
    return first && last ? { from: first.from, to: last.to } : null;
  }

  /** The tool stands there at the call: it came from above, so the way it came is free. */
  cameDown({ u, v }: Flat): void {
    this.columns.set(columnOf(u), [v, Infinity]);
  }

  /** Lowers the frontier by one element that the tip has run at feed. */
  lower(path: FlatSegment): void {
    const piece = pieceOf(path, CUT);
    if (piece) {
      if (!this.roofed(piece.u0, piece.u1)) this.cuts.push(piece);
    } else {
      const key = columnOf(path.to.u);
      const [low, top] = [Math.min(path.from.v, path.to.v), Math.max(path.from.v, path.to.v)];
      const been = this.columns.get(key) ?? [low, top];
      const joins = low <= been[1] && been[0] <= top;
      this.columns.set(
        key,
        joins ? [Math.min(low, been[0]), Math.max(top, been[1])] : low < been[0] ? [low, top] : been,
      );
    }
  }

  private get now(): Envelope {
    for (const run of sideBySide(this.cuts)) this.settled = loweredBy(this.settled, run, this.height);
    this.cuts = [];
    return this.settled;
  }

  private roofed(u0: number, u1: number): boolean {
    return this.roof < Infinity && highest(this.first, u0, u1).v > this.roof + SAME;
  }
}

const columnOf = (u: number) => Math.round(u / SAME);

/** Pieces in runs that go from left to right or from right to left, each run from left to right. */
function sideBySide(cuts: readonly EnvelopePiece[]): EnvelopePiece[][] {
  const runs: EnvelopePiece[][] = [];
  for (const cut of cuts) {
    const run = runs.at(-1);
    const [first, last] = [run?.[0], run?.at(-1)];
    if (run && last && cut.u0 >= last.u1 - ROUND) run.push(cut);
    else if (run && first && cut.u1 <= first.u0 + ROUND) run.unshift(cut);
    else runs.push([cut]);
  }
  return runs;
}

/** How far the insert draws back above its widest place, behind and before the tip, mm. */
function overhang(insert: Convex): [behind: number, before: number] {
  const { minU, maxU, maxV } = extent(insert);
  const top = insert
    .flatMap((e) => (e.kind === "line" ? [e.from, e.to] : [{ u: e.centre.u, v: e.centre.v + e.radius }]))
    .filter((p) => p.v > maxV - SAME);
  const us = top.map((p) => p.u);
  return [Math.max(0, Math.min(...us) - minU), Math.max(0, maxU - Math.max(...us))];
}

/** What stands in front of a tool: chains of material (on the right of their direction), as its tip meets them. */
function standing(chains: readonly (readonly FlatSegment[])[], insert: Convex): Envelope {
  return chains
    .filter((c) => c.length > 0)
    .map((c) =>
      reachOver(
        c.map((segment): Bound => ({ segment, on: "edge" })),
        insert,
      ),
    )
    .reduce<Envelope>((all, e) => (all.length === 0 ? e : higherOf(all, e)), []);
}

/** A closed outline as a chain with its inside on the right, closed beyond its first corner. */
function outlineChain(points: readonly Flat[]): FlatSegment[] {
  const twice = points.reduce((sum, p, i) => {
    const q = points[(i + 1) % points.length] as Flat;
    return sum + p.u * q.v - q.u * p.v;
  }, 0);
  const clockwise = twice > 0 ? [...points].reverse() : points;
  const lines = clockwise.map((from, i): FlatSegment => ({
    kind: "line",
    from,
    to: clockwise[(i + 1) % clockwise.length] as Flat,
  }));
  return lines.length > 0 ? [...lines, lines[0] as FlatSegment] : [];
}

/**
 * The frontier at the call of a cycle: the part under the blank. Where earlier cuts have changed the blank nobody knows
 * how: then roughing takes the area (`area`, corners in strategy space) to be full, and finishing expects what roughing
 * with the same values leaves, which is the contour grown by the oversize and at the most one infeed, up to the height
 * (`top`) that roughing begins at.
 */
export function atCall(
  o: {
    readonly stock: readonly Ring[] | null;
    readonly area: readonly Flat[];
    readonly frame: Frame;
    readonly insert: Convex;
  },
  part: Envelope,
  roughed: { readonly grown: Envelope; readonly infeed: number; readonly top?: number } | null,
): Envelope {
  if (o.stock === null && roughed) {
    const us = o.area.map((p) => p.u);
    const [from, to] = [Math.min(...us), Math.max(...us)];
    const left = raised(roughed.grown, from, to, roughed.infeed);
    const most =
      roughed.top === undefined ? null : linePiece({ u: from, v: roughed.top }, { u: to, v: roughed.top }, CUT);
    return higherOf(higherOf(part, roughed.grown), most ? loweredBy(left, [most], Infinity) : left);
  }
  const rings = o.stock === null ? [o.area] : o.stock.map((ring) => ring.map((p) => toFlat(o.frame, p)));
  // The work turns: an insert that is past the axis meets the material of the other side there.
  const turned = o.frame.transverse ? rings.map((ring) => ring.map(({ u, v }): Flat => ({ u: -u, v }))) : [];
  return higherOf(part, standing([...rings, ...turned].map(outlineChain), o.insert));
}
