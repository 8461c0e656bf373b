import { isDrill } from "../../../kernel/cutter/drill.ts";
import { radius, toDiameter } from "../../../kernel/units.ts";
import { formatNumber } from "../../../i18n/number.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import type { ToolFit } from "../../../program/tools/which-tool.ts";
import { Icon } from "../../base/Icon.tsx";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Columns of a tool in a few words. */
export function useToolDetails(): (tool: Tool) => string {
  const t = useTexts().setup.tool;
  const language = useSettings((s) => s.language);
  const number = (n: number) => formatNumber(language, n);
  return (tool) => {
    const setting = tool["T-ANGLE"];
    const point = tool["P-ANGLE"];
    if (isDrill(tool))
      return [
        t.types[tool.TYPE],
        `⌀${number(toDiameter(radius(tool.R ?? 0)))}`,
        tool.CUTLENGTH !== undefined && t.cutLength(number(tool.CUTLENGTH)),
      ]
        .filter((part) => part !== false)
        .join(" · ");
    return [
      t.types[tool.TYPE],
      tool.CUTWIDTH !== undefined && t.width(number(tool.CUTWIDTH)),
      t.radius(number(tool.RS)),
      setting !== undefined && point !== undefined && t.angles(number(setting), number(point)),
      tool.CUTLENGTH !== undefined && t.cutLength(number(tool.CUTLENGTH)),
      t.orientation(tool.TO),
    ]
      .filter((part) => part !== false)
      .join(" · ");
  };
}

/** Suitability of a tool for the open contour, in a few words. */
export function useToolVerdict(): (fit: ToolFit) => string {
  const t = useTexts().setup.tool;
  const language = useSettings((s) => s.language);
  return (fit) =>
    fit.makesContour ? t.makes : fit.unreached > 0 ? t.leaves(formatNumber(language, fit.unreached, 2)) : t.cannot;
}

/** A tool in two lines, with its suitability for the open contour once that is known. */
export function ToolWords({ tool, fit }: { readonly tool: Tool; readonly fit: ToolFit | undefined }) {
  const details = useToolDetails();
  return (
    <span className="tool-words">
      <span>
        <b className="number">{tool.T}</b> <b>{tool.NAME}</b>
      </span>
      <span className="small soft">{details(tool)}</span>
      {fit && <Verdict fit={fit} />}
    </span>
  );
}

/** The verdict with its mark. */
function Verdict({ fit }: { readonly fit: ToolFit }) {
  const verdict = useToolVerdict();
  return (
    <span className={`small tool-fit ${fit.makesContour ? "good" : "bad"}`}>
      <Icon name={fit.makesContour ? "check" : "warning"} /> {verdict(fit)}
    </span>
  );
}
