import { useEffect, useId, useRef } from "react";
import type { Prediction, Task, TaskWords } from "../../../course/task.ts";
import { answerKindOf, toldBy } from "../../../course/told.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { Icon } from "../../Icon.tsx";
import { useSelection } from "../../selected.ts";
import { useEditor } from "../../store.ts";
import { useMedia } from "../../use-media.ts";
import { showRun } from "./check.ts";
import { useTaskView } from "./task-view.ts";
import { setTold, taskOfWork } from "./work-task.ts";

const NO_TEXTS: readonly string[] = [];

/** A block that is pointed at while its number is asked for is the answer. */
function usePointedBlock(question: number, asks: boolean): void {
  const isProgram = useEditor((s) => s.program !== null);
  useEffect(() => {
    if (!asks) return undefined;
    const tell = (block: number) => setTold(question, String(block));
    if (!isProgram) {
      return useSelection.subscribe(({ line }, before) => {
        if (line && line !== before.line) tell(line.block);
      });
    }
    let stop = () => undefined as void;
    let gone = false;
    void import("./open-numbered.ts").then(({ followPointed }) => {
      if (!gone) stop = followPointed(tell);
    });
    return () => {
      gone = true;
      stop();
    };
  }, [question, asks, isProgram]);
}

interface AskedProps {
  readonly prediction: Prediction;
  readonly question: number;
  readonly text: string;
  readonly choices: readonly string[];
  readonly t: CourseTaskTexts;
  readonly labelled: string;
}

const bare = (text: string) => text.replaceAll(" ", "");

/** The field of one question: a number, a place, one of several, or a block. */
function AskedAnswer({ prediction, question, text, choices, t, labelled }: AskedProps) {
  const name = useId();
  const kind = answerKindOf(prediction);
  const put = (next: string) => setTold(question, next);
  const field = (label: string, sign: string, value: string, take: (next: string) => void, unit = "") => (
    <label className="task-field">
      {sign !== "" && <span className="number" aria-hidden="true">{sign}</span>}
      <input className="input number" type="text" inputMode="decimal" autoComplete="off" value={value} aria-label={label}
        aria-describedby={labelled} maxLength={12} onChange={(event) => take(event.currentTarget.value)} />
      {unit !== "" && <span className="soft small">{unit}</span>}
    </label>
  );
  if (kind === "choice") {
    return (
      <fieldset className="task-choices" aria-labelledby={labelled}>
        {choices.map((choice, i) => (
          <label key={i} className="task-choice">
            <input type="radio" name={name} checked={text === String(i)} onChange={() => put(String(i))} /> <span>{choice}</span>
          </label>
        ))}
      </fieldset>
    );
  }
  if (kind === "place") {
    const [x = "", z = ""] = text.split(" ");
    return (
      <div className="task-fields">
        <span className="small">{t.foretell.place}</span>
        {field(t.foretell.x, "⌀", x, (next) => put(`${bare(next)} ${z}`))}
        {field(t.foretell.z, "Z", z, (next) => put(`${x} ${bare(next)}`))}
      </div>
    );
  }
  if (kind === "block") {
    return (
      <div className="task-fields">
        <span className="soft small">{t.foretell.tapBlock}</span>
        {field(t.foretell.block, "", text, put)}
      </div>
    );
  }
  const { ask } = prediction;
  const unit = ask in t.foretell.units ? t.foretell.units[ask as keyof typeof t.foretell.units] : "";
  return <div className="task-fields">{field(t.foretell.answer, "", text, put, unit)}</div>;
}

/** Where the assignment stands in the place of the work: the way to what is pointed at for an answer. */
function ToPointed({ kind, t }: { readonly kind: ReturnType<typeof answerKindOf>; readonly t: CourseTaskTexts }) {
  const isNarrow = useMedia("narrow");
  const isOpen = useTaskView((v) => v.open);
  if (!isNarrow || !isOpen || (kind !== "place" && kind !== "block")) return null;
  return (
    <button type="button" className="button" onClick={() => useTaskView.setState({ open: false })}>
      <Icon name="up" /> {t.foretell.toPointed[kind]}
    </button>
  );
}

/** What is asked before the run, one question at a time. */
export function ForetellForm({ task, t, words }: { readonly task: Task; readonly t: CourseTaskTexts; readonly words: TaskWords }) {
  const labelled = useId();
  const told = useEditor((s) => taskOfWork(s)?.told ?? NO_TEXTS);
  const asked = useTaskView((v) => v.question);
  const predict = task.predict ?? [];
  const question = Math.min(asked, predict.length - 1);
  const prediction = predict[question];
  usePointedBlock(question, prediction !== undefined && answerKindOf(prediction) === "block");
  const form = useRef<HTMLFormElement>(null);
  const isTyping = useRef(false);
  // Who goes on with Enter in a field types on in that of the next question; who presses the button stays on it.
  useEffect(() => {
    if (!isTyping.current) return;
    isTyping.current = false;
    (form.current?.querySelector<HTMLInputElement>("input:checked") ?? form.current?.querySelector("input"))?.focus();
  }, [question]);
  if (!prediction) return null;
  const isLast = question === predict.length - 1;
  const isSaid = (i: number) => {
    const each = predict[i];
    return each !== undefined && toldBy(each, told[i] ?? "") !== null;
  };
  const show = (next: number) => useTaskView.setState({ question: next });
  const all = predict.every((_, i) => isSaid(i));
  return (
    <form ref={form} className="task-now task-foretell" onSubmit={(event) => {
      event.preventDefault();
      if (!isLast && isSaid(question)) {
        isTyping.current = document.activeElement instanceof HTMLInputElement;
        show(question + 1);
      } else if (all) void showRun(task);
    }}>
      <p id={labelled} className="task-question">
        {predict.length > 1 && <span className="soft small">{t.foretell.question(question + 1, predict.length)}</span>}
        <b>{words.questions?.[question] ?? t.foretell.title}</b>
      </p>
      <AskedAnswer key={question} prediction={prediction} question={question} text={told[question] ?? ""}
        choices={words.choices?.[question] ?? []} t={t} labelled={labelled} />
      <div className="task-ways">
        <ToPointed kind={answerKindOf(prediction)} t={t} />
        {question > 0 && <button type="button" className="button" onClick={() => show(question - 1)}>{t.foretell.back}</button>}
        {isLast
          ? <button type="submit" className="button primary" disabled={!all}>{t.foretell.run}</button>
          : <button type="submit" className="button primary" disabled={!isSaid(question)}>{t.foretell.nextQuestion}</button>}
      </div>
    </form>
  );
}
