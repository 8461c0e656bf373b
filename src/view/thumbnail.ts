import type { Cuboid } from "../kernel/area/box.ts";
import type { Pt, Ring, Turn } from "../kernel/geometry/point.ts";
import { plane, type PlanePoint } from "../kernel/plane/plane.ts";
import { boundsOf } from "./bounds.ts";

/** Numbers of an SVG `viewBox`, in part space with X up: x is z, y is −r, both mm. */
export type ViewBox = readonly [left: number, top: number, width: number, height: number];

/** A small picture of a part as its program makes it, with its blank. */
export interface Thumbnail {
  readonly box: ViewBox;
  readonly part: string;
  readonly blank: string;
  /** A milled part seen from above, if nothing is turned. */
  readonly milled?: MilledPlan | undefined;
}

/** A milled part seen from above: its stock, null if not stated, and the ways of tools with their ⌀, mm. */
export interface MilledPlan {
  readonly stock: ViewBox | null;
  readonly ways: readonly { readonly d: string; readonly wide: number }[];
}

/** Points closer together than this share of the picture's width are merged. */
const FINE = 1 / 400;
/** Margin round the part, as a share of the picture's width. */
const AIR = 0.03;

const n = (v: number) => String(Math.round(v * 100) / 100 + 0);
/** A place in such a picture, as path data. */
export const thumbPlace = (p: Pt): string => `${n(p.z)} ${n(-p.r)}`;

/** A ring without the points that are too fine for a small picture. */
function coarse(ring: Ring, fine: number): Ring {
  const kept: Pt[] = [];
  for (const p of ring) {
    const last = kept.at(-1);
    if (!last || Math.hypot(p.z - last.z, p.r - last.r) >= fine) kept.push(p);
  }
  return kept;
}

/** Rings as one path, no finer than `fine` mm. */
export const thumbRings = (rings: readonly Ring[], fine: number): string =>
  rings
    .map((ring) => coarse(ring, fine))
    .filter((ring) => ring.length > 2)
    .map((ring) => `M${ring.map(thumbPlace).join("L")}Z`)
    .join("");

/** The box of a part drawn on both sides of its axis. */
export function thumbBox(points: readonly Pt[]): ViewBox {
  const box = boundsOf(points) ?? { left: -1, right: 0, low: 0, high: 1 };
  const air = AIR * Math.max(box.right - box.left, box.high);
  const half = box.high + air;
  const [left, width] = [box.left - air, box.right - box.left + 2 * air];
  return [Number(n(left)), Number(n(-half)), Number(n(width)), Number(n(half + half))];
}

/** The picture of a part; null where there is none. */
export function thumbnailOf(blank: readonly Ring[], part: readonly Ring[]): Thumbnail | null {
  if (part.length === 0) return null;
  const box = thumbBox([...blank, ...part].flat());
  const fine = box[2] * FINE;
  return { box, part: thumbRings(part, fine), blank: thumbRings(blank, fine) };
}

/** A move of a mill. */
interface PlaneMove {
  readonly kind: "rapid" | "feed" | "arc" | "thread";
  readonly from: PlanePoint & { readonly z: number | null };
  readonly to: PlanePoint & { readonly z: number | null };
  readonly centre?: PlanePoint;
  readonly turn?: Turn;
  readonly radius: number;
}

/** Margin around a milled part, as a share of its larger side. */
const AIR_OF_PLANE = 1 / 16;

/** A box from its sides, Y up. */
const viewBox = (left: number, low: number, right: number, high: number): ViewBox => [
  Number(n(left)),
  Number(n(-high)),
  Number(n(right - left)),
  Number(n(high - low)),
];

/** Whether a move is in the stock; without stock, each feed is. */
const isIn = (stock: Cuboid | null, { kind, from, to }: PlaneMove) =>
  kind !== "rapid" && (!stock || Math.min(from.z ?? Infinity, to.z ?? Infinity) < stock.top);

/** Most moves of a tool that a small picture draws; more would fill it. */
const MOST_WAYS = 10_000;

/** The sides of the moves' ends, X to the right and Y up. */
function around(moves: readonly PlaneMove[]): Pick<Cuboid, "left" | "low" | "right" | "high"> {
  let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { from, to } of moves) {
    left = Math.min(left, from.x, to.x);
    low = Math.min(low, from.y, to.y);
    right = Math.max(right, from.x, to.x);
    high = Math.max(high, from.y, to.y);
  }
  return { left, low, right, high };
}

/** The picture of a milled part seen from above, Y up; null where nothing is milled. */
export function planeThumbnailOf(moves: readonly PlaneMove[], stock: Cuboid | null = null): Thumbnail | null {
  const cut = moves.filter((move) => isIn(stock, move));
  if (cut.length === 0) return null;
  const { left, low, right, high } = stock ?? around(cut);
  const air = Math.max(right - left, high - low) * AIR_OF_PLANE,
    box = viewBox(left - air, low - air, right + air, high + air);
  const fine = box[2] * FINE;
  const cell = ({ x, y }: PlanePoint) => `${Math.round(x / fine)} ${Math.round(y / fine)}`;
  const ways = new Map<number, { d: string; readonly drawn: Set<string> }>();
  for (const { from, to, centre, turn, radius } of cut) {
    const way = ways.get(2 * radius) ?? { d: "", drawn: new Set() };
    ways.set(2 * radius, way);
    const key = `${cell(from)} ${cell(to)} ${turn ?? ""}`;
    // Long programs pass the same places many times.
    if (way.drawn.has(key) || way.drawn.size === MOST_WAYS) continue;
    way.drawn.add(key);
    const path =
      centre && turn ? ({ kind: "arc", from, to, centre, turn } as const) : ({ kind: "line", from, to } as const);
    way.d += `M${plane
      .flattened(path, fine)
      .map(({ x, y }) => `${n(x)} ${n(-y)}`)
      .join("L")}`;
  }
  return {
    box,
    part: "",
    blank: "",
    milled: {
      stock: stock && viewBox(left, low, right, high),
      ways: [...ways].map(([wide, { d }]) => ({ d, wide: Number(n(wide)) })),
    },
  };
}
