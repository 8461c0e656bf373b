import { expect, test } from "vitest";
import { TASK_FORMAT, taskSchema } from "../../../course/task.ts";
import { undo } from "../../document/steps.ts";
import { readTaughtList, writeTaught } from "./taught-list.ts";
import { bringTasks, keepTask, removeTask, useTaught } from "./taught.ts";

const task = (id: string, title = "A") =>
  taskSchema.parse({
    format: TASK_FORMAT,
    id,
    kind: "make",
    start: { empty: true },
    words: { en: { title, ask: "B", hints: ["1", "2", "3"] } },
  });
const ids = () => useTaught.getState().list.map(({ id, words }) => `${id} ${words.en?.title}`);

test("tasks are kept once, the newest first, a changed one in place of the old one; each is a step of undo", () => {
  keepTask(task("pin"));
  keepTask(task("disc"));
  keepTask(task("pin", "C"));
  keepTask(task("pin", "C"));
  expect(ids()).toEqual(["pin C", "disc A"]);
  undo();
  expect(ids()).toEqual(["disc A", "pin A"]);
  removeTask("disc");
  undo();
  bringTasks([task("pin", "D"), task("bush")]);
  expect(ids()).toEqual(["disc A", "pin A", "bush A"]);
  expect(readTaughtList(writeTaught(useTaught.getState().list) ?? "")).toEqual(useTaught.getState().list);
});

test("a damaged list is none", () => {
  expect(readTaughtList('{"version":1,"tasks":[{"id":"x"}]}')).toBe(null);
  expect(readTaughtList("{")).toBe(null);
});
