import type { Dimension } from "../../cycles/define.ts";
import { shortest } from "../../kernel/geometry/segments.ts";
import type { Place } from "../camera.ts";
import { runsThrough, SIZE, textBox, textWidth, type StraightLine } from "../dimensions/labels.ts";
import { FIRST, spot, TRACK, type Layout } from "./layout.ts";
import { arcPath, arrowHead, polyline, type Mark } from "./marks.ts";
import {
  between,
  extension,
  filled,
  SHORT,
  stroke,
  TAIL,
  value,
  type Candidate,
  type HelpItem,
  type Tag,
} from "./stroke.ts";

/** The text of a dimension, and how it is drawn. */
export interface Lettering extends Tag {
  readonly q: string;
  readonly text: string;
  /** Drawn larger than to scale. */
  readonly underlined?: boolean;
}

const candidate = (
  l: Lettering,
  marks: () => readonly Mark[],
  middle: Place,
  turn: 0 | -90,
  lines: readonly StraightLine[],
  cost: number,
): Candidate => ({
  marks: () => [...marks(), value({ q: l.q, active: l.active }, middle, l.text, turn, l.underlined ?? false)],
  label: textBox(middle, l.text, turn),
  lines,
  cost,
});
/** Cost of the text of an angle over one of its own legs. */
const OVER_LEG = 8;
const width = (l: Lettering) => textWidth(l.text, SIZE.strong);
const range = (n: number) => Array.from({ length: n }, (_, i) => i);

/** A dimension line with the outside tails of a short one. */
function tailed(p: Place, q: Place): StraightLine {
  const long = Math.hypot(q.x - p.x, q.y - p.y);
  if (long < 0.5 || long >= SHORT) return [p, q];
  const by = { x: ((q.x - p.x) / long) * TAIL, y: ((q.y - p.y) / long) * TAIL };
  return [
    { x: p.x - by.x, y: p.y - by.y },
    { x: q.x + by.x, y: q.y + by.y },
  ];
}

/** Z dimensions: lines stacked above the drawing, then below it. */
function horizontal(layout: Layout, l: Lettering, a: Place, b: Place): Candidate[] {
  const { box, size } = layout;
  const [left, right] = [Math.min(a.x, b.x), Math.max(a.x, b.x)];
  const half = width(l) / 2;
  const point = right - left < 1;
  const beside = point ? 5 : 16;
  const middles = right - left > 2 * half + 18 ? [(left + right) / 2] : [right + half + beside, left - half - beside];
  const heights = [
    ...range(5).map((k) => ({ y: box.y - FIRST - k * TRACK, cost: k * 3 })),
    ...range(2).map((k) => ({ y: box.y + box.height + FIRST + k * TRACK, cost: 20 + k * 3 })),
    ...range(3).map((k) => ({ y: Math.min(a.y, b.y) - FIRST - k * TRACK, cost: 24 + k * 3 })),
  ];
  return heights
    .filter(({ y }) => y > 8 && y < size.height - 8)
    .flatMap(({ y, cost }) =>
      middles.map((x, i) => {
        const [p, q] = [
          { x: a.x, y },
          { x: b.x, y },
        ];
        const marks = () => [...extension(l, a, p), ...(point ? [] : extension(l, b, q)), ...between(l, p, q)];
        const lines: StraightLine[] = [[a, p], ...(point ? [] : [[b, q] as const, tailed(p, q)])];
        return candidate(l, marks, { x, y }, 0, lines, cost + i);
      }),
    );
}

