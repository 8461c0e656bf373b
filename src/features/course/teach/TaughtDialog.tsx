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
import { ExamStart } from "./ExamStart.tsx";
import { HandInDialog } from "./HandInDialog.tsx";
import { IncomingSet } from "./IncomingSet.tsx";
import { ResultView } from "./ResultView.tsx";
import { SetDialog } from "./SetDialog.tsx";
import { useExams } from "../../../app/records/course/exams.ts";
import { useSavedSets } from "../../../app/records/course/saved-sets.ts";
import { keepTask, useSavedTasks } from "../../../app/records/course/saved-tasks.ts";
import { taughtFile } from "./taught-files.ts";
import { TaughtProblemView } from "./TaughtProblemView.tsx";
import { closeCourseFile, useOpenedCourseFile } from "../../../app/records/course/opened-course-file.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import type { Task } from "../../../course/task.ts";
import "./set.css";
import "./teach.css";

/** Most fields named at once. */
const MAX_UNKNOWN_FIELDS = 12;

/** The dialog of the course: a received task or set, results of learners, and what can be done with a set. */
export function TaughtDialog() {
  const shown = useOpenedCourseFile((s) => s.shown);
  switch (shown?.kind) {
    case "task":
      return <IncomingTask task={shown.task} left={shown.left} />;
    case "set":
      return <IncomingSet set={shown.set} left={shown.left} />;
    case "exam":
    case "makeSet":
    case "handIn":
      return <OfSet {...shown} />;
    case "results":
      return <ResultView leftOut={shown.leftOut} />;
    case "problem":
      return <TaughtProblemView file={shown.file} problem={shown.problem} />;
    case undefined:
      return null;
  }
}

/** The dialogs of a saved set; nothing once it was removed. */
function OfSet({ kind, id }: { readonly kind: "exam" | "makeSet" | "handIn"; readonly id: string | null }) {
  const saved = useSavedSets((s) => s.list.find((set) => set.id === id));
  const exam = useExams(({ list }) => (id === null ? undefined : list[id]));
  // What was handed in outlives its set.
  const set = saved ?? exam?.set;
  if (kind === "handIn" && (set || id === null)) return <HandInDialog set={set} done={closeCourseFile} />;
  if (!set) return null;
  return kind === "exam" ? (
    <ExamStart set={set} done={closeCourseFile} />
  ) : (
    <SetDialog set={set} done={closeCourseFile} />
  );
}

function IncomingTask({ task, left }: { readonly task: Task; readonly left: readonly string[] }) {
  const t = useTexts("course-teach"),
    sets = useTexts("course-set");
  const language = useSettings((s) => s.language);
  const own = useSavedTasks((s) => s.list.find(({ id }) => id === task.id));
  const isHere = own !== undefined && JSON.stringify(own) === JSON.stringify(task);
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
  // The instructor opens what was handed out: the copy with the solution must stay.
  const keep = () => {
    if (task.solution || !own?.solution) keepTask(task);
  };
  const take = async () => {
    keep();
    closeCourseFile();
    await resumeOrStartTask(task, true);
  };
  return (
    <ModalDialog title={t.incoming.title(words?.title ?? task.id)} done={closeCourseFile}>
      <p>{task.solution ? t.incoming.lead : sets.incoming.task}</p>
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
            keep();
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
