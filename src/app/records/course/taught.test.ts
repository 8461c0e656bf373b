import { expect, test } from "vitest";
import { TASK_FORMAT, taskSchema } from "../../../course/task.ts";
import { undo } from "../../document/steps.ts";
import { keepTask, mergedTasks, removeTask, taughtRecord } from "./taught.ts";

const task = (id: string, title = "A") =>
  taskSchema.parse({
    format: TASK_FORMAT,
    id,
    kind: "make",
    start: { empty: true },
    words: { en: { title, ask: "B", hints: ["1", "2", "3"] } },
  });
const ids = () => taughtRecord.now().map(({ id, words }) => `${id} ${words.en?.title}`);

test("tasks are saved once, newest first, a changed one replaces the old one; each is a step of undo", () => {
  keepTask(task("pin"));
  keepTask(task("disc"));
  keepTask(task("pin", "C"));
  keepTask(task("pin", "C"));
  expect(ids()).toEqual(["pin C", "disc A"]);
  undo();
  expect(ids()).toEqual(["disc A", "pin A"]);
  removeTask("disc");
  undo();
  taughtRecord.put(mergedTasks(taughtRecord.now(), [task("pin", "D"), task("bush")]));
  expect(ids()).toEqual(["disc A", "pin A", "bush A"]);
  expect(taughtRecord.read(taughtRecord.write(taughtRecord.now()))).toEqual(taughtRecord.now());
});

test("a damaged list is empty", () => {
  expect(taughtRecord.read({ version: 1, tasks: [{ id: "x" }] })).toBe(null);
  expect(taughtRecord.read(undefined)).toBe(null);
});
