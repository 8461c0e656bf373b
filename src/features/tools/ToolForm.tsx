import { useId, useMemo } from "react";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import {
  applies,
  isDrillType,
  MILL_TABLE,
  POINT_LENGTH,
  type MillColumn,
  type NumberColumn,
} from "../../program/tools/tool-columns.ts";
import { cellOf, isMillEntry, readEntry, type EntryReading, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { CodeField } from "./CodeField.tsx";
import { LiveInsert, useLastValidTool } from "./LiveInsert.tsx";
import { MillDrawing } from "./MillDrawing.tsx";
import { NameFields } from "./NameFields.tsx";
import { TipPicker } from "./TipPicker.tsx";
import { setCell } from "./tool-edits.ts";
import { closeStep } from "../../app/document/steps.ts";
import { enterNext } from "../../app/fields/number/enter-next.ts";
import { HolderFields } from "./HolderFields.tsx";
import { LimitFields } from "./LimitFields.tsx";
import { CellMessages, ToolField } from "./ToolField.tsx";
import { useToolName } from "../../app/document/tool-name.ts";

type TurningColumn = Exclude<NumberColumn, MillColumn>;
const INSERT: readonly TurningColumn[] = ["T-ANGLE", "P-ANGLE", "CUTLENGTH", "CUTWIDTH", "DCW"];
const SETTING: readonly TurningColumn[] = ["ZL", "XL", "DZL", "DXL", "DYL", "ORI"];

const onEnter = enterNext();

/** The insert of a row, ignoring its number and name; `instead` overrides further cells that do not matter. */
const shapeOf = (entry: ToolEntry, reading: EntryReading, instead: ToolEntry["cells"] = {}): Tool | null =>
  reading.tool ??
  readEntry({ ...entry, cells: { ...entry.cells, T: String(reading.number ?? 0), NAME: "", ...instead } }).tool;

/** The orientation of a row with its picture and faults. */
function Orientation({
  entry,
  reading,
  issues,
}: {
  readonly entry: ToolEntry;
  readonly reading: EntryReading;
  readonly issues: readonly Issue[];
}) {
  const id = useId();
  const text = cellOf(entry, "TO");
  const without = useMemo(() => shapeOf(entry, reading, { TO: "1" }), [entry, reading]);
  const drawn = useLastValidTool(entry.id, without);
  const value = Number(text);
  return (
    <div className="tool-field wide">
      <TipPicker
        value={text.trim() === "" ? null : value}
        tool={drawn}
        onChoose={(to) => {
          closeStep();
          setCell(entry.id, "TO", String(to));
          closeStep();
        }}
      />
      <CellMessages id={`${id}-wrong`} issues={issues.filter((issue) => issue.at === "TO")} text={text} />
    </div>
  );
}

interface Row {
  readonly entry: ToolEntry;
  readonly reading: EntryReading;
}

/** The columns of a turning tool, with a live drawing of its insert. */
function TurningColumns({ entry, reading }: Row) {
  const t = useTexts("tables").tools;
  const type = cellOf(entry, "TYPE");
  const { issues } = reading;
  const shape = useMemo(() => shapeOf(entry, reading), [entry, reading]);
  const drawn = useLastValidTool(entry.id, shape);
  const field = (cell: TurningColumn) => (
    <ToolField key={cell} entry={entry} cell={cell} issues={issues} unused={applies(cell, type) ? null : type} />
  );
  return (
    <>
      <LiveInsert tool={drawn} now={shape !== null} />
      <fieldset className="tool-group">
        <legend>{t.groups.name}</legend>
        <NameFields entry={entry} issues={issues} />
      </fieldset>
      <CodeField key={entry.id} entry={entry} />
      <fieldset className="tool-group">
        <legend>{t.groups.tip}</legend>
        <Orientation key={entry.id} entry={entry} reading={reading} issues={issues} />
        {field("RS")}
        {field("DRS")}
      </fieldset>
      <fieldset className="tool-group">
        <legend>{t.groups.insert}</legend>
        {INSERT.map(field)}
      </fieldset>
      <LimitFields entry={entry} issues={issues} />
      <fieldset className="tool-group">
        <legend>{t.groups.setting}</legend>
        <p className="soft small tool-note">{t.keptOnly}</p>
        {SETTING.map(field)}
      </fieldset>
      <fieldset className="tool-group">
        <legend>{t.groups.holder}</legend>
        <HolderFields entry={entry} issues={issues} />
      </fieldset>
    </>
  );
}

/** The columns that a milling tool or a drill of its type uses. */
function MillColumns({ entry, reading: { issues, mill } }: Row) {
  const t = useTexts("tables").tools;
  const type = cellOf(entry, "TYPE");
  return (
    <>
      <MillDrawing mill={mill} />
      <fieldset className="tool-group">
        <legend>{t.groups.name}</legend>
        <NameFields entry={entry} issues={issues} />
      </fieldset>
      <fieldset className="tool-group">
        <legend>{t.groups.mill}</legend>
        <p className="soft small tool-note">{isDrillType(type) ? t.drillNote : t.millNote}</p>
        {([...MILL_TABLE, POINT_LENGTH] as const)
          .filter((cell) => applies(cell, type))
          .map((cell) => (
            <ToolField key={cell} entry={entry} cell={cell} issues={issues} />
          ))}
      </fieldset>
    </>
  );
}

/** All columns of one tool, with a live drawing, and the actions on the row. */
export function ToolForm({
  entry,
  reading,
  onDuplicate,
  onRemove,
}: Row & { readonly onDuplicate: () => void; readonly onRemove: () => void }) {
  const t = useTexts("tables").tools;
  const name = useToolName()(entry);
  return (
    <section className="tool-form" aria-label={t.form(name)} onKeyDownCapture={onEnter}>
      <header>
        <h2>{name}</h2>
        <button type="button" className="button" aria-label={t.duplicateLong(name)} onClick={onDuplicate}>
          <Icon name="copy" /> {t.duplicate}
        </button>
        <button type="button" className="button" aria-label={t.removeLong(name)} onClick={onRemove}>
          <Icon name="close" /> {t.remove}
        </button>
      </header>
      {isMillEntry(entry) ? (
        <MillColumns entry={entry} reading={reading} />
      ) : (
        <TurningColumns entry={entry} reading={reading} />
      )}
    </section>
  );
}
