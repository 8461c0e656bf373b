import { difference, union } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { sidesOf, type Edges } from "./edges.ts";
import type { ConvexPiece } from "./piece.ts";
import type { Sweep } from "./sweep.ts";

/** Rings, or merged groups of rings, per merge. The cost is the square of their number where many overlap. */
const GROUP = 4;
/** Swept points that may be pending before they are subtracted, in addition to the points of the stock. */
const RECENT = 40;

/** Merges rings in groups of groups as they arrive. The same rings in the same order always give the same areas. */
function heap(levels: Ring[][][] = [[]]) {
  /** levels[0] are single rings; each entry of levels[n] is GROUP entries of levels[n - 1] merged. */
  function keep(entry: Ring[], level: number): void {
    const entries = (levels[level] ??= []);
    entries.push(entry);
    if (entries.length < GROUP) return;
    levels[level] = [];
    keep(union(entries.flat()), level + 1);
  }
  return {
    add: (ring: Ring) => keep([ring], 0),
    all: () => levels.flat(2),
    copy: () => heap(levels.map((entries) => [...entries])),
  };
}

/** Rings as one area, merged group by group. */
export function merged(rings: readonly Ring[]): Ring[] {
  if (rings.length <= GROUP) return [...rings];
  const all = heap();
  rings.forEach(all.add);
  return all.all();
}

/** The stock at one moment: a base area less the sweeps since it was computed. Later cuts do not change it. */
export interface Present {
  readonly base: readonly Ring[];
  readonly gone: readonly Ring[];
  /** False when a convex piece surely has no area in common with the base. */
  meets(piece: ConvexPiece): boolean;
}

/** The last query: check, measurement and cut ask for the same rings one after the other. */
let asked: { readonly sweep: Sweep; readonly by: Present["meets"]; readonly rings: readonly Ring[] } | null = null;

/** The rings of the parts of a sweep that may meet a stock. */
export function ringsMeeting(sweep: Sweep, meets: Present["meets"]): readonly Ring[] {
  if (asked?.sweep === sweep && asked.by === meets) return asked.rings;
  const met = sweep.pieces.filter(meets);
  const rings = met.length < 2 ? met.map((piece) => piece.ring) : sweep.rings;
  asked = { sweep, by: meets, rings };
  return rings;
}

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

/** The state of a stock being cut. */
interface CuttingState {
  readonly initial: readonly Ring[];
  readonly base: readonly Ring[];
  readonly edges: Edges;
  readonly recent: ReturnType<typeof heap>;
  readonly pendingPoints: number;
  readonly pieces: number;
}

/** Starts cutting a stock. */
export const cutting = (initial: readonly Ring[]): Cutting =>
  cuttingOn({ initial, base: initial, edges: sidesOf(initial), recent: heap(), pendingPoints: 0, pieces: 0 });

function cuttingOn({ initial, ...from }: CuttingState): Cutting {
  let { base, edges, recent, pendingPoints, pieces } = from;
  let now: Present | null = null;
  /** The present stock, cached until the next cut. */
  let standing: readonly Ring[] | null = null;

  return {
    initial,
    get pieces() {
      return pieces;
    },
    add(sweep) {
      const rings = ringsMeeting(sweep, edges.meets);
      if (rings.length === 0) return;
      now = null;
      standing = null;
      pieces += sweep.pieces.length;
      rings.forEach(recent.add);
      pendingPoints += pointsOf(rings);
      if (pendingPoints <= RECENT + pointsOf(base)) return;
      base = difference(base, recent.all());
      [edges, recent, pendingPoints] = [sidesOf(base), heap(), 0];
    },
    present() {
      now ??= { base, gone: recent.all(), meets: edges.meets };
      return now;
    },
    stock(further) {
      const more = further ? ringsMeeting(further, edges.meets) : [];
      if (more.length > 0) return difference(base, [...recent.all(), ...more]);
      if (!standing) {
        const gone = recent.all();
        standing = gone.length === 0 ? base : difference(base, gone);
      }
      return standing;
    },
    copy: () => cuttingOn({ initial, base, edges, recent: recent.copy(), pendingPoints, pieces }),
  };
}
