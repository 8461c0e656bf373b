import type { TaskSet } from "../../../course/task-set.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTextsOrNull } from "../../../app/base/settings/use-texts.ts";
import { useExamOfTask } from "../../../app/records/course/exams.ts";
import { showHandIn } from "../../../app/records/course/opened-course-file.ts";
import { setOfTask, useSavedSets } from "../../../app/records/course/saved-sets.ts";
import { clockText, examStateText } from "../teach/exam-words.ts";
import { useTimeLeft } from "../teach/exam-watch.ts";
import { resumeOrStartTask } from "./begin.ts";
import "../teach/set.css";

/** Minutes before the end at which a screen reader is told. */
const WARNINGS = [10, 5, 1],
  MINUTE = 60_000;

/** The warning that applies to the time left; null before the first. It is announced when it changes. */
const warningAt = (left: number): number | null => WARNINGS.findLast((minutes) => left <= minutes * MINUTE) ?? null;

/** The set of the open task: its place in it, the tasks before and after, the clock of an exam, and handing in. */
export function SetBar({ task }: { readonly task: string }) {
  const words = useTextsOrNull("course-set");
  const language = useSettings((s) => s.language);
  const exam = useExamOfTask(task);
  const saved = useSavedSets(({ list }) => setOfTask(list, task)?.set);
  const left = useTimeLeft(exam ?? null);
  const set: TaskSet | undefined = exam?.set ?? saved;
  if (!set || !words) return null;
  const at = set.tasks.findIndex(({ id }) => id === task);
  const step = (by: number, label: (title: string) => string, icon: "unfold" | "fold") => {
    const next = set.tasks[at + by];
    const name = next && label(inScreenLanguage(next.words, language)?.title ?? next.id);
    return (
      <button
        type="button"
        className="button icon plain"
        aria-disabled={!next}
        aria-label={name ?? words.noneThere}
        title={name}
        onClick={() => next && void resumeOrStartTask(next, true)}
      >
        <Icon name={icon} />
      </button>
    );
  };
  const warning = left === null ? null : warningAt(left);
  return (
    <section className="set-bar" aria-label={words.bar}>
      {step(-1, words.before, "unfold")}
      <span className="set-place">
        <b>{inScreenLanguage(set.words, language)?.title}</b>{" "}
        <span className="number">{words.place(String(at + 1), String(set.tasks.length))}</span>
      </span>
      {step(1, words.after, "fold")}
      {left !== null && (
        <span className="set-clock number" role="timer" aria-label={words.timeLeft} data-short={warning !== null}>
          {clockText(left)}
        </span>
      )}
      <span role="status" className={exam?.ended ? "set-state" : "unseen"}>
        {exam?.ended && examStateText(exam, words, language)}
        {warning !== null && words.minutesLeft(warning)}
      </span>
      <button type="button" className="button" aria-haspopup="dialog" onClick={() => showHandIn(set.id)}>
        <Icon name="share" /> <span>{words.handIn}</span>
      </button>
    </section>
  );
}
