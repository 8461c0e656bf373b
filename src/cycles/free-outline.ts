import type { Frame } from "../kernel/flat.ts";
import { issue } from "../kernel/issue.ts";
import type { Setting } from "../kernel/plan.ts";
import type { Pt, Segment } from "../kernel/point.ts";
import { axial, radius, toRadius, type Axial, type Diameter } from "../kernel/units.ts";
import type { Dimension, Given, Outline } from "./define.ts";

const turnedAround = (s: Segment): Segment =>
  s.kind === "line"
    ? { kind: "line", from: s.to, to: s.from }
    : { kind: "arc", from: s.to, to: s.from, centre: s.centre, turn: s.turn === "cw" ? "ccw" : "cw" };

/** The values of a free-contour cycle that shape its outline. */
interface FreeValues {
  readonly Q499: number;
  readonly Q479: number;
  readonly Q480: Diameter;
  readonly Q482: Axial;
}

/** Contour of a subprogram in machining direction: as programmed, or from its end with Q499 = 1 and 2. */
export function freeOutline(v: FreeValues, given: Given, transverse: boolean): Outline {
  const programmed = given.contour;
  if (programmed === null) return { contour: [], dimensions: [], issues: [issue("contourMissing", "error", { label: "" }, "contour")] };
  const contour = v.Q499 === 0 ? programmed : programmed.map(turnedAround).reverse();
  const first = contour[0]?.from;
  const last = contour.at(-1)?.to;
  if (!first || !last) return { contour: [], dimensions: [], issues: [issue("contourTooShort", "error", {}, "contour")] };
  const flat = transverse ? first.r === last.r : first.z === last.z;
  if (flat) return { contour: [], dimensions: [], issues: [issue("contourFlat", "error", { axis: transverse ? "X" : "Z" }, "contour")] };
  return { contour, dimensions: v.Q479 === 1 ? limitDimensions(v, contour) : [], issues: [] };
}

function limitDimensions(v: FreeValues, contour: readonly Segment[]): Dimension[] {
  const points = contour.flatMap((s) => [s.from, s.to]);
  const z = points.reduce((sum, p) => sum + p.z, 0) / points.length;
  const r = points.reduce((sum, p) => sum + p.r, 0) / points.length;
  const at = (pz: number, pr: number): Pt => ({ z: axial(pz), r: radius(pr) });
  return [{ q: "Q480", form: "diameter", at: at(z, toRadius(v.Q480)) }, { q: "Q482", form: "z", from: at(0, r), to: at(v.Q482, r) }];
}

/**
 * How strategy space lies: u runs from the first towards the last point. The open side of a transverse contour is +Z; it
 * is −Z only when a tool that points to +Z stands behind the contour (decision 0010). The open side of a longitudinal one
 * is away from the axis when the start point lies farther out than the contour.
 */
export function freeFrame(contour: readonly Segment[], setting: Setting, transverse: boolean): Frame {
  const points = contour.flatMap((s) => [s.from, s.to]);
  const first = points[0] as Pt;
  const last = points[points.length - 1] as Pt;
  if (transverse) {
    const behind = points.every((p) => setting.start.z <= p.z) && [3, 4, 5].includes(setting.tool.TO);
    return { transverse, signU: last.r < first.r ? -1 : 1, signV: behind ? -1 : 1 };
  }
  const outside = points.every((p) => setting.start.r >= p.r);
  return { transverse, signU: last.z < first.z ? -1 : 1, signV: outside ? 1 : -1 };
}
