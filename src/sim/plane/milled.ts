import { areaOf } from "../../kernel/area/area.ts";
import { difference, intersection, union, unpacked } from "../../kernel/area/clip.ts";
import { isRapid, type MillMotion } from "../../kernel/plane/mill-motion.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { withoutSlivers } from "../../kernel/area/real-area.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { inStock } from "../contact.ts";
import { cutting, type Cutting } from "../cutting.ts";
import { isStockReplaced, marksOf, type StockMarks } from "../marks.ts";
import type { Checkpoint, PlayPosition } from "../simulation.ts";
import { heightsOf, standingAbove, type MilledBody } from "./body.ts";
import { heightLimits, distinctHeights, type DistinctHeights } from "./depths.ts";
import { sweeper, type Sweeper } from "./swept-below.ts";

/**
 * Inputs of milling: motions of flat end mills, and the bodies with the motion each is valid from, the first from the
 * start.
 */
export interface MilledInput {
  readonly motions: readonly MillMotion[];
  readonly bodies: readonly { readonly step: number; readonly body: MilledBody }[];
}

/** A body at one moment. */
export interface MilledMoment {
  /** The area above each limit at the start of the running motion. Never mutated: the same array is the same area. */
  readonly standing: readonly (readonly Ring[])[];
  /** The sweep of the running motion below each limit, by the non-zero rule; empty where it meets nothing. */
  readonly swept: readonly (readonly Ring[])[];
  /** The initial area between each limit and the one before it: the part of it that remains is not milled. */
  readonly initialBands: readonly (readonly Ring[])[];
}

/** The area above each limit at a moment, less the sweep of the running motion. */
export const areasAt = ({ standing, swept }: Pick<MilledMoment, "standing" | "swept">): readonly (readonly Ring[])[] =>
  standing.map((rings, i) => (swept[i]?.length ? difference(rings, swept[i]) : rings));

/** A rapid that surely runs through material. */
export interface RapidThrough {
  readonly step: number;
  readonly rings: readonly Ring[];
}

/**
 * A milled body in the plane: for each limit, the area above it. Seen from above only, so without overhangs and without
 * residue of ball or pointed tools. Cutting takes time and is done in small batches; a moment not reached yet is shown
 * as far as it is cut.
 */
export interface MilledStock extends DistinctHeights {
  readonly bottom: number;
  readonly top: number;
  /**
   * The heights above which areas are computed, and whether something is lower than all of them without being milled.
   */
  readonly limits: readonly number[];
  readonly hasLower: boolean;
  /** Motions that are cut so far. */
  readonly reached: () => number;
  /** Cuts some more motions; true when all are cut. */
  readonly advance: (motions: number) => boolean;
  readonly at: (position: PlayPosition) => MilledMoment;
  /** False where turning removes material between two motions. */
  readonly isSameBody: (one: number, other: number) => boolean;
  /** Rapids through material, among the motions cut so far. */
  readonly rapids: () => readonly RapidThrough[];
}

/** Motions between two marks; fewer where the sweeps have many corners. */
const MARK = { motions: 40, pieces: 600 } as const;
/** Most rapids reported. */
const MOST_RAPIDS = 50;

/** The area above one limit, cut motion by motion. */
interface Layer {
  readonly limit: number;
  readonly marks: StockMarks;
}

/** The area above a limit. The top counts from a hair below it, and everything is above the bottom. */
function standingOn(body: MilledBody, limit: number, { bottom, top }: Pick<MilledStock, "bottom" | "top">): Ring[] {
  return standingAbove(body, limit <= bottom ? -Infinity : limit >= top ? top - SAME : limit - SAME);
}

/** The area in which a body ends between each limit and the one before it. */
function cameFrom(
  body: MilledBody,
  limits: readonly number[],
  heights: Pick<MilledStock, "bottom" | "top">,
): readonly (readonly Ring[])[] {
  const areas = limits.map((limit) => standingOn(body, limit, heights));
  return areas.map((area, i) => (i === 0 ? area : withoutSlivers(difference(area, areas[i - 1] ?? []))));
}

