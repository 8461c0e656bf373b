import type { Cycle } from "../../cycles/define.ts";
import { useOf, worksAcross } from "../../cycles/use.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { withCycleValues } from "../../program/job/requested-job.ts";
import { perObject } from "../../nc/per-object.ts";
import type { Action, ActionSource, Chain, PlanRequest } from "../types.ts";
import { actionsOf, notDone, outsideTools } from "./candidates.ts";
import { isToleranced } from "./finest.ts";
import { finishings } from "./finish-outside.ts";
import { contourJob } from "./contour-job.ts";
import { withoutEdge } from "./front.ts";
import { outsideWork, workUpTo, type OutsideWork, type Piece } from "./outside-work.ts";
import { allowanceAlong } from "./near-net.ts";
import { bridgedIn, cutOf, turningCycles, turnings } from "./turned-contour.ts";

/** Inserts that rough; the price of the weaker ones is for the search. */
const TYPES: readonly Tool["TYPE"][] = ["ROUGH", "FINISH"];

/** The ways to rough each stock: facing asks for their tools, too. */
const waysOf = perObject((request: PlanRequest) =>
  perObject((stock: readonly Ring[]) => {
    const work = outsideWork({ stock }, request);
    const all = outsideTools(request);
    return TYPES.flatMap((type) => {
      const tools = all.filter(({ TYPE }) => TYPE === type);
      return openAhead(work).flatMap((piece) => roughings(workUpTo(work, piece), piece, { stock, tools, request }));
    });
  }),
);

const openAhead = ({ rough }: OutsideWork) => rough.filter(({ opensAhead }) => opensAhead);

/** Roughs the outside from the front: along the axis over its grooves or into them, and across it. */
export const roughOutside: ActionSource = {
  kind: "roughOutside",
  actions: (state, request) => notDone(waysOf(request)(state.stock), state),
};

/** The same to its finished size in one call, where nothing of it is toleranced. */
export const turnOutside: ActionSource = {
  kind: "roughOutside",
  inOneCall: true,
  actions(state, request) {
    const work = outsideWork(state, request);
    const finished = openAhead(work)
      .map((piece) => workUpTo(work, piece))
      .filter(({ chain }) => !isToleranced(chain));
    return notDone(
      finished.flatMap((each) => finishings(each, state.stock, request, "both")),
      state,
    );
  },
};

interface Around {
  readonly stock: readonly Ring[];
  readonly tools: readonly Tool[];
  readonly request: PlanRequest;
}

/** Whether the passes of a cycle follow the contour of a casting or a forging. */
const followsBlank = (cycle: Cycle): boolean => useOf(cycle).preTurned === true;

const NO_CHAIN: Chain = { segments: [], marks: [] };

/** Tools of each way to rough. */
const MOST = 2;

function roughings(work: OutsideWork, piece: Piece, { stock, tools, request }: Around): readonly Action[] {
  const whole = bridgedIn(work, work.pockets, true);
  const plain = bridgedIn(work, work.pockets, false);
  const { box } = piece;
  const allowance = allowanceAlong(piece, whole.segments, request);
  const along = allowance > 0 ? turningCycles(plain.segments, request, allowance).filter(followsBlank) : [];
  return [...turningCycles(plain.segments, request), ...along].flatMap((cycle) => {
    const across = worksAcross(cycle);
    const cut = cutOf(cycle.group, "rough", { box, stock });
    const candidate = { kind: "roughOutside", site: "outside", cycle, cut, box } as const;
    const jobOf = ({ segments }: Chain, plunging: number) =>
      withCycleValues(contourJob(cycle, { segments, way: "ahead", stock }), [
        ["Q487", plunging],
        ...(followsBlank(cycle) ? [["Q485", allowance] as const] : []),
      ]);
    const outline = across ? whole : plain;
    /** A job over a chain, and the same without the edge in front of it. */
    const jobsOf = (chain: Chain, plunging: number) => {
      const segments = across || followsBlank(cycle) ? null : withoutEdge(chain.segments);
      return {
        job: jobOf(chain, plunging),
        ...(segments && { other: jobOf({ segments, marks: [] }, plunging) }),
      };
    };
    const over = actionsOf({ ...candidate, ...jobsOf(outline, 0) }, tools, MOST, request);
    if (!work.pockets.some(({ axis }) => (axis === "z") === across)) return over;
    const into = turnings(
      work,
      {
        candidate: { ...candidate, variant: "in" },
        tools,
        most: MOST,
        cutChain: (chain) => (chain.segments.length === outline.segments.length ? NO_CHAIN : chain),
        jobsOf: (chain) => jobsOf(chain, 1),
      },
      request,
    );
    // Going over its grooves first is no gain for a tool that goes into them.
    const alone = over.filter(({ tool }) => !into.some((inside) => inside.tool.T === tool.T));
    return [...(alone.length > 0 ? alone : over.slice(0, 1)), ...into];
  });
}
