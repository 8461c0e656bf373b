import { plane } from "../../kernel/plane/plane.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Camera, Place, Size } from "../camera.ts";
import { arrange } from "../dimensions/arrange.ts";
import type { LabelBox } from "../dimensions/labels.ts";
import type { Mark } from "../help/marks.ts";
import { onScreen } from "./frame.ts";
import { contactLines, pointItem, shownPoints, type PointsOf, type ShownPoint } from "./points.ts";
import type { ApproachWords } from "./words.ts";

/** With more approaches than this, names have no coordinates. */
const FEW = 3;
/** Limit of named points. */
const MOST = 40;
/** A name that costs more is left out: the list below the picture has it. */
const FAR = 17;

/** A named point with the texts beside it. */
export interface NamedPlace extends ShownPoint {
  /** Belongs to a named approach. */
  readonly isNamed: boolean;
  readonly marks: readonly Mark[];
}

/** Distance of the places along a line that texts should rather not cover, pixels; most of them round a tool. */
const [APART, MOST_ROUND] = [6, 200];

/** Places along the straight ways between the points of approaches, and from the contour to the tool centre. */
function alongWays(approaches: readonly PointsOf[], camera: Camera): readonly Place[] {
  const ways = approaches.flatMap(({ points, departing }) => {
    const places = shownPoints([{ points, departing, contact: null }], camera).map(({ place }) => place);
    return places.slice(1).map((to, i) => [places[i] ?? to, to] as const);
  });
  return [...ways, ...contactLines(approaches, camera)].flatMap(([from, to]) => {
    const count = Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / APART);
    return Array.from({ length: count }, (_, i) => ({
      x: from.x + ((to.x - from.x) * i) / count,
      y: from.y + ((to.y - from.y) * i) / count,
    }));
  });
}

/** An approach with the radius of its tool. */
export interface NamedApproach extends PointsOf {
  readonly isNamed: boolean;
  /** mm; none is drawn where it is left out. */
  readonly toolRadius?: number;
}

/** Places round the tool where it waits before an approach, or ends after a departure: it is drawn there at rest. */
const roundTools = (approaches: readonly NamedApproach[], camera: Camera): readonly Place[] =>
  approaches.flatMap(({ points, departing, toolRadius = 0 }) => {
    const at = points[departing ? "PN" : "PS"],
      r = toolRadius * camera.scale;
    if (!at || r < APART) return [];
    const middle = onScreen(camera, at);
    const count = Math.min(MOST_ROUND, Math.ceil((2 * Math.PI * r) / APART));
    return Array.from({ length: count }, (_, i) => {
      const angle = (2 * Math.PI * i) / count;
      return { x: middle.x + r * Math.cos(angle), y: middle.y + r * Math.sin(angle) };
    });
  });

/**
 * The points of approaches, each place once. Those of named approaches have texts that cover neither each other nor a
 * point, nor the `taken` areas of other marks.
 */
export function planeNames(
  approaches: readonly NamedApproach[],
  camera: Camera,
  size: Size,
  speech: ApproachWords,
  taken: readonly LabelBox[] = [],
): readonly NamedPlace[] {
  const own = approaches.filter(({ isNamed }) => isNamed),
    named = shownPoints(own, camera);
  const others = shownPoints(approaches, camera)
    .filter(({ at }) => !named.some((each) => plane.apart(each.at, at) <= SAME))
    .map((each): ShownPoint => ({ ...each, names: [] }));
  const all = [
    ...named.map((each) => ({ ...each, isNamed: true })),
    ...others.map((each) => ({ ...each, isNamed: false })),
  ];
  const points = all.filter(({ place }) => place.x > 0 && place.y > 0 && place.x < size.width && place.y < size.height);
  const few = own.length <= FEW && size.width > 420;
  const middle = { x: size.width / 2, y: size.height / 2 };
  const kept = [
    { x: 0, y: 0, width: 48, height: size.height },
    { x: 0, y: size.height - 24, width: size.width, height: 24 },
    ...points.map((p) => ({ x: p.place.x - 6, y: p.place.y - 6, width: 12, height: 12 })),
    ...taken,
  ];
  const items = new Map(
    points
      .filter(({ names }) => names.length > 0)
      .slice(0, MOST)
      .map((p) => [p, { ...pointItem(p, speech, middle, false, few), most: FAR }]),
  );
  const placed = new Map(
    arrange([...items.values()], {
      ...size,
      avoid: [...alongWays(approaches, camera), ...roundTools(own, camera)],
      kept,
    }).map(({ item, marks }) => [item, marks()]),
  );
  return points.map((point) => {
    const item = items.get(point);
    return { ...point, marks: (item && placed.get(item)) ?? [] };
  });
}
