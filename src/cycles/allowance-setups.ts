import { areaOf, areaOfRing } from "../kernel/area/area.ts";
import { union } from "../kernel/area/clip.ts";
import { contourFrom, type ContourElement } from "../kernel/contour/contour.ts";
import { at, part, type Ring, type Segment } from "../kernel/geometry/point.ts";
import { oversizeContour } from "../kernel/strategy/oversize-contour.ts";
import { CHORD } from "../kernel/tolerance.ts";
import { radius, rounded } from "../kernel/units.ts";
import { dice, type Draw, type Setups } from "./random-setup.ts";

const { box, common, half, mm, mostly } = dice;

/** Two to six segments along the axis with steps, tapers and arcs either way, and corners between them. */
function drawnProfile(draw: Draw, along: 1 | -1, out: 1 | -1): Segment[] | null {
  const usual = half(draw, 14, 30);
  // Sometimes the face in front belongs to the contour, from the axis.
  let here = at(mm(draw, -3, 3), out > 0 ? mostly(draw, usual, draw.one(radius(0), radius(-0.8))) : usual);
  const made: ContourElement[] = [{ kind: "line", to: here }];
  const count = draw.whole(2, 6);
  for (let i = 1; i <= count; i += 1) {
    const to = at(
      rounded(here.z - along * draw.one(0, mm(draw, 1, 12), mm(draw, 1, 12))),
      Math.max(9, here.r + mm(draw, -6, 9)),
    );
    const bulge = mostly(draw, 0, mm(draw, 0.7, 3));
    const chord = part.apart(here, to);
    if (bulge > 0 && chord > 0.5)
      made.push({ kind: "radius", to, radius: rounded(chord * bulge), turn: draw.one("cw", "ccw") });
    else made.push({ kind: "line", to });
    here = to;
    const corner = draw.one("none", "round", "chamfer");
    if (corner !== "none" && i < count) made.push({ kind: corner, size: mm(draw, 0.2, 2) });
  }
  const built = contourFrom(made);
  const [first, last] = [built.segments[0]?.from, built.segments.at(-1)?.to];
  return built.issues.some((i) => i.severity === "error") || !first || !last || along * (first.z - last.z) < 1
    ? null
    : [...built.segments];
}

/** Orientation of a pointed tip: outside (1) or inside, towards −Z (1) or +Z. */
const TURNED = { "1/1": 1, "1/-1": 3, "-1/1": 7, "-1/-1": 5 } as const;

/** A casting round a contour, closed on the axis or inside a wall. */
function casting(contour: readonly Segment[], along: 1 | -1, out: 1 | -1, allowance: number): Ring {
  const frame = { transverse: false, signU: along > 0 ? -1 : 1, signV: out } as const;
  const line = part
    .flattenedChain(oversizeContour(contour, frame, { r: 0, z: 0, round: allowance }), CHORD)
    .map((p) => at(p.z, Math.max(0, p.r)));
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last) return [];
  const deep = out > 0 ? 0 : Math.max(...contour.flatMap((s) => [s.from.r, s.to.r])) + 20;
  const ring = [...line, at(last.z - along * 10, last.r), at(last.z - along * 10, deep), at(first.z, deep)];
  return areaOfRing(ring) < 0 ? ring.reverse() : ring;
}

/** Chords and the grid of areas differ by less, mm². */
const SAME_AREA = 0.01;

/** Whether a ring does not cross itself: a contour shorter than its allowance has no possible casting. */
const isPlain = (ring: Ring): boolean =>
  ring.length > 2 && Math.abs(areaOf(union([ring])) - areaOfRing(ring)) < SAME_AREA;

/** Set-ups of the contour-parallel cycle: outside and inside, towards −Z and +Z, of a casting or of a bar. */
export const allowanceSetups: Setups = (draw) => {
  const [out, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
  const contour = drawnProfile(draw, along, out);
  if (!contour) return null;
  const rs = contour.flatMap((s) => {
    const b = part.boxOf(s);
    return [b.low, b.high];
  });
  const [low, high] = [Math.min(...rs), Math.max(...rs)];
  const [first, last] = [contour[0] as Segment, contour.at(-1) as Segment];
  const allowance = mm(draw, 0.5, 8);
  const T = draw.one(1, 2, 4, 11);
  const [lowest, start] =
    out > 0 ? [0, high + allowance + mm(draw, -2, 4)] : [high + 20, Math.max(0.5, low - mm(draw, 0, 5))];
  const cast = casting(contour, along, out, allowance);
  const bar = box(
    first.from.z,
    last.to.z - along * 10,
    lowest,
    out > 0 ? high + allowance : Math.max(0, low - allowance),
  );
  return {
    values: {
      ...common(draw),
      Q485: allowance,
      Q486: draw.one(0, 1),
      Q499: mostly(draw, 0, draw.one(1, 2)),
    },
    contour,
    tool: { T, TO: T === 11 ? (out > 0 ? 2 : 6) : TURNED[`${out}/${along}`] },
    // Sometimes above the contour: the cycle then moves in front of it.
    start: at(
      first.from.z + along * mostly(draw, mm(draw, 0, 8), -mm(draw, 0, Math.abs(first.from.z - last.to.z))),
      start,
    ),
    blank: draw.one(bar, isPlain(cast) ? cast : bar),
  };
};
