import { useEffect, useState } from "react";
import { taskSchema, type Task } from "../../../course/task.ts";
import { useEditor } from "../../../app/document/store.ts";
import { fetchTask, fromOutside } from "../../../app/records/course/content.ts";
import { taskOfWork } from "../../../app/document/work-task.ts";
import { takeAnswer } from "../../../app/base/until-gone.ts";

/**
 * The task of the open work: from the work itself, or of the course. "none": its file is missing or damaged; null:
 * pending.
 */
export function useTaskFile(): Task | "none" | null {
  const id = useEditor((s) => taskOfWork(s)?.id ?? "");
  const file = useEditor((s) => taskOfWork(s)?.file);
  const [task, setTask] = useState<Task | "none" | null>(null);
  useEffect(() => {
    const take = (found: Task | null) => setTask(found ?? "none");
    if (file === undefined) return takeAnswer(() => fetchTask(id).catch(() => null), take);
    const read = taskSchema.safeParse(file);
    take(read.success ? fromOutside(read.data) : null);
    return undefined;
  }, [id, file]);
  return task;
}
