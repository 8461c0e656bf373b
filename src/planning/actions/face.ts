import { useOf, worksAcross } from "../../cycles/use.ts";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { axial, diameter, radius, rounded, toDiameter } from "../../kernel/units.ts";
import { jobFor, withValue } from "../../program/job/requested-job.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { Action, ActionSource } from "../types.ts";

/** Overlap of a face over a bore, mm: the nose of the insert leaves nothing at its edge. */
const OVER_BORE = 2;

/** Faces the front of the stock to Z0. */
export const face: ActionSource = {
  kind: "face",
  actions({ stock }, { shop, part, withoutCycles, withoutTools }) {
    const front = frontOf(stock);
    const end = boxAround(part.rings).right;
    if (front <= end) return [];
    const { high, low } = boxAround(stock);
    const corner = (r: number, z: number) => ({
      diameter: diameter(rounded(toDiameter(radius(r)))),
      z: axial(rounded(z)),
    });
    const wanted: ShapeRequest = {
      site: "face",
      shape: "step",
      from: corner(high, front),
      to: corner(Math.max(0, low - OVER_BORE), end),
      angle: 0,
      pitch: 0,
      contour: null,
      allowance: 0,
    };
    const cycles = cyclesFor(wanted).filter(
      (c) => worksAcross(c) && useOf(c).shapes.includes("step") && !withoutCycles.includes(c.number),
    );
    return cycles.flatMap((cycle) => {
      const job = withValue(jobFor(cycle, wanted, stock), "Q215", 0);
      return shop.tools
        .filter((tool) => isUsualTool(cycle.group, tool) && !withoutTools.includes(tool.T))
        .map((tool): Action => ({
          kind: "face",
          key: `face ${cycle.number} T${tool.T}`,
          site: "face",
          tool,
          cycle: cycle.number,
          job: { ...job, tool: tool.T },
          place: { front, rear: end, high, low },
          threads: [],
          values: [],
        }));
    });
  },
};
