import { formatNumber } from "../../../i18n/number.ts";
import { blankOfLines } from "../../../course/target-part.ts";
import { boxAround } from "../../../kernel/area/box.ts";
import { toDiameter, radius } from "../../../kernel/units.ts";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { WorkshopDrawing } from "../drawing/WorkshopDrawing.tsx";
import { resumeOrStartTask } from "../task/begin.ts";
import { ResultView } from "./ResultView.tsx";
import { keepTask, useSavedTasks } from "../../../app/records/course/saved-tasks.ts";
import { taughtFile } from "./taught-files.ts";
import { TaughtProblemView } from "./TaughtProblemView.tsx";
import { closeCourseFile, useOpenedCourseFile } from "../../../app/records/course/opened-course-file.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import type { Task } from "../../../course/task.ts";
import "./teach.css";

/** Most fields named at once. */
const MAX_UNKNOWN_FIELDS = 12;

/** A received task, before it is kept or started; or received results of a learner. */
export function TaughtDialog() {
  const shown = useOpenedCourseFile((s) => s.shown);
  switch (shown?.kind) {
    case "task":
      return <IncomingTask task={shown.task} left={shown.left} />;
    case "results":
      return <ResultView leftOut={shown.leftOut} />;
    case "problem":
      return <TaughtProblemView file={shown.file} problem={shown.problem} />;
    case undefined:
      return null;
  }
}

function IncomingTask({ task, left }: { readonly task: Task; readonly left: readonly string[] }) {
  const t = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const isHere = useSavedTasks((s) => s.list.some((each) => JSON.stringify(each) === JSON.stringify(task)));
  const words = inScreenLanguage(task.words, language);
  const number = (value: number) => formatNumber(language, value);
  const blank = task.part && boxAround([...blankOfLines(task.part.blank).rings]);
  const facts: readonly (readonly [keyof typeof t.incoming.facts, string])[] = [
    ["kind", t.kinds[task.kind]],
    ...(blank
      ? [["blank", `⌀${number(toDiameter(radius(blank.high)))} × ${number(blank.right - blank.left)}`] as const]
      : []),
    ["tools", task.rules.tools?.join(", ") ?? t.incoming.anyTools],
    ["size", t.kilobytes(formatNumber(language, taughtFile(task).length / 1000, 1))],
  ];
  const take = async () => {
    keepTask(task);
    closeCourseFile();
    await resumeOrStartTask(task, true);
  };
  return (
    <ModalDialog title={t.incoming.title(words?.title ?? task.id)} done={closeCourseFile}>
      <p>{t.incoming.lead}</p>
      {isHere && <Message tone="info">{t.incoming.isHere}</Message>}
      {left.length > 0 && (
        <Message tone="warning">{t.problem.leftOut(left.slice(0, MAX_UNKNOWN_FIELDS).join(", "))}</Message>
      )}
      {words && <p className="taught-ask">{words.ask}</p>}
      <dl className="modal-facts">
        {facts.map(([fact, value]) => (
          <div key={fact}>
            <dt>{t.incoming.facts[fact]}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      <div className="modal-ways">
        <button type="button" className="button primary modal-first" onClick={() => void take()}>
          {t.incoming.take}
        </button>
        <button
          type="button"
          className="button"
          onClick={() => {
            keepTask(task);
            closeCourseFile();
          }}
        >
          {t.incoming.keep}
        </button>
        <button type="button" className="button" onClick={closeCourseFile}>
          {t.incoming.not}
        </button>
      </div>
      {task.part && <WorkshopDrawing task={task} language={language} />}
    </ModalDialog>
  );
}
