import type { Cycle } from "../../cycles/define.ts";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { worksAcross } from "../../cycles/use.ts";
import { withValue } from "../../program/job/requested-job.ts";
import { boxAroundContour } from "../../program/job/requested-shape.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Action, ActionSource, PlanRequest } from "../types.ts";
import { actionsOf, toolsOf } from "./candidates.ts";
import { contourJob } from "./contour-job.ts";
import { outsideWork, type Piece } from "./outside-work.ts";

/** A section without the faces in front of it: facing takes those. */
export function withoutFront(segments: readonly Segment[]): readonly Segment[] {
  const first = segments.findIndex((s) => Math.abs(s.to.z - s.from.z) > SAME);
  return first < 0 ? [] : segments.slice(first);
}

/** Turning cycles for a section of the contour that are not excluded. */
export const turningCycles = (
  segments: readonly Segment[],
  allowance: number,
  { withoutCycles }: PlanRequest,
): readonly Cycle[] => {
  const wanted = {
    site: "outside",
    shape: "free",
    angle: 0,
    pitch: 1,
    contour: segments,
    allowance: allowance as ShapeRequest["allowance"],
    ...boxAroundContour(segments, "outside"),
  } as const;
  return cyclesFor(wanted).filter(
    (c) => (c.group === "longitudinal" || c.group === "transverse") && !withoutCycles.includes(c.number),
  );
};

/** Roughs the outside from the front, along the axis and across it. */
export const roughOutside: ActionSource = {
  kind: "roughOutside",
  actions(state, request) {
    const tools = toolsOf(request).filter(({ TYPE }) => TYPE === "ROUGH" || TYPE === "FINISH");
    return outsideWork(state, request)
      .rough.filter(({ opensAhead }) => opensAhead)
      .flatMap((piece) => roughings(piece, state.stock, request, tools));
  },
};

function roughings(
  { section, box }: Piece,
  stock: Parameters<typeof contourJob>[1]["stock"],
  request: PlanRequest,
  tools: ReturnType<typeof toolsOf>,
): readonly Action[] {
  const segments = withoutFront(section.segments);
  if (segments.length === 0) return [];
  return turningCycles(segments, 0, request).flatMap((cycle) => {
    const across = worksAcross(cycle);
    const made = contourJob(cycle, { segments: across ? section.segments : segments, way: "ahead", stock });
    return (across ? [0] : [0, 1]).flatMap((plunging) =>
      actionsOf(
        {
          kind: "roughOutside",
          site: "outside",
          cycle,
          job: withValue(made, "Q487", plunging),
          cut: { operation: "rough" },
          box,
          variant: `${plunging}`,
          most: 2,
        },
        tools,
        request,
        (a, b) => Number(b.tool.TYPE === "ROUGH") - Number(a.tool.TYPE === "ROUGH"),
      ),
    );
  });
}
