import { signOf, type Turn } from "../geometry/segments.ts";
import { plane, type PlanePoint } from "../plane/plane.ts";
import type { Curve, FreeElement, FromPole, FreeValue } from "./element.ts";
import type { Residuals } from "./least-squares.ts";

const { apart, cross, difference, dot, scaled, sum, angleOf, heading } = plane;

/**
 * Known geometry of a contour being solved: the curve of each element and the point at its end; 0 is the element before
 * the contour.
 */
export interface KnownGeometry {
  readonly curves: readonly (Curve | null)[];
  readonly points: readonly (PlanePoint | null)[];
}

/** Curves and points of some neighbouring elements; null outside the window. */
export interface FreePlaces {
  readonly curve: (k: number) => Curve | null;
  readonly point: (k: number) => PlanePoint | null;
}

/** Some neighbouring elements as equations. */
export interface Window {
  readonly first: number;
  readonly last: number;
  /**
   * Kind of each unknown: an angle, a distance to the left or right, a radius, or a coordinate in the first or second
   * axis.
   */
  readonly unknowns: readonly ("angle" | "offset" | "radius" | "x" | "y")[];
  readonly residuals: Residuals;
  readonly read: (at: readonly number[]) => FreePlaces;
}

/** The unit vector to the left of a direction. */
const leftOf = (angle: number): PlanePoint => ({ x: -Math.sin(angle), y: Math.cos(angle) });
type Arc = Extract<Curve, { kind: "arc" }>;
const reach = ({ radius, turn }: Arc): number => signOf(turn) * radius;

/** Direction of a curve at one of its points, radians. */
export function directionAt(curve: Curve, p: PlanePoint): number {
  return curve.kind === "line"
    ? curve.angle
    : angleOf(difference(p, curve.centre)) + (signOf(curve.turn) * Math.PI) / 2;
}

/** Distance of a point from a curve: positive to the left of a line, outside a circle. */
export const distanceFrom = (curve: Curve, p: PlanePoint): number =>
  curve.kind === "line" ? dot(leftOf(curve.angle), p) - curve.offset : apart(p, curve.centre) - curve.radius;

/** Point where two tangential curves touch; null for two lines. */
function touch(a: Curve, b: Curve): PlanePoint | null {
  if (a.kind === "line" && b.kind === "line") return null;
  if (a.kind === "arc" && b.kind === "arc") {
    const [between, off] = [difference(b.centre, a.centre), reach(b) - reach(a)];
    const far = Math.hypot(between.x, between.y);
    return far === 0 || off === 0 ? a.centre : sum(a.centre, scaled(between, (-reach(a) * Math.sign(off)) / far));
  }
  const [line, arc] = a.kind === "line" ? [a, b as Arc] : [b as Extract<Curve, { kind: "line" }>, a as Arc];
  return sum(arc.centre, scaled(leftOf(line.angle), -reach(arc)));
}

/** Residual of a tangential transition: zero where two curves touch, at whatever point. */
function touching(a: Curve, b: Curve, size: number): number {
  if (a.kind === "line" && b.kind === "line") return Math.sin(b.angle - a.angle);
  if (a.kind === "arc" && b.kind === "arc") return (apart(a.centre, b.centre) - Math.abs(reach(b) - reach(a))) / size;
  const [line, arc] = a.kind === "line" ? [a, b as Arc] : [b as Extract<Curve, { kind: "line" }>, a as Arc];
  return (distanceFrom(line, arc.centre) - reach(arc)) / size;
}

/** The given number as an absolute value; null if its reference is not known yet. */
export function freeValueOf(given: FreeValue, base: (of: number) => number | null): number | null {
  if (given === null) return null;
  if ("at" in given) return given.at;
  const from = base(given.of);
  return from === null ? null : from + given.by;
}

/** Residuals of a point given by its distance and angle from a pole. */
function fromPole(
  { pole, radius, angle }: FromPole,
  p: PlanePoint,
  point: FreePlaces["point"],
  size: number,
): number[] {
  const way = difference(p, pole);
  const far = freeValueOf(radius, (of) => (point(of) ? apart(point(of) ?? pole, pole) : null));
  const turned = freeValueOf(angle, (of) => (point(of) ? angleOf(difference(point(of) ?? pole, pole)) : null));
  const out: number[] = [];
  if (far !== null) out.push((Math.hypot(way.x, way.y) - Math.abs(far)) / size);
  if (turned !== null) out.push(cross(heading(turned), way) / size);
  return out;
}

