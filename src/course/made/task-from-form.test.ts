import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { answerOf } from "../judge/answer.ts";
import { judge } from "../judge/judge.ts";
import type { Task } from "../task.ts";
import { possibleFaults, withFaults } from "./faults.ts";
import {
  startProgramOfForm,
  linesOfText,
  outlinesFrom,
  proposedTask,
  learnerProgramOfForm,
  promptsOf,
  taskOfForm,
} from "./task-from-form.ts";
import { readForm, type TaskForm } from "./task-form.ts";
import { shownLanguageOf } from "../words.ts";
import { editedTask, formOfTask, textOfTask } from "./form-of-task.ts";
import {
  changedBlocks,
  outcomeOfRun,
  hasAnswerInRun,
  predictionOf,
  proposedQuestion,
  truthsOf,
} from "./made-questions.ts";
import type { QuestionDraft } from "./question-draft.ts";

const answer = (name: string) => answerOf(readFileSync(`src/examples/${name}.h`, "utf8"));
const flange = answer("flange"),
  shoulder = answer("shoulder");
const words: TaskForm["words"] = { title: "Flange, ⌀100!", ask: "Turn it.", hints: ["a", "b", "c"] };

const made = (of: typeof flange, change: Partial<TaskForm> = {}) => {
  const task = taskOfForm({ ...proposedTask(of), words, ...change }, of, "de", "7k");
  if ("length" in task) throw new Error(task.join());
  return task;
};

test.each([
  ["flange", flange],
  ["shoulder", shoulder],
])("a task made of the %s is passed by its own program", (_, of) => {
  const task = made(of);
  expect(judge(task, of).marks.filter(({ passed }) => !passed)).toEqual([]);
  expect(task.id).toBe("flange-100-7k");
});

test("proposed rules hold the numbers of the program", () => {
  const { rules } = made(flange);
  expect(rules.tools).toEqual([15, 1, 3, 5, 6, 8]);
  expect(rules.speed).toBe(3000);
  expect(rules.depth).toBeGreaterThan(1.1);
});

test("the outlines have the programmed sizes, from the contours or from the part as made", () => {
  const { outside, bore } = proposedTask(flange);
  for (const line of ["L X+62 Z-1.5", "L X+62 Z-38.5", "CR X+65 Z-40 R+1.5 DR-", "L X+80 Z-56.8"])
    expect(outside.split("\n")).toContain(line);
  expect(bore.split("\n")).toContain("L X+40 Z-31");
  expect(outlinesFrom(flange, "contours", [])).toEqual({ outside, bore });
  expect(outlinesFrom(flange, "made", []).outside.split("\n")).toContain("L X+62 Z-38.5");
  expect(outlinesFrom(shoulder, "made", []).outside.split("\n")).toContain("L X+50.087 Z-0.5");
});

test("missing fields are named", () => {
  expect(
    taskOfForm({ ...proposedTask(shoulder), outside: "L X+20 Z+0\nCR X+30 Z-40 R2 DR+" }, shoulder, "en", "1"),
  ).toEqual(["title", "ask", "part"]);
});

test("prompts start with the values of the call, except the emptied ones", () => {
  const { start } = made(shoulder, { start: "prompts", prompts: { operation: 0, emptied: ["Q463"] } });
  expect(start).toMatchObject({ cycle: shoulder.run.operations[0]?.cycle });
  const values = "values" in start ? start.values : {};
  expect(Object.keys(values)).toEqual(
    promptsOf(shoulder, 0)
      .map(([q]) => q)
      .filter((q) => q !== "Q463"),
  );
});

test("each fault changes one line, and the program with it is refused", () => {
  const lines = linesOfText(shoulder.text);
  for (const fault of possibleFaults(lines)) {
    const broken = withFaults(lines, [fault]);
    expect(broken).not.toEqual(lines);
    expect(lines.filter((line) => !broken.includes(line)).length).toBeLessThanOrEqual(1);
  }
  const task = made(shoulder, { kind: "fault", start: "program", faults: ["minus"] });
  const begun = learnerProgramOfForm({ ...proposedTask(shoulder), faults: ["minus"] }, shoulder);
  expect(task.start).toEqual({ program: begun });
  expect(judge(task, answerOf(begun.join("\n"))).passed).toBe(false);
});

const shaft = answer("shaft");

test("threads come from the program, drawn by their crest", () => {
  const { threads, outside } = proposedTask(shaft);
  expect(threads).toEqual([
    { from: 0, to: -21, crest: 60, root: 58.16, pitch: 1.5, name: "M60×1.5", on: true },
    {
      from: 0,
      to: -29.5,
      crest: 42.376,
      root: 44,
      pitch: 1.5,
      name: "M44×1.5",
      on: true,
    },
  ]);
  const task = made(shaft);
  expect(task.part?.threads).toHaveLength(threads.length);
  // The grooves are no corners of the outline.
  expect(outside.split("\n").length).toBeLessThan(60);
  expect(judge(task, shaft).marks.filter(({ passed }) => !passed)).toEqual([]);
  const shallow = answerOf(shaft.text.replaceAll(/Q473=\+?[\d.]+/g, "Q473=+0.3"));
  expect(
    judge(task, shallow)
      .marks.filter(({ passed }) => !passed)
      .map(({ about }) => about),
  ).toContain("M60×1.5");
});

