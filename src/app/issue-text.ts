import { createContext, useCallback, useContext } from "react";
import { cycleByNumber } from "../cycles/index.ts";
import type { Language } from "../i18n/languages.ts";
import type { Texts } from "../i18n/index.ts";
import type { AnyIssue } from "../i18n/message-texts.ts";
import { writer, type Write } from "../i18n/write.ts";
import type { RunFinding } from "../program/run-types.ts";
import { useSettings } from "./settings/settings.ts";
import { useTexts } from "./settings/use-texts.ts";

/** The sentence of a finding in a screen language; `cycle` tells what the value at its place measures. */
export function issueText(texts: Texts, language: Language, found: AnyIssue, cycle: number | null): string {
  const at = "at" in found ? found.at : undefined;
  const param = cycle === null || at === undefined ? undefined : cycleByNumber(cycle)?.params[at];
  const say = texts.messages.of[found.code] as (data: AnyIssue["data"], write: Write) => string;
  return say(found.data, writer(language, param?.kind));
}

/** Where something stands in the file of a called program, in words. */
export const placeInFile = ({ findings: t }: Texts, { file, block, line }: NonNullable<RunFinding["inFile"]>): string =>
  block === null ? t.lineOf(String(line), file) : t.blockOf(String(block), file);

/** The cycle whose parameters findings may stand at: that of the job, or of the open block. */
export const CycleInWork = createContext<number | null>(null);

/** Says findings in the screen language. */
export function useIssueText(): (found: AnyIssue) => string {
  const texts = useTexts();
  const language = useSettings((s) => s.language);
  const cycle = useContext(CycleInWork);
  return useCallback((found) => issueText(texts, language, found, cycle), [texts, language, cycle]);
}
