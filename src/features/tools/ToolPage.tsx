import { useEffect, useRef, useState } from "react";
import { Icon } from "../../app/base/Icon.tsx";
import { retryImport } from "../../app/base/parts.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { openToolRow, showOwn, showToolKind, type ToolKind, uncover, usePlace } from "../../app/place/place.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { addTool, duplicateTool, removeTool, restoreShippedTools } from "./tool-edits.ts";
import { isMillEntry } from "../../program/tools/tool-entry.ts";
import { exportToOrigin, exportTools, applyImport, type ImportSource, type ToolImport } from "./tool-files.ts";
import { toolsOnDevice, useTools } from "../../app/document/tool-store.ts";
import { useToolName } from "../../app/document/tool-name.ts";
import { TableStatus, type TableMessage } from "../../app/fields/table/TableStatus.tsx";
import { ExportDialog } from "./ExportDialog.tsx";
import { ImportDialog } from "./ImportDialog.tsx";
import { TableTabs } from "../../app/fields/table/TableTabs.tsx";
import { RestoreToolsDialog } from "./RestoreToolsDialog.tsx";
import { PasteButton } from "./PasteButton.tsx";
import { useSheetColumns } from "./use-sheet-columns.tsx";
import { ToolForm } from "./ToolForm.tsx";
import { ToolGrid } from "./ToolGrid.tsx";
import "../../app/fields/table/tools.css";

/** Types for file pickers that do not know the endings. */
const PLAIN_TYPES = ["application/json", "text/plain", "text/csv", "text/xml", "application/zip"];
const fetchFormats = () => retryImport(() => import("../../program/tool-files/formats.ts"));
const fetchImport = () => retryImport(() => import("./read-import.ts"));

/** The tool table of this device: the whole table, and the columns of the open tool. */
export function ToolPage() {
  const t = useTexts("tables").tools;
  const nameOf = useToolName();
  const list = useTools((s) => s.list);
  const { row: asked, kind: lastKind } = usePlace((p) => p.tools);
  const [said, setSaid] = useState<TableMessage | null>(null);
  const [asking, ask] = useState<ToolImport | "export" | "restore" | null>(null);
  const w = useTexts("tool-files");
  const { dialog, assign } = useSheetColumns();
  const language = useSettings((s) => s.language);
  const page = useRef<HTMLElement>(null);
  const file = useRef<HTMLInputElement>(null);
  const [endings, setEndings] = useState<string>();
  const read = toolsOnDevice(list);
  const opened = list.find((each) => each.id === asked);
  const kind: ToolKind = opened ? (isMillEntry(opened) ? "milling" : "turning") : lastKind;
  const rows = list.filter((each) => isMillEntry(each) === (kind === "milling"));
  const entry = opened ?? rows[0];
  const reading = entry && read.rows.get(entry.id);
  const wrong = list.length - read.table.tools.length - read.mills.length;

  useEffect(() => {
    void fetchFormats().then(({ TOOL_FILE_ENDINGS }) => setEndings([...TOOL_FILE_ENDINGS, ...PLAIN_TYPES].join(",")));
  }, []);
  const focusRow = () =>
    requestAnimationFrame(() => page.current?.querySelector<HTMLElement>("tr.open button")?.focus());
  const focusField = () =>
    requestAnimationFrame(() => {
      const field = page.current?.querySelector<HTMLInputElement>(".tool-form input[type=text]");
      field?.focus();
      field?.select();
    });
  useEffect(() => {
    page.current?.querySelector<HTMLElement>("tr.open button")?.focus();
  }, []);

  const edited = (row: string) => {
    setSaid(null);
    openToolRow(row);
    focusField();
  };
  const receive = (brought: ToolImport | TableMessage | null) => {
    if (!brought) return;
    if ("failed" in brought) return setSaid(brought);
    setSaid(null);
    ask(brought);
  };
  const bring = (sources: readonly ImportSource[]) => {
    if (sources.length > 0)
      void fetchImport()
        .then(({ readImportFiles }) => readImportFiles(sources, { t, w, assign }))
        .then(receive);
  };
  const remove = (id: string, name: string) => {
    showToolKind(kind);
    openToolRow(removeTool(id));
    setSaid({ sentences: [t.removed(name)], failed: false, changed: true });
    focusRow();
  };

  return (
    <main className="tool-page" ref={page}>
      <div className="tool-head">
        <button type="button" className="button" aria-label={t.backLong} onClick={uncover}>
          <Icon name="back" /> {t.back}
        </button>
        <div className="tool-title">
          <p>{t.lead}</p>
          <p className="soft small">
            {t.count(list.length)}
            {wrong > 0 && (
              <>
                {" · "}
                <span className="tool-errors">{t.wrongCount(wrong)}</span>
              </>
            )}
          </p>
        </div>
        <div className="tool-buttons">
          <button type="button" className="button primary" onClick={() => edited(addTool(kind))}>
            <Icon name="add" /> {t.add}
          </button>
        </div>
        <div className="tool-buttons" role="group" aria-label={t.files}>
          <button type="button" className="button" aria-label={w.importLong} onClick={() => file.current?.click()}>
            <Icon name="add" /> {t.import}
          </button>
          <PasteButton
            take={(source) => bring([source])}
            fail={(sentence) => setSaid({ sentences: [sentence], failed: true, changed: false })}
          />
          <button type="button" className="button" aria-label={w.exportLong} onClick={() => ask("export")}>
            <Icon name="download" /> {w.export}
          </button>
          <button type="button" className="button plain" aria-haspopup="dialog" onClick={() => ask("restore")}>
            {t.restore}
          </button>
          <input
            ref={file}
            type="file"
            hidden
            multiple
            accept={endings}
            onChange={(e) => {
              const chosen = [...(e.currentTarget.files ?? [])];
              e.currentTarget.value = "";
              bring(chosen);
            }}
          />
        </div>
      </div>
      <TableStatus
        said={said}
        undo={t.undo}
        done={() => {
          setSaid(null);
          focusRow();
        }}
      />
      {asking === "export" && (
        <ExportDialog
          words={w}
          done={() => ask(null)}
          again={(origin) => {
            ask(null);
            setSaid(exportToOrigin(origin, t, w));
          }}
          write={(way) => {
            ask(null);
            setSaid(exportTools(way, language, t, w));
          }}
        />
      )}
      {asking === "restore" && (
        <RestoreToolsDialog
          done={() => ask(null)}
          restore={() => {
            ask(null);
            restoreShippedTools();
            setSaid({ sentences: [t.restored], failed: false, changed: true });
          }}
        />
      )}
      {asking !== null && typeof asking === "object" && (
        <ImportDialog
          brought={asking}
          words={w}
          change={({ sheet }) => {
            ask(null);
            if (sheet) void assign(sheet, true).then(receive);
          }}
          done={() => ask(null)}
          reread={ask}
          take={(choice) => {
            ask(null);
            setSaid(applyImport(asking, choice, t, w));
          }}
        />
      )}
      {dialog}
      <div className="tool-list">
        <TableTabs open={kind} onTools={showToolKind} onOwn={() => showOwn()} />
        {rows.length === 0 ? (
          <p className="tool-none">{t.none}</p>
        ) : (
          <ToolGrid list={rows} kind={kind} read={read} open={entry?.id ?? null} />
        )}
        <p className="small evidence-text tool-note">{t.unconfirmed}</p>
      </div>
      {entry && reading && (
        <ToolForm
          entry={entry}
          reading={reading}
          onDuplicate={() => edited(duplicateTool(entry.id))}
          onRemove={() => remove(entry.id, nameOf(entry))}
        />
      )}
    </main>
  );
}
