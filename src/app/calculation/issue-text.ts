import { createContext, useCallback, useContext } from "react";
import { cycleByNumber } from "../../cycles/index.ts";
import type { Spoken } from "../../i18n/lengths.ts";
import type { Texts } from "../../i18n/index.ts";
import { messageIn } from "../../i18n/sentence.ts";
import type { AnyIssue } from "../../i18n/message-texts.ts";
import type { RunFinding } from "../../program/state/run-types.ts";
import { useLengths } from "./lengths.ts";
import { useTexts } from "../base/settings/use-texts.ts";

/**
 * The sentence of a finding in a screen language, with lengths in the unit of the program. `cycle` decides what the
 * value at its place measures.
 */
export function issueText(texts: Texts, spoken: Spoken, found: AnyIssue, cycle: number | null): string {
  const at = "at" in found ? found.at : undefined;
  const param = cycle === null || at === undefined ? undefined : cycleByNumber(cycle)?.params[at];
  return messageIn(texts, spoken, found, param?.kind);
}

/** A place in the file of a called program, in words. */
export const placeInFile = ({ findings: t }: Texts, { file, block, line }: NonNullable<RunFinding["inFile"]>): string =>
  block === null ? t.lineOf(String(line), file) : t.blockOf(String(block), file);

/** The cycle whose parameters findings may belong to: that of the job, or of the open block. */
export const CycleInWork = createContext<number | null>(null);

/** The sentences of findings in the screen language. */
export function useIssueText(): (found: AnyIssue) => string {
  const texts = useTexts();
  const lengths = useLengths();
  const cycle = useContext(CycleInWork);
  return useCallback((found) => issueText(texts, lengths, found, cycle), [texts, lengths, cycle]);
}
