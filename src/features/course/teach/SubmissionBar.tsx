import { useCallback, useEffect, useMemo, useState } from "react";
import { judge } from "../../../course/judge/judge.ts";
import type { TaskMark } from "../../../course/judge/judgement.ts";
import type { Task } from "../../../course/task.ts";
import { useOutcome } from "../../../app/calculation/outcome.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useEditor } from "../../../app/document/store.ts";
import { showResults } from "../../../app/records/course/show-results.ts";
import { DrawingPane } from "../drawing/DrawingPane.tsx";
import { isOfWork } from "../task/check.ts";
import { DrawingButton } from "../task/DrawingButton.tsx";
import { markText } from "../task/mark-words.ts";
import { MarkLine } from "../task/MarkLine.tsx";
import { useTaskView } from "../task/task-view.ts";
import { useTaskDrawing } from "../task/use-task-drawing.ts";
import { useTaskPicture } from "../task/use-task-picture.ts";
import { taskOfId } from "./hand-in.ts";
import { takeAnswer } from "../../../app/base/until-gone.ts";
import "../task/task.css";
import "./set.css";

/** The exercise of a learner's program: its drawing, and the marks of the program as it is now. */
function SubmittedTask({ task }: { readonly task: Task }) {
  const t = useTexts("course-task"),
    texts = useTexts();
  const language = useSettings((s) => s.language);
  const newest = useOutcome((o) => o.newest);
  const program = useEditor((s) => s.program);
  const answer = useMemo(() => (program && isOfWork(newest) ? newest : null), [newest, program]);
  const judgement = useMemo(() => answer && judge(task, answer), [task, answer]);
  const marks = useMemo(() => judgement?.marks.filter(({ passed }) => !passed) ?? null, [judgement]);
  const say = useCallback(
    (mark: TaskMark) => (answer ? markText(mark, { t, texts, language, task, answer }) : ""),
    [answer, t, texts, language, task],
  );
  useEffect(() => {
    if (answer && judgement)
      useTaskView.setState({ checked: { answer, judgement, passed: judgement.passed }, stale: false, place: 0 });
  }, [answer, judgement]);
  const drawing = useTaskDrawing(task);
  useTaskPicture(task, t, language, marks, say);
  return (
    <>
      <DrawingButton drawing={drawing} t={t} />
      {answer && marks && marks.length > 0 && task.kind !== "predict" && (
        <MarkLine marks={marks} say={say} run={answer.run} t={t} />
      )}
      {drawing.shown && <DrawingPane task={task} />}
    </>
  );
}

/** Whose program is open, what its exercise says about it, and the way back to the table of results. */
export function SubmissionBar({ said, task: id }: { readonly said: string; readonly task: string }) {
  const { table: words } = useTexts("course-set");
  const [task, find] = useState<Task | null>(null);
  useEffect(() => takeAnswer(() => taskOfId(id), find), [id]);
  return (
    <section className="set-bar submission-bar" aria-label={words.submission}>
      <span className="set-place">{said}</span>
      {task && <SubmittedTask task={task} />}
      <button type="button" className="button" aria-haspopup="dialog" onClick={() => showResults()}>
        <Icon name="unfold" /> <span>{words.back}</span>
      </button>
    </section>
  );
}
