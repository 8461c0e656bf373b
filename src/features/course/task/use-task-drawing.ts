import { useEffect } from "react";
import type { Task } from "../../../course/task.ts";
import { useChosenFinding } from "../../../app/document/chosen-finding.ts";
import { taskOfWork } from "../../../app/document/work-task.ts";
import { useEditor } from "../../../app/document/store.ts";
import { useMedia } from "../../../app/base/use-media.ts";
import { useHasDrawing } from "./use-has-drawing.ts";
import { useTaskView } from "./task-view.ts";

export interface TaskDrawing {
  readonly exists: boolean;
  readonly shown: boolean;
  readonly toggle: () => void;
}

/** The workshop drawing as a second picture: a task from a drawing begins with it, and each result shows the lathe. */
export function useTaskDrawing(task: Task): TaskDrawing {
  const veiled = useEditor((s) => taskOfWork(s)?.veiled ?? false);
  const isUsual = useHasDrawing(task);
  const chosen = useTaskView((v) => v.drawn);
  const isBeside = useMedia("broad");
  const isStrip = useMedia("strip");
  // While the run is hidden, the lathe is what the questions are about.
  const exists = task.part !== undefined && !veiled;
  // On a short phone it takes the room of the prompts: it opens at a press.
  const shown = exists && (chosen ?? (isUsual && !isStrip));
  // The marks of a check, and a place that is looked at, are on the lathe.
  useEffect(() => {
    if (isBeside) return undefined;
    const toLathe = () => useTaskView.setState({ drawn: false });
    const checks = useTaskView.subscribe(({ checked }, before) => {
      if (checked && checked !== before.checked) toLathe();
    });
    const choices = useChosenFinding.subscribe(({ id, count }, before) => {
      if (id !== null && count !== before.count) toLathe();
    });
    return () => {
      checks();
      choices();
    };
  }, [isBeside]);
  return { exists, shown, toggle: () => useTaskView.setState({ drawn: !shown }) };
}
