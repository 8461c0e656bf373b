import { worksAcross } from "../../cycles/use.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { part, type Ring } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { withValue } from "../../program/job/requested-job.ts";
import type { Action, ActionSource, PlanRequest } from "../types.ts";
import { notDone, outsideTools } from "./candidates.ts";
import { contourJob } from "./contour-job.ts";
import { finestOf } from "./finest.ts";
import { withoutFront } from "./front.ts";
import { sectionWorks } from "./rest-rough.ts";
import { isInGroove, outsideWork, workUpTo, type OutsideWork, type Piece } from "./outside-work.ts";
import { cutOf, turningCycles, turnings, typesFirst } from "./turned-contour.ts";

/** Tools to finish with. */
const MOST = 3;
const better = typesFirst("FINISH", "ROUGH");

/** Pieces that are finished by themselves. */
const MOST_PIECES = 4;

/** Finishes the contour in one pass from the front to the rear, and what other tools left of it by itself. */
export const finishOutside: ActionSource = {
  kind: "finishOutside",
  actions(state, request) {
    const work = outsideWork(state, request);
    const last = work.pieces.toSorted((a, b) => b.span[1] - a.span[1])[0];
    if (!last) return [];
    const isRest = state.done.some(({ action }) => action.kind === "finishOutside" || action.inOneCall);
    const isAlone = (piece: Piece) => isRest || (!piece.opensAhead && work.pieces.length > 1);
    const single = work.pieces
      .filter((piece) => piece !== last || !piece.opensAhead)
      .filter((piece) => isAlone(piece) && !isInGroove(piece, work))
      .slice(0, MOST_PIECES);
    return notDone(
      [
        ...finishings(workUpTo(work, last), state.stock, request),
        ...single.flatMap((piece) =>
          piece.opensAhead
            ? finishings(workUpTo(work, piece), state.stock, request)
            : sectionWorks(piece, "finishOutside", "finish", { stock: state.stock, request }),
        ),
      ],
      state,
    );
  },
};

/** Passes along a contour with inserts for it. `operation`: both where they rough it first, in one call. */
export function finishings(
  work: OutsideWork,
  stock: readonly Ring[],
  request: PlanRequest,
  operation: "finish" | "both" = "finish",
): readonly Action[] {
  const inOneCall = operation === "both";
  const tools = outsideTools(request).filter(({ TYPE }) => TYPE === "FINISH" || TYPE === "ROUGH");
  const box = boxAround([part.flattenedChain(work.chain.segments, CHORD)]);
  const roughness = finestOf(work.chain);
  const hasHollow = work.pockets.some(({ axis }) => axis === "z");
  return turningCycles(work.chain.segments, request)
    .filter((cycle) => hasHollow || !worksAcross(cycle))
    .flatMap((cycle) => {
      const cut = cutOf(cycle.group, operation, { box, stock, ...(roughness !== undefined && { roughness }) });
      const place = { site: "outside", cycle, cut, box } as const;
      const actions = turnings(
        work,
        {
          candidate: inOneCall
            ? { kind: "roughOutside", variant: "finish", ...place }
            : { kind: "finishOutside", ...place },
          tools,
          most: MOST,
          better,
          cutChain: withoutFront,
          jobsOf: ({ segments }) => ({
            job: withValue(contourJob(cycle, { segments, way: "ahead", stock }), "Q487", 1),
          }),
          isWanted: ({ makesContour }) => makesContour || !inOneCall,
        },
        request,
      );
      return inOneCall ? actions.map((action) => ({ ...action, inOneCall })) : actions;
    });
}
