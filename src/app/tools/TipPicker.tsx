import type { KeyboardEvent } from "react";
import type { TipOrientation, Tool } from "../../kernel/tool.ts";
import { InsertDrawing } from "../lathe/InsertDrawing.tsx";
import { useTexts } from "../settings/use-texts.ts";

/** Edge length of one picture, px. */
const DRAWING = 44;

/** The orientations where they point to on the lathe: Z to the right, X up. */
const PLACES: readonly TipOrientation[] = [7, 6, 5, 8, 9, 4, 1, 2, 3];
const COLUMNS = 3;
const STEPS: Readonly<Record<string, readonly [right: number, down: number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowDown: [0, 1],
  ArrowUp: [0, -1],
};

/** An arrow towards one of the eight directions, or a ring for none. */
function Arrow({ place }: { readonly place: number }) {
  const right = (place % COLUMNS) - 1;
  const down = Math.floor(place / COLUMNS) - 1;
  if (right === 0 && down === 0)
    return (
      <svg className="tip-arrow" viewBox="-12 -12 24 24">
        <circle r="6" />
      </svg>
    );
  const angle = (Math.atan2(down, right) * 180) / Math.PI;
  return (
    <svg className="tip-arrow" viewBox="-12 -12 24 24">
      <path d="M-8 0H8M2 -6L8 0L2 6" transform={`rotate(${angle})`} />
    </svg>
  );
}

/** TO by its picture: nine directions round the centre of the nose, each with the insert as it would stand. */
export function TipPicker({ name, value, tool, onChoose }: {
  readonly name: string;
  readonly value: number | null;
  /** The tool to draw in each direction; null while its other columns make none. */
  readonly tool: Tool | null;
  readonly onChoose: (to: TipOrientation) => void;
}) {
  const t = useTexts().tools;
  const onKeyDown = (event: KeyboardEvent<HTMLInputElement>, place: number) => {
    const step = STEPS[event.key];
    if (!step || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const wrap = (n: number) => (n + COLUMNS) % COLUMNS;
    const next = wrap(Math.floor(place / COLUMNS) + step[1]) * COLUMNS + wrap((place % COLUMNS) + step[0]);
    event.currentTarget.closest("fieldset")?.querySelectorAll("input")[next]?.focus();
    const to = PLACES[next];
    if (to) onChoose(to);
  };
  const chosen = PLACES.findIndex((to) => to === value);
  return (
    <fieldset className="tip-picker" role="radiogroup" aria-label={t.orientation}>
      <legend>
        <b className="number">TO</b> <span className="soft small">{t.columns.TO}</span>
      </legend>
      <div className="tip-grid">
        {PLACES.map((to, place) => (
          <label key={to} className="tip-choice" title={t.orientationOf(to, t.directions[to - 1] ?? "")}>
            <input type="radio" name={name} checked={to === value} tabIndex={place === Math.max(chosen, 0) ? 0 : -1}
              aria-label={t.orientationOf(to, t.directions[to - 1] ?? "")} onChange={() => onChoose(to)} onKeyDown={(e) =>
              onKeyDown(e, place)} />
            <span className="tip-picture" aria-hidden="true">
              {tool && <InsertDrawing tool={{ ...tool, TO: to }} width={DRAWING} height={DRAWING} />}
            </span>
            <span className="tip-words" aria-hidden="true">
              <b className="number">{to}</b>
              <Arrow place={place} />
            </span>
          </label>
        ))}
      </div>
      <p className="soft small">{t.orientationHint}</p>
    </fieldset>
  );
}
