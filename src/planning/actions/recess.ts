import { worksAcross } from "../../cycles/use.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { part, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { boxAroundContour } from "../../program/job/requested-shape.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { Action, ActionSource, PlanRequest } from "../types.ts";
import { bestWays, notDone, outsideTools, type Candidate } from "./candidates.ts";
import { contourJob } from "./contour-job.ts";
import { finestOf } from "./finest.ts";
import { outsideWork, pocketOf, type Piece } from "./outside-work.ts";
import type { Pocket } from "./pockets.ts";
import { cutOf } from "./turned-contour.ts";

/** Ways to make each groove. */
const MOST = 3;

/** Recess turning and recessing of grooves, in cylinders and in faces: of each with something left in it. */
export const recess: ActionSource = {
  kind: "recess",
  actions(state, request) {
    const work = outsideWork(state, request);
    const found = new Map<Pocket, Recess>();
    const look = (pieces: readonly Piece[], operation: Recess["operation"]) => {
      for (const piece of pieces) {
        const pocket = pocketOf(piece, work);
        if (pocket && !found.has(pocket)) found.set(pocket, { pocket, operation });
      }
    };
    look(work.rough, "both");
    if (work.rough.length === 0) look(work.pieces, "finish");
    return notDone(
      [...found.values()].flatMap((each) => recesses(each, state.stock, request)),
      state,
    );
  },
};

interface Recess {
  readonly pocket: Pocket;
  readonly operation: "both" | "finish";
}

/** Cycles that go into a groove along its axis, those with a contour of their own first. */
const cyclesOf = (segments: readonly Segment[], axis: Pocket["axis"], { withoutCycles }: PlanRequest) => {
  const site = axis === "z" ? "face" : "outside";
  return cyclesFor({
    site,
    shape: "free",
    angle: 0,
    pitch: 1,
    contour: segments,
    allowance: 0,
    ...boxAroundContour(segments, site),
  }).filter(
    (c) =>
      (c.group === "recessTurning" || c.group === "recessing") &&
      worksAcross(c) === (axis === "z") &&
      !withoutCycles.includes(c.number),
  );
};

function recesses(
  { pocket: { segments, marks, axis }, operation }: Recess,
  stock: readonly Ring[],
  request: PlanRequest,
): readonly Action[] {
  const box = boxOf(part.flattenedChain(segments, CHORD));
  const roughness = finestOf({ marks });
  const cut = {
    ...cutOf("recessing", operation, { box, stock, ...(roughness !== undefined && { roughness }) }),
    width: axis === "z" ? box.high - box.low : box.right - box.left,
  };
  const candidates = cyclesOf(segments, axis, request).map((cycle): Candidate => ({
    kind: "recess",
    site: axis === "z" ? "face" : "outside",
    cycle,
    job: contourJob(cycle, { segments, way: "ahead", stock }),
    cut,
    box,
  }));
  const tools = outsideTools(request).filter((tool) => candidates.some(({ cycle }) => isUsualTool(cycle.group, tool)));
  return bestWays(candidates, tools, MOST, request);
}
