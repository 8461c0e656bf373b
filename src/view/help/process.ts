import type { Dimension } from "../../cycles/define.ts";
import { fallingRuns } from "../../kernel/reach/bridge.ts";
import { segmentToFlat, segmentToPart } from "../../kernel/geometry/flat.ts";
import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { oversizeContour } from "../../kernel/strategy/oversize-contour.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import { toScreen, type Place } from "../camera.ts";
import { longest, numberOf, startPoint, type Context } from "./context.ts";
import { dimensionItem, leader, type Lettering } from "./dimensions.ts";
import { along, infeedForm, openSide, outward, pointAt } from "./frame.ts";

import { spot } from "./layout.ts";
import { arrowHead, circle, polygon, polyline, segmentPath, type Mark } from "./marks.ts";
import { drawnLine } from "./section.ts";
import { filled, stroke, type HelpItem, type Tag } from "./stroke.ts";
import { partnerOf, qOf, shownAs } from "./topics.ts";
import { SAME } from "../../kernel/tolerance.ts";

/** Marks that are always drawn, and a dimension that needs a place for its text. */
export interface Explanation {
  readonly under: readonly Mark[];
  readonly item: HelpItem | null;
}

/** Least drawn width of a small length while its prompt is active, and at other times, pixels. */
const SHOWN = { active: 8, quiet: 3 } as const;
/** Distance of a drawn tool path from the contour, pixels. */
const BESIDE = 6;

const screen = (c: Context, points: readonly Pt[]): Place[] => points.map((p) => toScreen(c.layout.camera, p));
const mm = (c: Context, pixels: number) => pixels / c.layout.camera.scale;
const pointed = (c: Context, l: Lettering, at: Pt, towards: Pt): HelpItem => ({
  q: l.q,
  candidates: leader(l, spot(c.layout, at), spot(c.layout, towards)),
});
/** A point a little outside the material, from another point. */
const outside = (c: Context, p: Pt): Pt => pointAt(c.frame, along(c.frame, p), outward(c.frame, p) + mm(c, 20));

/** A tool path with an arrowhead at its end. */
export function pathMarks(c: Context, tag: Tag, points: readonly Pt[]): Mark[] {
  const places = screen(c, points);
  const [tip, before] = [
    places.at(-1),
    [...places].reverse().find((p) => Math.hypot(p.x - (places.at(-1)?.x ?? 0), p.y - (places.at(-1)?.y ?? 0)) > 3),
  ];
  if (!tip || !before) return [];
  return [
    stroke(tag, "path", polyline(places)),
    filled(tag, "arrow", arrowHead(tip, tip.x - before.x, tip.y - before.y, 9)),
  ];
}

/** The contour with an oversize of so many pixels. */
const kept = (c: Context, contour: readonly Segment[], z: number, r: number): Segment[] =>
  oversizeContour(contour, c.frame, { z: mm(c, z), r: mm(c, r) });

/** The path of the finishing cut, a little beside the drawn contour; farther off where oversize is left. */
export const finishingPath = (c: Context, contour: readonly Segment[], pixels: number = BESIDE): Pt[] =>
  drawnLine(kept(c, contour, pixels, pixels));

/** The falling elements of the contour in machining direction, in runs of consecutive ones. */
export const fallingElements = (c: Context): Segment[][] =>
  fallingRuns(c.outline.contour.map((s) => segmentToFlat(c.frame, s))).map((run) =>
    run.map((s) => segmentToPart(c.frame, s)),
  );

/** The band of the oversize, drawn wider than to scale; both components, or only the requested one. */
export function bandMarks(c: Context, tag: Tag, which: "diameter" | "z" | "both", pixels: number): Mark[] {
  const outer = drawnLine(kept(c, c.outline.contour, which === "diameter" ? 0 : pixels, which === "z" ? 0 : pixels));
  const band = [...c.section.line, ...outer.toReversed()];
  return [filled(tag, "oversize", polygon(screen(c, band))), stroke(tag, "break", polyline(screen(c, outer)))];
}

