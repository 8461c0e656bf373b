import type { Task } from "../../../course/task.ts";
import { useEditor } from "../../../app/document/store.ts";
import { taskOfWork } from "../../../app/document/work-task.ts";

/** Whether a task shows its part: the words of an instructor's task may lack the sizes. */
export function useHasDrawing({ part, kind }: Task): boolean {
  const isFromOutside = useEditor((s) => taskOfWork(s)?.file !== undefined);
  return part !== undefined && (kind === "drawing" || isFromOutside);
}
