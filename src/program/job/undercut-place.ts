import { SAME } from "../../kernel/tolerance.ts";
import { diameter } from "../../kernel/units.ts";
import type { RowReading } from "./contour-rows.ts";
import type { UndercutPlace } from "./undercut-name.ts";

/**
 * Where the undercut of a row is: in the corner of a cylinder and a face, the elements before and behind it. Null where
 * they are something else or still unknown. `per`: mm in a unit of the rows.
 */
export function undercutPlace(rows: readonly RowReading[], index: number, per = 1): UndercutPlace | null {
  const before = rows.slice(0, index).findLast(({ end }) => end !== null);
  const behind = rows.slice(index + 1).find(({ end }) => end !== null);
  const [corner, from, to] = [before?.end, before?.inherited, behind?.end];
  if (!corner || !to || typeof from?.x !== "number") return null;
  const isAlong = (x: number) => Math.abs(x - corner.x) <= SAME;
  if (isAlong(from.x) === isAlong(to.x)) return null;
  const far = isAlong(from.x) ? to.x : from.x;
  return { diameter: diameter(corner.x * per), isInside: far < corner.x, z: corner.z * per };
}
