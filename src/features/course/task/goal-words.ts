import type { TaskGoal } from "../../../course/goals.ts";
import type { TaskRules, TaskSize } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import type { Language } from "../../../i18n/languages.ts";
import { formatNumber, formatSigned } from "../../../i18n/number.ts";
import { writer } from "../../../i18n/write.ts";
import { durationText, type DurationWords } from "../../../app/base/clock-text.ts";

/** A deviation with its sign; 0 has none. */
const deviation = (language: Language, value: number) => (value === 0 ? "0" : formatSigned(language, value));

/** A nominal size with its deviations: 40 ±0.02, 40 0/-0.05. */
export function toleranced(
  language: Language,
  { nominal, upper, lower }: Pick<TaskSize, "nominal" | "upper" | "lower">,
): string {
  const limits =
    upper === -lower
      ? `±${formatNumber(language, upper)}`
      : `${deviation(language, upper)}/${deviation(language, lower)}`;
  return `${formatNumber(language, nominal)} ${limits}`;
}

/** A size of the machined part, with its place of measurement. */
export const sizeGoal = (t: CourseTaskTexts, language: Language, size: TaskSize): string =>
  t.is.size[size.kind](
    toleranced(language, size),
    size.kind === "face" ? formatNumber(language, size.at) : formatSigned(language, size.at),
  );

/** The required value of a parameter. */
export function valueGoal(
  t: CourseTaskTexts,
  language: Language,
  asked: NonNullable<TaskRules["values"]>[number],
): string {
  const { q, from, to, cycle } = asked;
  const number = (value: number) => formatNumber(language, value);
  const said = () => {
    if (from !== undefined && to !== undefined)
      return from === to ? t.is.exact(q, number(from)) : t.is.between(q, number(from), number(to));
    return from === undefined ? t.is.most(q, number(to ?? 0)) : t.is.least(q, number(from));
  };
  return cycle === undefined ? said() : t.is.ofCycle(said(), String(cycle));
}

/** A list in words: 1, 3 and 4. */
function listed(t: CourseTaskTexts, all: readonly string[]): string {
  const [last = "", ...before] = all.toReversed();
  return before.length === 0 ? last : t.is.and(before.toReversed().join(", "), last);
}

/** A goal in words, with its numbers. */
export function goalText(t: CourseTaskTexts, duration: DurationWords, language: Language, goal: TaskGoal): string {
  const number = (value: number) => formatNumber(language, value);
  const { is } = t;
  switch (goal.kind) {
    case "predicted":
      return is.answered(goal.entry + 1, goal.of);
    case "part":
      return goal.residue === null ? is.part : is.partLeaving(writer(language).area(goal.residue));
    case "size":
      return sizeGoal(t, language, goal.size);
    case "safe":
    case "clean":
      return is[goal.kind];
    case "seconds":
      return is.seconds(durationText(duration, language, goal.limit));
    case "depth":
    case "speed":
      return is[goal.kind](number(goal.limit));
    case "mostTools":
    case "passes":
      return is[goal.kind](goal.limit);
    case "tools":
      return is.tools(listed(t, goal.tools.map(String)), goal.tools.length);
    case "cycles":
    case "without":
      return is[goal.kind](String(goal.cycle));
    case "values":
      return valueGoal(t, language, goal.asked);
    case "rz":
      return is.rz(
        number(goal.asked.most),
        formatSigned(language, goal.asked.from),
        formatSigned(language, goal.asked.to),
      );
    case "words":
      return is.words(goal.word);
  }
}
