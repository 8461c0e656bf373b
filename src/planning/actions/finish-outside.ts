import { worksAcross } from "../../cycles/use.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { part, type Ring } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { withValue } from "../../program/job/requested-job.ts";
import type { Action, ActionSource, Chain, PlanRequest } from "../types.ts";
import { actionOf, fitted, notDone, toolsOf, deepest } from "./candidates.ts";
import { contourJob } from "./contour-job.ts";
import { finestOf } from "./finest.ts";
import { withoutFront } from "./front.ts";
import { sectionWorks } from "./rest-rough.ts";
import { isInGroove, outsideWork, workUpTo, type OutsideWork, type Piece } from "./outside-work.ts";
import { cutOf, turnedChain, turningCycles, typesFirst } from "./turned-contour.ts";

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
  const tools = toolsOf(request).filter(({ TYPE }) => TYPE === "FINISH" || TYPE === "ROUGH");
  const box = boxAround([part.flattenedChain(work.chain.segments, CHORD)]);
  const roughness = finestOf(work.chain);
  const hasHollow = work.pockets.some(({ axis }) => axis === "z");
  return turningCycles(work.chain.segments, request)
    .filter((cycle) => hasHollow || !worksAcross(cycle))
    .flatMap((cycle) => {
      const cut = cutOf(cycle, operation, { box, stock, ...(roughness !== undefined && { roughness }) });
      const candidate = inOneCall
        ? ({ kind: "roughOutside", site: "outside", cycle, box, variant: "finish" } as const)
        : ({ kind: "finishOutside", site: "outside", cycle, box } as const);
      const jobOf = ({ segments }: Chain) => withValue(contourJob(cycle, { segments, way: "ahead", stock }), "Q487", 1);
      const fits = tools.flatMap((tool) => {
        const chain = withoutFront(
          turnedChain(
            work,
            tool,
            (segments) => fitted({ cycle, cut, job: jobOf({ segments, marks: [] }) }, tool, request)?.plan ?? null,
            worksAcross(cycle),
          ),
        );
        const fit = chain.segments.length > 0 && fitted({ cycle, cut, job: jobOf(chain) }, tool, request);
        return fit && (fit.makesContour || !inOneCall) ? { ...fit, goesInto: chain.segments.length } : [];
      });
      return deepest(fits, MOST, request, better).map(({ tool, job, values }) => ({
        ...actionOf(candidate, tool, job, values),
        ...(inOneCall && ({ inOneCall } as const)),
      }));
    });
}
