import { at, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { JOINED, ROUND } from "../../kernel/tolerance.ts";

/** Mapping of the drawing plane to Z and X of a part. */
export interface DxfPlacing {
  /** Drawing x is X and drawing y is Z; otherwise x is Z and y is X. */
  readonly swapped: boolean;
  /** Z is reversed against the drawing. */
  readonly flipped: boolean;
  /** X of the drawing is a diameter; otherwise a radius. */
  readonly diameters: boolean;
  /** Z0 is at the right end of the imported contour; otherwise as in the drawing. */
  readonly zeroRight: boolean;
}

/** A line or arc of the drawing, x as z and y as r until it is placed. */
export type DxfCurve = Segment;

/** Curves of a drawing, and the counts of other kinds of entities. */
export interface DxfCurves {
  readonly curves: readonly DxfCurve[];
  readonly skipped: ReadonlyMap<string, number>;
  /** Entities with missing or invalid numbers. */
  readonly broken: number;
}

type Fields = Readonly<Record<string, unknown>>;
const isFields = (v: unknown): v is Fields => typeof v === "object" && v !== null;
const number = (v: unknown): number | null =>
  typeof v === "number" && Number.isFinite(v) && Math.abs(v) < 1e6 ? v : null;

function point(v: unknown): Pt | null {
  if (!isFields(v)) return null;
  const [x, y] = [number(v["x"]), number(v["y"])];
  return x === null || y === null ? null : at(x, y);
}

const apart = (a: Pt, b: Pt) => Math.hypot(a.z - b.z, a.r - b.r);
/** Entities drawn on the back of the plane have their x mirrored. */
const seenFromBehind = (e: Fields) => {
  const direction = isFields(e["extrusionDirection"]) ? e["extrusionDirection"]["z"] : e["extrusionDirectionZ"];
  return (number(direction) ?? 1) < 0;
};
const mirrored = (s: DxfCurve): DxfCurve => {
  const turn = (p: Pt) => at(-p.z, p.r);
  return s.kind === "line"
    ? { kind: "line", from: turn(s.from), to: turn(s.to) }
    : { kind: "arc", from: turn(s.from), to: turn(s.to), centre: turn(s.centre), turn: s.turn === "cw" ? "ccw" : "cw" };
};

/** A side of a polyline: its bulge is the tangent of a quarter of the angle it turns through, positive to the left. */
export function bulged(from: Pt, to: Pt, bulge: number): DxfCurve {
  if (Math.abs(bulge) < ROUND) return { kind: "line", from, to };
  const k = (1 - bulge * bulge) / (4 * bulge),
    [dz, dr] = [to.z - from.z, to.r - from.r];
  return {
    kind: "arc",
    from,
    to,
    centre: at((from.z + to.z) / 2 - dr * k, (from.r + to.r) / 2 + dz * k),
    turn: bulge > 0 ? "ccw" : "cw",
  };
}

/** Curves of one entity; null for missing numbers, undefined for neither line nor arc. */
function curvesOf(e: Fields): DxfCurve[] | null | undefined {
  const vertices: readonly unknown[] = Array.isArray(e["vertices"]) ? e["vertices"] : [];
  switch (e["type"]) {
    case "LINE": {
      const [from, to] = [point(vertices[0]), point(vertices[1])];
      return from && to && [{ kind: "line", from, to }];
    }
    case "ARC": {
      const [centre, size, start, end] = [
        point(e["center"]),
        number(e["radius"]),
        number(e["startAngle"]),
        number(e["endAngle"]),
      ];
      if (!centre || size === null || size <= 0 || start === null || end === null) return null;
      const on = (a: number) => at(centre.z + size * Math.cos(a), centre.r + size * Math.sin(a));
      return [{ kind: "arc", from: on(start), to: on(end), centre, turn: "ccw" }];
    }
    case "LWPOLYLINE":
    case "POLYLINE": {
      const points = vertices.map(point);
      if (points.length < 2 || points.some((p) => p === null)) return null;
      const closed = e["shape"] === true;
      return points.flatMap((from, i) => {
        const to = points[i + 1] ?? (closed && points.length > 2 ? points[0] : null),
          v = vertices[i];
        return from && to ? [bulged(from, to, (isFields(v) ? number(v["bulge"]) : null) ?? 0)] : [];
      });
    }
    default:
      return undefined;
  }
}

/** Extracts lines, arcs and polylines from a parsed drawing; `scale`: mm per drawing unit. */
export function dxfCurves(entities: readonly unknown[], scale: number): DxfCurves {
  const skipped = new Map<string, number>();
  let broken = 0;
  const sized = (p: Pt) => at(p.z * scale, p.r * scale);
  const curves = entities.flatMap((e): DxfCurve[] => {
    if (!isFields(e)) return [];
    const made = curvesOf(e),
      kind = String(e["type"]);
    if (made === undefined) skipped.set(kind, (skipped.get(kind) ?? 0) + 1);
    if (made === null) broken += 1;
    return (made ?? [])
      .map((s) => (seenFromBehind(e) ? mirrored(s) : s))
      .map((s) =>
        s.kind === "line"
          ? { ...s, from: sized(s.from), to: sized(s.to) }
          : { ...s, from: sized(s.from), to: sized(s.to), centre: sized(s.centre) },
      );
  });
  return { curves: curves.filter((s) => s.kind === "arc" || apart(s.from, s.to) > JOINED), skipped, broken };
}
