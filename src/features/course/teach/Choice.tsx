import { LESSON_LANGUAGES, SCREEN_LANGUAGES, type LessonLanguage } from "../../../i18n/languages.ts";

/** Names of the languages in which texts are written; those that have texts are ticked. */
export const languageNames = (has: (language: LessonLanguage) => boolean): Readonly<Record<LessonLanguage, string>> =>
  Object.fromEntries(
    LESSON_LANGUAGES.map((each) => [each, SCREEN_LANGUAGES[each].name + (has(each) ? " ✓" : "")]),
  ) as Record<LessonLanguage, string>;

/** A choice of one, each in words. */
export function Choice<T extends string>({
  label,
  names,
  all,
  value,
  change,
}: {
  readonly label: string;
  readonly names: Readonly<Record<T, string>>;
  readonly all: readonly T[];
  readonly value: T;
  readonly change: (value: T) => void;
}) {
  return (
    <label className="teach-text">
      {label}
      <select
        className="select"
        value={value}
        onChange={(event) => {
          const chosen = all.find((each) => each === event.currentTarget.value);
          if (chosen) change(chosen);
        }}
      >
        {all.map((each) => (
          <option key={each} value={each}>
            {names[each]}
          </option>
        ))}
      </select>
    </label>
  );
}
