import { valuesOfThread, type ThreadFill } from "../../cycles/thread-values.ts";
import type { Cycle } from "../../cycles/define.ts";
import { firstValues } from "../../cycles/first-values.ts";
import { catalogue } from "../../cycles/index.ts";
import { useOf } from "../../cycles/use.ts";
import { cutLength, noseRadius } from "../../kernel/cutter/insert.ts";
import { USUAL_TOOTH, type Tool } from "../../kernel/plan/tool.ts";
import type { Aim, NamedThread } from "../../kernel/thread/named-thread.ts";
import { readThread } from "../../kernel/thread/threads.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { part, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { axial, diameter, radians, radius, radiusOf, rounded, roundedUp, toDiameter } from "../../kernel/units.ts";
import { jobFor, tipAtCall, withValue } from "../../program/job/requested-job.ts";
import type { SetJob } from "../../program/job/job.ts";
import { hasAngleOf } from "../../program/tools/thread-tool.ts";
import { positionAsTyped } from "../../program/values/typed-value.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { Action, ActionSource, Chain, PlanRequest } from "../types.ts";
import { actionOf, fitted, toolsOf } from "./candidates.ts";
import { highest, outsideWork } from "./outside-work.ts";

/** A thread of a side: its elements in the chain, and its name. */
export interface ThreadPlace {
  readonly first: number;
  readonly last: number;
  readonly designation: string;
}

/** Where a thread is cut, and with what. */
interface ThreadSide {
  readonly chain: Chain;
  readonly site: "outside" | "inside";
  /** Radius of its root, mm. */
  readonly root: number;
  readonly tool: Tool;
}

/** The threads of a chain, from the front to the rear. */
export function threadsOf({ marks }: Chain): readonly ThreadPlace[] {
  const found: ThreadPlace[] = [];
  marks.forEach(({ thread }, i) => {
    const last = found.at(-1);
    if (thread === undefined) return;
    if (last && last.last === i - 1 && last.designation === thread) found[found.length - 1] = { ...last, last: i };
    else found.push({ first: i, last: i, designation: thread });
  });
  return found;
}

/** Name of a thread at its place, as states of the search keep it. */
export const threadId = ({ segments }: Chain, { first, designation }: ThreadPlace): string =>
  `${designation} ${rounded(segments[first]?.from.z ?? 0)}`;

/** Threads whose crest and relief are finished. */
export const thread: ActionSource = {
  kind: "thread",
  actions(state, request) {
    const { chain, pieces } = outsideWork(state, request);
    const isOpen = ({ first, last }: ThreadPlace) =>
      pieces.every(({ borders: [from, to] }) => to < first || from > last + 1) &&
      !state.threads.has(threadId(chain, { first, last, designation: chain.marks[first]?.thread ?? "" }));
    return threadsOf(chain)
      .filter(isOpen)
      .flatMap((place) => {
        const named = readThread(place.designation);
        return named?.outside ? threadings(named, place, chain, state.stock, request) : [];
      });
  },
};

/** Clearance above the stock on the way to a thread, mm. */
const ABOVE = 1;
/** Depth of the grooves beyond the root of the drawing that rounded values may give, mm. */
const ROOT = 0.05;
/** Largest edge break at the front end of a thread, mm. */
const EDGE = 3;
/** Length of a run-out in a cylinder without relief, in pitches. */
export const RUN_OUT = 2;

/** Cycles that cut a thread on a cone. */
export const taperCycles: readonly Cycle[] = catalogue.filter(
  (c) => c.thread?.line && useOf(c).shapes.includes("thread"),
);

/**
 * The line of a taper thread between two Z, on the crest of the drawing; in a bore, where a cycle names its root, so far
 * outside of it, mm. Null for a cycle without such a line.
 */
export function alongCrest(
  { thread: roles }: Cycle,
  segments: readonly Segment[],
  [front, end]: readonly [number, number],
  outside = 0,
): Readonly<Record<string, number>> | null {
  const [first, last] = [segments[0]?.from, segments.at(-1)?.to];
  if (!roles?.line || !first || !last) return null;
  const across = (z: number) =>
    rounded(toDiameter(radius(first.r + outside + ((last.r - first.r) * (z - first.z)) / (last.z - first.z))));
  const [startX = "", endX = ""] = roles.diameters;
  const { startZ, endZ } = roles.line;
  return { [startX]: across(front), [startZ]: rounded(front), [endX]: across(end), [endZ]: rounded(end) };
}

