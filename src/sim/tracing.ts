import type { Clamping } from "../kernel/area/clamping.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { cutting } from "./cutting.ts";
import { brokenApart, holdOf } from "./work-holding.ts";
import { outlinesOf } from "./outlines.ts";
import { sweptBy } from "./sweep.ts";

/** A blank being cut: its stock, and the state after further steps, without loose pieces. */
interface Traced {
  readonly stock: readonly Ring[];
  cut(steps: readonly Step[]): Traced;
}

/** Starts cutting a blank without checking for damage. */
export function traceStock(blank: readonly Ring[], clamping: Clamping | null): Traced {
  const outlines = outlinesOf();
  const hold = holdOf(blank, clamping);
  const standing = (stock: readonly Ring[]): Traced => ({
    stock,
    cut(steps) {
      const cut = cutting(stock);
      for (const step of steps) cut.add(sweptBy(outlines(step.tool).insert, step));
      const left = cut.stock();
      return standing((hold && brokenApart(left, hold)?.held) ?? left);
    },
  });
  return standing(blank);
}
