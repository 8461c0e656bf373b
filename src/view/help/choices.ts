import type { Pt } from "../../kernel/geometry/point.ts";
import { toScreen } from "../camera.ts";
import { numberOf, type Context } from "./context.ts";
import type { Lettering } from "./dimensions.ts";
import { along, pointAt } from "./frame.ts";
import { polygon, polyline, type Mark } from "./marks.ts";
import { bandMarks, finishingPath, fallingElements, limit, pathMarks, type Explanation } from "./process.ts";
import { drawnLine } from "./section.ts";
import { filled, stroke } from "./stroke.ts";
import { qOf } from "./topics.ts";

const only = (under: readonly Mark[]): Explanation => ({ under, item: null });
const screen = (c: Context, points: readonly Pt[]) => points.map((p) => toScreen(c.layout.camera, p));
const passMarks = (c: Context, l: Lettering): Mark[] =>
  c.passes.map((p) => stroke(l, "pass", polyline(screen(c, p.line))));

/** A sample of evenly spaced passes, so that their ends can be told apart. */
const some = (c: Context, every: number): Context["passes"] => c.passes.filter((_, i) => i % every === 0);
/** Step of a sample of four passes at most. */
const fourth = (c: Context): number => Math.max(1, Math.ceil(c.passes.length / 4));

/** What is cut: the area, the contour, or the contour with its oversize. */
export function operation(c: Context, l: Lettering): Explanation {
  const value = numberOf(c.values, l.q);
  const rough = value === 0 || value === 1;
  const cut = rough ? [filled(l, "cut", polygon(screen(c, c.plan.area))), ...passMarks(c, l)] : [];
  const left = value === 1 || value === 3 ? bandMarks(c, l, "both", 5) : [];
  const finish = value === 1 ? [] : pathMarks(c, l, finishingPath(c, c.outline.contour, value === 3 ? 9 : 5));
  return only([...cut, ...left, ...finish]);
}

/**
 * Which way the contour is run through (the outline is already in machining direction); the mirrored tool is a small
 * insert at the beginning of the cut.
 */
export function reverse(c: Context, l: Lettering): Explanation {
  const value = numberOf(c.values, l.q);
  const path = finishingPath(c, c.outline.contour, 8);
  const at = path[0];
  const tool: Mark[] = [];
  if (value === 2 && at) {
    const p = toScreen(c.layout.camera, at);
    const side = c.frame.transverse ? 1 : c.frame.signU;
    tool.push(
      filled(
        l,
        "tool",
        polygon([
          p,
          { x: p.x - side * 4, y: p.y - 15 },
          { x: p.x - side * 17, y: p.y - 12 },
          { x: p.x - side * 13, y: p.y + 3 },
        ]),
      ),
    );
  }
  return only([...pathMarks(c, l, path), ...tool]);
}

/** How passes end: along the contour, or lifted at 45°, with or without a last run along the whole contour. */
export function smoothing(c: Context, l: Lettering): Explanation {
  const value = numberOf(c.values, l.q);
  const f = c.frame;
  const passes = some(c, fourth(c));
  const high = passes[1] ? Math.abs((passes[0]?.level ?? 0) - passes[1].level) : c.step;
  const left = drawnLine(c.plan.oversizeReach.map((k) => k.path));
  const lifts = passes.flatMap(({ from, to, level }, i) => {
    if (value !== 0) return pathMarks(c, l, [from, to, pointAt(f, along(f, to) - high, level + high)]);
    const before = passes[i - 1];
    if (!before || before.level <= level) return pathMarks(c, l, [from, to, pointAt(f, along(f, to), level + high)]);
    const between = left.filter((p) => along(f, p) > along(f, to) && along(f, p) < along(f, before.to));
    return pathMarks(c, l, [from, to, ...between, before.to]);
  });
  return only([...lifts, ...(value === 1 ? pathMarks(c, l, finishingPath(c, c.outline.contour, 5)) : [])]);
}

/** Falling elements: machined, or bridged at the level where they begin. */
export function plunging(c: Context, l: Lettering): Explanation {
  const value = numberOf(c.values, l.q);
  const paths =
    value === 1
      ? fallingElements(c).map((run) => finishingPath(c, run))
      : c.plan.reach.flatMap(({ path, reason }) => (reason === "plunging" ? [[path.from, path.to]] : []));
  return only(
    (paths.length > 0 ? paths : [finishingPath(c, c.outline.contour)]).flatMap((path) => pathMarks(c, l, path)),
  );
}

/** The switch for the limits: both lines, strong while the limits apply. */
export function limits(c: Context, l: Lettering): Explanation {
  const tag = { ...l, active: true };
  const [x, z] = [qOf(c.params, "limitDiameter"), qOf(c.params, "limitZ")];
  return only(
    [
      ...(x ? limit(c, { ...tag, q: x }, "diameter").under : []),
      ...(z ? limit(c, { ...tag, q: z }, "z").under : []),
    ].map((m) => ({
      ...m,
      q: l.q,
    })),
  );
}

/** Cutting in alternating directions, or always along the contour. */
export function direction(c: Context, l: Lettering): Explanation {
  // An odd step, so that return passes show too.
  const every = fourth(c) + 1 - (fourth(c) % 2);
  return only(some(c, every).flatMap((p) => pathMarks(c, l, [p.from, p.to])));
}

/** All passes along the contour, as the chosen option divides the stock on it. */
export const cuttingLines = (c: Context, l: Lettering): Explanation =>
  only([filled(l, "cut", polygon(screen(c, c.plan.area))), ...passMarks(c, l)]);
