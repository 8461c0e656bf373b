import { useState } from "react";
import { progressOfTask, stateOfTask } from "../../../course/progress.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { lazyPart } from "../../../app/base/parts.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { useLearning } from "../../../app/records/course/progress.ts";
import { TaskStateMark } from "../TaskStateMark.tsx";
import { resumeOrStartTask } from "../task/begin.ts";
import { textOfTask } from "../../../course/made/form-of-task.ts";
import type { Task } from "../../../course/task.ts";
import { recorded, undo, useIsLastStep, type HistoryStep } from "../../../app/document/steps.ts";
import { showHandIn } from "../../../app/records/course/opened-course-file.ts";
import { showResults } from "../../../app/records/course/show-results.ts";
import { copyTask, removeTask, useSavedTasks } from "../../../app/records/course/saved-tasks.ts";
import { useTextsOrNull } from "../../../app/base/settings/use-texts.ts";
import { NewSetButton, SavedSets } from "./SavedSets.tsx";
import "./set.css";
import "./teach.css";

const TeachDialog = lazyPart(async () => ({ default: (await import("./TeachDialog.tsx")).TeachDialog }));

/** The received tasks and sets, below the lessons, and the buttons to hand in, to collect, and to make a set. */
export function TaughtTasks() {
  const t = useTextsOrNull("course-teach");
  const language = useSettings((s) => s.language);
  const { list, trouble } = useSavedTasks();
  const learning = useLearning((s) => s.list);
  const [changed, change] = useState<Task | null>(null);
  const [gone, say] = useState<{ readonly title: string; readonly step: HistoryStep } | null>(null);
  const isLast = useIsLastStep(gone?.step);
  if (!t) return null;
  return (
    <section className="taught" aria-label={t.own.title}>
      {(list.length > 0 || trouble !== "none") && <h2>{t.own.title}</h2>}
      {trouble !== "none" && <Message tone="warning">{t.own[trouble]}</Message>}
      {list.length > 0 && (
        <ul className="taught-list">
          {list.map((task) => {
            const title = inScreenLanguage(task.words, language)?.title ?? task.id;
            return (
              <li key={task.id}>
                <span className="taught-name">{title}</span>
                <TaskStateMark state={stateOfTask(progressOfTask(learning, task.id))} />
                <button
                  type="button"
                  className="button"
                  aria-label={t.own.begin(title)}
                  onClick={() => void resumeOrStartTask(task, true)}
                >
                  <Icon name="play" />
                </button>
                {textOfTask(task) !== null && (
                  <button
                    type="button"
                    className="button plain"
                    aria-haspopup="dialog"
                    aria-label={t.own.edit(title)}
                    onClick={() => change(task)}
                  >
                    <Icon name="rename" />
                  </button>
                )}
                <button
                  type="button"
                  className="button plain"
                  aria-label={t.own.copy(title)}
                  onClick={() => copyTask(task, t.own.copyOf)}
                >
                  <Icon name="copy" />
                </button>
                <button
                  type="button"
                  className="button plain"
                  aria-label={t.own.remove(title)}
                  onClick={() => {
                    const step = recorded(() => removeTask(task.id));
                    say(step && { title, step });
                  }}
                >
                  <Icon name="remove" />
                </button>
              </li>
            );
          })}
        </ul>
      )}
      <div role="status">
        {gone && isLast && (
          <Message tone="info" className="taught-gone">
            <span>{t.own.removed(gone.title)}</span>
            <button type="button" className="button" onClick={() => undo(gone.step.document)}>
              <Icon name="undo" /> {t.own.undo}
            </button>
          </Message>
        )}
      </div>
      <SavedSets />
      <div className="modal-ways">
        <button type="button" className="button" aria-haspopup="dialog" onClick={() => showHandIn(null)}>
          <Icon name="share" /> {t.hand.open}
        </button>
        <button type="button" className="button" aria-haspopup="dialog" onClick={() => showResults()}>
          <Icon name="compare" /> {t.results.collect}
        </button>
        <NewSetButton />
      </div>
      {changed && <TeachDialog task={changed} done={() => change(null)} />}
    </section>
  );
}
