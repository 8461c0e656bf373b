import { writeHead } from "../tools/holder-cells.ts";
import type { HolderCell } from "../tools/tool-columns.ts";
import type { Hand } from "./code-part.ts";
import type { HolderCode } from "./holder-code.ts";
import { BAR_REACH, SHANK_REACH } from "./holder-facts.ts";

/** Insert in a holder: setting angle and included angle in degrees, edge and corner radius in mm. */
export interface HeldInsert {
  readonly setting: number;
  readonly angle: number;
  readonly edge: number;
  readonly corner: number;
}

/** Cells of a holder; an empty text empties the cell. */
export type HolderCells = Readonly<Record<HolderCell, string>>;

type Point = readonly [z: number, x: number];

/** Distance of a head behind the edges, mm, and its relief further on, degrees. */
const INSET = 1;
const RELIEF = 3;
/** Share of each edge on the seat. */
const SEATED = 0.7;
/** Smallest head length as a share of the shank, along the shank. */
const HEAD_OF_SHANK = 1.2;
const HEAD_OF_BAR = 0.8;
/** Chamfer on the far front corner of a bar, as a share of its diameter. */
const BROKEN = 0.3;
const HALF = 1 / 2;

const heading = (angle: number): Point => {
  const turn = (angle * Math.PI) / 180;
  return [-Math.cos(turn), Math.sin(turn)];
};
const along = (from: Point, to: Point, by: number): Point => [from[0] + to[0] * by, from[1] + to[1] * by];
/** Coordinate of a line through a point at a given z, or x. */
const xAt = (from: Point, way: Point, z: number) => from[1] + ((z - from[0]) * way[1]) / way[0];
const zAt = (from: Point, way: Point, x: number) => from[0] + ((x - from[1]) * way[0]) / way[1];

/**
 * Seat corners under the two edges of an insert of tip orientation 1, from its theoretical tip, and the directions of
 * the head behind them.
 */
function seatOf({ setting, angle, edge, corner }: HeldInsert) {
  const [main, second] = [heading(setting), heading(setting + angle)];
  const in_ = (INSET + corner * HALF) / Math.sin((angle * Math.PI) / 180);
  const root = along(along([0, 0], main, in_), second, in_);
  const reach = Math.max(edge * SEATED, INSET);
  return {
    root,
    onMain: along(root, main, reach),
    onSecond: along(root, second, reach),
    behindMain: heading(setting + RELIEF),
    behindSecond: heading(setting + angle - RELIEF),
  };
}

const tenths = (n: number) => Math.round(n * 10) / 10 + 0;

function cellsOf(
  head: readonly Point[],
  flip: Point,
  shank: { readonly z: number; readonly x: number; readonly across: number; readonly length: number },
): HolderCells {
  const turned = ([z, x]: Point): Point => [tenths(z * flip[0]), tenths(x * flip[1])];
  const [z, x] = turned([shank.z, shank.x]);
  return {
    width: String(shank.across),
    length: String(tenths(shank.length)),
    offsetZ: String(z),
    offsetX: String(x),
    axis: "",
    head: writeHead([head.map(turned)] as unknown as Parameters<typeof writeHead>[0]),
  };
}

/** A shank across the spindle, with the tip beyond one side. */
function offsetShank(insert: HeldInsert, across: number, reach: number, long: number, hand: Hand): HolderCells {
  const { root, onMain, onSecond, behindMain, behindSecond } = seatOf(insert);
  const far = xAt(onSecond, behindSecond, reach);
  const end = Math.ceil(Math.max(far, across * HEAD_OF_SHANK, onMain[1] + INSET));
  const near = reach - across;
  const head: Point[] = [
    root,
    onSecond,
    [reach, far],
    ...(end - far > INSET ? [[reach, end] as Point] : []),
    [Math.max(near, zAt(onMain, behindMain, end)), end],
    onMain,
  ];
  return cellsOf(head, [hand === "L" ? -1 : 1, 1], { z: near, x: end, across, length: long - end });
}

