import type { Texts } from "../../i18n/index.ts";
import type { Spoken } from "../../i18n/lengths.ts";
import { writer } from "../../i18n/write.ts";
import type { Doubt, ShownVerdict } from "./verdict.ts";

type Words = Texts["findings"]["verdict"];

/** The verdict in a few words. */
export function verdictTitle(
  t: Words,
  spoken: Spoken,
  { state, doubts, faults, file, residualArea, warnings }: ShownVerdict,
): string {
  if (state === "none") return t.none;
  if (state === "faults") return file === null ? t.faults(faults) : t.faultsIn(faults, file);
  const first = doubts[0];
  if (first?.kind === "unproved" && first.file !== undefined) return t.unprovedIn(first.file);
  if (first?.kind === "noOperation" && first.turned) return t.noCycle;
  if (first) return t[first.kind];
  if (residualArea > 0) return t.stays(writer(spoken).area(residualArea));
  return warnings > 0 ? t.warnings(warnings) : t.proved;
}

const whatOf = (t: Words["because"], { what, file }: Extract<Doubt, { kind: "unproved" }>): string =>
  file === undefined ? what : t.whatIn(what, file);

function because(t: Words["because"], doubt: Doubt): readonly string[] {
  switch (doubt.kind) {
    case "unproved":
      return [
        doubt.block === null ? t.unprovedAnywhere(whatOf(t, doubt)) : t.unproved(whatOf(t, doubt), String(doubt.block)),
      ];
    case "milling":
      return [t.milling(String(doubt.block))];
    case "notes":
      return doubt.notes.map((note) => t.notes[note]);
    case "nothingCut":
      return [t.nothingCut(String(doubt.cycle), String(doubt.block))];
    case "noOperation":
      return [doubt.turned ? t.noCycle : t.noOperation, ...(doubt.approachesClear ? [t.approachesClear] : [])];
    case "holderUnknown":
    case "flanksUnknown":
    case "curvatureUnknown":
      return [t[doubt.kind](doubt.tools.join(", "))];
  }
}

/** Every reason why a program is not or only partly verified, one sentence each. */
export const verdictReasons = (t: Words, { doubts }: ShownVerdict): readonly string[] =>
  doubts.flatMap((doubt) => because(t.because, doubt));
