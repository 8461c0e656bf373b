import { useId } from "react";
import type { Issue } from "../../kernel/plan/issue.ts";
import { TOOL_TYPES } from "../../kernel/plan/tool.ts";
import { isMillType, isToolType, MILL_TYPES } from "../../program/tools/tool-columns.ts";
import { cellOf, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { setCell } from "./tool-edits.ts";
import { closeStep } from "../../app/document/steps.ts";
import { CellMessages, ToolField } from "./ToolField.tsx";

interface Props {
  readonly entry: ToolEntry;
  readonly issues: readonly Issue[];
}

/** NAME as the control accepts it: capital letters. */
function NameField({ entry, issues }: Props) {
  const t = useTexts("tables").tools;
  const id = useId();
  const text = cellOf(entry, "NAME");
  const found = issues.filter((issue) => issue.at === "NAME");
  return (
    <div className="tool-field wide">
      <label htmlFor={id}>
        <b className="number">NAME</b> <span className="soft small">{t.columns.NAME}</span>
      </label>
      <input
        id={id}
        className="input number name"
        type="text"
        autoComplete="off"
        autoCapitalize="characters"
        spellCheck={false}
        maxLength={60}
        aria-label={t.field("NAME", t.columns.NAME)}
        aria-invalid={found.some((issue) => issue.severity === "error")}
        aria-describedby={`${id}-wrong`}
        value={text}
        onChange={(e) => setCell(entry.id, "NAME", e.currentTarget.value.toUpperCase())}
        onBlur={closeStep}
      />
      <CellMessages id={`${id}-wrong`} issues={found} text={text} />
    </div>
  );
}

/** TYPE, which determines the columns in use. */
function TypeField({ entry, issues }: Props) {
  const t = useTexts("tables").tools;
  const { setup } = useTexts();
  const id = useId();
  const type = cellOf(entry, "TYPE");
  const found = issues.filter((issue) => issue.at === "TYPE");
  return (
    <div className="tool-field wide">
      <label htmlFor={id}>
        <b className="number">TYPE</b> <span className="soft small">{t.columns.TYPE}</span>
      </label>
      <select
        id={id}
        className="select"
        aria-label={t.field("TYPE", t.columns.TYPE)}
        value={type}
        aria-invalid={found.length > 0}
        aria-describedby={`${id}-wrong`}
        onChange={(e) => {
          closeStep();
          setCell(entry.id, "TYPE", e.currentTarget.value);
          closeStep();
        }}
      >
        {!isToolType(type) && !isMillType(type) && <option value={type}>{type || t.anyType}</option>}
        <optgroup label={t.kinds.turning}>
          {TOOL_TYPES.map((each) => (
            <option key={each} value={each}>
              {each} · {setup.tool.types[each]}
            </option>
          ))}
        </optgroup>
        <optgroup label={t.kinds.milling}>
          {MILL_TYPES.map((each) => (
            <option key={each} value={each}>
              {each} · {each === "MILL" ? t.mill : setup.tool.types[each]}
            </option>
          ))}
        </optgroup>
      </select>
      <CellMessages id={`${id}-wrong`} issues={found} text={type} />
    </div>
  );
}

/** Number, names and type of a tool. */
export function NameFields({ entry, issues }: Props) {
  return (
    <>
      <ToolField entry={entry} cell="T" issues={issues} />
      <NameField entry={entry} issues={issues} />
      <TypeField entry={entry} issues={issues} />
    </>
  );
}
