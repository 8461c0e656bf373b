import type { Clamping } from "../../kernel/area/clamping.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";

/** A blank that is cut by the steps during a run. Immutable. */
export interface TracedBlank {
  /** Remaining stock. */
  readonly stock: readonly Ring[];
  /** The blank after some steps, without loose pieces. */
  cut(steps: readonly Step[]): TracedBlank;
}

/** Starts tracing a blank. The simulation implements it; a caller that knows both injects it. */
export type Tracing = (blank: readonly Ring[], clamping: Clamping | null) => TracedBlank;
