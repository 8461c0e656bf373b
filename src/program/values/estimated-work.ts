import { boxOf } from "../../kernel/area/box.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { axial, diameter, radius, toDiameter, toRadius } from "../../kernel/units.ts";
import type { Cycle, TurnedShape } from "../../cycles/define.ts";
import { firstValues } from "../../cycles/first-values.ts";
import type { Params, Values } from "../../cycles/params.ts";
import { useOf, worksAcross } from "../../cycles/use.ts";
import { beginsAtTip, valuesFor, type ShapeRequest } from "../../cycles/shape-request.ts";

/** Known data of a job while its prompts are being answered, mm. */
export interface PartialInput {
  /** Readable values, by Q. */
  readonly typed: Readonly<Partial<Record<string, number | "auto">>>;
  /** Contour of a free-contour cycle; null without one. */
  readonly contour: readonly Segment[] | null;
  /** Tip at the call, as far as set. */
  readonly tip: { readonly z: number | null; readonly r: number | null };
  /** The blank, as far as set; bore 0 where it is solid. */
  readonly blank: { readonly outside: number | null; readonly bore: number | null; readonly front: number | null };
}

/** Estimate of a part: typed values, completed by usual ones. */
export interface EstimatedWork {
  /** A value for every parameter. */
  readonly values: Readonly<Record<string, number>>;
  /** First corner of the contour, and the opposite one: its depth and end. */
  readonly from: Pt;
  readonly to: Pt;
  /** Box around the finished contour. */
  readonly box: Box;
  /** The depth is along the axis. */
  readonly across: boolean;
  readonly inside: boolean;
  readonly shape: TurnedShape;
  /** Thread pitch, mm; 0 without a thread. */
  readonly pitch: number;
  /** A free contour with a cylinder on its largest diameter, which is turned too. */
  readonly ringed: boolean;
  /** Its contour is drawn, not assumed. */
  readonly hasContour: boolean;
}

/** Default Z of the face, mm. */
const FRONT = 0;
/** Smallest core inside a step without a typed end, as a share of its start diameter. */
const CORE = 0.5;
/** Assumed length of a contour not drawn yet, mm. */
const UNDRAWN = 50;

const number = (value: number | "auto" | undefined): number | null => (typeof value === "number" ? value : null);

/** Ends of a cycle's own contour: a missing one is as far from its partner as in the example. */
function likelyEnds(cycle: Cycle, { typed, tip, blank }: PartialInput): { readonly from: Pt; readonly to: Pt } {
  const usual = firstValues(cycle);
  const simple = beginsAtTip(cycle);
  const grooves = cycle.group === "recessTurning" || cycle.group === "recessing";
  const example = {
    // A simple cycle begins on the blank surface; a groove in a face at the edge at its tip.
    d1: usual["Q491"] ?? Number(grooves && worksAcross(cycle) ? cycle.setup.start.x : cycle.setup.blank.outside),
    d2: usual["Q493"] ?? usual["Q491"] ?? 0,
    z1: usual["Q492"] ?? (grooves && !worksAcross(cycle) ? Number(cycle.setup.start.z) : FRONT),
    z2: usual["Q494"] ?? 0,
  };
  const [deep, long] = [example.d1 - example.d2, Math.abs(example.z1 - example.z2) || UNDRAWN];
  // An impossible diameter is ignored.
  const across = (q: string) => {
    const d = number(typed[q]);
    return d !== null && d > 0 ? d : null;
  };
  const [d2, z2] = [across("Q493") ?? (typed["Q493"] === 0 ? 0 : null), number(typed["Q494"])];
  const outside = blank.outside === null ? null : toDiameter(radius(blank.outside));
  const tipDiameter = tip.r === null ? null : toDiameter(radius(tip.r));
  // A contour starts on the surface of a solid blank, as `suggestedValue` says.
  const isSurface = (blank.bore ?? 0) <= 0 && (d2 ?? 0) < (outside ?? 0);
  const first = simple ? (tipDiameter ?? outside) : (across("Q491") ?? (isSurface ? outside : null));
  const d1 = first ?? (d2 === null ? example.d1 : d2 + deep);
  const end = d2 ?? Math.max(d1 - deep, d1 * CORE);
  // A shoulder begins at the face, and so does anything without a position.
  const begins = simple ? (tip.z ?? (grooves ? null : blank.front)) : number(typed["Q492"]);
  const ahead = z2 === null ? FRONT : grooves || z2 >= FRONT ? z2 + long : FRONT;
  const z1 = begins ?? ahead;
  const corner = (d: number, z: number) => at(axial(z), toRadius(diameter(d)));
  return { from: corner(d1, z1), to: corner(end, z2 ?? z1 - long) };
}

