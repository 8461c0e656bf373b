import { cutLength, cuttingWidth, isBar, noseRadius } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { DEPTH_OF_WIDTH } from "../../program/tools/cutting-work.ts";
import { EDGE_USED } from "../../report/advice/formulas.ts";
import { reasoned, type ReasonedNumber } from "./formulas.ts";
import { SLENDER } from "./stability.ts";
import type { ValueRisk, ValuesRequest } from "./values-request.ts";

/** Depth of a round insert over its radius. */
const DEPTH_OF_BUTTON = 0.5;
/** The depth of the edge: a share of its length, of a round insert, or of a blade. */
export function depthByEdge(tool: Tool): ReasonedNumber | null {
  const [edge, nose] = [cutLength(tool), noseRadius(tool)];
  if (isBar(tool)) {
    const b = cuttingWidth(tool);
    return b > 0 ? reasoned(DEPTH_OF_WIDTH * b, "depthOfWidth", "width", { b }) : null;
  }
  if (tool.TYPE === "BUTTON") return reasoned(DEPTH_OF_BUTTON * nose, "depthOfButton", "insert", { rε: nose });
  return edge === undefined ? null : reasoned(EDGE_USED * edge, "depthOfEdge", "cutLength", { l: edge });
}

/** What needs attention beside the values. */
export function risksOf({ tool, workpiece, bar, work }: ValuesRequest): readonly ValueRisk[] {
  const ratio = workpiece?.support === "chuck" ? workpiece.overhang / workpiece.diameter : 0;
  const ofBar = bar ? bar.overhang / bar.diameter : 0;
  const isTurned = work === "rough" || work === "face";
  return [
    ...(ratio > SLENDER.workpiece ? [{ kind: "slenderWorkpiece", ratio } as const] : []),
    ...(ofBar > SLENDER.bar ? [{ kind: "slenderBar", ratio: ofBar } as const] : []),
    ...(isTurned && depthByEdge(tool) === null ? [{ kind: "edgeUnknown", ratio: 0 } as const] : []),
  ];
}
