import type { MachineTexts } from "../../../i18n/en/machine.ts";
import { SCREEN_LANGUAGES, type Language } from "../../../i18n/languages.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { timesOf } from "../../../program/run/run-times.ts";
import type { Run, TimePart } from "../../../program/state/run-types.ts";

const CAUSES = ["cutting", "rapid", "dwell", "toolChange", "spindle"] as const;
const ALWAYS: readonly (typeof CAUSES)[number][] = ["cutting", "rapid"];
const LACKED = ["acceleration", "toolChange", "spindle"] as const satisfies readonly TimePart[];

/** The time of a run by cause, in seconds; causes without time are left out. */
export function timeCauses(t: MachineTexts["time"], run: Run): readonly (readonly [name: string, seconds: number])[] {
  const times = timesOf(run);
  return CAUSES.filter((cause) => times[cause] > 0 || ALWAYS.includes(cause)).map((cause) => [
    t.causes[cause],
    times[cause],
  ]);
}

/** The data that a time is calculated with, and what it does not include. */
export function timeContents(
  t: MachineTexts["time"],
  { timing: { machine, rates, contains } }: Run,
  language: Language,
): readonly string[] {
  const meters = (rate: number) => formatNumber(language, rate / 1000, 3);
  const lacked = LACKED.filter((part) => !contains.includes(part)).map((part) => t.lacks[part]);
  return [
    machine === null ? t.noMachine : t.machine(machine),
    typeof rates === "number" ? t.rate(meters(rates)) : t.rates(meters(rates.x), meters(rates.z)),
    ...(lacked.length > 0 ? [t.without(lacked.join(SCREEN_LANGUAGES[language].comma))] : []),
  ];
}
