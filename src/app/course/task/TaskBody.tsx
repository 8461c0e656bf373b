import { goalsOf, isMet } from "../../../course/goals.ts";
import type { Task, TaskWords } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { writer } from "../../../i18n/write.ts";
import { Icon } from "../../Icon.tsx";
import { useEditor } from "../../store.ts";
import { useSettings } from "../../settings/settings.ts";
import { WorkshopDrawing } from "../drawing/WorkshopDrawing.tsx";
import { Paragraphs } from "../Paragraphs.tsx";
import { ForetoldResult } from "./ForetoldResult.tsx";
import { goalText } from "./goal-words.ts";
import { TaskHelp } from "./TaskHelp.tsx";
import { TaskOnward } from "./TaskOnward.tsx";
import { useTaskView } from "./task-view.ts";
import { taskOfWork } from "./work-task.ts";

interface Props {
  readonly task: Task;
  readonly t: CourseTaskTexts;
  readonly words: TaskWords;
}

/** What the task wants, ticked off after the first check. */
function Goals({ task, t }: Props) {
  const language = useSettings((s) => s.language);
  const { live, foretold } = useTaskView();
  const rights = (foretold ?? []).map(({ right }) => right);
  return (
    <section className="task-part" aria-label={t.goals}>
      <h3>{t.goals}</h3>
      <ul className="task-goals">
        {goalsOf(task).map((goal, i) => {
          const known = goal.kind === "foretold" ? foretold !== null : live !== null;
          const met = known && isMet(goal, live, rights);
          return (
            <li key={i} data-met={known ? met : undefined}>
              <span className="task-tick" aria-hidden="true">{known && <Icon name={met ? "check" : "close"} />}</span>
              <span>{goalText(t, language, goal)} {known && <span className="unseen">, {met ? t.met : t.notMet}</span>}</span>
            </li>
          );
        })}
      </ul>
    </section>
  );
}

/** The score of a drawing, and what would be better. */
function Scored({ t }: Pick<Props, "t">) {
  const language = useSettings((s) => s.language);
  const score = useTaskView((v) => v.checked?.judgement.score);
  if (!score) return null;
  const write = writer(language);
  return (
    <section className="task-part" aria-label={t.score.title}>
      <h3>{t.score.of(String(score.total))}</h3>
      <ul className="task-score">
        {score.parts.map(({ what, points, of, value, par }) => {
          const number = (each: number) => what === "residue" ? write.area(each) : formatNumber(language, each, 0);
          return (
            <li key={what}>
              <span>{t.score.parts[what]}</span> <meter min={0} max={of} value={points} aria-label={t.score.parts[what]} />{" "}
              <span className="number">{points}/{of}</span>
              {points < of && <span className="soft small">{t.score.better[what](number(value), number(par))}</span>}
            </li>
          );
        })}
      </ul>
    </section>
  );
}

/** What is asked, what is to be reached, help one step at a time, and where it goes on. */
export function TaskBody({ task, t, words }: Props) {
  const language = useSettings((s) => s.language);
  const veiled = useEditor((s) => taskOfWork(s)?.veiled ?? false);
  // An instructor's words need not have the sizes: the part is shown.
  const isFromOutside = useEditor((s) => taskOfWork(s)?.file !== undefined);
  return (
    <>
      <section className="task-part task-ask" aria-label={t.unfold}>
        <Paragraphs text={words.ask} />
        {task.part && (task.kind === "drawing" || isFromOutside) && (
          <details className="task-drawing" open>
            <summary>{t.drawing}</summary>
            <WorkshopDrawing task={task} language={language} />
          </details>
        )}
      </section>
      <div className="task-beside">
        <Goals task={task} t={t} words={words} />
        <Scored t={t} />
        {!veiled && <ForetoldResult t={t} words={words} />}
      </div>
      <div className="task-beside">
        <TaskHelp task={task} t={t} words={words} />
        <TaskOnward task={task} t={t} words={words} />
      </div>
    </>
  );
}
