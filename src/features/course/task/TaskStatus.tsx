import { countGoals, goalsOf, isMet } from "../../../course/goals.ts";
import { stateOfTask } from "../../../course/progress.ts";
import type { Task } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { draftOf } from "../../../app/document/edits.ts";
import { FIRST_FOCUS } from "../../../app/base/focus-guard.ts";
import { openPrompt, enterSection, releaseKeyboard } from "../../../app/place/place.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useEditor } from "../../../app/document/store.ts";
import type { ParamTextId } from "../../../cycles/index.ts";
import { cycleByNumber } from "../../../cycles/index.ts";
import { useTaskProgress } from "../../../app/records/course/progress.ts";
import { useHasDrawing } from "./use-has-drawing.ts";
import { useTaskView, type NotReady } from "./task-view.ts";

/** Empty prompts named at once; the others follow once these have values. */
const NAMED = 3;

/** Opens the first empty prompt. */
function openFirstMissing(lacks: NotReady): void {
  const { job } = useEditor.getState();
  if (lacks.why === "noContour") return enterSection("contour");
  const q = lacks.why === "empty" ? lacks.at[0] : undefined;
  if (!job || q === undefined) return;
  releaseKeyboard();
  openPrompt(q, draftOf(job)[q] ?? "");
}

/** Why a check could not judge yet; that never counts as a try. */
function Lacking({ lacks, t }: { readonly lacks: NotReady; readonly t: CourseTaskTexts }) {
  const texts = useTexts();
  const cycle = useEditor((s) => s.job && cycleByNumber(s.job.cycle));
  const nameOf = (q: string) => {
    const param = cycle?.params[q];
    return param ? `${q} ${texts.params[param.text as ParamTextId].label}` : q;
  };
  if (lacks.why === "noCall") return <span>{t.noCall(String(lacks.cycle))}</span>;
  if (lacks.why === "noRun" || lacks.why === "notRun") return <span>{t[lacks.why]}</span>;
  const names =
    lacks.why === "empty"
      ? lacks.at.slice(0, NAMED).map(nameOf).join(", ") + (lacks.at.length > NAMED ? ", …" : "")
      : "";
  return (
    <>
      <span>{lacks.why === "empty" ? t.empty(names) : t.noContour}</span>
      <button type="button" className="button plain" onClick={() => openFirstMissing(lacks)} {...{ [FIRST_FOCUS]: "" }}>
        {t.goTo(lacks.why === "empty" ? (lacks.at[0] ?? "") : texts.page.contour)}
      </button>
    </>
  );
}

/** Whether the last check, or the run after the predictions, passed the current work. */
export function usePassedNow({ kind }: Task): boolean {
  const { checked, stale, comparedAnswers } = useTaskView();
  if (stale) return false;
  return checked
    ? checked.passed
    : kind === "predict" &&
        comparedAnswers !== null &&
        comparedAnswers.length > 0 &&
        comparedAnswers.every(({ right }) => right);
}

/** The status in one line: not ready, number of open goals, or passed. Announced after a check, not while editing. */
export function TaskStatus({ task, t }: { readonly task: Task; readonly t: CourseTaskTexts }) {
  const language = useSettings((s) => s.language);
  const { checking, notReady, checked, stale, comparedAnswers } = useTaskView();
  const progress = useTaskProgress(task.id);
  const { tries } = progress;
  const state = stateOfTask(progress);
  const rights = (comparedAnswers ?? []).map(({ right }) => right);
  const isPassed = usePassedNow(task);
  const hasDrawing = useHasDrawing(task);
  const say = () => {
    if (checking) return <span>{t.checking} …</span>;
    if (notReady) return <Lacking lacks={notReady} t={t} />;
    if (isPassed) {
      return (
        <span className="task-passed">
          <Icon name="check" /> {state === "new" || state === "tried" ? t.passed : t.passedFor[state]}
        </span>
      );
    }
    if (stale) return <span className="soft">{t.stale}</span>;
    if (!checked) return tries > 0 && <span className="soft">{t.tries(tries)}</span>;
    const { open, all } = countGoals(goalsOf(task), hasDrawing, (goal) => isMet(goal, checked.judgement, rights));
    return (
      <span className="task-failed">
        <Icon name="info" /> {t.failed(open, all)}
      </span>
    );
  };
  return (
    <p className="task-status" role="status" lang={language}>
      {say()}
    </p>
  );
}
