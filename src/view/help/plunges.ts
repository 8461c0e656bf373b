import { CHIP_BREAK } from "../../kernel/strategy/plunge-cuts.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import { toScreen } from "../camera.ts";
import { numberOf, type Context } from "./context.ts";
import { dimensionItem, leader, type Lettering } from "./dimensions.ts";
import { along, infeedForm, outward, pointAt } from "./frame.ts";

import { spot } from "./layout.ts";
import { circle, polyline, type Mark } from "./marks.ts";
import { plungesOf, type Pass } from "./passes.ts";
import { pathMarks, type Explanation } from "./process.ts";
import { stroke, type HelpItem } from "./stroke.ts";

/* Parameters of the recessing cycles, drawn on the plunges that the cycle plans for a point. */

const NOTHING: Explanation = { under: [], item: null };
const mm = (c: Context, pixels: number) => pixels / c.layout.camera.scale;
const raised = (c: Context, p: Pt, by: number): Pt => pointAt(c.frame, along(c.frame, p), outward(c.frame, p) + by);
const lines = (c: Context, l: Lettering, all: readonly Pass[]): Mark[] =>
  all.map((p) => stroke(l, "pass", polyline([p.from, p.to].map((at) => toScreen(c.layout.camera, at)))));
const pointed = (c: Context, l: Lettering, at: Pt): HelpItem => ({
  q: l.q,
  candidates: leader(l, spot(c.layout, at), spot(c.layout, raised(c, at, mm(c, 20)))),
});
/** Fallback without a plunge: the value points at the corner of the area. */
const cornerLeader = (c: Context, l: Lettering): Explanation => ({ under: [], item: pointed(c, l, c.section.corner) });

/** The deepest plunges side by side, from the first one on. */
function plunges(c: Context): Pass[] {
  const all = plungesOf(c.frame, c.plan.moves);
  const deepest = Math.min(...all.map((p) => p.level));
  const full = all.filter((p) => p.level < deepest + mm(c, 1));
  return full.length > 1 ? full : all;
}

/** The lateral offset between two neighbours. */
export function sideStep(c: Context, l: Lettering): Explanation {
  if (!l.active) return NOTHING;
  const [a, ...others] = plunges(c);
  if (!a) return cornerLeader(c, l);
  const apart = (p: Pass) => Math.abs(along(c.frame, p.to) - along(c.frame, a.to));
  const [b] = others.filter((p) => apart(p) > mm(c, 1)).sort((x, y) => apart(x) - apart(y));
  if (!b) return { under: lines(c, l, [a]), item: pointed(c, l, a.to) };
  const form = c.frame.transverse ? "r" : "z";
  const level = (a.level + outward(c.frame, a.from)) / 2;
  const [from, to] = [a, b].map((p) => pointAt(c.frame, along(c.frame, p.to), level)) as [Pt, Pt];
  return {
    under: lines(c, l, plunges(c)),
    item: dimensionItem(c.layout, { q: l.q, form, from, to }, { ...l, underlined: true }),
  };
}

/** The first plunge, into the solid. */
export function solidFeed(c: Context, l: Lettering): Explanation {
  if (!l.active) return NOTHING;
  const [first] = plunges(c);
  if (!first) return cornerLeader(c, l);
  const middle = pointAt(c.frame, along(c.frame, first.to), (outward(c.frame, first.from) + first.level) / 2);
  return { under: pathMarks(c, l, [first.from, first.to]), item: pointed(c, l, middle) };
}

/** The bottom of a plunge, where the tool dwells. */
export function dwell(c: Context, l: Lettering): Explanation {
  if (!l.active) return NOTHING;
  const [first] = plunges(c);
  if (!first) return cornerLeader(c, l);
  const ring = stroke(l, "frame", circle(toScreen(c.layout.camera, first.to), 5));
  return { under: [...lines(c, l, [first]), ring], item: pointed(c, l, first.to) };
}

/** One infeed step of a plunge; 0: the whole depth at once. */
export function depthLimit(c: Context, l: Lettering): Explanation {
  if (!l.active) return NOTHING;
  const [first] = plunges(c);
  if (!first) return cornerLeader(c, l);
  const [u, high] = [along(c.frame, first.to), outward(c.frame, first.from)];
  const depth = high - first.level;
  const limit = numberOf(c.values, l.q);
  const bites = limit > 0 && limit < depth ? Math.ceil(depth / limit) : 1;
  const back = Math.max(CHIP_BREAK, mm(c, 4));
  const path = Array.from({ length: Math.min(bites, 12) }, (_, k) => high - (depth * (k + 1)) / bites).flatMap(
    (v, k, all) =>
      k < all.length - 1 && depth / bites > 2 * back
        ? [pointAt(c.frame, u, v), pointAt(c.frame, u, v + back)]
        : [pointAt(c.frame, u, v)],
  );
  const to = pointAt(c.frame, u, high - depth / bites);
  return {
    under: pathMarks(c, l, [first.from, ...path]),
    item: dimensionItem(c.layout, { q: l.q, form: infeedForm(c.frame), from: pointAt(c.frame, u, high), to }, l),
  };
}

/** Retraction from the second plunge: straight, or first towards the previous one. */
export function retraction(c: Context, l: Lettering): Explanation {
  const [a, b] = plunges(c);
  const from = b ?? a;
  if (!from) return NOTHING;
  const u = along(c.frame, from.to);
  const by = a && b ? along(c.frame, a.to) - u : 0;
  const top = outward(c.frame, from.from);
  const up = Math.min(Math.abs(by), top - from.level);
  const lean =
    numberOf(c.values, l.q) === 1 && up > 0 ? [pointAt(c.frame, u + Math.sign(by) * up, from.level + up)] : [];
  const out = pointAt(c.frame, u + (lean.length > 0 ? Math.sign(by) * up : 0), top + mm(c, 12));
  return { under: [...lines(c, l, [from]), ...pathMarks(c, l, [from.to, ...lean, out])], item: null };
}

/** The order of the plunges: the first four of them, each drawn a little shorter than the previous one. */
export function comb(c: Context, l: Lettering): Explanation {
  const order = plunges(c).slice(0, 4);
  return { under: order.flatMap((p, i) => pathMarks(c, l, [p.from, raised(c, p.to, mm(c, 7 * i))])), item: null };
}