/** A shank across the spindle with the tip over its middle. */
function middleShank(insert: HeldInsert, across: number, long: number): HolderCells {
  const { root, onMain, onSecond, behindMain, behindSecond } = seatOf(insert);
  const side = across * HALF;
  const [right, left] = [xAt(onSecond, behindSecond, side), xAt(onMain, behindMain, -side)];
  const end = Math.ceil(Math.max(right, left, across));
  const head: Point[] = [root, onSecond, [side, right], [side, end], [-side, end], [-side, left], onMain];
  return cellsOf(
    head.filter(([z, x], i) => !(i > 0 && head[i - 1]?.[0] === z && head[i - 1]?.[1] === x)),
    [1, 1],
    {
      z: -side,
      x: end,
      across,
      length: long - end,
    },
  );
}

/** A round insert over the middle of a shank: a neck narrower than the insert, then the shank. */
function roundShank(diameter: number, across: number, long: number): HolderCells {
  const [neck, side, end] = [diameter * SEATED * HALF, across * HALF, Math.ceil(Math.max(across, diameter * 1.5))];
  const top = end - (side - neck);
  const cells = cellsOf([], [1, 1], { z: -side, x: end, across, length: long - end });
  const necked: Point[] = [
    [-neck, diameter * HALF],
    [neck, diameter * HALF],
    [neck, top],
    [-neck, top],
  ];
  const shoulders: Point[] = [
    [-neck, top],
    [neck, top],
    [side, end],
    [-side, end],
  ];
  const parts = [necked, shoulders].map((part) => part.map(([z, x]): Point => [tenths(z), tenths(x)]));
  return { ...cells, head: writeHead(parts as unknown as Parameters<typeof writeHead>[0]) };
}

/** A bar along the spindle whose tip points to +X. */
function barShank(insert: HeldInsert, across: number, reach: number, long: number): HolderCells {
  const { root, onMain, onSecond, behindMain, behindSecond } = seatOf(insert);
  const [near, far] = [reach - across * HALF, reach + across * HALF];
  const end = Math.ceil(Math.max(onSecond[0] + INSET, across * HEAD_OF_BAR));
  const broken = far - across * BROKEN;
  const front = (x: number) => Math.min(Math.max(zAt(onMain, behindMain, x), onMain[0]), end - INSET);
  const head: Point[] = [
    root,
    onSecond,
    [end, Math.max(near, xAt(onSecond, behindSecond, end))],
    [end, far],
    [Math.min(front(far) + across * BROKEN, end - INSET), far],
    ...(broken > onMain[1] ? [[front(broken), broken] as Point] : []),
    onMain,
  ];
  return cellsOf(head, [1, -1], { z: end, x: near, across, length: long - end });
}

/** Why the position of a shank does not follow from its holder code. */
export type NoShank = "incomplete" | "seat" | "reach" | "round";

/**
 * Shank and head of a holder code: sizes and tip position from the standards, head outline drawn behind the insert
 * edges. mm; corners from the theoretical tip.
 */
export function holderCellsOf(
  holder: HolderCode,
  insert: HeldInsert | null,
  diameter: number | null,
): HolderCells | NoShank {
  const { across, length, style, hand, kind } = holder;
  if (across === null || length === null || !style || !hand) return "incomplete";
  const round = holder.shape === "R";
  if (kind === "bar") {
    const reach = BAR_REACH[across];
    if (round || style.cuts === "side") return round ? "round" : "seat";
    if (reach === undefined) return "reach";
    return insert ? barShank(insert, across, reach, length) : "incomplete";
  }
  if (round) return style.seat === "middle" && diameter !== null ? roundShank(diameter, across, length) : "round";
  if (!insert) return "incomplete";
  if (style.seat === "middle") return hand === "N" ? middleShank(insert, across, length) : "seat";
  const reach = SHANK_REACH[across];
  if (style.seat !== "offset" || style.cuts === "end" || style.angle < 90 || hand === "N") return "seat";
  return reach === undefined ? "reach" : offsetShank(insert, across, reach, length, hand);
}
