import { useEffect, useRef } from "react";
import { formatNumber } from "../../i18n/number.ts";
import type { Tool } from "../../kernel/tool.ts";
import { shippedTools } from "../../program/shipped-tools.ts";
import type { ToolFit } from "../../program/which-tool.ts";
import { setTool } from "../edits.ts";
import { useFits } from "../engine/fits.ts";
import { Icon } from "../Icon.tsx";
import { InsertDrawing } from "../lathe/InsertDrawing.tsx";
import { usePlace } from "../place.ts";
import type { JobReading } from "../reading.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";

/** Edge length of an insert drawing, px. */
const DRAWING = 40;

/** Columns of a tool in a few words. */
function useDetails(): (tool: Tool) => string {
  const t = useTexts().setup.tool;
  const language = useSettings((s) => s.language);
  const number = (n: number) => formatNumber(language, n);
  return (tool) => {
    const setting = tool["T-ANGLE"];
    const point = tool["P-ANGLE"];
    return [
      t.types[tool.TYPE],
      tool.CUTWIDTH !== undefined && t.width(number(tool.CUTWIDTH)),
      t.radius(number(tool.RS)),
      setting !== undefined && point !== undefined && t.angles(number(setting), number(point)),
      tool.CUTLENGTH !== undefined && t.cutLength(number(tool.CUTLENGTH)),
      t.orientation(tool.TO),
    ].filter((part) => part !== false).join(" · ");
  };
}

/** The tools that ship, each drawn to scale, with what it can do on this contour. */
export function ToolTable({ read }: { readonly read: JobReading }) {
  const t = useTexts().setup.tool;
  const language = useSettings((s) => s.language);
  const details = useDetails();
  const fits = useFits();
  const asked = usePlace((p) => (p.field === "tool" ? p.focus : 0));
  const group = useRef<HTMLFieldSetElement>(null);
  const own = fits?.find((f) => f.tool.T === read.job.tool);
  const best = fits?.find((f) => f.makesContour);

  useEffect(() => {
    if (asked > 0) group.current?.querySelector<HTMLElement>("input:checked")?.focus();
  }, [asked]);

  const verdict = (fit: ToolFit) =>
    fit.makesContour ? t.makes : fit.unreached > 0 ? t.leaves(formatNumber(language, fit.unreached, 2)) : t.cannot;

  return (
    <fieldset className="setup-group" ref={group} role="radiogroup" aria-label={t.list}>
      <legend>{t.title}</legend>
      <div role="status">
        {own && !own.makesContour && (
          <div className="field-message warning">
            <Icon name="warning" />
            <p>{t.name(own.tool.T, own.tool.NAME)}: {verdict(own)}. {best ? t.better(best.tool.T, best.tool.NAME) : t.noneMakes}</p>
            {best && <button type="button" className="button" onClick={() => setTool(best.tool.T)}>{t.take(best.tool.T)}</button>}
          </div>
        )}
      </div>
      {shippedTools.map((tool) => {
        const fit = fits?.find((f) => f.tool.T === tool.T);
        return (
          <label key={tool.T} className="tool-row">
            <input
              type="radio" name="tool" checked={tool.T === read.job.tool} onChange={() => setTool(tool.T)}
              aria-label={`${t.name(tool.T, tool.NAME)}, ${details(tool)}${fit ? `, ${verdict(fit)}` : ""}`}
            />
            <InsertDrawing tool={tool} width={DRAWING} height={DRAWING} />
            <span className="tool-words">
              <span><b className="number">{tool.T}</b> <b>{tool.NAME}</b></span>
              <span className="small soft">{details(tool)}</span>
              {fit && (
                <span className={`small tool-fit ${fit.makesContour ? "good" : "bad"}`}>
                  <Icon name={fit.makesContour ? "check" : "warning"} /> {verdict(fit)}
                </span>
              )}
            </span>
          </label>
        );
      })}
    </fieldset>
  );
}
