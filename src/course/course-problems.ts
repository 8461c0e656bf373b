import { LESSON_LANGUAGES } from "../i18n/languages.ts";
import { run } from "../program/run/run.ts";
import { parse } from "../nc/parse.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import type { Run } from "../program/state/run-types.ts";
import { cycleByNumber } from "../cycles/index.ts";
import { answerOf } from "./judge/answer.ts";
import { judge } from "./judge/judge.ts";
import { truthOf } from "./judge/predicting.ts";
import { TASK_RAPID } from "./judge/shop.ts";
import { hasAnswerInRun } from "./made/made-questions.ts";
import { isMadeAsLearned } from "./judge/word-rule.ts";
import { isRefusedAsStated } from "./judge/refuses.ts";
import { targetPart } from "./target-part.ts";
import { promptsText, solutionValues } from "./prompts.ts";
import type { Lesson } from "./lesson.ts";
import { HINTS, type Task } from "./task.ts";

/** Name of a file without its folders and its ending. */
const stem = (file: string) => file.replace(/^.*[\\/]/, "").replace(/\.json$/, "");

function wordProblems(task: Task): string[] {
  const asked = task.predict ?? [];
  return LESSON_LANGUAGES.flatMap((language) => {
    const words = task.words[language];
    if (!words) return [`no words in ${language}`];
    const questions = words.questions ?? [];
    const choices = asked.map((p, i) => ({ p, offered: words.choices?.[i] ?? [] }));
    return [
      ...(words.hints.length === HINTS ? [] : [`${language}: ${words.hints.length} hints of ${HINTS}`]),
      ...(questions.length === asked.length
        ? []
        : [`${language}: ${questions.length} questions for ${asked.length} predictions`]),
      ...choices.flatMap(({ p, offered }, i) =>
        p.ask === "choice"
          ? offered.length > (p.right ?? Infinity) && (p.right ?? -1) >= 0 && offered.length > 1
            ? []
            : [`${language}: choices of prediction ${i + 1}`]
          : offered.length === 0
            ? []
            : [`${language}: prediction ${i + 1} is no choice`],
      ),
    ];
  });
}

function startProblems({ start }: Task): string[] {
  if (!("cycle" in start)) return [];
  const cycle = cycleByNumber(start.cycle);
  if (!cycle) return [`no cycle ${start.cycle}`];
  return Object.keys(start.values)
    .filter((q) => !(q in cycle.params))
    .map((q) => `cycle ${start.cycle} has no ${q}`);
}

/** Problem: the starting state passes already, so there is nothing to do. */
function alreadyPassed(task: Task): string[] {
  const begun = begunText(task) ?? "BEGIN PGM EMPTY MM\nEND PGM EMPTY MM";
  return judge(task, answerOf(begun)).passed ? ["what lies open in the beginning passes already"] : [];
}

/**
 * Problem: the solution's values do not pass when typed into the starting prompts, with their blank, tool and start
 * point.
 */
function solutionValueProblems(task: Task): string[] {
  const values = solutionValues(task);
  const text = values && promptsText(task, values);
  if (!text) return "cycle" in task.start ? ["the solution does not call the cycle of the prompts"] : [];
  const wrong = judge(task, answerOf(text))
    .marks.filter((m) => !m.passed)
    .map((m) => m.rule);
  return wrong.length > 0
    ? [`typed into the prompts, the values of the solution are refused: ${wrong.join(", ")}`]
    : [];
}

function answerProblems(task: Task): string[] {
  const wanted = task.part ? targetPart(task.part) : null;
  const out = (wanted?.issues ?? []).map((p) => `part: ${p.code} ${JSON.stringify(p.data)}`);
  if (wanted && wanted.rings.length === 0) out.push("the target part is empty");
  if (!task.solution) return [...out, "no solution"];
  const judged = judge(task, answerOf(task.solution.join("\n")));
  for (const m of judged.marks)
    if (!m.passed) out.push(`the solution is refused: ${m.rule} ${m.q ?? m.about ?? ""} ${m.value ?? ""}`);
  if (!isMadeAsLearned(task, task.solution.join("\n"))) out.push("the solution is not made as `learnedBy` says");
  if (!task.wrong || task.wrong.length === 0) out.push("no wrong answer");
  (task.wrong ?? []).forEach((wrong, i) => {
    const { rule, at, block } = wrong;
    if (!at && block === undefined && !PLACELESS.includes(rule))
      out.push(`wrong answer ${i + 1} names no place and no block`);
    if (!isRefusedAsStated(task, wrong, answerOf(wrong.program.join("\n"))))
      out.push(`wrong answer ${i + 1} is not refused by ${rule} where it says`);
  });
  return [...out, ...alreadyPassed(task), ...solutionValueProblems(task)];
}

/** The starting state as a program; null for an empty one. */
const begunText = (task: Task): string | null =>
  "program" in task.start ? task.start.program.join("\n") : promptsText(task);

/** Problem: the run of the starting state does not contain what a question asks for. */
function predictionProblems(task: Task): string[] {
  if (!task.predict?.length) return [];
  const begun = begunText(task);
  if (begun === null) return ["nothing is left to predict"];
  const answer = answerOf(begun);
  return task.predict.flatMap((prediction, i) => {
    const truth = truthOf(prediction, task, answer);
    const there = hasAnswerInRun(truth, answer);
    const vague = (prediction.ask === "seconds" || prediction.ask === "residue") && prediction.within === undefined;
    return [
      ...(there ? [] : [`prediction ${i + 1}: there is no such thing in the run`]),
      ...(vague ? [`prediction ${i + 1} needs \`within\``] : []),
    ];
  });
}

/** Rules about the program as a whole, without a place. */
const PLACELESS: readonly string[] = ["seconds", "cycles", "words", "passes", "mostTools", "blank", "values"];

/** The problems of a shipped task; empty without any. */
export function taskProblems(task: Task, file: string): string[] {
  const out = stem(file) === task.id ? [] : [`the id is ${task.id}`];
  out.push(...wordProblems(task), ...startProblems(task), ...predictionProblems(task));
  if (task.kind === "predict") {
    if (!task.predict?.length) out.push("nothing is predicted");
  } else out.push(...answerProblems(task));
  if (task.kind === "drawing" && !(task.part && task.par)) out.push("a drawing needs a part and a par");
  return out;
}

/** The errors of a run. */
function programErrors(lines: readonly string[]): string[] {
  const made: Run = run(parse(lines.join("\n")), { tools: shippedTools, rapid: TASK_RAPID });
  return made.issues
    .filter((f) => f.issue.severity === "error")
    .map((f) => `block ${f.block}: ${f.issue.code} ${JSON.stringify(f.issue.data)}`);
}

/** The problems of a shipped lesson; empty without any. */
export function lessonProblems(lesson: Lesson, file: string): string[] {
  const out: string[] = [];
  const name = `${String(lesson.number).padStart(2, "0")}-${lesson.id}`;
  if (stem(file) !== name) out.push(`the file should be called ${name}.json`);
  for (const language of LESSON_LANGUAGES) {
    const words = lesson.words[language];
    if (!words) out.push(`no words in ${language}`);
    else if (words.pages.length !== lesson.pages.length)
      out.push(`${language}: ${words.pages.length} texts for ${lesson.pages.length} pages`);
  }
  if (!lesson.pages[0]?.program) out.push("the first page has no program");
  lesson.pages.forEach(({ program }, i) => {
    if (program) out.push(...programErrors(program).map((e) => `page ${i + 1}: ${e}`));
  });
  if (lesson.example) out.push(...programErrors(lesson.example).map((e) => `example: ${e}`));
  return out;
}
