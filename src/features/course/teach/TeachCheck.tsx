import { useMemo, useState } from "react";
import { withoutAnswer } from "../../../course/task-set.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { formatNumber } from "../../../i18n/number.ts";
import type { TaskJudgement, TaskMark } from "../../../course/judge/judgement.ts";
import type { FormFault } from "../../../course/made/task-from-form.ts";
import type { Task } from "../../../course/task.ts";
import { lazyPart } from "../../../app/base/parts.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { startTask } from "../task/begin.ts";
import { pageAddress } from "../../../app/records/local-address.ts";
import { LinkBox } from "./LinkBox.tsx";
import { forgetForm } from "../../../app/records/course/kept-form.ts";
import { keepTask, useSavedTasks } from "../../../app/records/course/saved-tasks.ts";
import { taskLink, taughtFile } from "./taught-files.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

const TaskPaper = lazyPart(async () => ({ default: (await import("./TaskPaper.tsx")).TaskPaper }));

/** Most marks listed. */
const MAX_MARKS = 6;

/**
 * Whether the answer passes its own task; then the task can be tried and shared. A shared task is also kept here, so
 * that results can be run when they come back.
 */
export function TeachCheck({
  task,
  judged,
  isIdle,
  foretells,
  lacking,
  formKey,
  isChange,
  done,
}: {
  readonly task: Task | readonly FormFault[];
  readonly judged: TaskJudgement | null;
  readonly isIdle: boolean;
  /** It has questions only: there is no answer to judge. */
  readonly foretells: boolean;
  /** Numbers, from 1, of incomplete questions, and of those whose answer does not exist. */
  readonly lacking: Readonly<Record<"questions" | "truth", readonly number[]>>;
  /** Storage key of the form, and whether it changes a kept task. */
  readonly formKey: string;
  readonly isChange: boolean;
  readonly done: () => void;
}) {
  const t = useTexts("course-teach");
  const lacks = lacking.truth.length > 0;
  const faults = "length" in task ? [...task, ...(lacks ? ["truth" as const] : [])] : lacks ? ["truth" as const] : null;
  const whole = "length" in task || lacks ? null : task;
  const isKept = useSavedTasks(
    (s) => whole !== null && s.list.some((each) => JSON.stringify(each) === JSON.stringify(whole)),
  );
  const wrong = judged?.marks.filter(({ passed }) => !passed) ?? [];
  const ready = whole && (foretells || (judged?.passed && !isIdle)) ? whole : null;
  /** A kept task needs no stored form: the form is filled in from the task next time. */
  const keep = (kept: Task) => {
    keepTask(kept);
    if (isChange) forgetForm(formKey);
  };
  return (
    <section className="teach-checked" aria-label={t.check}>
      <h3>{t.check}</h3>
      <div role="status" className="teach-status">
        {faults && (
          <ul>
            {faults.map((fault) => (
              <li key={fault}>
                <Icon name="info" />{" "}
                {(fault === "questions" || fault === "truth") && (
                  <b>{lacking[fault].map((number) => t.question(String(number))).join(", ")}:</b>
                )}{" "}
                {t.needs[fault]}
              </li>
            ))}
          </ul>
        )}
        {foretells && ready && (
          <p className="teach-good">
            <Icon name="check" /> {t.runAnswers}
          </p>
        )}
        {judged?.passed && !isIdle && !lacks && (
          <p className="teach-good">
            <Icon name="check" /> {t.passes}
          </p>
        )}
        {judged?.passed && isIdle && (
          <p>
            <Icon name="warning" /> {t.idle}
          </p>
        )}
        {wrong.length > 0 && (
          <>
            <p className="teach-bad">
              <Icon name="error" /> {t.refused}
            </p>
            <ul>
              {wrong.slice(0, MAX_MARKS).map((mark, i) => (
                <FailedMark key={i} mark={mark} />
              ))}
            </ul>
          </>
        )}
      </div>
      <div className="modal-ways">
        <button
          type="button"
          className="button"
          disabled={!ready}
          onClick={() => {
            if (!ready) return;
            done();
            keep(ready);
            startTask(ready, true);
          }}
        >
          <Icon name="play" /> {t.tryIt}
        </button>
        <button type="button" className="button" disabled={!ready || isKept} onClick={() => ready && keep(ready)}>
          <Icon name="check" /> {isChange ? t.save : t.saveNew}
        </button>
      </div>
      {isKept && <p className="soft">{t.saved}</p>}
      {ready && <HandOut task={ready} keep={() => keep(ready)} />}
    </section>
  );
}

function FailedMark({ mark: { rule, value, limit, block } }: { readonly mark: TaskMark }) {
  const t = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const number = (n: number | undefined) => (n === undefined ? "" : formatNumber(language, n));
  const where = block === undefined ? "" : t.inBlock(String(block));
  const value0 = [number(value), where].filter((part) => part !== "").join(", ");
  return (
    <li>{value0 === "" && limit === undefined ? t.judged[rule] : t.mark(t.judged[rule], value0, number(limit))}</li>
  );
}

function HandOut({ task, keep }: { readonly task: Task; readonly keep: () => void }) {
  const t = useTexts("course-teach"),
    words = useTexts("course-set");
  const language = useSettings((s) => s.language);
  const [isWhole, include] = useState(true);
  const [isOnPaper, print] = useState(false);
  const given = useMemo(() => (isWhole ? task : withoutAnswer(task, true)), [task, isWhole]);
  return (
    <>
      <h3>{t.handOut}</h3>
      {task.solution && (
        <label className="teach-check">
          <input type="checkbox" checked={isWhole} onChange={() => include(!isWhole)} />
          {words.includeSolution}
        </label>
      )}
      <p className="soft small">{isWhole ? words.withAnswers : words.without.hints}</p>
      <LinkBox
        link={taskLink(pageAddress(), given)}
        name={inScreenLanguage(task.words, language)?.title ?? task.id}
        file={{ name: `${task.id}.turnwise-task.json`, text: taughtFile(given), label: t.saveTask }}
        before={keep}
      />
      <div className="modal-ways">
        <button type="button" className="button" aria-haspopup="dialog" onClick={() => print(true)}>
          <Icon name="print" /> {words.paper.open}
        </button>
      </div>
      {isOnPaper && <TaskPaper tasks={[task]} done={() => print(false)} />}
    </>
  );
}
