import type { Lengths } from "../../i18n/lengths.ts";
import { formatFixed } from "../../i18n/number.ts";
import type { Texts } from "../../i18n/index.ts";
import type { MeasuredSetting } from "./before.ts";

/** The numbers that are compared, in the order in which they stand. */
export const COMPARED = ["passes", "infeed", "time", "chip", "residual", "faults"] as const;
export type ComparedNumber = (typeof COMPARED)[number];

const DECIMALS: Readonly<Record<ComparedNumber, number>> = { passes: 0, infeed: 3, time: 1, chip: 2, residual: 2, faults: 0 };

const valueOf = ({ effect, chip, faults }: MeasuredSetting, name: ComparedNumber): number | null => {
  if (name === "chip") return chip;
  if (name === "faults") return faults;
  return name === "time" ? effect.seconds : effect[name];
};

/** One number of a setting as it is written. */
export function numberText(t: Texts, lengths: Lengths, setting: MeasuredSetting, name: ComparedNumber): string {
  const value = valueOf(setting, name), { effect: words } = t.page;
  if (value === null) return words.unknown;
  if (name === "residual" && value === 0) return words.none;
  const { language } = lengths;
  if (name === "infeed") return lengths.fixed(value, DECIMALS.infeed);
  if (name === "chip" || name === "residual") return lengths.fixedArea(value, DECIMALS[name]);
  if (name !== "time") return formatFixed(language, value, DECIMALS[name]);
  const minutes = Math.floor(Math.round(value) / 60);
  return words.duration(minutes, formatFixed(language, minutes > 0 ? value - minutes * 60 : value, minutes > 0 ? 0 : 1));
}

/** What stands beside a number that another setting has changed: what it was, or for a time by how much. Null where it is the same. */
export function changeText(t: Texts, lengths: Lengths, before: MeasuredSetting, now: MeasuredSetting, name: ComparedNumber): string | null {
  const [was, is] = [valueOf(before, name), valueOf(now, name)];
  const text = numberText(t, lengths, before, name);
  if (text === numberText(t, lengths, now, name) && name !== "time") return null;
  if (name !== "time" || was === null || is === null) return text;
  const { language } = lengths, by = formatFixed(language, Math.abs(is - was), DECIMALS.time);
  if (by === formatFixed(language, 0, DECIMALS.time)) return null;
  return t.page.effect.longer(`${is > was ? "+" : "−"}${by}`);
}
