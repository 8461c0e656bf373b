import { Suspense, useEffect, useState } from "react";
import { progressOfTask, stateOfTask } from "../../../course/progress.ts";
import { Icon } from "../../Icon.tsx";
import { lazyPart } from "../../parts.ts";
import { useSettings } from "../../settings/settings.ts";
import { inScreenLanguage } from "../content.ts";
import { useLearning } from "../progress.ts";
import { TaskStateMark } from "../TaskStateMark.tsx";
import { beginTask } from "../task/begin.ts";
import { removeTask, startTaught, useTaught } from "./taught.ts";
import { useTeachTextsSoon } from "./use-teach-texts.ts";
import "./teach.css";

const HandInDialog = lazyPart(async () => ({ default: (await import("./HandInDialog.tsx")).HandInDialog }));

/** The tasks that came from outside, below the lessons, and the way to hand in what was done. */
export function TaughtTasks() {
  const t = useTeachTextsSoon();
  const language = useSettings((s) => s.language);
  const { list, trouble } = useTaught();
  const learning = useLearning((s) => s.list);
  const [hands, handIn] = useState(false);
  useEffect(startTaught, []);
  if (!t) return null;
  return (
    <section className="taught" aria-label={t.own.title}>
      {(list.length > 0 || trouble !== "none") && <h2>{t.own.title}</h2>}
      {trouble !== "none" && (
        <p className="field-message warning">
          <Icon name="warning" /> {t.own[trouble]}
        </p>
      )}
      {list.length > 0 && (
        <ul className="taught-list">
          {list.map((task) => {
            const title = inScreenLanguage(task.words, language)?.title ?? task.id;
            return (
              <li key={task.id}>
                <span className="taught-name">{title}</span>
                <TaskStateMark state={stateOfTask(progressOfTask(learning, task.id))} />
                <button type="button" className="button" aria-label={t.own.begin(title)} onClick={() => void beginTask(task, true)}>
                  <Icon name="play" />
                </button>
                <button type="button" className="button plain" aria-label={t.own.remove(title)} onClick={() => removeTask(task.id)}>
                  <Icon name="remove" />
                </button>
              </li>
            );
          })}
        </ul>
      )}
      <div className="handing-ways">
        <button type="button" className="button" aria-haspopup="dialog" onClick={() => handIn(true)}>
          <Icon name="share" /> {t.hand.open}
        </button>
      </div>
      {hands && (
        <Suspense>
          <HandInDialog done={() => handIn(false)} />
        </Suspense>
      )}
    </section>
  );
}
