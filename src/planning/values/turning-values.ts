import { isBar, noseRadius } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { SPEED_SHARE } from "../../program/tools/cutting-work.ts";
import { feedForRz, USUAL_RZ } from "../../report/advice/formulas.ts";
import { feedOfBlade } from "./blade-values.ts";
import { depthsByForce, feedByNose, feedsByForce, risksOf, roughingDepth } from "./edge-values.ts";
import { atLeast, LEAST, leastOf, reasoned, typedDown, type ReasonedNumber } from "./formulas.ts";
import { constantSurface, GRID, shareOfSpeed } from "./spindle-values.ts";
import { DEFLECTION } from "../../report/advice/stability.ts";
import type { CuttingValues, ValuesRequest, WantedRoughness } from "./values-request.ts";

/** Rz of a turned surface over its Ra: 9 · √3 / 4 = 3.9 for a profile of circular arcs; an approximation. */
const RZ_OF_RA = 4;
/** Least depth over the nose radius. */
const DEPTH_OF_NOSE = 2 / 3;
/** The least depth of a cut, mm: with less the nose rubs. */
export const leastDepth = (tool: Tool): number => DEPTH_OF_NOSE * noseRadius(tool);
/** Wanted Rz, µm, of a mark. */
export const rzOf = ({ kind, value }: WantedRoughness): number => (kind === "Rz" ? value : RZ_OF_RA * value);

const halved = (feed: ReasonedNumber): ReasonedNumber =>
  typedDown(reasoned(feed.value / 2, "halfOfFeed", feed.limitedBy, { f: feed.value }), GRID.feed);

/** Roughing, also of a face or with a blade. */
export function roughing(request: ValuesRequest): CuttingValues {
  const { tool, material } = request;
  const wide = isBar(tool);
  const vc = wide
    ? shareOfSpeed(request, SPEED_SHARE.recess)
    : reasoned(material.roughSpeed, "speedOfMaterial", "material", { vc: material.roughSpeed });
  const turning = constantSurface(request, vc);
  const table = reasoned(material.roughFeed, "feedOfMaterial", "material", { f: material.roughFeed });
  // Where the least depth of the nose already bends workpiece or bar, the feed is reduced as well.
  const thinnest = Math.max(LEAST.depth, leastDepth(tool));
  const finer = feedsByForce(request, thinnest, DEFLECTION.rough);
  const feed = wide
    ? feedOfBlade(request, turning.spindle)
    : typedDown(atLeast(leastOf(table, feedByNose(tool), ...finer), LEAST.feed, "feedLeast"), GRID.feed);
  return {
    ...turning,
    feed,
    infeed: roughingDepth(request, feed.value, turning.spindle),
    plungeFeed: halved(feed),
    step: null,
    oversize: null,
    risks: risksOf(request),
  };
}

/** Finishing, and the oversize that suits it. */
export function finishing(request: ValuesRequest): CuttingValues {
  const { tool, material, roughness } = request;
  const turning = constantSurface(
    request,
    reasoned(material.finishSpeed, "speedOfMaterial", "material", { vc: material.finishSpeed }),
  );
  const nose = noseRadius(tool);
  const rz = roughness ? rzOf(roughness) : USUAL_RZ;
  const mark = roughness ? { [roughness.kind]: roughness.value, Rz: rz } : { Rz: rz };
  const byMark = nose > 0 ? reasoned(feedForRz(rz, nose), "feedOfRoughness", "roughness", { ...mark, rε: nose }) : null;
  // A coarse mark allows more than the usual finishing feed, but not more than roughing.
  const usual = roughness ? material.roughFeed : material.finishFeed;
  const feed = isBar(tool)
    ? leastOf(feedOfBlade(request, turning.spindle), byMark)
    : leastOf(reasoned(usual, "feedOfMaterial", "material", { f: usual }), byMark, feedByNose(tool));
  const typed = typedDown(feed, GRID.feed);
  const byNoseDepth = reasoned(leastDepth(tool), "depthOfNose", "insert", { rε: nose });
  const depth = leastOf(
    atLeast(byNoseDepth, LEAST.depth, "depthLeast"),
    ...depthsByForce(request, typed.value, DEFLECTION.finish),
  );
  const side = typedDown(atLeast(depth, LEAST.finishDepth, "depthLeast"), GRID.depth);
  const half = reasoned(side.value / 2, "halfOfDepth", side.limitedBy, { ap: side.value });
  return {
    ...turning,
    feed: typed,
    infeed: side,
    plungeFeed: halved(typed),
    step: null,
    oversize: {
      diameter: reasoned(
        toDiameter(radius(side.value)),
        side.formula === "depthOfNose" ? "oversizeOfNose" : "oversizeOfDepth",
        side.limitedBy,
        side.formula === "depthOfNose" ? side.inputs : { ap: side.value },
      ),
      z: typedDown(atLeast(half, LEAST.finishDepth, "depthLeast"), GRID.depth),
    },
    risks: risksOf(request),
  };
}
