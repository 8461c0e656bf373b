import { worksAcross } from "../../cycles/use.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { withValue } from "../../program/job/requested-job.ts";
import { perObject } from "../../nc/per-object.ts";
import type { Action, ActionKind, ActionSource, Chain, PlanRequest } from "../types.ts";
import { bestWays, notDone, outsideTools, type Candidate } from "./candidates.ts";
import { contourJob, type Way } from "./contour-job.ts";
import { isInGroove, outsideWork, type Piece } from "./outside-work.ts";
import { bridgedOver, isValley, pocketsOf } from "./pockets.ts";
import { cutOf, turningCycles, typesFirst } from "./turned-contour.ts";
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
    const { rough } = work;
    return notDone(
      rough
        .filter((piece) => !piece.opensAhead && !isInGroove(piece, work))
        .slice(0, MOST_PIECES)
        .flatMap((piece) => sectionWorks(piece, "restRough", "rough", { stock: state.stock, request })),
      state,
    );
  },
};

/** A section over its grooves, the same object for each stock. */
const overGrooves = perObject((section: Chain) =>
  bridgedOver(
    section,
    pocketsOf(section, "r").filter((pocket) => !isValley(pocket)),
  ),
);

/** Turns the section of a piece over its grooves, from its front and from its rear. */
export function sectionWorks(
  { section, box }: Piece,
  kind: ActionKind,
  operation: "rough" | "finish",
  { stock, request }: { readonly stock: readonly Ring[]; readonly request: PlanRequest },
): readonly Action[] {
  const { segments } = overGrooves(section);
  const tools = outsideTools(request).filter(({ TYPE }) => TYPE === "ROUGH" || TYPE === "FINISH" || TYPE === "BUTTON");
  const roughness = finestOf(section);
  const cut = cutOf("longitudinal", operation, {
    box,
    stock,
    ...(roughness !== undefined && { roughness }),
  });
  const candidates = turningCycles(segments, request)
    .filter((cycle) => !worksAcross(cycle))
    .flatMap((cycle) =>
      WAYS.map((way): Candidate => ({
        kind,
        site: "outside",
        cycle,
        job: withValue(contourJob(cycle, { segments, way, stock }), "Q487", 1),
        cut,
        box,
        variant: way,
      })),
    );
  return bestWays(candidates, tools, MOST_WAYS, request, operation === "finish" ? finishing : undefined);
}
