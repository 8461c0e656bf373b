import type { Cycle } from "../../cycles/define.ts";
import { useOf, worksAcross } from "../../cycles/use.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { withCycleValues } from "../../program/job/requested-job.ts";
import type { Action, ActionSource, Chain, PlanRequest } from "../types.ts";
import { actionOf, actionsOf, fitted, notDone, toolsOf, deepest } from "./candidates.ts";
import { isToleranced } from "./finest.ts";
import { finishings } from "./finish-outside.ts";
import { contourJob } from "./contour-job.ts";
import { withoutEdge, withoutFront } from "./front.ts";
import { outsideWork, workUpTo, type OutsideWork, type Piece } from "./outside-work.ts";
import { bridgedOver } from "./pockets.ts";
import { allowanceAlong } from "./near-net.ts";
import { cutOf, turnedChain, turningCycles } from "./turned-contour.ts";

/** Inserts that rough; the price of the weaker ones is for the search. */
const TYPES: readonly Tool["TYPE"][] = ["ROUGH", "FINISH"];

/** Roughs the outside from the front: along the axis over its grooves or into them, and across it. */
export const roughOutside: ActionSource = {
  kind: "roughOutside",
  actions(state, request) {
    const work = outsideWork(state, request);
    const open = work.rough.filter(({ opensAhead }) => opensAhead);
    const withTools = (tools: readonly Tool[]) =>
      notDone(
        open.flatMap((piece) => roughings(workUpTo(work, piece), piece, { stock: state.stock, tools, request })),
        state,
      );
    const all = toolsOf(request);
    const finished = open.map((piece) => workUpTo(work, piece)).filter(({ chain }) => !isToleranced(chain));
    return [
      ...TYPES.flatMap((type) => withTools(all.filter(({ TYPE }) => TYPE === type))),
      ...notDone(
        finished.flatMap((each) => finishings(each, state.stock, request, "both")),
        state,
      ),
    ];
  },
};

interface Around {
  readonly stock: readonly Ring[];
  readonly tools: readonly Tool[];
  readonly request: PlanRequest;
}

/** Whether the passes of a cycle follow the contour of a casting or a forging. */
const followsBlank = (cycle: Cycle): boolean => useOf(cycle).preTurned === true;

/** Tools of each way to rough. */
const MOST = 2;

function roughings(work: OutsideWork, piece: Piece, { stock, tools, request }: Around): readonly Action[] {
  const whole = bridgedOver(work.chain, work.pockets);
  const plain = withoutFront(whole);
  const { box } = piece;
  const allowance = allowanceAlong(piece, whole.segments, request);
  const along = allowance > 0 ? turningCycles(plain.segments, request, allowance).filter(followsBlank) : [];
  return [...turningCycles(plain.segments, request), ...along].flatMap((cycle) => {
    const across = worksAcross(cycle);
    const cut = cutOf(cycle, "rough", { box, stock });
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
    const into = tools.flatMap((tool) => {
      const chain = turnedChain(
        work,
        tool,
        (segments) => fitted({ cycle, cut, job: jobOf({ segments, marks: [] }, 1) }, tool, request)?.plan ?? null,
        across,
      );
      if (chain.segments.length === outline.segments.length) return [];
      const fit = fitted({ cycle, cut, ...jobsOf(chain, 1) }, tool, request);
      return fit ? { ...fit, goesInto: chain.segments.length } : [];
    });
    const made = deepest(into, MOST, request).map(({ tool, job, values }) =>
      actionOf({ ...candidate, variant: "in" }, tool, job, values),
    );
    // Going over its grooves first is no gain for a tool that goes into them.
    const alone = over.filter(({ tool }) => !made.some((inside) => inside.tool.T === tool.T));
    return [...(alone.length > 0 ? alone : over.slice(0, 1)), ...made];
  });
}
