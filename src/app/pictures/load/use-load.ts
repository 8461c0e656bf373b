import { useMemo } from "react";
import type { Lengths } from "../../../i18n/lengths.ts";
import { formatNumber } from "../../../i18n/number.ts";
import type { LoadTexts } from "../../../i18n/en/load.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { PathLoad } from "../../../sim/load/along.ts";
import type { RoughStretch } from "../../../sim/load/roughness.ts";
import { greatestAlong, roughestOf, worstOf, type AlongPath, type LoadPlace } from "../../../view/load/values.ts";
import { placeText } from "../lathe/running.ts";
import { useMeasuredLoad, type MeasuredLoad } from "./load-store.ts";

/** A quantity of the colour map. */
export type LoadQuantity = AlongPath | "roughness";

/** Measured data of this run; null for an older one. */
export function useLoadOf(run: Run): MeasuredLoad | null {
  const measured = useMeasuredLoad();
  return measured.run === run ? measured : null;
}

/** The run that the numbers belong to: the previous one until a change is measured. */
export function useMeasuredRun(run: Run): Run {
  const last = useMeasuredLoad((m) => m.run);
  return last?.program.name === run.program.name ? last : run;
}

/** The places of the highest value of each operation, and of all; null until known. */
export function useGreatest(
  run: Run,
  of: LoadQuantity,
): { readonly each: readonly LoadPlace[]; readonly worst: LoadPlace | null } | null {
  const { path, surface } = useLoadOf(run) ?? {};
  return useMemo(() => {
    if (of === "roughness") return surface ? greatest(roughestOf(surface)) : null;
    return path ? greatest(greatestAlong(path, of, run.steps)) : null;
  }, [run, of, path, surface]);
}
const greatest = (each: readonly LoadPlace[]) => ({ each, worst: worstOf(each) });

/** Decimals of each quantity; roughness has one while it is fine. */
const DECIMALS = { depth: 2, chip: 3, feed: 3, speed: 0 } as const;
const FINE = 10;
/** µm in a mm, and µin in an inch by a thousand. */
const MICRONS = 1000;

/** Size of the unit of a quantity: µm or µin, mm or inch, mm² or inch², m/min. */
export function loadSize({ unit, per }: Lengths, of: LoadQuantity): number {
  if (of === "speed" || unit === "mm") return 1;
  return of === "roughness" ? per / MICRONS : of === "chip" ? per ** 2 : per;
}

/** A value with the decimals of its quantity. */
export function loadNumber(lengths: Lengths, of: LoadQuantity, value: number): string {
  const { language } = lengths;
  if (of === "speed") return formatNumber(language, value, DECIMALS.speed);
  if (of === "chip") return lengths.area(value, DECIMALS.chip);
  if (of !== "roughness") return lengths.number(value, DECIMALS[of]);
  const said = value / loadSize(lengths, of);
  return formatNumber(language, said, Number(said < FINE));
}

/** A value with its unit. */
export const loadValue = (t: LoadTexts, lengths: Lengths, of: LoadQuantity, value: number): string =>
  `${loadNumber(lengths, of, value)} ${lengths.words(t.units[of])}`;

/** Text of a row of the path: the value, and its details. */
export function rowText(t: LoadTexts, lengths: Lengths, of: AlongPath, load: PathLoad, row: number): string {
  const value = load[of][row] ?? NaN,
    rpm = load.rpm[row] ?? NaN;
  if (!Number.isFinite(value)) return "–";
  const parts = [loadValue(t, lengths, of, value)];
  if (of === "feed" && Number.isFinite(rpm)) parts.push(lengths.words(t.perMinute(lengths.number(value * rpm, 0))));
  if (of === "speed") parts.push(t.rpm(formatNumber(lengths.language, rpm, 0)));
  if (of === "speed" && load.limited[row] === 1) parts.push(t.limitedLong);
  return parts.join(" · ");
}

/** Share by which the circle must differ from the rule for its value to be shown too. */
const DIFFERS = 0.02;

/** Text of a stretch of the surface: the value and its origin, or why there is none. */
export function stretchText(t: LoadTexts, lengths: Lengths, { rz, exact, by, feed, nose }: RoughStretch): string {
  if (rz === null) return t.by[by];
  const parts = [loadValue(t, lengths, "roughness", rz), t.by[by]];
  if (nose !== null) parts.push(lengths.words(t.feedAndNose(lengths.number(feed), lengths.number(nose))));
  if (by === "nose" && exact !== null && exact > rz * (1 + DIFFERS))
    parts.push(lengths.words(t.exactly(loadNumber(lengths, "roughness", exact))));
  return parts.join(" · ");
}

/** A place in words. */
export function loadPlaceText(t: LoadTexts, lengths: Lengths, { place, block }: LoadPlace): string {
  const { x, z } = placeText(lengths, place);
  return t.place(x, z, String(block));
}
