import type { Clamping } from "../../kernel/area/clamping.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";

/** A blank that is cut by the steps of a run while it runs. Never changed in place. */
export interface TracedBlank {
  /** What stands. */
  readonly stock: readonly Ring[];
  /** The same behind steps, without what has come off. */
  cut(steps: readonly Step[]): TracedBlank;
}

/** Begins to cut a blank: the simulation does it, and is handed to the run by whoever knows both. */
export type Tracing = (blank: readonly Ring[], clamping: Clamping | null) => TracedBlank;
