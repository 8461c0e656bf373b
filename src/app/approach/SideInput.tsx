import { useLayoutEffect, useRef } from "react";
import { SIDES } from "../../program/approach-draft.ts";
import { useTexts } from "../settings/use-texts.ts";

/** RL, RR or R0 as a choice; left and right move, ENT goes on. */
export function SideInput({ text, name, describedBy, focus, onText }: {
  readonly text: string;
  readonly name: string;
  readonly describedBy: string;
  readonly focus: number;
  readonly onText: (text: string) => void;
}) {
  const t = useTexts().approach;
  const group = useRef<HTMLFieldSetElement>(null);
  useLayoutEffect(() => {
    if (focus === 0) return;
    const radios = group.current?.querySelectorAll("input");
    (group.current?.querySelector<HTMLInputElement>("input:checked") ?? radios?.[0])?.focus({ preventScroll: true });
  }, [focus]);
  const chosen = SIDES.findIndex((side) => side === text.trim());
  const take = (at: number) => {
    const side = SIDES[at];
    if (!side) return;
    onText(side);
    group.current?.querySelectorAll("input")[at]?.focus({ preventScroll: true });
  };
  return (
    <fieldset
      ref={group} className="choices" role="radiogroup" aria-label={name} aria-describedby={describedBy}
      onKeyDown={(event) => {
        const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
        if (by === 0) return;
        event.preventDefault();
        take(Math.min(SIDES.length - 1, Math.max(0, chosen + by)));
      }}
    >
      {SIDES.map((side, i) => (
        <label key={side} className="choice">
          <input type="radio" name="approach-side" value={side} checked={i === chosen} onChange={() => take(i)} />
          <span className="number choice-number">{side}</span>
          <span>{t.sides[side]}</span>
        </label>
      ))}
    </fieldset>
  );
}
