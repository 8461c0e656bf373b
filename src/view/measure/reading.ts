import type { MeasuredEdge, MeasuredMoment, MeasuredPlace, Measurement } from "../../kernel/plan/measured.ts";
import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { segmentNow, type Measurable } from "./edges.ts";
import { gauged, type Gauged } from "./figure.ts";
import { onSide, halfOf } from "./snap.ts";

/** What measurements are read from again after each change. */
export interface MeasuredWork extends Measurable {
  /** The print of the stock of a moment; null where the program has no such moment. */
  readonly printOf: (moment: Omit<MeasuredMoment, "print">) => string | null;
}

/** A measurement as it is now. */
export interface MeasurementNow extends Gauged {
  readonly measurement: Measurement;
  /** What it was taken from is not there any more: the value is that of before the change. */
  readonly isOld: boolean;
}

/**
 * Where a place of a segment lies on the one that this became: an end at that end, the rest at the same share of the
 * way.
 */
function carried(was: Segment, is: Segment, p: Pt, spot: MeasuredPlace["spot"]): Pt | null {
  if (spot === "centre") return is.kind === "arc" ? is.centre : null;
  if (part.apart(p, was.from) < SAME) return is.from;
  if (part.apart(p, was.to) < SAME) return is.to;
  const long = part.lengthOf(was);
  return long < SAME ? null : part.pointOn(is, part.along(was, p) / long);
}

const isAt = (a: Pt, b: Pt): boolean => part.apart(a, b) < SAME;

/** An edge of the drawing that still holds the place in the same way, whatever became of the rest. */
function heldBy(
  drawing: Measurable,
  { of, segment: was }: MeasuredEdge,
  p: Pt,
  spot: MeasuredPlace["spot"],
): Segment | null {
  const chains = of === "contour" ? drawing.contours : drawing.blank;
  const holds = (is: Segment): boolean => {
    if (is.kind !== was.kind) return false;
    if (spot === "centre") return is.kind === "arc" && isAt(is.centre, p);
    if (spot === "corner") return isAt(is.from, p) || isAt(is.to, p);
    return part.distanceTo(is, p) < SAME;
  };
  for (const chain of chains) {
    const found = chain.find(holds);
    if (found) return found;
  }
  return null;
}

/** A place where it is now; null where it is gone. */
function placeNow(measured: MeasuredWork, place: MeasuredPlace): MeasuredPlace | null {
  const { at: p, spot, edge } = place;
  if (spot === "free") return place;
  if (spot === "path") return measured.path.some((end) => isAt(end, p)) ? place : null;
  if (!edge || edge.of === "stock") return place;
  const side = halfOf(measured, p),
    on = onSide(p, side);
  const own = segmentNow(measured, edge),
    now = own ? carried(edge.segment, own, on, spot) : null;
  if (own && now) return { ...place, at: onSide(now, side), edge: { ...edge, segment: own } };
  const segment = heldBy(measured, edge, on, spot);
  return segment && { ...place, edge: { ...edge, segment } };
}

/**
 * A measurement as it is now. Places on the contour or the blank go with the element that they were taken from; stock
 * of a moment is the same as long as all that made it is. What is gone is read as it was, and said to be old. Null
 * where it never made a value.
 */
export function readMeasurement(measurement: Measurement, measured: MeasuredWork): MeasurementNow | null {
  const { kind, places, moment } = measurement;
  const isTurned = measurement.plane === "ZX";
  const now = places.map((place) => placeNow(measured, place));
  const isThere = now.every((place) => place !== null);
  const isSame = !moment || measured.printOf(moment) === moment.print;
  const fresh =
    isThere && isSame
      ? gauged(
          kind,
          now.filter((place) => place !== null),
          isTurned,
        )
      : null;
  const read = fresh ?? gauged(kind, places, isTurned);
  return read && { ...read, measurement, isOld: fresh === null };
}
