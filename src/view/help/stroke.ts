import type { Place } from "../camera.ts";
import type { Item, Placed, Spot } from "../dimensions/arrange.ts";
import { SIZE } from "../dimensions/labels.ts";
import { arrowHead, polyline, type Fill, type Line, type Mark } from "./marks.ts";

/** The owner of a mark. */
export interface Tag {
  readonly q: string | null;
  readonly active: boolean;
}

/** A candidate place of a dimension. Its marks are made where it is chosen: most candidates are not. */
export interface Candidate extends Spot {
  readonly marks: () => readonly Mark[];
}
export type HelpItem = Item<Candidate>;
export type PlacedHelp = Placed<Candidate>;

/** A line with a role. */
export const stroke = (tag: Tag, line: Line, d: string): Mark => ({ ...tag, kind: "line", line, d });
/** A filled shape with a role. */
export const filled = (tag: Tag, fill: Fill, d: string): Mark => ({ ...tag, kind: "area", fill, d });
/** A value of a dimension about its middle. */
export const value = (tag: Tag, place: Place, text: string, turn: 0 | -90 = 0, underlined = false): Mark => ({
  ...tag,
  kind: "text",
  place,
  text,
  size: tag.active ? SIZE.strong : SIZE.quiet,
  turn,
  underlined,
  role: "value",
});
/** Running text about its middle. */
export const caption = (tag: Tag, place: Place, text: string): Mark => ({
  ...tag,
  kind: "text",
  place,
  text,
  size: SIZE.caption,
  turn: 0,
  underlined: false,
  role: "caption",
});

/** Below this length the arrows of a dimension are outside and point inwards, pixels. */
export const SHORT = 20;
/** Length of the tails that a short dimension has outside, pixels. */
export const TAIL = 13;

/** A dimension line between two places, with its arrowheads. */
export function between(tag: Tag, a: Place, b: Place): Mark[] {
  const long = Math.hypot(b.x - a.x, b.y - a.y);
  if (long < 0.5) return [];
  const u = { x: (b.x - a.x) / long, y: (b.y - a.y) / long };
  if (long >= SHORT)
    return [
      stroke(tag, "thin", polyline([a, b])),
      filled(tag, "arrow", arrowHead(a, -u.x, -u.y)),
      filled(tag, "arrow", arrowHead(b, u.x, u.y)),
    ];
  const out = (p: Place, k: number): Place => ({ x: p.x + u.x * k, y: p.y + u.y * k });
  return [
    stroke(tag, "thin", polyline([out(a, -TAIL), out(b, TAIL)])),
    filled(tag, "arrow", arrowHead(a, u.x, u.y)),
    filled(tag, "arrow", arrowHead(b, -u.x, -u.y)),
  ];
}

/** An extension line from a point of the drawing to just past its dimension line; it starts with a small gap. */
export function extension(tag: Tag, from: Place, to: Place): Mark[] {
  const long = Math.hypot(to.x - from.x, to.y - from.y);
  if (long < 5) return [];
  const u = { x: (to.x - from.x) / long, y: (to.y - from.y) / long };
  return [
    stroke(
      tag,
      "thin",
      polyline([
        { x: from.x + u.x * 2, y: from.y + u.y * 2 },
        { x: to.x + u.x * 4, y: to.y + u.y * 4 },
      ]),
    ),
  ];
}
