import { issue, type Issue } from "../plan/issue.ts";
import { fixesFinding, offerOf, withOffer } from "../plan/offer.ts";
import { plane, towardsTool, type PlanePoint, type PlaneSegment, type Side } from "./plane.ts";
import { opposite, type Turn } from "../geometry/segments.ts";
import { ROUND } from "../tolerance.ts";
import { roundedDown } from "../units.ts";

const { apart, beyond, cross, difference, direction, dot, leftOf, reversed, scaled, sizeOf, sum, sweepOf, turned } =
  plane;

/** The geometry of APPR and DEP. The polar forms (PLT, PLN, PCT, PLCT) differ only in the notation of their point. */
export type ApproachShape = "LT" | "LN" | "CT" | "LCT";

/** Input of an approach or a departure. Lengths mm, angles degrees; a missing word is absent. */
export interface ApproachRequest {
  readonly shape: ApproachShape;
  readonly departing: boolean;
  /** RL, RR or R0: for APPR from its own block, for DEP from the contour before it. */
  readonly side: Side;
  /** Radius of the mill, or of the nose. */
  readonly toolRadius: number;
  /** First (APPR) or last (DEP) element of the programmed contour. */
  readonly element: PlaneSegment;
  /**
   * APPR: the tool centre before the block (PS). DEP LCT: the programmed end point PN. Null if unknown or not needed.
   */
  readonly outside: PlanePoint | null;
  /** LEN of LT and LN, with its sign. */
  readonly length?: number;
  /** R of CT and LCT, with its sign. */
  readonly radius?: number;
  /** CCA of CT. */
  readonly centreAngle?: number;
}

export type PointName = "PS" | "PH" | "PA" | "PE" | "PN";
/** Named points of a form, each on the path of the tool centre. */
export type NamedPoints = { readonly [N in PointName]?: PlanePoint };

/** One leg of the path, in the order of travel. */
export interface ApproachLeg {
  readonly segment: PlaneSegment;
  /** "before": at the last feed (or rapid) before the block; "block": at the feed of the block. */
  readonly feed: "before" | "block";
}

/**
 * The path of the tool centre onto the contour (PS, PH, PA) or off it (PE, PH, PN). An impossible part is left out and
 * reported.
 */
export interface Approach {
  readonly shape: ApproachShape;
  readonly departing: boolean;
  readonly side: Side;
  readonly points: NamedPoints;
  readonly legs: readonly ApproachLeg[];
  /** Direction of the contour in PA or PE, length 1. */
  readonly tangent: PlanePoint;
  /** The arc of CT and LCT: centre angle in degrees. */
  readonly arc: {
    readonly centre: PlanePoint;
    readonly radius: number;
    readonly angle: number;
    readonly turn: Turn;
  } | null;
  readonly issues: readonly Issue[];
}

/** Largest value that a control accepts for lengths and radii. */
const MOST = 99_999.9999;
const LEAST = 0.001;
/** A tangent that touches the circle nearer to PA than this needs no arc, mm. */
const NO_ARC = 1e-6;

/** The path from outside onto the contour; a departure is computed as an arrival and reversed. */
interface Arrival {
  readonly auxiliary: PlanePoint | null;
  readonly segments: readonly PlaneSegment[];
  readonly arc: Approach["arc"];
}

interface Anchor {
  /** The tool centre in PA, or in PE for a departure. */
  readonly at: PlanePoint;
  /** Direction of arrival, and the unit vector to the side of the tool. */
  readonly way: PlanePoint;
  readonly free: PlanePoint;
  readonly hand: "left" | "right";
}

const flipped = (hand: "left" | "right") => (hand === "left" ? "right" : "left");
const lineTo = (from: PlanePoint | null, to: PlanePoint): PlaneSegment[] => (from ? [{ kind: "line", from, to }] : []);

function straight(q: ApproachRequest, a: Anchor, issues: Issue[]): Arrival {
  // A control then moves straight to the contour.
  if (q.length === undefined) issues.push(issue("missing", "warning", {}, "LEN"));
  const length = q.length ?? 0;
  // A minus selects the other side for LN; from the far end of a tangent there is no way onto the contour.
  if (q.shape === "LT" && length < 0)
    issues.push(issue("outOfRange", "error", { value: length, min: 0, max: MOST, nearest: -length }, "LEN"));
  const auxiliary = q.shape === "LT" ? beyond(a.at, a.way, -length) : beyond(a.at, a.free, length);
  return {
    auxiliary,
    segments: [...lineTo(q.departing ? null : q.outside, auxiliary), ...lineTo(auxiliary, a.at)],
    arc: null,
  };
}

/** A radius that makes a circle; null if there is none. `signed`: the sign selects the side. */
function radiusOf(q: ApproachRequest, signed: boolean, issues: Issue[]): number | null {
  const r = q.radius;
  if (r === undefined) issues.push(issue("missing", "error", {}, "R"));
  else if (r === 0 || (!signed && r < 0))
    issues.push(issue("outOfRange", "error", { value: r, min: LEAST, max: MOST, nearest: Math.max(LEAST, -r) }, "R"));
  return r === undefined || r === 0 ? null : signed ? r : Math.abs(r);
}

function angleOf(q: ApproachRequest, issues: Issue[]): number | null {
  const angle = q.centreAngle;
  if (angle === undefined) issues.push(issue("missing", "error", {}, "CCA"));
  else if (!(angle > 0 && angle <= 360)) {
    const nearest = angle > 360 ? 360 : angle < 0 ? Math.min(360, -angle) : LEAST;
    issues.push(issue("outOfRange", "error", { value: angle, min: LEAST, max: 360, nearest }, "CCA"));
    return angle === 0 ? null : nearest;
  }
  return angle ?? null;
}

