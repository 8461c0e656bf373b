import { inBox } from "../kernel/area/box.ts";
import { areaOf } from "../kernel/area/area.ts";
import { difference, intersection } from "../kernel/area/clip.ts";
import { isDrill } from "../kernel/cutter/drill.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { withoutSlivers } from "../kernel/area/real-area.ts";
import type { NeededHole, Step } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { inStock } from "./contact.ts";
import { piecesMeeting, type Cutting } from "./cutting.ts";
import { sweptBehindBlank } from "./behind-blank.ts";
import type { Edges } from "./edges.ts";
import type { WorkHold, Loose } from "./work-holding.ts";
import { cutsLoosePiece } from "./loose-cut.ts";
import { holderHits } from "./holder.ts";
import type { Outlines } from "./outlines.ts";
import { isPlainCut, judgePlainCut, type Surface } from "./plain-cut.ts";
import { largest, placeIn } from "./region.ts";
import type { AnyFinding, SimulatedOperation } from "./simulation.ts";
import { sweptBy, type Sweep } from "./sweep.ts";
import { limitHit, type LimitHit } from "./tool-limits.ts";

/** After this many damaging moves the check stops: it costs far more where there is damage. */
export const MOST_CONTACTS = 1000;
/** The finished part (shrunk) with its edges, to detect contour damage, and its contour surfaces. */
export interface Finished {
  readonly rings: readonly Ring[];
  readonly edges: Edges;
  readonly surfaces: readonly Surface[];
}

/** What a step is checked against, besides the stock. */
export interface CheckContext {
  readonly steps: readonly Step[];
  readonly finished: Finished;
  /** The work holding; null without a blank. */
  readonly hold: WorkHold | null;
  /** True where a clamping is stated, so that the space behind the blank is known. */
  readonly isClamped: boolean;
  /** Pieces that have come off before a step and are gone. */
  readonly loose: (step: number) => Loose | null;
  readonly outlines: (tool: Tool) => Outlines;
  readonly operations: readonly SimulatedOperation[];
}

/** The step as the rapid that positioned the tool: any contact there was made by that rapid. */
const broughtTo = (step: Step): Step => ({
  ...step,
  move: { kind: "rapid", phase: "position", run: "rough", step: 0, to: step.from },
});

/** The cause of a finding: its step, or the block that brought the tool there. */
type Cause = Pick<AnyFinding, "block" | "operation" | "isMeant" | "rear" | "below"> & { readonly limit?: LimitHit };

/** The finding of an area; none without one. */
const findingOf = (
  kind: AnyFinding["kind"],
  rings: readonly Ring[],
  index: number,
  step: Step,
  by: Cause = step,
): AnyFinding[] =>
  rings.length === 0
    ? []
    : [
        {
          kind,
          step: index,
          block: by.block,
          operation: by.operation,
          place: placeIn(largest(rings)),
          area: areaOf(rings),
          rings,
          moves: 1,
          ...(by.isMeant && { isMeant: true }),
          ...(by.below !== undefined && { below: by.below }),
          ...(by.rear !== undefined && { rear: by.rear }),
          ...(kind === "spindleStopped" && step.spindleFault && { idle: step.spindleFault }),
          ...(by.limit && {
            limit: { tool: step.tool.T, column: by.limit.column, value: by.limit.value, limit: by.limit.limit },
          }),
          ...(kind === "holeMissing" && step.hole && { hole: { tool: step.tool.T, ...step.hole } }),
        },
      ];

/** The stock in the way of a step that needs a hole. */
function inHole({ from, move: { to } }: Step, { radius }: NeededHole, cut: Cutting): Ring[] {
  const [low, high] = [Math.min(from.z, to.z), Math.max(from.z, to.z)];
  return withoutSlivers(inBox(cut.stock(), { left: low, right: high, low: 0, high: radius }));
}

/** The damage done by a step, checked before its sweep is subtracted from the stock. */
export function check(index: number, sweep: Sweep, cut: Cutting, against: CheckContext): AnyFinding[] {
  const { steps, finished, hold } = against;
  const step = steps[index] as Step,
    outlines = against.outlines(step.tool),
    loose = against.loose(index);
  const found: AnyFinding[] = [];
  const report = (kind: AnyFinding["kind"], rings: readonly Ring[], by?: Cause) =>
    found.push(...findingOf(kind, rings, index, step, by));
  const now = cut.present();
  // The quick check joins many pieces at once, so its hits are confirmed in the stock itself.
  const sure = (area: Ring[]) => (area.length === 0 ? area : withoutSlivers(intersection(cut.stock(), area)));
  const touches = piecesMeeting(sweep, now.meets).length > 0;
  const met =
    step.positionedBy === undefined
      ? []
      : sure(withoutSlivers(inStock([sweptBy(outlines.checked, broughtTo(step))], now)));
  if (step.positionedBy !== undefined) report("rapidInStock", met, { block: step.positionedBy, operation: null });
  if (touches && step.move.kind === "rapid") {
    const taken = sure(withoutSlivers(inStock([sweep], now)));
    report("rapidInStock", met.length > 0 ? withoutSlivers(difference(taken, met)) : taken);
  }
  // The drill's shape makes the bore: contours of turning cycles do not apply to it.
  if (touches && !isDrill(step.tool) && sweep.pieces.some((p) => finished.edges.meets(p))) {
    const taken = sure(withoutSlivers(inStock([sweep], now, finished.rings)));
    if (taken.length === 0 || !isPlainCut(step)) report("gouge", taken);
    else {
      const judged = judgePlainCut(index, taken, cut, { ...against, surfaces: finished.surfaces });
      const { kind = null, below = -1 } = judged ?? {};
      if (kind === "gouge") report(kind, taken);
      else if (kind === "meant") report("cutBelowContour", taken, { ...step, below, isMeant: true });
      else if (kind) report(kind, taken, { ...step, below });
    }
  }
  report("holderContact", sure(holderHits(step, outlines, now)));
  const limit = limitHit(step, sweep, outlines.insert, now);
  if (limit) report("toolLimit", limit.rings, { ...step, limit });
  const behind = hold && !against.isClamped ? sweptBehindBlank(sweep, hold.rear) : [];
  if (hold && behind.length > 0)
    report(step.move.kind === "rapid" ? "rapidBehindBlank" : "feedBehindBlank", behind, { ...step, rear: hold.rear.z });
  if (
    loose &&
    step.move.kind !== "rapid" &&
    sweep.pieces.some((p) => loose.edges.meets(p)) &&
    cutsLoosePiece(loose, index, cut, against)
  )
    report("cutOnLoosePiece", withoutSlivers(intersection(loose.rings, sweep.rings)));
  if (step.move.kind === "rapid") return found;
  if (touches && step.spindleFault) report("spindleStopped", sure(withoutSlivers(inStock([sweep], now))));
  if (touches && step.hole) report("holeMissing", sure(inHole(step, step.hole, cut)));
  return found;
}
