import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { FULL_TURN, overlap, positive, type Box } from "../../kernel/geometry/segments.ts";
import { ROUND, SAME } from "../../kernel/tolerance.ts";
import type { DrawnCurve } from "./drawing.ts";

/** Lines and arcs this near to each other over a common length are one, mm. */
const NEAR = 1e-3;

type Line = Extract<Segment, { kind: "line" }>;
type Arc = Extract<Segment, { kind: "arc" }>;
/** The endless line or the circle of a curve, as numbers; curves of one carrier have nearly equal ones. */
type Carrier = readonly [number, number, number];

function carrierOf(s: Segment): Carrier {
  if (s.kind === "arc") return [s.centre.z, s.centre.r, part.radiusOf(s)];
  const way = directionOf(s);
  const foot = part.beyond(s.from, way, -part.dot(s.from, way));
  return [foot.z, foot.r, 0];
}
/** Direction of a line in the right half of the plane. */
function directionOf(s: Line): Pt {
  const way = part.unit(part.difference(s.to, s.from));
  return way.z < -ROUND || (Math.abs(way.z) <= ROUND && way.r < 0) ? part.scaled(way, -1) : way;
}

/** The line or arc that covers two of one carrier; null where they share no length, only a point. */
function unitedCurve(a: Segment, b: Segment): Segment | null {
  if (a.kind === "line" && b.kind === "line") {
    const way = directionOf(a),
      place = (p: Pt) => part.dot(part.difference(p, a.from), way),
      off = (p: Pt) => Math.abs(part.cross(part.difference(p, a.from), way));
    const [one, two] = [
      [place(a.from), place(a.to)],
      [place(b.from), place(b.to)],
    ];
    const common = Math.min(Math.max(...one), Math.max(...two)) - Math.max(Math.min(...one), Math.min(...two));
    return common > NEAR && off(b.from) < NEAR && off(b.to) < NEAR ? unitedLine(a, b) : null;
  }
  if (a.kind === "line" || b.kind === "line") return null;
  const isOneCircle = part.apart(a.centre, b.centre) < NEAR && Math.abs(part.radiusOf(a) - part.radiusOf(b)) < NEAR;
  return isOneCircle ? unitedArc(a, b) : null;
}

function unitedLine(a: Line, b: Line): Line {
  const way = directionOf(a),
    place = (p: Pt) => part.dot(part.difference(p, a.from), way),
    ends = [a.from, a.to, b.from, b.to].toSorted((p, q) => place(p) - place(q)),
    [low = a.from, high = a.to] = [ends[0], ends[3]];
  return place(a.to) > place(a.from) ? part.line(low, high) : part.line(high, low);
}

const forwards = (s: Arc): Arc => (s.turn === "ccw" ? s : { ...s, from: s.to, to: s.from, turn: "ccw" });
/** The arc that covers both; null where they only touch or have nothing in common. */
function unitedArc(first: Arc, second: Arc): Arc | null {
  const [a, b] = [forwards(first), forwards(second)],
    size = part.radiusOf(a),
    angle = (p: Pt) => part.angleOf(part.difference(p, a.centre)),
    start = angle(a.from),
    slack = NEAR / size;
  const [own, other] = [part.sweepOf(a), part.sweepOf(b)],
    gone = positive(angle(b.from) - start),
    offset = gone > FULL_TURN - slack ? 0 : gone,
    around = offset + other - FULL_TURN;
  const beginsInside = offset < own - slack,
    endsInside = around > slack;
  if (!beginsInside && !endsInside) return null;
  const isFull = beginsInside
    ? endsInside || Math.max(own, offset + other) >= FULL_TURN - slack
    : Math.max(own, around) >= offset - slack;
  if (isFull) return { ...a, to: a.from };
  if (beginsInside) return offset + other > own ? { ...a, to: b.to } : a;
  return around >= own ? b : { ...b, to: a.to };
}

/** The curves with those that lie on each other as one, and how many went; without those of no length. */
export function withoutDoubles(curves: readonly DrawnCurve[]): {
  readonly curves: DrawnCurve[];
  readonly doubled: number;
} {
  const sound = curves.filter(
    ({ segment }) => segment.kind === "arc" || part.apart(segment.from, segment.to) > SAME / 10,
  );
  const cells = new Map<string, number[]>(),
    kept: (DrawnCurve | null)[] = [];
  const cell = 10 * NEAR;
  const keyOf = (c: Carrier, { segment, role }: DrawnCurve, shifted: Carrier) =>
    `${segment.kind} ${role} ${c.map((n, i) => Math.floor(n / cell + 0.5) + (shifted[i] ?? 0)).join(" ")}`;
  const boxes: Box[] = [];
  let doubled = 0;
  for (const next of sound) {
    let curve: DrawnCurve = next,
      box = part.boxOf(curve.segment);
    const carrier = carrierOf(curve.segment),
      isArc = curve.segment.kind === "arc";
    for (const dz of [-1, 0, 1])
      for (const dr of [-1, 0, 1])
        for (const size of isArc ? [-1, 0, 1] : [0])
          for (const i of cells.get(keyOf(carrier, curve, [dz, dr, size])) ?? []) {
            const [other, around] = [kept[i], boxes[i]];
            if (!other || !around || !overlap(around, box)) continue;
            const united = unitedCurve(other.segment, curve.segment);
            if (!united) continue;
            kept[i] = null;
            doubled += 1;
            curve = { ...other, segment: united };
            box = part.boxOf(united);
          }
    const key = keyOf(carrierOf(curve.segment), curve, [0, 0, 0]),
      there = cells.get(key);
    if (there) there.push(kept.length);
    else cells.set(key, [kept.length]);
    kept.push(curve);
    boxes.push(box);
  }
  return { curves: kept.filter((c) => c !== null), doubled };
}
