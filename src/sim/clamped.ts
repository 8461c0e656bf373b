import { boxAround } from "../kernel/box.ts";
import type { Ring } from "../kernel/point.ts";
import { regionsOf } from "./region.ts";
import type { Simulation } from "./simulation.ts";

/** What stands at the end of a run, piece by piece: each an outline with its cavities. */
export interface LeftPieces {
  /** The piece in the chuck: it reaches farthest back. Null where nothing is left. */
  readonly held: readonly Ring[] | null;
  /** Pieces that do not hang together with it, the largest first. */
  readonly off: readonly (readonly Ring[])[];
}

/** Less is no piece but a chip or a skin, mm². */
const PIECE = 1;

/** The pieces that a run leaves. */
export function leftPieces({ final }: Pick<Simulation, "final">): LeftPieces {
  const pieces = regionsOf(final, PIECE).toSorted((a, b) => b.area - a.area).map(({ outline, holes }) => [outline, ...holes]);
  const back = (piece: readonly Ring[]) => boxAround([...piece]).left;
  const held = pieces.reduce<readonly Ring[] | null>((best, piece) => (best && back(best) <= back(piece) ? best : piece), null);
  return { held, off: pieces.filter((piece) => piece !== held) };
}
