import { emptyPlan } from "../kernel/strategy/leveled.ts";
import type { Acting, Cycle, Outline } from "./define.ts";
import type { Params } from "./params.ts";

/** Nothing is turned. */
const NOTHING: Outline = {
  contour: [],
  frame: { transverse: false, signU: 1, signV: 1 },
  sunk: false,
  dimensions: [],
  issues: [],
};

/** A cycle that acts where it is defined: it has neither contour nor path and is no operation. */
export const defineActing = <const P extends Params, const N extends number>(
  cycle: Pick<Cycle<P, N>, "number" | "evidence" | "partly" | "params"> & { readonly acts: Acting },
): Cycle<P, N> => ({
  ...cycle,
  group: "special",
  manual: null,
  contour: "none",
  setup: {
    name: "SPECIAL",
    tool: 1,
    blank: { outside: "75", bore: "", length: "100", allowance: "0" },
    start: { x: "75", z: "2" },
    contour: [],
  },
  steps: { rough: 0, finish: 0 },
  outline: () => NOTHING,
  plan: () => emptyPlan([]),
});
