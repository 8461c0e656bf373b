import { pathAlong } from "../reach/envelope.ts";
import {
  flat,
  normalAt,
  segmentToFlat,
  segmentToPart,
  type Flat,
  type FlatSegment,
  type Frame,
} from "../geometry/flat.ts";
import type { Segment } from "../geometry/point.ts";
import { JOINED, ROUND } from "../tolerance.ts";
import type { Tool } from "../plan/tool.ts";
import { length } from "../units.ts";
import { tipEnvelopeOver } from "./tip-envelope.ts";

/**
 * A tool without a nose radius, for drawings and divisions without a tool: round inserts suit every cutting direction.
 */
export const POINT_TOOL: Tool = { T: 0, NAME: "", TYPE: "BUTTON", TO: 9, RS: length(0) };

/**
 * A contour with its oversize, as the path of a point in machining direction: the state that a cycle leaves, or with
 * `round`, perpendicular to the contour everywhere, the state before it. It begins and ends next to the ends of the
 * contour.
 */
export function oversizeContour(
  contour: readonly Segment[],
  frame: Frame,
  { r, z, round = 0 }: { readonly r: number; readonly z: number; readonly round?: number },
): Segment[] {
  const elements = contour.map((s) => segmentToFlat(frame, s));
  const [first, last] = [elements[0], elements.at(-1)];
  if (!first || !last) return [];
  const keep = frame.transverse ? { u: r, v: z, round } : { u: z, v: r, round };
  const around = { wall: null, front: "part", frontWall: null, floors: [] } as const;
  const { envelope } = tipEnvelopeOver(
    elements.map((segment) => ({ segment, on: "contour" })),
    POINT_TOOL,
    frame,
    keep,
    around,
  );
  const beside = (s: FlatSegment, end: "from" | "to"): Flat => {
    const n = normalAt(s, end);
    return {
      u: s[end].u + sign(n.u) * keep.u + n.u * round,
      v: s[end].v + Math.max(0, sign(n.v)) * keep.v + n.v * round,
    };
  };
  const [start, end] = [beside(first, "from"), beside(last, "to")];
  const path = pathAlong(envelope, start.u + JOINED, end.u - JOINED).map((s) => s.segment);
  // A wall at an end of the contour gives a step.
  const whole = [
    flat.line(start, path[0]?.from ?? end),
    ...path,
    ...(path.length > 0 ? [flat.line(path.at(-1)?.to ?? end, end)] : []),
  ];
  return whole.map((s) => segmentToPart(frame, s));
}

/** 0 for a direction along the other axis. */
const sign = (n: number) => (Math.abs(n) < ROUND ? 0 : Math.sign(n));
