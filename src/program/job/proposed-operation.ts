import type { Cycle, TurnedShape } from "../../cycles/define.ts";
import { useOf, worksAcross } from "../../cycles/use.ts";
import type { Corner, Site, ShapeRequest } from "../../cycles/shape-request.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { at, part, type Ring } from "../../kernel/geometry/point.ts";
import { axial, diameter, radius, rounded, toDiameter, toRadius } from "../../kernel/units.ts";
import type { SetJob, SpindleDraft } from "./job.ts";
import type { Operation } from "../state/run-types.ts";
import { positionAsTyped, valueAsTyped } from "../values/typed-value.ts";
import { jobFor, withValue } from "./requested-job.ts";
import { boxAroundContour, requestedContour } from "./requested-shape.ts";

/** Context of a new operation: the blank, and the previous operations. */
export interface OperationContext {
  readonly blank: readonly Ring[];
  /** Previous operations, in order. */
  readonly before: readonly Operation[];
}

/** Share of diameter and length in a first proposal, and its recess depth and width, mm. */
const PART = { diameter: 0.8, length: 0.4 };
const RECESS = { depth: 6, width: 5, behind: 10 };
const FACE = 5;
const PITCH = 1.5;
/** Distance of a start point from the face, mm: more than the set-up clearance of the cycles. */
const CLEARANCE = 3;
/** Distance of a start point from a thread on a contour, mm. */
const RUN_IN = 10;

/** Dimensions as one would write them: whole numbers. */
const whole = (n: number): number => Math.round(n);

interface Room {
  readonly outer: number;
  readonly bore: number;
  readonly front: number;
  readonly back: number;
}

/** The blank as diameters and Z; the usual one where a program states none. */
function roomOf(blank: readonly Ring[]): Room {
  if (blank.length === 0) return { outer: 80, bore: 0, front: 1, back: -99 };
  const { left, right, low, high } = boxOf(blank.flat());
  return {
    outer: rounded(toDiameter(radius(high))),
    bore: rounded(toDiameter(radius(Math.max(0, low)))),
    front: right,
    back: left,
  };
}

const corner = (d: number, z: number): Corner => ({
  diameter: diameter(rounded(Math.max(0, d))),
  z: axial(rounded(z)),
});

/** Corners of the last previous operation on the same site; null without one. */
function lastOf(before: readonly Operation[], site: Site): Pick<ShapeRequest, "from" | "to"> | null {
  const sideOf = ({ plan: { openSide } }: Operation): Site => {
    if (Math.abs(openSide.z) > Math.abs(openSide.r)) return "face";
    return openSide.r < 0 ? "inside" : "outside";
  };
  const found = before.findLast((operation) => sideOf(operation) === site && operation.plan.contour.length > 0);
  return found ? boxAroundContour(found.plan.contour, site) : null;
}

function stepOutside(
  { outer, front, back }: Room,
  last: Pick<ShapeRequest, "from" | "to"> | null,
): Pick<ShapeRequest, "from" | "to"> {
  const length = whole((front - back) * PART.length);
  if (!last) return { from: corner(outer, 0), to: corner(whole(outer * PART.diameter), -length) };
  // A shoulder continues at the end of the previous one, at the next diameter.
  const rest = Math.max(1, whole((last.to.z - back) * PART.length));
  const inner =
    last.from.diameter < outer ? last.from.diameter : last.to.diameter + (outer - last.to.diameter) * PART.diameter;
  return { from: corner(outer, last.to.z), to: corner(inner, last.to.z - rest) };
}

function onFace(
  { outer, bore, front }: Room,
  last: Pick<ShapeRequest, "from" | "to"> | null,
): Pick<ShapeRequest, "from" | "to"> {
  // Material in front of Z0 is faced first.
  if (front > 0 && !last) return { from: corner(outer, front), to: corner(bore, 0) };
  return { from: corner(outer, 0), to: corner(whole(outer * PART.diameter), -FACE) };
}

