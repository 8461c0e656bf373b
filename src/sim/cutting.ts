import { difference, union } from "../kernel/clip.ts";
import type { Ring } from "../kernel/point.ts";
import { edgesOf, type Edges } from "./edges.ts";
import type { Piece } from "./piece.ts";

/** Convex pieces, or merged groups of them, that are merged in one go. Many that overlap cost the square of their number. */
const GROUP = 8;
/** Pieces after which the stock that checks look at is brought up to date, and the part of its points that may wait beyond. */
const [RECENT, PART] = [48, 6];

/** Rings that are merged in groups of groups as they come. The same rings in the same order always give the same areas. */
function heap() {
  /** levels[0] are single rings; each entry of levels[n] is GROUP entries of levels[n - 1] merged. */
  const levels: Ring[][][] = [[]];
  function keep(entry: Ring[], level: number): void {
    const entries = (levels[level] ??= []);
    entries.push(entry);
    if (entries.length < GROUP) return;
    levels[level] = [];
    keep(union(entries.flat()), level + 1);
  }
  return { add: (ring: Ring) => keep([ring], 0), all: () => levels.flat(2) };
}

/** Convex rings as one area, merged group by group. */
export function merged(rings: readonly Ring[]): Ring[] {
  if (rings.length <= GROUP) return [...rings];
  const all = heap();
  rings.forEach(all.add);
  return all.all();
}

/** The stock at one moment: an area less what has been swept since that was made up. Later cuts do not change it. */
export interface Present {
  readonly base: readonly Ring[];
  readonly gone: readonly Ring[];
  /** False when a convex piece surely has no area in common with the base. */
  meets(piece: Piece): boolean;
}

/**
 * Stock that is being cut: the stock it began with, and what has been swept since, merged in groups of groups. The
 * same pieces added in the same order always give the same stock, to the last bit.
 */
export interface Cutting {
  /** The stock it began with. */
  readonly initial: readonly Ring[];
  /** Convex pieces added that met the stock. */
  readonly pieces: number;
  /** Takes away convex pieces. Those that do not meet the stock it began with are passed over. */
  add(pieces: readonly Piece[]): void;
  /** Whether a convex piece met the stock it began with. */
  meets(piece: Piece): boolean;
  /** The stock for checks, which ask it often: it is brought up to date now and then, so that little is left to take away. */
  present(): Present;
  /** The stock now, less further pieces that are not kept. */
  stock(further?: readonly Piece[]): readonly Ring[];
}

/** Begins to cut a stock. */
export function cutting(initial: readonly Ring[]): Cutting {
  const edges = edgesOf(initial);
  const swept = heap();
  let pieces = 0;
  let [base, baseEdges, recent, waiting]: [readonly Ring[], Edges, Ring[], number] = [initial, edges, [], 0];

  return {
    initial,
    get pieces() {
      return pieces;
    },
    add(more) {
      for (const piece of more) {
        if (!edges.meets(piece)) continue;
        pieces += 1;
        swept.add(piece.ring);
        recent.push(piece.ring);
        waiting += 1;
      }
    },
    meets: (piece) => edges.meets(piece),
    present() {
      if (recent.length > GROUP) recent = merged(recent);
      if (waiting > RECENT + base.reduce((sum, ring) => sum + ring.length, 0) / PART) {
        base = difference(base, recent);
        [baseEdges, recent, waiting] = [edgesOf(base), [], 0];
      }
      const [known, gone] = [baseEdges, [...recent]];
      return { base, gone, meets: (piece) => known.meets(piece) };
    },
    stock(further = []) {
      const gone = [...swept.all(), ...further.filter((piece) => edges.meets(piece)).map((piece) => piece.ring)];
      return gone.length === 0 ? initial : difference(initial, gone);
    },
  };
}
