import { useId, useState } from "react";
import type { TaskForm, WordsDraft } from "../../../course/made/task-form.ts";
import { hasQuestions } from "../../../course/made/task-from-form.ts";
import { LESSON_LANGUAGES, SCREEN_LANGUAGES, type LessonLanguage } from "../../../i18n/languages.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { Choice, languageNames } from "./Choice.tsx";

/** Props of each part of the form: its current state, and the setter. */
export interface FormPart {
  readonly made: TaskForm;
  /** `isStep`: removes typed content, so undo is offered. */
  readonly change: (some: Partial<TaskForm>, isStep?: boolean) => void;
}

/** A text of the form, of one line or of several. */
export function TeachText({
  label,
  hint,
  value,
  rows = 1,
  isNc = false,
  change,
}: {
  readonly label: string;
  readonly hint?: string;
  readonly value: string;
  readonly rows?: number;
  readonly isNc?: boolean;
  readonly change: (text: string) => void;
}) {
  const id = useId();
  const shared = {
    id,
    value,
    className: isNc ? "input number" : "input",
    spellCheck: !isNc,
    ...(hint !== undefined && { "aria-describedby": `${id}-hint` }),
  };
  return (
    <div className="teach-text">
      <label htmlFor={id}>{label}</label>
      {rows > 1 ? (
        <textarea
          {...shared}
          rows={rows}
          maxLength={isNc ? 60_000 : 2000}
          onChange={(event) => change(event.currentTarget.value)}
        />
      ) : (
        <input {...shared} maxLength={200} onChange={(event) => change(event.currentTarget.value)} />
      )}
      {hint !== undefined && (
        <p id={`${id}-hint`} className="small soft">
          {hint}
        </p>
      )}
    </div>
  );
}

const NO_WORDS: WordsDraft = { title: "", ask: "", hints: ["", "", ""] };

/** Title, assignment and hints in one language; `label` names the field in it. */
function OneLanguage({
  words,
  say,
  label,
}: {
  readonly words: WordsDraft;
  readonly say: (some: Partial<WordsDraft>) => void;
  readonly label: (field: string) => string;
}) {
  const t = useTexts("course-teach"),
    { hintOptional } = useTexts("course-set");
  const at = (index: 0 | 1 | 2, typed: number, text: string) => (index === typed ? text : words.hints[index]);
  return (
    <>
      <TeachText label={label(t.name)} value={words.title} change={(title) => say({ title })} />
      <TeachText label={label(t.ask)} hint={t.askHint} rows={4} value={words.ask} change={(ask) => say({ ask })} />
      {words.hints.map((hint, i) => (
        <TeachText
          key={i}
          label={label(t.hints[i] ?? "")}
          {...(i === 0 && { hint: hintOptional })}
          rows={2}
          value={hint}
          change={(text) => say({ hints: [at(0, i, text), at(1, i, text), at(2, i, text)] })}
        />
      ))}
    </>
  );
}

/** The texts in further languages, one after the other. */
function Translations({ made, change, first }: FormPart & { readonly first: LessonLanguage }) {
  const t = useTexts("course-set");
  const others = LESSON_LANGUAGES.filter((each) => each !== first);
  const [language, speak] = useState<LessonLanguage>(others[0] ?? first);
  const { translations = {} } = made;
  const words = translations[language] ?? NO_WORDS;
  const name = SCREEN_LANGUAGES[language].name;
  return (
    <details className="teach-more">
      <summary>{t.translations}</summary>
      <p className="small soft">{t.translationsHint}</p>
      <Choice
        label={t.language}
        names={languageNames((each) => translations[each] !== undefined)}
        all={others}
        value={language}
        change={speak}
      />
      <OneLanguage
        key={language}
        words={words}
        label={(field) => t.textIn(field, name)}
        say={(some) => {
          const next = { ...words, ...some },
            { [language]: _, ...rest } = translations;
          const isEmpty = [next.title, next.ask, ...next.hints].every((text) => text === "");
          change({ translations: isEmpty ? rest : { ...translations, [language]: next } });
        }}
      />
    </details>
  );
}

/** Kind, and the texts: title, assignment and hints, in one language or several. */
export function WordFields({
  made,
  change,
  kinds,
  language,
}: FormPart & { readonly kinds: readonly TaskForm["kind"][]; readonly language: LessonLanguage }) {
  const t = useTexts("course-teach");
  const name = useId();
  const { words, kind } = made;
  return (
    <fieldset>
      <legend>{t.words}</legend>
      <div role="radiogroup" aria-label={t.kind} className="teach-choices">
        {kinds.map((each) => (
          <label key={each} className="teach-check">
            <input
              type="radio"
              name={name}
              checked={kind === each}
              onChange={() =>
                change({ kind: each, ...(hasQuestions(each) && made.start === "empty" && { start: "program" }) })
              }
            />
            {t.kinds[each]}
          </label>
        ))}
      </div>
      <OneLanguage words={words} label={(field) => field} say={(some) => change({ words: { ...words, ...some } })} />
      <Translations made={made} change={change} first={language} />
    </fieldset>
  );
}
