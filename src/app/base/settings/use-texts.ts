import { use, useEffect, useReducer } from "react";
import type { PartName } from "../../../i18n/parts.ts";
import { fetchTexts, partOf, type ByLanguage, type PartContents } from "./loaded-texts.ts";
import { useSettings } from "./settings.ts";
import { takeAnswer } from "../until-gone.ts";

/** A value in the current screen language. Suspends until it is loaded. */
export function useByLanguage<T>(of: ByLanguage<T>): T {
  const language = useSettings((s) => s.language);
  // A component that has suspended is rendered once more and must use the same promise: otherwise React fails at its
  // further hooks.
  const waited = of.pending(language);
  return waited ? use(waited) : (of.cached(language) ?? use(of.fetchWithRetry(language)));
}

/** A part of the texts in the screen language, by default that of the workplaces. Suspends until it is loaded. */
export const useTexts = <N extends PartName = "workplace">(name = "workplace" as N): PartContents<N> =>
  useByLanguage(partOf(name));

/** The same without suspending: null until it is loaded. */
export function useTextsOrNull<N extends PartName>(name: N): PartContents<N> | null {
  const language = useSettings((s) => s.language);
  const [, showAgain] = useReducer((n: number) => n + 1, 0);
  const part = partOf(name),
    texts = part.cached(language);
  const isHere = texts !== undefined;
  useEffect(
    () => (isHere ? undefined : takeAnswer(async () => await part.fetchWithRetry(language), showAgain)),
    [part, language, isHere],
  );
  return texts ?? null;
}

/** Fetches the texts of the workplaces in the screen language, and further parts. */
export const fetchShownTexts = async (...further: readonly PartName[]): Promise<void> => {
  const { language } = useSettings.getState();
  await Promise.all(["workplace" as const, ...further].map((part) => fetchTexts(language, part)));
};
