import { readFileSync } from "node:fs";
import { z } from "zod/mini";
import { answerOf } from "../src/course/judge/answer.ts";
import { judge } from "../src/course/judge/judge.ts";
import type { Answer, TaskMark } from "../src/course/judge/judgement.ts";
import { isRefusedAsStated } from "../src/course/judge/refuses.ts";
import { targetPart } from "../src/course/target-part.ts";
import { lessonProblems, taskProblems } from "../src/course/course-problems.ts";
import { lessonSchema } from "../src/course/lesson.ts";
import { TASK_FORMAT, taskSchema, type Task } from "../src/course/task.ts";
import { areaOf } from "../src/kernel/area/area.ts";
import { toDiameter } from "../src/kernel/units.ts";
import { LESSON_LANGUAGES } from "../src/i18n/languages.ts";
import { message } from "../src/i18n/message.ts";

const write = (text = "") => void process.stdout.write(`${text}\n`);
const short = (n: number) => String(Math.round(n * 1000) / 1000);

function placeOf({ place }: TaskMark): string {
  return place ? ` at X${short(toDiameter(place.r))} Z${short(place.z)}` : "";
}

/** A mark on one line. */
function formatMark(mark: TaskMark, task: Task): string {
  const { rule, passed, value, limit, block, step, operation, q, about, size, entry, reason, issue } = mark;
  const asked = size === undefined ? undefined : task.sizes?.[size];
  const parts = [
    `${passed ? "  ok   " : "  WRONG"} ${rule}`,
    q,
    about === undefined ? undefined : `“${about}”`,
    asked && `${asked.kind} at ${asked.at}: ${asked.nominal} (${asked.lower}…${asked.upper})`,
    value === undefined ? undefined : short(value),
    limit === undefined ? undefined : `limit ${short(limit)}`,
    placeOf(mark).trim(),
    block === undefined ? undefined : `block ${block}`,
    operation === undefined ? undefined : `call ${operation}`,
    step === undefined ? undefined : `step ${step}`,
    entry === undefined ? undefined : `entry ${entry}`,
    reason,
    issue && message("en", issue),
  ];
  return parts.filter((p) => p !== undefined && p !== "").join("  ");
}

function sums({ run, simulation }: Answer): string {
  const calls = run.operations.map(
    (o, i) =>
      `call ${i}: cycle ${o.cycle} T${o.tool.T}, ${o.plan.passes} passes, infeed ${short(o.plan.infeed)}, deepest ${short(
        simulation.proof.operations[i]?.deepest?.depth ?? 0,
      )}, ${short(o.seconds)} s`,
  );
  return [
    `  ${short(simulation.totalSeconds)} s, made part ${short(areaOf(simulation.final))} mm²`,
    ...calls.map((c) => `  ${c}`),
  ].join("\n");
}

function show(title: string, task: Task, program: readonly string[], whole: boolean): Answer {
  const answer = answerOf(program.join("\n"));
  const judgement = judge(task, answer);
  write(`${title}: ${judgement.passed ? "PASSES" : "REFUSED"}`);
  write(sums(answer));
  for (const mark of judgement.marks) if (whole || !mark.passed) write(formatMark(mark, task));
  return answer;
}

function reportTask(file: string, task: Task): boolean {
  const wanted = task.part ? targetPart(task.part) : null;
  if (wanted) {
    write(`blank ${short(areaOf(wanted.blank))} mm², target part ${short(areaOf(wanted.rings))} mm²`);
    for (const ring of wanted.rings)
      write(
        `  X${ring
          .slice(0, 40)
          .map((p) => `${short(toDiameter(p.r))} Z${short(p.z)}`)
          .join("  X")}`,
      );
  }
  if (task.solution) show("solution", task, task.solution, true);
  (task.wrong ?? []).forEach((wrong, i) => {
    const answer = show(`wrong ${i + 1}`, task, wrong.program, false);
    const found = isRefusedAsStated(task, wrong, answer);
    write(
      found
        ? `  refused as the file says`
        : `  NOT REFUSED AS THE FILE SAYS: ${JSON.stringify({ ...wrong, program: undefined })}`,
    );
  });
  const problems = taskProblems(task, file);
  for (const problem of problems) write(`PROBLEM ${problem}`);
  return problems.length === 0;
}

function reportFile(file: string): boolean {
  write(`── ${file}`);
  const data: unknown = JSON.parse(readFileSync(file, "utf8"));
  const isTask = typeof data === "object" && data !== null && "format" in data && data.format === TASK_FORMAT;
  const read = isTask ? taskSchema.safeParse(data) : lessonSchema.safeParse(data);
  if (!read.success) {
    write(z.prettifyError(read.error));
    return false;
  }
  if (isTask) return reportTask(file, read.data as Task);
  const problems = lessonProblems(lessonSchema.parse(data), file);
  for (const problem of problems) write(`PROBLEM ${problem}`);
  return problems.length === 0;
}

/** `npm run course -- FILE.json …`: how each answer of a task is judged, and the problems of a task or a lesson. */
export function main(files: readonly string[]): number {
  if (files.length === 0) {
    write(`usage: npm run --silent course -- FILE.json …   (languages ${LESSON_LANGUAGES.join(", ")})`);
    return 2;
  }
  const wrong = files.filter((file) => !reportFile(file));
  write(wrong.length === 0 ? "all right" : `wrong: ${wrong.join(", ")}`);
  return wrong.length === 0 ? 0 : 1;
}
