import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { noseRadius } from "../../kernel/cutter/insert.ts";
import { part as geometry, type Ring } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import type { NamedThread } from "../../kernel/thread/named-thread.ts";
import { readThread } from "../../kernel/thread/threads.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { axial, diameter, radius, radiusOf, rounded, roundedDown, toDiameter } from "../../kernel/units.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { withValue } from "../../program/job/requested-job.ts";
import { coreOf, hasTap, isTapOf } from "../../program/tools/tap-of-thread.ts";
import { hasAngleOf } from "../../program/tools/thread-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import { borderOf } from "../open-regions.ts";
import type { Action, ActionSource, PlanRequest, PlanState } from "../types.ts";
import { clearRadius, insideRegions, solidFrom } from "./bore.ts";
import { barsOf, heldBar, jobInside, startFor, startLimit } from "./bars.ts";
import type { BoreWay } from "./bore-turning.ts";
import { actionOf, fitsOf, fitted, notDone } from "./candidates.ts";
import { drillsOf, onAxis } from "./on-axis.ts";
import {
  alongCrest,
  fillOf,
  RUN_OUT,
  taperCycles,
  threadEnd,
  threadId,
  threadsOf,
  type ThreadPlace,
} from "./thread.ts";

/** Most bars that are proposed for a thread. */
const MOST_TOOLS = 2;
/** Run-up in front of a thread in pitches and at least in mm; clearance below its crest, mm. */
const [RUN_UP, LEAST_RUN_UP, BESIDE] = [3, 3, 1];
/** A bore is measured so far within its end, and a core so far below its wall, mm. */
const WITHIN = 0.1;
/** Chamfer of a tap in pitches: it goes so far beyond the end of a thread where the bore lets it. */
const LEAD = 2;

/** The tip is lifted so far from the crest between two passes, and at least so far, mm. */
const [LIFT, LEAST_LIFT] = [5, 0.2];

/** Grooves may be deeper than the root by rounded values and chords, mm. */
const ROOT = 0.05;

/** A thread that is not cut yet. */
interface OpenThread {
  readonly named: NamedThread;
  readonly place: ThreadPlace;
  readonly box: Box;
  readonly id: string;
  /** Nothing is left on its crest. */
  readonly isFinished: boolean;
}

function openThreads({ stock, threads }: PlanState, { part: { inside }, part }: PlanRequest): readonly OpenThread[] {
  const borders = insideRegions(stock, part).flatMap((region) => {
    const border = borderOf(inside, region);
    return border ? [border] : [];
  });
  return threadsOf(inside).flatMap((place) => {
    const { first, last, designation } = place;
    const named = readThread(designation);
    const id = threadId(inside, place);
    if (!named?.inside || threads.has(id)) return [];
    const box = boxOf(geometry.flattenedChain(inside.segments.slice(first, last + 1), CHORD));
    const isFinished = borders.every(([from, to]) => to < first || from > last);
    return [{ named, place, box, id, isFinished }];
  });
}

/** With a tap, where the table has one for the thread. */
function tapped({ named, box, id }: OpenThread, stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const front = frontOf(stock);
  const core = coreOf(named);
  const across = toDiameter(radius(clearRadius(stock, box.left + WITHIN, front)));
  if (!hasTap(named) || !core || across < core.limits[0] - SAME || across > core.limits[1] + SAME) return [];
  const rear = Math.max(box.left - LEAD * named.pitch, solidFrom(stock, radiusOf(core.limits[0]) - WITHIN));
  if (rear > box.left + SAME) return [];
  return drillsOf(request)
    .filter((tool) => isTapOf(tool, named))
    .flatMap((tool): readonly Action[] => {
      const made = onAxis("tap", tool, rounded(front - rear), stock, request);
      if (!made) return [];
      const place = { front, rear, high: radiusOf(named.nominal) + ROOT, low: radiusOf(core.limits[0]) - ROOT };
      const key = `thread tap T${tool.T} ${box.right.toFixed(2)}`;
      return [{ ...made, kind: "thread", key, site: "inside", tool, place, threads: [id] }];
    });
}

