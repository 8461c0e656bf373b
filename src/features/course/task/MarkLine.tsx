import { useEffect, useEffectEvent } from "react";
import { FIRST_FOCUS } from "../../../app/base/focus-guard.ts";
import type { TaskMark } from "../../../course/judge/judgement.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { useChosenFinding } from "../../../app/document/chosen-finding.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { markId, showMark } from "./show-mark.ts";
import { useTaskView } from "./task-view.ts";

/** Marks have the same colour and shape as in the picture. */
const badgeOf = ({ rule }: TaskMark): string => (rule === "residue" ? "badge-residual" : "badge-finding");

/** One mark: what is wrong, where, and which step. A click shows the place; the next button goes on. */
export function MarkLine({
  marks,
  say,
  run,
  t,
}: {
  readonly marks: readonly TaskMark[];
  readonly say: (mark: TaskMark) => string;
  readonly run: Run;
  readonly t: CourseTaskTexts;
}) {
  const place = useTaskView((v) => v.place);
  const chosen = useChosenFinding((c) => c.id);
  const mark = marks[Math.min(place, marks.length - 1)];
  const go = (index: number) => {
    const next = marks[index];
    if (!next) return;
    useTaskView.setState({ place: index });
    void showMark(next, index, run);
  };
  // After a check, the first mark is shown.
  const begin = useEffectEvent(() => go(Math.min(place, marks.length - 1)));
  useEffect(() => begin(), [marks]);
  // A mark clicked in the picture is shown in the line.
  const follow = useEffectEvent((id: string | null) => {
    const index = marks.findIndex((_, i) => markId(i) === id);
    if (index >= 0 && index !== place) go(index);
  });
  useEffect(() => follow(chosen), [chosen]);
  if (!mark) return null;
  return (
    <div className="task-now task-mark">
      <button
        type="button"
        className="task-told"
        aria-label={`${place + 1}: ${say(mark)}`}
        onClick={() => go(place)}
        {...{ [FIRST_FOCUS]: "" }}
      >
        <span className={`badge ${badgeOf(mark)}`} aria-hidden="true">
          {place + 1}
        </span>
        <span>{say(mark)}</span>
      </button>
      {marks.length > 1 && (
        <span className="task-steps">
          <button
            type="button"
            className="button icon"
            aria-label={t.previous}
            title={t.previous}
            disabled={place === 0}
            onClick={() => go(place - 1)}
          >
            <Icon name="unfold" />
          </button>
          <span className="number small">{t.count(place + 1, marks.length)}</span>
          <button
            type="button"
            className="button icon"
            aria-label={t.next}
            title={t.next}
            disabled={place >= marks.length - 1}
            onClick={() => go(place + 1)}
          >
            <Icon name="fold" />
          </button>
        </span>
      )}
    </div>
  );
}
