import { expect, test } from "vitest";
import { readTask } from "./read-task.ts";
import { TASK_FORMAT } from "./task.ts";

const words = (more = {}) => ({ en: { title: "A", ask: "B", hints: ["1", "2", "3"], ...more } });
const task = (more = {}): unknown => ({
  format: TASK_FORMAT,
  id: "pin-41",
  kind: "make",
  start: { empty: true },
  words: words(),
  ...more,
});
const faults = (more: object) => {
  const read = readTask(task(more));
  return "faults" in read ? read.faults.map(({ path, kind, wanted }) => `${path} ${kind} ${wanted}`.trim()) : [];
};
const blank = ["BLK FORM CYLINDER Z D41.3 L77.7 DIST+1.9"];

test.each([
  ["a field that is missing", { id: undefined }, ["id missing"]],
  ["a name that is none", { id: "Pin 41" }, ["id form"]],
  ["a text for a number", { rules: { depth: "2" } }, ["rules.depth type number"]],
  ["a number that no lathe has", { rules: { seconds: 1e9 } }, ["rules.seconds large 1000000"]],
  [
    "a size without its deviation",
    { sizes: [{ kind: "diameter", at: -7, nominal: 41.3, upper: 0 }] },
    ["sizes[0].lower missing"],
  ],
  ["a hint too many", { words: words({ hints: ["1", "2", "3", "4"] }) }, ["words.en.hints large 3"]],
  ["a material that is not in the list", { material: "wood" }, [expect.stringMatching(/^material oneOf s235, c45, /)]],
  ["nothing to begin with", { start: {} }, ["start oneOf cycle, program, empty"]],
  ["a cycle in quotation marks", { start: { cycle: "811" } }, ["start.cycle type number"]],
  ["a cycle that is not here", { start: { cycle: 4711 } }, ["start.cycle unknown"]],
  [
    "a prompt that the cycle does not have",
    { start: { cycle: 811, values: { Q507: "1" } } },
    ["start.values.Q507 unknown"],
  ],
  ["a prompt that is none", { start: { cycle: 811, values: { depth: "1" } } }, ["start.values.depth unknown"]],
  [
    "a question that is none",
    { predict: [{ ask: "colour" }] },
    [expect.stringMatching(/^predict\[0\]\.ask oneOf passes, infeed, .*block$/)],
  ],
  ["a question without its place", { predict: [{ ask: "diameter" }] }, ["predict[0].at missing"]],
  ["nothing that is predicted", { kind: "predict" }, ["predict missing"]],
  ["a question without words", { predict: [{ ask: "passes" }] }, ["words.en.questions count 1"]],
  [
    "a choice that is not offered",
    { predict: [{ ask: "choice", right: 2 }], words: words({ questions: ["Q"], choices: [["a", "b"]] }) },
    ["predict[0].right large 1"],
  ],
  ["no language", { words: {} }, ["words missing"]],
  ["an outline that is none", { part: { blank, outside: ["L X+0 Z+0", "CR X+20 Z-3 R1 DR+"] } }, ["part contour"]],
  ["no blank", { part: { blank: ["BLK FORM"], outside: ["L X+0 Z+0"] } }, ["part contour"]],
])("%s is told by its field", (_, more, told) => expect(faults(more)).toEqual(told));

test("unknown fields are left out and named", () => {
  const raw = { ...(task({ rules: { depht: 2, depth: 1.7 }, sizes: [] }) as object), ruels: {} };
  const read = readTask(raw);
  expect(read).toMatchObject({ left: ["rules.depht", "ruels"], task: { rules: { depth: 1.7 } } });
});

test("prototype keys are no fields", () => {
  const read = readTask(
    JSON.parse('{"__proto__":{"kind":"drawing"},"constructor":1,"start":{"cycle":811,"values":{"__proto__":"1"}}}'),
  );
  expect("faults" in read).toBe(true);
  expect(({} as { kind?: string }).kind).toBeUndefined();
});

test.each([null, 7, "x", [], [[]]])("%j is rejected as a task", (raw) => expect("faults" in readTask(raw)).toBe(true));
