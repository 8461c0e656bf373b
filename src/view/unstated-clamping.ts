import { at, type Pt, type Ring } from "../kernel/geometry/point.ts";
import type { Bounds } from "./camera.ts";

/**
 * The rear end of a blank with the drawing symbol for clamping: a plane with short lines behind it, without any
 * clamping device.
 */
export interface UnstatedClamping {
  /** The plane, from the axis or the bore to the outside. */
  readonly plane: readonly [Pt, Pt];
  readonly hatch: readonly (readonly [Pt, Pt])[];
}

/** Length of the short lines as a share of the radius, and its limits, mm; their number has limits for any blank. */
const LINES = { share: 0.18, least: 1, most: 12, fewest: 2, greatest: 60 } as const;

/** The plane at the rear end of a blank whose clamping is not stated. */
export function unstatedClamping(blank: readonly Ring[], { left, high }: Bounds): UnstatedClamping {
  const low = Math.min(
    high,
    ...blank
      .flat()
      .filter(({ z }) => z === left)
      .map(({ r }) => r),
  );
  const long = Math.min(LINES.most, Math.max(LINES.least, high * LINES.share)),
    count = Math.min(LINES.greatest, Math.max(LINES.fewest, Math.round((high - low) / long)));
  const apart = (high - low) / count,
    reach = Math.min(apart, 2 * LINES.most);
  return {
    plane: [at(left, low), at(left, high)],
    hatch: Array.from({ length: count }, (_, i) => {
      const r = low + (i + 1) * apart;
      return [at(left, r), at(left - reach, r - reach)] as const;
    }),
  };
}
