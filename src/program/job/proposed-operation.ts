import type { Cycle, TurnedShape } from "../../cycles/define.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import { useOf, worksAcross } from "../../cycles/use.ts";
import { beginsAtTip, type Corner, type ShapeRequest, type Site } from "../../cycles/shape-request.ts";
import type { Param } from "../../cycles/params.ts";
import type { Ring, Segment } from "../../kernel/geometry/point.ts";
import { axial, diameter, radius, rounded, toDiameter } from "../../kernel/units.ts";
import type { Operation } from "../state/run-types.ts";
import { isOfDrawing, suggestedValue } from "../values/suggestion.ts";
import { positionAsTyped, valueAsTyped } from "../values/typed-value.ts";
import type { SetJob, SpindleDraft } from "./job.ts";
import type { Draft } from "./read-draft.ts";
import { jobFor } from "./requested-job.ts";
import { boxAroundContour } from "./requested-shape.ts";
import { faceOf, frontOf, longestOf, reliefBehind, startOnSurface, type StockSurface } from "./stock-surface.ts";

/** Context of a new operation: the stock left by the previous operations, and where in it the operation starts. */
export interface OperationContext {
  readonly stock: readonly Ring[];
  readonly surface: StockSurface;
  /** Previous operations, in order. */
  readonly before: readonly Pick<Operation, "spindle" | "cycle">[];
  /** The contour of a cycle that takes one. */
  readonly contour: readonly Segment[];
  /** The start point as typed; an empty coordinate is proposed where the stock determines it. */
  readonly start: SetJob["start"];
}

/** A new operation. Sizes that only the drawing knows stay open. */
export interface ProposedOperation {
  /** The job to write. */
  readonly job: SetJob;
  /** Sizes of the chosen surface, which the job has: where the contour starts. */
  readonly placed: Draft;
  /** Other sizes that follow from the stock: suggestions for open prompts. */
  readonly sizes: Draft;
  /** The same job with likely sizes: only to compare tools, never written. */
  readonly likely: SetJob;
}

/** The site that a cycle can work on. */
export function sitesOf(cycle: Cycle): readonly Site[] {
  return worksAcross(cycle) ? ["face"] : ["outside", "inside"];
}

/** Where an operation starts, unless another surface is chosen: threads and faces at the front, others on the longest. */
export function usualSurface({ group }: Cycle, surfaces: readonly StockSurface[]): StockSurface | null {
  const [first] = surfaces;
  return first && group !== "thread" && first.site !== "face" ? longestOf(surfaces) : (first ?? null);
}

/** Set-up clearance of a start point, mm; of a cut that begins at the tip; of a thread; overlap of a face over a bore. */
const CLEARANCE = 2;
const AT_TIP = 1;
const RUN_UP = 5;
const OVER_BORE = 1;
/** Likely sizes, as a share of diameter and length, mm of a groove, mm of a pitch. */
const LIKELY = { diameter: 0.8, length: 0.4, depth: 2.5, width: 5, pitch: 1.5 };

const isGroove = ({ group }: Cycle) => group === "recessTurning" || group === "recessing";
const shapeOf = (cycle: Cycle): TurnedShape =>
  cycle.group === "thread" ? "thread" : isGroove(cycle) ? "groove" : (useOf(cycle).shapes[0] ?? "step");

const corner = (d: number, z: number): Corner => ({
  diameter: diameter(rounded(Math.max(0, d))),
  z: axial(rounded(z)),
});
const acrossOf = (r: number) => rounded(toDiameter(radius(Math.max(0, r))));