test("the table offers what the instructor chooses", () => {
  expect(made(shoulder).rules.tools).toEqual([1]);
  expect(made(shoulder, { offer: "listed", tools: [3, 1, 7] }).rules.tools).toEqual([3, 1, 7]);
  expect("tools" in made(shoulder, { offer: "all" }).rules).toBe(false);
});

const fates = { fine: "a", rapid: "b", gouge: "c", residue: "d", error: "e" };
const asked = (ask: QuestionDraft["ask"], of: typeof flange, more: Partial<QuestionDraft> = {}): QuestionDraft => ({
  ...proposedQuestion(ask, of, { solution: shoulder.text, at: "-10", fates }),
  text: "How many?",
  ...more,
});

test("the right answer to a question comes from the run", () => {
  const { questions } = {
    questions: [
      asked("passes", shoulder),
      asked("diameter", shoulder, { at: "-7,3" }),
      asked("residuePlace", shoulder),
    ],
  };
  const task = made(shoulder, { kind: "predict", start: "program", questions });
  expect(task).not.toHaveProperty("solution");
  expect(task).not.toHaveProperty("part");
  expect(task.predict).toEqual([
    { ask: "passes" },
    { ask: "diameter", at: -7.3, within: 0.05 },
    { ask: "residuePlace", within: 3 },
  ]);
  const truths = truthsOf(questions, {}, shoulder);
  expect(truths[0]).toEqual({ kind: "number", value: shoulder.run.operations[0]?.plan.passes });
  expect(truths.map((truth) => truth && hasAnswerInRun(truth, shoulder))).toEqual([true, true, false]);
});

test("an incomplete question prevents the task", () => {
  const faults = (questions: readonly QuestionDraft[], start: TaskForm["start"] = "program") =>
    taskOfForm({ ...proposedTask(shoulder), words, kind: "predict", start, questions }, shoulder, "en", "1");
  expect(faults([])).toEqual(["noQuestion"]);
  expect(faults([asked("passes", shoulder)], "empty")).toEqual(["begins"]);
  expect(faults([asked("passes", shoulder, { text: " " })])).toEqual(["questions"]);
  for (const wrong of [
    asked("seconds", shoulder, { within: "" }),
    asked("face", shoulder, { at: "x" }),
    asked("choice", shoulder, {
      choices: "one\n",
    }),
    asked("choice", shoulder, { right: "7" }),
    asked("block", shoulder, { right: "" }),
    asked("passes", shoulder, { within: "-1" }),
  ])
    expect(predictionOf(wrong)).toBe(null);
});

test("the faulty block and the outcome of a run are proposed", () => {
  const begins = (faults: TaskForm["faults"]) =>
    answerOf(startProgramOfForm({ ...proposedTask(shoulder), start: "program", faults }, shoulder) ?? "");
  const text = (begun: typeof flange, blocks: readonly number[]) =>
    linesOfText(begun.text)
      .filter((line) => blocks.some((block) => line.startsWith(`${block} `)))
      .join();
  const minus = begins(["minus"]),
    start = begins(["start"]),
    turn = begins(["perRevolution"]);
  expect(text(minus, changedBlocks(minus.text, shoulder.text))).toContain("CYCL DEF");
  expect(asked("block", start).right).toBe(changedBlocks(start.text, shoulder.text).join(", "));
  expect(changedBlocks(turn.text, shoulder.text)).toHaveLength(2);
  expect(changedBlocks(shoulder.text, shoulder.text)).toEqual([]);
  expect([outcomeOfRun(shoulder), outcomeOfRun(minus)]).toEqual(["fine", "error"]);
  expect(asked("choice", minus).right).toBe("4");
});

test("a form is stored and read again; a damaged one is rejected", () => {
  const form = { ...proposedTask(shaft), questions: [asked("block", shoulder)] };
  expect(readForm(JSON.parse(JSON.stringify(form)))).toEqual(form);
  expect(readForm({ ...form, kind: "bake" })).toBe(null);
});

const shipped = (id: string): Task => JSON.parse(readFileSync(`src/course/tasks/${id}.json`, "utf8")) as Task;

test.each(["l16-drawn-rod", "l03-how-many-passes", "l01-sawn-long", "l22-clamp-shaft", "l04-foretell-speed"])(
  "%s comes out of the form as it went in, and with what was changed",
  (id) => {
    const task = shipped(id),
      text = textOfTask(task) ?? "",
      of = answerOf(text);
    expect(shownLanguageOf(task.words, "fr")).toBe("fr");
    const form = formOfTask(task, text, of, "fr");
    expect(editedTask(task, form, of, "fr")).toEqual(task);
    const renamed = editedTask(task, { ...form, words: { ...form.words, title: "Autre" } }, of, "fr");
    expect(renamed).toEqual({ ...task, words: { ...task.words, fr: { ...task.words.fr, title: "Autre" } } });
  },
);
