import { contourFrom, type ContourElement } from "../kernel/contour/contour.ts";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { METRIC } from "../kernel/contour/metric-thread.ts";
import { ROUND, SAME } from "../kernel/tolerance.ts";
import type { TipOrientation } from "../kernel/plan/tool.ts";
import { rounded, toDiameter } from "../kernel/units.ts";
import { box, half, mm, mostly, type Draw, type RandomSetup, type Setups } from "./random-setup.ts";

/** Values of every thread cycle. */
function threadValues(draw: Draw, out: 1 | -1) {
  const starts = draw.one(1, 1, 2, 3);
  const pitch = mm(draw, 0.5, 3);
  const Q473 = mostly(draw, 0, mm(draw, 0.2, 1.6));
  const depth = Q473 > 0 ? Q473 : pitch * (out > 0 ? METRIC.outside : METRIC.inside);
  const values = {
    Q471: out > 0 ? 0 : 1,
    Q461: 0,
    Q460: mm(draw, 0.5, 3),
    Q472: rounded(pitch * starts),
    Q473,
    Q474: draw.one(0, mm(draw, 0.5, 4)),
    Q465: mm(draw, 2, 8),
    Q466: mm(draw, 0.5, 5),
    Q463: mm(draw, 0.08, 0.6),
    Q467: draw.one(0, 29.5, 30),
    Q468: draw.one(0, 1),
    Q470: draw.one(0, mm(draw, 0, 359)),
    Q475: starts,
    Q476: draw.one(0, 0, 1, 2),
  };
  return { values, depth };
}

/** Height of a tooth that clears any material in these set-ups, mm. */
const HIGH = 12;

const tool = (out: 1 | -1, tooth = HIGH): RandomSetup["tool"] => ({
  T: out > 0 ? 12 : 13,
  TO: out > 0 ? 2 : 6,
  CUTLENGTH: tooth,
});

/** Half the width of the shipped thread tools at the height of their tooth, mm: 60° about a nose of 0.1. */
const besideTip = (tooth: number) => (tooth + 0.1) * Math.tan(Math.PI / 6);
/** A shoulder this far behind a flank is clear of it, mm. */
const CLEAR = 0.005;

/**
 * A blank with a shoulder behind its end `z`, towards −Z where `along` is 1; in a bore the shoulder is a step towards
 * the axis.
 */
function shouldered(
  blank: Ring,
  { z, along, surface, to }: { z: number; along: 1 | -1; surface: number; to: number },
): Ring {
  const [ends, heights] = [blank.map((p) => p.z), blank.map((p) => p.r)];
  const [front, back] = along > 0 ? [Math.max(...ends), Math.min(...ends)] : [Math.min(...ends), Math.max(...ends)];
  const core = heights.find((r) => Math.abs(r - surface) > SAME) ?? 0;
  const ring = [at(front, core), at(front, surface), at(z, surface), at(z, to), at(back, to), at(back, core)];
  return along > 0 === to > core ? ring.reverse() : ring;
}

