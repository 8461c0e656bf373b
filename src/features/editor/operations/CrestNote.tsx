import type { ThreadFill } from "../../../cycles/thread-values.ts";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { toDiameter } from "../../../kernel/units.ts";
import type { StockSurface } from "../../../program/job/stock-surface.ts";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";

/** Share of the depth of a thread by which its shaft or bore may differ. */
const MUCH = 0.1;

/** Says when a surface is not the shaft or the bore that a thread needs. */
export function CrestNote({
  words,
  fill: { inside, before, cut },
  surface,
}: {
  readonly words: InsertTexts;
  readonly fill: ThreadFill;
  readonly surface: StockSurface;
}) {
  const language = useSettings((s) => s.language);
  const write = (mm: number) => formatNumber(language, mm, 3);
  const is = toDiameter(surface.from.r);
  if (Math.abs(is - before) <= 2 * MUCH * cut.depth) return null;
  return (
    <Message tone="warning">{words.threadBefore[inside ? "inside" : "outside"](write(before), write(is))}</Message>
  );
}
