import { useEffect } from "react";
import { loadCourseTask } from "../../../i18n/load-course-task.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { laterTexts } from "../../../app/base/settings/later-texts.ts";
import { startWorkingTime } from "../../../app/records/course/working-time.ts";
import { TaskPanel } from "./TaskPanel.tsx";
import { viewTask } from "./task-view.ts";
import { useTaskFile } from "./use-task-file.ts";
import "./task.css";

const { useThem: useTaskTexts } = laterTexts(loadCourseTask);

startWorkingTime();

/** What is asked of the work that is open, and what became of it. */
export function TaskBar({ work }: { readonly work: string }) {
  const t = useTaskTexts();
  const task = useTaskFile();
  useEffect(() => viewTask(work), [work]);
  if (task === null) return null;
  if (task !== "none") return <TaskPanel task={task} t={t} />;
  return (
    <p className="task-panel task-gone">
      <Icon name="info" /> {t.gone}
    </p>
  );
}
