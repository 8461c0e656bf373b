import { useState } from "react";
import { shownHelp } from "../../../course/progress.ts";
import type { Task } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { lazyPart } from "../../../app/base/parts.ts";
import { useTaskProgress } from "../../../app/records/course/progress.ts";
import { SureToShow } from "../task/SureToShow.tsx";

const PlansDialog = lazyPart(async () => ({ default: (await import("./PlansDialog.tsx")).PlansDialog }));

/** A part that is programmed freely can be made by more than one plan. */
const hasPlans = ({ kind, part }: Task): boolean => kind === "drawing" && part !== undefined;

/**
 * Opens the learner's plan beside the planner's. Before the exercise is passed that is help, which is asked for and
 * counted like the solution; where an exercise has no solution to show, the comparison opens only after passing.
 */
export function PlansButton({ task, t }: { readonly task: Task; readonly t: CourseTaskTexts }) {
  const progress = useTaskProgress(task.id);
  const [sure, ask] = useState(false);
  const [open, setOpen] = useState(false);
  const isKnown = progress.passed !== null || shownHelp(progress).solution;
  if (!hasPlans(task) || (!isKnown && task.solution === undefined)) return null;
  return (
    <>
      {!sure && (
        <button
          type="button"
          className="button plans-open"
          aria-haspopup={isKnown ? "dialog" : undefined}
          onClick={() => (isKnown ? setOpen(true) : ask(true))}
        >
          {progress.passed ? t.comparePlan : t.showPlan}
        </button>
      )}
      {sure && (
        <SureToShow
          id={task.id}
          t={t}
          label={t.showPlan}
          question={t.confirmPlan}
          show={() => setOpen(true)}
          done={() => ask(false)}
        />
      )}
      {open && <PlansDialog task={task} t={t} done={() => setOpen(false)} />}
    </>
  );
}
