import { useId } from "react";
import type { Issue } from "../../kernel/plan/issue.ts";
import { readAxis } from "../../program/tools/holder-cells.ts";
import { HOLDER_NUMBERS } from "../../program/tools/tool-columns.ts";
import { cellOf, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { setCell } from "./tool-edits.ts";
import { closeStep } from "../../app/document/steps.ts";
import { ChoiceField } from "./ChoiceField.tsx";
import { CellMessages, ToolField } from "./ToolField.tsx";

interface Props {
  readonly entry: ToolEntry;
  readonly issues: readonly Issue[];
}

/** The axis of the shank; an invalid axis from a file stays visible. */
function AxisField({ entry, issues }: Props) {
  const t = useTexts("tables").tools;
  return (
    <ChoiceField
      entry={entry}
      cell="axis"
      issues={issues}
      value={readAxis(cellOf(entry, "axis"))}
      choices={["", "X", "Z"]}
      words={t.axes}
      label={<span className="soft small">{t.holder.axis}</span>}
    />
  );
}

/** The outline between shank and insert, by its corners. */
function HeadField({ entry, issues }: Props) {
  const t = useTexts("tables").tools;
  const id = useId();
  const text = cellOf(entry, "head");
  const found = issues.filter((issue) => issue.at === "head");
  return (
    <div className="tool-field wide">
      <label htmlFor={id}>
        <span className="soft small">{t.holder.head}</span>
      </label>
      <textarea
        id={id}
        className="input number head"
        rows={2}
        autoComplete="off"
        spellCheck={false}
        maxLength={500}
        aria-invalid={found.length > 0}
        aria-describedby={`${id}-hint ${id}-wrong`}
        value={text}
        onChange={(e) => setCell(entry.id, "head", e.currentTarget.value)}
        onBlur={closeStep}
      />
      <span className="soft small" id={`${id}-hint`}>
        {t.headHint}
      </span>
      <CellMessages id={`${id}-wrong`} issues={found} text={text} />
    </div>
  );
}

/** The holder of a tool: four numbers and an axis for the shank, and the outline of the head. */
export function HolderFields({ entry, issues }: Props) {
  return (
    <>
      {HOLDER_NUMBERS.map((cell) => (
        <ToolField key={cell} entry={entry} cell={cell} issues={issues} />
      ))}
      <AxisField entry={entry} issues={issues} />
      <HeadField entry={entry} issues={issues} />
    </>
  );
}
