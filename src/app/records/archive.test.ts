import { newPart } from "../../planning/part/finished-part.ts";
import { beginExam } from "../../course/exam.ts";
import { SET_FORMAT, setSchema } from "../../course/task-set.ts";
import { answerOf } from "../../course/judge/answer.ts";
import { proposedTask } from "../../course/made/task-from-form.ts";
import { RESULT_FORMAT, type HandedResult } from "../../course/made/result.ts";
import { TASK_FORMAT, taskSchema } from "../../course/task.ts";
import fc from "fast-check";
import { strToU8, unzipSync, zipSync } from "fflate";
import { expect, test } from "vitest";
import { catalogue } from "../../cycles/index.ts";
import { NO_PROGRESS, withHint, withPass, withPlace } from "../../course/progress.ts";
import { exampleJob } from "../../program/job/job.ts";
import { readCuttingTable, usualTable, writeCuttingTable } from "../../program/tools/cutting-table.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import { firstSettings } from "../base/settings/settings.ts";
import type { Work } from "../document/work.ts";
import { ARCHIVE_LIMITS, readArchive, writeArchive, type ArchivedWork, type ReadArchive } from "./archive.ts";

const jobs: readonly Work[] = catalogue.map(exampleJob);
const name = fc.oneof(
  fc.string({ unit: "binary", maxLength: 30 }),
  fc.constantFrom(
    "A",
    "a",
    "a.h",
    "A.H",
    "..",
    "../../etc",
    "CON",
    "aux.h",
    "C:\\x",
    "__proto__",
    "",
    " . ",
    "x".repeat(300),
  ),
);
const text = fc.oneof(
  fc.string({ unit: "binary", maxLength: 200 }),
  fc.constantFrom("0 BEGIN PGM A MM\r\n1 L X+41.3 ; Ø\r\n", "\ud800", "\u0000"),
);
const encoding = fc.constantFrom("utf-8" as const, "windows-1252" as const);
const file = fc.record({ name, text, encoding });
const program: fc.Arbitrary<Work> = fc.record({
  name,
  text,
  encoding,
  files: fc.array(file, { maxLength: 3 }),
  skipMarked: fc.boolean(),
});
const job: fc.Arbitrary<Work> = fc
  .tuple(fc.constantFrom(...jobs), name, fc.string({ maxLength: 20 }))
  .map(([made, called, typed]) =>
    "drafts" in made
      ? { ...made, name: called, material: typed, drafts: { ...made.drafts, 9999: { Q1: typed } } }
      : made,
  );
const works: fc.Arbitrary<readonly ArchivedWork[]> = fc.array(
  fc.record({
    work: fc.uuid(),
    savedAt: fc.oneof(fc.integer({ min: -(2 ** 35), max: 2 ** 35 }), fc.constant(1_795_395_781)).map((s) => s * 1000),
    job: fc.oneof(job, program),
  }),
  { maxLength: 5 },
);
const own = [
  {
    id: "c1",
    number: "x",
    name: "SAW",
    parameters: [
      { id: "p1", q: "", prompt: "DEPTH?", kind: "length" as const, min: "", max: "3.", first: "", choices: "" },
    ],
  },
];
const tools = shippedList.map((row, i) => (i === 1 ? { ...row, cells: { ...row.cells, RS: "0,41x" } } : row));
const ofShop = {
  power: 7.3,
  materials: usualTable.materials.map((each, i) => (i === 1 ? { ...each, roughSpeed: 143.7 } : each)),
};
const settings = {
  ...firstSettings(),
  language: "fr" as const,
  xDown: true,
  material: "c45",
  cutting: writeCuttingTable(ofShop),
};
const course = withPlace(
  withPass(withHint(NO_PROGRESS, "l03-thicker-bar", 2), "l03-thicker-bar", { when: 1_795_395_781_123, seconds: 41.7 }),
  {
    lesson: "first-shoulder",
    number: 3,
    page: "tasks",
  },
);
const taught = taskSchema.parse({
  format: TASK_FORMAT,
  id: "stepped-pin-1x",
  kind: "make",
  start: { empty: true },
  words: { fr: { title: "Axe", ask: "Tournez-le.", hints: ["a", "b", "c"] } },
});
const sample = { ...proposedTask(answerOf("0 BEGIN PGM A MM\n1 END PGM A MM\n")), material: "c45" };
const forms = {
  "work a": {
    form: { ...sample, words: { title: "Bolzen", ask: "", hints: ["", "zweiter", ""] as const } },
    print: "7 x",
    at: 1_795_395_781_123,
  },
};
const worked = { "stepped-pin-1x": { ms: 487_321, steps: 13 } };
const result: HandedResult = { format: RESULT_FORMAT, name: "Ada 7", made: 1_795_395_781_123, tasks: [] };
const results = [{ file: "Ada-7.turnwise-result.json", result }];
const set = setSchema.parse({
  format: SET_FORMAT,
  id: "set-4c1b9e",
  words: { de: { title: "Reihe" } },
  tasks: [taught],
  due: 1_795_995_781_123,
  exam: { minutes: 45, reports: "goals" },
});
const exams = {
  [set.id]: {
    ...beginExam(set, "Ada 7", "MT 2", 1_795_395_781_123),
    checks: { [taught.id]: { count: 2, passed: false, met: 1, of: 4 } },
    ended: { by: "time" as const, result: { ...result, name: "Ada" } },
  },
};
const column = { cell: "RS", inch: true, diameter: false } as const;
const words = { TYPE: { Schruppen: "ROUGH" }, TO: {} };
const columns = [{ signature: '["nr","radius"]', day: "2026-11-21", columns: [null, column], words }];
const parts = [{ id: "part-1", part: newPart("PIN"), withoutTools: [3], withoutCycles: [] }];
const whole = {
  tools,
  own,
  settings,
  course,
  taught: [taught],
  sets: [set],
  exams,
  forms,
  worked,
  results,
  columns,
  parts,
};
const nothing = {
  tools: null,
  own: null,
  settings: null,
  course: null,
  taught: null,
  sets: null,
  exams: null,
  forms: null,
  worked: null,
  results: null,
  columns: null,
  parts: null,
};
const read = (bytes: Uint8Array): ReadArchive => {
  const found = readArchive(bytes);
  if ("problem" in found) throw new Error(found.problem);
  return found;
};

