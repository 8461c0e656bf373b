import { worksAcross } from "../../cycles/use.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { withValue } from "../../program/job/requested-job.ts";
import type { Action, ActionKind, ActionSource, PlanRequest } from "../types.ts";
import { bestWays, notDone, toolsOf, type Candidate } from "./candidates.ts";
import { contourJob, type Way } from "./contour-job.ts";
import { outsideWork, pocketOf, type OutsideWork, type Piece } from "./outside-work.ts";
import { cutOf, suits, turningCycles, typesFirst } from "./turned-contour.ts";
import { finestOf } from "./finest.ts";

/** Pieces to work on, and ways to work on each. */
const [MOST_PIECES, MOST_WAYS] = [4, 4];
const finishing = typesFirst("FINISH", "ROUGH");
const WAYS: readonly Way[] = ["ahead", "back"];

/** Roughs what is left between higher places, from either side. */
export const restRough: ActionSource = {
  kind: "restRough",
  actions(state, request) {
    const work = outsideWork(state, request);
    return notDone(
      work.rough
        .filter(({ opensAhead }) => !opensAhead)
        .slice(0, MOST_PIECES)
        .flatMap((piece) => sectionWorks(piece, "restRough", "rough", { work, stock: state.stock, request })),
      state,
    );
  },
};

interface Around {
  readonly work: OutsideWork;
  readonly stock: readonly Ring[];
  readonly request: PlanRequest;
}

/** Turns the section of a piece, from its front and from its rear, with tools that reach most of its groove. */
export function sectionWorks(
  piece: Piece,
  kind: ActionKind,
  operation: "rough" | "finish",
  { work, stock, request }: Around,
): readonly Action[] {
  const { section, box } = piece;
  const { segments } = section;
  const pocket = pocketOf(piece, work);
  const tools = toolsOf(request).filter(({ TYPE }) => TYPE === "ROUGH" || TYPE === "FINISH" || TYPE === "BUTTON");
  const roughness = finestOf(section);
  const candidates = turningCycles(segments, request)
    .filter((cycle) => !worksAcross(cycle))
    .flatMap((cycle) =>
      WAYS.map((way): Candidate => ({
        kind,
        site: "outside",
        cycle,
        job: withValue(contourJob(cycle, { segments, way, stock }), "Q487", 1),
        cut: cutOf(cycle, operation, { box, stock, ...(roughness !== undefined && { roughness }) }),
        box,
        variant: way,
        ...(pocket && { accepts: (plan, tool) => suits(plan, tool, pocket) }),
      })),
    );
  return bestWays(candidates, tools, MOST_WAYS, request, operation === "finish" ? finishing : undefined);
}
