import { useId } from "react";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import { formatNumber } from "../../../i18n/number.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import type { NamedThread } from "../../../kernel/thread/named-thread.ts";
import { radius, toDiameter } from "../../../kernel/units.ts";
import { coreOf } from "../../../program/tools/tap-of-thread.ts";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";

interface Props {
  readonly words: InsertTexts;
  readonly text: string;
  /** The thread that the text names, if a tap makes it. */
  readonly thread: NamedThread | null;
  /** Diameter of the bore in the stock, mm; null for none. */
  readonly bore: number | null;
  /** The drill for the hole before it, where there is no bore. */
  readonly drill: Tool | null;
  readonly isDrilled: boolean;
  readonly onText: (text: string) => void;
  readonly onDrilled: (isDrilled: boolean) => void;
}

/** The thread of a tap by its name, its core, and drilling before it. */
export function TapField({ words: { hand }, text, thread, bore, drill, isDrilled, onText, onDrilled }: Props) {
  const id = useId();
  const language = useSettings((s) => s.language);
  const write = (mm: number) => formatNumber(language, mm, 3);
  const core = thread && coreOf(thread);
  const limits = core ? ([write(core.limits[0]), write(core.limits[1])] as const) : null;
  const isWrong = core !== null && bore !== null && (bore < core.limits[0] || bore > core.limits[1]);
  return (
    <div className="wide operation-tap">
      <label htmlFor={id}>
        <span>{hand.thread}</span>
        <input
          id={id}
          className="input"
          autoComplete="off"
          spellCheck={false}
          placeholder="M10, M20×1.5, G1/2"
          value={text}
          aria-invalid={text.trim() !== "" && !thread}
          aria-describedby={`${id}-said`}
          onChange={(event) => onText(event.target.value)}
        />
      </label>
      <span id={`${id}-said`} className="small soft">
        {limits && hand.core(...limits)}
        {text.trim() !== "" && !thread && (
          <Message as="span" tone="warning">
            {hand.noTap}
          </Message>
        )}
      </span>
      {limits && isWrong && <Message tone="warning">{hand.wrongBore(write(bore), ...limits)}</Message>}
      {drill && (
        <label className="operation-drilled">
          <input type="checkbox" checked={isDrilled} onChange={(event) => onDrilled(event.target.checked)} />
          <span>{hand.drillBefore(write(toDiameter(radius(drill.R ?? 0))), drill.T)}</span>
        </label>
      )}
    </div>
  );
}
