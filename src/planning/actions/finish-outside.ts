import { worksAcross } from "../../cycles/use.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { part, type Ring } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { withValue } from "../../program/job/requested-job.ts";
import type { Action, ActionSource, Chain, PlanRequest } from "../types.ts";
import { actionOf, fitted, notDone, ranked, toolsOf } from "./candidates.ts";
import { contourJob } from "./contour-job.ts";
import { finestOf } from "./finest.ts";
import { sectionWorks } from "./rest-rough.ts";
import { isInGroove, outsideWork, workUpTo, type OutsideWork } from "./outside-work.ts";
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
    if (work.rough.some(({ opensAhead }) => opensAhead)) return [];
    const last = work.pieces.toSorted((a, b) => b.span[1] - a.span[1])[0];
    if (!last) return [];
    const rest = work.pieces.length > 1 || state.done.some(({ action }) => action.kind === "finishOutside");
    const single = rest ? work.pieces.filter((piece) => !isInGroove(piece, work)).slice(0, MOST_PIECES) : [];
    return notDone(
      [
        ...finishings(workUpTo(work, last), state.stock, request),
        ...single.flatMap((piece) => sectionWorks(piece, "finishOutside", "finish", { stock: state.stock, request })),
      ],
      state,
    );
  },
};

function finishings(work: OutsideWork, stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const tools = toolsOf(request).filter(({ TYPE }) => TYPE === "FINISH" || TYPE === "ROUGH");
  const box = boxAround([part.flattenedChain(work.chain.segments, CHORD)]);
  const roughness = finestOf(work.chain);
  return turningCycles(work.chain.segments, request)
    .filter((cycle) => !worksAcross(cycle))
    .flatMap((cycle) => {
      const cut = cutOf(cycle, "finish", { box, stock, ...(roughness !== undefined && { roughness }) });
      const candidate = { kind: "finishOutside", site: "outside", cycle, box } as const;
      const jobOf = ({ segments }: Chain) => withValue(contourJob(cycle, { segments, way: "ahead", stock }), "Q487", 1);
      const fits = tools.flatMap((tool) => {
        const chain = turnedChain(
          work,
          (segments) => fitted({ cycle, cut, job: jobOf({ segments, marks: [] }) }, tool, request)?.plan ?? null,
        );
        return (chain.segments.length > 0 && fitted({ cycle, cut, job: jobOf(chain) }, tool, request)) || [];
      });
      return ranked(fits, better)
        .slice(0, MOST)
        .map(({ tool, job, values }) => actionOf(candidate, tool, job, values));
    });
}
