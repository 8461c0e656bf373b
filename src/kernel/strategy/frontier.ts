import { extent, type Convex } from "../reach/convex.ts";
import { intervalsAbove, lowerSideAt, withCuts, pieceOf, raisedSection } from "../reach/cut-envelope.ts";
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
 * The remaining stock as the tool meets it: for every u the lowest height of the tip at which the insert is clear.
 * Initially the blank, or the area where no blank is known; every cut lowers it. Strategy space, mm.
 */
export class Frontier {
  private settled: Envelope;
  /** Pending cuts, applied to the envelope together on the next read. */
  private cuts: EnvelopePiece[] = [];
  /** Heights between which the tip moved vertically: it may do so again in exactly that column. */
  private readonly columns = new Map<number, readonly [low: number, top: number]>();
  private readonly before: number;
  private readonly behind: number;
  private readonly height: number;

  /**
   * `first`: the initial stock. `roof`: a machining limit, above which nothing may be cut although there is material;
   * Infinity without one.
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

  /** Highest tip position between two places (without the ends) that may meet material; −∞ in air. */
  over(u0: number, u1: number): number {
    const [a, b] = [Math.min(u0, u1) + SAME, Math.max(u0, u1) - SAME];
    return b > a ? Math.min(this.roof, highest(this.now, a, b).v) : -Infinity;
  }

  /**
   * Whether the tip, clear at u0, may cross to u1 at a height without touching the stock. A wall in front of u1, left
   * by a deeper cut, may overhang there; one behind u0 only recedes.
   */
  canCross(u0: number, u1: number, v: number): boolean {
    if (v < this.over(u0, u1) - SAME || this.isRoofed(Math.min(u0, u1), Math.max(u0, u1))) return false;
    const [low, top] = this.columns.get(columnOf(u1)) ?? [Infinity, -Infinity];
    if (v <= lowerSideAt(this.now, u1) + SAME || (v >= low - SAME && v <= top + SAME)) return true;
    return v >= this.overhangHeight(u1, u1 > u0 ? 0 : this.behind, u1 > u0 ? this.before : 0) - SAME;
  }

  /**
   * The height above which the tip may move vertically. Next to a wall left by a cut, an insert edge that recedes from
   * the nose has left more material than the nose shows, so the wall counts there too.
   */
  freeFrom(u: number): number {
    if (this.isRoofed(u, u)) return Infinity;
    const beside = lowerSideAt(this.now, u);
    const [low, top] = this.columns.get(columnOf(u)) ?? [Infinity, -Infinity];
    // A column that ends below material left by an insert lower than its cut leads nowhere.
    return Math.max(
      top >= beside - SAME ? Math.min(beside, low) : beside,
      this.overhangHeight(u, this.behind, this.before),
    );
  }

  /**
   * Height of walls that overhang a place, from within a distance behind and before it, if there was material at the
   * place.
   */
  private overhangHeight(u: number, behind: number, before: number): number {
    return behind + before > 0
      ? Math.min(lowerSideAt(this.first, u), highest(this.now, u - behind, u + before).v)
      : -Infinity;
  }

  /** The interval where the stock is more than `by` mm above an envelope; null if there is none. */
  stockAbove(e: Envelope, { from, to }: Interval, by: number): Interval | null {
    const above = intervalsAbove(this.now, e, from, to, by);
    const [first, last] = [above[0], above.at(-1)];
    return first && last ? { from: first.from, to: last.to } : null;
  }

  /** Marks the column above the tool position at the call as free, because the tool came down there. */
  openColumn({ u, v }: Flat): void {
    this.columns.set(columnOf(u), [v, Infinity]);
  }

  /** Lowers the frontier by one element cut at feed. */
  lower(path: FlatSegment): void {
    const piece = pieceOf(path, CUT);
    if (piece) {
      if (!this.isRoofed(piece.u0, piece.u1)) this.cuts.push(piece);
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
    for (const run of monotonicRuns(this.cuts)) this.settled = withCuts(this.settled, run, this.height);
    this.cuts = [];
    return this.settled;
  }

  private isRoofed(u0: number, u1: number): boolean {
    return this.roof < Infinity && highest(this.first, u0, u1).v > this.roof + SAME;
  }
}

const columnOf = (u: number) => Math.round(u / SAME);

/** Groups pieces into runs that go only left or only right; each run is sorted from left to right. */
function monotonicRuns(cuts: readonly EnvelopePiece[]): EnvelopePiece[][] {
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

/** Horizontal distance from the insert's top to its widest places, behind and before the tip, mm. */
function overhang(insert: Convex): [behind: number, before: number] {
  const { minU, maxU, maxV } = extent(insert);
  const top = insert
    .flatMap((e) => (e.kind === "line" ? [e.from, e.to] : [{ u: e.centre.u, v: e.centre.v + e.radius }]))
    .filter((p) => p.v > maxV - SAME);
  const us = top.map((p) => p.u);
  return [Math.max(0, Math.min(...us) - minU), Math.max(0, maxU - Math.max(...us))];
}

/** The stock in front of a tool as tip positions: chains of material (on the right of their direction). */
function stockEnvelope(chains: readonly (readonly FlatSegment[])[], insert: Convex): Envelope {
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
 * The frontier at the call of a cycle: the part and the blank above it. If earlier cuts have changed the blank, its
 * state is unknown: then roughing assumes the full area (`area`, corners in strategy space), and finishing the state
 * after roughing with the same values: the contour grown by the oversize and at most one infeed, up to the height
 * (`top`) that roughing begins at.
 */
export function envelopeAtCall(
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
    const left = raisedSection(roughed.grown, from, to, roughed.infeed);
    const most =
      roughed.top === undefined ? null : linePiece({ u: from, v: roughed.top }, { u: to, v: roughed.top }, CUT);
    return higherOf(higherOf(part, roughed.grown), most ? withCuts(left, [most], Infinity) : left);
  }
  const rings = o.stock === null ? [o.area] : o.stock.map((ring) => ring.map((p) => toFlat(o.frame, p)));
  // The workpiece rotates: an insert past the axis meets the material of the other side.
  const turned = o.frame.transverse ? rings.map((ring) => ring.map(({ u, v }): Flat => ({ u: -u, v }))) : [];
  return higherOf(part, stockEnvelope([...rings, ...turned].map(outlineChain), o.insert));
}
