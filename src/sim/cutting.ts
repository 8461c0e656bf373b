import { difference, union } from "../kernel/clip.ts";
import type { Ring } from "../kernel/point.ts";
import { edgesOf } from "./edges.ts";
import type { Piece } from "./piece.ts";

/** Convex pieces, or merged groups of them, that are merged in one go. Many that overlap cost the square of their number. */
const GROUP = 8;

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
  /** Everything added so far: merged groups and single pieces. */
  swept(): Ring[];
  /** The stock now, less further pieces that are not kept. */
  stock(further?: readonly Piece[]): readonly Ring[];
}

/** Begins to cut a stock. */
export function cutting(initial: readonly Ring[]): Cutting {
  const edges = edgesOf(initial);
  /** levels[0] are single pieces; each entry of levels[n] is GROUP entries of levels[n - 1] merged. */
  const levels: Ring[][][] = [[]];
  let pieces = 0;

  function keep(entry: Ring[], level: number): void {
    const entries = (levels[level] ??= []);
    entries.push(entry);
    if (entries.length < GROUP) return;
    levels[level] = [];
    keep(union(entries.flat()), level + 1);
  }
  const swept = () => levels.flat(2);
  return {
    initial,
    get pieces() {
      return pieces;
    },
    add(more) {
      for (const piece of more) {
        if (!edges.meets(piece)) continue;
        pieces += 1;
        keep([piece.ring], 0);
      }
    },
    meets: (piece) => edges.meets(piece),
    swept,
    stock(further = []) {
      const gone = [...swept(), ...further.filter((piece) => edges.meets(piece)).map((piece) => piece.ring)];
      return gone.length === 0 ? initial : difference(initial, gone);
    },
  };
}
