import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { boundsOf } from "./bounds.ts";

/** Numbers of an SVG `viewBox`, in part space with X up: x is z, y is −r, both mm. */
export type ViewBox = readonly [left: number, top: number, width: number, height: number];

/** A small picture of a part as its program makes it, with its blank. */
export interface Thumbnail {
  readonly box: ViewBox;
  readonly part: string;
  readonly blank: string;
  /** The path of a mill in the plane, if nothing is turned. */
  readonly plane?: string | undefined;
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
  readonly kind: string;
  readonly from: { readonly x: number; readonly y: number };
  readonly to: { readonly x: number; readonly y: number };
}

/** Margin around a milling path, as a share of its larger side. */
const AIR_OF_PLANE = 1 / 16;

/** The picture of a milling path seen from above, Y up; null where nothing is cut. */
export function planeThumbnailOf(plane: readonly PlaneMove[]): Thumbnail | null {
  const cut = plane.filter(({ kind }) => kind !== "rapid");
  const all = cut.flatMap(({ from, to }) => [from, to]);
  if (all.length === 0) return null;
  const [xs, ys] = [all.map(({ x }) => x), all.map(({ y }) => -y)];
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const [width, height] = [Math.max(...xs) - left, Math.max(...ys) - top];
  const air = Math.max(width, height) * AIR_OF_PLANE;
  const box: ViewBox = [left - air, top - air, width + 2 * air, height + 2 * air];
  const way = cut.map(({ from, to }) => `M${n(from.x)} ${n(-from.y)}L${n(to.x)} ${n(-to.y)}`).join("");
  return { box: box.map((v) => Number(n(v))) as unknown as ViewBox, part: "", blank: "", plane: way };
}
