import { expect, test } from "vitest";
import { readSet } from "./read-task.ts";
import { NO_PROGRESS, withPass } from "./progress.ts";
import {
  isForLearners,
  nextOpenTask,
  SET_FORMAT,
  setForLearners,
  setSchema,
  taskInSet,
  type TaskSet,
} from "./task-set.ts";
import { TASK_FORMAT, taskSchema } from "./task.ts";

const program = ["0 BEGIN PGM A MM", "1 M30", "2 END PGM A MM"];
const task = taskSchema.parse({
  format: TASK_FORMAT,
  id: "pin-41",
  kind: "fault",
  start: { program },
  predict: [{ ask: "choice", right: 1 }, { ask: "block", right: [7] }, { ask: "passes" }],
  words: {
    en: { title: "A", ask: "B", hints: ["SECRET 1"], questions: ["C", "D", "E"], choices: [["x", "y"], [], []] },
    de: { title: "A", ask: "B", questions: ["C", "D", "E"], choices: [["x", "y"], [], []], learned: "SECRET 2" },
  },
  rules: { depth: 2 },
  solution: ["SECRET 3"],
  wrong: [{ program: ["SECRET 4"], rule: "depth" }],
});
const set = (more: Partial<TaskSet> = {}): TaskSet =>
  setSchema.parse({ format: SET_FORMAT, id: "set-a1", words: { en: { title: "S" } }, tasks: [task], ...more });
const given = (more: Partial<TaskSet>) => JSON.stringify(setForLearners(set(more)));

test.each([
  ["all help", { help: "all" }, [1, 2, 3, 4], true],
  ["hints alone", { help: "hints" }, [1, 2], true],
  ["no help", { help: "none" }, [2], true],
  ["an exam, whatever its help", { help: "all", exam: { reports: "goals" } }, [], false],
] as const)("with %s learners read no more than that", (_, more, secrets, right) => {
  const text = given(more);
  for (const n of [1, 2, 3, 4]) expect([n, text.includes(`SECRET ${n}`)]).toEqual([n, secrets.includes(n as never)]);
  expect(/"right":/.test(text)).toBe(right);
  expect(text).toContain('"depth":2');
});

test("what learners get is a set that can be read, and is told apart from the instructor's", () => {
  const exam = set({ exam: { reports: "nothing", minutes: 45 } });
  const read = readSet(JSON.parse(JSON.stringify(setForLearners(exam))));
  expect(read).toMatchObject({ left: [], set: { exam: { minutes: 45 }, tasks: [{ id: "pin-41" }] } });
  expect([isForLearners(exam), "set" in read && isForLearners(read.set)]).toEqual([false, true]);
});

test.each([
  ["no task", { tasks: [] }, ["tasks small"]],
  ["two tasks of one id", { tasks: [task, task] }, ["tasks[1].id form"]],
  ["no language", { words: {} }, ["words missing"]],
  ["a task with a fault", { tasks: [{ ...task, predict: [] }] }, ["tasks[0].words.en.questions count"]],
  ["an exam that says something else", { exam: { reports: "marks" } }, ["exam.reports oneOf"]],
])("a set with %s is refused by its field", (_, more, told) => {
  const read = readSet({ ...set(), ...more });
  const found = "faults" in read ? read.faults.map(({ path, kind }) => `${path} ${kind}`) : [];
  expect(found).toEqual(expect.arrayContaining(told));
});

test("the id of a task in a set is its own, and stays when it is added again", () => {
  const once = taskInSet({ ...task, id: "a".repeat(60) }, "4c1b9e");
  expect(once.id).toMatch(/^a{48}-4c1b9e$/);
  expect(taskInSet(once, "4c1b9e")).toEqual(once);
});

test.each([
  ["the next in order", [], "a", "b"],
  ["a passed one is left out", ["b"], "a", "c"],
  ["from the last on to the first", ["c"], "c", "a"],
  ["none but the task itself", ["a", "b"], "c", undefined],
  ["none when all are passed", ["a", "b", "c"], "b", undefined],
] as const)("the next open task of a set: %s", (_, passed, after, next) => {
  const three = { ...set(), tasks: ["a", "b", "c"].map((id) => ({ ...task, id })) };
  const progress = passed.reduce((now, id) => withPass(now, id, { when: 1 }), NO_PROGRESS);
  expect(nextOpenTask(three, progress, after)?.id).toBe(next);
});
