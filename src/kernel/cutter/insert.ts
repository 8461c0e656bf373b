import { edgeEnd, edgeStart, inFrame, moved, type Convex, type Edge, type Feature } from "../reach/convex.ts";
import { drillShape, isDrill } from "./drill.ts";
import { flat, type Flat } from "../geometry/flat.ts";
import { at, part, type Pt, type Ring } from "../geometry/point.ts";
import { JOINED, ROUND } from "../tolerance.ts";
import { USUAL_TOOTH, type TipOrientation, type Tool } from "../plan/tool.ts";
import { length, radians } from "../units.ts";

const { beyond, heading, scaled } = flat;

/** Edge length of an insert whose CUTLENGTH is empty, mm: 12, and 30 for the bar of a recessing tool. */
const EDGE = 12;
const BAR = 30;
/** Point angle of a thread insert whose P-ANGLE is empty, degrees: that of the metric and the unified profile. */
const POINT_ANGLE = 60;

/** From the centre of the nose radius to the theoretical tip, in nose radii, for each tip orientation (−Z, +X …). */
export const TIP: Readonly<Record<TipOrientation, Flat>> = {
  1: { u: -1, v: -1 },
  2: { u: 0, v: -1 },
  3: { u: 1, v: -1 },
  4: { u: 1, v: 0 },
  5: { u: 1, v: 1 },
  6: { u: 0, v: 1 },
  7: { u: -1, v: 1 },
  8: { u: -1, v: 0 },
  9: { u: 0, v: 0 },
};

/** Where the tip of an orientation points, in part space (u is z, v is r); 0 for a round tip. */
export const tipDirection = (TO: TipOrientation): Flat => TIP[TO];

/** Nose or corner radius with its delta, mm, never negative. */
export const noseRadius = (t: Tool) => Math.max(0, t.RS + (t.DRS ?? 0));
/** From the centre of the nose radius to the theoretical tip, mm. */
export function tipOffset(t: Tool): Flat {
  const [tip, r] = [TIP[t.TO] ?? TIP[9], noseRadius(t)];
  return scaled(tip, r);
}
/**
 * Greatest travel of the tip past the axis until the outermost nose has faced the axis clean, mm: the nose centre is
 * then on the axis, or past it where an edge keeps the lowest point of the nose off the face.
 */
export const noseReach = (t: Tool): number =>
  insertShape(t).reduce(
    (most, e) => (e.kind === "arc" && e.feature === "nose" ? Math.max(most, e.centre.v) : most),
    noseRadius(t),
  );
/** Length of the cutting edge, mm; undefined when none was entered (0 counts as none). */
export const cutLength = (t: Tool) => (t.CUTLENGTH !== undefined && t.CUTLENGTH > 0 ? t.CUTLENGTH : undefined);
/** Angle between the flanks of a thread insert, degrees. */
export const pointAngle = (t: Tool): number => t["P-ANGLE"] ?? POINT_ANGLE;
/** Height of the tooth of a thread insert, mm: its CUTLENGTH. */
const toothHeight = (t: Tool): number => cutLength(t) ?? USUAL_TOOTH;
/** A thread tool for flanks of this height, mm: an empty CUTLENGTH sets no limit, so the tooth is made high enough. */
export function withToothFor(height: number, t: Tool): Tool {
  const high = height * 1.2;
  return cutLength(t) === undefined && high > USUAL_TOOTH && Number.isFinite(high)
    ? { ...t, CUTLENGTH: length(high) }
    : t;
}
/** Width of a recessing edge with its delta, mm. */
export const cuttingWidth = (t: Tool) => Math.max(0, (t.CUTWIDTH ?? 0) + (t.DCW ?? 0));
export const isBar = (t: Tool) => t.TYPE === "RECESS" || t.TYPE === "RECTURN";
/** True when T-ANGLE or P-ANGLE is empty, so that the flanks of the insert are unknown. */
export const flanksUnknown = (t: Tool) =>
  (t.TYPE === "ROUGH" || t.TYPE === "FINISH") && (t["T-ANGLE"] === undefined || t["P-ANGLE"] === undefined);

/** True for a blade that plunges along Z. */
export const plungesAxially = (t: Tool) => isBar(t) && tipDirection(t.TO).v === 0 && tipDirection(t.TO).u !== 0;

