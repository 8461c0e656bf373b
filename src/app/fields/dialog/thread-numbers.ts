import type { Language } from "../../../i18n/languages.ts";
import { decimalSign, formatNumber } from "../../../i18n/number.ts";
import { decimalsInInches, valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { useSettings } from "../../base/settings/settings.ts";
import type { JobReading } from "../../document/reading.ts";

/** Numbers of a thread as the program of the dialog writes them. */
export interface ThreadNumbers {
  /** A value in mm or degrees at its prompt. */
  readonly at: (q: string, value: number) => string;
  /** The same as it is typed, with a decimal point. */
  readonly typed: (q: string, value: number) => string;
  /** A length in mm. */
  readonly length: (mm: number) => string;
  readonly plain: (n: number) => string;
  /** A designation with the decimal sign of the screen. */
  readonly name: (designation: string) => string;
}

/** A designation with the decimal sign of a language. */
export const designationIn = (language: Language, designation: string): string =>
  designation.replace(/(\d)\.(?=\d)/g, `$1${decimalSign(language)}`);

/** A length that no prompt has. */
const LENGTH = { kind: "length", decimals: 3 } as const;

export function useThreadNumbers({ cycle, inches }: JobReading): ThreadNumbers {
  const language = useSettings((s) => s.language);
  const inInches = inches !== undefined;
  const paramOf = (q: string) => cycle.params[q] ?? LENGTH;
  const write = (param: { readonly kind: string; readonly decimals: number }, value: number) =>
    formatNumber(language, valueInProgram(param, value, inInches), inInches ? decimalsInInches(param) : param.decimals);
  return {
    at: (q, value) => write(paramOf(q), value),
    typed: (q, value) => String(valueInProgram(paramOf(q), value, inInches)),
    length: (mm) => write(LENGTH, mm),
    plain: (n) => formatNumber(language, n),
    name: (designation) => designationIn(language, designation),
  };
}
