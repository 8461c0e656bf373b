import { useEffect } from "react";
import { formatNumber } from "../../../i18n/number.ts";
import type { TaskJudgement, TaskMark } from "../../../course/judge/judgement.ts";
import type { MadeFault } from "../../../course/made/made-task.ts";
import type { Task } from "../../../course/task.ts";
import { downloadText } from "../../files/download.ts";
import { Icon } from "../../Icon.tsx";
import { useSettings } from "../../settings/settings.ts";
import { beginTaskAnew } from "../task/begin.ts";
import { LinkBox, pageAddress } from "./LinkBox.tsx";
import { keepTask, startTaught } from "./taught.ts";
import { taskLink, taughtFile } from "./taught-files.ts";
import { useTeachTexts } from "./use-teach-texts.ts";

/** Most marks that are told at once. */
const MOST_TOLD = 6;

/**
 * Whether the answer passes its own task; then it is tried and handed out. What goes out is kept here too, so that answers to it can be run
 * when they come back.
 */
export function TeachCheck({ task, judged, isIdle, done }: { readonly task: Task | readonly MadeFault[];
  readonly judged: TaskJudgement | null; readonly isIdle: boolean; readonly done: () => void })
{
  const t = useTeachTexts();
  useEffect(startTaught, []);
  const faults = "length" in task ? task : null, whole = "length" in task ? null : task;
  const wrong = judged?.marks.filter(({ passed }) => !passed) ?? [];
  const ready = whole && judged?.passed && !isIdle ? whole : null;
  return (
    <section className="teach-checked" aria-label={t.check}>
      <h3>{t.check}</h3>
      <div role="status" className="teach-status">
        {faults && (
          <ul>
            {faults.map((fault) => (
              <li key={fault}>
                <Icon name="info" /> {t.needs[fault]}
              </li>
            ))}
          </ul>
        )}
        {judged?.passed && !isIdle && (
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
            <ul>{wrong.slice(0, MOST_TOLD).map((mark, i) => <Told key={i} mark={mark} />)}</ul>
          </>
        )}
      </div>
      <div className="handing-ways">
        <button type="button" className="button" disabled={!ready} onClick={() => {
          if (!ready) return;
          done();
          keepTask(ready);
          beginTaskAnew(ready, true);
        }}>
          <Icon name="play" /> {t.tryIt}
        </button>
      </div>
      {ready && <HandOut task={ready} />}
    </section>
  );
}

function Told({ mark: { rule, value, limit, block } }: { readonly mark: TaskMark }) {
  const t = useTeachTexts();
  const language = useSettings((s) => s.language);
  const number = (n: number | undefined) => (n === undefined ? "" : formatNumber(language, n));
  const where = block === undefined ? "" : t.inBlock(String(block));
  const value0 = [number(value), where].filter((part) => part !== "").join(", ");
  return <li>{value0 === "" && limit === undefined ? t.judged[rule] : t.mark(t.judged[rule], value0, number(limit))}</li>;
}

function HandOut({ task }: { readonly task: Task }) {
  const t = useTeachTexts();
  return (
    <>
      <h3>{t.handOut}</h3>
      <LinkBox link={taskLink(pageAddress(), task)} copies={() => keepTask(task)} />
      <div className="handing-ways">
        <button type="button" className="button" onClick={() => {
          keepTask(task);
          downloadText(taughtFile(task), `${task.id}.turnwise-task.json`);
        }}>
          <Icon name="download" /> {t.saveTask}
        </button>
      </div>
    </>
  );
}
