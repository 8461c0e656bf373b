import type { Clamping } from "../kernel/area/clamping.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { sameHold } from "./held.ts";
import { sameRings, sameSteps } from "./same-step.ts";
import { tracing } from "./tracing.ts";

/** What stood after so many steps of a blank. */
interface Stage {
  readonly steps: readonly Step[];
  readonly stock: readonly Ring[];
}

/** A blank that was traced. */
interface Traced {
  readonly blank: readonly Ring[];
  readonly clamping: Clamping | null;
  readonly stages: readonly Stage[];
}

/**
 * Traces blanks of one run after the other: what stood after the same steps is not cut again. `next` begins another
 * run; the blanks of a run are traced in the order in which it states them.
 */
export function tracingAgain(): { readonly tracing: typeof tracing; next(): void } {
  let [now, before]: [Traced[], readonly Traced[]] = [[], []];
  return {
    next() {
      [now, before] = [[], now];
    },
    tracing(blank, clamping) {
      const same = sameSteps();
      const former = before[now.length];
      const stages: Stage[] = [];
      now.push({ blank, clamping, stages });
      let steps: Step[] = [];
      let stock = blank;
      let known = former !== undefined && sameRings(former.blank, blank) && sameHold(former.clamping, clamping);
      return {
        add: (step) => void steps.push(step),
        stock() {
          const stage = known ? former?.stages[stages.length] : undefined;
          known =
            stage !== undefined &&
            stage.steps.length === steps.length &&
            stage.steps.every((s, i) => same(s, steps[i] as Step));
          if (stage && known) ({ stock } = stage);
          else {
            const cut = tracing(stock, clamping);
            steps.forEach(cut.add);
            stock = cut.stock();
          }
          stages.push({ steps, stock });
          steps = [];
          return stock;
        },
      };
    },
  };
}
