import { useRef } from "react";
import { Radio, RadioGroup, type RadioProps } from "react-aria-components/RadioGroup";
import type { TipOrientation, Tool } from "../../kernel/plan/tool.ts";
import { InsertDrawing } from "../../app/pictures/lathe/InsertDrawing.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Edge length of one picture, px. */
const DRAWING = 44;

/** The orientations as they point on the lathe: Z to the right, X up. */
const PLACES: readonly TipOrientation[] = [7, 6, 5, 8, 9, 4, 1, 2, 3];
const COLUMNS = 3;
/** Up and down move by rows; left and right work as in every radio group. */
const ROWS: Readonly<Record<string, number>> = { ArrowDown: COLUMNS, ArrowUp: -COLUMNS };

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

/** TO by its picture: nine directions around the centre of the nose, each with the insert in that orientation. */
export function TipPicker({
  value,
  tool,
  onChoose,
}: {
  readonly value: number | null;
  /** The tool to draw in each direction; null while its other columns are invalid. */
  readonly tool: Tool | null;
  readonly onChoose: (to: TipOrientation) => void;
}) {
  const t = useTexts("tables").tools;
  const grid = useRef<HTMLDivElement>(null);
  const choose = (to: TipOrientation | undefined) => to && onChoose(to);
  const keys =
    (place: number): NonNullable<RadioProps["onKeyDown"]> =>
    (event) => {
      const by = event.altKey || event.ctrlKey || event.metaKey ? undefined : ROWS[event.key];
      if (by === undefined) return event.continuePropagation();
      event.preventDefault();
      const next = (place + by + PLACES.length) % PLACES.length;
      choose(PLACES[next]);
      grid.current?.querySelectorAll("input")[next]?.focus();
    };
  return (
    <fieldset className="tip-picker">
      <legend>
        <b className="number">TO</b> <span className="soft small">{t.columns.TO}</span>
      </legend>
      <RadioGroup
        ref={grid}
        className="tip-grid"
        aria-label={t.orientation}
        value={value === null ? null : String(value)}
        onChange={(chosen) => choose(PLACES.find((to) => String(to) === chosen))}
      >
        {PLACES.map((to, place) => (
          <Radio
            key={to}
            value={String(to)}
            className="tip-choice"
            aria-label={t.orientationOf(to, t.directions[to - 1] ?? "")}
            onKeyDown={keys(place)}
            render={(label) => <label {...label} title={t.orientationOf(to, t.directions[to - 1] ?? "")} />}
          >
            <span className="tip-picture" aria-hidden="true">
              {tool && <InsertDrawing tool={{ ...tool, TO: to }} width={DRAWING} height={DRAWING} />}
            </span>
            <span className="tip-words" aria-hidden="true">
              <b className="number">{to}</b>
              <Arrow place={place} />
            </span>
          </Radio>
        ))}
      </RadioGroup>
      <p className="soft small">{t.orientationHint}</p>
    </fieldset>
  );
}
