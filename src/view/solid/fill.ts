import { Earcut } from "three/src/extras/Earcut.js";
import { areaOfRing } from "../../kernel/area/area.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";

/** Whether a point lies in a ring; beside its edge it may fall either way. */
function holds(ring: Ring, p: Pt): boolean {
  let inside = false;
  let a = ring.at(-1);
  for (const b of ring) {
    if (a && a.r > p.r !== b.r > p.r && p.z < a.z + ((p.r - a.r) / (b.r - a.r)) * (b.z - a.z)) inside = !inside;
    a = b;
  }
  return inside;
}

/**
 * Triangles, counter-clockwise, that fill outer rings (counter-clockwise) less holes (clockwise), by their places among
 * all points; corners on a straight side may have none. The triangulation is the file of three alone, since the worker
 * fills areas too and must not load the rest.
 */
export function trianglesOf(rings: readonly Ring[]): number[] {
  let first = 0;
  const all = rings.map((ring) => {
    const places = ring.map((_, i) => first + i);
    first += ring.length;
    return { ring, places, area: ring.length > 2 ? areaOfRing(ring) : 0 };
  });
  const outers = all.filter((x) => x.area > 0).sort((a, b) => a.area - b.area);
  const holes = all
    .filter((x) => x.area < 0)
    .map((hole) => {
      const inside = (outer: Ring) => hole.ring.filter((p) => holds(outer, p)).length;
      return { ...hole, of: outers.find(({ ring }) => 2 * inside(ring) > hole.ring.length) };
    });
  return outers.flatMap((outer) => {
    const own = [outer, ...holes.filter(({ of }) => of === outer)],
      places = own.flatMap((each) => each.places),
      numbers = own.flatMap(({ ring }) => ring.flatMap(({ z, r }) => [z, r]));
    let count = 0;
    const begins = own.slice(1).map((_, i) => (count += own[i]?.ring.length ?? 0));
    return Earcut.triangulate(numbers, begins).map((i) => places[i] ?? 0);
  });
}
