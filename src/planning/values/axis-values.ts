import { METRIC } from "../../kernel/contour/metric-thread.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import {
  DEEP_HOLES,
  HSS_DRILL,
  HSS_REAMER,
  MOST_DRILL_FEED,
  MOST_FIRST_PASS,
  PECKS,
  SPEED_SHARE,
  THREAD_PASSES,
} from "../../program/tools/cutting-work.ts";
import { specificForce } from "../../report/advice/formulas.ts";
import { atLeast, LEAST, leastOf, reasoned, typedDown, type ReasonedNumber, type ValueFormula } from "./formulas.ts";
import { constantSpindle, GRID, powerFor } from "./spindle-values.ts";
import { feedForForce } from "../../report/advice/stability.ts";
import type { CuttingValues, ValuesRequest } from "./values-request.ts";

/** Threads: a constant speed within the feed rate of the machine. */
export function threading(request: ValuesRequest): CuttingValues {
  const { material, largest, depth = 0, pitch = 1, fastest } = request;
  const vc = Math.round(material.roughSpeed * SPEED_SHARE.thread);
  const byRate = fastest ? reasoned(fastest / pitch, "rpmOfThread", "pitch", { vf: fastest, P: pitch }) : null;
  const passes = THREAD_PASSES.find(([upTo]) => pitch <= upTo)?.[1] ?? 1;
  // A depth of 0 leaves it to the control, which takes that of the metric profile.
  const h = depth > 0 ? depth : METRIC.outside * pitch;
  const first = leastOf(
    reasoned(h / Math.sqrt(passes), "depthOfThread", "pitch", { h, i: passes }),
    reasoned(MOST_FIRST_PASS, "depthOfTooth", "insert", {}),
  );
  return {
    ...constantSpindle(request, vc, largest, byRate),
    feed: reasoned(pitch, "feedOfPitch", "pitch", { P: pitch }),
    infeed: typedDown(first, GRID.feed),
    plungeFeed: null,
    step: null,
    oversize: null,
    risks: [],
  };
}

/** A wider hole is no pilot: what it leaves is a share of the diameter. */
const MOST_PILOT = 0.9;

/** Drills and centre drills of high-speed steel, on the axis; `smallest`: the diameter of the hole that is there. */
export function drilling(request: ValuesRequest): CuttingValues {
  const { tool, material, depth = 0, work, smallest, largest } = request;
  const d = Math.max(work === "centre" ? largest : toDiameter(radius(tool.R ?? 0)), 0.5);
  const across = work === "centre" ? (tool.centre?.hole.d1 ?? d) : d;
  const data = HSS_DRILL[material.group] ?? HSS_DRILL.S ?? { speed: 1, feed: 0.01 };
  const deep = work === "drill" ? DEEP_HOLES.findLast(([from]) => depth / d >= from) : undefined;
  const [, slower, finer] = deep ?? [0, 1, 1];
  const vc = Math.round(data.speed * slower);
  const turning = constantSpindle(request, vc, d);
  const c = data.feed * finer;
  const power = powerFor(request, turning.spindle);
  const cut = Math.max((Math.PI * d * turning.speed.value) / 1000, 1);
  // Both edges cut half of the diameter, at half of the speed on average; a pilot hole leaves its share undone.
  const share = 1 - Math.min(smallest / d, MOST_PILOT) ** 2;
  const strong = feedForForce((240_000 * power) / (cut * share), material, d);
  const feed = leastOf(
    reasoned(c * across, "feedOfDrill", "material", { c, d: across }),
    reasoned(MOST_DRILL_FEED, "feedOfMaterial", "material", { f: MOST_DRILL_FEED }),
    reasoned(strong, "feedOfPower", "power", {
      Pc: power,
      b: d,
      vc: cut,
      kc: Math.round(specificForce(material, strong)),
    }),
  );
  return {
    ...turning,
    feed: typedDown(atLeast(feed, Math.min(LEAST.feed, strong), "feedLeast"), GRID.feed),
    infeed: null,
    plungeFeed: null,
    step: deep
      ? typedDown(reasoned(d, "stepOfDiameter", "depth", { d }), GRID.depth)
      : reasoned(depth, "wholeDepth", "depth", { t: depth }),
    oversize: null,
    risks: HSS_DRILL[material.group] ? [] : [{ kind: "notDrilled", ratio: 0 }],
  };
}

/** The pecks of a drill in a deep hole, mm: the first one, how much shorter each next one is, and the shortest. */
export function pecks(tool: Tool): Readonly<Record<"first" | "less" | "least", ReasonedNumber>> {
  const d = toDiameter(radius(tool.R ?? 0));
  const typed = (share: number, formula: ValueFormula) =>
    typedDown(reasoned(share * d, formula, "depth", { d }), GRID.depth);
  return {
    first: typed(PECKS.first, "stepFirst"),
    less: typed(PECKS.less, "stepLess"),
    least: typed(PECKS.least, "stepOfDiameter"),
  };
}

/** Whether a drill clears its chips in a hole of a depth, mm. */
export const isDeepHole = (tool: Tool, depth: number): boolean =>
  depth / toDiameter(radius(tool.R ?? 0)) >= (DEEP_HOLES[0]?.[0] ?? Infinity);

/** Reamers of high-speed steel, on the axis. */
export function reaming(request: ValuesRequest): CuttingValues {
  const { tool, material } = request;
  const d = toDiameter(radius(tool.R ?? 0));
  const data = HSS_DRILL[material.group] ?? HSS_DRILL.S ?? { speed: 1, feed: 0.01 };
  const { speed, feed: c, most } = HSS_REAMER;
  const feed = leastOf(
    reasoned(c * d, "feedOfReamer", "material", { c, d }),
    reasoned(most, "feedOfMaterial", "material", { f: most }),
  );
  return {
    ...constantSpindle(request, Math.round(data.speed * speed), d),
    feed: typedDown(atLeast(feed, LEAST.feed, "feedLeast"), GRID.feed),
    infeed: null,
    plungeFeed: null,
    step: null,
    oversize: null,
    risks: HSS_DRILL[material.group] ? [] : [{ kind: "notDrilled", ratio: 0 }],
  };
}
