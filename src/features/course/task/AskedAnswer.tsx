import { useId } from "react";
import type { Prediction } from "../../../course/task.ts";
import { answerKindOf } from "../../../course/predicted-answers.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { enterNext } from "../../../app/fields/number/enter-next.ts";
import { NumberInput } from "../../../app/fields/number/NumberInput.tsx";

interface AskedProps {
  readonly prediction: Prediction;
  /** Gets the answer at each keystroke. */
  readonly put: (text: string) => void;
  readonly text: string;
  readonly choices: readonly string[];
  readonly t: CourseTaskTexts;
  readonly labelled: string;
}

const bare = (text: string) => text.replaceAll(" ", "");

const onEnter = enterNext();

/** The field of one question: a number, a place, one of several, or a block. */
export function AskedAnswer({ prediction, put, text, choices, t, labelled }: AskedProps) {
  const name = useId();
  const kind = answerKindOf(prediction);
  const field = (label: string, sign: string, value: string, take: (next: string) => void, unit = "") => (
    <label className="task-field">
      {sign !== "" && (
        <span className="number" aria-hidden="true">
          {sign}
        </span>
      )}
      <NumberInput
        kind="typed"
        inputMode="decimal"
        maxLength={12}
        text={value}
        onText={take}
        aria-label={label}
        aria-describedby={labelled}
      />
      {unit !== "" && <span className="soft small">{unit}</span>}
    </label>
  );
  if (kind === "choice") {
    return (
      <fieldset className="task-choices" aria-labelledby={labelled}>
        {choices.map((choice, i) => (
          <label key={i} className="task-choice">
            <input type="radio" name={name} checked={text === String(i)} onChange={() => put(String(i))} />{" "}
            <span>{choice}</span>
          </label>
        ))}
      </fieldset>
    );
  }
  if (kind === "place") {
    const [x = "", z = ""] = text.split(" ");
    return (
      <div className="task-fields" onKeyDown={onEnter}>
        <span className="small">{t.predict.place}</span>
        {field(t.predict.x, "⌀", x, (next) => put(`${bare(next)} ${z}`))}
        {field(t.predict.z, "Z", z, (next) => put(`${x} ${bare(next)}`))}
      </div>
    );
  }
  if (kind === "block") {
    return (
      <div className="task-fields">
        <span className="soft small">{t.predict.tapBlock}</span>
        {field(t.predict.block, "", text, put)}
      </div>
    );
  }
  const { ask } = prediction;
  const unit = ask in t.predict.units ? t.predict.units[ask as keyof typeof t.predict.units] : "";
  return <div className="task-fields">{field(t.predict.answer, "", text, put, unit)}</div>;
}
