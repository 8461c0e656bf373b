import { useEffect } from "react";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { startWorkingTime } from "../../../app/records/course/working-time.ts";
import { useEditor, openContent } from "../../../app/document/store.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { useExamOfTask } from "../../../app/records/course/exams.ts";
import { watchExams } from "../teach/exam-watch.ts";
import { ExamPanel } from "./ExamPanel.tsx";
import { SetBar } from "./SetBar.tsx";
import { TaskPanel } from "./TaskPanel.tsx";
import { viewTask } from "./task-view.ts";
import { useShowPassed } from "./use-show-passed.ts";
import { useTaskFile } from "./use-task-file.ts";
import "./task.css";

startWorkingTime();
watchExams();

/** The assignment of the open work, and its result. */
export function TaskBar({ work }: { readonly work: string }) {
  const t = useTexts("course-task");
  const task = useTaskFile();
  const language = useSettings((s) => s.language);
  const named = useEditor((s) => openContent(s)?.name ?? "");
  const exam = useExamOfTask(task && task !== "none" ? task.id : "");
  useEffect(() => viewTask(work), [work]);
  const title = (task !== null && task !== "none" && inScreenLanguage(task.words, language)?.title) || named;
  useEffect(() => {
    document.title = `${title} · Turnwise`;
  }, [title]);
  useShowPassed();
  if (task === null) return null;
  if (task !== "none")
    return (
      <>
        <SetBar task={task.id} />
        {exam ? <ExamPanel task={task} exam={exam} t={t} /> : <TaskPanel task={task} t={t} />}
      </>
    );
  return (
    <p className="task-panel task-gone">
      <Icon name="info" /> {t.fileMissing}
    </p>
  );
}