/** Sizes of an operation that its surface determines, by Q. */
function knownSizes(cycle: Cycle, { stock, surface, start }: OperationContext): Readonly<Record<string, number>> {
  const { site, from, to } = surface;
  const d = acrossOf(from.r);
  const typed = (text: string) => (text.trim() === "" || Number.isNaN(Number(text)) ? {} : { value: Number(text) });
  const put = (q: string, { value }: { readonly value?: number }) => (value === undefined ? {} : { [q]: value });
  switch (shapeOf(cycle)) {
    case "thread": {
      // The thread ends where its cylinder ends; the insert runs out in the relief.
      const relief = reliefBehind(surface, stock);
      return {
        ...(site === "outside" ? { Q491: d } : {}),
        Q492: startOnSurface(surface, stock),
        ...(relief ? { Q494: Math.round(10 * relief.from) / 10, Q474: 0 } : {}),
      };
    }
    case "groove":
    case "plunge":
      return site === "face"
        ? { Q492: from.z, ...put("Q491", typed(start.x)) }
        : { Q491: d, ...put("Q492", typed(start.z)) };
    case "step":
    case "free": {
      if (site !== "face") return { Q491: d, Q492: startOnSurface(surface, stock) };
      // Stock in front of Z0 is faced; the cut passes the edge of a bore.
      const faces = from.z > faceOf(stock);
      return {
        Q491: d,
        Q492: from.z,
        ...(faces ? { Q493: acrossOf(to.r - (to.r > 0 ? OVER_BORE : 0)), Q494: 0 } : {}),
      };
    }
  }
}

/** A shape that the operation may have: its open sizes are invented, so it only serves to compare tools. */
function likelyShape(cycle: Cycle, context: OperationContext): ShapeRequest {
  const { surface, contour } = context;
  const { site, from } = surface;
  const shape = shapeOf(cycle);
  const rest = { site, shape, angle: 0, pitch: LIKELY.pitch, contour: null, allowance: 0 } as const;
  if (cycle.contour === "free" && contour.length > 0)
    return { ...rest, shape: "free", contour, ...boxAroundContour(contour, site) };
  const known = knownSizes(cycle, context);
  const d1 = known["Q491"] ?? acrossOf(from.r);
  const z1 = known["Q492"] ?? from.z;
  const long = Math.max(LIKELY.width, Math.abs(from.z - surface.to.z) * LIKELY.length);
  const deeper = site === "inside" ? d1 + 2 * LIKELY.depth : d1 * LIKELY.diameter;
  const [d2, z2] =
    shape === "groove"
      ? site === "face"
        ? [d1 - 2 * LIKELY.width, z1 - LIKELY.depth]
        : [site === "inside" ? d1 + LIKELY.depth : d1 - LIKELY.depth, z1 - LIKELY.width]
      : [shape === "thread" ? d1 : deeper, z1 - (site === "face" ? LIKELY.depth : long)];
  return { ...rest, from: corner(d1, z1), to: corner(known["Q493"] ?? d2, known["Q494"] ?? z2) };
}

/** Tip at the call, clear of the stock; a coordinate that only the drawing knows stays empty. */
function startOf(cycle: Cycle, { stock, surface, start }: OperationContext, likely: SetJob): SetJob["start"] {
  const { site, from } = surface;
  const out = site === "inside" ? -1 : 1;
  const beside = (by: number) => positionAsTyped(acrossOf(from.r + out * by));
  const ahead = (by: number) =>
    positionAsTyped(Math.max(startOnSurface(surface, stock), from.z > 0 ? frontOf(stock) : from.z) + by);
  const shape = shapeOf(cycle);
  const proposed = (() => {
    if (shape === "thread") return { x: beside(RUN_UP), z: ahead(RUN_UP) };
    if (shape === "groove" || shape === "plunge") {
      const clear = beginsAtTip(cycle) ? AT_TIP : CLEARANCE;
      return site === "face" ? { x: "", z: positionAsTyped(from.z + clear) } : { x: beside(clear), z: "" };
    }
    if (cycle.contour === "free" && likely.contour.length > 0) return likely.start;
    return site === "face"
      ? { x: beside(CLEARANCE), z: positionAsTyped(from.z) }
      : { x: beside(0), z: ahead(CLEARANCE) };
  })();
  const or = (typed: string, otherwise: string) => (typed.trim() === "" ? otherwise : typed);
  return { x: or(start.x, proposed.x), z: or(start.z, proposed.z) };
}

