import { part, type Pt } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { ContourChoice, DrawnContour, DrawnCurve, Drawing } from "./drawing.ts";
import { acrossAxis, alongAxis, segmentsOnDrawing } from "./on-drawing.ts";
import { axisAlong, axisPositions, nearestCurve, nextPosition, rounded, zeroPositions } from "./positions.ts";
import { propose } from "./propose.ts";

/** What a tap on the picture chooses. */
export type PickKind = "contour" | "axis" | "zero";

/** Reads the contour of a choice. */
export type ContourReader = (choice: ContourChoice) => DrawnContour;

/** Result of a tap: the changed choice, or why nothing is there. */
export type Picked =
  | { readonly change: Partial<ContourChoice> }
  | { readonly refused: "notStraight" | "nothingHere" | "notOfContour" };
/** Another axis: half, piece and zero point are proposed for it. Without a place the likeliest is taken. */
function axisChosen(
  drawing: Drawing,
  { gap, reversed, thin, diameters, withoutLayers }: ContourChoice,
  on: { readonly axis: ContourChoice["axis"]; readonly axisAt?: number },
): ContourChoice {
  return propose(drawing, { ...on, gap, reversed, thin, diameters, withoutLayers });
}

function pickAxis(drawing: Drawing, choice: ContourChoice, p: Pt, within: number): Picked {
  const isAxis = (curve: DrawnCurve) => axisAlong(curve) !== null;
  const index =
    nearestCurve(drawing.curves, p, within, (curve) => curve.role === "centre" && isAxis(curve)) ??
    nearestCurve(drawing.curves, p, within, isAxis);
  const on = index === null ? null : axisAlong(drawing.curves[index] as DrawnCurve);
  if (on) return { change: axisChosen(drawing, choice, on) };
  return { refused: nearestCurve(drawing.curves, p, within) === null ? "nothingHere" : "notStraight" };
}

function pickZero(drawing: Drawing, choice: ContourChoice, p: Pt, within: number): Picked {
  let found: Pt | null = null,
    least = within;
  for (const { segment: s } of drawing.curves)
    for (const end of s.kind === "arc" ? [s.from, s.to, s.centre] : [s.from, s.to]) {
      const far = Math.hypot(end.z - p.z, end.r - p.r);
      if (far <= least) [found, least] = [end, far];
    }
  if (found) return { change: { zero: rounded(alongAxis(choice, found)) } };
  const across = choice.axis === "x" ? "y" : "x";
  const index = nearestCurve(drawing.curves, p, within, (curve) => axisAlong(curve)?.axis === across);
  const on = index === null ? null : axisAlong(drawing.curves[index] as DrawnCurve);
  return on ? { change: { zero: on.axisAt } } : { refused: "nothingHere" };
}

/** Distance of a point of the drawing from the contour of a choice, mm. */
const farFrom = (choice: ContourChoice, { segments }: DrawnContour, p: Pt): number =>
  segmentsOnDrawing(choice, segments)
    .flat()
    .reduce((least, s) => Math.min(least, part.distanceTo(s, p)), Infinity);

/** Whether a line can be part of a contour. */
const counts = ({ thin, withoutLayers }: ContourChoice, { role, layer }: DrawnCurve): boolean =>
  role !== "centre" && (thin || role === "outline") && !withoutLayers.includes(layer);

function pickContour(drawing: Drawing, choice: ContourChoice, p: Pt, within: number, read: ContourReader): Picked {
  const index = nearestCurve(drawing.curves, p, within, (curve) => counts(choice, curve));
  const sideOf = (q: Pt): ContourChoice["half"] => (acrossAxis(choice, q) >= choice.axisAt ? "upper" : "lower");
  if (index === null) {
    const half = sideOf(p);
    return half === choice.half || read({ ...choice, half, piece: 0 }).pieces.length === 0
      ? { refused: "nothingHere" }
      : { change: { half, piece: 0 } };
  }
  const { segment } = drawing.curves[index] as DrawnCurve,
    half = sideOf(part.nearestOn(segment, p));
  // A line on the axis belongs to both halves: the present one first.
  const halves = half === choice.half ? [half] : [half, choice.half];
  for (const each of halves) {
    const base = { ...choice, half: each };
    const piece = read(base).pieces.findIndex(({ curves }) => curves.includes(index));
    if (piece < 0) continue;
    const chosen = { ...base, piece },
      own = read(chosen);
    if (!own.hasSides) return { change: { half: each, piece } };
    const sides = (["outside", "bore"] as const).map((side) => {
      const asked = { ...chosen, side };
      return { side, far: farFrom(asked, side === chosen.side ? own : read(asked), p) };
    });
    const side = sides.reduce((best, next) => (next.far < best.far - SAME ? next : best)).side;
    return { change: { half: each, piece, side } };
  }
  return { refused: "notOfContour" };
}

/**
 * What a tap at a point of the drawing chooses. `within`: reach of the tap, mm; `read`: the contour of a choice, for the
 * pieces of the other half.
 */
export function picked(
  of: PickKind,
  drawing: Drawing,
  choice: ContourChoice,
  p: Pt,
  within: number,
  read: ContourReader,
): Picked {
  if (of === "axis") return pickAxis(drawing, choice, p, within);
  return of === "zero" ? pickZero(drawing, choice, p, within) : pickContour(drawing, choice, p, within, read);
}

export type ArrowKey = "ArrowLeft" | "ArrowRight" | "ArrowUp" | "ArrowDown";

/** What the arrow keys choose on the picture: the next axis, zero point, piece or half; null for no change. */
export function stepped(
  of: PickKind,
  key: ArrowKey,
  drawing: Drawing,
  choice: ContourChoice,
  read: ContourReader,
): Partial<ContourChoice> | null {
  const isLevel = key === "ArrowLeft" || key === "ArrowRight",
    by = key === "ArrowRight" || key === "ArrowUp" ? 1 : -1;
  if (of === "axis") {
    const axis = isLevel ? "y" : "x";
    if (axis !== choice.axis) return axisChosen(drawing, choice, { axis });
    const axisAt = nextPosition(axisPositions(drawing, axis), choice.axisAt, by);
    return axisAt === choice.axisAt ? null : axisChosen(drawing, choice, { axis, axisAt });
  }
  if (of === "zero") {
    if (isLevel !== (choice.axis === "x")) return null;
    const zero = nextPosition(zeroPositions(drawing, choice, read(choice)), choice.zero, by);
    return zero === choice.zero ? null : { zero };
  }
  if (isLevel === (choice.axis === "y")) {
    const half = by > 0 ? "upper" : "lower";
    return half === choice.half ? null : { half, piece: 0 };
  }
  const piece = choice.piece + by;
  return read(choice).pieces[piece] ? { piece } : null;
}
