import type { MeasuredEdge, MeasuredMoment, MeasuredPlace, Measurement } from "../../kernel/plan/measured.ts";
import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { segmentNow, type Measurable } from "./edges.ts";
import { measuredFigure, type MeasuredFigure } from "./figure.ts";
import { onSide, halfOf } from "./snap.ts";

/** The current geometry from which measurements are read after each change. */
export interface MeasuredWork extends Measurable {
  /** The fingerprint of the stock of a moment; null if the program has no such moment. */
  readonly fingerprintOf: (moment: Omit<MeasuredMoment, "print">) => string | null;
}

/** A measurement, read from the current geometry. */
export interface CurrentMeasurement extends MeasuredFigure {
  readonly measurement: Measurement;
  /** The geometry it was taken from is gone: the value is the previous one. */
  readonly isStale: boolean;
}

/**
 * Maps a place on a segment to the changed segment: an end to the same end, other places to the same share of the
 * length.
 */
function carried(was: Segment, is: Segment, p: Pt, spot: MeasuredPlace["spot"]): Pt | null {
  if (spot === "centre") return is.kind === "arc" ? is.centre : null;
  if (part.apart(p, was.from) < SAME) return is.from;
  if (part.apart(p, was.to) < SAME) return is.to;
  const long = part.lengthOf(was);
  return long < SAME ? null : part.pointOn(is, part.along(was, p) / long);
}

const isAt = (a: Pt, b: Pt): boolean => part.apart(a, b) < SAME;

/** An edge of the drawing that still carries the place in the same way, whatever else has changed. */
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

/** The current position of a place; null if it is gone. */
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
 * Reads a measurement from the current geometry. Places on the contour or the blank follow the element they were taken
 * from; stock of a moment is current while everything that made it is unchanged. A measurement without its geometry
 * keeps its value and is marked as old. Null if it never had a value.
 */
export function readMeasurement(measurement: Measurement, measured: MeasuredWork): CurrentMeasurement | null {
  const { kind, places, moment } = measurement;
  const isTurned = measurement.plane === "ZX";
  const now = places.map((place) => placeNow(measured, place));
  const isThere = now.every((place) => place !== null);
  const isSame = !moment || measured.fingerprintOf(moment) === moment.print;
  const fresh =
    isThere && isSame
      ? measuredFigure(
          kind,
          now.filter((place) => place !== null),
          isTurned,
        )
      : null;
  const read = fresh ?? measuredFigure(kind, places, isTurned);
  return read && { ...read, measurement, isStale: fresh === null };
}
