import type { ToolsTexts } from "../../i18n/en/tables/tools.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { HolderNumber, LimitNumber, NumberCell, NumberColumn } from "../../program/tools/tool-columns.ts";
import { isDrillType, ruleOf } from "../../program/tools/tool-columns.ts";
import { cellOf, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { FieldMessage } from "../../app/fields/number/FieldMessage.tsx";
import { LabelledInput } from "../../app/fields/number/LabelledInput.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { setCell } from "./tool-edits.ts";
import { closeStep } from "../../app/document/steps.ts";

interface MessagesProps {
  readonly issues: readonly Issue[];
  readonly text: string;
  readonly decimals?: number;
  readonly onTake?: (nearest: number) => void;
}

/** The faults of a cell. A merely missing value is shown without alarm. */
const Messages = ({ issues, text, decimals = 4, onTake }: MessagesProps) =>
  issues.map((issue) => (
    <FieldMessage
      key={issue.code}
      problem={{ issue }}
      decimals={decimals}
      calm={text.trim() === "" && issue.severity === "error"}
      {...(onTake && { onTake })}
    />
  ));

/** The same below a field that is not a number, announced when it changes. */
export const CellMessages = ({ id, ...of }: MessagesProps & { readonly id: string }) => (
  <div id={id} className="field-messages" role="status">
    <Messages {...of} />
  </div>
);

const UNITS = { length: "mm", angle: "degrees", number: null } as const;

/** Meaning of a column for tools of one type only. */
function ownMeaning(t: ToolsTexts, cell: NumberCell, type: string): string | null {
  if (cell in t.limits) return t.limits[cell as LimitNumber];
  if (cell === "T-ANGLE" && isDrillType(type)) return t.drillAngle;
  return cell === "CUTLENGTH" && type === "THREAD" ? t.toothHeight : null;
}

/** One number of a row: each keystroke goes to the table, sums are evaluated on leaving the field. */
export function ToolField({
  entry,
  cell,
  issues,
  unused = null,
}: {
  readonly entry: ToolEntry;
  readonly cell: NumberCell;
  readonly issues: readonly Issue[];
  /** The type that does not use this column; null if it does. */
  readonly unused?: string | null;
}) {
  const t = useTexts("tables").tools;
  const text = cellOf(entry, cell),
    type = cellOf(entry, "TYPE");
  const put = (next: string) => setCell(entry.id, cell, next);
  const {
    kind,
    range: [min],
    decimals,
  } = ruleOf(cell, type);
  const column = cell in t.holder ? null : (cell as NumberColumn);
  const meaning = ownMeaning(t, cell, type) ?? (column ? t.columns[column] : t.holder[cell as HolderNumber]);
  const found = issues.filter((issue) => issue.at === cell);
  return (
    <LabelledInput
      className={`tool-field${unused === null ? "" : " unused"}`}
      text={text}
      onText={put}
      onLeave={closeStep}
      signed={min < 0}
      label={
        <>
          {column && <b className="number">{column}</b>} <span className="soft small">{meaning}</span>
        </>
      }
      aria-label={column ? t.field(column, meaning) : meaning}
      unit={unused === null ? UNITS[kind] && t.units[UNITS[kind]] : t.unused(unused)}
      disabled={unused !== null}
      aria-invalid={found.some((issue) => issue.severity === "error")}
      messages={
        <Messages
          issues={found}
          text={text}
          decimals={decimals}
          onTake={(nearest) => {
            closeStep();
            put(String(nearest));
            closeStep();
          }}
        />
      }
    />
  );
}
