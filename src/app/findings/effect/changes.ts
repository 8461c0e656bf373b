import type { Lengths } from "../../../i18n/lengths.ts";
import { formatFixed } from "../../../i18n/number.ts";
import type { Texts } from "../../../i18n/index.ts";
import type { Plan } from "../../../kernel/plan/plan.ts";
import type { Operation } from "../../../program/state/run-types.ts";
import { durationText } from "../../base/clock-text.ts";
import type { MeasuredSetting } from "./compared.ts";

/** The compared numbers, in display order. */
export const COMPARED = ["passes", "infeed", "time", "chip", "residual", "faults"] as const;
export type ComparedNumber = (typeof COMPARED)[number];

const valueOf = ({ effect, chip, faults }: MeasuredSetting, name: ComparedNumber): number | null => {
  if (name === "chip") return chip;
  if (name === "faults") return faults;
  return name === "time" ? effect.seconds : effect[name];
};

/** Smaller areas have more decimals, so that two digits are seen, mm². */
const SMALL = 0.1;

/** Decimals of an area, mm². */
export const areaDecimals = (mm2: number): number =>
  mm2 > 0 && mm2 < SMALL ? Math.min(5, 1 - Math.floor(Math.log10(mm2))) : 2;

/** One number of a setting as text. */
export function numberText(t: Texts, lengths: Lengths, setting: MeasuredSetting, name: ComparedNumber): string {
  const value = valueOf(setting, name),
    { effect: words } = t.page;
  if (value === null) return words.unknown;
  if (name === "residual" && value === 0) return words.none;
  const { language } = lengths;
  if (name === "infeed") return lengths.fixed(value, 3);
  if (name === "chip" || name === "residual") return lengths.fixedArea(value, areaDecimals(value));
  return name === "time" ? durationText(words.duration, language, value) : formatFixed(language, value, 0);
}

/** What differs in an operation. */
export interface ChangedOperation {
  /** Index in the run. */
  readonly operation: number;
  readonly name: "passes" | "infeed" | "time";
  readonly before: string;
  readonly now: string;
}

type Compared = Pick<Operation, "cycle" | "seconds"> & { readonly plan: Pick<Plan, "passes" | "infeed"> };

/**
 * The operations of two runs whose numbers differ, in the order of the run. None if the runs have other operations:
 * then there is nothing to set side by side.
 */
export function changedOperations(
  t: Pick<Texts, "page">,
  lengths: Lengths,
  before: readonly Compared[],
  now: readonly Compared[],
): readonly ChangedOperation[] {
  if (before.length !== now.length || before.some(({ cycle }, i) => cycle !== now[i]?.cycle)) return [];
  const numbers = ({ plan, seconds }: Compared) => ({
    passes: formatFixed(lengths.language, plan.passes, 0),
    infeed: lengths.fixed(plan.infeed, 3),
    time: durationText(t.page.effect.duration, lengths.language, seconds),
  });
  return before.flatMap((each, operation) => {
    const [was, is] = [numbers(each), numbers(now[operation] ?? each)];
    return (["passes", "infeed", "time"] as const)
      .filter((name) => was[name] !== is[name])
      .map((name) => ({ operation, name, before: was[name], now: is[name] }));
  });
}

/** The previous value of a changed number, for a time the difference. Null if it is the same. */
export function changeText(
  t: Texts,
  lengths: Lengths,
  before: MeasuredSetting,
  now: MeasuredSetting,
  name: ComparedNumber,
): string | null {
  const [was, is] = [valueOf(before, name), valueOf(now, name)];
  const text = numberText(t, lengths, before, name);
  if (text === numberText(t, lengths, now, name) && name !== "time") return null;
  if (name !== "time" || was === null || is === null) return text;
  const { duration } = t.page.effect;
  const by = durationText(duration, lengths.language, Math.abs(is - was));
  return by === durationText(duration, lengths.language, 0) ? null : `${is > was ? "+" : "−"}${by}`;
}