/** Starts cutting; null without a body. */
export function milledStock({ motions, bodies }: MilledInput): MilledStock | null {
  const first = bodies[0],
    heights = first && heightsOf(first.body);
  if (!heights) return null;
  const { bottom, top } = heights;
  const told = distinctHeights(motions, {
    bottom,
    top,
    shoulders: bodies.flatMap(({ body }) => heightsOf(body)?.shoulders ?? []),
  });
  const lowest = told.heights.at(-1) ?? top,
    area = (body: MilledBody, height: number) => areaOf(standingAbove(body, height));
  const hasLower = bodies.some(({ body }) => area(body, -Infinity) > area(body, lowest - SAME) + SAME);
  const limits = heightLimits(told.heights, heights, hasLower);
  const bodyAt = new Map(bodies.map((each) => [each.step, each]));
  const layers = limits.map((limit): Layer => ({ limit, marks: marksOf() }));
  const rapids: RapidThrough[] = [];
  let cuts: readonly Cutting[] = [],
    next = 0,
    marked = 0;

  const came = bodies.map(({ step, body }) => ({ step, areas: cameFrom(body, limits, heights) }));
  /** The areas left within another body: turning removes material between two milling cuts. */
  const taken = (body: MilledBody, before: readonly (readonly Ring[])[] | null) =>
    limits.map((limit, i) => {
      const own = standingOn(body, limit, heights),
        had = before?.[i];
      return had ? intersection(had, own) : own;
    });
  const begin = (areas: readonly (readonly Ring[])[], step: number, given?: "isStated") => {
    layers.forEach(({ marks }, i) => marks.add(step, areas[i] ?? [], given));
    marked = step;
    return areas.map(cutting);
  };

  const sweeps = sweeper();
  /**
   * A cut exactly as deep as a limit leaves the material at that height, except at the bottom, which is milled through.
   */
  const swept = (m: MillMotion, limit: number, fraction?: number) =>
    sweeps(m, limit + (limit <= bottom ? SAME : -SAME), fraction);

  function look(m: MillMotion, step: number): void {
    if (!isRapid(m) || rapids.length >= MOST_RAPIDS) return;
    const rings = withoutSlivers(
      union(
        limits.flatMap((limit, i) => {
          const now = cuts[i]?.present();
          return now ? inStock(swept(m, limit), now) : [];
        }),
      ),
    );
    if (rings.length > 0) rapids.push({ step, rings });
  }

  function cut(): void {
    const body = bodyAt.get(next),
      m = motions[next];
    if (body) cuts = begin(taken(body.body, next === 0 ? null : cuts.map((c) => c.stock())), next, "isStated");
    else if (next - marked >= MARK.motions || cuts.some((c) => c.pieces >= MARK.pieces))
      cuts = begin(
        cuts.map((c) => c.stock()),
        next,
      );
    if (m) {
      look(m, next);
      limits.forEach((limit, i) => {
        for (const sweep of swept(m, limit)) cuts[i]?.add(sweep);
      });
    }
    next += 1;
  }
  cut();

  const players = layers.map(({ limit, marks }) => layerPlayer(motions, marks.all(), (m) => swept(m, limit)));
  return {
    ...told,
    top,
    bottom,
    limits,
    hasLower,
    reached: () => Math.min(next, motions.length),
    advance(some) {
      for (let i = 0; i < some && next < motions.length; i += 1) cut();
      return next >= motions.length;
    },
    at({ step, fraction }) {
      const whole = Math.max(0, Math.min(step, next)),
        running = whole < step || fraction <= 0 ? undefined : motions[whole];
      const standing = players.map((player) => player(whole));
      return {
        standing,
        swept: limits.map((limit) =>
          running ? swept(running, limit, fraction).flatMap(({ rings }) => [...rings]) : [],
        ),
        initialBands: came.findLast((each) => each.step <= whole)?.areas ?? [],
      };
    },
    isSameBody: (one, other) => !bodies.some(({ step }) => step > Math.min(one, other) && step <= Math.max(one, other)),
    rapids: () => rapids,
  };
}

/** The area of one layer at the start of any motion, from the nearest mark or from the last query. */
function layerPlayer(
  motions: readonly MillMotion[],
  marks: readonly Checkpoint[],
  swept: (m: MillMotion) => ReturnType<Sweeper>,
): (step: number) => readonly Ring[] {
  let now: { mark: number; next: number; cut: Cutting } | null = null;
  let given: { readonly cut: Cutting; readonly pieces: number; readonly area: readonly Ring[] } | null = null;
  /** Returns the same array until something is cut: the picture then skips the comparison. */
  const areaOf = (cut: Cutting): readonly Ring[] => {
    if (given?.cut !== cut || given.pieces !== cut.pieces) given = { cut, pieces: cut.pieces, area: cut.stock() };
    return given.area;
  };
  return (step) => {
    let mark = marks.findLastIndex((each) => each.step <= step);
    while (mark > 0 && !marks[mark]?.stock) mark -= 1;
    if (!now || now.mark < mark || now.next > step)
      now = { mark, next: marks[mark]?.step ?? 0, cut: cutting(unpacked(marks[mark]?.stock ?? [])) };
    while (now.next < step) {
      const m = motions[now.next];
      for (const sweep of m ? swept(m) : []) now.cut.add(sweep);
      now.next += 1;
      const begun: Checkpoint | undefined = marks[now.mark + 1];
      if (begun?.step === now.next)
        now = {
          mark: now.mark + 1,
          next: now.next,
          cut: cutting(isStockReplaced(begun) ? unpacked(begun.stock ?? []) : now.cut.stock()),
        };
    }
    return areaOf(now.cut);
  };
}
