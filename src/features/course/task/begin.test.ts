import { expect, test } from "vitest";
import { TASK_FORMAT, taskSchema } from "../../../course/task.ts";
import { isProgram } from "../../../app/document/work.ts";
import { plainWork } from "../../../app/records/save-file.ts";
import { workOfTask } from "./begin.ts";

const task = taskSchema.parse({
  format: TASK_FORMAT,
  id: "how-many",
  kind: "predict",
  start: { program: ["0 BEGIN PGM A MM", "1 END PGM A MM"] },
  rules: { tools: [3] },
  predict: [{ ask: "passes" }],
  words: { en: { title: "A", ask: "B", hints: ["1", "2", "3"], questions: ["How many?"] } },
});

test("a task with predictions starts with the run hidden, with the allowed tools and without its own file", () => {
  const work = workOfTask(task);
  expect(work.task).toEqual({ id: "how-many", veiled: true });
  expect(work.tools?.map(({ cells }) => cells.T)).toEqual(["3"]);
  expect(isProgram(work) && work.text).toBe("0 BEGIN PGM A MM\n1 END PGM A MM\n");
});

test("a received task includes its file, through saving and sharing", () => {
  const work = plainWork(JSON.parse(JSON.stringify(workOfTask(task, true))));
  expect(taskSchema.parse(work?.task?.file)).toEqual(task);
});
