import { inScreenWriting } from "../../i18n/number.ts";
import { useMemo } from "react";
import type { ToolFileTexts } from "../../i18n/tool-file-text.ts";
import { HOLDER_CELLS, type HolderCell } from "../../program/tools/tool-columns.ts";
import type { ToolEntry } from "../../program/tools/tool-entry.ts";
import { planImport, type ImportChange } from "../../program/tools/tool-import.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { ForeignPreview } from "./ForeignPreview.tsx";
import type { ToolImport } from "./tool-files.ts";
import { useToolName } from "../../app/document/tool-name.ts";
import { useTools } from "../../app/document/tool-store.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";

/** Most tools listed. */
const MOST = 200;

const isHolderCell = (cell: string): cell is HolderCell => HOLDER_CELLS.some((each) => each === cell);

function Changes({ changed, words: w }: { readonly changed: readonly ImportChange[]; readonly words: ToolFileTexts }) {
  const t = useTexts("tables").tools;
  const nameOf = useToolName();
  const language = useSettings((s) => s.language);
  const shown = (cell: string, text: string, outline: string) =>
    text === "" ? w.empty : cell === "head" ? outline : inScreenWriting(language, text);
  return (
    <ul className="import-changes">
      {changed.slice(0, MOST).map(({ tool, cells }) => (
        <li key={tool.id}>
          <b>{nameOf(tool)}</b>
          <span>
            {cells
              .map(({ cell, from, to }) => {
                const name = isHolderCell(cell) ? t.holder[cell] : cell;
                return `${name} ${shown(cell, from, w.outline)} → ${shown(cell, to, w.newOutline)}`;
              })
              .join("; ")}
          </span>
        </li>
      ))}
      {changed.length > MOST && <li>{w.more(changed.length - MOST)}</li>}
    </ul>
  );
}

function Names({ tools, words: w }: { readonly tools: readonly ToolEntry[]; readonly words: ToolFileTexts }) {
  const nameOf = useToolName();
  const more = tools.length > MOST ? [w.more(tools.length - MOST)] : [];
  return <p className="import-names">{[...tools.slice(0, MOST).map(nameOf), ...more].join(" · ")}</p>;
}

/** Preview of an import: new tools, changed values, errors, and columns that are not understood. */
export function ImportDialog({
  brought,
  words: w,
  take,
  reread,
  change,
  done,
}: {
  readonly brought: ToolImport;
  readonly words: ToolFileTexts;
  readonly take: (choice: "all" | "new") => void;
  /** Shows the same files read with another unit. */
  readonly reread: (again: ToolImport) => void;
  /** Assigns the columns of its sheet again. */
  readonly change: (brought: ToolImport) => void;
  readonly done: () => void;
}) {
  const t = useTexts("tables").tools;
  const list = useTools((s) => s.list);
  const plan = useMemo(() => planImport(list, brought.incoming, "all"), [list, brought]);
  const { fresh, changed, same, wrong } = plan;
  const title = w.title(brought.name);
  const told = fresh.length + changed.length;
  const { foreign } = brought;
  // Their tools are listed with their values already.
  const onlyForeign = foreign?.tools.length === brought.incoming.rows.length;
  return (
    <ModalDialog isBare className="tool-dialog" first=".primary" title={title} done={done}>
      <h2>{title}</h2>
      <div className="tool-dialog-body" tabIndex={0} role="group" aria-label={title}>
        {foreign && (
          <ForeignPreview
            foreign={foreign}
            most={MOST}
            more={w.more}
            replaced={onlyForeign ? list.filter(({ id }) => changed.some(({ tool }) => tool.id === id)) : []}
            choose={(unit) => brought.withUnit && reread(brought.withUnit(unit))}
          />
        )}
        {brought.notes?.map((note) => (
          <p key={note}>{note}</p>
        ))}
        {told === 0 && <p>{w.nothing}</p>}
        {fresh.length > 0 && !onlyForeign && (
          <>
            <h3>{w.fresh(fresh.length)}</h3>
            <Names tools={fresh} words={w} />
          </>
        )}
        {changed.length > 0 && !onlyForeign && (
          <>
            <h3>{w.changed(changed.length)}</h3>
            <Changes changed={changed} words={w} />
          </>
        )}
        {same > 0 && <p className="soft">{w.same(same)}</p>}
        {wrong.length > 0 && (
          <>
            <h3 className="tool-errors">
              <Icon name="error" /> {w.wrong(wrong.length)}
            </h3>
            <Names tools={wrong} words={w} />
          </>
        )}
        {brought.leftOut.length > 0 && <p>{w.leftOut(brought.leftOut.join(", "))}</p>}
        {brought.kept.length > 0 && <p className="soft">{w.keptInFile(brought.kept.join(", "))}</p>}
        {brought.cutShort && <p>{t.cutShort}</p>}
      </div>
      <div className="tool-dialog-ways">
        {told + same > 0 && (
          <button type="button" className="button primary" onClick={() => take("all")}>
            {w.takeAll(told + same)}
          </button>
        )}
        {fresh.length > 0 && told + same > fresh.length && (
          <button type="button" className="button" onClick={() => take("new")}>
            {w.takeNew(fresh.length)}
          </button>
        )}
        {brought.sheet && (
          <button type="button" className="button" onClick={() => change(brought)}>
            {w.changeColumns}
          </button>
        )}
        <button type="button" className="button" onClick={done}>
          {w.cancel}
        </button>
      </div>
    </ModalDialog>
  );
}
