import { cutLength, cuttingWidth, isBar, noseRadius } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import { DEEPEST_GROOVE, DEPTH_OF_WIDTH } from "../../program/tools/cutting-work.ts";
import { depthForPower, EDGE_USED, FEED_OF_NOSE, leadOf, specificForce } from "../../report/advice/formulas.ts";
import { atLeast, LEAST, leastOf, reasoned, typedDown, type ReasonedNumber } from "./formulas.ts";
import { GRID, powerFor } from "./spindle-values.ts";
import { bentBodies, DEFLECTION, depthForForce, feedForForce, SLENDER } from "../../report/advice/stability.ts";
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

/** The roughing feed that a nose bears. */
export function feedByNose(tool: Tool): ReasonedNumber | null {
  const nose = noseRadius(tool);
  return nose > 0 ? reasoned(FEED_OF_NOSE * nose, "feedOfNose", "insert", { rε: nose }) : null;
}

/** A face presses along the axis, which bends no workpiece. */
const bodiesBentBy = ({ work, workpiece, bar, material }: ValuesRequest, deflection: number) =>
  bentBodies({ workpiece: work === "face" ? null : workpiece, bar }, material.group, deflection);

/** Depths at which workpiece and bar bend as far as allowed. */
export function depthsByForce(request: ValuesRequest, f: number, deflection: number): readonly ReasonedNumber[] {
  const kc = specificForce(request.material, f * Math.sin(leadOf(request.tool)));
  return bodiesBentBy(request, deflection).map(({ force, inputs, by }) =>
    reasoned(depthForForce(force, kc, f), by === "bar" ? "depthOfBar" : "depthOfWorkpiece", by, {
      ...inputs,
      f,
      kc: Math.round(kc),
    }),
  );
}

/** Depth over feed from which chips of long-chipping steel do not break. */
const DEPTH_OF_FEED = 10;

/** Depth of a roughing pass: the least that chip, edge, power, workpiece and bar allow. */
export function roughingDepth(request: ValuesRequest, f: number, spindle: Spindle): ReasonedNumber {
  const { tool, material } = request;
  const lead = leadOf(tool);
  const vc = spindle.kind === "surface" ? spindle.cuttingSpeed : material.roughSpeed;
  const Pc = powerFor(request, spindle);
  const strong = depthForPower(material, Pc, f, vc, lead);
  const kc = Math.round(specificForce(material, f * Math.sin(lead)));
  const edge = depthByEdge(tool);
  const depth = leastOf(
    reasoned(strong, "depthOfPower", "power", { Pc, f, kc, vc }),
    // A blade breaks its chip by steps.
    isBar(tool) ? null : reasoned(DEPTH_OF_FEED * f, "depthOfFeed", "chip", { f }),
    edge,
    ...depthsByForce(request, f, DEFLECTION.rough),
  );
  return typedDown(atLeast(depth, Math.min(LEAST.depth, strong, edge?.value ?? Infinity), "depthLeast"), GRID.depth);
}

/** Feeds at which they bend as far as allowed by a cut of a depth, or a blade of a width. */
export function feedsByForce(request: ValuesRequest, b: number, deflection: number): readonly ReasonedNumber[] {
  const { material } = request;
  return bodiesBentBy(request, deflection).map(({ force, inputs, by }) =>
    reasoned(feedForForce(force, material, b), by === "bar" ? "feedOfBar" : "feedOfWorkpiece", by, {
      ...inputs,
      b,
      "kc1.1": material.kc11,
      mc: material.mc,
    }),
  );
}

/** What needs attention beside the values. */
export function risksOf({ tool, workpiece, bar, work, depth = 0 }: ValuesRequest): readonly ValueRisk[] {
  const ratio = workpiece?.support === "chuck" ? workpiece.overhang / workpiece.diameter : 0;
  const ofBar = bar ? bar.overhang / bar.diameter : 0;
  const isTurned = work === "rough" || work === "face";
  const plunges = work === "recess" || work === "partOff";
  const widths = plunges && cuttingWidth(tool) > 0 ? depth / cuttingWidth(tool) : 0;
  return [
    ...(ratio > SLENDER.workpiece ? [{ kind: "slenderWorkpiece", ratio } as const] : []),
    ...(ofBar > SLENDER.bar ? [{ kind: "slenderBar", ratio: ofBar } as const] : []),
    ...(widths > DEEPEST_GROOVE ? [{ kind: "deepGroove", ratio: widths } as const] : []),
    ...(isTurned && depthByEdge(tool) === null ? [{ kind: "edgeUnknown", ratio: 0 } as const] : []),
  ];
}
