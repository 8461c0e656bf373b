import { saysNothing } from "../../cycles/effect.ts";
import { isRecalled, type Param } from "../../cycles/params.ts";
import type { ParamTextId } from "../../cycles/index.ts";
import { formatNumber } from "../../i18n/number.ts";
import { setPrompt } from "../edits.ts";
import type { FindingEntry } from "../findings/entry.ts";
import { useFindings } from "../findings/use-findings.ts";
import { mayTakeKeyboard, openPrompt, usePlace } from "../place.ts";
import type { JobReading } from "../reading.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { HelpSlot } from "./HelpSlot.tsx";
import type { Prompt, PromptSession } from "./session.ts";
import { unitOf, writeValue } from "./write-value.ts";

/** A cycle block of a program: what is wrong with it only, and how its prompts are written into its text. */
export interface PromptedBlock {
  /** Its first line in the text, from 1. */
  readonly line: number;
  readonly problems: readonly FindingEntry[];
  readonly set: (q: string, text: string) => void;
  /** Several prompts in one step of undo. */
  readonly setAll: (texts: Readonly<Record<string, string>>) => void;
}

/** The prompts of a cycle: those of the job, or of a block of a program. */
export function useCycleSession(read: JobReading, block: PromptedBlock | null): PromptSession {
  const { cycle, job, draft, reading } = read;
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const opened = usePlace();
  const all = useFindings();
  const findings = block?.problems ?? all;
  const { units, evidence } = t.dialog;
  const number = (param: Param, n: number) => formatNumber(language, n, param.decimals);

  const shownOf = (q: string, param: Param): Prompt["shown"] => {
    const field = reading.perField[q];
    if (field?.empty) return { text: field.issue ? t.dialog.noValue : t.dialog.noEntry, unit: "", soft: true };
    const written = field ? writeValue(language, param, field) : null;
    const bare = written === null || field?.written === "auto";
    return { text: written ?? draft[q] ?? "", unit: bare ? "" : units[unitOf(param, job.perRevolution)], soft: false };
  };
  const doubtOf = (param: Param): string | null => {
    if (isRecalled(cycle)) return null;
    if (param.evidence !== "A") return evidence.parameter;
    return param.rangeEvidence !== "A" && !param.choices ? evidence.range : null;
  };
  const promptOf = ([q, param]: readonly [string, Param]): Prompt => {
    const words = t.params[param.text as ParamTextId];
    const meanings: Readonly<Record<number, string>> = "choices" in words ? words.choices : {};
    const idle = saysNothing(param, reading.partial);
    const without = idle && param.counts ? `${param.counts.q} = ${String(reading.partial[param.counts.q])}` : null;
    return {
      id: q,
      letter: q,
      question: words.prompt,
      label: words.label,
      about: words.explanation,
      name: t.dialog.value(q, words.prompt),
      unit: units[unitOf(param, job.perRevolution)],
      range: param.choices ? null : t.dialog.range(number(param, param.range[0]), number(param, param.range[1])),
      notes: [
        ...(param.incremental ? [t.dialog.incremental] : []),
        ...(param.optional ? [t.dialog.optional] : []),
        ...(param.reserved ? [t.dialog.reserved] : []),
        ...(without === null ? [] : [t.dialog.withoutEffect(without)]),
      ],
      doubt: doubtOf(param),
      choices: param.choices?.map((n) => ({ value: String(n), meaning: meanings[n] ?? "" })) ?? null,
      optional: param.optional,
      idle,
      increments: false,
      auto: param.kind === "feed",
      decimals: param.decimals,
      shown: shownOf(q, param),
    };
  };
  const placeOf = (at: string): string => {
    const param = cycle.params[at];
    return t.dialog.value(at, param ? t.params[param.text as ParamTextId].label : "");
  };
  return {
    fields: Object.entries<Param>(cycle.params).map(promptOf),
    draft,
    readings: reading.perField,
    findings,
    set: block?.set ?? setPrompt,
    besides: (id) =>
      findings.flatMap((entry) => {
        const concerns = entry.at !== null && entry.at !== id && "other" in entry.issue.data && entry.issue.data.other === id;
        return concerns && entry.at !== null ? [{ entry, place: placeOf(entry.at) }] : [];
      }),
    picture: <HelpSlot read={read} q={opened.prompt} />,
    opened: { id: opened.prompt, before: opened.before, focus: opened.focus },
    open: openPrompt,
    mayFocus: mayTakeKeyboard,
    asksParameters: block === null,
    keypad: "sums",
  };
}