export function clearance(c: Context, l: Lettering): Explanation {
  const value = Math.max(numberOf(c.values, l.q), mm(c, 1));
  const s = startPoint(c.frame, c.section.corner, value);
  const centre = toScreen(c.layout.camera, s);
  const cross =
    `${polyline([
      { x: centre.x - 6, y: centre.y },
      { x: centre.x + 6, y: centre.y },
    ])}` +
    `${polyline([
      { x: centre.x, y: centre.y - 6 },
      { x: centre.x, y: centre.y + 6 },
    ])}`;
  const form = c.frame.sunk ? infeedForm(c.frame) : "z";
  return {
    under: [stroke(l, "frame", circle(centre, 3.5) + cross)],
    item:
      c.params[l.q]?.reserved && !l.active
        ? null
        : dimensionItem(c.layout, { q: l.q, form, from: c.section.corner, to: s }, l),
  };
}

export function infeed(c: Context, l: Lettering): Explanation {
  if (c.plan.isParallel) return infeedAlongContour(c, l);
  const u = along(c.frame, c.section.corner);
  const [from, to] = [pointAt(c.frame, u, c.top), pointAt(c.frame, u, c.top - c.step)];
  const lines = mm(c, 3) > c.step ? c.passes.slice(0, 3) : c.passes;
  return {
    under: lines.map((p) => stroke(l, "pass", polyline(screen(c, p.line)))),
    item: dimensionItem(c.layout, { q: l.q, form: infeedForm(c.frame), from, to }, l),
  };
}

/** A point on the contour, and another one `by` mm square to it. */
function offsetPoint(c: Context, by: number): { readonly at: Pt; readonly off: Pt } {
  const { element, at } = longest(c, () => true);
  const away = element ? part.scaled(part.leftOf(part.direction(element, at)), openSide(c.frame)) : part.point(0, 1);
  return { at, off: part.beyond(at, away, by) };
}

/** The infeed of passes along the contour: the first of them, square to the blank. */
function infeedAlongContour(c: Context, l: Lettering): Explanation {
  const blank = numberOf(c.values, qOf(c.params, "allowance"));
  const [from, to] = [offsetPoint(c, blank).off, offsetPoint(c, blank - c.step).off];
  return {
    under: c.passes.map((p) => stroke(l, "pass", polyline(screen(c, p.line)))),
    item: dimensionItem(c.layout, { q: l.q, form: "along", from, to }, l),
  };
}

/** The allowance on the contour before the cycle, square to it. */
export function allowance(c: Context, l: Lettering): Explanation {
  const value = numberOf(c.values, l.q);
  const { at, off } = offsetPoint(c, Math.max(value, mm(c, 1)));
  const outer = drawnLine(oversizeContour(c.outline.contour, c.frame, { z: 0, r: 0, round: value }));
  const band = l.active ? [filled(l, "cut", polygon(screen(c, [...c.section.line, ...outer.toReversed()])))] : [];
  return {
    under: [...band, stroke(l, "break", polyline(screen(c, outer)))],
    item: dimensionItem(c.layout, { q: l.q, form: "along", from: at, to: off }, l),
  };
}

export function oversize(c: Context, l: Lettering, which: "diameter" | "z"): Explanation {
  const pixels = l.active ? SHOWN.active : SHOWN.quiet;
  const steep = (dz: number, dr: number) => dr > dz * 1.2;
  const { element, at } = longest(c, which === "z" ? steep : (dz, dr) => dz > dr * 1.2);
  const away = element ? part.scaled(part.leftOf(part.direction(element, at)), openSide(c.frame)) : at;
  const size = (n: number) => (n < 0 ? -1 : 1) * mm(c, pixels);
  const off: Pt = which === "z" ? part.point(at.z + size(away.z), at.r) : part.point(at.z, at.r + size(away.r));
  return {
    under: l.active ? bandMarks(c, l, which, pixels) : [],
    item: l.active
      ? dimensionItem(
          c.layout,
          { q: l.q, form: which === "z" ? "z" : "r", from: at, to: off },
          { ...l, underlined: true },
        )
      : { ...pointed(c, l, at, outside(c, at)), most: 7 },
  };
}