function threadings(
  named: NamedThread,
  place: ThreadPlace,
  chain: Chain,
  stock: readonly Ring[],
  request: PlanRequest,
): readonly Action[] {
  const segments = chain.segments.slice(place.first, place.last + 1);
  const box = boxOf(part.flattenedChain(segments, CHORD));
  const before = chain.segments[place.first - 1];
  // A thread begins at the face when only an edge break is in front of it.
  const isBreak = before && before.from.r < box.high && before.from.z - box.right < EDGE;
  const front = isBreak ? Math.max(box.right, before.from.z) : box.right;
  const across = toDiameter(radius(box.high));
  const corner = (z: number) => ({ diameter: diameter(rounded(across)), z: axial(rounded(z)) });
  const wanted = {
    site: "outside",
    shape: "thread",
    from: corner(front),
    to: corner(box.left),
    angle: 0,
    pitch: named.pitch,
    contour: null,
    allowance: 0,
  } as const;
  const cycles = (named.taper > 0 ? taperCycles : cyclesFor(wanted)).filter(
    ({ number }) => !request.withoutCycles.includes(number),
  );
  return cycles.flatMap((cycle) =>
    toolsOf(request)
      .filter((tool) => hasAngleOf(named, tool))
      .flatMap((tool): readonly Action[] => {
        const fill = fillOf(named, cycle, across, noseRadius(tool));
        if (!fill) return [];
        const root = named.taper > 0 ? box.low - fill.cut.depth : radiusOf(fill.cut.root);
        const { end, rise } = threadEnd(named, place, { chain, site: "outside", root, tool });
        const begun = jobFor(cycle, { ...wanted, to: corner(end) }, stock);
        const line = alongCrest(cycle, segments, [front, end]);
        const values = { ...fill.values, ...line, Q474: rounded(rise), ...(line && { Q466: rounded(named.pitch) }) };
        const filled = Object.entries(values).reduce((job, [q, value]) => withValue(job, q, value), begun);
        const job = clearOf(filled, box.left, stock);
        const cut = {
          operation: "both",
          work: "thread",
          smallest: fill.cut.root,
          largest: across,
          stock,
          depth: fill.cut.depth,
          pitch: named.pitch,
        } as const;
        const fit = fitted({ cycle, job, cut }, tool, request);
        if (!fit) return [];
        const action = actionOf({ kind: "thread", site: "outside", cycle, box }, tool, fit.job, fit.values);
        const low = root - ROOT;
        const made = { ...action.place, low, front, rear: end };
        return [{ ...action, place: made, threads: [threadId(chain, place)] }];
      }),
  );
}

/**
 * Z where the passes of a thread end, mm, and the length of its run-out. They go on to where its relief is as deep as its
 * root: in front of that the drawing has material. In a short relief, or without one, the tooth stops in front of the
 * shoulder, and rises on the way to that place.
 */
export function threadEnd(
  { angle, pitch }: NamedThread,
  { first, last }: ThreadPlace,
  { chain: { segments }, site, root, tool }: ThreadSide,
): { readonly end: number; readonly rise: number } {
  const high = (r: number) => (site === "outside" ? r : -r);
  const crest = Math.max(...segments.slice(first, last + 1).flatMap(({ from, to }) => [high(from.r), high(to.r)]));
  const left = segments[last]?.to.z ?? 0;
  const behind = segments.slice(last + 1);
  const [rising, deepest] = [
    behind.findIndex((s) => high(s.to.r) > high(s.from.r) + SAME),
    behind.findIndex(({ to }) => high(to.r) <= high(root) + ROOT),
  ];
  const isRelieved = deepest >= 0 && (rising < 0 || deepest < rising);
  const relief = behind.length === 0 ? left : isRelieved ? (behind[deepest]?.to.z ?? null) : null;
  const deep = relief ?? left;
  const tooth = cutLength(tool) ?? USUAL_TOOTH;
  const half = (r: number) => Math.tan(radians(angle) / 2) * Math.min(tooth, high(r) - high(root)) + noseRadius(tool);
  // The flank of the tooth stays a pitch away from all of the shoulder, also where a rounding or a cone begins it.
  const shoulder = part.flattenedChain(behind, CHORD).flatMap((to, i, all) => {
    const from = all[i - 1];
    if (!from || high(to.r) <= crest + SAME) return [];
    const top = root + Math.sign(to.r - root) * tooth;
    const share = (top - from.r) / (to.r - from.r);
    return share > 0 && share < 1 ? [from, { z: from.z + share * (to.z - from.z), r: top }, to] : [from, to];
  });
  const end = Math.max(deep, ...shoulder.map(({ z, r }) => z + pitch + half(r)));
  const rise = relief !== null ? Math.max(0, end > deep ? left - end : 0) : RUN_OUT * pitch;
  return { end, rise };
}

/** The values of a thread whose crest is nearest to the cylinder of the drawing. */
export function fillOf(
  named: NamedThread,
  cycle: Cycle,
  across: number,
  nose: number,
  site: "outside" | "inside" = "outside",
): ThreadFill | null {
  const { thread: roles } = cycle;
  if (!roles) return null;
  // Its own first values too: an infeed along the flank may be steeper than the flank of this thread.
  const typed = { ...firstValues(cycle), [roles.position]: site === "inside" ? 1 : 0 };
  const aims: readonly Aim[] = named[site]?.tolerance ? ["middle", "basic"] : ["basic"];
  const fills = aims.flatMap((aim) => {
    const fill = valuesOfThread(named, roles, typed, { aim, nose });
    return typeof fill === "string" ? [] : [fill];
  });
  const off = ({ cut }: ThreadFill) => Math.abs(cut.crest - across);
  return fills.toSorted((a, b) => off(a) - off(b))[0] ?? null;
}

/** The job with its start above everything between it and the end of the thread. */
function clearOf(job: SetJob, end: number, stock: readonly Ring[]): SetJob {
  const start = tipAtCall(job);
  const r = Math.max(start.r, highest(stock, end, start.z + ABOVE) + ABOVE);
  return { ...job, start: { ...job.start, x: positionAsTyped(roundedUp(toDiameter(radius(r)))) } };
}
