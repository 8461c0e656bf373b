import type { Plan } from "../kernel/plan.ts";
import type { Pt, Ring } from "../kernel/point.ts";
import { axial, radius } from "../kernel/units.ts";
import { boxOf } from "./box.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });

/** The middle of the corners of an outline. */
function middleOf(ring: Ring): Pt {
  const count = Math.max(1, ring.length);
  return at(ring.reduce((sum, p) => sum + p.z, 0) / count, ring.reduce((sum, p) => sum + p.r, 0) / count);
}

/**
 * The way from the deepest path of a tool to where every position is free, farther than the area is large: along it the
 * tool can back out from everywhere. It is across the cutting direction, since the deepest path never turns back along
 * that; told from the path itself, on the side on which the body of the insert stands.
 */
export function freeWay(insert: Ring, { area, reach }: Pick<Plan, "area" | "reach">): Pt {
  const box = boxOf([...area, ...reach.flatMap((piece) => [piece.path.from, piece.path.to])]);
  const far = Math.max(box.right - box.left, box.top - box.bottom) || 1;
  const body = middleOf(insert);
  const left = reach.map(({ path }) => at(path.from.r - path.to.r, path.to.z - path.from.z));
  const side = left.reduce((sum, n) => sum + n.z * body.z + n.r * body.r, 0) >= 0 ? 1 : -1;
  const ways = [at(0, 1), at(1, 0), at(0, -1), at(-1, 0)].map((way) => {
    const climbs = left.map((n) => side * (n.z * way.z + n.r * way.r));
    return {
      way,
      blocked: climbs.reduce((sum, climb) => sum + Math.max(0, -climb), 0),
      free: climbs.reduce((sum, climb) => sum + climb, 0),
    };
  });
  const best = ways.reduce((a, b) => (b.blocked < a.blocked - 1e-6 || (b.blocked < a.blocked + 1e-6 && b.free > a.free) ? b : a));
  return at(best.way.z * far, best.way.r * far);
}
