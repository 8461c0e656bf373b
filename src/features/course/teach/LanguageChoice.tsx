import { SCREEN_LANGUAGES, type LessonLanguage } from "../../../i18n/languages.ts";

/** The language in which texts are written; those that have texts are ticked. */
export function LanguageChoice({
  label,
  all,
  value,
  has,
  change,
}: {
  readonly label: string;
  readonly all: readonly LessonLanguage[];
  readonly value: LessonLanguage;
  readonly has: (language: LessonLanguage) => boolean;
  readonly change: (language: LessonLanguage) => void;
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
            {SCREEN_LANGUAGES[each].name}
            {has(each) ? " ✓" : ""}
          </option>
        ))}
      </select>
    </label>
  );
}
