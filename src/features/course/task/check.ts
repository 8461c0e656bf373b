import { judge } from "../../../course/judge/judge.ts";
import type { Answer } from "../../../course/judge/judgement.ts";
import { wrongSideOf } from "../../../course/judge/wrong-side.ts";
import type { Task } from "../../../course/task.ts";
import type { RunFinding } from "../../../program/state/run-types.ts";
import { SLIP_CODES } from "../../../program/values/dimension-slips.ts";
import { comparePredictedAnswers, type ComparedAnswer } from "../../../course/predicted-answers.ts";
import { asProgram } from "../../../app/fields/compare/sides.ts";
import { restartComparison } from "../../../app/findings/effect/compared.ts";
import { outcomeOfOther } from "../../../app/calculation/other-outcome.ts";
import { calculation } from "../../../app/calculation/calculation.ts";
import { isMadeFrom, useOutcome, type Outcome } from "../../../app/calculation/outcome.ts";
import { isOpen } from "../../../app/findings/entry.ts";
import { chooseFinding } from "../../../app/document/chosen-finding.ts";
import { printedText } from "../../../app/document/printed.ts";
import { readJob } from "../../../app/document/reading.ts";
import { flushEdits, useEditor } from "../../../app/document/store.ts";
import { notePass, noteTry } from "../../../app/records/course/progress.ts";
import { workOfTask } from "./begin.ts";
import { useTaskView, type NotReady } from "./task-view.ts";
import { changeTask, taskOfWork } from "../../../app/document/work-task.ts";

/** Whether a result belongs to the current state of the open work. */
export function isOfWork(outcome: Outcome | null): outcome is Outcome {
  const { job, program } = useEditor.getState();
  if (!outcome) return false;
  return program ? isMadeFrom(outcome, program) : job !== null && outcome.text === printedText(job);
}

/** Waits for the result of the current state of the open work; null if it fails or another work is opened. */
function awaitOutcome(): Promise<Outcome | null> {
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
  const { job } = useEditor.getState();
  const read = job && readJob(job);
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

/** Whether an issue says which dimension is wrong. */
const isSlip = ({ issue }: RunFinding): boolean =>
  issue.severity === "error" && (SLIP_CODES.has(issue.code) || wrongSideOf(issue) !== null);

/**
 * Whether an answer can be judged: something cuts, or a cycle call is refused for a dimension that is not as the task
 * began.
 */
const isJudged = ({ run, text }: Answer, task: Task): boolean =>
  run.steps.some(({ move }) => move.kind !== "rapid") ||
  run.plane.length > 0 ||
  (run.issues.some(isSlip) && text !== asProgram(workOfTask(task)).text);

const areRight = (answers: readonly ComparedAnswer[] | null, task: Task): boolean =>
  (task.predict ?? []).every((_, i) => answers?.[i]?.right === true);

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
    return useTaskView.setState({ checking: false, notReady: { why: answer ? "noRun" : "notRun" } });
  const judgement = judge(task, answer);
  const passed = judgement.passed && areRight(useTaskView.getState().comparedAnswers, task);
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

const cachedStartOutcomes = new WeakMap<Task, Answer>();

/** The result of the program that the task starts with. */
async function answerAtStart(task: Task): Promise<Answer | null> {
  const known = cachedStartOutcomes.get(task);
  if (known) return known;
  const made = await outcomeOfOther(asProgram(workOfTask(task)));
  if (made) cachedStartOutcomes.set(task, made);
  return made;
}

/** Compares the predictions with the actual run; null if that is not available. */
export async function comparePredictions(task: Task): Promise<readonly ComparedAnswer[] | null> {
  const { work } = useEditor.getState();
  const truth = await answerAtStart(task);
  const now = useEditor.getState();
  const { told = [], veiled = false } = taskOfWork(now) ?? {};
  if (!truth || now.work !== work || veiled) return null;
  const answers = comparePredictedAnswers(task, told, truth);
  useTaskView.setState({ comparedAnswers: answers });
  return answers;
}

/** Shows the run once all predictions are made. In a task of predictions only, this counts as the try. */
export async function showRun(task: Task): Promise<void> {
  changeTask(({ veiled: _, ...told }) => told);
  // The cached result belongs to the hidden run.
  calculation.recalculate();
  // Showing the run is not a change of values.
  void awaitOutcome().then(restartComparison);
  const answers = await comparePredictions(task);
  if (!answers || task.kind !== "predict") return;
  noteTry(task.id);
  if (areRight(answers, task)) notePass(task.id);
}

/** Asks the wrong predictions again, with the run hidden. */
export function retryPredictions(): void {
  const { comparedAnswers } = useTaskView.getState();
  const isRight = (i: number) => comparedAnswers?.[i]?.right === true;
  changeTask(({ id, file, told = [] }) => ({
    id,
    ...(file !== undefined && { file }),
    veiled: true,
    told: told.map((text, i) => (isRight(i) ? text : "")),
  }));
  const question = Math.max(0, comparedAnswers?.findIndex(({ right }) => !right) ?? 0);
  useTaskView.setState({ comparedAnswers: null, checked: null, live: null, question });
  calculation.recalculate();
}
