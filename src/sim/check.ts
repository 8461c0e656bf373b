import { areaOf } from "../kernel/area.ts";
import { difference, intersection } from "../kernel/clip.ts";
import { isDrill } from "../kernel/drill.ts";
import type { Ring } from "../kernel/point.ts";
import { real } from "../kernel/real-area.ts";
import type { Step } from "../kernel/step.ts";
import { inStock } from "./contact.ts";
import { near, type Cutting } from "./cutting.ts";
import type { Edges } from "./edges.ts";
import { holderHits } from "./holder.ts";
import type { Outlines } from "./outlines.ts";
import { largest, placeIn } from "./region.ts";
import type { StockFinding } from "./simulation.ts";
import { sweptBy, type Sweep } from "./sweep.ts";

/** Moves that do damage, after which damage is no longer looked for: looking costs far more where there is some. */
export const MOST_CONTACTS = 1000;
/** The finished part (shrunk) with its edges, to see gouges. */
export interface Finished {
  readonly rings: readonly Ring[];
  readonly edges: Edges;
}

/** The tool stands where a rapid has brought it: what it meets there the rapid has run into. */
const broughtTo = (step: Step): Step => ({ ...step, move: { kind: "rapid", phase: "position", run: "rough", step: 0, to: step.from } });

/** What goes wrong in a step, before its sweep is taken from the stock. */
export function check(step: Step, index: number, outlines: Outlines, sweep: Sweep, cut: Cutting, finished: Finished): StockFinding[] {
  const found: StockFinding[] = [];
  const report = (kind: StockFinding["kind"], rings: Ring[], by: Pick<StockFinding, "block" | "operation"> = step) => {
    if (rings.length > 0)
      found.push({
        kind,
        step: index,
        block: by.block,
        operation: by.operation,
        place: placeIn(largest(rings)),
        area: areaOf(rings),
        rings,
        moves: 1,
      });
  };
  const now = cut.present();
  // The quick look joins many pieces at once; what it finds is looked at again in the stock itself.
  const sure = (area: Ring[]) => (area.length === 0 ? area : real(intersection(cut.stock(), area)));
  const touches = near(sweep, now.meets).length > 0;
  const met = step.broughtBy === undefined ? [] : sure(real(inStock([sweptBy(outlines.checked, broughtTo(step))], now)));
  if (step.broughtBy !== undefined) report("rapidInStock", met, { block: step.broughtBy, operation: null });
  if (touches && step.move.kind === "rapid") {
    const taken = sure(real(inStock([sweep], now)));
    report("rapidInStock", met.length > 0 ? real(difference(taken, met)) : taken);
  }
  // A bore is cut by the shape of the drill: the contours of turning cycles say nothing of it.
  if (touches && !isDrill(step.tool) && sweep.pieces.some((p) => finished.edges.meets(p)))
    report("gouge", sure(real(inStock([sweep], now, finished.rings))));
  report("holderContact", sure(holderHits(step, outlines, now)));
  return found;
}
