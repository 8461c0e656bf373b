import type { ToolFileTexts } from "../../i18n/tool-file-text.ts";
import { originsOf } from "../../program/tools/table-write-back.ts";
import type { TableOrigin } from "../../program/tools/tool-entry.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import type { ExportKind } from "./tool-files.ts";
import { toolsOnDevice, useTools } from "../../app/document/tool-store.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";

/** Asks for the export format, and lists what each format cannot hold. */
export function ExportDialog({
  words: w,
  again,
  write,
  done,
}: {
  readonly words: ToolFileTexts;
  readonly again: (origin: TableOrigin) => void;
  readonly write: (kind: ExportKind) => void;
  readonly done: () => void;
}) {
  const t = useTexts("tables").tools;
  const list = useTools((s) => s.list);
  const { table, mills } = toolsOnDevice(list);
  const held = table.tools.some((tool) => tool.holder);
  const origins = [...originsOf(list, false), ...originsOf(list, true)];
  const kinds: readonly {
    readonly kind: ExportKind;
    readonly name: string;
    readonly hint: string;
    readonly count: number;
  }[] = [
    {
      kind: "turning",
      name: w.turning,
      hint: `${w.roundsHint}${held ? ` ${w.noHolders}` : ""}`,
      count: table.tools.length,
    },
    { kind: "milling", name: w.milling, hint: w.roundsHint, count: mills.length },
    { kind: "csv", name: w.sheet, hint: w.sheetHint, count: table.tools.length + mills.length },
    { kind: "json", name: w.json, hint: w.jsonHint, count: table.tools.length + mills.length },
  ];
  const choice = (key: string, name: string, hint: string, take: () => void, disabled = false) => (
    <li key={key}>
      <button type="button" className="button" disabled={disabled} aria-describedby={`export-${key}`} onClick={take}>
        <Icon name="download" /> {name}
      </button>
      <p className="soft small" id={`export-${key}`}>
        {hint}
      </p>
    </li>
  );
  return (
    <ModalDialog
      isBare
      className="tool-dialog"
      first=".export-ways button:not(:disabled)"
      title={w.exportTitle}
      done={done}
    >
      <h2>{w.exportTitle}</h2>
      <ul className="tool-dialog-body export-ways">
        {origins.map((origin, i) => choice(`again-${i}`, w.again(origin.name), w.againHint, () => again(origin)))}
        {kinds.map(({ kind, name, hint, count }) =>
          choice(kind, name, count === 0 ? w.noTools : `${t.count(count)}. ${hint}`, () => write(kind), count === 0),
        )}
      </ul>
      <div className="tool-dialog-ways">
        <button type="button" className="button" onClick={done}>
          {w.cancel}
        </button>
      </div>
    </ModalDialog>
  );
}