/** Whether a free contour is turned in a bore: it descends from the face, or lies on the wall of an existing bore. */
function contourInside(points: readonly Pt[], bore: number | null): boolean {
  const [a, b] = [points[0], points.at(-1)];
  if (!a || !b) return false;
  const [front, back] = a.z >= b.z ? [a, b] : [b, a];
  const { low } = boxOf([...points]);
  if (bore !== null && bore > 0 && low >= bore - SAME && Math.abs(front.r - back.r) < SAME && front.r < low + SAME)
    return true;
  return front.r > back.r + SAME;
}

/** Whether a contour runs along its largest diameter, not only up to it. */
const isRinged = (points: readonly Pt[], { high }: Box) =>
  points.some((p, i) => {
    const before = points[i - 1];
    return before !== undefined && p.r > high - SAME && before.r > high - SAME && Math.abs(p.z - before.z) > SAME;
  });

/** Estimates the part that typed values describe; missing values become the usual ones. */
export function estimateWork(cycle: Cycle, known: PartialInput): EstimatedWork {
  const { typed, contour, blank } = known;
  const across = worksAcross(cycle);
  const points = cycle.contour === "free" && contour ? part.flattenedChain(contour, CHORD) : [];
  const ends = likelyEnds(cycle, known);
  const [from, to] = [points[0] ?? ends.from, points.at(-1) ?? ends.to];
  const { thread } = cycle;
  const position = thread && number(typed[thread.position]);
  const falls =
    points.length > 0
      ? !across && contourInside(points, blank.bore)
      : cycle.contour === "own" && !thread && from.r < to.r;
  const inside = thread ? position === 1 : falls;
  const shape = thread ? "thread" : (useOf(cycle).shapes.at(-1) ?? "free");
  const pitch = thread ? (number(typed[thread.pitch]) ?? firstValues(cycle)[thread.pitch] ?? 0) : 0;
  const corner = (p: Pt) => ({ diameter: toDiameter(p.r), z: axial(p.z) });
  const wanted: ShapeRequest = {
    site: across ? "face" : inside ? "inside" : "outside",
    shape,
    from: corner(from),
    to: corner(to),
    angle: 0,
    pitch,
    contour,
    allowance: 0,
  };
  const read = Object.entries(typed).flatMap(([q, value]) => (typeof value === "number" ? [[q, value] as const] : []));
  const values = { ...valuesFor(cycle, wanted), ...cycle.setup.values, ...Object.fromEntries(read) };
  const outline =
    cycle.contour === "own"
      ? cycle.outline({ ...values, ...Object.fromEntries(read) } as Values<Params>, { contour: null, start: from })
          .contour
      : [];
  const corners = points.length > 0 ? points : [from, to, ...part.flattenedChain(outline, CHORD)];
  const box = boxOf([...corners]);
  return {
    values,
    from,
    to,
    box,
    across,
    inside,
    shape,
    pitch,
    hasContour: points.length > 0,
    ringed: cycle.group === "longitudinal" && isRinged(points, box),
  };
}
