import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import type { TaskDrawing } from "./use-task-drawing.ts";

/** Shows the drawing of a task in place of the lathe or beside it, or hides it; nothing for a task without one. */
export function DrawingButton({ drawing, t }: { readonly drawing: TaskDrawing; readonly t: CourseTaskTexts }) {
  return (
    drawing.exists && (
      <button
        type="button"
        className="button task-draw"
        aria-label={t.drawing}
        title={t.drawing}
        aria-pressed={drawing.shown}
        // A press leaves the focus in the prompt.
        onMouseDown={(event) => event.preventDefault()}
        onClick={drawing.toggle}
      >
        <Icon name="drawing" /> <span>{t.drawing}</span>
      </button>
    )
  );
}
