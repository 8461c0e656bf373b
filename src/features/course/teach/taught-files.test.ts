import { expect, test } from "vitest";
import { TASK_FORMAT, taskSchema } from "../../../course/task.ts";
import { readResult, RESULT_FORMAT } from "../../../course/made/result.ts";
import { SET_FORMAT, setForLearners, setSchema, taskInSet } from "../../../course/task-set.ts";
import { packedForLink } from "../../../app/records/link.ts";
import { fetchTask } from "../../../app/records/course/content.ts";
import {
  courseTasksIn,
  readTaught,
  readTaughtLink,
  resultLink,
  setLink,
  taskLink,
  taughtFile,
} from "./taught-files.ts";

const task = taskSchema.parse({
  format: TASK_FORMAT,
  id: "stepped-pin-1x",
  kind: "make",
  start: { program: ["0 BEGIN PGM PIN MM", "1 BLK FORM CYLINDER Z D41.3 L77.7 DIST+1.9", "2 END PGM PIN MM"] },
  part: {
    blank: ["BLK FORM CYLINDER Z D41.3 L77.7 DIST+1.9"],
    outside: ["L X+0 Z+0", "L X+33.1", "L Z-17.7", "L X+41.3"],
  },
  rules: { tools: [3, 1] },
  words: { de: { title: "Bolzen ⌀33,1", ask: "Drehen Sie ihn.", hints: ["a", "b", "c"] } },
});
const result = readResult({
  format: RESULT_FORMAT,
  name: "",
  made: 1_795_000_000_123,
  tasks: [
    {
      id: "stepped-pin-1x",
      title: "Bolzen",
      tries: 3,
      hints: 1,
      solution: false,
      passed: { way: "hints", when: 1_794_999_999_000 },
      seconds: 61.7,
      score: null,
      worked: 487,
      steps: 12,
      program: "0 BEGIN PGM PIN MM\n1 END PGM PIN MM\n",
      verdict: { passed: false, refused: ["residue", "rapid"] },
    },
  ],
});

test("a task and results survive a link and a file", async () => {
  if (!result) throw new Error("no result");
  const page = "https://example.org/turnwise/";
  for (const [link, content] of [
    [taskLink(page, task), { kind: "task", task, left: [] }],
    [
      resultLink(page, result),
      {
        kind: "result",
        result,
      },
    ],
  ] as const) {
    expect(link.startsWith(`${page}#`)).toBe(true);
    expect(await readTaughtLink(link.slice(page.length))).toEqual(content);
  }
  // Links of the first form, which earlier editions made.
  expect(await readTaughtLink(`#t1=${packedForLink(task)}`)).toEqual({ kind: "task", task, left: [] });
  expect(readTaught(taughtFile(task))).toEqual({ kind: "task", task, left: [] });
  expect(readTaught(taughtFile(result))).toEqual({ kind: "result", result });
});

test("altered, truncated, oversized and newer content is reported separately, and nothing throws", async () => {
  const hash = taskLink("", task);
  expect(await readTaughtLink(hash.slice(0, -9))).toEqual({ kind: "damaged" });
  expect(await readTaughtLink(`${hash.slice(0, 40)}!${hash.slice(41)}`)).toEqual({ kind: "damaged" });
  expect(await readTaughtLink(hash, 300)).toEqual({ kind: "tooLarge" });
  expect(await readTaughtLink(hash.replace("#t2", "#t3"))).toEqual({ kind: "newer" });
  expect(readTaught(taughtFile(task).replace("turnwise-task/1", "turnwise-task/3"))).toEqual({ kind: "newer" });
  expect(readTaught(taughtFile(task).replace('"make"', '"bake"'))).toEqual({
    kind: "fields",
    faults: [{ path: "kind", kind: "oneOf", wanted: "make, fault, predict, drawing" }],
  });
  expect(readTaught(JSON.stringify({ ...task, words: {} }))).toEqual({
    kind: "fields",
    faults: [{ path: "words", kind: "missing", wanted: "" }],
  });
  expect(readTaught("0 BEGIN PGM A MM")).toMatchObject({ kind: "notJson" });
  expect(readTaught('{\n "format": "turnwise-task/1",\n "id" 7\n}')).toEqual({ kind: "notJson", line: 3 });
  expect(readTaught('{"tools":[]}')).toEqual({ kind: "foreign" });
  expect(readTaught('{"format":"turnwise-archive/9"}')).toEqual({ kind: "foreign" });
  expect(readTaught("null")).toEqual({ kind: "foreign" });
  expect(readTaught(`${"[".repeat(101)}${"]".repeat(101)}`)).toEqual({ kind: "foreign" });
  expect(readTaught(taughtFile(task).padEnd(4_000_001))).toEqual({ kind: "tooLarge" });
  if (result) expect(readTaught(taughtFile(result).replace('"hints": 1', '"hints": -1'))).toEqual({ kind: "damaged" });
  expect(readTaught(`\uFEFF${taughtFile(task)}`)).toMatchObject({ kind: "task" });
});

test("a received task with the id of a course task gets another id, the same each time", async () => {
  const alike = { ...task, id: "l02-sharper-corner" },
    own = { ...task, id: "own-l02-sharper-corner" };
  for (const read of [
    readTaught(taughtFile(alike)),
    await readTaughtLink(taskLink("", alike)),
    readTaught(taughtFile(own)),
  ])
    expect(read).toEqual({ kind: "task", task: own, left: [] });
});

test("a set of three course tasks in four languages fits a QR code, and comes back as learners get it", async () => {
  const inSet = async (id: string) => {
    const task = await fetchTask(id);
    if (!task) throw new Error(id);
    return taskInSet(task, "k7");
  };
  const course = await Promise.all(["l03-first-shoulder", "l05-chamfered-seat", "l09-cap-contour"].map(inSet));
  const set = setSchema.parse({
    format: SET_FORMAT,
    id: "week-12-k7",
    words: { en: { title: "Week 12" } },
    tasks: [...course, task],
    exam: { minutes: 60, reports: "goals" },
  });
  const ofCourse = await courseTasksIn(set);
  expect([...ofCourse.values()]).toEqual(["l03-first-shoulder", "l05-chamfered-seat", "l09-cap-contour"]);
  const given = setForLearners(set);
  const hash = setLink("", given, ofCourse);
  expect(hash.length).toBeLessThan(600);
  expect(await readTaughtLink(hash)).toEqual({ kind: "set", set: given, left: [] });
  // A task that this page does not have comes from a newer one; a changed one is in the link.
  expect(await readTaughtLink(setLink("", given, new Map([["stepped-pin-1x", "l99-none"]])))).toEqual({
    kind: "newer",
  });
  const changed = course.map((each) => ({ ...each, rules: { ...each.rules, depth: 1.23 } }));
  expect(await courseTasksIn({ ...set, tasks: changed })).toEqual(new Map());
});
