import { isBar, noseRadius } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { radians, radius, toDiameter } from "../../kernel/units.ts";
import { SPEED_SHARE } from "../../program/tools/cutting-work.ts";
import { depthForPower, FEED_OF_NOSE, feedForRz, specificForce } from "../../report/advice/formulas.ts";
import { feedOfBlade } from "./blade-values.ts";
import { depthByEdge, risksOf } from "./edge-values.ts";
import { atLeast, LEAST, leastOf, reasoned, typedDown, type ReasonedNumber } from "./formulas.ts";
import { constantSurface, GRID, powerFor, shareOfSpeed } from "./spindle-values.ts";
import { DEFLECTION, depthForForce, forceOnBar, forceOnWorkpiece, type AllowedForce } from "./stability.ts";
import type { CuttingValues, ValuesRequest, WantedRoughness } from "./values-request.ts";

/** Rz of a turned surface over its Ra: 9 · √3 / 4 = 3.9 for a profile of circular arcs; an approximation. */
const RZ_OF_RA = 4;
/** Rz of a finished surface without a mark, µm. */
const USUAL_RZ = 6.3;
/** Depth over feed from which chips of long-chipping steel do not break. */
const DEPTH_OF_FEED = 10;
/** Finishing depth over the nose radius: with less the nose rubs. */
const DEPTH_OF_NOSE = 2 / 3;
/** Angle of the edge where the tool has none, degrees. */
const LEAD = 90;
/** Wanted Rz, µm, of a mark. */
export const rzOf = ({ kind, value }: WantedRoughness): number => (kind === "Rz" ? value : RZ_OF_RA * value);

const leadOf = (tool: Tool) => radians(isBar(tool) ? LEAD : (tool["T-ANGLE"] ?? LEAD));

const depthByForce = (
  { force, inputs }: AllowedForce,
  of: "depthOfWorkpiece" | "depthOfBar",
  kc: number,
  f: number,
): ReasonedNumber =>
  reasoned(depthForForce(force, kc, f), of, of === "depthOfBar" ? "bar" : "slenderness", {
    ...inputs,
    f,
    kc: Math.round(kc),
  });

/** Depth limits by the stiffness of workpiece and bar. */
function depthsByForce(request: ValuesRequest, feed: number, allowed: number): readonly (ReasonedNumber | null)[] {
  const { tool, material, workpiece, bar, work } = request;
  const kc = specificForce(material, feed * Math.sin(leadOf(tool)));
  // Facing presses along the axis, which bends nothing.
  const held = work === "face" || !workpiece ? null : forceOnWorkpiece(workpiece, material.group, allowed);
  const bent = bar && forceOnBar(bar, allowed);
  return [held && depthByForce(held, "depthOfWorkpiece", kc, feed), bent && depthByForce(bent, "depthOfBar", kc, feed)];
}

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
  const nose = noseRadius(tool);
  const table = reasoned(material.roughFeed, "feedOfMaterial", "material", { f: material.roughFeed });
  const byNose = nose > 0 ? reasoned(FEED_OF_NOSE * nose, "feedOfNose", "insert", { rε: nose }) : null;
  const feed = wide ? feedOfBlade(request, turning.spindle) : typedDown(leastOf(table, byNose), GRID.feed);
  const f = feed.value;
  const power = powerFor(request, turning.spindle);
  const kc = Math.round(specificForce(material, f * Math.sin(leadOf(tool))));
  const byPower = reasoned(
    depthForPower(material, power, f, turning.speed.value, leadOf(tool)),
    "depthOfPower",
    "power",
    { Pc: power, f, kc, vc: turning.speed.value },
  );
  const least = leastOf(
    reasoned(DEPTH_OF_FEED * f, "depthOfFeed", "chip", { f }),
    depthByEdge(tool),
    byPower,
    ...depthsByForce(request, f, DEFLECTION.rough),
  );
  const edge = depthByEdge(tool)?.value ?? Infinity;
  return {
    ...turning,
    feed,
    infeed: typedDown(atLeast(least, Math.min(LEAST.depth, byPower.value, edge)), GRID.depth),
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
  const byNose = nose > 0 ? reasoned(FEED_OF_NOSE * nose, "feedOfNose", "insert", { rε: nose }) : null;
  const feed = isBar(tool)
    ? leastOf(feedOfBlade(request, turning.spindle), byMark)
    : leastOf(reasoned(usual, "feedOfMaterial", "material", { f: usual }), byMark, byNose);
  const typed = typedDown(feed, GRID.feed);
  const depth = leastOf(
    reasoned(Math.max(LEAST.depth, DEPTH_OF_NOSE * nose), "depthOfNose", "insert", { rε: nose }),
    ...depthsByForce(request, typed.value, DEFLECTION.finish),
  );
  const side = typedDown(atLeast(depth, LEAST.finishDepth), GRID.depth);
  const z = reasoned(Math.max(LEAST.finishDepth, side.value / 2), "halfOfDepth", side.limitedBy, { ap: side.value });
  return {
    ...turning,
    feed: typed,
    infeed: side,
    plungeFeed: halved(typed),
    step: null,
    oversize: {
      diameter: { ...side, value: toDiameter(radius(side.value)) },
      z: typedDown(z, GRID.depth),
    },
    risks: risksOf(request),
  };
}
