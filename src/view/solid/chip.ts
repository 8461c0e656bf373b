import type { Chip } from "../../sim/chip/chip.ts";
import { trianglesOf } from "./fill.ts";

/** Offset of a chip above the face of the insert, mm, so that both remain visible. */
const OVER = 0.02;

/**
 * A chip as a filled area in the working plane of the tool, relative to the tip, and its cutting edge in pieces. mm.
 */
export interface ChipInSpace {
  readonly positions: Float32Array;
  readonly index: Uint32Array;
  /** x, y and z of both ends of each piece. */
  readonly contact: Float32Array;
}

/** The area of a chip and its edge in contact in space. */
export function chipInSpace({ rings, contact }: Pick<Chip, "rings" | "contact">): ChipInSpace {
  return {
    positions: Float32Array.from(rings.flat().flatMap(({ z, r }) => [r, OVER, z])),
    index: Uint32Array.from(trianglesOf(rings)),
    contact: Float32Array.from(
      contact.flatMap((line) =>
        line.slice(1).flatMap((to, i) => {
          const from = line[i] ?? to;
          return [from.r, OVER, from.z, to.r, OVER, to.z];
        }),
      ),
    ),
  };
}