/** With a threading bar. */
function turned(open: OpenThread, stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const { named, place, box, id, isFinished } = open;
  if (!isFinished) return [];
  const { inside } = request.part;
  const isTaper = named.taper > 0;
  const across = toDiameter(radius(isTaper ? box.high : box.low));
  const segments = inside.segments.slice(place.first, place.last + 1);
  const corner = (z: number) => ({ diameter: diameter(rounded(across)), z: axial(rounded(z)) });
  const [before, next] = [inside.segments[place.first - 1], inside.segments[place.last + 1]];
  const runOut = RUN_OUT * named.pitch;
  // It begins in front of a chamfer.
  const isChamfered = before && before.from.r >= box.low && before.from.z - box.right < runOut;
  const begin = isChamfered ? before.from.z : box.right;
  const wanted: ShapeRequest = {
    site: "inside",
    shape: "thread",
    from: corner(begin),
    to: corner(box.left),
    angle: 0,
    pitch: named.pitch,
    contour: null,
    allowance: 0,
  };
  const front = frontOf(stock);
  const clear = clearRadius(stock, box.left, front);
  const z = begin + Math.max(LEAST_RUN_UP, RUN_UP * named.pitch);
  const way: BoreWay = { z, clear, low: clear - BESIDE };
  return (isTaper ? taperCycles : cyclesFor(wanted))
    .filter(({ number }) => !request.withoutCycles.includes(number))
    .flatMap((cycle) => {
      const fitOfBar = (tool: Tool) => {
        const fill = fillOf(named, cycle, across, noseRadius(tool), "inside");
        const r = startFor(tool, way);
        if (!fill || r === null) return null;
        const lifts = Math.min(LIFT, roundedDown(clear - startLimit(tool, clear)));
        if (lifts < LEAST_LIFT) return null;
        const root = isTaper ? box.high + fill.cut.depth : radiusOf(fill.cut.root);
        // It goes on behind the rear end of a through bore, where it runs out.
        const { end, rise } = next
          ? threadEnd(named, place, { chain: inside, site: "inside", root, tool })
          : { end: box.left - named.pitch, rise: runOut };
        const made = withValue(jobInside(cycle, { ...wanted, to: corner(end) }, stock, { z, r }), "Q460", lifts);
        const line = isTaper ? alongCrest(cycle, segments, [begin, end], fill.cut.depth) : null;
        const values = { ...fill.values, ...line, ...(line && { Q466: rounded(named.pitch) }) };
        const filled = Object.entries(values).reduce((job, [q, value]) => withValue(job, q, value), made);
        const job = withValue(filled, "Q474", rounded(rise));
        const cut = {
          operation: "both",
          work: "thread",
          smallest: across,
          largest: fill.cut.root,
          stock,
          depth: fill.cut.depth,
          pitch: named.pitch,
          bar: heldBar(tool, front - box.left),
        } as const;
        const fit = fitted({ cycle, job, cut }, tool, request);
        const room = { front: z, rear: end - runOut, high: root + ROOT, low: box.low - ROOT };
        return fit && { ...fit, room };
      };
      const bars = barsOf(request, (tool) => hasAngleOf(named, tool));
      return fitsOf(bars, MOST_TOOLS, request, fitOfBar).map((fit): Action => {
        const action = actionOf({ kind: "thread", site: "inside", cycle, box }, fit.tool, fit.job, fit.values);
        return { ...action, place: fit.room, threads: [id] };
      });
    });
}

/** Threads in a bore: tapped, or cut with a bar. */
export const threadInside: ActionSource = {
  kind: "thread",
  actions: (state, request) =>
    notDone(
      openThreads(state, request).flatMap((open) => [
        ...tapped(open, state.stock, request),
        ...turned(open, state.stock, request),
      ]),
      state,
    ),
};
