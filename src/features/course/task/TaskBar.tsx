import { useEffect } from "react";
import { Icon } from "../../../app/base/Icon.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { startWorkingTime } from "../../../app/records/course/working-time.ts";
import { useExamOfTask } from "../../../app/records/course/exams.ts";
import { watchExams } from "../teach/exam-watch.ts";
import { ExamPanel } from "./ExamPanel.tsx";
import { SetBar } from "./SetBar.tsx";
import { TaskPanel } from "./TaskPanel.tsx";
import { viewTask } from "./task-view.ts";
import { useTaskFile } from "./use-task-file.ts";
import "./task.css";

startWorkingTime();
watchExams();

/** The assignment of the open work, and its result. */
export function TaskBar({ work }: { readonly work: string }) {
  const t = useTexts("course-task");
  const task = useTaskFile();
  const exam = useExamOfTask(task && task !== "none" ? task.id : "");
  useEffect(() => viewTask(work), [work]);
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
