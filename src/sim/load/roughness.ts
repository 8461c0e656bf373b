import { isDrill } from "../../kernel/cutter/drill.ts";
import type { Convex } from "../../kernel/reach/convex.ts";
import type { Flat } from "../../kernel/geometry/flat.ts";
import { insertShape } from "../../kernel/cutter/insert.ts";
import { part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { pathOf } from "../../kernel/time/time.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { PlayPosition } from "../simulation.ts";
import { cuspOf, rzByRule, rzOfCircle, type Cusp } from "./cusp.ts";
import { feedPerTurn, rpmAt, spindleAt, type SpindleFrom } from "./spindles.ts";
import { surfaceOrigins, surfaceOf, type SurfaceOrigin } from "./surface.ts";

/**
 * What forms a stretch of the finished surface: the nose alone, or with an edge ("partly"); a straight edge along the
 * surface; the shape of a tool at the end of its move; a thread; a drill; or unknown, without a feed per revolution.
 */
export type FormedBy = Cusp["by"] | "shape" | "thread" | "drill" | "unknown";

/** A stretch of the finished surface made by one move. */
export interface RoughStretch {
  readonly points: Ring;
  /** The moment at which the tool was at its middle. */
  readonly position: PlayPosition;
  readonly block: number;
  readonly operation: number | null;
  readonly by: FormedBy;
  /**
   * Theoretical Rz, µm: f²/(8·r) for the nose alone, the outline's cusp height where an edge takes part; null
   * otherwise.
   */
  readonly rz: number | null;
  /** Exact cusp height of the nose circle or of the insert's outline, µm. */
  readonly exact: number | null;
  /** Feed, mm/rev, and nose radius, mm. */
  readonly feed: number;
  readonly nose: number | null;
}

/** Rounding of feeds (mm) and directions, so that equal cusps are computed once. */
const ALIKE = 1e4;

type Formed = Pick<RoughStretch, "by" | "rz" | "exact" | "feed" | "nose">;

const without = (by: FormedBy, feed = NaN): Formed => ({ by, rz: null, exact: null, feed, nose: null });

function formedBy(cusp: Cusp | null, feed: number): Formed {
  if (!cusp) return without("unknown", feed);
  const { by, nose, height } = cusp;
  if (by === "edge") return without("edge", feed);
  const outline = nose === null ? height * 1000 : Math.min(height * 1000, rzByRule(feed, nose));
  return by === "nose" && nose !== null
    ? { by, rz: rzByRule(feed, nose), exact: rzOfCircle(feed, nose), feed, nose }
    : { by, rz: outline, exact: outline, feed, nose };
}

function forming(spindles: readonly SpindleFrom[]) {
  const shapes = new Map<Tool, Convex>();
  const known = new Map<Convex, Map<string, Formed>>();
  const cusp = (tool: Tool, out: Flat, feed: number): Formed => {
    const shape = shapes.get(tool) ?? insertShape(tool, true);
    shapes.set(tool, shape);
    const made = known.get(shape) ?? new Map<string, Formed>();
    known.set(shape, made);
    const key = [out.u, out.v, feed].map((n) => Math.round(n * ALIKE)).join();
    const formed = made.get(key) ?? formedBy(cuspOf(shape, out, feed), feed);
    made.set(key, formed);
    return formed;
  };
  return ({ out, tip, along }: SurfaceOrigin, index: number, { move, tool }: Step): Formed => {
    if (move.kind === "thread") return without("thread");
    if (isDrill(tool)) return without("drill");
    if (!along) return without("shape");
    return cusp(tool, out, feedPerTurn(move, rpmAt(spindleAt(spindles, index), tip.r)));
  };
}

/** Shorter pieces are rounding of an outline and join the piece before them, mm. */
const NO_PIECE = 0.05;

const joins = (a: Pt, b: Pt) => part.apart(a, b) <= SAME;

/** The fraction of a move at which its tip is at a point of its path. */
function fractionOf(step: Step, tip: Pt): number {
  const path = pathOf(step.from, step.move),
    long = part.lengthOf(path);
  return long > SAME ? Math.min(1, Math.max(0, part.along(path, tip) / long)) : 0;
}

/**
 * The theoretical roughness of a finished surface: its machined stretches, each with the move that made it. `first`:
 * the first step in the present clamping.
 */
export function roughnessOf(
  stock: readonly Ring[],
  steps: readonly Step[],
  spindles: readonly SpindleFrom[],
  first = 0,
): RoughStretch[] {
  const form = forming(spindles);
  const stretches: (Omit<RoughStretch, "points"> & { readonly points: Pt[] })[] = [];
  for (const made of surfaceOrigins(surfaceOf(stock), steps, first)) {
    const step = made.step === null ? undefined : steps[made.step];
    if (made.step === null || !step) continue;
    const formed = form(made, made.step, step),
      last = stretches.at(-1);
    const end = last?.points.at(-1);
    const isSame = (last?.by === formed.by && last.rz === formed.rz) || part.apart(made.from, made.to) < NO_PIECE;
    if (last && end && isSame && last.position.step === made.step && joins(end, made.from)) last.points.push(made.to);
    else {
      const position = { step: made.step, fraction: fractionOf(step, made.tip) };
      stretches.push({
        ...formed,
        position,
        block: step.block,
        operation: step.operation,
        points: [made.from, made.to],
      });
    }
  }
  return stretches;
}
