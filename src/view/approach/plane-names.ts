import type { NamedPoints, PointName } from "../../kernel/plane/approach.ts";
import { plane, type PlanePoint } from "../../kernel/plane/plane.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Camera, Size } from "../camera.ts";
import { arrange } from "../help/labels.ts";
import type { Mark } from "../help/marks.ts";
import { onScreen } from "./frame.ts";
import { pointItem, type ShownPoint } from "./points.ts";
import type { ApproachWords } from "./words.ts";

/** With more approaches than this, names have no coordinates. */
const FEW = 3;
/** Limit of named points. */
const MOST = 40;
/** A name farther from its point than this is left out: the list below the picture has it. */
const FAR = 4;
const ORDER: readonly PointName[] = ["PS", "PH", "PA", "PE", "PN"];

/** A named point with the texts beside it. */
export interface NamedPlace extends ShownPoint {
  readonly marks: readonly Mark[];
}

/** The named points of a whole program, each place once, with texts that cover neither each other nor a point. */
export function planeNames(
  approaches: readonly { readonly points: NamedPoints; readonly departing: boolean }[],
  camera: Camera,
  size: Size,
  speech: ApproachWords,
): readonly NamedPlace[] {
  const shown: { names: PointName[]; at: PlanePoint }[] = [];
  for (const { points, departing } of approaches) {
    for (const name of departing ? (["PE", "PH", "PN"] as const) : ORDER) {
      const at = points[name];
      if (!at) continue;
      const same = shown.find((each) => plane.apart(each.at, at) <= SAME);
      if (!same) shown.push({ names: [name], at });
      else if (!same.names.includes(name)) same.names.push(name);
    }
  }
  const points = shown
    .map((p): ShownPoint => ({ ...p, place: onScreen(camera, p.at) }))
    .filter(({ place }) => place.x > 0 && place.y > 0 && place.x < size.width && place.y < size.height);
  const few = approaches.length <= FEW && size.width > 420;
  const middle = { x: size.width / 2, y: size.height / 2 };
  const kept = [
    { x: 0, y: 0, width: 48, height: size.height },
    { x: 0, y: size.height - 24, width: size.width, height: 24 },
    ...points.map((p) => ({ x: p.place.x - 6, y: p.place.y - 6, width: 12, height: 12 })),
  ];
  const items = points.slice(0, MOST).map((p) => ({ ...pointItem(p, speech, middle, false, few), most: FAR }));
  const placed = new Map(arrange(items, { ...size, avoid: [], kept }).map(({ item, marks }) => [item, marks]));
  return points.map((point, i) => ({ ...point, marks: (items[i] && placed.get(items[i])) ?? [] }));
}
