import { useState } from "react";
import { progressOfTask, stateOfTask } from "../../../course/progress.ts";
import { isForLearners, SET_FORMAT, type TaskSet } from "../../../course/task-set.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { lessonLanguageOf } from "../../../i18n/languages.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { randomId } from "../../../app/base/random-id.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTextsOrNull } from "../../../app/base/settings/use-texts.ts";
import { recorded, undo, useIsLastStep, type HistoryStep } from "../../../app/document/steps.ts";
import { useExams } from "../../../app/records/course/exams.ts";
import { showExamTerms, showHandIn, showSetForm } from "../../../app/records/course/opened-course-file.ts";
import { useLearning } from "../../../app/records/course/progress.ts";
import { keepSet, removeSet, useSavedSets } from "../../../app/records/course/saved-sets.ts";
import { resumeOrStartTask } from "../task/begin.ts";
import { TaskStateMark } from "../TaskStateMark.tsx";
import { examStateText, momentText } from "./exam-words.ts";
import { watchExams } from "./exam-watch.ts";

watchExams();

/** Characters of the mark that ends the ids of a set and its tasks. */
const MARK = 6;

/** Makes an empty set and opens its form. */
export function NewSetButton() {
  const t = useTextsOrNull("course-set");
  const language = useSettings((s) => s.language);
  if (!t) return null;
  return (
    <button
      type="button"
      className="button"
      aria-haspopup="dialog"
      onClick={() => {
        const id = `set-${randomId().slice(0, MARK)}`;
        const words = { [lessonLanguageOf(language)]: { title: t.untitled } };
        keepSet({ format: SET_FORMAT, id, words, tasks: [], help: "all" });
        showSetForm(id);
      }}
    >
      <Icon name="add" /> {t.make}
    </button>
  );
}

function SavedSet({ set, remove }: { readonly set: TaskSet; readonly remove: (title: string) => void }) {
  const t = useTextsOrNull("course-set");
  const language = useSettings((s) => s.language);
  const learning = useLearning((s) => s.list);
  const exam = useExams(({ list }) => list[set.id]);
  if (!t) return null;
  const title = inScreenLanguage(set.words, language)?.title ?? set.id;
  const isClosed = set.exam !== undefined && !exam;
  const state = () => {
    if (exam) return examStateText(exam, t, language);
    const due = set.due === undefined ? [] : [t.terms.due(momentText(language, set.due))];
    return [...(set.exam ? [t.exam.notBegun] : []), ...due].join(" ");
  };
  return (
    <section className="set-saved" aria-label={title}>
      <h3>{title}</h3>
      {state() !== "" && <p className="soft">{state()}</p>}
      <ol className="set-tasks">
        {set.tasks.map((task) => {
          const name = inScreenLanguage(task.words, language)?.title ?? task.id;
          return (
            <li key={task.id}>
              <span className="taught-name">{name}</span>
              {!set.exam && <TaskStateMark state={stateOfTask(progressOfTask(learning, task.id))} />}
              {!isClosed && (
                <button
                  type="button"
                  className="button icon"
                  aria-label={t.begin(name)}
                  onClick={() => void resumeOrStartTask(task, true)}
                >
                  <Icon name="play" />
                </button>
              )}
            </li>
          );
        })}
      </ol>
      <div className="modal-ways">
        {isClosed && set.tasks.length > 0 && (
          <button type="button" className="button primary" aria-haspopup="dialog" onClick={() => showExamTerms(set.id)}>
            <Icon name="play" /> {t.exam.toTerms}
          </button>
        )}
        {!isClosed && set.tasks.length > 0 && (
          <button type="button" className="button" aria-haspopup="dialog" onClick={() => showHandIn(set.id)}>
            <Icon name="share" /> {t.handInOf(title)}
          </button>
        )}
        {(!isForLearners(set) || set.tasks.length === 0) && (
          <button type="button" className="button" aria-haspopup="dialog" onClick={() => showSetForm(set.id)}>
            <Icon name="rename" /> {t.edit}
          </button>
        )}
        <button type="button" className="button plain" aria-label={t.removeSet(title)} onClick={() => remove(title)}>
          <Icon name="remove" />
        </button>
      </div>
    </section>
  );
}

/** The sets on this device: an instructor's own, and received ones with their tasks in order. */
export function SavedSets() {
  const t = useTextsOrNull("course-set");
  const { list, trouble } = useSavedSets();
  const [gone, say] = useState<{ readonly title: string; readonly step: HistoryStep } | null>(null);
  const isLast = useIsLastStep(gone?.step);
  if (!t) return null;
  return (
    <>
      {(list.length > 0 || trouble !== "none") && <h2>{t.sets}</h2>}
      {trouble !== "none" && <Message tone="warning">{t.trouble[trouble]}</Message>}
      {list.map((set) => (
        <SavedSet
          key={set.id}
          set={set}
          remove={(title) => {
            const step = recorded(() => removeSet(set.id));
            say(step && { title, step });
          }}
        />
      ))}
      <div role="status">
        {gone && isLast && (
          <Message tone="info" className="taught-gone">
            <span>{t.setRemoved(gone.title)}</span>
            <button type="button" className="button" onClick={() => undo(gone.step.document)}>
              <Icon name="undo" /> {t.undo}
            </button>
          </Message>
        )}
      </div>
    </>
  );
}
