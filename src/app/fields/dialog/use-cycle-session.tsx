import { hasNoEffect } from "../../../cycles/effect.ts";
import type { Param } from "../../../cycles/params.ts";
import type { ParamTextId } from "../../../cycles/index.ts";
import { formatNumber, inScreenWriting } from "../../../i18n/number.ts";
import { decimalsInInches, valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { anyNumber, readText } from "../../../program/values/field.ts";
import type { SetupPlace } from "../../../program/job/setup-places.ts";
import type { Draft } from "../../../program/job/read-draft.ts";
import { suggestedValue, type SuggestionContext } from "../../../program/values/suggestion.ts";
import { setPrompt, setPrompts } from "../../document/edits.ts";
import { setPlace } from "../../document/setup-edits.ts";
import { isAboutTool, isError, type FindingEntry } from "../../findings/entry.ts";
import { useFindings } from "../../findings/use-findings.ts";
import { mayTakeKeyboard, openPrompt, enterSection, usePlace } from "../../place/place.ts";
import type { JobReading } from "../../document/reading.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { closeStep } from "../../document/steps.ts";
import { useToolList } from "../../document/work-tools.ts";
import { HelpSlot } from "./HelpSlot.tsx";
import { isSetupPlace, setupPrompts } from "./setup-prompts.ts";
import { promptOf, type Prompt, type PromptSession } from "./session.ts";
import { unitOf, writeValue } from "./write-value.ts";

/** A cycle block of a program: its own problems, and how its prompts are written to its text. */
export interface PromptedBlock {
  /** Its first line in the text, from 1. */
  readonly line: number;
  readonly problems: readonly FindingEntry[];
  readonly set: (q: string, text: string) => void;
  /** Sizes that follow from the stock, suggested at open prompts. */
  readonly sizes?: Draft;
  /** Inserts an operation behind its own. */
  readonly onInsert?: () => void;
  /** Calls another tool for its operation. */
  readonly takeTool?: (T: number) => void;
  /** Several prompts in one step of undo. */
  readonly setAll: (texts: Readonly<Record<string, string>>) => void;
}

/** Context of suggestions: the blank, if it is set. */
function suggestionContext({ job, setup }: JobReading): SuggestionContext {
  const set = (place: SetupPlace, text: string) =>
    setup && !setup.proposed.has(place) ? readText(anyNumber, text).value : null;
  const { outside, bore, allowance } = job.blank;
  return {
    blank: {
      outside: set("blank.outside", outside),
      bore: set("blank.bore", bore),
      front: set("blank.allowance", allowance),
    },
    perRevolution: job.perRevolution,
  };
}

/** The prompts of a cycle: those of the job, or of a block of a program. */
export function useCycleSession(read: JobReading, block: PromptedBlock | null): PromptSession {
  const { cycle, job, draft, reading } = read;
  const inches = read.inches !== undefined;
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const opened = usePlace();
  const all = useFindings();
  const findings = block?.problems ?? all;
  const tools = useToolList();
  const context = suggestionContext(read);
  const { units } = t.dialog;
  const unitText = (param: Param): string => {
    const unit = units[unitOf(param, job.perRevolution)];
    return inches ? unit.replace("mm", "inch") : unit;
  };
  const inProgram = (param: Param, n: number) => valueInProgram(param, n, inches, job.perRevolution);
  const number = (param: Param, n: number) =>
    formatNumber(language, inProgram(param, n), inches ? decimalsInInches(param) : param.decimals);

  const shownOf = (q: string, param: Param): Prompt["shown"] => {
    const field = reading.perField[q];
    if (field?.empty) return { text: field.issue ? t.dialog.noValue : t.dialog.noEntry, unit: "", soft: true };
    const written = field ? writeValue(language, param, field, inches ? (mm) => inProgram(param, mm) : null) : null;
    const bare = written === null || field?.written === "auto";
    return { text: written ?? draft[q] ?? "", unit: bare ? "" : unitText(param), soft: false };
  };
  const asked = ([q, param]: readonly [string, Param]): Prompt => {
    const { prompt, label, explanation, ...words } = t.params[param.text as ParamTextId];
    const meanings: Readonly<Record<number, string>> = "choices" in words ? words.choices : {};
    const idle = hasNoEffect(param, reading.partial);
    const conditionOf = (other: string) => inScreenWriting(language, String(reading.partial[other]));
    const usual = param.optional ? null : suggestedValue(cycle, q, context);
    const suggested = block?.sizes?.[q] ?? (usual === null ? null : inProgram(param, usual));
    return promptOf(
      { id: q, optional: param.optional, decimals: param.decimals },
      { prompt, label, about: explanation },
      {
        page: ["guide", String(cycle.number), q],
        name: t.dialog.value(q, prompt),
        unit: unitText(param),
        range: param.choices ? null : t.dialog.range(number(param, param.range[0]), number(param, param.range[1])),
        notes: [
          ...(param.incremental ? [t.dialog.incremental] : []),
          ...(param.optional ? [t.dialog.optional] : []),
          ...(param.reserved ? [t.dialog.reserved] : []),
          ...(idle && param.condition
            ? [t.dialog.withoutEffect(`${param.condition.q} = ${conditionOf(param.condition.q)}`)]
            : []),
        ],
        choices: param.choices?.map((n) => ({ value: String(n), meaning: meanings[n] ?? "" })) ?? null,
        idle,
        auto: param.kind === "feed",
        shown: shownOf(q, param),
        ...(suggested !== null && { suggestion: String(suggested) }),
      },
    );
  };
  const contourPrompt = (): Prompt => {
    const { question, label, about, elements, none, change } = t.dialog.contour;
    const has = job.contour.length > 0;
    return promptOf(
      { id: "contour", letter: "LBL", optional: true },
      { prompt: question, label, about },
      {
        page: ["guide", "contour"],
        name: label,
        shown: { text: has ? elements(job.contour.length) : none, unit: "", soft: !has },
        hasNoValue: true,
        action: { label: has ? change : t.findings.done.toContour, run: () => enterSection("contour"), needed: !has },
      },
    );
  };
  const setup = setupPrompts(read, t, language, tools);
  const contour = block === null && cycle.contour === "free" ? [contourPrompt()] : [];
  const placeOf = (at: string): string => {
    const place = setup.fields.find((f) => f.id === at);
    if (place) return place.name;
    if (isAboutTool(at)) return t.setup.tool.title;
    const param = cycle.params[at];
    return t.dialog.value(at, param ? t.params[param.text as ParamTextId].label : "");
  };
  /**
   * A fault without a path and without its own prompt is shown at the prompts that shape the contour, and at a changed
   * one.
   */
  const isPathless = (entry: FindingEntry, id: string): boolean =>
    isError(entry) &&
    entry.spot === null &&
    (entry.at === null || isAboutTool(entry.at)) &&
    (cycle.params[id]?.shown === "outline" ||
      (id in cycle.params && id === opened.prompt && draft[id] !== opened.before));
  const set: PromptSession["set"] =
    block?.set ?? ((id, text) => (isSetupPlace(id) ? setPlace(id, text) : setPrompt(id, text)));
  /**
   * A click on a dimension opens its prompt; a long press puts its value into the open one, as its own step of undo.
   */
  const onPick = (q: string, taken: boolean) => {
    const into = opened.prompt;
    if (!taken || into === null || into === q || cycle.params[into]?.choices) return openPrompt(q, draft[q] ?? "");
    closeStep();
    set(into, draft[q] ?? "");
    closeStep();
  };
  return {
    fields: [...setup.fields, ...contour, ...Object.entries<Param>(cycle.params).map(asked)],
    draft: { ...draft, ...setup.draft },
    readings: { ...reading.perField, ...setup.readings },
    findings,
    set,
    setAll: block?.setAll ?? setPrompts,
    idleWith: (id, text) => (other) => {
      const param = cycle.params[other];
      return param !== undefined && hasNoEffect(param, { ...reading.partial, [id]: Number(text) });
    },
    otherFindings: (id) =>
      findings.flatMap((entry) => {
        const concerns =
          entry.at !== null && entry.at !== id && "other" in entry.issue.data && entry.issue.data.other === id;
        if (!concerns && !isPathless(entry, id)) return [];
        return [{ entry, ...(entry.at !== null && { place: placeOf(entry.at) }) }];
      }),
    picture: (
      <HelpSlot
        read={read}
        q={opened.prompt !== null && opened.prompt in cycle.params ? opened.prompt : null}
        onPick={onPick}
      />
    ),
    opened: { id: opened.prompt, before: opened.before, focus: opened.focus },
    open: openPrompt,
    mayFocus: mayTakeKeyboard,
    asksParameters: block === null,
    keypad: "sums",
  };
}
