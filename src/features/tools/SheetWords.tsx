import type { SheetTexts } from "../../i18n/tool-sheet-text.ts";
import { TOOL_TYPES } from "../../kernel/plan/tool.ts";
import type { WordCell } from "../../program/tool-sheets/assignment.ts";
import { ARROWS } from "../../program/tool-sheets/value-words.ts";
import { MILL_TYPES } from "../../program/tools/tool-columns.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The words of a sheet for types or orientations, each with what it means; nothing where the sheet has none. */
export function SheetWords({
  cell,
  all,
  chosen,
  words: w,
  onChoose,
}: {
  readonly cell: WordCell;
  readonly all: readonly string[];
  readonly chosen: Readonly<Record<string, string>>;
  readonly words: SheetTexts;
  readonly onChoose: (word: string, value: string) => void;
}) {
  const t = useTexts("tables").tools;
  const { types } = useTexts().setup.tool;
  // A sheet that already has the values of the control needs no list.
  const plain = all.every((word) => word.trim().toUpperCase() === chosen[word]);
  if (all.length === 0 || plain) return null;
  const options =
    cell === "TO"
      ? ARROWS.map((arrow, i) => [String(i + 1), `${i + 1} ${arrow} ${t.directions[i] ?? ""}`] as const)
      : [...TOOL_TYPES, ...MILL_TYPES].map(
          (type) => [type, `${type} · ${type === "MILL" ? t.mill : types[type]}`] as const,
        );
  return (
    <section className="sheet-words">
      <h3>{w.words[cell]}</h3>
      <ul className="sheet-columns" aria-label={w.words[cell]}>
        {all.map((word) => (
          <li key={word} className="sheet-column">
            <b className="sheet-title">{word}</b>
            <select
              className="select"
              aria-label={w.wordOf(word)}
              value={chosen[word] ?? ""}
              onChange={(e) => onChoose(word, e.currentTarget.value)}
            >
              <option value="">{w.noValue}</option>
              {options.map(([value, label]) => (
                <option key={value} value={value}>
                  {label}
                </option>
              ))}
            </select>
          </li>
        ))}
      </ul>
    </section>
  );
}
