import { useMemo, useState } from "react";
import { pageLength } from "../../app/base/unit.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { ToolsTexts } from "../../i18n/en/tables/tools.ts";
import { insertOutline, isBar, plungesAxially } from "../../kernel/cutter/insert.ts";
import { CHORD, ROUND, SAME } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { boundsOf } from "../../view/bounds.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { heldBounds, InsertDrawing } from "../../app/pictures/lathe/InsertDrawing.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Edges of the drawing, px. */
const WIDTH = 176;
const HEIGHT = 148;

/** The next of 1, 2, 5, 10, 20 … not below a length, so that the scale does not change at each keystroke. */
export function scaleLengthFor(length: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(length, SAME)));
  return [1, 2, 5, 10].map((n) => n * power).find((n) => n >= length - ROUND) ?? length;
}

/** The tool of a row, or its last valid one while its cells are invalid. */
export function useLastValidTool(id: string, tool: Tool | null): Tool | null {
  const [last, setLast] = useState<{ readonly id: string; readonly tool: Tool } | null>(null);
  if (tool && (last?.id !== id || last.tool !== tool)) setLast({ id, tool });
  return tool ?? (last?.id === id ? last.tool : null);
}

/** The stated limits of a tool, each in a few words. */
function limitsOf(tool: Tool, number: (n: number) => string, { limitsOf: w }: ToolsTexts): string[] {
  const { DAXN, DAXX, CDX, DMIN } = tool;
  return [
    ...(plungesAxially(tool) && DAXN !== undefined && DAXX !== undefined ? [w.axial(number(DAXN), number(DAXX))] : []),
    ...(isBar(tool) && CDX !== undefined ? [w.depth(number(CDX))] : []),
    ...(DMIN === undefined ? [] : [w.bore(number(DMIN))]),
  ];
}

/** The insert of the open row to scale, with a reference length; updated at each keystroke. */
export function LiveInsert({
  tool,
  now,
}: {
  /** The tool to draw; null if there is none. */
  readonly tool: Tool | null;
  /** False while the cells are invalid and the last valid tool is drawn. */
  readonly now: boolean;
}) {
  const t = useTexts("tables").tools;
  const language = useSettings((s) => s.language);
  const measured = useMemo(() => {
    const insert = tool && boundsOf(insertOutline(tool, CHORD));
    if (!tool || !insert) return null;
    const all = heldBounds(tool);
    const span = scaleLengthFor(Math.max((all.right - all.left) * (HEIGHT / WIDTH), all.high - all.low) * 1.12);
    return { width: insert.right - insert.left, height: insert.high - insert.low, span, bar: scaleLengthFor(span / 6) };
  }, [tool]);
  if (!tool || !measured)
    return (
      <div className="live-insert">
        <p className="soft small">{t.noDrawing}</p>
      </div>
    );
  const number = (n: number, decimals: number) => formatNumber(language, n, decimals);
  const pixels = (measured.bar * Math.min(WIDTH, HEIGHT)) / measured.span;
  return (
    <figure className={`live-insert${now ? "" : " dimmed"}`} aria-label={t.drawing}>
      <InsertDrawing tool={tool} width={WIDTH} height={HEIGHT} span={measured.span} whole />
      <figcaption className="small">
        <span className="scale-bar number">
          <i style={{ width: pageLength(pixels) }} /> {t.scale(number(measured.bar, 3))}
        </span>
        <span className="soft number">{t.size(number(measured.width, 2), number(measured.height, 2))}</span>
        {limitsOf(tool, (n) => number(n, 3), t).map((each) => (
          <span key={each} className="soft number">
            {each}
          </span>
        ))}
        {!now && (
          <span className="last-possible">
            <Icon name="info" /> {t.lastPossible}
          </span>
        )}
      </figcaption>
    </figure>
  );
}