function circular(q: ApproachRequest, a: Anchor, issues: Issue[]): Arrival | null {
  if (q.side === "none") issues.push(issue("approachNeedsSide", "error", {}));
  const [radius, angle] = [radiusOf(q, true, issues), angleOf(q, issues)];
  if (radius === null || angle === null || q.side === "none") return null;
  const centre = beyond(a.at, a.free, radius);
  const turn: Turn = (a.hand === "left") === radius > 0 ? "ccw" : "cw";
  const auxiliary = angle === 360 ? a.at : turned(a.at, centre, turn === "ccw" ? -angle : angle);
  const arc: PlaneSegment = { kind: "arc", from: auxiliary, to: a.at, centre, turn };
  return {
    auxiliary,
    segments: [...lineTo(q.departing ? null : q.outside, auxiliary), arc],
    arc: { centre, radius: Math.abs(radius), angle, turn },
  };
}

/** Line and arc: the line touches the circle, which is determined by its radius alone. */
function tangential(q: ApproachRequest, a: Anchor, issues: Issue[]): Arrival | null {
  const radius = radiusOf(q, false, issues);
  const { outside } = q;
  if (radius === null || !outside) return null;
  const centre = beyond(a.at, a.free, radius);
  const spoke = difference(outside, centre);
  const far = sizeOf(spoke);
  if (far < radius - ROUND) {
    const w = difference(outside, a.at);
    const fits = dot(w, w) / (dot(w, a.free) + dot(w, a.free));
    const nearest = fits > 0 ? roundedDown(fits) : 0;
    issues.push(issue("approachInsideCircle", "error", { point: q.departing ? "PN" : "PS", radius, nearest }, "R"));
    return null;
  }
  const turn: Turn = a.hand === "left" ? "ccw" : "cw";
  const half = Math.sqrt(Math.max(0, far * far - radius * radius));
  const aside = ((turn === "ccw" ? radius : -radius) * half) / (far * far);
  const touching = sum(centre, sum(scaled(spoke, (radius * radius) / (far * far)), scaled(leftOf(spoke), aside)));
  if (apart(touching, a.at) <= NO_ARC) return { auxiliary: a.at, segments: lineTo(outside, a.at), arc: null };
  const arc = { kind: "arc", from: touching, to: a.at, centre, turn } as const;
  return {
    auxiliary: touching,
    segments: [...lineTo(outside, touching), arc],
    arc: { centre, radius, angle: (sweepOf(arc) * 180) / Math.PI, turn },
  };
}

/**
 * Path of APPR onto the contour or of DEP off it. Never throws; an impossible form becomes a straight line, with an
 * issue.
 */
export function approach(q: ApproachRequest): Approach {
  const made = computeApproach(q);
  return { ...made, issues: made.issues.map((each) => withTestedOffer(each, q, made.issues)) };
}

/** Keeps an offer only if trying it in its word fixes the finding. */
function withTestedOffer(found: Issue, q: ApproachRequest, before: readonly Issue[]): Issue {
  const offer = offerOf(found);
  if (offer === null) return found;
  const key = found.at === "R" ? "radius" : found.at === "CCA" ? "centreAngle" : "length";
  return fixesFinding(found, before, computeApproach({ ...q, [key]: offer }).issues) ? found : withOffer(found, null);
}

function computeApproach(q: ApproachRequest): Approach {
  const issues: Issue[] = [];
  const corner = q.departing ? q.element.to : q.element.from;
  const tangent = direction(q.element, corner);
  const at = beyond(corner, towardsTool(tangent, q.side), q.toolRadius);
  let hand: "left" | "right" = q.side === "none" ? "left" : q.side;
  if (q.side === "none" && q.shape === "LCT" && q.outside)
    hand = cross(tangent, difference(q.outside, at)) >= 0 ? "left" : "right";
  if (q.side === "none" && q.shape === "LN") issues.push(issue("approachSideAssumed", "warning", {}));
  const anchor: Anchor = {
    at,
    free: towardsTool(tangent, hand),
    way: q.departing ? scaled(tangent, -1) : tangent,
    hand: q.departing ? flipped(hand) : hand,
  };
  const made =
    q.shape === "CT"
      ? circular(q, anchor, issues)
      : q.shape === "LCT"
        ? tangential(q, anchor, issues)
        : straight(q, anchor, issues);
  const arrival = made ?? { auxiliary: null, segments: lineTo(q.outside, at), arc: null };
  const { shape, departing, side } = q;
  const common = {
    shape,
    departing,
    side,
    tangent,
    arc: arrival.arc && q.departing ? { ...arrival.arc, turn: opposite(arrival.arc.turn) } : arrival.arc,
    issues,
  };
  const ph = arrival.auxiliary;
  if (!departing) {
    const legs = arrival.segments.map((segment, i): ApproachLeg => ({
      segment,
      feed: made && shape !== "LCT" && i === 0 && q.outside ? "before" : "block",
    }));
    return { ...common, points: { ...(q.outside && { PS: q.outside }), ...(ph && { PH: ph }), PA: at }, legs };
  }
  const legs = arrival.segments.map((s): ApproachLeg => ({ segment: reversed(s), feed: "block" })).reverse();
  const end = shape === "LCT" ? q.outside : ph;
  return { ...common, points: { PE: at, ...(shape === "LCT" && ph && { PH: ph }), ...(end && { PN: end }) }, legs };
}
