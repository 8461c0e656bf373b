import { areaOfRing } from "../../src/kernel/area/area.ts";
import { boxAround, inBox } from "../../src/kernel/area/box.ts";
import { difference, intersection, isInside, opened, simplified, union } from "../../src/kernel/area/clip.ts";
import { at, type Pt, type Ring } from "../../src/kernel/geometry/point.ts";
import { SLIVER } from "../../src/kernel/tolerance.ts";
import type { Tool } from "../../src/kernel/plan/tool.ts";
import { plungesAxially } from "../../src/kernel/cutter/insert.ts";
import { isDrill } from "../../src/kernel/cutter/drill.ts";
import { outlinesOf } from "../../src/sim/outlines.ts";
import { regionsOf } from "../../src/sim/region.ts";

/*
 * What a tool can touch at all, by its shape alone: all places to which it comes from outside without meeting what has
 * to stay. It knows no cycle, no strategy and no action of the planner, so that it bounds what a plan leaves.
 */

/** Obstacles are simplified to this, mm. */
const WITHIN = 0.01;
/** Room around the obstacles, mm. */
const ROOM = 250;

const moved = (ring: Ring, by: Pt): Ring => ring.map(({ z, r }) => at(z + by.z, r + by.r));
const mirrored = (ring: Ring): Ring => ring.map(({ z, r }) => at(-z, -r));
const turn = (o: Pt, a: Pt, b: Pt): number => (a.z - o.z) * (b.r - o.r) - (a.r - o.r) * (b.z - o.z);

/** The convex hull of points, anticlockwise. */
function hull(points: readonly Pt[]): Ring {
  const sorted = points.toSorted((a, b) => a.z - b.z || a.r - b.r);
  const half = (from: readonly Pt[]): Pt[] => {
    const out: Pt[] = [];
    for (const p of from) {
      for (;;) {
        const [o, a] = [out.at(-2), out.at(-1)];
        if (!o || !a || turn(o, a, p) > 0) break;
        out.pop();
      }
      out.push(p);
    }
    return out.slice(0, -1);
  };
  const ring = [...half(sorted), ...half(sorted.toReversed())];
  return areaOfRing(ring) < 0 ? ring.toReversed() : ring;
}

const edgesOf = (rings: readonly Ring[]): readonly (readonly [Pt, Pt])[] =>
  rings.flatMap((ring) => ring.map((a, i) => [a, ring[(i + 1) % ring.length] ?? a] as const));

/** A convex shape along the edges of an area. */
const along = (edges: readonly (readonly [Pt, Pt])[], shape: Ring): readonly Ring[] =>
  edges.map(([a, b]) => hull([...moved(shape, a), ...moved(shape, b)]));

/** What the cutting part of a tool can touch of an area: `stays`: what no part of the tool may meet. */
export function touched(area: readonly Ring[], stays: readonly Ring[], tool: Tool): readonly Ring[] {
  const { insert, checked, holder } = outlinesOf()(tool);
  const both = [...stays, ...stays.map((ring) => ring.map(({ z, r }) => at(z, -r)).toReversed())];
  const obstacles = simplified(union(both), WITHIN);
  const edges = edgesOf(obstacles);
  const forbidden = [checked, ...holder].flatMap((shape) => {
    const back = mirrored(shape);
    const first = back[0] ?? at(0, 0);
    return [...along(edges, back), ...obstacles.map((ring) => moved(ring, first))];
  });
  const { left, right, high } = boxAround(obstacles);
  const [low, top] = [-high - ROOM, high + ROOM];
  const room: Ring = [at(left - ROOM, low), at(right + ROOM, low), at(right + ROOM, top), at(left - ROOM, top)];
  const free = difference([room], union(forbidden));
  const outside = at(right + ROOM - 1, top - 1);
  const open = regionsOf(free, 0).find(({ outline }) => isInside(outline, outside));
  if (!open) return [];
  const places = [open.outline, ...open.holes];
  const [own, shape] = [boxAround(area), boxAround([insert])];
  const near = inBox(places, {
    left: own.left - shape.right - 1,
    right: own.right - shape.left + 1,
    low: own.low - shape.high - 1,
    high: own.high - shape.low + 1,
  });
  const reached = union([...along(edgesOf(near), insert), ...near.map((ring) => moved(ring, insert[0] ?? at(0, 0)))]);
  return opened(intersection(area, reached), SLIVER);
}

/** Tools that cut along a path. A blade for faces is curved, so that its shape in the half plane says too much. */
export const turningTools = (tools: readonly Tool[]): readonly Tool[] =>
  tools.filter((tool) => !isDrill(tool) && tool.TYPE !== "THREAD" && !plungesAxially(tool));
