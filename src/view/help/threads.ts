import { part, type Pt } from "../../kernel/geometry/point.ts";
import { numberOf, type Context } from "./context.ts";
import type { Lettering } from "./dimensions.ts";
import { along, outward, pointAt } from "./frame.ts";
import { leader } from "./dimensions.ts";
import { spot } from "./layout.ts";
import { arrowHead, circle, polyline, type Mark } from "./marks.ts";
import { finishingPath, pathMarks, type Explanation } from "./process.ts";
import { filled, stroke } from "./stroke.ts";

const mm = (c: Context, pixels: number) => pixels / c.layout.camera.scale;

/** The path of the tool along the thread, drawn for a choice while its prompt is active. */
export const alongThread = (c: Context, l: Lettering): Explanation => ({
  under: l.active ? pathMarks(c, l, finishingPath(c, c.outline.contour)) : [],
  item: null,
});

/** The start of the thread, and a point so many pixels above it, out of the material. */
function beginning(c: Context, pixels: number): { readonly at: Pt; readonly over: Pt } {
  const at = c.section.line[0] ?? c.section.corner;
  return { at, over: pointAt(c.frame, along(c.frame, at), outward(c.frame, at) + mm(c, pixels)) };
}

const DIAL = 15;

/** The spindle seen along its axis, with the angle at which the thread begins. */
export function startingAngle(c: Context, l: Lettering): Explanation {
  if (!l.active) return { under: [], item: null };
  const { at, over } = beginning(c, 34);
  const centre = spot(c.layout, over);
  const angle = (numberOf(c.values, l.q) * Math.PI) / 180;
  const rim = { x: centre.x + DIAL * Math.sin(angle), y: centre.y - DIAL * Math.cos(angle) };
  const zero = { x: centre.x, y: centre.y - DIAL };
  return {
    under: [
      stroke(l, "frame", circle(centre, DIAL)),
      stroke(l, "break", polyline([centre, zero])),
      stroke(l, "path", polyline([centre, rim])),
      filled(l, "arrow", arrowHead(rim, rim.x - centre.x, rim.y - centre.y, 7)),
    ],
    item: { q: l.q, candidates: leader(l, spot(c.layout, at), centre) },
  };
}

/** Limit of arrows: more add no information. */
const MOST = 6;

/** One arrow into the material for each start, side by side. */
export function starts(c: Context, l: Lettering): Explanation {
  if (!l.active) return { under: [], item: null };
  const { at } = beginning(c, 0);
  const count = Math.min(MOST, Math.max(1, numberOf(c.values, l.q)));
  const arrows = Array.from({ length: count }, (_, i): Mark[] => {
    const u = along(c.frame, at) + mm(c, 8 + i * 11);
    const v = outward(c.frame, at);
    return pathMarks(c, l, [pointAt(c.frame, u, v + mm(c, 26)), pointAt(c.frame, u, v + mm(c, 3))]);
  });
  const last = pointAt(c.frame, along(c.frame, at) + mm(c, 8 + count * 11), outward(c.frame, at) + mm(c, 20));
  return { under: arrows.flat(), item: { q: l.q, candidates: leader(l, spot(c.layout, at), spot(c.layout, last)) } };
}

/** The path at finished depth, there and back. */
export function airCuts(c: Context, l: Lettering): Explanation {
  if (!l.active) return { under: [], item: null };
  const way = finishingPath(c, c.outline.contour);
  const back = finishingPath(c, c.outline.contour, 18).toReversed();
  const at = way[Math.floor(way.length / 2)] ?? c.section.corner;
  const over = part.point(at.z, at.r);
  return {
    under: [...pathMarks(c, l, way), ...pathMarks(c, l, back)],
    item: { q: l.q, candidates: leader(l, spot(c.layout, over), spot(c.layout, beginning(c, 40).over)) },
  };
}