const packed = (manifest: unknown) => zipSync({ "turnwise.json": strToU8(JSON.stringify(manifest)) });
const manifestOf = (bytes: Uint8Array) =>
  JSON.parse(new TextDecoder().decode(unzipSync(bytes)["turnwise.json"])) as {
    works: { content: { job: { name: string } } }[];
  };

test("everything packed is read back, including invalid text and drafts of other cycles", () => {
  fc.assert(
    fc.property(works, fc.boolean(), (all, isWhole) => {
      const rest = isWhole ? whole : nothing;
      const found = read(writeArchive({ works: all, ...rest }));
      expect(found).toEqual({ works: all, ...rest, unread: [], unreadParts: [], unreadRows: [] });
    }),
    { numRuns: 60 },
  );
});

test("a file of an earlier edition is read as before; a damaged part is named and stops no other", () => {
  const manifest = manifestOf(writeArchive({ works: [], ...whole })) as unknown as Record<string, unknown>;
  const { forms: _, worked: __, results: ___, columns: ____, ...before } = manifest;
  expect(read(packed(before))).toMatchObject({
    taught: [taught],
    course,
    forms: null,
    worked: null,
    results: null,
    columns: null,
    unreadParts: [],
  });
  const form = { ...forms["work a"].form, material: undefined };
  const older = { ...before, forms: { content: { version: 1, forms: { "work a": { ...forms["work a"], form } } } } };
  expect(read(packed(older)).forms?.["work a"]?.form.material).toBeNull();
  const broken = {
    ...manifest,
    forms: { content: { version: 1, forms: { x: { form: {}, print: "", at: 3 } } } },
    results: { print: "0", content: {} },
  };
  expect(read(packed(broken))).toMatchObject({
    worked,
    forms: {},
    results: null,
    unreadParts: ["results"],
    unreadRows: ["x"],
  });
  const far = { file: "far.json", result: { ...result, made: 1e20 } };
  const rows = { ...manifest, results: { content: { version: 1, files: [far, ...results] } } };
  expect(read(packed(rows))).toMatchObject({ results, unreadParts: [], unreadRows: ["far.json"] });
  const undated = { work: "w", content: { version: 3, savedAt: 1e20, job: jobs[0] } };
  expect(read(packed({ ...manifest, works: [undated] })).works).toMatchObject([{ savedAt: 0 }]);
});

test("every path stays inside its folder, and no two are equal on any system", () => {
  fc.assert(
    fc.property(works, (all) => {
      const paths = Object.keys(unzipSync(writeArchive({ works: all, tools, own, settings })));
      expect(new Set(paths.map((path) => path.toUpperCase())).size).toBe(paths.length);
      for (const path of paths) {
        expect(path).toMatch(/^(?:turnwise\.json|settings\.json|tools\/[A-Z]+\.json|programs\/[^/\\:]+\/[^/\\:]+)$/);
        expect(path).not.toMatch(/\/\.|(?:^|\/)(?:CON|AUX)(?:\.|\/|$)/i);
      }
    }),
    { numRuns: 50 },
  );
});

