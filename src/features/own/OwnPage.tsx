import { useEffect, useRef, useState, type KeyboardEvent } from "react";
import type { OwnEntry } from "../../program/edits/own-cycle.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { TableStatus, type TableMessage } from "../../app/fields/table/TableStatus.tsx";
import { TableTabs } from "../../app/fields/table/TableTabs.tsx";
import { openOwn, showToolKind, showTools, uncover, usePlace } from "../../app/place/place.ts";
import { addOwn, duplicateOwn, isFull, removeOwn } from "../../app/fields/blocks/own-edits.ts";
import { exportOwn, importOwnFile } from "./own-files.ts";
import { libraryOf } from "../../app/document/own-reading.ts";
import { useOwn } from "../../app/document/own-store.ts";
import { OwnForm } from "./OwnForm.tsx";
import "../../app/fields/table/tools.css";
import "./own.css";

/** The own cycles of this device: the list, and the description of the open one. */
export function OwnPage() {
  const t = useTexts("tables").own;
  const list = useOwn((s) => s.list);
  const { row: asked, focus } = usePlace((p) => p.own);
  const [said, setSaid] = useState<TableMessage | null>(null);
  const page = useRef<HTMLElement>(null);
  const file = useRef<HTMLInputElement>(null);
  const { rows } = libraryOf(list);
  const entry = list.find((each) => each.id === asked) ?? list[0];
  const reading = entry && rows.get(entry.id);
  const full = isFull(list);
  const nameOf = ({ number, name }: OwnEntry) => t.cycleName(number.trim() || t.unnamed, name.trim());

  const focusRow = () =>
    requestAnimationFrame(() =>
      (
        page.current?.querySelector<HTMLElement>(".own-row[aria-current]") ?? page.current?.querySelector("button")
      )?.focus(),
    );
  useEffect(() => {
    if (focus === 0)
      (
        page.current?.querySelector<HTMLElement>(".own-row[aria-current]") ?? page.current?.querySelector("button")
      )?.focus();
    else {
      // Proposals from a program are filled in: focus goes to the first missing text, or else to the kind of the first
      // parameter.
      const [number, ...words] =
        page.current?.querySelectorAll<HTMLInputElement>(".own-names input, .own-prompt input") ?? [];
      const missing = words[0]?.value === "" ? number : words.find(({ value }) => value === "");
      (missing ?? page.current?.querySelector<HTMLElement>(".own-parameter select") ?? number)?.focus();
      missing?.select();
    }
  }, [focus]);

  const edited = (id: string) => {
    setSaid(null);
    openOwn(id, true);
  };
  const remove = (gone: OwnEntry) => {
    openOwn(removeOwn(gone.id));
    setSaid({ sentences: [t.removed(nameOf(gone))], failed: false, changed: true });
    focusRow();
  };
  const onRowKey = (event: KeyboardEvent) => {
    const at = entry ? list.indexOf(entry) : -1;
    const ways: Readonly<Record<string, number>> = {
      ArrowDown: at + 1,
      ArrowUp: at - 1,
      Home: 0,
      End: list.length - 1,
    };
    const next = list[ways[event.key] ?? -1];
    if (!next) return;
    event.preventDefault();
    openOwn(next.id);
    focusRow();
  };

  return (
    <main className="tool-page own-page" ref={page}>
      <div className="tool-head">
        <button type="button" className="button" aria-label={t.backLong} onClick={uncover}>
          <Icon name="back" /> {t.back}
        </button>
        <div className="tool-title">
          <p>{t.lead}</p>
          <p className="soft small">{t.count(list.length)}</p>
        </div>
        <div className="tool-buttons">
          <button type="button" className="button primary" disabled={full} onClick={() => edited(addOwn())}>
            <Icon name="add" /> {t.add}
          </button>
        </div>
        <div className="tool-buttons" role="group" aria-label={t.files.name}>
          <button
            type="button"
            className="button"
            aria-label={t.files.importLong}
            onClick={() => file.current?.click()}
          >
            <Icon name="add" /> {t.files.import}
          </button>
          <button
            type="button"
            className="button"
            aria-label={t.files.exportLong}
            disabled={list.length === 0}
            onClick={() => setSaid(exportOwn(t))}
          >
            <Icon name="download" /> {t.files.export}
          </button>
          <input
            ref={file}
            type="file"
            hidden
            accept=".json,application/json"
            onChange={(e) => {
              const [chosen] = e.currentTarget.files ?? [];
              e.currentTarget.value = "";
              if (chosen) void importOwnFile(chosen, t).then(setSaid);
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
      <TableTabs
        open="own"
        onOwn={() => undefined}
        onTools={(kind) => {
          showToolKind(kind);
          showTools();
        }}
      />
      <div className="tool-list">
        {list.length === 0 ? (
          <p className="tool-none">{t.none}</p>
        ) : (
          <ul className="own-list" aria-label={t.list} onKeyDown={onRowKey}>
            {list.map((each) => {
              const wrong = (rows.get(each.id)?.problems.length ?? 0) > 0;
              return (
                <li key={each.id}>
                  <button
                    type="button"
                    className="own-row"
                    tabIndex={each === entry ? 0 : -1}
                    aria-current={each === entry ? "true" : undefined}
                    aria-label={`${t.select(nameOf(each))}${wrong ? `, ${t.hasError}` : ""}`}
                    onClick={() => openOwn(each.id)}
                  >
                    <b className="number">{each.number.trim() || "–"}</b>
                    <span className="own-row-name">{each.name}</span>
                    <span className="small soft">{t.parameterCount(each.parameters.length)}</span>
                    {wrong && <Icon name="error" />}
                  </button>
                </li>
              );
            })}
          </ul>
        )}
      </div>
      {entry && reading && (
        <OwnForm
          key={entry.id}
          entry={entry}
          reading={reading}
          name={nameOf(entry)}
          onDuplicate={full ? null : () => edited(duplicateOwn(entry.id))}
          onRemove={() => remove(entry)}
        />
      )}
    </main>
  );
}
