import { useOf, worksAcross } from "../../cycles/use.ts";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { boxAround, boxOf, inBox } from "../../kernel/area/box.ts";
import { part, type Ring } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { axial, diameter, radius, rounded, toDiameter } from "../../kernel/units.ts";
import { jobFor } from "../../program/job/requested-job.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { positionAsTyped } from "../../program/values/typed-value.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { ActionSource, PlannedPart, PlanRequest } from "../types.ts";
import { actionsOf, notDone, outsideTools } from "./candidates.ts";
import { FAR } from "./bore.ts";
import { finestOf } from "./finest.ts";
import { highest } from "./outside-work.ts";
import { roughOutside } from "./rough-outside.ts";
import { typesFirst } from "./turned-contour.ts";

/** Overlap of a face over a bore, mm: the nose of the insert leaves nothing at its edge. */
const OVER_BORE = 2;
/** Distance from the point of a tailstock and other bodies of the clamping, mm. */
const BESIDE = 2;
/** Distance of the start point from the finished face, mm. */
const AHEAD = 2;
/** Tools to try. */
const MOST = 3;

const better = typesFirst("ROUGH", "FINISH");

/** Marks of the elements that lie in the front plane. */
const marksAt = ({ outside, inside }: PlannedPart, z: number) =>
  [outside, inside].flatMap(({ segments, marks }) =>
    marks.filter((_, i) => {
      const s = segments[i];
      return s !== undefined && Math.abs(s.from.z - z) < SAME && Math.abs(s.to.z - z) < SAME;
    }),
  );

/** Radius down to which a face is cut: beyond the edge of a bore, to the axis, or up to what holds the front. */
function innerOf(stock: readonly Ring[], [end, front]: readonly [number, number], { clamping }: PlanRequest): number {
  const bored = Math.max(0, boxAround(inBox(stock, { left: end, right: front, low: -1, high: FAR })).low - OVER_BORE);
  const held = (clamping?.bodies ?? []).map(({ rings }) => highest(rings, end, FAR));
  return Math.max(bored, ...held.filter((r) => r > 0).map((r) => r + BESIDE));
}

/** Faces the front of the stock down to the front face of the finished part, roughing and finishing in one call. */
export const face: ActionSource = {
  kind: "face",
  actions(state, request) {
    const { stock } = state;
    const [end, front] = [boxAround(request.part.rings).right, frontOf(stock)];
    if (front <= end + SAME) return [];
    const high = highest(stock, end, front);
    const low = innerOf(stock, [end, front], request);
    if (low >= high) return [];
    const corner = (r: number, z: number) => ({
      diameter: diameter(rounded(toDiameter(radius(r)))),
      z: axial(rounded(z)),
    });
    const wanted: ShapeRequest = {
      site: "face",
      shape: "step",
      from: corner(high, front),
      to: corner(low, end),
      angle: 0,
      pitch: 0,
      contour: null,
      allowance: 0,
    };
    const box = boxOf([part.point(end, low), part.point(front, high)]);
    const roughness = finestOf({ marks: marksAt(request.part, end) });
    const cut = {
      operation: "both",
      work: "face",
      smallest: toDiameter(radius(low)),
      largest: toDiameter(radius(high)),
      stock,
      ...(roughness !== undefined && { roughness }),
    } as const;
    // A tool that goes on with roughing saves a change.
    const goesOn = new Set(roughOutside.actions(state, request).map(({ tool }) => tool.T));
    const actions = cyclesFor(wanted)
      .filter((c) => worksAcross(c) && useOf(c).shapes.includes("step") && !request.withoutCycles.includes(c.number))
      .flatMap((cycle) => {
        const tools = outsideTools(request).filter((tool) => isUsualTool(cycle.group, tool));
        const begun = jobFor(cycle, wanted, stock);
        const job = { ...begun, start: { ...begun.start, z: positionAsTyped(rounded(Math.max(front, end + AHEAD))) } };
        const candidate = { kind: "face", site: "face", cycle, job, cut, box } as const;
        const own = actionsOf(
          candidate,
          tools.filter(({ T }) => goesOn.has(T)),
          MOST,
          request,
          better,
        );
        return own.length > 0 ? own : actionsOf(candidate, tools, MOST, request, better);
      });
    return notDone(actions, state);
  },
};
