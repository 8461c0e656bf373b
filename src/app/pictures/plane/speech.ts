import type { Lengths } from "../../../i18n/lengths.ts";
import { plane, type PlanePoint } from "../../../kernel/plane/plane.ts";
import { radius, toDiameter } from "../../../kernel/units.ts";
import type { WorkingPlane } from "../../../program/motion/approach-fields.ts";
import type { ApproachWords } from "../../../view/approach/words.ts";

const { sum } = plane;

/**
 * Number texts of a plane's picture: X and Y of a mill; X as diameter and Z in turning. `tip`: offset of the programmed
 * point.
 */
export function approachSpeech(lengths: Lengths, plane: WorkingPlane, tip: PlanePoint): ApproachWords {
  const signed = (n: number) => lengths.signed(n).replace("-", "−");
  const contour = (at: PlanePoint) =>
    plane === "ZX"
      ? `X⌀${lengths.number(toDiameter(radius(at.y)))} Z${signed(at.x)}`
      : `X${signed(at.x)} Y${signed(at.y)}`;
  return {
    number: (n) => lengths.number(n).replace("-", "−"),
    point: (p) => contour(sum(p, tip)),
    contour,
  };
}
