import type { Clamping } from "../kernel/area/clamping.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { cutting } from "./cutting.ts";
import { brokenApart, holdOf } from "./held.ts";
import { outlinesOf } from "./outlines.ts";
import { sweptBy } from "./sweep.ts";

/**
 * Cuts a blank step by step, without looking at what the steps do wrong. What comes off is gone when it is asked for
 * next.
 */
export function tracing(
  blank: readonly Ring[],
  clamping: Clamping | null,
): { add(step: Step): void; stock(): readonly Ring[] } {
  const outlines = outlinesOf();
  const hold = holdOf(blank, clamping);
  let cut = cutting(blank);
  return {
    add: (step) => cut.add(sweptBy(outlines(step.tool).insert, step)),
    stock() {
      const stock = cut.stock();
      cut = cutting((hold && brokenApart(stock, hold)?.held) ?? stock);
      return cut.initial;
    },
  };
}
