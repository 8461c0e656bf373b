import { useEffect, useRef } from "react";
import { Radio, RadioGroup } from "react-aria-components/RadioGroup";
import type { ToolFit } from "../../../program/tools/which-tool.ts";
import { takePlace } from "../../document/setup-edits.ts";
import { InsertDrawing } from "../../pictures/lathe/InsertDrawing.tsx";
import { usePlace } from "../../place/place.ts";
import type { JobReading } from "../../document/reading.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useToolList } from "../../document/work-tools.ts";
import { ToolWords, useToolDetails, useToolVerdict } from "./tool-words.tsx";

/** Edge length of an insert drawing, px. */
const DRAWING = 40;

/** The tools of the table, drawn to scale, with their suitability for this contour. */
export function ToolTable({ read, fits }: { readonly read: JobReading; readonly fits: readonly ToolFit[] | null }) {
  const { setup } = useTexts();
  const t = setup.tool;
  const tools = useToolList();
  const details = useToolDetails();
  const verdict = useToolVerdict();
  const asked = usePlace((p) => (p.field === "tool" ? p.focus : 0));
  const proposed = read.setup?.proposed.has("tool") ? read.job.tool : null;
  const group = useRef<HTMLDivElement>(null);

  useEffect(() => {
    if (asked === 0) return;
    const row = ["input:checked", ".suggested input", "input"].map((at) =>
      group.current?.querySelector<HTMLElement>(at),
    );
    row.find((each) => each)?.focus();
  }, [asked]);

  return (
    <fieldset className="setup-group">
      <legend>{t.list}</legend>
      <RadioGroup
        ref={group}
        className="tool-rows"
        aria-label={t.list}
        value={proposed === null ? String(read.job.tool) : null}
        onChange={(number) => takePlace("tool", number)}
      >
        {tools.map((tool) => {
          const fit = fits?.find((f) => f.tool.T === tool.T);
          const said = [
            t.name(tool.T, tool.NAME),
            details(tool),
            ...(tool.T === proposed ? [setup.proposed] : []),
            ...(fit ? [verdict(fit)] : []),
          ];
          return (
            <Radio
              key={tool.T}
              value={String(tool.T)}
              className={`tool-row radio${tool.T === proposed ? " suggested" : ""}`}
              aria-label={said.join(", ")}
            >
              <InsertDrawing tool={tool} width={DRAWING} height={DRAWING} />
              <ToolWords tool={tool} fit={fit} />
            </Radio>
          );
        })}
      </RadioGroup>
    </fieldset>
  );
}
