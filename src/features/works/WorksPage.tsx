import { momentWriter } from "../../app/base/clock-text.ts";
import { RowGuard } from "../../app/base/RowGuard.tsx";
import { UnreadList } from "./UnreadList.tsx";
import { useCallback, useEffect, useMemo, useRef, useState, type KeyboardEvent } from "react";
import { goHome } from "../../app/document/go-home.ts";
import { menuCycle } from "../../app/fields/chooser/menu.ts";
import { openAskedFiles } from "../../app/fields/open/open-files.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { keptPictures } from "../../app/records/kept-picture.ts";
import type { WorkSummary } from "../../app/records/device.ts";
import { refreshWorks, useSavedWorks } from "../../app/records/keep.ts";
import { useWorksInOtherTabs } from "../../app/records/use-works-in-other-tabs.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { TableStatus } from "../../app/fields/table/TableStatus.tsx";
import { listWorks, WORK_ORDERS, type WorkOrder } from "./list-works.ts";
import { sizeWords } from "./size-words.ts";
import { LongList } from "../../app/base/LongList.tsx";
import { useListActions } from "./use-list-actions.ts";
import { WorkRow } from "./WorkRow.tsx";
import "./works.css";

const rowOf = (work: string) => document.querySelector<HTMLElement>(`[data-work="${CSS.escape(work)}"] .work-open`);

/** Focuses the row of a work once the list has changed. */
const focusRow = (work: string): void =>
  void requestAnimationFrame(() => requestAnimationFrame(() => rowOf(work)?.focus()));

/**
 * The same after an asynchronous action, unless focus has moved elsewhere: a Delete meant for a field must not reach a
 * row.
 */
const focusRowAgain = (work: string): void =>
  void requestAnimationFrame(() =>
    requestAnimationFrame(() => {
      const { activeElement, body } = document;
      if (!activeElement || activeElement === body || activeElement.closest("[data-work]")) rowOf(work)?.focus();
    }),
  );

/** Arrow keys move between works, F2 renames one, Delete deletes it. */
function onListKey(event: KeyboardEvent, wish: (work: string, what: "rename" | "remove") => void): void {
  const { target, key } = event;
  const row = target instanceof HTMLElement && target.closest<HTMLElement>("[data-work]");
  if (!row || event.ctrlKey || event.metaKey || event.altKey) return;
  const list = row.parentElement?.children;
  const ways: Readonly<Record<string, Element | null | undefined>> = {
    ArrowDown: row.nextElementSibling,
    ArrowUp: row.previousElementSibling,
    Home: list?.[0],
    End: list?.[list.length - 1],
  };
  const next = ways[key];
  if (next) next.querySelector<HTMLElement>(".work-open")?.focus();
  else if (key === "F2") wish(row.dataset["work"] ?? "", "rename");
  else if (key === "Delete") wish(row.dataset["work"] ?? "", "remove");
  else return;
  event.preventDefault();
}

