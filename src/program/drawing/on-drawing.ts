import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { opposite } from "../../kernel/geometry/segments.ts";
import type { ContourChoice } from "./drawing.ts";
import { backPlacingOf } from "./halves.ts";

/** Coordinate along the axis of rotation and across it, mm of the drawing. */
export const alongAxis = ({ axis }: Pick<ContourChoice, "axis">, p: Pt): number => (axis === "x" ? p.z : p.r);
export const acrossAxis = ({ axis }: Pick<ContourChoice, "axis">, p: Pt): number => (axis === "x" ? p.r : p.z);
/** The point with these coordinates along and across the axis. */
export const fromAxis = ({ axis }: Pick<ContourChoice, "axis">, along: number, across: number): Pt =>
  axis === "x" ? at(along, across) : at(across, along);

/** Distance of chords from arcs that are ellipses on the drawing, mm. */
const CHORDS = 0.05;

/**
 * Each segment of the part where a choice has it on the drawing. With X drawn as a diameter, arcs are ellipses there and
 * become chords.
 */
export function segmentsOnDrawing(choice: ContourChoice, segments: readonly Segment[]): Segment[][] {
  const put = backPlacingOf(choice);
  const turnsOver = [choice.mirrored, choice.half === "lower", choice.axis === "y"].filter(Boolean).length % 2 === 1;
  return segments.map((s): Segment[] => {
    if (s.kind === "line") return [part.line(put(s.from), put(s.to))];
    if (choice.diameters) {
      const points = part.flattened(s, CHORDS).map(put);
      return points.slice(1).map((to, i) => part.line(points[i] ?? to, to));
    }
    const turn = turnsOver ? opposite(s.turn) : s.turn;
    return [{ kind: "arc", from: put(s.from), to: put(s.to), centre: put(s.centre), turn }];
  });
}