export function roughingFeed(c: Context, l: Lettering): Explanation {
  const pass = c.passes[Math.min(1, c.passes.length - 1)];
  if (!pass) return { under: [], item: pointed(c, l, c.section.corner, outside(c, c.section.corner)) };
  const lines = l.active ? c.passes.map((p) => stroke(l, "pass", polyline(screen(c, p.line)))) : [];
  const at = (t: number): Pt => part.beyond(pass.from, part.difference(pass.to, pass.from), t);
  if (c.plan.isParallel) {
    const middle = pass.line[Math.floor(pass.line.length / 2)] ?? pass.from;
    return { under: [...lines, ...pathMarks(c, l, pass.line)], item: pointed(c, l, middle, outside(c, middle)) };
  }
  return {
    under: [...lines, ...pathMarks(c, l, [at(0.25), at(0.7)])],
    item: pointed(c, l, at(0.5), outside(c, at(0.5))),
  };
}

export function finishingFeed(c: Context, l: Lettering): Explanation {
  const { at } = longest(c, () => true);
  const found = kept(c, c.outline.contour, BESIDE, BESIDE).map((s) => part.nearestOn(s, at));
  const middle = found.reduce(
    (best, p) => (part.apart(p, at) < part.apart(best, at) ? p : best),
    found[0] ?? c.section.corner,
  );
  return {
    under: l.active ? pathMarks(c, l, finishingPath(c, c.outline.contour)) : [],
    item: pointed(c, l, middle, outside(c, middle)),
  };
}

export function plungingFeed(c: Context, l: Lettering): Explanation {
  const found = fallingElements(c);
  const u = along(c.frame, c.section.corner);
  const runs =
    found.length > 0
      ? found.map((run) => finishingPath(c, run))
      : [[pointAt(c.frame, u, c.top + mm(c, 14)), pointAt(c.frame, u, c.top - c.step)]];
  const first = runs[0] ?? [];
  const middle = first[Math.floor(first.length / 2)] ?? c.section.corner;
  return {
    under: l.active ? runs.flatMap((run) => pathMarks(c, l, run)) : [],
    item: pointed(c, l, middle, outside(c, middle)),
  };
}

/** A limit goes across the whole drawing; it is dashed while the limits are off. */
export function limit(c: Context, l: Lettering, which: "diameter" | "z"): Explanation {
  const on = numberOf(c.values, qOf(c.params, "limits")) === 1;
  if (!on && !l.active) return { under: [], item: null };
  const value = numberOf(c.values, l.q);
  const { reach } = c.layout;
  const at: Pt = which === "z" ? part.point(value, reach.high) : part.point(reach.right, toRadius(diameter(value)));
  const far: Pt = which === "z" ? part.point(value, reach.low) : part.point(reach.left, at.r);
  const line = stroke(l, on ? "limit" : "break", polyline([spot(c.layout, at), spot(c.layout, far)]));
  const form =
    which === "z"
      ? dimensionItem(c.layout, { q: l.q, form: "z", from: at, to: at }, l)
      : dimensionItem(c.layout, { q: l.q, form: "diameter", at }, l);
  return { under: [line], item: form };
}

export function offsetWidth(c: Context, l: Lettering): Explanation {
  if (!l.active) return { under: [], item: null };
  const pass = c.passes[Math.min(1, c.passes.length - 1)];
  if (!pass) return { under: [], item: pointed(c, l, c.section.corner, outside(c, c.section.corner)) };
  const value = Math.max(numberOf(c.values, l.q), mm(c, SHOWN.active));
  const way = Math.sign(along(c.frame, pass.to) - along(c.frame, pass.from));
  const end = pointAt(c.frame, along(c.frame, pass.to) - way * value, pass.level);
  const form = c.frame.transverse ? "r" : "z";
  return {
    under: pathMarks(c, l, [pass.from, end]),
    item: dimensionItem(c.layout, { q: l.q, form, from: end, to: pass.to }, { ...l, underlined: true }),
  };
}

