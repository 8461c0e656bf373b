import { useMemo, useState, type ReactNode } from "react";
import type { Texts } from "../../../i18n/index.ts";
import { formatNumber, formatSigned } from "../../../i18n/number.ts";
import {
  approachDraft,
  approachStatement,
  readApproach,
  SIDES,
  type ApproachDraft,
  type ApproachReading,
  type ApproachStatement,
} from "../../../program/edits/approach-draft.ts";
import { approachFields, type ApproachField, type ApproachWord } from "../../../program/motion/approach-fields.ts";
import type { ApproachContext } from "../../../program/edits/approach-request.ts";
import { approachWords } from "../../../app/fields/blocks/approach-words.ts";
import { promptOf, type Prompt, type PromptSession } from "../../../app/fields/dialog/session.ts";
import type { FindingEntry } from "../../../app/findings/entry.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { createDeferredStore } from "../../../app/base/typing.ts";

/** The typed values of one block. */
export interface TypedApproach {
  readonly draft: ApproachDraft;
  readonly reading: ApproachReading;
  readonly set: (words: ApproachDraft) => void;
}

const same = (a: ApproachStatement, b: ApproachStatement) =>
  a.form === b.form &&
  a.departing === b.departing &&
  JSON.stringify(approachDraft(a)) === JSON.stringify(approachDraft(b));

/** The values of the prompts: as typed, unless the block was changed elsewhere. */
const shownDraft = (
  statement: ApproachStatement,
  { plane, parameters }: ApproachContext,
  typed: ApproachDraft,
): ApproachDraft =>
  same(approachStatement(statement, plane, typed, parameters), statement) ? typed : approachDraft(statement);

/**
 * Typed text of a block. Readable values go into the block at once; others stay in their prompt. A block changed
 * elsewhere (undo, its text) replaces the typed text. `newest`: the newest block, which is rendered a moment after
 * typing. `onTyped` gets whether all typed values are readable.
 */
export function useTypedApproach(
  statement: ApproachStatement,
  context: ApproachContext,
  newest: () => ApproachStatement,
  onChange: (next: ApproachStatement, place: string | null) => void,
  onTyped: (isRead: boolean) => void = () => undefined,
): TypedApproach {
  const { plane, parameters } = context;
  const [useTyped] = useState(() => createDeferredStore(() => ({ draft: approachDraft(statement) })));
  const typed = useTyped((s) => s.draft);
  const draft = useMemo(() => shownDraft(statement, context, typed), [statement, context, typed]);
  return {
    draft,
    reading: useMemo(() => readApproach(statement, plane, draft, parameters), [statement, plane, draft, parameters]),
    set(words) {
      const now = newest(),
        next = { ...shownDraft(now, context, useTyped.getState().draft), ...words };
      useTyped.setState({ draft: next });
      const written = approachStatement(now, plane, next, parameters);
      if (!same(written, now)) onChange(written, Object.keys(words).join(" "));
      onTyped(Object.values(readApproach(now, plane, next, parameters)).every(({ issue }) => issue === null));
    },
  };
}

/** The unit of a word. */
function unitText(t: Texts, { kind }: ApproachField, inch: boolean): string {
  const long = inch ? "inch" : "mm";
  switch (kind) {
    case "length":
      return long;
    case "diameter":
      return inch ? `${long} ⌀` : t.dialog.units.diameter;
    case "angle":
      return "°";
    case "feed":
      return `${long}/min`;
    case "side":
    case "functions":
      return "";
  }
}

interface Shown {
  readonly statement: ApproachStatement;
  readonly context: ApproachContext;
  readonly typed: TypedApproach;
  readonly findings: readonly FindingEntry[];
  readonly picture: (open: ApproachWord | null) => ReactNode;
  /** The first open prompt; the first one if the form lacks it. */
  readonly begins?: string | null;
}

/** The prompts of an APPR or DEP block in the order of the control. */
export function useApproachSession({
  statement,
  context,
  typed,
  findings,
  picture,
  begins = null,
}: Shown): PromptSession {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const { draft, reading } = typed;
  const { plane } = context;
  const fields = approachFields(statement.form, statement.departing, plane);
  const first = (fields.find((f) => f.id === begins) ?? fields[0])?.id ?? null;
  const [opened, setOpened] = useState({
    id: first as string | null,
    before: first ? (draft[first] ?? "") : "",
    focus: 0,
  });
  // The new form may lack this word.
  const open = fields.find((f) => f.id === opened.id)?.id ?? (opened.id === null ? null : first);

  const shownOf = (f: ApproachField): Prompt["shown"] => {
    const text = (draft[f.id] ?? "").trim();
    if (text === "") return { text: f.optional ? t.approach.left : t.approach.empty, unit: "", soft: true };
    const unit = unitText(t, f, context.unit !== 1);
    const { value = null, written = null, incremental = false } = reading[f.id] ?? {};
    if (f.kind === "side" || f.kind === "functions" || value === null || typeof written !== "number")
      return { text, unit, soft: false };
    return {
      text: (incremental ? "I" : "") + (f.range[0] < 0 ? formatSigned(language, value) : text),
      unit,
      soft: false,
    };
  };
  const asked = (f: ApproachField): Prompt => {
    const texts = approachWords(t.approach, f.id, { departing: statement.departing, plane });
    const letter = f.id === "SIDE" ? "RL/RR" : f.id;
    const [min = "", max = ""] = f.range.map((n) => formatNumber(language, n, 4));
    return promptOf({ id: f.id, letter, optional: f.optional, increments: f.increments ?? false }, texts, {
      page: ["guide", `${statement.departing ? "dep" : "appr"}-${statement.form.toLowerCase()}`, f.id],
      name: t.approach.value(letter, texts.prompt),
      unit: unitText(t, f, context.unit !== 1),
      range: f.kind === "side" || f.kind === "functions" ? null : t.dialog.range(min, max),
      notes: [...(f.optional ? [t.dialog.optional] : []), ...(f.increments ? [t.approach.incremental] : [])],
      choices: f.kind === "side" ? SIDES.map((value) => ({ value, meaning: t.approach.sides[value] })) : null,
      shown: shownOf(f),
    });
  };
  return {
    fields: fields.map(asked),
    draft,
    readings: reading,
    findings,
    set: (id, text) => typed.set({ [id]: text }),
    // Issues of the block as a whole, or of a word without a prompt, are shown at every prompt.
    otherFindings: () =>
      findings.flatMap((entry) => {
        if (entry.at === null) return [{ entry }];
        return fields.some((f) => f.id === entry.at) ? [] : [{ entry, place: entry.at }];
      }),
    picture: picture(open),
    opened: { ...opened, id: open },
    open: (id, before) => setOpened((o) => ({ id, before, focus: o.focus + 1 })),
    mayFocus: () => opened.focus > 0,
    asksParameters: false,
    keypad: "words",
  };
}
