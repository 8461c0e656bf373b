import { boxAround } from "../../kernel/area/box.ts";
import type { Clamped } from "../../kernel/area/clamping.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { scanCrossings } from "../../sim/scan.ts";
import type { HeldWorkpiece } from "./stability.ts";

/** Places at which the section of the workpiece is taken. */
const SECTIONS = 48;

/**
 * The free part of a stock in its clamping, as a plain bar of the same stiffness: its sections count by the square of
 * their bending moment, so that a thin pin at the free end counts less than one at the jaws. Null without a clamping, or
 * where nothing sticks out of it.
 */
export function heldWorkpiece(stock: readonly Ring[], clamped: Clamped | null): HeldWorkpiece | null {
  if (!clamped || stock.length === 0) return null;
  const { kind, face, tailstock } = clamped.clamping;
  const support = kind === "centres" ? "centres" : tailstock ? "chuckAndCentre" : "chuck";
  const { left, right } = boxAround(stock);
  const from = Math.max(left, face);
  const overhang = right - from;
  if (!(overhang > 0)) return null;
  const places = Array.from({ length: SECTIONS }, (_, i) => from + ((i + 0.5) / SECTIONS) * overhang);
  let [weights, compliance] = [0, 0];
  scanCrossings(stock, "r", places).forEach((crossings, i) => {
    const [inner = 0, outer = 0] = [crossings[0], crossings.at(-1)].map((r) => Math.max(0, r ?? 0));
    const moment = outer ** 4 - inner ** 4;
    const weight = support === "chuck" ? (right - (places[i] ?? 0)) ** 2 : 1;
    if (!(moment > 0)) return;
    weights += weight;
    compliance += weight / moment;
  });
  if (compliance === 0) return null;
  return { overhang, diameter: toDiameter(radius((weights / compliance) ** (1 / 4))), support };
}
