import type { Ring } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { cutting } from "./cutting.ts";
import { outlinesOf } from "./outlines.ts";
import { sweptBy } from "./sweep.ts";

/** Cuts a blank step by step, without looking at what the steps do wrong. */
export function tracing(blank: readonly Ring[]): { add(step: Step): void; stock(): readonly Ring[] } {
  const outlines = outlinesOf();
  let cut = cutting(blank);
  return {
    add: (step) => cut.add(sweptBy(outlines(step.tool).insert, step)),
    stock() {
      cut = cutting(cut.stock());
      return cut.initial;
    },
  };
}
