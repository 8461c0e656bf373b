import { ARC_END, ROUND, SAME } from "../tolerance.ts";
import { roundedUp } from "../units.ts";
import { signOf, type SegmentOf, type Segments, type Turn } from "./segments.ts";
import type { Vectors } from "./vectors.ts";

/** Arcs that a program states without a centre. */
export function arcFormsOf<P>(v: Vectors<P>, { direction, line }: Segments<P>) {
  const { beyond, cross, difference, dot, leftOf, sizeOf } = v;

  /**
   * An arc by its end, radius (mm; negative: the longer arc) and turn. If the radius cannot span the two points,
   * `nearest` is the smallest one that can, on the grid a control prints.
   */
  function arcByRadius(
    from: P,
    to: P,
    radius: number,
    turn: Turn,
  ): { readonly segment: SegmentOf<P> | null; readonly nearest: number } {
    const way = difference(to, from);
    const chord = sizeOf(way);
    const nearest = roundedUp(chord / 2) * (radius < 0 ? -1 : 1);
    if (chord <= SAME || chord / 2 - Math.abs(radius) > ARC_END / 2) return { segment: null, nearest };
    const height = Math.sqrt(Math.max(0, radius * radius - (chord * chord) / 4));
    const side = (signOf(turn) * Math.sign(radius) * height) / chord;
    return {
      segment: { kind: "arc", from, to, centre: beyond(beyond(from, way, 1 / 2), leftOf(way), side), turn },
      nearest,
    };
  }

  /** The arc (or line) that continues a segment tangentially and ends in `to`; null when it would have to turn back. */
  function arcTangential(before: SegmentOf<P>, to: P): SegmentOf<P> | null {
    const from = before.to;
    const way = direction(before, from);
    const chord = difference(to, from);
    const [aside, square] = [cross(way, chord), dot(chord, chord)];
    if (Math.abs(aside) <= ROUND * Math.max(1, square)) return dot(way, chord) > 0 ? line(from, to) : null;
    const k = square / (2 * aside);
    return { kind: "arc", from, to, centre: beyond(from, leftOf(way), k), turn: k > 0 ? "ccw" : "cw" };
  }

  return { arcByRadius, arcTangential };
}
