import { useEffect, useMemo } from "react";
import type { TaskMark } from "../../../course/judge/judgement.ts";
import type { Task } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { useTaskResult } from "../../../app/findings/task-result.ts";
import { useTaskProgress } from "../../../app/records/course/progress.ts";
import { areFixesShown } from "./fixes-shown.ts";
import { markId, showTaskMark } from "./show-mark.ts";
import { useTaskView } from "./task-view.ts";

const NONE: readonly TaskMark[] = [];

/** Adds the failed marks of the last check to the findings, and holds back fixes while the fault is asked for. */
export function useFindingsOfTask(
  task: Task,
  t: CourseTaskTexts,
  marks: readonly TaskMark[] | null,
  say: (mark: TaskMark) => string,
): void {
  const stale = useTaskView((v) => v.stale);
  const progress = useTaskProgress(task.id);
  const isHeldBack = task.kind === "fault" && !areFixesShown(progress);
  const result = useMemo(
    () => ({
      title: t.lastCheck,
      against: task.part ? t.against : null,
      heldBack: isHeldBack ? t.heldBack : null,
      rows: (stale ? NONE : (marks ?? NONE)).map((mark, i) => ({
        id: markId(i),
        mark: String(i + 1),
        kind: mark.rule === "residue" ? ("residual" as const) : ("finding" as const),
        text: say(mark),
        go: () => showTaskMark(mark),
      })),
    }),
    [task, t, marks, say, stale, isHeldBack],
  );
  useEffect(() => {
    useTaskResult.setState({ result });
    return () => useTaskResult.setState({ result: null });
  }, [result]);
}
