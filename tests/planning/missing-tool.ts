import { readThread } from "../../src/kernel/thread/threads.ts";
import { degrees, length } from "../../src/kernel/units.ts";
import type { Holder, TipOrientation, Tool } from "../../src/kernel/plan/tool.ts";
import type { PlanRequest } from "../../src/planning/types.ts";
import type { MissingTool } from "../../src/planning/working-plan.ts";

/** Least setting angle of a turning tool, its point where nothing limits it, degrees; and what it stays away from a limit. */
const [SETTING, POINT, CLEAR] = [45, 80, 0.2];
/** Nose and blade where nothing limits them, mm. */
const [NOSE, WIDTH] = [0.4, 3];
/** Share of the greatest width, and of the bore, that the tool has. */
const LESS = 0.9;

/** A bar that fits into a bore: from the tip to its far side it is a little narrower, and its tip stands out by `depth`. */
function bar(most: number, reach: number, depth: number, behind: number): Holder {
  const width = Math.max(most * LESS - depth, 1);
  return { width: length(width), length: length(reach + 10), offsetZ: length(behind), offsetX: length(-depth) };
}

const orientation = ({ form, site, hand }: MissingTool): TipOrientation => {
  if (form === "recessing" || form === "thread") return site === "inside" ? 6 : site === "face" ? 8 : 2;
  if (site === "inside") return hand === "left" ? 5 : 7;
  return hand === "left" ? 3 : 1;
};

/** A turning tool with exactly the data that a plan says are missing. */
function turningTool(T: number, missing: MissingTool): Tool {
  const { form, mostDiameter = 40, leastReach = 50, leastDepth = 20, mostWidth = WIDTH } = missing;
  const { rises = 0, descends = 0, leastEdge = 0, mostNose = NOSE, site } = missing;
  const width = Math.min(WIDTH, mostWidth * LESS);
  const common = { T, NAME: `MISSING-${T}`, TO: orientation(missing) };
  const setting = Math.max(rises + CLEAR, leastEdge + CLEAR, SETTING);
  const inside = (depth: number, behind: number) =>
    site === "inside" ? { holder: bar(mostDiameter, leastReach, depth, behind) } : {};
  if (form === "thread")
    return {
      ...common,
      TYPE: "THREAD",
      RS: length(0.1),
      "P-ANGLE": degrees(readThread(missing.thread ?? "")?.angle ?? 60),
      CUTLENGTH: length(2.5),
      ...inside(3, -1),
    };
  if (form === "recessing")
    return {
      ...common,
      TYPE: "RECTURN",
      RS: length(Math.min(mostNose, width / 4, 0.2)),
      CUTWIDTH: length(width),
      CUTLENGTH: length(leastDepth),
      ...inside(leastDepth, -width / 2),
    };
  return {
    ...common,
    TYPE: "ROUGH",
    RS: length(Math.min(NOSE, mostNose)),
    "T-ANGLE": degrees(setting),
    "P-ANGLE": degrees(Math.min(POINT, 180 - setting - descends - CLEAR)),
    // An insert lies within its bar.
    ...(site === "inside" && { CUTLENGTH: length((mostDiameter * LESS) / 2) }),
    ...inside(mostDiameter * (1 - LESS), 3),
  };
}

/** A request with a tool of exactly the data that a plan says are missing. */
export function withMissing(request: PlanRequest, missing: MissingTool, T: number): PlanRequest {
  const { shop } = request;
  const { mills = [] } = shop;
  if (missing.form !== "drill")
    return { ...request, shop: { ...shop, tools: [...shop.tools, turningTool(T, missing)] } };
  const R = ((missing.mostDiameter ?? 10) / 2) * LESS;
  const drill = {
    T,
    NAME: `MISSING-${T}`,
    TYPE: "DRILL",
    R,
    "T-ANGLE": 118,
    LCUTS: (missing.leastReach ?? 50) + 2 * R,
  } as const;
  return { ...request, shop: { ...shop, mills: [...mills, drill] } };
}
