import { useRef } from "react";
import { createPortal } from "react-dom";
import { goalsOf } from "../../../course/goals.ts";
import type { Task } from "../../../course/task.ts";
import type { TaskSet } from "../../../course/task-set.ts";
import { toolsOfTask } from "../../../course/task-start.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { cellOf } from "../../../program/tools/tool-entry.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { WorkshopDrawing } from "../drawing/WorkshopDrawing.tsx";
import { goalText } from "../task/goal-words.ts";
import { termsOnPaper } from "./exam-words.ts";
import "./paper.css";

interface Props {
  /** The tasks, one sheet each, and the set that they belong to. */
  readonly tasks: readonly Task[];
  readonly set?: TaskSet;
  readonly done: () => void;
}

/** Lines to write on: name, class and date. */
function Lines() {
  const { paper } = useTexts("course-set");
  return (
    <dl className="paper-lines">
      {([paper.name, paper.group, paper.day] as const).map((line) => (
        <div key={line}>
          <dt>{line}</dt>
          <dd />
        </div>
      ))}
    </dl>
  );
}

/** One task: assignment, drawing, blank, tools and goals. */
function Sheet({ task, heading }: { readonly task: Task; readonly heading: string }) {
  const t = useTexts("course-task"),
    { paper } = useTexts("course-set");
  const { duration } = useTexts("first").page.effect;
  const language = useSettings((s) => s.language);
  const words = inScreenLanguage(task.words, language);
  const { rules, start, predict = [], part } = task;
  const tools = rules.tools && toolsOfTask(task);
  return (
    <article className="paper-sheet">
      <Lines />
      {heading !== "" && <p className="paper-set">{heading}</p>}
      <h2>{words?.title ?? task.id}</h2>
      <p className="taught-ask">{words?.ask}</p>
      {part && (
        <>
          <WorkshopDrawing task={task} language={language} />
          <h3>{paper.blank}</h3>
          <pre className="number">{part.blank.join("\n")}</pre>
        </>
      )}
      {"program" in start && (
        <>
          <h3>{paper.program}</h3>
          <pre className="number">{start.program.join("\n")}</pre>
        </>
      )}
      {predict.length > 0 && (
        <>
          <h3>{paper.questions}</h3>
          <ol className="paper-questions">
            {predict.map((_, i) => (
              <li key={i}>
                {words?.questions?.[i]}
                {(words?.choices?.[i] ?? []).map((choice) => (
                  <span key={choice} className="paper-choice">
                    ☐ {choice}
                  </span>
                ))}
              </li>
            ))}
          </ol>
        </>
      )}
      {task.kind !== "predict" && (
        <>
          <h3>{paper.tools}</h3>
          <p>
            {tools ? tools.map((entry) => `T${cellOf(entry, "T")} ${cellOf(entry, "NAME")}`).join(", ") : paper.anyTool}
          </p>
          <h3>{t.goals}</h3>
          <ul className="set-terms">
            {goalsOf(task)
              .filter(({ kind }) => kind !== "predicted")
              .map((goal, i) => (
                <li key={i}>{goalText(t, duration, language, goal)}</li>
              ))}
          </ul>
        </>
      )}
    </article>
  );
}

/** Whole tasks on paper, one sheet each, as they are printed. */
export function TaskPaper({ tasks, set, done }: Props) {
  const words = useTexts("course-set");
  const { close } = useTexts("first").page;
  const language = useSettings((s) => s.language);
  const paper = useSettings((s) => s.paper);
  const dialog = useRef<HTMLDialogElement>(null);
  const title = set && (inScreenLanguage(set.words, language)?.title ?? set.id);
  return createPortal(
    <ModalDialog isBare ref={dialog} className="paper" first=".paper-print" title={words.paper.title} done={done}>
      <div className="paper-bar">
        <button type="button" className="button" onClick={() => dialog.current?.close()}>
          <Icon name="back" /> {close}
        </button>
        <button type="button" className="button primary paper-print" onClick={() => print()}>
          <Icon name="print" /> {words.paper.print}
        </button>
      </div>
      <div className="paper-view" data-paper={paper} tabIndex={0} role="region" aria-label={words.paper.title}>
        {set?.exam && (
          <article className="paper-sheet">
            <Lines />
            <h2>{words.exam.title(title ?? "")}</h2>
            <p className="taught-ask">{inScreenLanguage(set.words, language)?.about}</p>
            <ul className="set-terms">
              {termsOnPaper(set, words, language).map((term) => (
                <li key={term}>{term}</li>
              ))}
            </ul>
          </article>
        )}
        {tasks.map((task, i) => (
          <Sheet
            key={task.id}
            task={task}
            heading={title ? `${title} · ${words.place(String(i + 1), String(tasks.length))}` : ""}
          />
        ))}
      </div>
    </ModalDialog>,
    document.body,
  );
}
