import { useId, type ReactNode } from "react";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { CellName } from "../../program/tools/tool-columns.ts";
import { cellOf, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { setCell } from "./tool-edits.ts";
import { closeStep } from "../../app/document/steps.ts";
import { CellMessages } from "./ToolField.tsx";

/** A cell with a few words to choose from; an invalid word from a file stays visible. */
export function ChoiceField<W extends string>({
  entry,
  cell,
  issues,
  value,
  choices,
  words,
  label,
  wide = false,
}: {
  readonly entry: ToolEntry;
  readonly cell: CellName;
  readonly issues: readonly Issue[];
  /** The word that the cell holds; null when it is none of them. */
  readonly value: W | null;
  readonly choices: readonly W[];
  readonly words: Readonly<Record<W, string>>;
  readonly label: ReactNode;
  readonly wide?: boolean;
}) {
  const id = useId();
  const text = cellOf(entry, cell);
  const found = issues.filter((issue) => issue.at === cell);
  return (
    <div className={`tool-field${wide ? " wide" : ""}`}>
      <label htmlFor={id}>{label}</label>
      <select
        id={id}
        className="select"
        value={value ?? text}
        aria-invalid={found.length > 0}
        aria-describedby={`${id}-wrong`}
        onChange={(e) => {
          closeStep();
          setCell(entry.id, cell, e.currentTarget.value);
          closeStep();
        }}
      >
        {value === null && <option value={text}>{text}</option>}
        {choices.map((each) => (
          <option key={each} value={each}>
            {words[each]}
          </option>
        ))}
      </select>
      <CellMessages id={`${id}-wrong`} issues={found} text={text} />
    </div>
  );
}