/** Residuals of an element's end point. */
export function endResiduals(e: FreeElement, k: number, { point }: FreePlaces, size: number): number[] {
  const p = point(k);
  if (!p) return [];
  const out: number[] = [];
  const [x, y] = [freeValueOf(e.x, (of) => point(of)?.x ?? null), freeValueOf(e.y, (of) => point(of)?.y ?? null)];
  if (x !== null) out.push((p.x - x) / size);
  if (y !== null) out.push((p.y - y) / size);
  if (e.polar) out.push(...fromPole(e.polar, p, point, size));
  const end = e.closes === null ? null : point(e.closes);
  if (end) out.push((p.x - end.x) / size, (p.y - end.y) / size);
  return out;
}

/** Residuals of an element's curve alone. */
function curveResiduals(e: FreeElement, found: FreePlaces, own: Curve, size: number): number[] {
  const out = e.through.map((p) => distanceFrom(own, p) / size);
  if (e.distancePoint) out.push((Math.abs(distanceFrom(own, e.distancePoint.point)) - e.distancePoint.distance) / size);
  if (own.kind === "line") {
    const other = e.parallel && found.curve(e.parallel.of);
    if (other?.kind !== "line" || !e.parallel) return out;
    out.push(Math.sin(own.angle - other.angle));
    const along = Math.cos(own.angle - other.angle) < 0 ? -other.offset : other.offset;
    if (e.parallel.distance !== null) out.push((Math.abs(own.offset - along) - e.parallel.distance) / size);
    return out;
  }
  const [x, y] = [
    freeValueOf(e.centreX, (of) => found.point(of)?.x ?? null),
    freeValueOf(e.centreY, (of) => found.point(of)?.y ?? null),
  ];
  // An absolute centre is not an unknown.
  if (x !== null && e.centreX && "by" in e.centreX) out.push((own.centre.x - x) / size);
  if (y !== null && e.centreY && "by" in e.centreY) out.push((own.centre.y - y) / size);
  if (e.centrePolar) out.push(...fromPole(e.centrePolar, own.centre, found.point, size));
  return out;
}

/** The given direction of an element, or of the start of an arc; null where it is not known yet. */
export function givenAngle(e: FreeElement, { curve, point }: FreePlaces): number | null {
  return freeValueOf(e.angle, (of) => {
    const [other, end] = [curve(of), point(of)];
    return other?.kind === "line" ? other.angle : other && end ? directionAt(other, end) : null;
  });
}

/** Residuals of an element together with both its ends. */
function spanResiduals(e: FreeElement, k: number, found: FreePlaces, own: Curve, size: number): number[] {
  const [from, to] = [found.point(k - 1), found.point(k)];
  const out: number[] = [];
  if (own.kind === "arc" && from) {
    const angle = givenAngle(e, found);
    if (angle !== null) out.push(dot(difference(own.centre, from), heading(angle)) / size);
  }
  if (!from || !to) return out;
  if (e.length !== null)
    out.push(
      ((own.kind === "line" ? dot(difference(to, from), heading(own.angle)) : apart(from, to)) - e.length) / size,
    );
  if (e.sweep !== null && own.kind === "arc") {
    const turned = angleOf(difference(from, own.centre)) + signOf(own.turn) * e.sweep;
    out.push(cross(heading(turned), difference(to, own.centre)) / size);
  }
  return out;
}

/** Direction change at a known point, between the curves before and behind it. */
const bend = (a: Curve, b: Curve, p: PlanePoint): number => Math.sin(directionAt(b, p) - directionAt(a, p));

/** Takes the next unknown as a value of an unsolved element. */
type Take = (kind: Window["unknowns"][number]) => (at: readonly number[]) => number;

function curveFrom(e: FreeElement, found: FreePlaces, take: Take): (at: readonly number[]) => Curve {
  if (e.kind === "line") {
    const given = givenAngle(e, found);
    const [angle, offset] = [given === null ? take("angle") : () => given, take("offset")];
    return (at) => ({ kind: "line", angle: angle(at), offset: offset(at) });
  }
  const direct = (given: FreeValue) => (given && "at" in given ? given.at : null);
  const [cx, cy] = [direct(e.centreX), direct(e.centreY)];
  const turn: Turn = e.turn,
    size = e.radius;
  const [x, y, radius] = [
    cx === null ? take("x") : () => cx,
    cy === null ? take("y") : () => cy,
    size === null ? take("radius") : () => size,
  ];
  return (at) => ({ kind: "arc", centre: { x: x(at), y: y(at) }, radius: Math.abs(radius(at)), turn });
}

