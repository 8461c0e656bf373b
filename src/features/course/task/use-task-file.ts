import { useEffect, useState } from "react";
import { taskSchema, type Task } from "../../../course/task.ts";
import { useEditor } from "../../../app/document/store.ts";
import { fetchTask, fromOutside } from "../../../app/records/course/content.ts";
import { taskOfWork } from "../../../app/document/work-task.ts";

/**
 * The task of the open work: from the work itself, or of the course. "none": its file is missing or damaged; null:
 * pending.
 */
export function useTaskFile(): Task | "none" | null {
  const id = useEditor((s) => taskOfWork(s)?.id ?? "");
  const file = useEditor((s) => taskOfWork(s)?.file);
  const [task, setTask] = useState<Task | "none" | null>(null);
  useEffect(() => {
    let gone = false;
    const take = (found: Task | null) => {
      if (!gone) setTask(found ?? "none");
    };
    const read = file === undefined ? null : taskSchema.safeParse(file);
    if (read) take(read.success ? fromOutside(read.data) : null);
    else void fetchTask(id).then(take, () => take(null));
    return () => {
      gone = true;
    };
  }, [id, file]);
  return task;
}
