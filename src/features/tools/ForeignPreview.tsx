import { inScreenWriting } from "../../i18n/number.ts";
import type { LengthUnit } from "../../kernel/units.ts";
import { HOLDER_CELLS, type CellName } from "../../program/tools/tool-columns.ts";
import { readEntry, type ToolEntry } from "../../program/tools/tool-entry.ts";
import type { CellOrigin, ForeignTool } from "../../program/tool-files/foreign-tool.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts, useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { useToolName } from "../../app/document/tool-name.ts";
import type { ToolForeignTexts } from "../../i18n/tool-foreign-text.ts";
import type { ForeignImport } from "./tool-files.ts";

const UNITS = ["mm", "inch"] as const satisfies readonly LengthUnit[];

/** Asks for the unit of the file where it has none. */
function UnitChoice({
  unit,
  words: w,
  choose,
}: {
  readonly unit: LengthUnit;
  readonly words: ToolForeignTexts;
  readonly choose: (unit: LengthUnit) => void;
}) {
  return (
    <fieldset className="foreign-unit">
      <legend>{w.unit}</legend>
      {UNITS.map((each) => (
        <label key={each}>
          <input type="radio" name="foreign-unit" checked={each === unit} onChange={() => choose(each)} />
          {w.units[each]}
        </label>
      ))}
      <span className="soft small">{w.unitHint}</span>
    </fieldset>
  );
}

const isHolderCell = (cell: CellName) => HOLDER_CELLS.some((each) => each === cell);

interface Shown {
  readonly name: string;
  readonly value: string;
  readonly origin: CellOrigin;
}

/** The cells of a tool as shown: the numbers of the shank are one. */
function useShown({ cells, origins }: ForeignTool, words: ToolForeignTexts): readonly Shown[] {
  const t = useTexts("tables").tools;
  const language = useSettings((s) => s.language);
  const names = Object.keys(origins) as readonly CellName[];
  const ofHolder = names.filter(isHolderCell);
  const value = (cell: CellName) => {
    const text = cells[cell] ?? "";
    if (cell === "TO") return `${text} (${t.directions[Number(text) - 1] ?? ""})`;
    return cell === "NAME" || cell === "TYPE" ? text : inScreenWriting(language, text);
  };
  const shank = ["width", "length"] as const;
  const [first] = ofHolder;
  return [
    ...names
      .filter((cell) => !isHolderCell(cell))
      .map((cell) => ({ name: cell, value: value(cell), origin: origins[cell] as CellOrigin })),
    ...(first
      ? [{ name: words.holder, value: shank.map(value).join(" × "), origin: origins[first] as CellOrigin }]
      : []),
  ];
}

/** One tool: what is proposed and why, what is missing, and the property of each other value. */
function Tool({ tool, words: w }: { readonly tool: ForeignTool; readonly words: ToolForeignTexts }) {
  const nameOf = useToolName();
  const entry = { id: "", cells: tool.cells };
  const { issues } = readEntry(entry);
  const shown = useShown(tool, w);
  const [proposed, taken] = [
    shown.filter((s) => s.origin.why.length > 0),
    shown.filter((s) => s.origin.why.length === 0),
  ];
  const empty = (at: string | undefined) => at !== undefined && (tool.cells[at as CellName] ?? "") === "";
  const missing = issues.filter((each) => each.severity === "error" && empty(each.at)).map((each) => each.at);
  const flanks = issues.filter((each) => each.code === "flanksNotChecked").map((each) => each.at);
  return (
    <li>
      <b>{nameOf(entry)}</b>
      {missing.length > 0 && (
        <p className="tool-errors">
          <Icon name="error" /> {w.missing(missing.join(", "))}
        </p>
      )}
      {proposed.map(({ name, value, origin }) => (
        <p key={name}>
          <span className="foreign-mark">{w.proposed}</span> {name} {value}:{" "}
          {origin.why.map((why) => w.why[why]).join("; ")}
          {origin.from !== "" && <span className="soft"> ({origin.from})</span>}
        </p>
      ))}
      {flanks.length > 0 && <p className="soft small">{w.flanks(flanks.join(", "))}</p>}
      <details>
        <summary aria-label={`${w.taken(taken.length)} – ${nameOf(entry)}`}>{w.taken(taken.length)}</summary>
        <table>
          <thead>
            <tr>
              <th scope="col">{w.column}</th>
              <th scope="col">{w.value}</th>
              <th scope="col">{w.property}</th>
            </tr>
          </thead>
          <tbody>
            {taken.map(({ name, value, origin }) => (
              <tr key={name}>
                <th scope="row">{name}</th>
                <td>{value}</td>
                <td>{origin.from}</td>
              </tr>
            ))}
          </tbody>
        </table>
        {tool.unused.length > 0 && <p className="soft small">{w.unused(tool.unused.join(", "))}</p>}
      </details>
    </li>
  );
}

/** Tools from files of other systems before they are imported, with the origin of each value. */
export function ForeignPreview({
  foreign: { formats, tools, refused, assumedUnit },
  most,
  more,
  replaced,
  choose,
}: {
  readonly foreign: ForeignImport;
  /** Most tools listed, and how the others are counted. */
  readonly most: number;
  readonly more: (n: number) => string;
  /** Tools of the table that are replaced. */
  readonly replaced: readonly ToolEntry[];
  readonly choose: (unit: LengthUnit) => void;
}) {
  const w = useTextsOrNull("tool-foreign");
  const nameOf = useToolName();
  if (!w) return null;
  const isProposed = tools.some(({ origins }) => Object.values(origins).some(({ why }) => why.length > 0));
  return (
    <>
      {assumedUnit && <UnitChoice unit={assumedUnit} words={w} choose={choose} />}
      {tools.length > 0 && (
        <>
          <h3>{w.heading(tools.length, formats.map((format) => w.formats[format]).join(", "))}</h3>
          {isProposed && <p className="soft">{w.proposedHint}</p>}
          <ul className="import-changes foreign-tools">
            {tools.slice(0, most).map((tool) => (
              <Tool key={tool.cells.T} tool={tool} words={w} />
            ))}
            {tools.length > most && <li>{more(tools.length - most)}</li>}
          </ul>
        </>
      )}
      {replaced.length > 0 && (
        <>
          <h3>{w.replaces(replaced.length)}</h3>
          <p className="import-names">{replaced.slice(0, most).map(nameOf).join(" · ")}</p>
        </>
      )}
      {refused.length > 0 && (
        <>
          <h3>{w.refused(refused.length)}</h3>
          <ul className="import-changes">
            {refused.slice(0, most).map(({ label, why, kind }, i) => (
              <li key={i}>
                <span>
                  {label}: {w.refusals[why](kind)}
                </span>
              </li>
            ))}
            {refused.length > most && <li>{more(refused.length - most)}</li>}
          </ul>
        </>
      )}
    </>
  );
}
