import type { Approach, PointName } from "../../kernel/plane/approach.ts";
import { plane, type PlanePoint } from "../../kernel/plane/plane.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Camera, Place } from "../camera.ts";
import { SIZE, textWidth, type Candidate, type Item } from "../help/labels.ts";
import type { Mark } from "../help/marks.ts";
import { onScreen } from "./frame.ts";
import type { ApproachWords } from "./words.ts";

/** A named point in the picture. Points that fall together share one. */
export interface ShownPoint {
  readonly names: readonly PointName[];
  readonly at: PlanePoint;
  readonly place: Place;
}

const ORDER: readonly PointName[] = ["PS", "PH", "PA", "PE", "PN"];

/** The points of an approach in the order of travel. */
export function shownPoints(result: Approach, camera: Camera): readonly ShownPoint[] {
  const order = result.departing ? (["PE", "PH", "PN"] as const) : ORDER;
  const shown: { names: PointName[]; at: PlanePoint; place: Place }[] = [];
  for (const name of order) {
    const at = result.points[name];
    if (!at) continue;
    const same = shown.find((each) => plane.apart(each.at, at) <= SAME);
    if (same) same.names.push(name);
    else shown.push({ names: [name], at, place: onScreen(camera, at) });
  }
  return shown;
}

const LINE = 15;
/** Distance from a point to its text, pixels. */
const AWAY = 13;

/** The text beside a point, with eight candidate places; those away from the middle of the picture first. */
export function pointItem(
  p: ShownPoint,
  speech: ApproachWords,
  middle: Place,
  active: boolean,
  coordinates: boolean,
): Item {
  const name = p.names.join(" = ");
  const where = coordinates ? speech.point(p.at) : "";
  const width = Math.max(textWidth(name, SIZE.strong), textWidth(where, SIZE.quiet)) + 6;
  const height = coordinates ? LINE * 2 : LINE + 2;
  const out = Math.atan2(p.place.y - middle.y, p.place.x - middle.x);
  const candidates = [1, 2].flatMap((ring) =>
    [0, 1, 2, 3, 4, 5, 6, 7].map((eighth): Candidate => {
      const angle = (eighth * Math.PI) / 4;
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      const gap = AWAY * ring * ring;
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
      const marks: Mark[] = [text(0, name, SIZE.strong), ...(coordinates ? [text(1, where, SIZE.quiet)] : [])];
      const label = { x: centre.x - width / 2, y: centre.y - height / 2, width, height };
      return { marks, label, lines: [], cost: (1 - Math.cos(angle - out)) * 2 + (eighth % 2) * 0.3 + (ring - 1) * 4 };
    }),
  );
  return { q: name, candidates };
}