/** Diameters: an upright line from the surface to just past the axis, in columns beside the drawing. */
function diameter(layout: Layout, l: Lettering, at: Place): Candidate[] {
  const { box, contour, axisY, size } = layout;
  const columns = [
    ...range(4).map((k) => ({
      x: box.x + box.width + FIRST + k * TRACK,
      cost: k * 3 + Math.max(0, contour.right - at.x) / 16,
    })),
    ...range(3).map((k) => ({ x: box.x - FIRST - k * TRACK, cost: k * 3 + Math.max(0, at.x - contour.left) / 16 })),
    ...range(3).map((k) => ({ x: at.x + (k % 2 ? 1 : -1) * (18 + 14 * k), cost: 20 + k * 3 })),
  ];
  const long = Math.abs(axisY - at.y);
  return columns
    .filter(({ x }) => x > 8 && x < size.width - 8)
    .flatMap(({ x, cost }) => {
      const foot = { x, y: axisY },
        head = { x, y: at.y };
      const down = axisY >= at.y ? 1 : -1;
      const marks = () => [
        ...extension(l, at, head),
        stroke(l, "thin", polyline([head, ...(layout.broken ? zigzag(foot, head) : []), { x, y: axisY + 7 * down }])),
        filled(l, "arrow", arrowHead(head, 0, -down)),
      ];
      const lines: StraightLine[] = [
        [at, head],
        [foot, head],
      ];
      const upright =
        long > width(l) + 18
          ? [0.5, 0.62, 0.38].map((t, i) =>
              candidate(l, marks, { x, y: at.y + (axisY - at.y) * t }, -90, lines, cost + i),
            )
          : [];
      const flat = [1, -1].map((side, i) =>
        candidate(
          l,
          marks,
          { x: x + side * (width(l) / 2 + 6), y: at.y + down * Math.min(12, long / 2) },
          0,
          lines,
          cost + 6 + i,
        ),
      );
      return [...upright, ...flat];
    });
}

/** The kink of a broken dimension line, near the axis, from the head on. */
function zigzag(foot: Place, head: Place): Place[] {
  const down = foot.y >= head.y ? 1 : -1;
  const y = foot.y - down * Math.min(11, Math.abs(foot.y - head.y) * 0.3);
  return [
    { x: foot.x, y: y - 4 * down },
    { x: foot.x + 5, y: y - 1.5 * down },
    { x: foot.x - 5, y: y + 1.5 * down },
    {
      x: foot.x,
      y: y + 4 * down,
    },
  ];
}

/** Depths across the axis: an upright line beside its two points. */
function upright(layout: Layout, l: Lettering, a: Place, b: Place): Candidate[] {
  const [low, high] = [Math.max(a.y, b.y), Math.min(a.y, b.y)];
  const [left, right] = [Math.min(a.x, b.x), Math.max(a.x, b.x)];
  const columns = range(4).flatMap((k) => [
    { x: right + 13 + k * 14, side: 1, cost: k * 3 },
    { x: left - 13 - k * 14, side: -1, cost: 1 + k * 3 },
  ]);
  return columns
    .flatMap(({ x, side, cost }) => {
      const [p, q] = [
        { x, y: a.y },
        { x, y: b.y },
      ];
      const marks = () => [...extension(l, a, p), ...extension(l, b, q), ...between(l, p, q)];
      const lines: StraightLine[] = [[a, p], [b, q], tailed(p, q)];
      return [
        candidate(l, marks, { x: x + side * (width(l) / 2 + 7), y: (low + high) / 2 }, 0, lines, cost),
        candidate(l, marks, { x, y: high - 22 }, 0, lines, cost + 2),
        candidate(l, marks, { x, y: low + 22 }, 0, lines, cost + 3),
      ];
    })
    .filter((c) => c.label.x > 0 && c.label.x + c.label.width < layout.size.width);
}

/** A length along a slanted element: a line parallel to it, on either side. */
export function parallel(l: Lettering, a: Place, b: Place): Candidate[] {
  const long = Math.hypot(b.x - a.x, b.y - a.y) || 1;
  const n = { x: -(b.y - a.y) / long, y: (b.x - a.x) / long };
  return [16, -16, 30, -30, 46, -46].map((d, i) => {
    const [p, q] = [a, b].map((o) => ({ x: o.x + n.x * d, y: o.y + n.y * d })) as [Place, Place];
    const out = Math.sign(d) * (10 + (Math.abs(n.x) * width(l)) / 2);
    const middle = { x: (p.x + q.x) / 2 + n.x * out, y: (p.y + q.y) / 2 + n.y * out };
    return candidate(
      l,
      () => [...extension(l, a, p), ...extension(l, b, q), ...between(l, p, q)],
      middle,
      0,
      [[p, q]],
      i,
    );
  });
}

