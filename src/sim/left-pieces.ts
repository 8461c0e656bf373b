import type { Ring } from "../kernel/geometry/point.ts";
import { regionsOf } from "./region.ts";
import type { Simulation } from "./simulation.ts";

/** The pieces at the end of a run, each an outline with its cavities. */
export interface LeftPieces {
  /** The piece in the chuck; null where nothing is left. */
  readonly held: readonly Ring[] | null;
  /** Pieces that came off, the largest first. */
  readonly off: readonly (readonly Ring[])[];
}

/** Smallest area of a piece; anything smaller is a chip or a skin, mm². */
const PIECE = 1;

export function leftPieces({ final, proof }: Pick<Simulation, "final" | "proof">): LeftPieces {
  const [held] = regionsOf(final, PIECE).toSorted((a, b) => b.area - a.area);
  const off = proof.loose.filter(({ area }) => area > PIECE).toSorted((a, b) => b.area - a.area);
  return { held: held ? [held.outline, ...held.holes] : null, off: off.map(({ rings }) => rings) };
}
