import { useId, useMemo, useState, type ReactNode } from "react";
import type { ContourChoice, DrawnContour, Drawing, DrawingGiven } from "../../program/drawing/drawing.ts";
import { anyNumber, readText, type Field } from "../../program/values/field.ts";
import { INCH } from "../../kernel/units.ts";
import { formatNumber } from "../../i18n/number.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { NumberInput } from "../../app/fields/number/NumberInput.tsx";
import { zeroPositions } from "../../program/drawing/positions.ts";

interface Props {
  readonly drawing: Drawing;
  readonly choice: ContourChoice;
  readonly proposed: ContourChoice;
  readonly contour: DrawnContour;
  /** Reads the drawing again. */
  readonly onGiven: (given: DrawingGiven) => void;
  /** Another direction of the axis, with its likeliest place. */
  readonly onAxis: (axis: ContourChoice["axis"]) => void;
  readonly onChange: (change: Partial<ContourChoice>) => void;
}

const POSITION: Field = { ...anyNumber, optional: false };
const GAP: Field = { ...anyNumber, range: [0, 10], optional: false };
/** Most layers and pieces offered in a list. */
const MOST_LAYERS = 60;
const MOST_PIECES = 100;

/** A number that is typed; until it is valid the previous one stays in force. */
function Position({
  name,
  value,
  per,
  field,
  onValue,
}: {
  readonly name: string;
  readonly value: number;
  /** Millimetres per shown unit. */
  readonly per: number;
  readonly field: Field;
  readonly onValue: (value: number) => void;
}) {
  const shown = String(Number((value / per).toFixed(4)));
  const [typed, type] = useState<{ readonly text: string; readonly of: number } | null>(null);
  const text = typed && typed.of === value ? typed.text : shown;
  return (
    <NumberInput
      text={text}
      aria-label={name}
      aria-invalid={readText(field, text).issue !== null}
      onText={(next) => {
        const read = readText(field, next).value;
        const mm = read === null ? value : read * per;
        type({ text: next, of: mm });
        if (mm !== value) onValue(mm);
      }}
      onLeave={() => type(null)}
    />
  );
}

