import { valuesOfThread, type ThreadFill } from "../../cycles/thread-values.ts";
import type { Cycle } from "../../cycles/define.ts";
import { noseRadius } from "../../kernel/cutter/insert.ts";
import type { Aim, NamedThread } from "../../kernel/thread/named-thread.ts";
import { readThread } from "../../kernel/thread/threads.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { part, type Ring } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { axial, diameter, radius, radiusOf, rounded, roundedUp, toDiameter } from "../../kernel/units.ts";
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

function threadings(
  named: NamedThread,
  place: ThreadPlace,
  chain: Chain,
  stock: readonly Ring[],
  request: PlanRequest,
): readonly Action[] {
  const segments = chain.segments.slice(place.first, place.last + 1);
  const box = boxOf(part.flattenedChain(segments, CHORD));
  const [before, next] = [chain.segments[place.first - 1], chain.segments[place.last + 1]];
  // A thread begins at the face when only an edge break is in front of it.
  const isBreak = before && before.from.r < box.high && before.from.z - box.right < EDGE;
  const front = isBreak ? Math.max(box.right, before.from.z) : box.right;
  const isRelieved = !next || next.to.r < box.high - SAME;
  const across = toDiameter(radius(box.high));
  const corner = (z: number) => ({ diameter: diameter(rounded(across)), z: axial(rounded(z)) });
  const cycles = cyclesFor({
    site: "outside",
    shape: "thread",
    from: corner(front),
    to: corner(box.left),
    angle: 0,
    pitch: named.pitch,
    contour: null,
    allowance: 0,
  }).filter(({ number }) => !request.withoutCycles.includes(number));
  return cycles.flatMap((cycle) =>
    toolsOf(request)
      .filter((tool) => hasAngleOf(named, tool))
      .flatMap((tool): readonly Action[] => {
        const fill = fillOf(named, cycle, across, noseRadius(tool));
        if (!fill) return [];
        // The tooth leaves the material where the relief is as deep as the thread.
        const root = radiusOf(fill.cut.root);
        const end = isRelieved ? reliefFrom(chain, place, root) : box.left;
        const begun = jobFor(
          cycle,
          {
            site: "outside",
            shape: "thread",
            from: corner(front),
            to: corner(end),
            angle: 0,
            pitch: named.pitch,
            contour: null,
            allowance: 0,
          },
          stock,
        );
        const filled = Object.entries(fill.values).reduce((job, [q, value]) => withValue(job, q, value), begun);
        const job = clearOf(
          withValue(filled, "Q474", isRelieved ? 0 : rounded(RUN_OUT * named.pitch)),
          box.left,
          stock,
        );
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

/** Z from which on the relief behind a thread is at least as deep as its root. */
function reliefFrom({ segments }: Chain, { last }: ThreadPlace, root: number): number {
  let end = segments[last]?.to.z ?? 0;
  for (const s of segments.slice(last + 1)) {
    if (s.to.r >= s.from.r - SAME) return end;
    end = s.to.z;
    if (s.to.r <= root) return end;
  }
  return end;
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
  const aims: readonly Aim[] = named[site]?.tolerance ? ["middle", "basic"] : ["basic"];
  const fills = aims.flatMap((aim) => {
    const fill = valuesOfThread(named, roles, { [roles.position]: site === "inside" ? 1 : 0 }, { aim, nose });
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