/** True for such a blade whose range of diameters is not stated: its side is curved for one. */
export const curvatureUnknown = (t: Tool) => plungesAxially(t) && (t.DAXN === undefined || t.DAXX === undefined);

/**
 * The insert as a convex boundary of lines and arcs, relative to the theoretical tip; u is z, v is r (mm). With unknown
 * flanks it is only the nose circle (`body`: extended away from the tip, so that it removes material).
 */
export function insertShape(t: Tool, body = false): Convex {
  const r = noseRadius(t);
  const tip = TIP[t.TO] ?? TIP[9];
  if (isBar(t)) return bar(t, r);
  if (isDrill(t)) return drillShape(t);
  const shift = scaled(tip, -r);
  if (t.TYPE === "BUTTON") return moved(circle(r), shift);
  if (t.TYPE === "THREAD") return moved(tooth(r, Math.atan2(-tip.v, -tip.u), pointAngle(t) / 2, toothHeight(t)), shift);
  if (flanksUnknown(t))
    return moved(body ? capsule(r, Math.atan2(-tip.v, -tip.u), cutLength(t) ?? EDGE) : circle(r), shift);
  return moved(oriented(parallelogram(t, r), t.TO), shift);
}

/** A main and a secondary edge from the nose, for orientation 1, about the centre of the nose. */
function parallelogram(t: Tool, r: number): Convex {
  const T = t["T-ANGLE"] ?? 0;
  const P = Math.min(Math.max(t["P-ANGLE"] ?? 0, 1), 179);
  const l = cutLength(t) ?? EDGE;
  return pointed(r, radians(180 - T - P), radians(180 - T), l, true);
}

/**
 * The tooth of a thread insert about `axis` (from the tip inwards): half angle in degrees, height from the tip in mm.
 */
function tooth(r: number, axis: number, half: number, height: number): Convex {
  const a = radians(half);
  const edge = (height + r / Math.sin(a) - r) / Math.cos(a);
  return pointed(r, axis - a, axis + a, edge, false);
}

/**
 * Two edges in the directions `secondary` and `main` (radians, counter-clockwise in this order), joined by the nose.
 */
function pointed(r: number, secondary: number, main: number, l: number, parallel: boolean): Convex {
  const half = (main - secondary) / 2;
  const s = heading(secondary);
  const m = heading(main);
  const apex = scaled(heading(secondary + half), -r / Math.sin(half));
  const tangent = r / Math.tan(half);
  const far = Math.max(l, tangent * 1.001);
  const onS = beyond(apex, s, tangent);
  const onM = beyond(apex, m, tangent);
  const endS = beyond(apex, s, far);
  const endM = beyond(apex, m, far);
  const nose: Edge = {
    kind: "arc",
    centre: { u: 0, v: 0 },
    radius: r,
    start: main + Math.PI / 2,
    sweep: Math.PI - 2 * half,
    feature: "nose",
  };
  const line = (from: Flat, to: Flat, feature: Feature): Edge => ({ kind: "line", from, to, feature });
  const rear = beyond(endS, m, far);
  const sides = parallel
    ? [line(endS, rear, "behindSecondary"), line(rear, endM, "behindMain")]
    : [line(endS, endM, "back")];
  return [nose, line(onS, endS, "secondaryEdge"), ...sides, line(endM, onM, "mainEdge")];
}

const circle = (r: number): Convex => [
  { kind: "arc", centre: { u: 0, v: 0 }, radius: r, start: 0, sweep: 2 * Math.PI, feature: "nose" },
];

/** The nose circle extended along `axis` by `l`. */
function capsule(r: number, axis: number, l: number): Convex {
  const end = scaled(heading(axis), l);
  const near: Edge = {
    kind: "arc",
    centre: { u: 0, v: 0 },
    radius: r,
    start: axis + Math.PI / 2,
    sweep: Math.PI,
    feature: "nose",
  };
  const away: Edge = {
    kind: "arc",
    centre: end,
    radius: r,
    start: axis - Math.PI / 2,
    sweep: Math.PI,
    feature: "back",
  };
  const join = (a: Edge, b: Edge, feature: Feature): Edge => ({
    kind: "line",
    from: edgeEnd(a),
    to: edgeStart(b),
    feature,
  });
  return [near, join(near, away, "secondaryEdge"), away, join(away, near, "mainEdge")];
}

