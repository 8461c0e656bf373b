import { approach, type Approach, type ApproachRequest, type ApproachShape } from "../../kernel/plane/approach.ts";
import { plane, towardsTool, type PlanePoint, type PlaneSegment, type Side } from "../../kernel/plane/plane.ts";

const { apart, beyond, direction } = plane;

/** Where to put a form: at which contour, with which tool. */
export interface FormPlace {
  /** Behind APPR, or before DEP. */
  readonly contour: readonly PlaneSegment[];
  readonly side: Side;
  readonly toolRadius: number;
  /** Where the tool comes from or leaves to; null if unknown. */
  readonly outside: PlanePoint | null;
}

/** One of the eight forms with values that fit the place. */
export interface SuggestedForm {
  readonly shape: ApproachShape;
  readonly departing: boolean;
  readonly request: ApproachRequest;
  readonly result: Approach;
}

const SHAPES: readonly ApproachShape[] = ["LT", "LN", "CT", "LCT"];
/** Lengths to suggest, mm. */
const STEPS = [1, 2, 3, 5, 8, 10, 12, 15, 20, 25, 30, 40, 50, 60, 80, 100];

const atLeast = (size: number) => STEPS.find((s) => s >= size) ?? Math.ceil(size);
const rounded = (p: PlanePoint): PlanePoint => ({ x: Math.round(p.x), y: Math.round(p.y) });

/** A place outside the contour from which every form works. */
export function outsidePoint({ contour, side, toolRadius }: FormPlace, departing: boolean): PlanePoint | null {
  const element = departing ? contour.at(-1) : contour[0];
  if (!element) return null;
  const corner = departing ? element.to : element.from;
  const way = direction(element, corner);
  const far = atLeast(toolRadius * 1.5 + 5);
  return rounded(
    beyond(
      beyond(corner, towardsTool(way, side === "none" ? "left" : side), toolRadius + far * 1.4),
      way,
      (departing ? 1.6 : -1.6) * far,
    ),
  );
}

/** The four approaches or the four departures, side by side at the same contour. */
export function suggestedForms(place: FormPlace, departing: boolean): readonly SuggestedForm[] {
  const element = departing ? place.contour.at(-1) : place.contour[0];
  if (!element) return [];
  const { side, toolRadius } = place;
  const outside = place.outside ?? outsidePoint(place, departing);
  const size = atLeast(Math.max(5, toolRadius));
  return SHAPES.map((shape) => {
    const sideOfForm = shape === "CT" && side === "none" ? "left" : side;
    const common = {
      shape,
      departing,
      side: sideOfForm,
      toolRadius,
      element,
      outside: departing && shape !== "LCT" ? null : outside,
    };
    const own =
      shape === "CT"
        ? { radius: size, centreAngle: 90 }
        : shape === "LCT"
          ? { radius: size }
          : { length: atLeast(Math.max(5, toolRadius * 1.2)) };
    const request: ApproachRequest = { ...common, ...own };
    const result = approach(request);
    const inside = result.issues.find((found) => found.code === "approachInsideCircle");
    const fits = inside?.data.nearest;
    if (fits === undefined || fits < 0.1) return { shape, departing, request, result };
    const smaller: ApproachRequest = { ...request, radius: STEPS.findLast((s) => s <= fits) ?? fits };
    return { shape, departing, request: smaller, result: approach(smaller) };
  });
}

/** As much of a contour as lies near its end. */
export function nearby(contour: readonly PlaneSegment[], departing: boolean, most: number): readonly PlaneSegment[] {
  const end = departing ? contour.at(-1)?.to : contour[0]?.from;
  if (!end) return [];
  const near = contour.filter((s) => Math.min(apart(s.from, end), apart(s.to, end)) <= most);
  return near.length > 0 ? near : departing ? contour.slice(-1) : contour.slice(0, 1);
}
