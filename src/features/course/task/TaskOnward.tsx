import { useMemo, useState } from "react";
import { isMadeAsLearned } from "../../../course/judge/word-rule.ts";
import { nextOpenTask } from "../../../course/task-set.ts";
import type { Task, TaskWords } from "../../../course/task.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { lazyPart } from "../../../app/base/parts.ts";
import { playback } from "../../../app/calculation/playback.ts";
import { usePlayback } from "../../../app/pictures/lathe/use-playback.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { courseHref } from "../../../app/place/course-links.ts";
import { useLearning, useTaskProgress } from "../../../app/records/course/progress.ts";
import { setOfTask, useSavedSets } from "../../../app/records/course/saved-sets.ts";
import { beginTaskOfCourse } from "../begin-task.ts";
import { PassedBar } from "../PassedBar.tsx";
import { PlansButton } from "../plans/PlansButton.tsx";
import { StepLinks } from "../StepLinks.tsx";
import { lessonsAround, useCoursePath, useNextStep } from "../use-course-path.ts";
import { resumeOrStartTask, startTask } from "./begin.ts";
import { playMade } from "./play-made.ts";
import { useTaskView } from "./task-view.ts";

const HandInDialog = lazyPart(async () => ({ default: (await import("../teach/HandInDialog.tsx")).HandInDialog }));

interface Props {
  readonly task: Task;
  readonly t: CourseTaskTexts;
  readonly words: TaskWords;
}

/** The lesson of a task of the course, and the lessons of the path on which it lies; null for an instructor's task. */
function useLessonOfTask(id: string) {
  const path = useCoursePath();
  const lesson = path.all.find(({ tasks }) => tasks.some((task) => task.id === id));
  if (!lesson) return null;
  const around = lessonsAround(path, lesson.id);
  const isOnPath = around.some(({ tasks }) => tasks.some((task) => task.id === id));
  return { lesson, lessons: isOnPath ? around : path.all };
}

/** After an instructor's task: the next open one of its set; otherwise the set, or this task alone, is handed in. */
function NextOfInstructor({ task, t }: Omit<Props, "words">) {
  const texts = useTexts("course-path").made;
  const language = useSettings((s) => s.language);
  const { list } = useLearning();
  const set = useSavedSets((s) => setOfTask(s.list, task.id)?.set);
  const [hands, handIn] = useState(false);
  const next = set && nextOpenTask(set, list, task.id);
  if (next) {
    return (
      <button type="button" className="button primary task-next" onClick={() => void resumeOrStartTask(next, true)}>
        <span>{t.nextTask(inScreenLanguage(next.words, language)?.title ?? next.id)}</span>
      </button>
    );
  }
  return (
    <>
      <button type="button" className="button primary" aria-haspopup="dialog" onClick={() => handIn(true)}>
        <Icon name="share" /> {texts.handIn}
      </button>
      {hands && <HandInDialog set={set} task={set ? undefined : task.id} done={() => handIn(false)} />}
    </>
  );
}

/** The next step in the course; an instructor's task is handed in. */
function NextStep({ task, t }: Omit<Props, "words">) {
  const of = useLessonOfTask(task.id);
  const step = useNextStep({ lesson: of?.lesson.id ?? "", task: task.id });
  if (!of) return <NextOfInstructor task={task} t={t} />;
  if (step?.kind === "task") {
    const { id, title } = step.task;
    return (
      <button type="button" className="button primary task-next" onClick={() => void beginTaskOfCourse(id)}>
        <span>{t.nextTask(title)}</span>
      </button>
    );
  }
  if (step) return <StepLinks step={step} className="button primary task-next" />;
  return (
    <a className="button primary task-next" href={courseHref()}>
      {t.toCourse}
    </a>
  );
}

/** Plays what was made from its start, or skips to the end. */
function PlayMade() {
  const t = useTexts("course-path").made;
  const playing = usePlayback(playback, (s) => s.get().playing);
  return (
    <button type="button" className="button" onClick={() => (playing ? playback.dispatch({ do: "last" }) : playMade())}>
      <Icon name={playing ? "fold" : "play"} /> {playing ? t.skip : t.again}
    </button>
  );
}

/** What was learned, if the task was passed in the way of which it speaks. */
function Learned({ task, t, words }: Props) {
  const checked = useTaskView((v) => v.checked);
  const { learnedBy } = task;
  const isSo = useMemo(
    () => learnedBy === undefined || (checked?.passed === true && isMadeAsLearned({ learnedBy }, checked.answer.text)),
    [learnedBy, checked],
  );
  if (!isSo || words.learned === undefined) return null;
  return (
    <div className="task-learned">
      <h3>
        <Icon name="check" /> {t.learned}
      </h3>
      <p>{words.learned}</p>
    </div>
  );
}

/** Below the line of a passed task while the assignment is folded: what was learned, and the way on. */
export function PassedLine({ task, t, words }: Props) {
  const of = useLessonOfTask(task.id);
  const score = useTaskView((v) => v.checked?.judgement.score?.total);
  return (
    <div className="task-now task-made">
      <Learned task={task} t={t} words={words} />
      <div className="task-ways">
        {score !== undefined && <b>{t.score.of(String(score))}</b>}
        <NextStep task={task} t={t} />
        <PlansButton task={task} t={t} />
        <PlayMade />
        {of && <PassedBar lessons={of.lessons} />}
      </div>
    </div>
  );
}

/** In the assignment: what was learned and the way on after passing, and the link to the lesson. */
export function TaskOnward({ task, t, words }: Props) {
  const { passed } = useTaskProgress(task.id);
  const of = useLessonOfTask(task.id);
  return (
    <section className="task-part task-onward">
      {passed && <Learned task={task} t={t} words={words} />}
      <div className="task-ways">
        {passed && <NextStep task={task} t={t} />}
        <a className="button" href={courseHref(of?.lesson.id ?? null, "tasks")}>
          {of ? t.toLesson : t.toCourse}
        </a>
        <button type="button" className="button" onClick={() => startTask(task, !of)}>
          {t.startOver}
        </button>
      </div>
    </section>
  );
}
