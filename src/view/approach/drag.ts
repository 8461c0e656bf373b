import type { Approach, PointName } from "../../kernel/plane/approach.ts";
import { plane, type PlanePoint } from "../../kernel/plane/plane.ts";
import { inDegrees, rounded } from "../../kernel/units.ts";

const { cross, difference, dot, leftOf, scaled } = plane;

/** A handle of the picture: a named point, or the centre of the arc. */
export type Handle = PointName | "centre";

/** What dragging a handle changes: one word, or the point that the block names. */
export type Dragged =
  | { readonly word: "LEN" | "R" | "CCA"; readonly value: number }
  | { readonly word: "point"; readonly point: PlanePoint };

/** Which handles of a form change something in the block. */
export function handlesOf({ shape, departing, arc }: Approach, polarWithoutPole: boolean): readonly Handle[] {
  const end: Handle = departing ? "PN" : "PA";
  const isNamed = !polarWithoutPole && (!departing || shape === "LCT");
  const own: Handle = departing ? "PN" : "PH";
  return [...(isNamed ? [end] : []), ...(shape === "LCT" ? [] : [own]), ...(arc ? (["centre"] as const) : [])];
}

/** Dragged values snap to a grid of values that one can type. */
const onGrid = (value: number, grid: number) => rounded(Math.round(value / grid) * grid) + 0;

/** The centre angle from one ray to another in the turn of the arc, degrees. */
function angleTo(contact: PlanePoint, p: PlanePoint, turn: "cw" | "ccw"): number {
  const angle = inDegrees(Math.atan2(cross(contact, p), dot(contact, p))) * (turn === "ccw" ? 1 : -1);
  return angle <= 0 ? angle + 360 : angle;
}

/**
 * The value that brings a handle to a place; the programmed point is the handle without `offset`. Null where the handle
 * changes nothing.
 */
export function dragged(
  result: Approach,
  handle: Handle,
  to: PlanePoint,
  grid: number,
  offset: PlanePoint,
): Dragged | null {
  const contact = result.departing ? result.points.PE : result.points.PA;
  if (!contact) return null;
  const { tangent, shape, departing } = result;
  const away = scaled(leftOf(tangent), result.side === "right" ? -1 : 1);
  const d = difference(to, contact);
  if (handle === "centre") {
    const size = dot(d, away);
    return { word: "R", value: onGrid(shape === "LCT" ? Math.max(grid, Math.abs(size)) : size || grid, grid) || grid };
  }
  if ((handle === "PA" && !departing) || (handle === "PN" && shape === "LCT")) {
    return { word: "point", point: { x: onGrid(to.x - offset.x, grid), y: onGrid(to.y - offset.y, grid) } };
  }
  if (handle !== (departing ? "PN" : "PH")) return null;
  if (shape === "LT") return { word: "LEN", value: onGrid(dot(d, tangent) * (departing ? 1 : -1), grid) };
  if (shape === "LN") return { word: "LEN", value: onGrid(dot(d, away), grid) };
  if (shape !== "CT" || !result.arc) return null;
  const [ray, end] = [difference(to, result.arc.centre), difference(contact, result.arc.centre)];
  const angle = departing ? angleTo(end, ray, result.arc.turn) : angleTo(ray, end, result.arc.turn);
  return { word: "CCA", value: Math.max(1, Math.min(360, Math.round(angle))) };
}
