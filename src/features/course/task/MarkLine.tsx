import { useEffect, useEffectEvent } from "react";
import type { TaskMark } from "../../../course/judge/judgement.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { useChosen } from "../../../app/document/chosen.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { markId, showMark } from "./show-mark.ts";
import { useTaskView } from "./task-view.ts";

/** The colour and form of a mark are those that it has in the picture. */
const badgeOf = ({ rule }: TaskMark): string => (rule === "residue" ? "badge-residual" : "badge-finding");

/** One thing that is wrong: where, and which step. The picture goes there, and on to the next. */
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
  const chosen = useChosen((c) => c.id);
  const mark = marks[Math.min(place, marks.length - 1)];
  const go = (index: number) => {
    const next = marks[index];
    if (!next) return;
    useTaskView.setState({ place: index });
    void showMark(next, index, run);
  };
  // The first one is shown when the check has found it.
  const begin = useEffectEvent(() => go(Math.min(place, marks.length - 1)));
  useEffect(() => begin(), [marks]);
  // A mark that is pressed in the picture is the one that is told.
  const follow = useEffectEvent((id: string | null) => {
    const index = marks.findIndex((_, i) => markId(i) === id);
    if (index >= 0 && index !== place) go(index);
  });
  useEffect(() => follow(chosen), [chosen]);
  if (!mark) return null;
  return (
    <div className="task-now task-mark">
      <button type="button" className="task-told" aria-label={`${place + 1}: ${say(mark)}`} onClick={() => go(place)}>
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