/** Angles: an arc between reference and element; a narrow one has its arrows outside. */
function angle(l: Lettering, vertex: Place, from: Place, to: Place): Candidate[] {
  const bearing = (p: Place) => Math.atan2(vertex.y - p.y, p.x - vertex.x);
  const start = bearing(from);
  const sweep = shortest(bearing(to) - start);
  const on = (a: number, r: number): Place => ({ x: vertex.x + r * Math.cos(a), y: vertex.y - r * Math.sin(a) });
  return [46, 62, 34, 80, 100, 26].flatMap((r, i) => {
    const narrow = Math.abs(sweep) * r < 24;
    const over = narrow ? 14 / r : 0;
    const way = sweep < 0 ? -1 : 1;
    const [begin, end] = [start - way * over, start + sweep + way * over];
    const head = (a: number, side: number) =>
      filled(l, "arrow", arrowHead(on(a, r), -Math.sin(a) * side, -Math.cos(a) * side, 7));
    const marks = () => [
      stroke(l, "thin", polyline([vertex, on(start, r + 8)])),
      stroke(l, "thin", polyline([vertex, on(start + sweep, r + 8)])),
      stroke(l, "thin", arcPath(vertex, r, begin, end)),
      head(start, narrow ? way : -way),
      head(start + sweep, narrow ? -way : way),
    ];
    const half = width(l) / 2;
    const arc: StraightLine = [on(begin, r), on(end, r)];
    const spots: { p: Place; cost: number }[] = narrow
      ? [
          { p: on(end + way * (10 / r), r + half * 0.3), cost: 0 },
          { p: on(begin - way * (10 / r), r + half * 0.3), cost: 1 },
          {
            p: on(start + sweep / 2, r + half + 14),
            cost: 1,
          },
        ]
      : [
          { p: on(start + sweep / 2, r + half + 6), cost: 0 },
          { p: on(start + sweep / 2, r - half - 6), cost: 1 },
        ];
    const legs = [start, start + sweep].map((a): StraightLine => [vertex, on(a, r)]);
    return spots.map(({ p, cost }) => {
      const own = candidate(l, marks, p, 0, [...legs, arc], i * 1.5 + cost);
      return legs.some((leg) => runsThrough(leg, own.label)) ? { ...own, cost: own.cost + OVER_LEG } : own;
    });
  });
}

/** Leaders: an arrow on the element, a slanted line to a short shelf that carries the text. */
export function leader(l: Lettering, at: Place, towards: Place): Candidate[] {
  const base =
    Math.hypot(towards.x - at.x, towards.y - at.y) < 0.5
      ? -Math.PI / 4
      : Math.atan2(towards.y - at.y, towards.x - at.x);
  const turns = [0, 0.4, -0.4, 0.8, -0.8, 1.3, -1.3, 2, -2, Math.PI];
  return [22, 34, 50, 70, 95].flatMap((long) =>
    turns.flatMap((turn, j) => {
      const a = base + turn;
      const knee = { x: at.x + Math.cos(a) * long, y: at.y + Math.sin(a) * long };
      const side = Math.cos(a) >= 0 ? 1 : -1;
      const shelf = { x: knee.x + side * 7, y: knee.y };
      const middle = { x: shelf.x + side * (width(l) / 2 + 3), y: shelf.y };
      const marks = () => [
        stroke(l, "thin", polyline([at, knee, shelf])),
        filled(l, "arrow", arrowHead(at, at.x - knee.x, at.y - knee.y)),
      ];
      return [
        candidate(
          l,
          marks,
          middle,
          0,
          [[at, knee]],
          (long - 22) * 0.16 + j * 1.4 + (Math.min(Math.abs(Math.cos(a)), Math.abs(Math.sin(a))) < 0.25 ? 4 : 0),
        ),
      ];
    }),
  );
}

/** All candidate places for a dimension of the outline. */
export function dimensionItem(layout: Layout, d: Dimension, l: Lettering): HelpItem {
  const s = (p: Parameters<typeof spot>[1]) => spot(layout, p);
  switch (d.form) {
    case "diameter":
      return { q: l.q, candidates: diameter(layout, l, s(d.at)) };
    case "z":
      return { q: l.q, candidates: horizontal(layout, l, s(d.from), s(d.to)) };
    case "r":
      return { q: l.q, candidates: upright(layout, l, s(d.from), s(d.to)) };
    case "along":
      return { q: l.q, candidates: parallel(l, s(d.from), s(d.to)) };
    case "angle":
      return { q: l.q, candidates: angle(l, s(d.vertex), s(d.from), s(d.to)) };
    case "leader":
      return { q: l.q, candidates: leader(l, s(d.at), s(d.towards)) };
  }
}