/** A recessing bar with two rounded corners; the tip on its cutting edge, at a corner or in the middle. */
function bar(t: Tool, r: number): Convex {
  const w = cuttingWidth(t);
  const l = cutLength(t) ?? BAR;
  const rr = Math.min(r, w / 2, l);
  const tip = TIP[t.TO] ?? TIP[2];
  const left = tip.v === 0 || tip.u === 0 ? -w / 2 : tip.u < 0 ? 0 : -w;
  const corner = (u: number, start: number): Edge => ({
    kind: "arc",
    centre: { u, v: rr },
    radius: rr,
    start,
    sweep: Math.PI / 2,
    feature: "nose",
  });
  const line = (fu: number, fv: number, tu: number, tv: number, feature: Feature): Edge => ({
    kind: "line",
    from: { u: fu, v: fv },
    to: { u: tu, v: tv },
    feature,
  });
  const up: Convex = [
    corner(left + rr, Math.PI),
    line(left + rr, 0, left + w - rr, 0, "width"),
    corner(left + w - rr, -Math.PI / 2),
    line(left + w, rr, left + w, l, "secondaryEdge"),
    line(left + w, l, left, l, "back"),
    line(left, l, left, rr, "mainEdge"),
  ];
  if (tip.v < 0 || t.TO === 9) return up;
  if (tip.v > 0) return inFrame(up, { transverse: false, signU: 1, signV: -1 });
  return inFrame(up, { transverse: true, signU: tip.u > 0 ? -1 : 1, signV: 1 });
}

/** A shape for orientation 1 turned to another orientation: mirrored in z, in r, or with z and r swapped first. */
function oriented(k: Convex, to: TipOrientation): Convex {
  const inside = to === 5 || to === 6 || to === 7 || to === 4;
  const left = to === 3 || to === 5;
  if (to === 8 || to === 4)
    return inFrame(inFrame(k, { transverse: false, signU: 1, signV: inside ? -1 : 1 }), {
      transverse: true,
      signU: 1,
      signV: 1,
    });
  return inFrame(k, { transverse: false, signU: left ? -1 : 1, signV: inside ? -1 : 1 });
}

/**
 * The insert as a polygon relative to the theoretical tip, counter-clockwise; arcs within `chord` mm, inside the true
 * shape. `body`: with unknown flanks, extended so that it removes material; else only the nose, because nothing else
 * can be checked.
 */
export function insertOutline(t: Tool, chord: number, body = true): Ring {
  const out: Pt[] = [];
  const add = (p: Flat) => {
    const [next, last] = [at(p.u, p.v), out.at(-1)];
    if (!last || part.apart(last, next) > JOINED) out.push(next);
  };
  for (const e of moved(insertShape(t, body), correctionShift(t))) {
    if (e.kind === "line") add(e.from);
    else {
      const step = e.radius > chord ? 2 * Math.acos(1 - chord / e.radius) : e.sweep;
      for (const [start, sweep] of quarters(e.start, e.sweep)) {
        const n = Math.max(1, Math.ceil(sweep / step));
        for (let i = 0; i <= n; i++) {
          const a = start + (sweep * i) / n;
          add(flat.onCircle(e.centre, e.radius, a));
        }
      }
    }
  }
  const first = out[0];
  const last = out[out.length - 1];
  if (first && last && out.length > 1 && part.apart(first, last) <= JOINED) out.pop();
  return out;
}

/** Splits an angle range at the axes, so that the outline reaches as far along each axis as the insert. */
function quarters(start: number, sweep: number): [start: number, sweep: number][] {
  const quarter = Math.PI / 2;
  const cuts = [start];
  for (let k = Math.floor(start / quarter + 1 + ROUND); k * quarter < start + sweep - ROUND; k++)
    cuts.push(k * quarter);
  return cuts.map((a, i) => [a, (cuts[i + 1] ?? start + sweep) - a]);
}

/** Shift of the insert by a correction, from the tip that the control calculates with. */
export const correctionShift = (t: Tool): Flat => ({ u: t.correction?.z ?? 0, v: t.correction?.r ?? 0 });
