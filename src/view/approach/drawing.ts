import type { Approach } from "../../kernel/plane/approach.ts";
import { partSegment, plane, type PlanePoint, type PlaneSegment } from "../../kernel/plane/plane.ts";
import type { Camera, Place, Size } from "../camera.ts";
import { arrange } from "../dimensions/arrange.ts";
import type { LabelBox } from "../dimensions/labels.ts";
import { arrowHead, circle, polyline, segmentPath, type Mark } from "../help/marks.ts";
import { filled, stroke, type Tag } from "../help/stroke.ts";
import { dimensionItems } from "./dimensions.ts";
import { along, cameraFor, planeFrameOf, onScreen } from "./frame.ts";
import { contactLines, pointItem, shownPoints, type PointsOf, type ShownPoint } from "./points.ts";
import type { ApproachWords } from "./words.ts";

const { beyond } = plane;

/** What to draw of one approach or departure. */
export interface ApproachScene {
  readonly result: Approach;
  /** The programmed contour next to it, and the path of the tool centre along it. */
  readonly contour: readonly PlaneSegment[];
  readonly centre: readonly PlaneSegment[];
  readonly toolRadius: number;
  /** The way to PH runs at rapid. */
  readonly rapidBefore: boolean;
  /** The word of the current prompt; null draws everything quiet. */
  readonly active: string | null;
  readonly size: Size;
  /** Small pictures carry names without coordinates and no dimensions. */
  readonly small: boolean;
  readonly speech: ApproachWords;
  /** Keeps the picture where it is while a point is dragged. */
  readonly camera?: Camera;
}

/** The display list, from back to front, all places in CSS pixels. */
export interface ApproachDrawing {
  readonly size: Size;
  readonly marks: readonly Mark[];
  readonly points: readonly ShownPoint[];
  /** Centre of the arc, on the screen and in the plane. */
  readonly centre: { readonly at: PlanePoint; readonly place: Place } | null;
  readonly labels: readonly LabelBox[];
  readonly camera: Camera;
}

const quiet: Tag = { q: null, active: false };
const LARGE = { left: 76, right: 76, top: 32, bottom: 32 };
const SMALL = { left: 20, right: 20, top: 22, bottom: 22 };

/** The tangent in PA or PE, a little longer than the tool's reach. */
function tangentLine(scene: ApproachScene, camera: Camera, contact: PlanePoint): Mark {
  const far = Math.max(scene.toolRadius * 1.25, 34 / camera.scale);
  const { tangent } = scene.result;
  return stroke(
    quiet,
    "axis",
    polyline([onScreen(camera, beyond(contact, tangent, -far)), onScreen(camera, beyond(contact, tangent, far))]),
  );
}

/** The right-angle mark between contour and path in the perpendicular forms. */
function squareMark({ result }: ApproachScene, camera: Camera, contact: PlanePoint, outer: PlanePoint): Mark {
  const k = 9 / camera.scale;
  const long = Math.hypot(outer.x - contact.x, outer.y - contact.y) || 1;
  const away = { x: (outer.x - contact.x) / long, y: (outer.y - contact.y) / long };
  const [a, c] = [beyond(contact, result.tangent, k), beyond(contact, away, k)];
  return stroke(quiet, "thin", polyline([a, beyond(a, away, k), c].map((p) => onScreen(camera, p))));
}

/** An arrow half way along a leg that shows its direction. */
function legArrow(tag: Tag, leg: PlaneSegment, camera: Camera): Mark[] {
  const [a, b] = [...along([leg], 16)].slice(8, 10).map((p) => onScreen(camera, p));
  const ends = [onScreen(camera, leg.from), onScreen(camera, leg.to)] as const;
  if (!a || !b || Math.hypot(ends[1].x - ends[0].x, ends[1].y - ends[0].y) < 26) return [];
  return [filled(tag, "arrow", arrowHead(b, b.x - a.x, b.y - a.y, 9))];
}

/** The picture of one approach: contour, compensated path, tool at its points, tangent, dimensions and names. */
export function approachDrawing(scene: ApproachScene): ApproachDrawing {
  const { result, contour, toolRadius, size, active } = scene;
  const element = (result.departing ? contour.at(-1) : contour[0]) ?? {
    kind: "line",
    from: { x: 0, y: 0 },
    to: { x: 1, y: 0 },
  };
  const camera =
    scene.camera ?? cameraFor(planeFrameOf(result, element, toolRadius), size, scene.small ? SMALL : LARGE);
  const path = (segments: readonly PlaneSegment[]) => segmentPath(segments.map(partSegment), camera);
  const own: readonly PointsOf[] = [{ ...result, contact: result.departing ? element.to : element.from }];
  const points = shownPoints(own, camera),
    centres = points.filter(({ onContour }) => !onContour);
  const contact = result.departing ? result.points.PE : result.points.PA;
  const auxiliary = result.departing ? result.points.PN : result.points.PH;
  const side: Tag = { q: "SIDE", active: active === "SIDE" };
  const feed: Tag = { q: "F", active: active === "F" };

  const tools =
    toolRadius > 0 ? centres.map((p) => stroke(quiet, "edge", circle(p.place, toolRadius * camera.scale))) : [];
  const marks: Mark[] = [
    stroke(side, "pass", path(scene.centre)),
    ...tools,
    stroke(quiet, "contour", path(contour)),
    ...contactLines(own, camera).map((line) => stroke(quiet, "thin", polyline(line))),
    ...(contact ? [tangentLine(scene, camera, contact)] : []),
    ...(contact && auxiliary && result.shape === "LN" ? [squareMark(scene, camera, contact, auxiliary)] : []),
    ...result.legs.flatMap(({ segment, feed: at }) => {
      const rapid = at === "before" && scene.rapidBefore;
      return [
        stroke(rapid ? quiet : feed, rapid ? "rapid" : "path", path([segment])),
        ...legArrow(rapid ? quiet : feed, segment, camera),
      ];
    }),
  ];
  const middle = { x: size.width / 2, y: size.height / 2 };
  const lit = (p: ShownPoint) =>
    (active === "X" || active === "Y" || active === "PR" || active === "PA") &&
    p.names.includes(result.departing ? "PN" : "PA");
  const items = [
    ...points
      .filter(({ names }) => names.length > 0)
      .map((p) => pointItem(p, scene.speech, middle, lit(p), !scene.small)),
    ...(scene.small ? [] : dimensionItems(result, camera, scene.speech, active)),
  ];
  const lines = [...along([...contour, ...scene.centre, ...result.legs.map((leg) => leg.segment)], 40)].map((p) =>
    onScreen(camera, p),
  );
  const kept = points.map((p) => ({ x: p.place.x - 7, y: p.place.y - 7, width: 14, height: 14 }));
  const placed = arrange(items, { ...size, avoid: scene.small ? [] : lines, kept });
  return {
    size,
    camera,
    points,
    labels: placed.map((p) => p.label),
    centre: result.arc && { at: result.arc.centre, place: onScreen(camera, result.arc.centre) },
    marks: [...marks, ...placed.flatMap((p) => p.marks())],
  };
}