/** All choices by name, next to the picture on which they can be picked. */
export function DrawingChoices({ drawing, choice, proposed, contour, onGiven, onAxis, onChange }: Props) {
  const t = useTexts("drawing-import"),
    language = useSettings((s) => s.language),
    id = useId();
  const { axis } = choice,
    per = drawing.unit.unit === "inch" ? INCH : 1;
  const ends = useMemo(() => zeroPositions(drawing, choice, contour), [drawing, choice, contour]);
  const isProposed = (...keys: readonly (keyof ContourChoice)[]) => keys.every((key) => choice[key] === proposed[key]);
  const group = (name: string, isOwn: boolean, content: ReactNode) => (
    <fieldset className="drawing-choice">
      <legend>
        {name} {isOwn && <span className="small soft proposal">{t.proposed}</span>}
      </legend>
      {content}
    </fieldset>
  );
  const either = <K extends "axis" | "half" | "side">(
    key: K,
    options: readonly (readonly [ContourChoice[K], string])[],
    onChosen: (value: ContourChoice[K]) => void,
  ) => (
    <span className="drawing-either">
      {options.map(([value, name]) => (
        <label key={name} className="choice">
          <input type="radio" name={`${id}-${key}`} checked={choice[key] === value} onChange={() => onChosen(value)} />
          <span>{name}</span>
        </label>
      ))}
    </span>
  );
  const layers = [...new Set(drawing.curves.map(({ layer }) => layer))];
  const tick = (key: "diameters" | "reversed" | "thin", name: string) => (
    <label className="choice">
      <input type="checkbox" checked={choice[key]} onChange={(e) => onChange({ [key]: e.currentTarget.checked })} />
      <span>{name}</span>
    </label>
  );
  return (
    <>
      <label className="drawing-unit">
        <span>{t.unit}</span>
        <select
          className="select"
          value={drawing.unit.unit}
          onChange={(e) => onGiven({ unit: e.currentTarget.value === "inch" ? "inch" : "mm" })}
        >
          <option value="mm">{t.units.mm}</option>
          <option value="inch">{t.units.inch}</option>
        </select>
        <span className={`small ${drawing.unit.source === "assumed" ? "assumed" : "soft"}`}>
          {t.source[drawing.unit.source]}
        </span>
      </label>
      {drawing.bodies && drawing.bodies.all.length > 1 && (
        <label className="drawing-line">
          <span>{t.body}</span>
          <select
            className="select"
            value={drawing.bodies.drawn}
            onChange={(e) => onGiven({ body: Number(e.currentTarget.value) })}
          >
            {drawing.bodies.all.map(({ name, across, length }, i) => (
              <option key={i} value={i}>
                {t.bodyOf(i + 1, name, formatNumber(language, across, 1), formatNumber(language, length, 1))}
              </option>
            ))}
          </select>
        </label>
      )}
      {contour.hasSides &&
        group(
          t.side,
          isProposed("side"),
          either(
            "side",
            [
              ["outside", t.sides.outside],
              ["bore", t.sides.bore],
            ],
            (side) => onChange({ side }),
          ),
        )}
      {group(
        t.half,
        isProposed("half"),
        either(
          "half",
          [
            ["upper", t.halves[axis].upper],
            ["lower", t.halves[axis].lower],
          ],
          (half) => onChange({ half, piece: 0 }),
        ),
      )}
      {contour.pieces.length > 1 && (
        <label className="drawing-line">
          <span>{t.piece}</span>
          <select
            className="select"
            value={choice.piece}
            onChange={(e) => onChange({ piece: Number(e.currentTarget.value) })}
          >
            {contour.pieces.slice(0, Math.max(MOST_PIECES, choice.piece + 1)).map(({ length }, i, { length: all }) => (
              <option key={i} value={i}>
                {t.pieceOf(i + 1, all, formatNumber(language, length, 1))}
              </option>
            ))}
          </select>
        </label>
      )}
      {group(
        t.axis,
        isProposed("axis", "axisAt"),
        <>
          {either(
            "axis",
            [
              ["x", t.level],
              ["y", t.upright],
            ],
            onAxis,
          )}
          <span className="drawing-at">
            <span>{t.axisAt[axis]}</span>
            <Position
              name={`${t.axis} ${t.axisAt[axis]}`}
              value={choice.axisAt}
              per={per}
              field={POSITION}
              onValue={(axisAt) => onChange({ axisAt })}
            />
          </span>
        </>,
      )}
      {group(
        t.zero,
        isProposed("zero", "mirrored"),
        <>
          <span className="drawing-at">
            <span>{t.zeroAt[axis]}</span>
            <Position
              name={`${t.zero} ${t.zeroAt[axis]}`}
              value={choice.zero}
              per={per}
              field={POSITION}
              onValue={(zero) => onChange({ zero })}
            />
          </span>
          <span className="drawing-ends">
            {(["low", "high"] as const).map((end) => {
              const zero = end === "low" ? ends[0] : ends.at(-1);
              return (
                <button
                  key={end}
                  type="button"
                  className="button"
                  disabled={zero === undefined}
                  aria-pressed={zero === choice.zero}
                  onClick={() => zero !== undefined && onChange({ zero })}
                >
                  {t.atEnd[axis][end]}
                </button>
              );
            })}
          </span>
          <label className="drawing-line">
            <span>{t.zWay}</span>
            <select
              className="select"
              value={choice.mirrored ? "back" : "forward"}
              onChange={(e) => onChange({ mirrored: e.currentTarget.value === "back" })}
            >
              <option value="forward">{t.zWays[axis].forward}</option>
              <option value="back">{t.zWays[axis].back}</option>
            </select>
          </label>
        </>,
      )}
      <details className="drawing-more">
        <summary>{t.more}</summary>
        {tick("reversed", t.reversed)}
        {tick("thin", t.thin)}
        {tick("diameters", t.diameters)}
        <label className="drawing-line">
          <span>{t.gap}</span>
          <Position
            name={t.gap}
            value={choice.gap}
            per={1}
            field={GAP}
            onValue={(gap) => onChange({ gap, piece: 0 })}
          />
        </label>
        {layers.length > 1 && (
          <fieldset className="drawing-choice">
            <legend>{t.layers}</legend>
            {layers.slice(0, MOST_LAYERS).map((layer) => (
              <label key={layer} className="choice">
                <input
                  type="checkbox"
                  checked={!choice.withoutLayers.includes(layer)}
                  onChange={(e) =>
                    onChange({
                      withoutLayers: e.currentTarget.checked
                        ? choice.withoutLayers.filter((each) => each !== layer)
                        : [...choice.withoutLayers, layer],
                      piece: 0,
                    })
                  }
                />
                <span>{layer}</span>
              </label>
            ))}
          </fieldset>
        )}
      </details>
    </>
  );
}
