import { Suspense, useEffect, useRef, useState } from "react";
import { isUnsimulated } from "../../cycles/unsimulated-cycles.ts";
import { withBlock } from "../../nc/edit.ts";
import { blockNumbers, startLines, type Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import { enterNext } from "../../app/fields/number/enter-next.ts";
import { FieldMessage } from "../../app/fields/number/FieldMessage.tsx";
import type { FindingEntry } from "../../app/findings/entry.ts";
import { FIRST_FOCUS } from "../../app/base/focus-guard.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { Message } from "../../app/base/Message.tsx";
import { CalledTool } from "./operations/CalledTool.tsx";
import { DescribeCycle } from "../../app/fields/own/DescribeCycle.tsx";
import { useGuidedBlock } from "../../app/place/open-call.ts";
import { useOutcome, type Outcome } from "../../app/calculation/outcome.ts";
import { askForOperation } from "../../app/document/inserting.ts";
import { showFile, useShownOtherFile } from "../../app/document/shown-file.ts";
import { placeInFile } from "../../app/calculation/issue-text.ts";
import { operationAt } from "../../program/edits/operations.ts";
import { fileKey } from "../../program/state/program-files.ts";
import { useEditor } from "../../app/document/store.ts";
import { fileOf } from "../../app/document/work.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { BlockField } from "./BlockField.tsx";
import { openingBlock } from "../../app/fields/blocks/operation-rows.ts";
import { fieldsOf } from "../../app/fields/blocks/block-fields.ts";
import { kindOf } from "../../app/fields/blocks/block-kind.ts";
import { BlockMore } from "./BlockMore.tsx";
import { editProgram, openBlock, readWhole, useSession } from "../../app/fields/blocks/session.ts";

/** Marks the button of the next step, where the control waits after the last word of a block. */
export const NEXT_STEP = "data-next-step";
const onEnter = enterNext(".block-insert", (from) =>
  from.closest(".block-panel")?.querySelector<HTMLElement>(`[${NEXT_STEP}]`),
);

/** Blocks have no nearest value to offer. */
const nothing = () => undefined;

/** Findings that say that a block is kept but not simulated. */
const NOT_SIMULATED_CODES: ReadonlySet<string> = new Set(["cycleNotSimulated", "notSimulated", "notUnderstood"]);

/** The definition of the called cycle, if it is in a called program; null if it is not, or unknown. */
function definedElsewhere(outcome: Outcome | null, call: number | undefined) {
  const found = outcome?.run.operations.find(({ block, definedFile }) => block === call && definedFile !== undefined);
  const { program } = useEditor.getState();
  if (found?.definedFile === undefined || !program || !fileOf(program, fileKey(found.definedFile))) return null;
  return { file: found.definedFile, block: found.definedIn, line: found.definedLine };
}

/** After the guide page of a word, its field gets focus again. */
function backToWord(form: HTMLElement | null): void {
  const { block } = useGuidedBlock.getState();
  if (!form || !block?.word || block.work !== useEditor.getState().work) return;
  useGuidedBlock.setState({ block: { ...block, word: null } });
  form.querySelector<HTMLElement>(`[data-word="${CSS.escape(block.word)}"]`)?.focus();
}

/** Fields whose links to the guide are shown at once; more of them are behind one button. */
const FEW_LINKS = 2;

/** Whether a block turns: X is a diameter there. */
const isTurnedAt = ({ blocks }: Program, index: number): boolean => {
  const mode = blocks.slice(0, index).findLast(({ statement }) => statement.kind === "mode")?.statement;
  return mode?.kind === "mode" && mode.mode === "TURN";
};

/** The dialog of a block that is no catalogue cycle: one field per word, from the description of its kind. */
export function BlockForm({ problems }: { readonly problems: readonly FindingEntry[] }) {
  const all = useTexts();
  const { editor: t } = all;
  const file = useShownOtherFile();
  const newest = useOutcome((s) => s.newest);
  const {
    reading: { program },
    index,
  } = useSession();
  const form = useRef<HTMLDivElement>(null);
  const [hasLinks, showLinks] = useState(false);
  const block = program.blocks[index];
  useEffect(() => backToWord(form.current), []);
  if (!block) return null;
  const s = block.statement;
  const line = startLines(program)[index] ?? 1,
    kind = kindOf(s),
    fields = fieldsOf(s),
    isTurned = isTurnedAt(program, index);
  const hasPages = kind !== "unknown" && kind !== "empty";
  const change = (next: Statement, field: string) =>
    editProgram(withBlock(program, index, next), `block ${index} ${field}`);
  const away = s.kind === "cycleCall" && file === null ? definedElsewhere(newest, blockNumbers(program)[index]) : null;
  const definition =
    s.kind === "cycleCall" && !away
      ? program.blocks.slice(0, index).findLastIndex((b) => b.statement.kind === "cycle")
      : -1;
  // Where an operation opens, its last word leads on to the next one, as the end of the prompts of a cycle does.
  const unit = file === null ? operationAt(program, index) : null;
  const opens = unit !== null && openingBlock(program, unit) === index;
  const numbers = definition >= 0 ? blockNumbers(program) : [];
  return (
    <div className="block-form" ref={form} role="form" aria-label={t.form}>
      <code className="number block-text">{block.raw.trimEnd()}</code>
      {(s.kind === "unknown" || (s.kind === "cycle" && isUnsimulated(s.cycle))) &&
        !problems.some(({ issue }) => NOT_SIMULATED_CODES.has(issue.code)) && <Message tone="info">{t.kept}</Message>}
      {s.kind === "cycle" && (
        <Suspense>
          <DescribeCycle statement={s} />
        </Suspense>
      )}
      {s.kind === "toolCall" && <CalledTool key={index} statement={s} change={(next) => change(next, "tool chosen")} />}
      {fields.length > FEW_LINKS && hasPages && (
        <button
          type="button"
          className="button plain small block-links"
          aria-expanded={hasLinks}
          onClick={() => showLinks(!hasLinks)}
        >
          <Icon name="question" /> {t.moreOnWords}
        </button>
      )}
      <div className="block-words" onKeyDown={onEnter} {...{ [FIRST_FOCUS]: "" }}>
        {fields.map((field) => (
          <BlockField
            key={`${index} ${field.id}`}
            field={field}
            statement={s}
            change={change}
            isTurned={isTurned}
            more={
              hasPages &&
              (hasLinks || fields.length <= FEW_LINKS) && <BlockMore kind={kind} field={field} line={line} />
            }
          />
        ))}
        {opens && (
          <button type="button" className="button block-insert" onClick={() => askForOperation(unit)}>
            <Icon name="add" /> {all.operations.insert}
          </button>
        )}
        {definition >= 0 && (
          <button type="button" className="button" onClick={() => openBlock(definition)}>
            {t.goToDefinition(String(numbers[definition] ?? 0))}
          </button>
        )}
        {away && (
          <button
            type="button"
            className="button"
            onClick={() => {
              showFile(away.file);
              readWhole();
              openBlock(startLines(useSession.getState().reading.program).indexOf(away.line));
            }}
          >
            {t.goToDefinitionIn(String(away.block), away.file)}
          </button>
        )}
      </div>
      <div role="status">
        {problems.map((problem, i) => (
          <FieldMessage
            key={i}
            problem={problem}
            decimals={3}
            onTake={nothing}
            {...(problem.inFile && { place: placeInFile(all, problem.inFile) })}
          />
        ))}
      </div>
    </div>
  );
}
