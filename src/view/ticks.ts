import { ROUND } from "../kernel/tolerance.ts";
/** Marks of a scale: which values, and how many decimals their labels need. */
export interface Ticks {
  readonly step: number;
  readonly decimals: number;
  readonly values: readonly number[];
}

/** Upper limit of marks on a scale, whatever the request. */
const MOST = 200;

/** Steps of 1, 2 or 5 times a power of ten, at least `apart` units from each other, that fall between two values. */
export function ticks(from: number, to: number, apart: number): Ticks {
  const low = Math.min(from, to),
    high = Math.max(from, to);
  if (!Number.isFinite(low) || !Number.isFinite(high) || !(apart > 0) || !Number.isFinite(apart))
    return { step: 1, decimals: 0, values: [] };
  const wanted = Math.max(apart, (high - low) / MOST);
  const power = 10 ** Math.floor(Math.log10(wanted));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= wanted * (1 - ROUND)) ?? 10 * power;
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + ROUND));
  const first = Math.ceil(low / step - ROUND),
    last = Math.floor(high / step + ROUND);
  return {
    step,
    decimals,
    values: Array.from({ length: Math.max(0, last - first + 1) }, (_, i) =>
      Number(((first + i) * step).toFixed(decimals)),
    ),
  };
}
