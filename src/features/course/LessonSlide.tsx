import { useId } from "react";
import type { Lesson } from "../../course/lesson.ts";
import { cycleOfParameter } from "../../course/playback-range.ts";
import { cycleByNumber, type ParamTextId } from "../../cycles/index.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { ChoiceText } from "../../i18n/param-text.ts";
import { unitOf } from "../../app/fields/dialog/write-value.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

type Slide = NonNullable<Lesson["pages"][number]["slide"]>;

/** A slider for one value: its name on the control, the number, the slider. The picture follows. */
export function LessonSlide({
  slide,
  value,
  lines,
  onSlide,
}: {
  readonly slide: Slide;
  readonly value: number;
  /** The program of the page; its first cycle with this parameter describes the value. */
  readonly lines: readonly string[];
  readonly onSlide: (value: number) => void;
}) {
  const texts = useTexts();
  const language = useSettings((s) => s.language);
  const id = useId();
  const { q, from, to, step } = slide;
  const param = cycleByNumber(cycleOfParameter(lines, q) ?? 0)?.params[q];
  const words = param && texts.params[param.text as ParamTextId];
  const choice = words && "choices" in words ? (words as ChoiceText).choices[value] : undefined;
  const unit = param ? texts.dialog.units[unitOf(param, true)] : "";
  const number = [formatNumber(language, value), unit].filter((each) => each !== "").join(" ");
  const said = choice ? `${number} ${choice}` : number;
  return (
    <div className="lesson-slide">
      <label htmlFor={id}>
        <span className="number">{q}</span> {words?.label}
      </label>
      {/* The slider itself says its value. */}
      <output className="number" htmlFor={id} aria-live="off">
        {number}
      </output>
      {choice && <p className="lesson-choice small">{choice}</p>}
      <input
        id={id}
        type="range"
        min={from}
        max={to}
        step={step}
        value={value}
        aria-valuetext={said}
        onChange={(event) => onSlide(Number(event.currentTarget.value))}
      />
    </div>
  );
}