test("the programs have the bytes that the control reads", () => {
  const [first] = jobs;
  const german = {
    name: "WELLE.H",
    text: "0 BEGIN PGM WELLE MM\r\n1 ; ⌀ Maß 41,3\r\n".replace("⌀", "Ø"),
    encoding: "windows-1252" as const,
  };
  const files = unzipSync(
    writeArchive({
      works: [
        { work: "a", savedAt: 3, job: { ...german, files: [{ ...german, name: "sub.h" }] } },
        { work: "b", savedAt: 4, job: first! },
        {
          work: "c",
          savedAt: 5,
          job: german,
        },
      ],
      tools,
    }),
  );
  expect(Object.keys(files).slice(1, 3)).toEqual(["programs/WELLE/WELLE.H", "programs/WELLE/sub.h"]);
  expect(files["programs/WELLE/WELLE.H"]?.includes(0xdf)).toBe(true);
  expect(files["programs/WELLE (2)/WELLE.H"]?.at(-2)).toBe(13);
  expect(Object.keys(files).some((path) => path.startsWith(`programs/${first!.name}/`))).toBe(true);
  expect(JSON.parse(new TextDecoder().decode(files["tools/TOOLS.json"]))).toMatchObject({ tools: expect.any(Array) });
});

test("the shop's cutting data are in it, among the settings and as the file that a device takes; shipped ones are not", () => {
  const bytes = writeArchive({ settings });
  const file = unzipSync(bytes)["tools/CUTTING.json"];
  expect(readCuttingTable(new TextDecoder().decode(file))).toEqual(ofShop);
  expect(readCuttingTable(read(bytes).settings?.cutting ?? "")).toEqual(ofShop);
  expect(Object.keys(unzipSync(writeArchive({ settings: { ...settings, cutting: "" } })))).toEqual([
    "turnwise.json",
    "settings.json",
  ]);
});

test("an altered or unreadable work is named, and the others are read", () => {
  const three = ["A", "B", "C"].map((named, i) => ({ work: named, savedAt: i, job: { ...jobs[0]!, name: named } }));
  const manifest = manifestOf(writeArchive({ works: three, tools }));
  manifest.works[1]!.content.job.name = "OTHER";
  Object.assign(manifest.works[2]!, { print: undefined, content: { version: 4711 } });
  Object.assign(manifest, { tools: { print: "0", content: { version: 2, rows: [] } } });
  expect(read(packed(manifest))).toMatchObject({
    works: [{ work: "A" }],
    unread: ["B", "C"],
    tools: null,
    unreadParts: ["tools"],
  });
});

test("a file that is no archive, damaged, too large or newer gives its reason", () => {
  const good = writeArchive({ works: [{ work: "a", savedAt: 3, job: jobs[0]! }] });
  const problem = (bytes: Uint8Array, limits = {}) => readArchive(bytes, { ...ARCHIVE_LIMITS, ...limits });
  expect(problem(strToU8("0 BEGIN PGM A MM"))).toEqual({ problem: "notAnArchive" });
  expect(problem(zipSync({ "a.h": strToU8("L X+1") }))).toEqual({ problem: "notAnArchive" });
  expect(problem(packed({ format: "other/1" }))).toEqual({ problem: "notAnArchive" });
  expect(problem(packed({ format: "turnwise-archive/2" }))).toEqual({ problem: "newer" });
  expect(problem(good.subarray(0, good.length - 40))).toEqual({ problem: "damaged" });
  expect(problem(zipSync({ "turnwise.json": strToU8("{") }))).toEqual({ problem: "damaged" });
  // Small when packed; unpacked, more than a tab holds or deeper than anything is read.
  const trap = (text: string) => zipSync({ "turnwise.json": strToU8(text) });
  expect(problem(trap("[".repeat(30_000_000)))).toEqual({ problem: "tooLarge" });
  expect(problem(trap(`{"format":"turnwise-archive/1","works":${"[".repeat(101)}${"]".repeat(101)}}`))).toEqual({
    problem: "tooLarge",
  });
  for (const limits of [{ packed: 100 }, { unpacked: 100 }, { entries: 1 }])
    expect(problem(good, limits)).toEqual({ problem: "tooLarge" });
  // Works beyond the largest count are named, and cost no other.
  const two = writeArchive({ works: [0, 1].map((i) => ({ work: `${i}`, savedAt: 3, job: jobs[i]! })) });
  expect(problem(two, { works: 1 })).toMatchObject({ works: [{ job: jobs[0] }], unread: [jobs[1]!.name] });
});

test("no bytes make reading throw, and an altered file never gives other content", () => {
  const all = [{ work: "a", savedAt: 3, job: jobs[0]! }];
  const good = writeArchive({ works: all });
  fc.assert(
    fc.property(fc.nat(good.length - 1), fc.integer({ min: 1, max: 255 }), (at, by) => {
      const bytes = Uint8Array.from(good, (byte, i) => (i === at ? byte ^ by : byte));
      const found = readArchive(bytes);
      if ("problem" in found) return;
      for (const { job: kept } of found.works) expect(kept).toEqual(all[0]?.job);
    }),
    { numRuns: 400 },
  );
  fc.assert(fc.property(fc.uint8Array(), (bytes) => "problem" in readArchive(Uint8Array.from([0x50, 0x4b, ...bytes]))));
});
