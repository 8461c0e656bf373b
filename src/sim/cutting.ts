import { difference, union } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { sidesOf, type Edges } from "./edges.ts";
import type { ConvexPiece } from "./piece.ts";
import { ringsAlong, wayOn, type Sweep, type Way } from "./sweep.ts";

/** Rings, or merged groups of rings, per merge. The cost is the square of their number where many overlap. */
const GROUP = 4;
/** Swept points that may be pending before they are subtracted, in addition to the points of the stock. */
const RECENT = 40;
/** Points of a way from which on it is not lengthened. */
const MOST_LINKED = 32;

/** Rings merged in groups of groups: [0] are single rings, each entry of [n] is GROUP entries of [n - 1] merged. */
type Pile = readonly (readonly (readonly Ring[])[])[];

/** A pile with another entry. The same rings in the same order always give the same areas. */
function piled(pile: Pile, entry: readonly Ring[], level = 0): Pile {
  const entries = [...(pile[level] ?? []), entry];
  const isFull = entries.length === GROUP;
  const next = [...pile.slice(0, level), isFull ? [] : entries, ...pile.slice(level + 1)];
  return isFull ? piled(next, union(entries.flat()), level + 1) : next;
}

/** Rings as one area, merged group by group. */
export function merged(rings: readonly Ring[]): Ring[] {
  if (rings.length <= GROUP) return [...rings];
  return rings.reduce<Pile>((pile, ring) => piled(pile, [ring]), []).flat(2);
}

/** The stock at one moment: a base area less the sweeps since it was computed. Later cuts do not change it. */
export interface Present {
  readonly base: readonly Ring[];
  readonly gone: readonly Ring[];
  /** False when a convex piece surely has no area in common with the base. */
  meets(piece: ConvexPiece): boolean;
}

/** A present stock whose recent sweeps are merged only where somebody asks for them. */
class Standing implements Present {
  constructor(
    readonly base: readonly Ring[],
    readonly meets: Present["meets"],
    private readonly recent: Recent,
  ) {}
  get gone(): readonly Ring[] {
    return this.recent.rings();
  }
}

/** The last query: check, measurement and cut ask for the same pieces one after the other. */
let asked: { readonly sweep: Sweep; readonly by: Present["meets"]; readonly met: readonly ConvexPiece[] } | null = null;

/** The pieces of a sweep that may meet a stock. */
export function piecesMeeting(sweep: Sweep, meets: Present["meets"]): readonly ConvexPiece[] {
  if (asked?.sweep !== sweep || asked.by !== meets) asked = { sweep, by: meets, met: sweep.pieces.filter(meets) };
  return asked.met;
}

/** The rings of the parts of a sweep that may meet a stock. */
export const ringsMeeting = (sweep: Sweep, meets: Present["meets"]): readonly Ring[] =>
  ringsOf(sweep, piecesMeeting(sweep, meets));
const ringsOf = (sweep: Sweep, met: readonly ConvexPiece[]): readonly Ring[] =>
  met.length < 2 ? met.map((piece) => piece.ring) : sweep.rings;

const pointsOf = (rings: readonly Ring[]) => rings.reduce((sum, ring) => sum + ring.length, 0);

/**
 * Stock being cut: a base area, and the sweeps since it was computed. The base is recomputed after a number of swept
 * points, so that little is pending at each query. The same sweeps in the same order always give the same stock, to the
 * last bit.
 */
export interface Cutting {
  /** The initial stock. */
  readonly initial: readonly Ring[];
  /** Convex pieces of the sweeps that met the stock. */
  readonly pieces: number;
  /** Subtracts a sweep; parts that do not meet the stock are skipped. */
  add(sweep: Sweep): void;
  /** The stock for checks. */
  present(): Present;
  /** The stock now, less a further sweep that is not kept. */
  stock(further?: Sweep): readonly Ring[];
  /** An independent copy of the present state. */
  copy(): Cutting;
}

/**
 * The sweeps since the base was computed: a pile, and the last sweep. Sweeps that go on from one another are one way: it
 * has far fewer points than they have, and crosses itself instead of overlapping.
 */
class Recent {
  private closed: Pile | null = null;
  private flat: readonly Ring[] | null = null;
  private constructor(
    private readonly pile: Pile,
    /** Swept points; a way counts two for each chord. */
    readonly points: number,
    private readonly way: Way | null,
    /** The sweep and its pieces that meet the stock; null where the way is longer than it. */
    private readonly alone: { readonly sweep: Sweep; readonly met: readonly ConvexPiece[] } | null,
  ) {}
  static readonly none = new Recent([], 0, null, null);

  rings(): readonly Ring[] {
    return (this.flat ??= this.whole().flat(2));
  }
  with(sweep: Sweep, met: readonly ConvexPiece[]): Recent {
    const { way, points } = this,
      next = sweep.way ?? null;
    const more = points + (next ? 2 * (next.points.length - 1) : pointsOf(sweep.rings));
    const longer = way && next && way.points.length < MOST_LINKED ? wayOn(way, next) : null;
    return longer
      ? new Recent(this.pile, more, longer, null)
      : new Recent(this.whole(), more + (next?.outline.length ?? 0), next, { sweep, met });
  }
  /** The pile with the last sweep or way. */
  private whole(): Pile {
    if (this.closed) return this.closed;
    const { alone, way } = this;
    const last = alone ? ringsOf(alone.sweep, alone.met) : way ? ringsAlong(way) : [];
    return (this.closed = last.reduce((all, ring) => piled(all, [ring]), this.pile));
  }
}

/** The state of a stock being cut. */
interface CuttingState {
  readonly initial: readonly Ring[];
  readonly base: readonly Ring[];
  readonly edges: Edges;
  readonly recent: Recent;
  readonly pieces: number;
}

/** Starts cutting a stock. */
export const cutting = (initial: readonly Ring[]): Cutting =>
  cuttingOn({ initial, base: initial, edges: sidesOf(initial), recent: Recent.none, pieces: 0 });

function cuttingOn({ initial, ...from }: CuttingState): Cutting {
  let { base, edges, recent, pieces } = from;
  let now: Present | null = null;
  /** The present stock, cached until the next cut. */
  let standing: readonly Ring[] | null = null;

  return {
    initial,
    get pieces() {
      return pieces;
    },
    add(sweep) {
      const met = piecesMeeting(sweep, edges.meets);
      if (met.length === 0) return;
      now = null;
      standing = null;
      pieces += sweep.pieces.length;
      recent = recent.with(sweep, met);
      if (recent.points <= RECENT + pointsOf(base)) return;
      base = difference(base, recent.rings());
      [edges, recent] = [sidesOf(base), Recent.none];
    },
    present() {
      now ??= new Standing(base, edges.meets, recent);
      return now;
    },
    stock(further) {
      const more = further ? ringsMeeting(further, edges.meets) : [];
      if (more.length > 0) return difference(base, [...recent.rings(), ...more]);
      if (!standing) {
        const gone = recent.rings();
        standing = gone.length === 0 ? base : difference(base, gone);
      }
      return standing;
    },
    copy: () => cuttingOn({ initial, base, edges, recent, pieces }),
  };
}
