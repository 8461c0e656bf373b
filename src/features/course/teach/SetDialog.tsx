import { useState } from "react";
import { EXAM_REPORTS, SET_HELP, SET_LIMITS, isForLearners, type TaskSet } from "../../../course/task-set.ts";
import { shownLanguageOf } from "../../../course/words.ts";
import { LESSON_LANGUAGES, lessonLanguageOf } from "../../../i18n/languages.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { NumberInput } from "../../../app/fields/number/NumberInput.tsx";
import { keepSet } from "../../../app/records/course/saved-sets.ts";
import { Choice, languageNames } from "./Choice.tsx";
import { SetHandOut } from "./SetHandOut.tsx";
import { SetTasks } from "./SetTasks.tsx";
import { TeachText } from "./WordFields.tsx";
import "./teach.css";

const MINUTE = 60_000;

/** A moment as the browser's field of day and time writes it, in local time. */
const localMoment = (at: number): string =>
  new Date(at - new Date(at).getTimezoneOffset() * MINUTE).toISOString().slice(0, "2026-01-01T08:00".length);

/** A field with a whole number up to a limit; empty: none. */
function WholeNumber({
  label,
  most,
  value,
  change,
}: {
  readonly label: string;
  readonly most: number;
  readonly value: number | undefined;
  readonly change: (value: number | undefined) => void;
}) {
  return (
    <label className="teach-text">
      {label}
      <NumberInput
        kind="typed"
        inputMode="numeric"
        className="input number"
        maxLength={4}
        text={value === undefined ? "" : String(value)}
        onText={(text) => {
          const digits = text.replace(/\D/g, "");
          change(digits === "" ? undefined : Math.min(most, Math.max(1, Number(digits))));
        }}
      />
    </label>
  );
}

/** Title and text of a set, in one language after the other. */
function SetWords({ set, change }: { readonly set: TaskSet; readonly change: (some: Partial<TaskSet>) => void }) {
  const t = useTexts("course-set");
  const teach = useTexts("course-teach");
  const screen = useSettings((s) => s.language);
  const [language, speak] = useState(() => shownLanguageOf(set.words, screen) ?? lessonLanguageOf(screen));
  const said = set.words[language];
  // A title that is being typed may be empty; the set itself always has one.
  const [title, name] = useState<string | null>(null);
  const say = (some: { readonly title?: string; readonly about?: string }) => {
    const { title: called = t.untitled, about = "" } = { ...said, ...some };
    const isLeft = called.trim() === "" && about.trim() === "" && Object.keys(set.words).length > 1;
    const { [language]: _, ...others } = set.words;
    change({
      words: isLeft
        ? others
        : {
            ...set.words,
            [language]: {
              title: called.trim() === "" ? t.untitled : called,
              ...(about.trim() !== "" && { about }),
            },
          },
    });
  };
  return (
    <fieldset>
      <legend>{teach.words}</legend>
      <Choice
        label={t.language}
        names={languageNames((each) => set.words[each] !== undefined)}
        all={LESSON_LANGUAGES}
        value={language}
        change={(chosen) => {
          speak(chosen);
          name(null);
        }}
      />
      <TeachText
        label={teach.name}
        value={title ?? said?.title ?? ""}
        change={(text) => {
          name(text);
          say({ title: text });
        }}
      />
      <TeachText label={t.about} rows={2} value={said?.about ?? ""} change={(about) => say({ about })} />
    </fieldset>
  );
}

/** The form of a set: title, tasks in order, exercise or exam, and the ways to hand it out. Each change is saved. */
export function SetDialog({ set, done }: { readonly set: TaskSet; readonly done: () => void }) {
  const t = useTexts("course-set");
  const { exam, due, help } = set;
  const change = (some: Partial<TaskSet>, place: string | null = null) =>
    keepSet({ ...set, ...some }, place === null ? null : `${set.id} ${place}`);
  const without = (field: "due" | "exam"): void => {
    const { [field]: _, ...rest } = set;
    keepSet(rest);
  };
  const changeExam = (some: Partial<NonNullable<TaskSet["exam"]>>) =>
    exam && change({ exam: { ...exam, ...some } }, "exam");
  return (
    <ModalDialog className="teach" title={t.title} done={done}>
      <div className="teach-form">
        <div className="teach-fields">
          <p className="soft">{isForLearners(set) ? t.received : t.stored}</p>
          <SetWords set={set} change={(some) => change(some, "words")} />
          <SetTasks set={set} change={change} />
          <fieldset>
            <legend>{t.terms.title}</legend>
            <div role="radiogroup" aria-label={t.mode} className="teach-choices">
              {(["exercises", "exam"] as const).map((mode) => (
                <label key={mode} className="teach-check">
                  <input
                    type="radio"
                    name={`mode ${set.id}`}
                    checked={(mode === "exam") === (exam !== undefined)}
                    onChange={() =>
                      mode === "exam" ? change({ exam: { minutes: 60, tries: 3, reports: "passed" } }) : without("exam")
                    }
                  />
                  {t.modes[mode]}
                </label>
              ))}
            </div>
            {exam ? (
              <div className="teach-pairs">
                <WholeNumber
                  label={t.minutes}
                  most={SET_LIMITS.minutes}
                  value={exam.minutes}
                  change={(minutes) => changeExam({ minutes })}
                />
                <Choice
                  label={t.reports}
                  names={t.reportNames}
                  all={EXAM_REPORTS}
                  value={exam.reports}
                  change={(reports) => changeExam({ reports })}
                />
                {exam.reports !== "nothing" && (
                  <WholeNumber
                    label={t.tries}
                    most={SET_LIMITS.tries}
                    value={exam.tries}
                    change={(tries) => changeExam({ tries })}
                  />
                )}
                <label className="teach-check">
                  <input
                    type="checkbox"
                    checked={exam.anonymous === true}
                    onChange={({ currentTarget: { checked } }) => changeExam({ anonymous: checked })}
                  />
                  {t.anonymous}
                </label>
              </div>
            ) : (
              <Choice
                label={t.help}
                names={t.helpNames}
                all={SET_HELP}
                value={help}
                change={(next) => change({ help: next })}
              />
            )}
            <div className="set-due">
              <label className="teach-text">
                {t.due}
                <input
                  type="datetime-local"
                  className="input"
                  value={due === undefined ? "" : localMoment(due)}
                  onChange={(event) => {
                    const at = Date.parse(event.currentTarget.value);
                    if (Number.isFinite(at)) change({ due: at }, "due");
                    else without("due");
                  }}
                />
              </label>
              {due !== undefined && (
                <button type="button" className="button" onClick={() => without("due")}>
                  <Icon name="close" /> {t.noDue}
                </button>
              )}
            </div>
          </fieldset>
        </div>
        <SetHandOut set={set} />
      </div>
    </ModalDialog>
  );
}
