import type { ActionSource } from "../types.ts";
import { withValue } from "../../program/job/requested-job.ts";
import { worksAcross } from "../../cycles/use.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { part, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { actionsOf, toolsOf } from "./candidates.ts";
import { contourJob } from "./contour-job.ts";
import { outsideWork } from "./outside-work.ts";
import { turningCycles, withoutFront } from "./rough-outside.ts";

/** Finishes the contour in one pass from the front to the rear. */
export const finishOutside: ActionSource = {
  kind: "finishOutside",
  actions(state, request) {
    const { pieces, chain } = outsideWork(state, request);
    if (pieces.length === 0) return [];
    const segments: readonly Segment[] = withoutFront(chain.segments);
    if (segments.length === 0) return [];
    const box = boxAround([part.flattenedChain(segments, CHORD)]);
    const tools = toolsOf(request).filter(({ TYPE }) => TYPE === "ROUGH" || TYPE === "FINISH");
    return turningCycles(segments, 0, request)
      .filter((cycle) => !worksAcross(cycle))
      .flatMap((cycle) => {
        const made = contourJob(cycle, { segments, way: "ahead", stock: state.stock });
        return actionsOf(
          {
            kind: "finishOutside",
            site: "outside",
            cycle,
            job: withValue(made, "Q487", 1),
            cut: { operation: "finish" },
            box,
            most: 3,
          },
          tools,
          request,
          (a, b) => Number(b.tool.TYPE === "FINISH") - Number(a.tool.TYPE === "FINISH"),
        );
      });
  },
};
