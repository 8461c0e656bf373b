import type { PlayedTrack } from "./playback.ts";

/** What the bar shows of one motion. */
export interface TimedStep {
  readonly move: { readonly kind: string };
  readonly operation: number | null;
}

/** The bar of a run: 0 to 1 is its whole time. */
export interface TimeBar {
  /** Cutting and rapid stretches, one path each, in a box 1 wide and 1 high. */
  readonly cutting: string;
  readonly rapid: string;
  /** Boundaries of moves, those too near to the last one left out. */
  readonly boundaries: readonly number[];
  readonly operations: readonly { readonly operation: number; readonly from: number; readonly to: number }[];
}

/** The operation at a share of the bar; null between operations. */
export const operationAt = ({ operations }: Pick<TimeBar, "operations">, at: number): number | null =>
  operations.findLast(({ from, to }) => from <= at && at <= to)?.operation ?? null;

/** How many colours of tools there are. */
export const TOOL_TONES = 8;

/** The colour of each operation: that of its tool, in the order in which the tools are first used. */
export function toolTones(tools: readonly number[]): readonly number[] {
  const order = [...new Set(tools)];
  return tools.map((tool) => order.indexOf(tool) % TOOL_TONES);
}

/** Boundaries closer together than this share of the bar would only turn it grey. */
const NEAR = 0.006;
/** Stretches of one kind this close together, as a share of the bar, are merged: no screen shows the gap. */
const ONE = 1 / 8000;

const n = (v: number) => String(Math.round(v * 1e5) / 1e5);

interface Stretched {
  readonly from: number;
  to: number;
}

const barsOf = (stretches: readonly Stretched[]): string =>
  stretches.map(({ from, to }) => `M${n(from)} 0H${n(to)}V1H${n(from)}Z`).join("");

/** Merges the steps of a run into stretches: rapids low, cutting high. */
export function timeBar(steps: readonly TimedStep[], track: PlayedTrack): TimeBar {
  const whole = track.total > 0 ? track.total : 1;
  const cutting: Stretched[] = [],
    rapid: Stretched[] = [],
    boundaries: number[] = [];
  const operations: { operation: number; from: number; to: number }[] = [];
  let from = 0;
  steps.forEach((step, i) => {
    const to = (track.ends[i] ?? 0) / whole,
      kind = step.move.kind === "rapid" ? rapid : cutting,
      last = kind.at(-1);
    if (last && from - last.to < ONE) last.to = to;
    else if (to > from) kind.push({ from, to });
    if (to - (boundaries.at(-1) ?? 0) > NEAR && to < 1) boundaries.push(to);
    const open = operations.at(-1),
      joins = open && step.operation === open.operation && steps[i - 1]?.operation === step.operation;
    if (joins) open.to = to;
    else if (step.operation !== null) operations.push({ operation: step.operation, from, to });
    from = to;
  });
  return { cutting: barsOf(cutting), rapid: barsOf(rapid), boundaries, operations };
}
