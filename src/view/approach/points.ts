import type { Approach, PointName } from "../../kernel/plane/approach.ts";
import { plane, type PlanePoint } from "../../kernel/plane/plane.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Camera, Place } from "../camera.ts";
import { SIZE, textWidth, type LabelBox, type StraightLine } from "../dimensions/labels.ts";
import { polyline, type Mark } from "../help/marks.ts";
import { stroke, type Candidate, type HelpItem, type Tag } from "../help/stroke.ts";
import { onScreen } from "./frame.ts";
import type { ApproachWords } from "./words.ts";

/**
 * A point in the picture. Points that fall together share one. PA and PE are points of the contour; the tool centre
 * there has no name.
 */
export interface ShownPoint {
  readonly names: readonly PointName[];
  readonly at: PlanePoint;
  readonly place: Place;
  /** A point of the contour; else of the path of the tool centre. */
  readonly onContour: boolean;
}

/** An approach or departure whose points are shown. */
export interface PointsOf extends Pick<Approach, "points" | "departing"> {
  /** Its first or last point of the contour; null shows the tool centre in its place. */
  readonly contact: PlanePoint | null;
}

const ORDER: readonly PointName[] = ["PS", "PH", "PA", "PE", "PN"];

/** The points of approaches in the order of travel. */
export function shownPoints(all: readonly PointsOf[], camera: Camera): readonly ShownPoint[] {
  const shown: { names: PointName[]; at: PlanePoint; place: Place; onContour: boolean }[] = [];
  const add = (name: PointName | null, at: PlanePoint, onContour: boolean) => {
    const same = shown.find((each) => plane.apart(each.at, at) <= SAME);
    const names = name === null ? [] : [name];
    if (!same) shown.push({ names, at, place: onScreen(camera, at), onContour });
    else if (name !== null && !same.names.includes(name)) same.names.push(name);
  };
  for (const { points, departing, contact } of all)
    for (const name of departing ? (["PE", "PH", "PN"] as const) : ORDER) {
      const at = points[name],
        isContact = name === (departing ? "PE" : "PA");
      if (!at) continue;
      const isApart = isContact && contact !== null && plane.apart(at, contact) > SAME;
      if (isApart) add(name, contact, true);
      add(isApart ? null : name, at, false);
    }
  return shown;
}

/** The lines from points of the contour to the tool centre there. */
export const contactLines = (all: readonly PointsOf[], camera: Camera): readonly (readonly [Place, Place])[] =>
  all.flatMap(({ points, departing, contact }) => {
    const centre = points[departing ? "PE" : "PA"];
    return centre && contact && plane.apart(centre, contact) > SAME
      ? [[onScreen(camera, contact), onScreen(camera, centre)] as const]
      : [];
  });

/** The coordinates of a point in words. */
export const pointText = ({ at, onContour }: ShownPoint, speech: ApproachWords): string =>
  onContour ? speech.contour(at) : speech.point(at);

const LINE = 15;
/** Distances from a point to its text, pixels; a farther text has a leader. */
const RINGS = [13, 32, 56, 84, 116] as const;
/** Where a leader begins, and where it ends for other texts, from its point and from its text; pixels. */
const LEADER = { from: 13, short: 1.5 } as const;

/** The leader from a point to its text. */
function leader(tag: Tag, from: Place, label: LabelBox): { readonly mark: Mark; readonly line: StraightLine } {
  const to = {
    x: Math.max(label.x, Math.min(from.x, label.x + label.width)),
    y: Math.max(label.y, Math.min(from.y, label.y + label.height)),
  };
  const far = Math.hypot(to.x - from.x, to.y - from.y) || 1;
  const at = (s: number): Place => ({
    x: from.x + ((to.x - from.x) * s) / far,
    y: from.y + ((to.y - from.y) * s) / far,
  });
  const begin = at(Math.min(far, LEADER.from));
  return {
    mark: stroke(tag, "thin", polyline([begin, to])),
    line: [begin, at(Math.max(LEADER.from, far - LEADER.short))],
  };
}

/** The text beside a point: candidate places in eight directions, those away from the middle of the picture first. */
export function pointItem(
  p: ShownPoint,
  speech: ApproachWords,
  middle: Place,
  active: boolean,
  coordinates: boolean,
): HelpItem {
  const name = p.names.join(" = ");
  const where = coordinates ? pointText(p, speech) : "";
  const width = Math.max(textWidth(name, SIZE.strong), textWidth(where, SIZE.quiet)) + 6;
  const height = coordinates ? LINE * 2 : LINE + 2;
  const out = Math.atan2(p.place.y - middle.y, p.place.x - middle.x);
  const candidates = RINGS.flatMap((gap, ring) =>
    [0, 1, 2, 3, 4, 5, 6, 7].map((eighth): Candidate => {
      const angle = (eighth * Math.PI) / 4;
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      const centre = { x: p.place.x + cos * (gap + width / 2), y: p.place.y + sin * (gap + height / 2) };
      const tag = { q: p.names[0] ?? null, active };
      const text = (line: number, words: string, size: number): Mark => ({
        ...tag,
        kind: "text",
        place: { x: centre.x, y: centre.y + (coordinates ? line * LINE - LINE / 2 : 0) },
        text: words,
        size,
        turn: 0,
        underlined: false,
        role: "value",
      });
      const label = { x: centre.x - width / 2, y: centre.y - height / 2, width, height },
        led = ring > 0 ? leader(tag, p.place, label) : null;
      return {
        marks: () => [
          ...(led ? [led.mark] : []),
          text(0, name, SIZE.strong),
          ...(coordinates ? [text(1, where, SIZE.quiet)] : []),
        ],
        label,
        lines: led ? [led.line] : [],
        cost: (1 - Math.cos(angle - out)) * 2 + (eighth % 2) * 0.3 + ring * 3,
      };
    }),
  );
  return { q: name, candidates };
}
