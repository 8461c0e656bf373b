import { judge } from "../../../course/judge/judge.ts";
import type { Answer, TaskJudgement } from "../../../course/judge/judgement.ts";
import { findSlip, hasSlip, withoutSlip, withSlip } from "../../../course/judge/slips.ts";
import type { Task } from "../../../course/task.ts";
import { areAllRight } from "../../../course/predicted-answers.ts";
import { presentProgram } from "../../../app/fields/compare/sides.ts";
import { stopwatch } from "../../../app/base/clock.ts";
import { outcomeOfOther } from "../../../app/calculation/other-outcome.ts";
import { useOutcome, type Outcome } from "../../../app/calculation/outcome.ts";
import { isResultOf } from "../../../app/calculation/result-of.ts";
import { isOpen } from "../../../app/findings/entry.ts";
import { chooseFinding } from "../../../app/document/chosen-finding.ts";
import { asProgram } from "../../../app/document/printed.ts";
import { openReading } from "../../../app/document/reading.ts";
import { flushEdits, openContent, useEditor } from "../../../app/document/store.ts";
import { progressOfTask } from "../../../course/progress.ts";
import { notePass, noteTry, progressRecord } from "../../../app/records/course/progress.ts";
import { areFixesShown } from "./fixes-shown.ts";
import { workOfTask } from "./begin.ts";
import { useTaskView, type NotReady } from "./task-view.ts";

/** Whether a result belongs to the current state of the open work. */
export function isOfWork(outcome: Outcome | null): outcome is Outcome {
  const content = openContent();
  return outcome !== null && content !== null && isResultOf(outcome, content);
}

/** Waits for the result of the current state of the open work; null if it fails or another work is opened. */
export function awaitOutcome(): Promise<Outcome | null> {
  const { work } = useEditor.getState();
  return new Promise((done) => {
    const look = () => {
      const { newest, stopped } = useOutcome.getState();
      const isLeft = useEditor.getState().work !== work;
      if (!isLeft && isOfWork(newest)) stop(newest);
      else if (isLeft || stopped) stop(null);
    };
    const leave = [useOutcome.subscribe(look), useEditor.subscribe(look)];
    const stop = (answer: Outcome | null) => {
      for (const end of leave) end();
      done(answer);
    };
    look();
  });
}

/** What the open work needs before it can be judged; null if nothing. */
function notReadyReason(): NotReady | null {
  const read = openReading();
  if (!read) return null;
  if (read.cycle.contour === "free" && read.job.contour.length === 0) return { why: "noContour" };
  if (read.reading.values) return null;
  const open = read.reading.issues.flatMap((issue) => (isOpen({ issue }) && issue.at !== undefined ? [issue.at] : []));
  return open.length > 0 ? { why: "empty", at: open } : { why: "notRun" };
}

/** Clears the note of a missing value once it is there. */
export function clearResolvedNotReady(): void {
  const { notReady } = useTaskView.getState();
  if (notReady?.why !== "empty" && notReady?.why !== "noContour") return;
  const lacks = notReadyReason();
  const isSame =
    lacks?.why === "empty" && notReady.why === "empty" ? lacks.at[0] === notReady.at[0] : lacks?.why === notReady.why;
  if (!isSame) useTaskView.setState({ notReady: null });
}

/** Whether an answer can be judged: something cuts, or there is an error that the start of a part does not have. */
const isJudged = ({ run, text }: Answer, task: Task): boolean =>
  run.steps.some(({ move }) => move.kind !== "rapid") ||
  run.plane.length > 0 ||
  (run.issues.some(({ issue }) => issue.severity === "error") &&
    (task.kind === "fault" || text !== asProgram(workOfTask(task)).text));

/** Why nothing is cut: a cycle that is never called, or nothing that cuts. */
function nothingCut({ run }: Answer): NotReady {
  const uncalled = run.issues.find(({ issue }) => issue.code === "cycleNeverCalled");
  return uncalled?.issue.code === "cycleNeverCalled"
    ? { why: "noCall", cycle: uncalled.issue.data.cycle }
    : { why: "noRun" };
}

/** Longest search for a slip, ms. */
const SEARCHING = 4000;

/** The judgement with the slip that explains it, if there is one. The slip that a task asks for is not given away. */
async function withSlipNamed(task: Task, answer: Answer, judgement: TaskJudgement): Promise<TaskJudgement> {
  const program = judgement.passed ? null : presentProgram();
  if (!program) return judgement;
  const end = stopwatch() + SEARCHING;
  const runOf = (text: string) => (stopwatch() < end ? outcomeOfOther({ ...program, text }) : Promise.resolve(null));
  const found = await findSlip(task, answer, judgement, runOf);
  if (!found) return withoutSlip(task, answer, judgement);
  const isAsked = task.kind === "fault" && !areFixesShown(progressOfTask(progressRecord.now(), task.id));
  if (!isAsked || !hasSlip(task, asProgram(workOfTask(task)).text, found.slip)) return withSlip(judgement, found);
  // The fault is not named; where it is the tool, the dimensions are not suspected either.
  return found.slip.values.some(({ q }) => q === "T") ? withoutSlip(task, answer, judgement) : judgement;
}

/** Waits for a paint, so that a long check shows its progress text. */
const afterPaint = (): Promise<void> => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

/** Judges the current state of the open work, and counts it as a try. */
export async function checkTask(task: Task): Promise<void> {
  const { work } = useEditor.getState();
  flushEdits();
  const lacks = notReadyReason();
  chooseFinding(null);
  if (lacks) return useTaskView.setState({ notReady: lacks });
  useTaskView.setState({ checking: true, notReady: null });
  const answer = await awaitOutcome();
  await afterPaint();
  if (useTaskView.getState().work !== work) return;
  if (!answer || !isJudged(answer, task))
    return useTaskView.setState({ checking: false, notReady: answer ? nothingCut(answer) : { why: "notRun" } });
  const judgement = await withSlipNamed(task, answer, judge(task, answer));
  if (useTaskView.getState().work !== work) return;
  const passed = judgement.passed && areAllRight(task, useTaskView.getState().comparedAnswers);
  const { score } = judgement;
  noteTry(task.id);
  if (passed) notePass(task.id, { seconds: answer.simulation.totalSeconds, ...(score && { score: score.total }) });
  useTaskView.setState({
    checking: false,
    checked: { answer, judgement, passed },
    live: judgement,
    stale: false,
    place: 0,
  });
}

/** Updates the goals after the first check, without counting a try. */
export function judgeQuietly(task: Task): void {
  const { checked } = useTaskView.getState();
  const { newest } = useOutcome.getState();
  if (!checked || !isOfWork(newest) || newest.text === checked.answer.text) return;
  useTaskView.setState({ live: judge(task, newest) });
}
