import type { Pt } from "../../kernel/point.ts";
import { toScreen } from "../camera.ts";
import { numberOf, type Context } from "./context.ts";
import type { Lettering } from "./dimensions.ts";
import { along, outward, pointAt } from "./frame.ts";
import { polygon, polyline, type Mark } from "./marks.ts";
import { falling } from "./passes.ts";
import { bandMarks, besides, limit, pathMarks, type Explanation } from "./process.ts";
import { filled, stroke } from "./stroke.ts";
import { qOf } from "./topics.ts";

const only = (under: readonly Mark[]): Explanation => ({ under, item: null });
const screen = (c: Context, points: readonly Pt[]) => points.map((p) => toScreen(c.layout.camera, p));
const passMarks = (c: Context, l: Lettering): Mark[] => c.passes.map((p) => stroke(l, "pass", polyline(screen(c, [p.from, p.to]))));

/** A few passes that stand for all, evenly spread, so that their ends can be told apart. */
function some(c: Context, count: number): Context["passes"] {
  const every = Math.max(1, Math.ceil(c.passes.length / count));
  return c.passes.filter((_, i) => i % every === 0);
}

/** What is cut: the area, the contour, or the contour with its oversize. */
export function operation(c: Context, l: Lettering): Explanation {
  const value = numberOf(c.values, l.q);
  const rough = value === 0 || value === 1;
  const cut = rough ? [filled(l, "cut", polygon(screen(c, c.section.area))), ...passMarks(c, l)] : [];
  const left = value === 1 || value === 3 ? bandMarks(c, l, "both", 5) : [];
  const finish = value === 1 ? [] : pathMarks(c, l, besides(c, c.section.line, value === 3 ? 9 : 5));
  return only([...cut, ...left, ...finish]);
}

/**
 * Which way the contour is run through (the outline is already in machining direction); the mirrored tool is a small insert at
 * the beginning of the cut.
 */
export function reverse(c: Context, l: Lettering): Explanation {
  const value = numberOf(c.values, l.q);
  const path = besides(c, c.section.line, 8);
  const at = path[0];
  const tool: Mark[] = [];
  if (value === 2 && at) {
    const p = toScreen(c.layout.camera, at);
    const side = c.frame.infeed === "r" ? c.frame.feed : 1;
    tool.push(
      filled(l, "tool",
        polygon([p, { x: p.x - side * 4, y: p.y - 15 }, { x: p.x - side * 17, y: p.y - 12 }, { x: p.x - side * 13, y: p.y + 3 }])),
    );
  }
  return only([...pathMarks(c, l, path), ...tool]);
}

/** How passes end: along the contour, or lifted at 45°, with or without a last run along the whole contour. */
export function smoothing(c: Context, l: Lettering): Explanation {
  const value = numberOf(c.values, l.q);
  const f = c.frame;
  const passes = some(c, 4);
  const high = passes[1] ? Math.abs((passes[0]?.level ?? 0) - passes[1].level) : c.step;
  const lifts = passes.flatMap((pass, i) => {
    const end = pass.to;
    const level = pass.level + high;
    if (value === 0) {
      const before = passes[i - 1];
      const up = before && before.level > pass.level ? before.to : pointAt(f, along(f, end), level);
      return [pathMarks(c, l, [pass.from, end, up])];
    }
    return [pathMarks(c, l, [pass.from, end, pointAt(f, along(f, end) - high, level)])];
  });
  return only([...lifts.flat(), ...(value === 1 ? pathMarks(c, l, besides(c, c.section.line, 5)) : [])]);
}

/** Falling elements: machined, or bridged at the level where they begin. */
export function plunging(c: Context, l: Lettering): Explanation {
  const value = numberOf(c.values, l.q);
  const f = c.frame;
  const runs = falling(f, c.section.line);
  if (value === 1)
    return only(runs.length > 0 ? runs.flatMap((run) => pathMarks(c, l, besides(c, run))) : pathMarks(c, l, besides(c, c.section.line)));
  const bridges = runs.flatMap((run) => {
    const from = run[0];
    if (!from) return [];
    const level = outward(f, from);
    const rest = c.section.line.slice(c.section.line.indexOf(from) + 1);
    const back = rest.findIndex((p, i) => i > 0 && outward(f, p) >= level - 1e-6);
    const to = rest[back] ?? rest.at(-1) ?? from;
    return [pathMarks(c, l, [from, pointAt(f, along(f, to), level)])];
  });
  return only(bridges.length > 0 ? bridges.flat() : pathMarks(c, l, besides(c, c.section.line)));
}

/** The switch of the limits: both lines, strong when they hold. */
export function limits(c: Context, l: Lettering): Explanation {
  const tag = { ...l, active: true };
  const [x, z] = [qOf(c.params, "limitDiameter"), qOf(c.params, "limitZ")];
  return only(
    [...(x ? limit(c, { ...tag, q: x }, "diameter").under : []), ...(z ? limit(c, { ...tag, q: z }, "z").under : [])].map((m) => ({
      ...m,
      q: l.q,
    })),
  );
}

/** Cutting both ways in turn, or always the way of the contour. */
export function direction(c: Context, l: Lettering): Explanation {
  const both = numberOf(c.values, l.q) === 0;
  return only(some(c, 4).flatMap((p, i) => pathMarks(c, l, both && i % 2 === 1 ? [p.to, p.from] : [p.from, p.to])));
}
