import { useEffect, useState } from "react";
import type { Issue } from "../../../kernel/plan/issue.ts";
import { approach } from "../../../kernel/plane/approach.ts";
import type { ApproachReading, ApproachStatement } from "../../../program/edits/approach-draft.ts";
import { shapeOf } from "../../../program/motion/approach-fields.ts";
import { readyApproach, wordsOfPoint, type ApproachContext } from "../../../program/edits/approach-request.ts";
import { positionAsTyped } from "../../../program/values/typed-value.ts";
import type { Dragged } from "../../../view/approach/drag.ts";
import { onPromptKey } from "../../../app/fields/dialog/prompt-keys.ts";
import { PromptDialog } from "../../../app/fields/dialog/PromptDialog.tsx";
import { commandsOf, type PromptSession } from "../../../app/fields/dialog/session.ts";
import { entryAt, isError, type FindingEntry } from "../../../app/findings/entry.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { ApproachChooser } from "./ApproachChooser.tsx";
import { ApproachPicture } from "./ApproachPicture.tsx";
import { withForm } from "./change-form.ts";
import { useApproachSession, useTypedApproach } from "./use-approach-session.tsx";

interface Props {
  readonly statement: ApproachStatement;
  /** The newest block, which is rendered a moment after typing. */
  readonly newest?: () => ApproachStatement;
  /** The surroundings of the block: `approachContext` makes them from program and run. */
  readonly context: ApproachContext;
  /** Findings of the last run at this block. */
  readonly found?: readonly FindingEntry[];
  /** Starts with the choice of a form. */
  readonly choosing?: boolean;
  /** Consecutive changes with the same place are one step of undo; null is a separate step. */
  /** The first open prompt, and the callback for each one opened. */
  readonly begins?: string | null;
  readonly onOpen?: (word: string | null) => void;
  readonly onChange: (next: ApproachStatement, place: string | null) => void;
  readonly onTyped?: (isRead: boolean) => void;
}

const weight = { error: 0, warning: 1, info: 2 } as const;
const placed = (issue: Issue): FindingEntry => entryAt(issue, issue.at ?? null, null);

/** All issues of one block, worst first, without duplicates: of its words, its geometry and the run. */
function approachProblems(
  reading: ApproachReading,
  made: readonly Issue[],
  found: readonly FindingEntry[],
): readonly FindingEntry[] {
  const typed = Object.values(reading).flatMap((r) => (r.issue ? [placed(r.issue)] : []));
  const taken = new Set(typed.map((p) => p.at));
  const more = [...made.map(placed), ...found].filter((p) => p.at === null || !taken.has(p.at));
  const all = new Map([...typed, ...more].map((p) => [`${p.issue.code} ${p.at ?? ""}`, p]));
  return [...all.values()].sort((a, b) => weight[a.issue.severity] - weight[b.issue.severity]);
}

/** The end of the dialog: the remaining faults. */
function ApproachDone({ session }: { readonly session: PromptSession }) {
  const {
    dialog: { active, done: t },
  } = useTexts();
  const wrong = new Set(session.findings.filter(isError).map((p) => p.at)).size;
  return (
    <section
      className="active-prompt dialog-done"
      aria-label={active}
      onKeyDown={(event) => onPromptKey(event, session)}
    >
      <h2 className={wrong > 0 ? "done-open" : "done-complete"}>
        <Icon name={wrong > 0 ? "error" : "check"} />
        {wrong > 0 ? t.open(wrong) : t.title}
      </h2>
      <button type="button" className="button" onClick={() => commandsOf(session).goTo(session.fields[0]?.id ?? null)}>
        {t.first}
      </button>
    </section>
  );
}

/** The dialog of an APPR or DEP block: one open prompt, the drawing of its values, all other prompts one line each. */
export function ApproachDialog({
  statement,
  newest = () => statement,
  context,
  found = [],
  choosing: first = false,
  begins = null,
  onOpen,
  onChange,
  onTyped,
}: Props) {
  const { approach: t } = useTexts();
  const [choosing, choose] = useState(first);
  const { form, departing } = statement;
  const name = `${departing ? "DEP" : "APPR"} ${form}`;
  const typed = useTypedApproach(statement, context, newest, onChange, onTyped);
  const ready = readyApproach(form, departing, typed.reading, context);
  const made = ready && approach(ready.request);

  const drag = (change: Dragged) => {
    if (change.word !== "point")
      return typed.set({
        [change.word]: positionAsTyped(change.word === "CCA" ? change.value : change.value / context.unit),
      });
    const words = wordsOfPoint(form, change.point, context);
    if (words) typed.set(words);
  };
  const session = useApproachSession({
    statement,
    context,
    typed,
    begins,
    findings: approachProblems(typed.reading, made?.issues ?? [], found),
    picture: (active) => (
      <div className="help-slot">
        <ApproachPicture
          key={name}
          name={name}
          form={form}
          ready={ready}
          context={context}
          active={active}
          onDrag={drag}
        />
      </div>
    ),
  });

  const { id: asked } = session.opened;
  useEffect(() => onOpen?.(asked), [onOpen, asked]);

  return (
    <PromptDialog
      session={session}
      className="approach-dialog"
      name={t.form(name)}
      listName={t.list}
      hint={t.drag}
      done={<ApproachDone session={session} />}
      head={
        <div className="approach-title">
          <h2>
            <span className="number">{name}</span> <span className="soft">{t.shapes[shapeOf(form)].name}</span>
          </h2>
          <button type="button" className="button" aria-expanded={choosing} onClick={() => choose(!choosing)}>
            {t.otherForm}
          </button>
        </div>
      }
      instead={
        choosing ? (
          <ApproachChooser
            context={context}
            chosen={statement}
            onChoose={(taken, polar) => {
              choose(false);
              onChange(withForm(statement, taken, context, polar), null);
            }}
          />
        ) : null
      }
    />
  );
}
