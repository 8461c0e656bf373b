import { useState } from "react";
import { shownHelp } from "../../../course/progress.ts";
import { programOfLines } from "../../../course/task-start.ts";
import { shownId, type Task, type TaskWords } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { showComparison } from "../../../app/place/place.ts";
import { startWork } from "../../../app/records/keep.ts";
import { bundleOf, useEditor } from "../../../app/document/store.ts";
import { onlyBundle } from "../../../app/document/work.ts";
import { Paragraphs } from "../Paragraphs.tsx";
import { PlansButton } from "../plans/PlansButton.tsx";
import { noteHint, useTaskProgress } from "../../../app/records/course/progress.ts";
import { SureToShow } from "./SureToShow.tsx";

/** Opens a block of the current program; a job of prompts has no blocks to open. */
async function showBlock(_file: string | null, _index: number, number: number): Promise<void> {
  if (!useEditor.getState().program) return;
  const { openBlockByNumber } = await import("./block-by-number.ts");
  openBlockByNumber(number, null);
}

/**
 * The three stages of the hint, one after the other, then the solution next to the own program. Each is shown on
 * request, and counted.
 */
export function TaskHelp({
  task,
  t,
  words,
}: {
  readonly task: Task;
  readonly t: CourseTaskTexts;
  readonly words: TaskWords;
}) {
  const progress = useTaskProgress(task.id);
  const { hints, solution: seen } = shownHelp(progress);
  const { tries } = progress;
  const [shown, setShown] = useState(0);
  const [sure, ask] = useState(false);
  const [open, setOpen] = useState(false);
  const { solution } = task;
  const stages = Math.max(shown, hints);
  const next = stages + 1;
  const isLast = next === words.hints.length;
  // The last hint is the whole way to the answer.
  const isHeldBack = isLast && next > 1 && tries === 0;
  if (words.hints.length === 0 && !solution) return null;
  const name = `${words.title} · ${t.solutionName}`;
  const text = solution && programOfLines(solution);
  return (
    <section className="task-part task-help">
      {words.hints.slice(0, stages).map((hint, i) => (
        <div key={i} className="task-hint">
          <h3>{t.hint(i + 1, words.hints.length)}</h3>
          <Paragraphs text={hint} before={[words.ask, ...words.hints.slice(0, i)]} />
        </div>
      ))}
      <div className="task-ways">
        {stages < words.hints.length && (
          <button
            type="button"
            className="button"
            aria-disabled={isHeldBack}
            aria-describedby={isHeldBack ? "hint-after-try" : undefined}
            onClick={() => {
              if (isHeldBack) return;
              setShown(next);
              noteHint(task.id, next);
            }}
          >
            {t.showHint(next, words.hints.length)}
          </button>
        )}
        {text !== undefined && !sure && !open && (
          <button type="button" className="button" onClick={() => (seen ? setOpen(true) : ask(true))}>
            {t.showSolution}
          </button>
        )}
        <PlansButton task={task} t={t} />
      </div>
      {isHeldBack && (
        <p id="hint-after-try" className="small soft">
          {t.hintAfterTry}
        </p>
      )}
      {sure && (
        <SureToShow
          id={task.id}
          t={t}
          label={t.showSolution}
          question={t.confirmSolution}
          show={() => setOpen(true)}
          done={() => ask(false)}
        />
      )}
      {open && text !== undefined && (
        <div className="task-solution">
          <h3>{t.solution}</h3>
          <pre className="number small" tabIndex={0} aria-label={t.solution}>
            {text}
          </pre>
          <div className="task-ways">
            <button
              type="button"
              className="button"
              aria-haspopup="dialog"
              onClick={() => showComparison((...place) => void showBlock(...place), { name, text })}
            >
              {t.compare}
            </button>
            <button
              type="button"
              className="button"
              onClick={() =>
                void startWork({
                  name: `${shownId(task)}_solution.h`,
                  text,
                  encoding: "utf-8",
                  ...onlyBundle(bundleOf(useEditor.getState())),
                })
              }
            >
              {t.openSolution}
            </button>
          </div>
        </div>
      )}
    </section>
  );
}
