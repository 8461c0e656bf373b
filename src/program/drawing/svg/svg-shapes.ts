import { ROUND } from "../../../kernel/tolerance.ts";
import { attributeOf, type XmlElement } from "../../files/xml.ts";
import type { Curve3, V3 } from "../space.ts";
import { ellipticalArc, numbersOf, pathCurves, type PathCurves } from "./svg-path.ts";

/** Lengths of the units of SVG in px, which are 1/96 inch. */
const PX: Readonly<Record<string, number>> = {
  "": 1,
  px: 1,
  mm: 96 / 25.4,
  cm: 96 / 2.54,
  q: 96 / 101.6,
  in: 96,
  pt: 96 / 72,
  pc: 16,
};

/** A length with its unit; null for none, a percentage or a unit that depends on a font. */
export function lengthOf(text: string | undefined): { readonly px: number; readonly unit: string } | null {
  const [, n = "", unit = ""] =
      /^([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?)\s*([a-zA-Z]*)$/.exec((text ?? "").trim()) ?? [],
    size = PX[unit.toLowerCase()];
  return n === "" || size === undefined || Math.abs(Number(n)) > 1e7
    ? null
    : { px: Number(n) * size, unit: unit.toLowerCase() };
}

const full = (centre: V3, rx: number, ry: number): Curve3 => ({
  kind: "conic",
  centre,
  u: [rx, 0, 0],
  v: [0, ry, 0],
  start: 0,
  end: 2 * Math.PI,
});

/** Lines through points. */
function through(points: readonly number[], closed: boolean): Curve3[] {
  const out: Curve3[] = [];
  const at = (i: number): V3 => [points[2 * i] ?? 0, points[2 * i + 1] ?? 0, 0],
    count = points.length >> 1;
  for (let i = 0; i + 1 < count; i += 1) out.push({ kind: "line", from: at(i), to: at(i + 1) });
  if (closed && count > 2) out.push({ kind: "line", from: at(count - 1), to: at(0) });
  return out;
}

function rectangle(e: XmlElement): Curve3[] {
  const size = (name: string) => lengthOf(attributeOf(e, name))?.px;
  const [x, y, w, h] = [size("x") ?? 0, size("y") ?? 0, size("width") ?? 0, size("height") ?? 0];
  if (w <= 0 || h <= 0) return [];
  const rx = Math.min(size("rx") ?? size("ry") ?? 0, w / 2),
    ry = Math.min(size("ry") ?? size("rx") ?? 0, h / 2);
  if (rx <= 0 || ry <= 0) return through([x, y, x + w, y, x + w, y + h, x, y + h], true);
  const corners: readonly (readonly [V3, V3])[] = [
    [
      [x + w - rx, y, 0],
      [x + w, y + ry, 0],
    ],
    [
      [x + w, y + h - ry, 0],
      [x + w - rx, y + h, 0],
    ],
    [
      [x + rx, y + h, 0],
      [x, y + h - ry, 0],
    ],
    [
      [x, y + ry, 0],
      [x + rx, y, 0],
    ],
  ];
  return corners.flatMap(([from, to], i): Curve3[] => {
    const arc = ellipticalArc(from, to, [rx, ry], 0, { large: false, sweep: true }),
      next = corners[(i + 1) % 4]?.[0] ?? to;
    const side: Curve3[] =
      Math.hypot(next[0] - to[0], next[1] - to[1]) > ROUND ? [{ kind: "line", from: to, to: next }] : [];
    return arc ? [arc, ...side] : side;
  });
}

/** Curves of a basic shape or path in its own coordinates; null for an element that draws none. */
export function shapeCurves(e: XmlElement): PathCurves | null {
  const size = (name: string) => lengthOf(attributeOf(e, name))?.px ?? 0,
    whole = (curves: readonly Curve3[]): PathCurves => ({ curves, complete: true });
  switch (e.local) {
    case "path":
      return pathCurves(attributeOf(e, "d") ?? "");
    case "line":
      return whole(through([size("x1"), size("y1"), size("x2"), size("y2")], false));
    case "polyline":
    case "polygon":
      return whole(through(numbersOf(attributeOf(e, "points") ?? ""), e.local === "polygon"));
    case "rect":
      return whole(rectangle(e));
    case "circle": {
      const r = size("r");
      return whole(r > 0 ? [full([size("cx"), size("cy"), 0], r, r)] : []);
    }
    case "ellipse": {
      const [rx, ry] = [size("rx"), size("ry")];
      return whole(rx > 0 && ry > 0 ? [full([size("cx"), size("cy"), 0], rx, ry)] : []);
    }
    default:
      return null;
  }
}
