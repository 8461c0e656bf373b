import { useRef, useState } from "react";
import { approach } from "../../kernel/approach.ts";
import type { ApproachStatement } from "../../program/approach-draft.ts";
import { approachFields, shapeOf } from "../../program/approach-fields.ts";
import { readyApproach, wordsOfPoint, type ApproachContext } from "../../program/approach-request.ts";
import type { Dragged } from "../../view/approach/drag.ts";
import type { ValueField } from "../dialog/ValueInput.tsx";
import { Icon } from "../Icon.tsx";
import type { Entry } from "../findings/entry.ts";
import { useTexts } from "../settings/use-texts.ts";
import { useFingers } from "../use-fingers.ts";
import { ApproachChooser } from "./ApproachChooser.tsx";
import { ApproachKeypad } from "./ApproachKeypad.tsx";
import { ApproachPicture } from "./ApproachPicture.tsx";
import { withForm } from "./change-form.ts";
import { OpenPrompt } from "./OpenPrompt.tsx";
import { problemsOfBlock } from "./block-problems.ts";
import { useTypedApproach } from "./use-draft.ts";
import { usePrompts } from "./use-prompts.ts";
import { WordList } from "./WordList.tsx";
import { blockName } from "./words.ts";

interface Props {
  readonly statement: ApproachStatement;
  /** What stands round the block: `approachContext` makes it from program and run. */
  readonly context: ApproachContext;
  /** What the last run found at this block. */
  readonly found?: readonly Entry[];
  /** Begins with the choice of a form. */
  readonly choosing?: boolean;
  /** Changes with the same place, one after the other, are one step of undo; null is a step of its own. */
  readonly onChange: (next: ApproachStatement, place: string | null) => void;
}

const numberText = (n: number) => String(Math.round(n * 1000) / 1000 + 0);

/** The dialog of an APPR or DEP block: one prompt open, the drawing of its values, all other prompts one line each. */
export function ApproachDialog({ statement, context, found = [], choosing: first = false, onChange }: Props) {
  const t = useTexts();
  const fingers = useFingers();
  const field = useRef<ValueField | null>(null);
  const [choosing, choose] = useState(first);
  const { form, departing } = statement;
  const fields = approachFields(form, departing, context.plane);
  const { draft, reading, set } = useTypedApproach(statement, context, onChange);
  const prompts = usePrompts(fields, draft, set);
  const ready = readyApproach(form, departing, reading, context);
  const made = ready && approach(ready.request);
  const problems = problemsOfBlock(reading, made?.issues ?? [], found);
  const name = blockName(statement);
  const { open } = prompts;

  const drag = (change: Dragged) => {
    if (change.word !== "point") return set({ [change.word]: numberText(change.word === "CCA" ? change.value : change.value / context.unit) });
    const words = wordsOfPoint(form, change.point, context);
    if (words) set(words);
  };
  const here = open && problems.filter((p) => p.at === open.id || (p.at !== null && !fields.some((f) => f.id === p.at)) || p.at === null);

  return (
    <div className="cycle-dialog approach-dialog" role="form" aria-label={t.approach.form(name)}>
      <div className="approach-title">
        <h2><span className="number">{name}</span> <span className="soft">{t.approach.shapes[shapeOf(form)].name}</span></h2>
        <button type="button" className="button" aria-expanded={choosing} onClick={() => choose(!choosing)}>{t.approach.otherForm}</button>
      </div>
      {choosing
        ? (
          <ApproachChooser
            context={context} chosen={{ shape: shapeOf(form), departing }}
            onChoose={(taken) => {
              choose(false);
              onChange(withForm(statement, taken, context), null);
            }}
          />
        )
        : (
          <>
            {open
              ? (
                <OpenPrompt
                  open={open} place={t.approach.position(fields.indexOf(open) + 1, fields.length)} plane={context.plane} inch={context.unit !== 1}
                  text={draft[open.id] ?? ""} reading={reading[open.id]} problems={here ?? []} prompts={prompts} ownKeypad={fingers} field={field}
                  onText={(text) => set({ [open.id]: text })}
                />
              )
              : (
                <section className="active-prompt dialog-done" aria-label={t.dialog.active} onKeyDown={prompts.onKeyDown}>
                  <h2 className={problems.some((p) => p.issue.severity === "error") ? "done-open" : "done-complete"}>
                    <Icon name={problems.some((p) => p.issue.severity === "error") ? "error" : "check"} />
                    {problems.some((p) => p.issue.severity === "error") ? t.dialog.done.open(new Set(problems.filter((p) => p.issue.severity === "error").map((p) => p.at)).size) : t.dialog.done.title}
                  </h2>
                  <button type="button" className="button" onClick={() => prompts.actions.goTo(fields[0]?.id ?? null)}>{t.dialog.done.first}</button>
                </section>
              )}
            {fingers && open && (
              <ApproachKeypad
                actions={prompts.actions} numeric={open.kind !== "side"} optional={open.optional} incremental={open.increments ?? false}
                change={(by) => {
                  const entry = field.current?.read();
                  field.current?.focus();
                  if (entry) field.current?.write(by(entry));
                }}
              />
            )}
            <div className="below-prompt">
              <div className="help-slot">
                <ApproachPicture key={name} name={name} form={form} ready={ready} context={context} active={open?.id ?? null} onDrag={drag} />
              </div>
              <div className="prompt-list-box" onKeyDown={prompts.onKeyDown}>
                <WordList fields={fields} plane={context.plane} draft={draft} reading={reading} problems={problems} open={open?.id ?? null} goTo={prompts.actions.goTo} inch={context.unit !== 1} />
                {!fingers && <p className="small soft dialog-keys">{t.approach.drag}</p>}
              </div>
            </div>
          </>
        )}
    </div>
  );
}
