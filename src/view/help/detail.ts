import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { toScreen, type Camera, type Place } from "../camera.ts";
import { labelsOverlap, runsThrough, textBox, type LabelBox } from "../dimensions/labels.ts";
import { elementAt } from "./process.ts";
import { openSide } from "./frame.ts";
import type { Context } from "./context.ts";
import type { Lettering } from "./dimensions.ts";
import { arrowHead, circle, dense, polygon, polyline, segmentPath, type Mark } from "./marks.ts";
import { filled, stroke, value, type PlacedHelp } from "./stroke.ts";

/** An element smaller than this on the screen is magnified while its prompt is active, pixels. */
const SMALL = 13;
/** What share of the lens the element fills. */
const SHARE = 0.75;

/** Whether a length deserves the lens. */
export const isSmall = (c: Context, mm: number): boolean => mm > 0 && mm * c.layout.camera.scale < SMALL;

/** Where the lens covers least: over no text, off the contour, and not far from the element. */
function lensPlace(
  c: Context,
  radius: number,
  text: LabelBox,
  at: Place,
  placed: readonly PlacedHelp[],
  kept: readonly LabelBox[],
): Place {
  const { width, height } = c.layout.size;
  const line = dense(c.section.line.map((p) => toScreen(c.layout.camera, p)));
  const blank = c.section.blank.map((p) => toScreen(c.layout.camera, p));
  let best: Place = { x: width - radius - 2, y: radius + 2 };
  let least = Infinity;
  const half = Math.max(radius, text.width / 2);
  for (let x = half + 3; x <= width - half - 3; x += 8)
    for (let y = radius + 3; y <= height - radius - text.height - 5; y += 8) {
      const lens = { x: x - radius, y: y - radius, width: 2 * radius, height: 2 * radius + text.height + 4 };
      const over = (p: Place) => Math.hypot(p.x - x, p.y - y) < radius + 3;
      const gap = Math.hypot(at.x - x, at.y - y);
      const hidden =
        Math.abs(at.x - x) < text.width / 2 + 9 &&
        Math.abs(at.y - (y + radius + text.height / 2 + 2)) < text.height / 2 + 9;
      const cheap =
        gap / 7 + (gap < radius + 14 || hidden ? 60 : 0) + (kept.some((b) => labelsOverlap(b, lens)) ? 500 : 0);
      if (cheap >= least) continue;
      const cost =
        placed.filter((p) => labelsOverlap(p.label, lens) || p.lines.some((l) => runsThrough(l, lens))).length * 6 +
        line.filter(over).length * 1.2 +
        blank.filter(over).length * 3 +
        cheap;
      if (cost < least) [best, least] = [{ x, y }, cost];
    }
  return best;
}

/** An arc's radius from its centre, or the corner that a chamfer takes away, in the lens. */
function measure(c: Context, l: Lettering, element: Segment, camera: Camera): Mark[] {
  const [from, to] = [toScreen(camera, element.from), toScreen(camera, element.to)];
  if (element.kind === "line") {
    const [dz, dr] = [element.to.z - element.from.z, element.to.r - element.from.r];
    const corner = dz * dr * openSide(c.frame) > 0 ? { x: from.x, y: to.y } : { x: to.x, y: from.y };
    return [stroke(l, "break", polyline([from, corner, to]))];
  }
  const middle = toScreen(camera, part.pointOn(element, 0.5));
  const centre = toScreen(camera, element.centre);
  return [
    stroke(l, "thin", polyline([centre, middle])),
    filled(l, "arrow", arrowHead(middle, middle.x - centre.x, middle.y - centre.y)),
  ];
}

/** A lens over a small element, with its value below, and the boxes that nothing else may cover. */
export function detail(
  c: Context,
  l: Lettering,
  { at, mm }: { readonly at: Pt; readonly mm: number },
  placed: readonly PlacedHelp[],
  kept: readonly LabelBox[],
): { readonly marks: Mark[]; readonly boxes: readonly LabelBox[]; readonly label: LabelBox } {
  const { width, height } = c.layout.size;
  const radius = Math.min(52, 0.17 * Math.min(width, height));
  const spot = toScreen(c.layout.camera, at);
  const text = textBox({ x: 0, y: 0 }, l.text, 0);
  const centre = lensPlace(c, radius, text, spot, placed, kept);
  const scale = (radius * SHARE) / mm;
  const camera: Camera = { scale, xUp: true, zero: { x: centre.x - at.z * scale, y: centre.y + at.r * scale } };
  const quiet = { q: l.q, active: false };
  const element = elementAt(c, at)?.element;
  const inside: Mark[] = [
    filled(quiet, "paper", circle(centre, radius)),
    filled(quiet, "part", polygon(c.section.part.map((p) => toScreen(camera, p)))),
    stroke(quiet, "contour", segmentPath(c.outline.contour, camera)),
    ...c.section.edges.map(([a, b]) => stroke(quiet, "edge", polyline([toScreen(camera, a), toScreen(camera, b)]))),
    ...(element ? [stroke(l, "element", segmentPath([element], camera)), ...measure(c, l, element, camera)] : []),
  ];
  const away = Math.hypot(centre.x - spot.x, centre.y - spot.y) || 1;
  const u = { x: (centre.x - spot.x) / away, y: (centre.y - spot.y) / away };
  const place = { x: centre.x, y: centre.y + radius + text.height / 2 + 2 };
  const label = textBox(place, l.text, 0);
  return {
    marks: [
      stroke(l, "thin", circle(spot, 7)),
      stroke(
        l,
        "thin",
        polyline([
          { x: spot.x + u.x * 7, y: spot.y + u.y * 7 },
          { x: centre.x - u.x * radius, y: centre.y - u.y * radius },
        ]),
      ),
      {
        kind: "detail",
        q: l.q,
        active: l.active,
        centre,
        radius,
        marks: inside,
      },
      stroke(l, "frame", circle(centre, radius)),
      value(l, place, l.text),
    ],
    boxes: [{ x: centre.x - radius, y: centre.y - radius, width: 2 * radius, height: 2 * radius }, label],
    label,
  };
}
