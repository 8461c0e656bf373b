import { fetchTask } from "../../app/records/course/content.ts";
import { resumeOrStartTask, startTask } from "./task/begin.ts";

/** Whether a task is being fetched: pressed twice, a button still starts one work. */
const fetching = { is: false };

/** Opens a task of the course: its newest work, or a new one. `over`: it is started over. */
export async function beginTaskOfCourse(id: string, over = false): Promise<void> {
  if (fetching.is) return;
  fetching.is = true;
  try {
    const task = await fetchTask(id);
    if (!task) return;
    if (over) startTask(task);
    else await resumeOrStartTask(task);
  } finally {
    fetching.is = false;
  }
}
