import { cuttingWidth } from "../../kernel/cutter/insert.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import { DEPTH_OF_WIDTH, FEED_OF_WIDTH, SPEED_SHARE, STEPS_FROM_WIDTHS } from "../../program/tools/cutting-work.ts";
import { specificForce } from "../../report/advice/formulas.ts";
import { atLeast, leastOf, reasoned, typedDown, LEAST, type ReasonedNumber } from "./formulas.ts";
import { risksOf } from "./edge-values.ts";
import { constantSurface, GRID, powerFor, shareOfSpeed } from "./spindle-values.ts";
import { DEFLECTION, feedForForce, forceOnBar, forceOnWorkpiece, type AllowedForce } from "./stability.ts";
import type { CuttingValues, ValuesRequest } from "./values-request.ts";

/** Feed of a blade by its width, bounded by workpiece, bar and power. */
export function feedOfBlade(request: ValuesRequest, spindle: Spindle): ReasonedNumber {
  const { tool, material, workpiece, bar } = request;
  const b = Math.max(cuttingWidth(tool), 0.5);
  const usual = reasoned(FEED_OF_WIDTH.usual * b, "feedOfWidth", "width", { b });
  const table = reasoned(material.roughFeed, "feedOfMaterial", "material", { f: material.roughFeed });
  const held = workpiece && forceOnWorkpiece(workpiece, material.group, DEFLECTION.rough);
  const bent = bar && forceOnBar(bar, DEFLECTION.rough);
  const byForce = (allowed: AllowedForce | null, by: "slenderness" | "bar") =>
    allowed &&
    reasoned(feedForForce(allowed.force, material, b), "feedOfWorkpiece", by, {
      ...allowed.inputs,
      b,
      "kc1.1": material.kc11,
      mc: material.mc,
    });
  const vc = spindle.kind === "surface" ? spindle.cuttingSpeed : material.roughSpeed;
  const power = powerFor(request, spindle);
  const strong = feedForForce((60_000 * power) / vc, material, b);
  const byPower = reasoned(strong, "feedOfPower", "power", {
    Pc: power,
    b,
    vc,
    kc: Math.round(specificForce(material, strong)),
  });
  const least = leastOf(usual, table, byForce(held, "slenderness"), byForce(bent, "bar"), byPower);
  return typedDown(atLeast(least, Math.min(LEAST.feed, byPower.value)), GRID.feed);
}

/** Recessing and parting off. */
export function plunging(request: ValuesRequest): CuttingValues {
  const { tool, depth = 0, work } = request;
  const turning = constantSurface(
    request,
    shareOfSpeed(request, SPEED_SHARE[work === "partOff" ? "partOff" : "recess"]),
  );
  const feed = feedOfBlade(request, turning.spindle);
  const b = cuttingWidth(tool);
  const isDeep = b > 0 && depth > STEPS_FROM_WIDTHS * b;
  return {
    ...turning,
    feed,
    infeed: typedDown(reasoned(DEPTH_OF_WIDTH * b, "depthOfWidth", "width", { b }), GRID.depth),
    plungeFeed: feed,
    step: isDeep ? typedDown(reasoned(STEPS_FROM_WIDTHS * b, "stepOfWidth", "width", { b }), GRID.depth) : null,
    oversize: null,
    risks: risksOf(request),
  };
}
