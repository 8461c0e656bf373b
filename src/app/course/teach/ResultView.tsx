import { useEffect, useRef, useState } from "react";
import type { HandedResult, TaskResult } from "../../../course/made/result.ts";
import { stateOfTask } from "../../../course/progress.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { openText } from "../../files/open-program.ts";
import { Icon } from "../../Icon.tsx";
import { useSettings } from "../../settings/settings.ts";
import { useModal } from "../../use-modal.ts";
import { taskOfId, verdictHere } from "./hand-in.ts";
import { leaveTaught } from "./taught-shown.ts";
import { useTeachTexts } from "./use-teach-texts.ts";

/** What a program comes to when it is run here; "unknown" where this device does not have its task. */
type Again = "passes" | "fails" | "unknown" | "none";

async function runAgain({ id, program }: TaskResult): Promise<Again> {
  const task = program === null ? null : await taskOfId(id);
  if (program === null) return "none";
  if (!task) return "unknown";
  return verdictHere(task, program).passed ? "passes" : "fails";
}

/** Runs each program once more, one after the other. */
function useAgain(tasks: readonly TaskResult[]): readonly Again[] {
  const [again, say] = useState<readonly Again[]>([]);
  useEffect(() => {
    let gone = false;
    void (async () => {
      const found: Again[] = [];
      for (const task of tasks) {
        found.push(await runAgain(task));
        if (gone) return;
        say([...found]);
        await new Promise((goOn) => setTimeout(goOn));
      }
    })();
    return () => {
      gone = true;
    };
  }, [tasks]);
  return again;
}

const MINUTE = 60;

/** Results that a learner handed in, as a table; each program is run once more and can be opened. */
export function ResultView({ result }: { readonly result: HandedResult }) {
  const t = useTeachTexts();
  const language = useSettings((s) => s.language);
  const dialog = useRef<HTMLDialogElement>(null);
  useModal(dialog);
  const again = useAgain(result.tasks);
  const words = t.results, number = (value: number, decimals = 1) => formatNumber(language, value, decimals);
  const told: Readonly<Record<Again, string>> = {
    passes: words.againPasses,
    fails: words.againFails,
    unknown: words.unknown,
    none: words.none,
  };
  const day = new Intl.DateTimeFormat(language, { dateStyle: "long", timeStyle: "short" }).format(result.made);
  return (
    <dialog ref={dialog} className="handing taught-wide" aria-label={words.title(result.name)}
      onClose={() => !dialog.current?.open && leaveTaught()} onKeyDown={(event) => event.stopPropagation()}
    >
      <div className="handing-head">
        <h2>{words.title(result.name)}</h2>
        <button type="button" className="button icon plain" aria-label={t.close} onClick={() => dialog.current?.close()}>
          <Icon name="close" />
        </button>
      </div>
      <p>{words.lead(day)}</p>
      <div className="taught-table" role="region" aria-label={words.title(result.name)} tabIndex={0}>
        <table>
          <thead>
            <tr>
              {[
                words.task,
                words.state,
                words.again,
                words.tries,
                words.hints,
                words.solution,
                words.time,
                words.steps,
                words.machining,
                words.program,
              ].map((head) => <th key={head} scope="col">{head}</th>)}
            </tr>
          </thead>
          <tbody>
            {result.tasks.map((task, i) => (
              <tr key={task.id}>
                <th scope="row">{task.title}</th>
                <td>{words.states[stateOfTask(task)]}</td>
                <td role={again[i] === undefined ? "status" : undefined}>{again[i] === undefined ? "…" : told[again[i]]}</td>
                <td className="number">{task.tries}</td>
                <td className="number">{task.hints}</td>
                <td>{task.solution ? words.yes : words.no}</td>
                <td className="number">
                  {task.worked < MINUTE ? words.seconds(number(task.worked, 0)) : words.minutes(number(task.worked / MINUTE, 0))}
                </td>
                <td className="number">{task.steps}</td>
                <td className="number">{task.seconds === null ? "–" : words.seconds(number(task.seconds, 0))}</td>
                <td>
                  {task.program !== null && (
                    <button type="button" className="button" aria-label={words.open(task.title)} onClick={() => {
                      leaveTaught();
                      openText(task.program ?? "");
                    }}>
                      <Icon name="unfold" />
                    </button>
                  )}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </dialog>
  );
}
