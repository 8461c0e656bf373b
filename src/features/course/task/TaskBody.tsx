import { useDeferredValue } from "react";
import type { Task, TaskWords } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { writer } from "../../../i18n/write.ts";
import { useEditor } from "../../../app/document/store.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { WorkshopDrawing } from "../drawing/WorkshopDrawing.tsx";
import { Paragraphs } from "../Paragraphs.tsx";
import { PredictionResult } from "./PredictionResult.tsx";
import { useMedia } from "../../../app/base/use-media.ts";
import { durationText } from "../../../app/base/clock-text.ts";
import { TaskGoals } from "./TaskGoals.tsx";
import { useHasDrawing } from "./use-has-drawing.ts";
import { TaskHelp } from "./TaskHelp.tsx";
import { TaskOnward } from "./TaskOnward.tsx";
import { useTaskView } from "./task-view.ts";
import { taskOfWork } from "../../../app/document/work-task.ts";

interface Props {
  readonly task: Task;
  readonly t: CourseTaskTexts;
  readonly words: TaskWords;
}

/** A task may be the first page of the course that is read: no glossary term was introduced before. */
const NOTHING: readonly string[] = [];

/** The score of a drawing task, and how to improve it. */
function Scored({ t }: Pick<Props, "t">) {
  const language = useSettings((s) => s.language);
  const { duration } = useTexts("first").page.effect;
  const score = useTaskView((v) => v.checked?.judgement.score);
  if (!score) return null;
  const write = writer(language);
  return (
    <section className="task-part" aria-label={t.score.title}>
      <h3>{t.score.of(String(score.total))}</h3>
      <ul className="task-score">
        {score.parts.map(({ what, points, of, value, par }) => {
          const number = (each: number) => {
            if (what === "time") return durationText(duration, language, each);
            return what === "residue" ? write.area(each) : formatNumber(language, each, 0);
          };
          return (
            <li key={what}>
              <span>{t.score.parts[what]}</span>{" "}
              <meter min={0} max={of} value={points} aria-label={t.score.parts[what]} />{" "}
              <span className="number">
                {points}/{of}
              </span>
              {points < of && <span className="soft small">{t.score.better[what](number(value), number(par))}</span>}
            </li>
          );
        })}
      </ul>
    </section>
  );
}

/** Assignment, goals, help step by step, and the next task. */
export function TaskBody({ task, t, words }: Props) {
  const language = useSettings((s) => s.language);
  const veiled = useEditor((s) => taskOfWork(s)?.veiled ?? false);
  const hasDrawing = useHasDrawing(task);
  // Where the assignment takes the place of the work, the drawing is part of it.
  const isAlone = useMedia("narrow");
  // A live region announces what comes into it, not what it is made with.
  const ask = useDeferredValue(words.ask, "");
  return (
    <>
      <section className="task-part task-ask" aria-label={t.unfold}>
        <div className="task-ask-text" aria-live="polite">
          {ask !== "" && <Paragraphs text={ask} before={NOTHING} />}
        </div>
        {hasDrawing && isAlone && (
          <details className="task-drawing" open>
            <summary>{t.drawing}</summary>
            <WorkshopDrawing task={task} language={language} />
          </details>
        )}
      </section>
      <div className="task-beside">
        <TaskGoals task={task} t={t} hasDrawing={hasDrawing} />
        <Scored t={t} />
        {!veiled && <PredictionResult task={task} t={t} words={words} />}
      </div>
      <div className="task-beside">
        <TaskHelp task={task} t={t} words={words} />
        <TaskOnward task={task} t={t} words={words} />
      </div>
    </>
  );
}
