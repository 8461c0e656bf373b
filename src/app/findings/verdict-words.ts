import type { Texts } from "../../i18n/index.ts";
import type { Language } from "../../i18n/languages.ts";
import { writer } from "../../i18n/write.ts";
import type { Doubt, ShownVerdict } from "./verdict.ts";

type Words = Texts["findings"]["verdict"];

/** The verdict in a few words. */
export function verdictTitle(t: Words, language: Language, { state, doubts, faults, stays, warnings }: ShownVerdict): string {
  if (state === "none") return t.none;
  if (state === "faults") return t.faults(faults);
  const first = doubts[0];
  if (first) return t[first.kind];
  if (stays > 0) return t.stays(writer(language).area(stays));
  return warnings > 0 ? t.warnings(warnings) : t.proved;
}

function because(t: Words["because"], doubt: Doubt): readonly string[] {
  switch (doubt.kind) {
    case "unproved":
      return [doubt.block === null ? t.unprovedAnywhere(doubt.what) : t.unproved(doubt.what, String(doubt.block))];
    case "milling":
      return [t.milling(String(doubt.block))];
    case "nothingCut":
      return [t.nothingCut(String(doubt.cycle), String(doubt.block))];
    case "noOperation":
      return doubt.approachesClear ? [t.noOperation, t.approachesClear] : [t.noOperation];
    case "holderUnknown":
    case "flanksUnknown":
      return [t[doubt.kind](doubt.tools.join(", "))];
  }
}

/** Every reason why a program is not proved, or not wholly, as a sentence each. */
export const verdictReasons = (t: Words, { doubts }: ShownVerdict): readonly string[] =>
  doubts.flatMap((doubt) => because(t.because, doubt));
