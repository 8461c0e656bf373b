import type { Param } from "../../../cycles/params.ts";
import type { Language } from "../../../i18n/languages.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { decimalsInInches, valueInProgram } from "../../../program/blocks/cycle-values.ts";
import type { DraftInches } from "../../../program/job/read-draft.ts";

/** Writes values in mm in the screen language, and for a program in inches in that unit. */
export const numberIn =
  (language: Language, inches: DraftInches | null) =>
  (mm: number, decimals: number, { kind }: Pick<Param, "kind">): string =>
    inches
      ? formatNumber(
          language,
          valueInProgram({ kind }, mm, true, inches.perRevolution),
          decimalsInInches({ kind, decimals }),
        )
      : formatNumber(language, mm, decimals);