/** A thread in a face, towards the axis or away from it, in front or behind. */
function faceThread(draw: Draw): RandomSetup {
  const { values } = threadValues(draw, 1);
  const [inwards, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
  const [r1, z1] = [half(draw, 25, 40), mm(draw, -5, 5)];
  const r2 = rounded(r1 - inwards * mm(draw, 8, 20));
  const z2 = rounded(z1 + mostly(draw, 0, mm(draw, -1, 1)));
  const TO: TipOrientation = along > 0 ? 8 : 4;
  const face = along > 0 ? Math.max(z1, z2) : Math.min(z1, z2);
  return {
    values: { ...values, Q461: 1, Q464: 0, Q469: 0, Q491: toDiameter(r1), Q492: z1, Q493: 2 * r2, Q494: z2 },
    contour: null,
    tool: { T: 12, TO, CUTLENGTH: HIGH },
    start: at(face + along * mm(draw, 1, 5), r1 + inwards * mm(draw, 2, 8)),
    blank: box(face, face - along * 25, r1, inwards > 0 ? Math.max(0, r2 - 12) : r2 + 12),
  };
}

/**
 * A thread along the axis, outside and inside, towards −Z and +Z; `extended`: also on a cone, in every dimensioning.
 */
function longThread(draw: Draw, extended: boolean): RandomSetup {
  const [out, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
  const { values, depth } = threadValues(draw, out);
  const [r1, z1] = [half(draw, 20, 40), mm(draw, -5, 5)];
  const z2 = rounded(z1 - along * mm(draw, 6, 25));
  const r2 = rounded(r1 + (extended ? mostly(draw, 0, mm(draw, -2, 2)) : 0));
  const taper = Math.sign(r2 - r1) * mm(draw, 4, 12);
  const form = extended ? draw.one(0, 0, 1, 2, 3, 4) : 0;
  const steep = Math.tan((Math.abs(taper) * Math.PI) / 180) * Math.abs(z2 - z1);
  const [low, high] = [Math.min(r1, r2) - (form > 1 ? steep : 0), Math.max(r1, r2) + (form > 1 ? steep : 0)];
  const surface = out > 0 ? high + mostly(draw, 0, 0.2) : low - depth - mostly(draw, 0, 0.2);
  const long = form === 1 || form === 3 ? 40 : 0;
  const blank = box(
    z1 + (form === 1 ? along * long : 0),
    z2 - along * (12 + long),
    surface,
    out > 0 ? 0 : surface + 25,
  );
  // The limit case: a tooth as high as the thread is deep, and a shoulder right behind the flank of the last pass.
  const crest = out > 0 ? high : low - depth;
  const tooth = !extended && Math.abs(surface - crest) < ROUND ? draw.one(HIGH, depth, depth + 0.5) : HIGH;
  const behind = z2 - along * (values.Q472 + besideTip(tooth) + CLEAR);
  const hasShoulder = !extended && tooth < HIGH && draw.one(true, false);
  return {
    values: {
      ...values,
      ...(extended && { Q464: form, Q469: form === 0 ? 0 : taper, Q493: 2 * r2 }),
      Q491: toDiameter(r1),
      Q492: z1,
      Q494: z2,
    },
    contour: null,
    tool: tool(out, tooth),
    start: at(z1 + along * (mm(draw, 3, 12) + long), surface + out * mm(draw, 1, 5)),
    blank: hasShoulder ? shouldered(blank, { z: behind, along, surface, to: surface + out * mm(draw, 2, 12) }) : blank,
  };
}

export const threadSetups = (draw: Draw, extended: boolean): RandomSetup =>
  extended && draw.one(false, false, true) ? faceThread(draw) : longThread(draw, extended);

/**
 * Set-ups of a thread along a free contour: lines, tapers and sometimes an arc, always in one direction along the axis.
 */
export const threadContourSetups: Setups = (draw) => {
  const [out, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
  const { values, depth } = threadValues(draw, out);
  const [r1, z1] = [half(draw, 22, 40), mm(draw, -5, 5)];
  let here = at(z1, r1);
  const made: ContourElement[] = [{ kind: "line", to: here }];
  const count = draw.whole(1, 3);
  for (let i = 0; i < count; i += 1) {
    const to = at(rounded(here.z - along * mm(draw, 4, 10)), rounded(here.r + mostly(draw, 0, mm(draw, -1, 1))));
    if (draw.one(false, false, true))
      made.push({ kind: "radius", to, radius: mm(draw, 15, 40), turn: draw.one("cw", "ccw") });
    else made.push({ kind: "line", to });
    here = to;
  }
  const built = contourFrom(made);
  if (built.issues.some((i) => i.severity === "error")) return null;
  const surface = out > 0 ? r1 + 4 : r1 - 4 - depth;
  return {
    values,
    contour: built.segments,
    tool: tool(out),
    start: at(z1 + along * mm(draw, 4, 12), surface + out * mm(draw, 1, 5)),
    blank: box(z1, here.z - along * 12, surface, out > 0 ? 0 : surface + 25),
  };
};
