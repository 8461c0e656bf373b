import type { TaskState } from "../../course/progress.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/**
 * Each state has its own shape: an empty ring, a half one, a tick; with a dash below after hints, two after the
 * solution.
 */
const FORMS: Readonly<Record<TaskState, string>> = {
  new: "M8 2.5a5.5 5.5 0 1 0 0 11a5.5 5.5 0 0 0 0-11",
  tried: "M8 2.5a5.5 5.5 0 1 0 0 11a5.5 5.5 0 0 0 0-11M8 5v6M6.5 5.4v5.2",
  alone: "M2.5 8.5l3.5 4 7.5-9",
  hints: "M2.5 6l3.5 4 7.5-8M5 14h6",
  solution: "M2.5 6l3.5 4 7.5-8M2.5 14h4.5M9 14h4.5",
};

/** A state, as a mark and in words. Not started is most of a new course: its ring is enough for the eye. */
export function StateMark({ form, words }: { readonly form: TaskState; readonly words: string }) {
  return (
    <span className={`task-state task-${form}`}>
      <svg className="icon" viewBox="0 0 16 16" aria-hidden="true" focusable="false">
        <path d={FORMS[form]} />
      </svg>
      <span className={form === "new" ? "unseen" : undefined}>{words}</span>
    </span>
  );
}

/** The state of a task. */
export function TaskStateMark({ state }: { readonly state: TaskState }) {
  const t = useTexts("course");
  return <StateMark form={state} words={t.states[state]} />;
}