function inRecess(
  room: Room,
  site: Site,
  last: Pick<ShapeRequest, "from" | "to"> | null,
): Pick<ShapeRequest, "from" | "to"> {
  const { outer, front, back } = room;
  if (site === "face") {
    const middle = whole((outer + room.bore) * PART.length);
    return { from: corner(middle + RECESS.depth, 0), to: corner(middle - RECESS.depth, -RECESS.width) };
  }
  const top = last ? Math.min(last.to.diameter, outer) : outer;
  const z = Math.max(last ? last.to.z + RECESS.behind : -RECESS.behind, back + (front - back) * PART.length);
  return { from: corner(top, z), to: corner(top - RECESS.depth, z - RECESS.width) };
}

/** Shape that a cycle would machine here: continues the last operation, within the blank. */
function wantedHere(cycle: Cycle, { blank, before }: OperationContext): ShapeRequest {
  const room = roomOf(blank);
  const across = worksAcross(cycle);
  const [shape = "step"] = useOf(cycle).shapes as readonly TurnedShape[];
  const site: Site = across ? "face" : "outside";
  const last = lastOf(before, site) ?? (across ? null : lastOf(before, "outside"));
  const rest = { site, angle: 0, pitch: PITCH, contour: null, allowance: 0 } as const;
  if (cycle.group === "thread") {
    const { from, to } = stepOutside(room, null);
    const on = last ?? { from, to: { ...to, diameter: from.diameter } };
    return {
      ...rest,
      site: "outside",
      shape: "thread",
      from: corner(on.to.diameter, on.from.z),
      to: corner(on.to.diameter, on.to.z),
    };
  }
  if (shape === "groove" || cycle.group === "recessing" || cycle.group === "recessTurning")
    return { ...rest, shape: "groove", ...inRecess(room, site, last) };
  const corners = across ? onFace(room, last) : stepOutside(room, last);
  return { ...rest, shape: shape === "plunge" ? "plunge" : "step", ...corners };
}

/** The same with a drawn contour, where the cycle takes one. */
function drawn(cycle: Cycle, wanted: ShapeRequest): ShapeRequest {
  if (cycle.contour !== "free") return wanted;
  const r = toRadius(wanted.from.diameter);
  const line = [part.line(at(wanted.from.z, r), at(wanted.to.z, r))];
  return { ...wanted, shape: "free", contour: wanted.shape === "thread" ? line : requestedContour(wanted) };
}

/** Edge of a shoulder that any insert can turn. */
const EDGE = { q: "Q500", size: 1 };

function withEdge(job: SetJob, cycle: Cycle, wanted: ShapeRequest): SetJob {
  if (cycle.params[EDGE.q] === undefined || wanted.shape !== "step" || wanted.site === "face") return job;
  return withValue(job, EDGE.q, EDGE.size);
}

/** A face is called from outside and in front of it, a thread on a contour from in front of it. */
function withOwnStart(job: SetJob, cycle: Cycle, { site, shape, from }: ShapeRequest): SetJob {
  if (shape === "thread" && cycle.contour === "free") {
    const [x, z] = [from.diameter + RUN_IN, from.z + RUN_IN];
    return { ...job, start: { x: positionAsTyped(x), z: positionAsTyped(z) } };
  }
  return site === "face" && shape === "step"
    ? { ...job, start: { ...job.start, z: positionAsTyped(from.z + CLEARANCE) } }
    : job;
}

/** Proposes a job of a cycle that fits the stock and the previous operations; everything can be changed afterwards. */
export function proposedOperation(cycle: Cycle, here: OperationContext): SetJob {
  const wanted = wantedHere(cycle, here);
  const plain = jobFor(cycle, drawn(cycle, wanted), here.blank.length > 0 ? here.blank : null);
  const job = withOwnStart(withEdge(plain, cycle, wanted), cycle, wanted);
  const last = here.before.at(-1)?.spindle;
  // A thread is cut at a constant speed, regardless of earlier cuts.
  const fits = last && (cycle.group !== "thread" || last.kind === "constant");
  return { ...job, spindle: fits ? spindleAsTyped(job.spindle, last) : job.spindle };
}

function spindleAsTyped(usual: SpindleDraft, spindle: NonNullable<Operation["spindle"]>): SpindleDraft {
  return spindle.kind === "constant"
    ? { ...usual, mode: "constant", speed: valueAsTyped(spindle.speed) }
    : {
        ...usual,
        mode: "surface",
        cuttingSpeed: valueAsTyped(spindle.cuttingSpeed),
        limit: valueAsTyped(spindle.limit),
      };
}
