import { useEffect, useMemo, useRef, useState } from "react";
import { useOutcome } from "../../app/calculation/outcome.ts";
import { KEEPS_KEYBOARD } from "../../app/place/place.ts";
import { useLengths } from "../../app/calculation/lengths.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { chooseOpenBlock } from "../../app/fields/blocks/choose-block.ts";
import { partsOf, type Part, type PartFilter } from "../../app/fields/blocks/program-parts.ts";
import { openBlock, useSession } from "../../app/fields/blocks/session.ts";
import { useShownOtherFile } from "../../app/document/shown-file.ts";
import { useWindow } from "./use-window.ts";
import { OperationList } from "./operations/OperationList.tsx";
import { doneWords } from "../../app/fields/blocks/words.ts";
import { useToolList } from "../../app/document/work-tools.ts";

const FILTERS = ["operations", "all", "labels", "notes"] as const satisfies readonly ("all" | PartFilter)[];

/** The parts of the program: tools, cycles with their actions, labels, contours, notes. A click opens the block. */
export function StructurePanel() {
  const all = useTexts();
  const { editor: t } = all;
  const lengths = useLengths();
  const tools = useToolList();
  const reading = useSession((s) => s.reading);
  const index = useSession((s) => s.index);
  const newest = useOutcome((s) => s.newest);
  const [filter, show] = useState<(typeof FILTERS)[number]>("operations");
  const select = useRef<HTMLSelectElement>(null);
  const narrowing = useRef(false);
  const file = useShownOtherFile();
  const parts = useMemo(() => partsOf(reading.program, newest, file), [reading, newest, file]);
  const shown = useMemo(
    () => (filter === "all" ? parts : parts.filter((part) => part.filter === filter)),
    [parts, filter],
  );
  const current = shown.findLastIndex((part) => part.index <= index);
  const { box, from, to, above, below, measure } = useWindow(shown.length, current);

  const entry = (part: Part, place: number) => {
    const unmade = part.acts ? t.acts : t.notRun;
    const run = part.done ? doneWords(all, lengths, part.done) : newest ? unmade : "";
    const done = part.kind === "cycle" ? run : "";
    const tool =
      part.tool === null ? undefined : tools.find(({ T, NAME }) => String(T) === part.tool || NAME === part.tool);
    const more = done || (tool ? tool.NAME : part.kind === "structure" ? "" : t.kinds[part.kind]);
    return (
      <li key={part.index} aria-setsize={shown.length} aria-posinset={place + 1}>
        <button
          type="button"
          className={`part part-${part.filter}`}
          aria-current={place === current ? "step" : undefined}
          aria-label={`${t.line(String(part.number), `${t.kinds[part.kind]}, ${part.text}`)}${done && `, ${done}`}`}
          onClick={() => {
            openBlock(part.index);
            chooseOpenBlock();
          }}
        >
          <span className="number part-number">{part.number}</span>
          <span className="part-words">
            <span className="number part-text">{part.text}</span>
            {more && <span className="small soft">{more}</span>}
          </span>
        </button>
      </li>
    );
  };

  // The list changes: focus stays on its filter.
  useEffect(() => {
    if (narrowing.current) select.current?.focus();
    narrowing.current = false;
  }, [filter]);
  const narrowed = (
    <label className="structure-filter">
      <span className="small soft">{t.filter}</span>
      <select
        ref={select}
        className="select"
        aria-label={t.filter}
        value={filter}
        onChange={(event) => {
          narrowing.current = true;
          show(FILTERS.find((each) => each === event.target.value) ?? "all");
        }}
      >
        {FILTERS.map((each) => (
          <option key={each} value={each}>
            {t.filters[each]}
          </option>
        ))}
      </select>
    </label>
  );
  return (
    <div className="structure" {...{ [KEEPS_KEYBOARD]: "" }}>
      {filter === "operations" ? (
        <OperationList filter={narrowed} />
      ) : (
        <>
          {narrowed}
          {shown.length === 0 && <p className="soft structure-empty">{t.nothing}</p>}
          <div className="structure-list" ref={box} onScroll={measure}>
            <ol aria-label={t.list} style={{ paddingTop: above, paddingBottom: below }}>
              {shown.slice(from, to).map((part, i) => entry(part, from + i))}
            </ol>
          </div>
        </>
      )}
    </div>
  );
}
