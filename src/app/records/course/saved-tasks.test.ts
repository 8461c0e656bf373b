import { expect, test } from "vitest";
import { TASK_FORMAT, taskSchema } from "../../../course/task.ts";
import { undo } from "../../document/steps.ts";
import { keepTask, mergedTasks, removeTask, taskRecord } from "./saved-tasks.ts";

const task = (id: string, title = "A") =>
  taskSchema.parse({
    format: TASK_FORMAT,
    id,
    kind: "make",
    start: { empty: true },
    words: { en: { title, ask: "B", hints: ["1", "2", "3"] } },
  });
const ids = () => taskRecord.now().map(({ id, words }) => `${id} ${words.en?.title}`);

test("tasks are saved once, newest first, a changed one replaces the old one; each is a step of undo", () => {
  keepTask(task("pin"));
  keepTask(task("disc"));
  keepTask(task("pin", "C"));
  keepTask(task("pin", "C"));
  expect(ids()).toEqual(["pin C", "disc A"]);
  undo("course");
  expect(ids()).toEqual(["disc A", "pin A"]);
  removeTask("disc");
  undo("course");
  taskRecord.put(mergedTasks(taskRecord.now(), [task("pin", "D"), task("bush")]));
  expect(ids()).toEqual(["disc A", "pin A", "bush A"]);
  expect(taskRecord.read(taskRecord.write(taskRecord.now()))).toEqual(taskRecord.now());
});

test("a damaged row costs itself only, and a damaged list is none", () => {
  const raw = { version: 1, tasks: [{ id: "x" }, task("pin"), task("pin", "again")] };
  expect(taskRecord.read(raw)).toEqual([task("pin")]);
  expect(taskRecord.unread(raw).map(({ name }) => name)).toEqual(["x", "pin"]);
  expect(taskRecord.read({ version: 1, tasks: 7 })).toBe(null);
  expect(taskRecord.read(undefined)).toBe(null);
});
