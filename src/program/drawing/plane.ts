import { ROUND } from "../../kernel/tolerance.ts";
import { cross3, dot3, minus, size3, spanOf, unit3, type Curve3, type Placing, type V3 } from "./space.ts";

/** Deviation from a plane that a drawing may have, mm. */
const FLAT = 1e-3;
/** A line that leaves the plane by less than this share of its length was meant to lie in it. */
const NEARLY = 0.2;
/** Sine of the angle between directions that count as one, and cosine of one with an axis. */
const PARALLEL = 1e-6,
  UPRIGHT = 1 - PARALLEL;
/** Directions of curves from which planes are tried. */
const TRIED = 12;

const X: V3 = [1, 0, 0],
  Y: V3 = [0, 1, 0],
  Z: V3 = [0, 0, 1];

function depth(c: Curve3, normal: V3): number {
  const heights = spanOf(c).map((p) => dot3(p, normal));
  return heights.reduce((a, b) => Math.max(a, b), -Infinity) - heights.reduce((a, b) => Math.min(a, b), Infinity);
}
const extent = (c: Curve3): number => {
  const [first, ...rest] = spanOf(c);
  return first ? rest.reduce((far, p) => Math.max(far, size3(minus(p, first))), 0) : 0;
};

/** Normals of the planes that two directions of the curves span. */
function spanned(curves: readonly Curve3[]): V3[] {
  const ways: V3[] = [];
  for (const c of curves) {
    const [first, ...rest] = spanOf(c);
    for (const p of rest) {
      const way = first && unit3(minus(p, first));
      if (way && ways.length < TRIED && ways.every((w) => size3(cross3(w, way)) > PARALLEL)) ways.push(way);
    }
    if (ways.length >= TRIED) break;
  }
  return ways.slice(1).flatMap((way) => {
    const normal = unit3(cross3(ways[0] ?? X, way));
    return normal ? [normal] : [];
  });
}

/** How a drawing is looked at: a map that puts its plane into xy, the name of the plane, and who lies outside of it. */
export interface View {
  readonly placing: Placing;
  readonly plane: "xy" | "xz" | "yz" | "oblique";
  readonly isOutside: (c: Curve3) => boolean;
}

/**
 * The plane in which most curves of a drawing lie, xy before others; its first axis is x, or y in a plane across x,
 * its second axis y or z. Curves in parallel planes are seen as one.
 */
export function viewOf(curves: readonly Curve3[]): View {
  const count = (normal: V3) => curves.filter((c) => depth(c, normal) <= FLAT).length;
  let best = { normal: Z, count: count(Z) };
  if (best.count < curves.length)
    for (const normal of [Y, X, ...spanned(curves)]) {
      const lie = count(normal);
      if (lie > best.count) best = { normal, count: lie };
    }
  const n = best.normal,
    isLevel = Math.abs(n[2]) > UPRIGHT,
    up = isLevel ? Y : (unit3(minus(Z, [n[0] * n[2], n[1] * n[2], n[2] * n[2]])) ?? Z),
    side = isLevel ? X : cross3(up, n),
    forward = side[0] < -ROUND || (Math.abs(side[0]) <= ROUND && side[1] < 0) ? -1 : 1;
  const right: V3 = [side[0] * forward, side[1] * forward, side[2] * forward];
  const row = (i: 0 | 1 | 2): V3 => [right[i], up[i], n[i]];
  const across = Math.abs(n[1]) > UPRIGHT ? "xz" : Math.abs(n[0]) > UPRIGHT ? "yz" : "oblique";
  return {
    placing: { x: row(0), y: row(1), z: row(2), origin: [0, 0, 0] },
    plane: isLevel ? "xy" : across,
    isOutside: (c) => {
      const deep = depth(c, n);
      return deep > FLAT && deep > NEARLY * extent(c);
    },
  };
}
