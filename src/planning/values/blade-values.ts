import { cuttingWidth, noseRadius } from "../../kernel/cutter/insert.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import { FEED_OF_WIDTH, SPEED_SHARE, STEPS_FROM_WIDTHS } from "../../program/tools/cutting-work.ts";
import { specificForce } from "../../report/advice/formulas.ts";
import { feedsByForce, risksOf, roughingDepth } from "./edge-values.ts";
import { atLeast, LEAST, leastOf, reasoned, typedDown, type ReasonedNumber } from "./formulas.ts";
import { constantSurface, GRID, powerFor, shareOfSpeed } from "./spindle-values.ts";
import { DEFLECTION, feedForForce } from "../../report/advice/stability.ts";
import type { CuttingValues, ValuesRequest } from "./values-request.ts";

/** Width of a blade whose table row has none, mm. */
const NARROWEST = 0.5;

/** Feed of a blade by its width, bounded by its corners, workpiece, bar and power. */
export function feedOfBlade(request: ValuesRequest, spindle: Spindle): ReasonedNumber {
  const { tool, material } = request;
  const b = Math.max(cuttingWidth(tool), NARROWEST);
  const corner = noseRadius(tool);
  const vc = spindle.kind === "surface" ? spindle.cuttingSpeed : material.roughSpeed;
  const power = powerFor(request, spindle);
  const strong = feedForForce((60_000 * power) / vc, material, b);
  const kc = Math.round(specificForce(material, strong));
  const least = leastOf(
    reasoned(FEED_OF_WIDTH * b, "feedOfWidth", "width", { b }),
    reasoned(material.roughFeed, "feedOfMaterial", "material", { f: material.roughFeed }),
    corner > 0 ? reasoned(corner, "feedOfCorner", "insert", { rε: corner }) : null,
    ...feedsByForce(request, b, DEFLECTION.rough),
    reasoned(strong, "feedOfPower", "power", { Pc: power, b, vc, kc }),
  );
  return typedDown(atLeast(least, Math.min(LEAST.feed, strong), "feedLeast"), GRID.feed);
}

/** Recessing and parting off. */
export function plunging(request: ValuesRequest): CuttingValues {
  const { tool, depth = 0, work } = request;
  const partsOff = work === "partOff";
  const turning = constantSurface(request, shareOfSpeed(request, SPEED_SHARE[partsOff ? "partOff" : "recess"]));
  const feed = feedOfBlade(request, turning.spindle);
  const b = cuttingWidth(tool);
  const steps = !partsOff && b > 0 && depth > STEPS_FROM_WIDTHS * b;
  return {
    ...turning,
    feed,
    infeed: roughingDepth(request, feed.value, turning.spindle),
    plungeFeed: feed,
    step: steps ? typedDown(reasoned(STEPS_FROM_WIDTHS * b, "stepOfWidth", "width", { b }), GRID.depth) : null,
    oversize: null,
    risks: risksOf(request),
  };
}