export function depthCompensation(c: Context, l: Lettering): Explanation {
  if (!l.active) return { under: [], item: null };
  const line = c.section.line,
    f = c.frame;
  const low = Math.min(...line.map((p) => outward(f, p)));
  const floor = line.filter((p) => outward(f, p) < low + SAME).map((p) => along(f, p));
  const [a, b] = [Math.min(...floor), Math.max(...floor)];
  const value = numberOf(c.values, l.q);
  const by = (Math.sign(value) || 1) * mm(c, SHOWN.active);
  const shift = c.values[l.q] === 0 ? 0 : by;
  return {
    under: pathMarks(c, l, [pointAt(f, a, low + shift), pointAt(f, b, low + shift)]),
    item: dimensionItem(
      c.layout,
      {
        q: l.q,
        form: infeedForm(f),
        from: pointAt(f, (a + b) / 2, low),
        to: pointAt(f, (a + b) / 2, low + by),
      },
      {
        ...l,
        underlined: true,
      },
    ),
  };
}

/** Highest cost of a quiet diameter: dearer places lie in the middle of the contour. */
const OUTSIDE = 19;

/**
 * Dimensions of the start and the end of a free contour: not values of the cycle, so they belong to no parameter. A
 * value that both ends share is written once.
 */
export function plainDimensions(c: Context): HelpItem[] {
  if (c.outline.dimensions.some((d) => shownAs(c.params, d.q) === "outline")) return [];
  const [start, end] = [c.section.line[0], c.section.line.at(-1)];
  const ends = [start, end].flatMap((p) => (p ? [p] : []));
  const isNew = (at: Pt, one: (p: Pt) => number) => at === start || !start || Math.abs(one(at) - one(start)) > SAME;
  return ends.flatMap((at) => [
    ...(isNew(at, (p) => p.r)
      ? [{ ...dimensionItem(c.layout, { q: "", form: "diameter", at }, c.plain("diameter", at)), most: OUTSIDE }]
      : []),
    ...(isNew(at, (p) => p.z)
      ? [dimensionItem(c.layout, { q: "", form: "z", from: part.point(0, at.r), to: at }, c.plain("axial", at))]
      : []),
  ]);
}

/** A dimension of the outline; a parameter without one on this contour points at the end it belongs to. */
export function outlined(c: Context, l: Lettering, partner: string | null): Explanation {
  const own = c.outline.dimensions.filter((d) => d.q === l.q || d.q === partner);
  const d = own.find((o) => o.q === l.q) ?? own[0];
  const type = partnerOf(c.params, l.q);
  const without = type !== null && numberOf(c.values, c.params[l.q]?.kind === "choice" ? l.q : type) === 0;
  const nothing = c.params[l.q]?.rounds && numberOf(c.values, l.q) === 0;
  if (d && (l.active || !(without || nothing))) {
    const snapped = d.form === "leader" && !without ? { ...d, at: elementAt(c, d.at)?.at ?? d.at } : d;
    return { under: without ? [] : elementMarks(c, l, d), item: dimensionItem(c.layout, { ...snapped, q: l.q }, l) };
  }
  if (!l.active) return { under: [], item: null };
  const at = c.section.line.at(c.params[l.q]?.place === "end" ? -1 : 0) ?? c.section.corner;
  return { under: [stroke(l, "frame", circle(spot(c.layout, at), 6))], item: pointed(c, l, at, outside(c, at)) };
}

/** The element a leader points at, strong while its parameter is active. */
function elementMarks(c: Context, l: Lettering, d: Dimension): Mark[] {
  if (!l.active || d.form !== "leader") return [];
  const found = elementAt(c, d.at);
  return found ? [stroke(l, "element", segmentPath([found.element], c.layout.camera))] : [];
}

/** The element whose middle lies nearest to a point, and that middle. */
export function nearestElement(
  contour: readonly Segment[],
  at: Pt,
): { readonly element: Segment; readonly at: Pt } | null {
  let best: { element: Segment; at: Pt } | null = null;
  let least = Infinity;
  for (const element of contour) {
    const middle = part.pointOn(element, 0.5);
    const gap = Math.hypot(middle.z - at.z, middle.r - at.r);
    if (gap < least) [best, least] = [{ element, at: middle }, gap];
  }
  return best;
}

/** The contour element at which a leader points. */
export const elementAt = (c: Context, at: Pt) => nearestElement(c.outline.contour, at);
