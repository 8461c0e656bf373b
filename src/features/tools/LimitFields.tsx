import type { Issue } from "../../kernel/plan/issue.ts";
import { BLADE_SUPPORTS } from "../../kernel/plan/tool.ts";
import { applies, LIMIT_NUMBERS } from "../../program/tools/tool-columns.ts";
import { cellOf, readSupport, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { ChoiceField } from "./ChoiceField.tsx";
import { ToolField } from "./ToolField.tsx";

/** Orientations that cut a bore, and those that plunge along Z. */
const INSIDE = ["5", "6", "7"];
const AXIAL = ["4", "8"];

/** What the maker states about the use of a blade or a boring bar; only what a tool of this kind has, or what is filled. */
export function LimitFields({ entry, issues }: { readonly entry: ToolEntry; readonly issues: readonly Issue[] }) {
  const t = useTexts("tables").tools;
  const [type, to] = [cellOf(entry, "TYPE"), cellOf(entry, "TO").trim()];
  const fits = (cell: (typeof LIMIT_NUMBERS)[number]): boolean => {
    if (cellOf(entry, cell).trim() !== "") return true;
    if (cell === "DMIN") return INSIDE.includes(to);
    if (cell === "CUTDIA") return !INSIDE.includes(to) && !AXIAL.includes(to);
    return cell === "CDX" || AXIAL.includes(to);
  };
  const numbers = LIMIT_NUMBERS.filter((cell) => applies(cell, type) && fits(cell));
  if (numbers.length === 0) return null;
  return (
    <fieldset className="tool-group">
      <legend>{t.groups.limits}</legend>
      <p className="soft small tool-note">{t.limitsNote}</p>
      {numbers.map((cell) => (
        <ToolField key={cell} entry={entry} cell={cell} issues={issues} />
      ))}
      {applies("SUPPORT", type) && (
        <ChoiceField
          entry={entry}
          cell="SUPPORT"
          issues={issues}
          value={readSupport(cellOf(entry, "SUPPORT"))}
          choices={["", ...BLADE_SUPPORTS]}
          words={t.supports}
          label={
            <>
              <b className="number">SUPPORT</b> <span className="soft small">{t.limits.SUPPORT}</span>
            </>
          }
        />
      )}
    </fieldset>
  );
}
