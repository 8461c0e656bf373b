import { expect, test } from "vitest";
import { TASK_FORMAT, taskSchema } from "../../../course/task.ts";
import { readResult, RESULT_FORMAT } from "../../../course/made/result.ts";
import { readTaught, readTaughtLink, resultLink, taskLink, taughtFile } from "./taught-files.ts";

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

test("a task and results survive a link and a file", () => {
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
    expect(readTaughtLink(link.slice(page.length))).toEqual(content);
  }
  expect(readTaught(taughtFile(task))).toEqual({ kind: "task", task, left: [] });
  expect(readTaught(taughtFile(result))).toEqual({ kind: "result", result });
});

test("altered, truncated, oversized and newer content is reported separately, and nothing throws", () => {
  const hash = taskLink("", task);
  expect(readTaughtLink(hash.slice(0, -9))).toEqual({ kind: "damaged" });
  expect(readTaughtLink(`${hash.slice(0, 40)}!${hash.slice(41)}`)).toEqual({ kind: "damaged" });
  expect(readTaughtLink(hash, 300)).toEqual({ kind: "tooLarge" });
  expect(readTaughtLink(hash.replace("#t1", "#t2"))).toEqual({ kind: "newer" });
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
  expect(readTaught(taughtFile(task).padEnd(4_000_001))).toEqual({ kind: "tooLarge" });
  if (result) expect(readTaught(taughtFile(result).replace('"hints": 1', '"hints": -1'))).toEqual({ kind: "damaged" });
  expect(readTaught(`\uFEFF${taughtFile(task)}`)).toMatchObject({ kind: "task" });
});

test("a received task with the id of a course task gets another id, the same each time", () => {
  const alike = { ...task, id: "l02-sharper-corner" },
    own = { ...task, id: "own-l02-sharper-corner" };
  for (const read of [readTaught(taughtFile(alike)), readTaughtLink(taskLink("", alike)), readTaught(taughtFile(own))])
    expect(read).toEqual({ kind: "task", task: own, left: [] });
});