/** All works of this device, exercises in one row that opens: search, sort, rename, duplicate, delete, save as a file. */
export function WorksPage() {
  const { works: t } = useTexts("device");
  const { page, menu } = useTexts("first");
  const language = useSettings((s) => s.language);
  const all = useSavedWorks((k) => k.works);
  const elsewhere = useWorksInOtherTabs();
  const [sought, seek] = useState("");
  const [order, setOrder] = useState<WorkOrder>("newest");
  const search = useRef<HTMLInputElement>(null);
  const works = useMemo(() => all.filter(({ cycle }) => cycle === null || menuCycle(cycle)), [all]);
  const shown = useMemo(
    () => listWorks(works, sought, order, (cycle) => menu.of[cycle]?.name ?? ""),
    [works, sought, order, menu],
  );
  // Pictures are updated while a work is open, not while the list is shown.
  const [pictures] = useState(keptPictures);
  const { saying, say, renaming, selected, select, remove, save, onWish } = useListActions(
    t,
    page.start.isElsewhere,
    focusRowAgain,
  );
  const chosen = shown.filter(({ work }) => selected.has(work));
  useEffect(() => {
    void refreshWorks();
    search.current?.focus();
  }, []);
  const words = useMemo(() => {
    const when = momentWriter(language);
    return (savedAt: number, size: number) => `${page.start.changed(when(savedAt))} · ${sizeWords(size, language)}`;
  }, [language, page]);
  const wish = useCallback(
    (work: string, what: "rename" | "remove") => {
      const of = shown.find((each) => each.work === work);
      if (of && !elsewhere.has(work)) onWish(of, { what });
    },
    [shown, elsewhere, onWish],
  );

  const exercises = shown.filter(({ task }) => task !== undefined);
  const programs = shown.filter(({ task }) => task === undefined);
  // What a search found, or what an action would reach, is in sight.
  const showsExercises =
    sought.trim() !== "" || programs.length === 0 || exercises.some(({ work }) => selected.has(work));
  const rows = (label: string, of: readonly WorkSummary[]) =>
    of.length > 0 && (
      <LongList
        all={of}
        more={t.more}
        className="works-list"
        aria-label={label}
        onKeyDown={(event) => onListKey(event, wish)}
        row={(each) => (
          <RowGuard key={each.work} name={each.name}>
            <WorkRow
              of={each}
              seen={pictures.get(each.work)}
              kind={each.cycle === null ? t.program : (menu.of[each.cycle]?.name ?? "")}
              task={each.task === undefined ? null : page.start.task}
              about={words(each.savedAt, each.size)}
              elsewhere={elsewhere.has(each.work) ? page.start.isElsewhere : null}
              selected={selected.has(each.work)}
              renaming={renaming === each.work}
              t={t}
              onWish={onWish}
            />
          </RowGuard>
        )}
      />
    );

  return (
    <main className="works-page">
      <div className="works-head">
        <button type="button" className="button" onClick={goHome}>
          <Icon name="back" /> {t.back}
        </button>
        <button type="button" className="button" onClick={() => void openAskedFiles()}>
          <Icon name="add" /> {page.programs.openFile}
        </button>
        <p role="status" className="soft">
          {sought.trim() === "" ? t.count(works.length) : t.found(shown.length, works.length)}
        </p>
        <input
          ref={search}
          className="input works-search"
          type="search"
          aria-label={t.search}
          placeholder={t.search}
          value={sought}
          onChange={(event) => seek(event.currentTarget.value)}
          onKeyDown={(event) => {
            const [first] = shown;
            if (event.key === "ArrowDown" && first) focusRow(first.work);
          }}
        />
        <label className="works-order">
          <span>{t.sort}</span>
          <select
            className="select"
            value={order}
            onChange={(event) => setOrder(WORK_ORDERS.find((each) => each === event.target.value) ?? "newest")}
          >
            {WORK_ORDERS.map((each) => (
              <option key={each} value={each}>
                {t.orders[each]}
              </option>
            ))}
          </select>
        </label>
      </div>
      {shown.length > 0 && (
        <div className="works-chosen">
          <label className="work-select">
            <input
              type="checkbox"
              checked={chosen.length === shown.length}
              onChange={() =>
                select(chosen.length === shown.length ? new Set() : new Set(shown.map(({ work }) => work)))
              }
            />
            <span>{t.selectAll}</span>
          </label>
          {chosen.length > 0 && (
            <>
              <span>{t.selected(chosen.length)}</span>
              <button type="button" className="button" onClick={() => void save()}>
                <Icon name="download" /> {t.saveSelected}
              </button>
              <button
                type="button"
                className="button"
                onClick={() => {
                  search.current?.focus();
                  void remove(
                    chosen.map(({ work }) => work),
                    null,
                  );
                }}
              >
                <Icon name="remove" /> {t.removeSelected}
              </button>
            </>
          )}
        </div>
      )}
      <TableStatus said={saying} undo={page.undo} done={() => say(null)} />
      {shown.length === 0 && <p className="soft works-none">{works.length === 0 ? t.none : t.noMatch}</p>}
      {rows(t.list, programs)}
      {exercises.length > 0 && (
        <details className="kept-exercises" open={showsExercises}>
          <summary>{page.start.exercises(exercises.length)}</summary>
          {rows(page.start.exercises(exercises.length), exercises)}
        </details>
      )}
      <UnreadList />
    </main>
  );
}
