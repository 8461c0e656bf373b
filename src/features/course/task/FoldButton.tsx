import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useTaskView } from "./task-view.ts";

/** Unfolds the assignment, or folds it; `body`: its id. */
export function FoldButton({ body, t }: { readonly body: string; readonly t: CourseTaskTexts }) {
  const open = useTaskView((v) => v.open);
  const name = open ? t.fold : t.unfold;
  return (
    <button
      type="button"
      className="button task-unfold"
      aria-label={name}
      aria-expanded={open}
      aria-controls={body}
      onClick={() => useTaskView.setState({ open: !open })}
    >
      <Icon name={open ? "up" : "down"} /> <span>{name}</span>
    </button>
  );
}
