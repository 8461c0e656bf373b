import { hasNoEffect, type SomeValues } from "../../cycles/effect.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { Kind, Param } from "../../cycles/params.ts";
import { rounded } from "../../kernel/units.ts";

/** One demonstrated value of a parameter: candidates, of which the first with a path is used. */
export interface Candidates {
  readonly tried: readonly (number | "auto")[];
  /** True for the value that the others are compared with. */
  readonly isUsual: boolean;
}

/** Shares of the usual value, the farthest first. */
type Shares = readonly number[];
const LESS: Shares = [0.25, 0.4, 0.6, 0.8];
const MORE: Shares = [4, 2.5, 1.6, 1.2];
const SHARES: Partial<Record<Kind, readonly [less: Shares, more: Shares]>> = {
  feed: [
    [0.5, 0.7, 0.85],
    [2, 1.5, 1.2],
  ],
  radial: [
    [1 / 3, 0.5, 0.75],
    [2, 1.5, 1.2],
  ],
  axialDepth: [
    [1 / 3, 0.5, 0.75],
    [2, 1.5, 1.2],
  ],
  oversizeDiameter: [[0], [5, 3, 2]],
  factor: [
    [0.5, 0.75],
    [1.25, 1.1],
  ],
  percent: [[0.5], [1.5]],
  angle: [[0], [4, 2.5, 1.6, 1.2, 1.1, 1.05]],
  count: [[0.5], [2]],
  revolutions: [[0], [3]],
};
/** Values compared with a value of 0, in the unit of its kind. */
const FROM_ZERO: Partial<Record<Kind, readonly [number, number]>> = {
  feed: [0.1, 0.2],
  radial: [0.5, 1.5],
  axialDepth: [0.5, 1.5],
  oversizeDiameter: [0.4, 2],
  length: [0.5, 2],
  angle: [5, 15],
  revolutions: [1, 3],
  count: [1, 3],
};
/** Shift of a position on the part, as a share of the distance to the other end of the contour. */
const MOVED: Shares = [0.4, 0.25, 0.12, 0.06];
/** Span of a position without another end: this share of it, and at least so many mm. */
const ALONE = 0.3;
const LEAST_SPAN = 10;
/** Variation of the tilt of an insert in the cut, mm: smaller than the shift of a position on the part. */
const TILTED = 0.2;
/** Decimals of candidate values. */
const FINE = { place: 1, value: 3 } as const;

/** Decimals of candidate values of a parameter: counts are whole. */
export const finestOf = ({ kind, decimals }: Pick<Param, "kind" | "decimals">): number =>
  kind === "count" ? 0 : Math.min(decimals, FINE.value);

const to = (value: number, decimals: number) => rounded(Number(value.toFixed(decimals)));
const inRange = ({ range: [min, max] }: Param, values: readonly number[]) => values.filter((v) => v >= min && v <= max);

/** The greatest distance from a position to another one of its kind. */
function spanOf(cycle: Pick<Cycle, "params">, q: string, values: SomeValues, usual: number): number {
  const kind = cycle.params[q]?.kind;
  const others = Object.entries<Param>(cycle.params).flatMap(([other, param]) => {
    const value = values[other];
    return other !== q && param.kind === kind && param.shown === "outline" && typeof value === "number"
      ? [Math.abs(value - usual)]
      : [];
  });
  const span = Math.max(0, ...others);
  return span > 0 ? span : Math.max(LEAST_SPAN, Math.abs(usual) * ALONE);
}

/**
 * The values that demonstrate a parameter: a small, the usual and a large one, or all options of a choice. `values`:
 * all values of its cycle, with the usual one; "auto" is compared with feeds.
 */
export function threeValues(cycle: Pick<Cycle, "params">, q: string, values: SomeValues): readonly Candidates[] {
  const param = cycle.params[q];
  if (!param) return [];
  const usual = values[q] ?? param.example;
  const one = (tried: readonly (number | "auto")[], isUsual = false): readonly Candidates[] =>
    tried.length > 0 ? [{ tried, isUsual }] : [];
  if (param.choices) return param.choices.map((value) => ({ tried: [value], isUsual: value === usual }));
  if (usual === "auto") return [...one(inRange(param, [0.1])), ...one([usual], true), ...one(inRange(param, [0.5]))];
  if (param.shown === "depthCompensation") {
    const tilted = (by: number) => one(inRange(param, [to(usual + by, FINE.value)]));
    return [...tilted(-TILTED), ...one([usual], true), ...tilted(TILTED)];
  }
  if (param.kind === "diameter" || param.kind === "axial") {
    const span = spanOf(cycle, q, values, usual);
    const moved = (sign: number) =>
      inRange(
        param,
        MOVED.map((share) => to(usual + sign * share * span, FINE.place)),
      );
    const inOrder = [...one(moved(-1)), ...one([usual], true), ...one(moved(1))];
    return usual < 0 ? inOrder.reverse() : inOrder;
  }
  const decimals = finestOf(param);
  if (usual === 0) {
    const [some, much] = FROM_ZERO[param.kind] ?? [1, 3];
    return [...one([usual], true), ...one(inRange(param, [some])), ...one(inRange(param, [much]))];
  }
  const [less, more] = SHARES[param.kind] ?? [LESS, MORE];
  const times = (shares: Shares) =>
    [
      ...new Set(
        inRange(
          param,
          shares.map((share) => to(usual * share, decimals)),
        ),
      ),
    ].filter((v) => v !== usual);
  return [...one(times(less)), ...one([usual], true), ...one(times(more))];
}

/** Parameters shown with roughing alone, since finishing would remove their effect. */
const LEFT_BY_ROUGHING: ReadonlySet<Param["shown"]> = new Set(["oversizeDiameter", "oversizeZ", "smoothing"]);
const ROUGHING = 1;

/** Other values of the cycle that make a parameter's effect visible, by Q; empty where it already is. */
export function neededFor(
  cycle: Pick<Cycle, "params">,
  q: string,
  values: SomeValues,
): Readonly<Record<string, number>> {
  const needed: Record<string, number> = {};
  let param = cycle.params[q];
  while (param?.condition && hasNoEffect({ ...param, reserved: false }, values) && !(param.condition.q in needed)) {
    const { q: other, among } = param.condition;
    needed[other] = among.find((value) => value !== 0) ?? among[0] ?? 0;
    param = cycle.params[other];
  }
  const shown = cycle.params[q]?.shown;
  const operation = Object.entries<Param>(cycle.params).find(([, p]) => p.shown === "operation")?.[0];
  if (shown && LEFT_BY_ROUGHING.has(shown) && operation !== undefined && values[operation] !== ROUGHING)
    needed[operation] = ROUGHING;
  return needed;
}
