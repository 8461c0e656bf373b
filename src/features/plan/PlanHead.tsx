import { useMemo, useRef, useState } from "react";
import { newPart, type FinishedPart } from "../../planning/part/finished-part.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { Menu } from "../../app/base/Menu.tsx";
import { closeStep } from "../../app/document/steps.ts";
import { useEditor } from "../../app/document/store.ts";
import { TableStatus, type TableMessage } from "../../app/fields/table/TableStatus.tsx";
import { uncover } from "../../app/place/place.ts";
import { addPart, deletePart, openPart, useParts, type StoredPart } from "../../app/records/part-store.ts";
import { partOfProgram } from "./part-of-program.ts";
import { openPartFile, savePartFile } from "./part-files.ts";
import { sayOpened, showTab, usePlanPlace } from "./plan-place.ts";
import { problemWords, type PlanWords } from "../../app/fields/plan/plan-words.ts";

interface Props {
  readonly words: PlanWords;
  readonly stored: StoredPart;
  readonly onPart: (part: FinishedPart, place: string | null) => void;
}

/** Most problems of a file that are named. */
const MOST_ERRORS = 5;

/** Name of the part, the other parts of the device, and part files. */
export function PlanHead({ words, stored, onPart }: Props) {
  const { t } = words;
  const parts = useParts((p) => p.list);
  const hasWork = useEditor((s) => s.job !== null || s.program !== null);
  const file = useRef<HTMLInputElement>(null),
    name = useRef<HTMLInputElement>(null);
  const [said, say] = useState<TableMessage | null>(null);
  const put = (next: TableMessage | null) => {
    sayOpened(null);
    say(next);
  };
  const begin = (part: FinishedPart) => {
    addPart(part);
    showTab("part");
    put(null);
    requestAnimationFrame(() => name.current?.focus());
  };
  const fromProgram = () => {
    const part = partOfProgram();
    if (part) begin(part);
    else put({ sentences: [t.part.noContour], failed: true, changed: false });
  };
  const opened = usePlanPlace((p) => p.opened);
  const errors = opened?.problems.map((problem) => problemWords(words, problem, () => 0)) ?? [];
  const ofFile: TableMessage | null = useMemo(
    () =>
      opened && {
        sentences: opened.isOpen
          ? [words.t.part.imported(opened.name)]
          : [words.t.part.notOpened(opened.name), ...errors.slice(0, MOST_ERRORS)],
        failed: !opened.isOpen,
        changed: opened.isOpen,
      },
    // The sentences follow from the file and the language.
    // oxlint-disable-next-line react/exhaustive-deps
    [opened, words],
  );
  return (
    <>
      <div className="plan-head">
        <button type="button" className="button" onClick={uncover}>
          <Icon name="back" /> {t.back}
        </button>
        <h1 className="plan-title">{t.title}</h1>
        <label className="plan-name">
          <span className="unseen">{t.part.name}</span>
          <input
            ref={name}
            className="input"
            type="text"
            maxLength={32}
            autoComplete="off"
            spellCheck={false}
            placeholder={t.part.unnamed}
            value={stored.part.name}
            onChange={(event) => onPart({ ...stored.part, name: event.currentTarget.value }, "name")}
            onBlur={closeStep}
          />
        </label>
        {parts.length > 1 && (
          <label className="plan-others-list">
            <span className="unseen">{t.part.list}</span>
            <select className="select" value={stored.id} onChange={(event) => openPart(event.currentTarget.value)}>
              {parts.map(({ id, part }) => (
                <option key={id} value={id}>
                  {part.name.trim() || t.part.unnamed}
                </option>
              ))}
            </select>
          </label>
        )}
        <Menu
          name={t.part.more}
          groups={[
            [
              { name: t.part.create, icon: "add", go: () => begin(newPart(t.part.first)) },
              { name: t.part.duplicate, icon: "copy", go: () => begin(stored.part) },
              ...(hasWork ? [{ name: t.part.fromProgram, icon: "insert" as const, go: fromProgram }] : []),
            ],
            [
              { name: t.part.open, icon: "raise", go: () => file.current?.click() },
              { name: t.part.save, icon: "download", go: () => savePartFile(stored.part) },
            ],
            [
              {
                name: t.part.remove,
                icon: "remove",
                go: () => {
                  deletePart();
                  put({ sentences: [t.part.removed], failed: false, changed: true });
                },
              },
            ],
          ]}
        />
        <input
          ref={file}
          type="file"
          hidden
          accept=".json,application/json"
          onChange={(event) => {
            const [chosen] = event.currentTarget.files ?? [];
            event.currentTarget.value = "";
            if (!chosen) return;
            say(null);
            void openPartFile(chosen);
          }}
        />
      </div>
      <TableStatus said={said ?? ofFile} undo={t.part.undo} done={() => put(null)} />
    </>
  );
}