/** Whether only its two ends determine a line's direction. */
const undirected = (e: FreeElement) => e.kind === "line" && e.angle === null && !e.tangent;

const ends = (e: FreeElement) =>
  [e.x, e.y, e.polar?.radius ?? null, e.polar?.angle ?? null, e.length, e.sweep, e.closes].filter(
    (given) => given !== null,
  ).length;

/**
 * The equations of elements `first` to `last`; null where they cannot be solved on their own. `size` makes lengths
 * comparable.
 */
export function windowOf(
  elements: readonly FreeElement[],
  known: KnownGeometry,
  first: number,
  last: number,
  size: number,
): Window | null {
  const at = (k: number) => elements[k - 1];
  const standing: FreePlaces = { curve: (k) => known.curves[k] ?? null, point: (k) => known.points[k] ?? null };
  const [head, tail] = [at(first), at(last)];
  if (!head || !tail) return null;
  const [curved, placed] = [
    (k: number) => (known.curves[k] ?? null) !== null,
    (k: number) => (known.points[k] ?? null) !== null,
  ];
  const single = first === last;
  const [headKnown, tailKnown] = [curved(first), curved(last)];
  if (single && headKnown && placed(last)) return null;
  const withStart = placed(first - 1) && (!headKnown || single);
  const withEnd = placed(last) || (tailKnown ? single : ends(tail) > (undirected(tail) ? 0 : 1));
  const unknowns: Window["unknowns"][number][] = [];
  const take: Take = (kind) => {
    const place = unknowns.push(kind) - 1;
    return (values) => values[place] ?? 0;
  };
  const curves = new Map<number, (at: readonly number[]) => Curve>();
  for (let k = first; k <= last; k += 1) {
    const [e, own] = [at(k), known.curves[k] ?? null];
    if (!e || (e.angle && "by" in e.angle && givenAngle(e, standing) === null)) return null;
    if (e.parallel && !known.curves[e.parallel.of]) return null;
    const open = (k === first && !withStart) || (k === last && !withEnd);
    if (!own && undirected(e) && open) return null;
    curves.set(k, own ? () => own : curveFrom(e, standing, take));
  }
  const points = new Map<number, ((at: readonly number[]) => PlanePoint) | "touch">();
  for (let k = first; k <= last; k += 1) {
    if (placed(k) || (k === last && !withEnd)) continue;
    const [e, next] = [at(k), at(k + 1)];
    if (k < last && next?.tangent && !(e?.kind === "line" && next.kind === "line")) points.set(k, "touch");
    else {
      const [x, y] = [take("x"), take("y")];
      points.set(k, (values) => ({ x: x(values), y: y(values) }));
    }
  }
  const read = (values: readonly number[]): FreePlaces => {
    const made = new Map([...curves].map(([k, make]) => [k, make(values)] as const));
    const curve = (k: number) => made.get(k) ?? known.curves[k] ?? null;
    const point = (k: number): PlanePoint | null => {
      const own = points.get(k);
      if (own !== "touch") return own ? own(values) : (known.points[k] ?? null);
      const [a, b] = [curve(k), curve(k + 1)];
      return a && b && touch(a, b);
    };
    return { curve, point };
  };
  const residuals = (values: readonly number[]): number[] => {
    const found = read(values);
    const out: number[] = [];
    for (let k = first; k <= last; k += 1) {
      const [e, own] = [at(k), found.curve(k)];
      if (!e || !own) continue;
      const isNew = !curved(k);
      const [from, to] = [
        k > first || withStart ? found.point(k - 1) : null,
        k < last || withEnd ? found.point(k) : null,
      ];
      if (isNew) out.push(...curveResiduals(e, found, own, size));
      // Where curves touch, the point lies on both.
      if (from && points.get(k - 1) !== "touch" && (isNew || !placed(k - 1))) out.push(distanceFrom(own, from) / size);
      if (to && points.get(k) !== "touch" && (isNew || !placed(k))) out.push(distanceFrom(own, to) / size);
      if (to && !placed(k)) out.push(...endResiduals(e, k, found, size));
      out.push(
        ...spanResiduals(
          e,
          k,
          { curve: found.curve, point: (n) => (n === k - 1 ? from : n === k ? to : found.point(n)) },
          own,
          size,
        ),
      );
      const before = k > first || withStart ? found.curve(k - 1) : null;
      if (!e.tangent || !before) continue;
      const fixed = known.points[k - 1];
      if (fixed) out.push(bend(before, own, fixed));
      else if (k > first) out.push(touching(before, own, size));
    }
    return out;
  };
  return { first, last, unknowns, residuals, read };
}
