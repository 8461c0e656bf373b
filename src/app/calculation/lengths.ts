import type { Run } from "../../program/state/run-types.ts";
import { createContext, useContext, useMemo } from "react";
import type { Language } from "../../i18n/languages.ts";
import { lengthsIn, type Lengths } from "../../i18n/lengths.ts";
import { IN_MM, type LengthUnit } from "../../kernel/units.ts";
import { useOutcome } from "./outcome.ts";
import { useSettings } from "../base/settings/settings.ts";

/** The unit of the pictured program; null: that of the open work. */
export const CountedIn = createContext<LengthUnit | null>(null);

/** How lengths are written for a program that counts in a unit. */
export const lengthsOf = (language: Language, unit: LengthUnit): Lengths => lengthsIn(language, unit, IN_MM[unit]);

/** How lengths are written here: in the screen language, and in the unit of the program, by default the open one. */
export function useLengths(run?: Pick<Run, "program">): Lengths {
  const language = useSettings((s) => s.language),
    around = useContext(CountedIn);
  const open = useOutcome((s) => s.pictured?.run.program.unit ?? "mm"),
    unit = run?.program.unit ?? around ?? open;
  return useMemo(() => lengthsOf(language, unit), [language, unit]);
}
