import { useCallback, useState } from "react";
import type { DeviceTexts } from "../../i18n/en/device.ts";
import { openSaved } from "../../app/fields/kept/SavedPrograms.tsx";
import type { WorkSummary } from "../../app/records/device.ts";
import { useSavedWorks } from "../../app/records/keep.ts";
import { duplicateWork, removeWorks, renameWork } from "../../app/records/works.ts";
import { WORKS } from "../../app/document/documents.ts";
import { historyOf, lastStep, useSteps, type HistoryStep } from "../../app/document/steps.ts";
import type { TableMessage } from "../../app/fields/table/TableStatus.tsx";
import { saveWorks } from "./export-works.ts";
import type { RowAction } from "./WorkRow.tsx";

const said = (sentence: string, changed = false): TableMessage => ({ sentences: [sentence], failed: false, changed });
const failed = (sentence: string): TableMessage => ({ sentences: [sentence], failed: true, changed: false });

/** So many works take a while to be deleted. */
const MANY = 100;

/** The actions of the list of works: on one row, and on all selected ones. `focus` focuses the row of a work. */
export function useListActions(t: DeviceTexts["works"], isElsewhere: string, focus: (work: string) => void) {
  const [last, setLast] = useState<{ readonly said: TableMessage; readonly step: HistoryStep | undefined } | null>(
    null,
  );
  const step = useSteps((s) => historyOf(WORKS, s).past.at(-1));
  // The status offers undo, so it is cleared once the change was undone in another way.
  const saying = last && (!last.said.changed || last.step === step) ? last.said : null;
  const say = useCallback((now: TableMessage | null) => setLast(now && { said: now, step: lastStep(WORKS) }), []);
  const [renaming, rename] = useState<string | null>(null);
  const [selected, select] = useState<ReadonlySet<string>>(new Set());

  const call = useCallback(
    async ({ work, name }: WorkSummary, typed: string) => {
      rename(null);
      focus(work);
      const next = typed.trim();
      if (next === "" || next === name) return;
      const done = await renameWork(work, next);
      const problems = { elsewhere: isElsewhere, nameTaken: t.nameTaken(next), failed: t.failed };
      say(done === "done" ? said(t.renamed(next), true) : failed(problems[done]));
      focus(work);
    },
    [t, isElsewhere, focus, say],
  );

  const remove = useCallback(
    async (works: readonly string[], nextRow: string | null) => {
      if (works.length >= MANY) say(said(t.removing(works.length)));
      const { gone, leftOut, refused } = await removeWorks(works);
      select((before) => new Set([...before].filter((work) => !works.includes(work))));
      const sentences = [
        ...(gone.length > 0 ? [t.removed(gone.length, gone[0]?.job.name ?? "")] : []),
        ...(leftOut > 0 ? [t.leftOut(leftOut)] : []),
        ...(refused > 0 ? [t.notRemoved(refused)] : []),
      ];
      say({ sentences, failed: gone.length === 0, changed: gone.length > 0 });
      if (nextRow !== null) focus(nextRow);
    },
    [t, focus, say],
  );

  const duplicate = useCallback(
    async ({ work }: WorkSummary) => {
      const made = await duplicateWork(
        work,
        useSavedWorks.getState().works.map(({ name }) => name),
      );
      say(made ? said(t.duplicated(made.job.name), true) : failed(t.failed));
      if (made) focus(made.work);
    },
    [t, focus, say],
  );

  const save = useCallback(async () => {
    const count = await saveWorks([...selected]);
    say(count > 0 ? said(t.saved(count)) : failed(t.failed));
  }, [t, selected, say]);

  const onWish = useCallback(
    (of: WorkSummary, wish: RowAction) => {
      switch (wish.what) {
        case "open":
          return void openSaved(of.work);
        case "rename":
          return rename(of.work);
        case "stay":
          rename(null);
          return focus(of.work);
        case "call":
          return void call(of, wish.name);
        case "duplicate":
          return void duplicate(of);
        case "remove": {
          const rows = [...document.querySelectorAll<HTMLElement>("[data-work]")].map(
            (row) => row.dataset["work"] ?? "",
          );
          const at = rows.indexOf(of.work);
          return void remove([of.work], rows[at + 1] ?? rows[at - 1] ?? null);
        }
        case "select":
          return select((before) => {
            const next = new Set(before);
            if (!next.delete(of.work)) next.add(of.work);
            return next;
          });
      }
    },
    [call, duplicate, remove, focus],
  );

  return { saying, say, renaming, selected, select, remove, save, onWish };
}