/** Parameters of the start of a contour. */
const OF_START: ReadonlySet<string> = new Set(["Q491", "Q492"]);

/** Values of the prompts: the sizes of the surface, and usual ones where the drawing does not decide; the rest is open. */
function writtenValues(cycle: Cycle, { site }: StockSurface, placed: Draft): Draft {
  const blank = { outside: null, bore: null, front: null };
  return Object.fromEntries(
    Object.entries<Param>(cycle.params).map(([q, param]) => {
      if (cycle.thread?.position === q) return [q, site === "inside" ? "1" : "0"];
      const open = isOfDrawing(param) || param.text === "startZ";
      const value = open ? null : suggestedValue(cycle, q, { blank, perRevolution: true });
      return [q, placed[q] ?? (value === null ? "" : String(value))];
    }),
  );
}

/** The spindle of the last operation of the same kind: a thread is cut at a constant speed, regardless of other cuts. */
function spindleFor(cycle: Cycle, context: OperationContext, usual: SpindleDraft): SpindleDraft {
  const isThread = (number: number) => cycleByNumber(number)?.group === "thread";
  const last = context.before.findLast((o) => isThread(o.cycle) === (cycle.group === "thread"))?.spindle;
  const fits = last && (cycle.group !== "thread" || last.kind === "constant");
  return fits ? spindleAsTyped(usual, last) : usualSpindle(cycle, context, usual);
}

/** Proposes an operation of a cycle on a surface of the stock. Nothing is invented: unknown sizes stay open. */
export function proposedOperation(cycle: Cycle, context: OperationContext): ProposedOperation {
  const made = jobFor(cycle, likelyShape(cycle, context), context.stock);
  const start = startOf(cycle, context, made);
  const known = Object.entries(knownSizes(cycle, { ...context, start })).filter(([q]) => cycle.params[q]);
  const sized = (isOfStart: boolean): Draft =>
    Object.fromEntries(
      known.filter(([q]) => OF_START.has(q) === isOfStart).map(([q, value]) => [q, String(rounded(value))]),
    );
  const [placed, sizes] = [sized(true), sized(false)];
  const values = writtenValues(cycle, context.surface, placed);
  const typed = Object.entries({ ...values, ...sizes }).filter(([, text]) => text !== "");
  const likely = { ...made.drafts[cycle.number], ...Object.fromEntries(typed) };
  const spindle = spindleFor(cycle, context, made.spindle);
  const job: SetJob = { ...made, start, spindle, drafts: { [cycle.number]: values } };
  return { job, placed, sizes, likely: { ...job, drafts: { [cycle.number]: likely } } };
}

/** Usual cutting speed of a thread, m/min, and the fastest spindle for it, rpm. */
const THREADING = { speed: 120, fastest: 1500 };

/** A thread is cut at a constant speed that suits its diameter. */
function usualSpindle(cycle: Cycle, { surface }: OperationContext, usual: SpindleDraft): SpindleDraft {
  if (cycle.group !== "thread") return usual;
  const turns = (1000 * THREADING.speed) / (Math.PI * Math.max(1, acrossOf(surface.from.r)));
  return { ...usual, mode: "constant", speed: String(Math.min(THREADING.fastest, Math.round(turns / 10) * 10)) };
}

function spindleAsTyped(usual: SpindleDraft, spindle: NonNullable<Operation["spindle"]>): SpindleDraft {
  return spindle.kind === "constant"
    ? { ...usual, mode: "constant", speed: valueAsTyped(spindle.speed) }
    : {
        ...usual,
        mode: "surface",
        cuttingSpeed: valueAsTyped(spindle.cuttingSpeed),
        limit: valueAsTyped(spindle.limit),
      };
}
