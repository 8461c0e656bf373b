import { part, type Segment } from "../../kernel/geometry/point.ts";
import { toScreen, type Camera, type Place } from "../camera.ts";
import { headPlaces } from "../dimensions/strokes.ts";

/** What a filled shape stands for. */
export type Fill = "part" | "cut" | "oversize" | "paper" | "arrow" | "tool" | "place";
/** What a line stands for; form and colour belong to whoever paints it. */
export type Line =
  | "contour"
  | "axis"
  | "edge"
  | "break"
  | "area"
  | "thin"
  | "pass"
  | "path"
  | "rapid"
  | "limit"
  | "element"
  | "frame";

interface Belongs {
  /** The parameter this mark explains; null for the drawing itself. */
  readonly q: string | null;
  /** True for the marks of the active parameter. */
  readonly active: boolean;
}

/** One mark of the help picture: all places in CSS pixels, path data likewise. */
export type Mark = Belongs &
  (
    | { readonly kind: "area"; readonly fill: Fill; readonly d: string }
    | { readonly kind: "line"; readonly line: Line; readonly d: string }
    | {
        readonly kind: "text";
        readonly place: Place;
        readonly text: string;
        readonly size: number;
        /** Degrees, clockwise on the screen; −90 reads from the right. */
        readonly turn: 0 | -90;
        /** A dimension that is not to scale is underlined, as on a print. */
        readonly underlined: boolean;
        /** A caption is running text, a value is a number. */
        readonly role: "value" | "caption";
      }
    | { readonly kind: "detail"; readonly centre: Place; readonly radius: number; readonly marks: readonly Mark[] }
  );

/** A tenth of a pixel is finer than any screen draws. */
export const px = (v: number): string => String(Math.round(v * 10) / 10 + 0);
const at = (p: Place) => `${px(p.x)} ${px(p.y)}`;

/** Straight lines through places. */
export const polyline = (places: readonly Place[]): string => (places.length > 1 ? `M${places.map(at).join("L")}` : "");
/** Places along straight lines, at most four pixels apart. */
export const dense = (line: readonly Place[]): Place[] =>
  line.flatMap((b, i) => {
    const a = line[i - 1];
    if (!a) return [b];
    const n = Math.min(200, Math.ceil(Math.hypot(b.x - a.x, b.y - a.y) / 4));
    return Array.from({ length: n }, (_, k) => ({
      x: a.x + ((b.x - a.x) * (k + 1)) / n,
      y: a.y + ((b.y - a.y) * (k + 1)) / n,
    }));
  });
/** A closed shape through places. */
export const polygon = (places: readonly Place[]): string => (places.length > 2 ? `M${places.map(at).join("L")}Z` : "");
/**
 * A full circle. Its ends are exactly twice the written radius apart: two halves over a shorter chord would each bulge.
 */
export function circle(c: Place, r: number): string {
  const [x, radius] = [Number(px(c.x)), px(r)];
  const [left, right] = [px(x - Number(radius)), px(x + Number(radius))];
  return `M${left} ${px(c.y)}A${radius} ${radius} 0 1 1 ${right} ${px(c.y)}A${radius} ${radius} 0 1 1 ${left} ${px(c.y)}Z`;
}

/**
 * An arc on the screen about `c` from one angle to another, radians, counted as the screen sees them with Y upwards.
 */
export function arcPath(c: Place, r: number, from: number, to: number): string {
  const p = (a: number) => at({ x: c.x + r * Math.cos(a), y: c.y - r * Math.sin(a) });
  return `M${p(from)}A${px(r)} ${px(r)} 0 ${Math.abs(to - from) > Math.PI ? 1 : 0} ${to > from ? 0 : 1} ${p(to)}`;
}

/** Contour segments as a screen path; arcs stay arcs. */
export function segmentPath(segments: readonly Segment[], camera: Camera): string {
  let d = "";
  let last: Place | null = null;
  for (const s of segments) {
    const [from, to] = [toScreen(camera, s.from), toScreen(camera, s.to)];
    if (!last || Math.hypot(last.x - from.x, last.y - from.y) > 0.1) d += `M${at(from)}`;
    if (s.kind === "line") d += `L${at(to)}`;
    else {
      const arc = part.polarOf(s);
      const r = px(Math.max(arc.startRadius * camera.scale, 0.1));
      d += `A${r} ${r} 0 ${Math.abs(arc.sweep) > Math.PI ? 1 : 0} ${s.turn === "ccw" ? 0 : 1} ${at(to)}`;
    }
    last = to;
  }
  return d;
}

/** A slim arrowhead with its tip at `tip`, pointing along the screen direction (x, y). */
export const arrowHead = (tip: Place, x: number, y: number, size = 8): string =>
  polygon(headPlaces(tip, { x, y }, { long: size, half: size * 0.21 }));
