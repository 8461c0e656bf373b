import { expect, test } from "vitest";
import fc from "fast-check";
import { cuttingCycles } from "../../cycles/index.ts";
import type { Measurement } from "../../kernel/plan/measured.ts";
import { at } from "../../kernel/geometry/point.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { exampleJob, type SetJob } from "../../program/job/job.ts";
import { printAsInManual, printJob } from "../../program/job/print-job.ts";
import { LEGACY_OUTPUT } from "../../program/machine/nc-output.ts";
import { readSave, SAVE_VERSION, upgrade, type SaveFile } from "./save-file.ts";

const saved = (): SaveFile[] =>
  cuttingCycles.map((cycle) => ({ version: SAVE_VERSION, savedAt: 1_700_000_000_000, job: exampleJob(cycle) }));

test("saving and reading gives the same work", () => {
  for (const file of saved()) expect(readSave(JSON.parse(JSON.stringify(file)))).toEqual(file);
});

test("measurements are saved with the work, with places, moment and label position; a broken one is damage", () => {
  const edge = {
    of: "contour",
    chain: 0,
    element: 2,
    shape: "1/5/77",
    segment: { kind: "arc", from: at(-13.27, 8.5), to: at(-14.87, 10.1), centre: at(-13.27, 10.1), turn: "cw" },
  } as const;
  const measured: Measurement[] = [
    {
      id: "1",
      kind: "radius",
      plane: "ZX",
      places: [{ at: at(-14.4, 8.97), spot: "edge", edge }],
      text: at(-9.1, 14),
    },
    {
      id: "2",
      kind: "length",
      plane: "XY",
      places: [
        { at: at(1.5, -3), spot: "free" },
        { at: at(9, -3), spot: "path" },
      ],
      moment: { step: 12, fraction: 0.25, block: 31, pass: 2, print: "1x7" },
    },
  ];
  const works = [
    { ...saved()[0]?.job, measured },
    { name: "MAIN.H", text: "END PGM A MM", encoding: "utf-8", measured },
  ];
  for (const job of works)
    expect(readSave(JSON.parse(JSON.stringify({ version: SAVE_VERSION, savedAt: 1, job })))?.job).toEqual(job);
  const broken = { ...works[1], measured: [{ ...measured[0], places: [] }] };
  expect(readSave({ version: SAVE_VERSION, savedAt: 1, job: broken })).toBeNull();
});

test("a work of a task is saved with its task, the predictions and the file it came from", () => {
  const task = {
    id: "predict-7",
    veiled: true,
    told: ["4", "⌀41.7 Z-13"],
    file: { format: "turnwise-task/1", words: { en: {} } },
  };
  const works = [
    { ...saved()[0]?.job, task },
    { name: "MAIN.H", text: "END PGM A MM", encoding: "utf-8", task: { id: "x" } },
  ];
  for (const job of works)
    expect(readSave(JSON.parse(JSON.stringify({ version: SAVE_VERSION, savedAt: 1, job })))?.job).toEqual(job);
  expect(readSave({ version: SAVE_VERSION, savedAt: 1, job: { ...works[1], task: { id: 7 } } })).toBeNull();
});

test("the machine of a shared work is saved with it, and so is having none", () => {
  const program = { name: "MAIN.H", text: "END PGM A MM", encoding: "utf-8" };
  for (const machine of ["", "{}", "x".repeat(10_000)]) {
    for (const job of [
      { ...saved()[0]?.job, machine },
      { ...program, machine },
    ])
      expect(readSave(JSON.parse(JSON.stringify({ version: SAVE_VERSION, savedAt: 1, job })))?.job).toEqual(job);
  }
  expect(readSave({ version: SAVE_VERSION, savedAt: 1, job: { ...program, machine: "x".repeat(10_001) } })).toBeNull();
});

test("the material of a work is saved with it, also one that this device does not know", () => {
  const works = [
    { ...saved()[0]?.job, material: "42crmo4" },
    {
      name: "MAIN.H",
      text: "END PGM A MM",
      encoding: "utf-8",
      material: "own17",
    },
  ];
  for (const job of works) {
    expect(readSave(JSON.parse(JSON.stringify({ version: SAVE_VERSION, savedAt: 1, job })))?.job).toEqual(job);
    expect(readSave({ version: SAVE_VERSION, savedAt: 1, job: { ...job, material: 17 } })).toBeNull();
  }
});

test("the clamping of a work is saved with it, even half typed; a save without it is as before", () => {
  const words = { D: "60", LENGTH: "", FACE: "-7", TIP: "abc" };
  for (const clamping of [
    { kind: "softJaws", words },
    { kind: "centres", words: {} },
  ]) {
    const job = { ...saved()[0]?.job, clamping };
    expect(readSave(JSON.parse(JSON.stringify({ version: SAVE_VERSION, savedAt: 1, job })))?.job).toEqual(job);
  }
  expect(readSave(saved()[0])?.job).not.toHaveProperty("clamping");
  expect(
    readSave({ version: SAVE_VERSION, savedAt: 1, job: { ...saved()[0]?.job, clamping: { kind: "vice", words } } }),
  ).toBeNull();
});

test("what was proposed for set fields is saved with them; a save without it is as before", () => {
  const job = { ...saved()[0]?.job, proposals: { tool: "1", "blank.outside": "60" } };
  expect(readSave(JSON.parse(JSON.stringify({ version: SAVE_VERSION, savedAt: 1, job })))?.job).toEqual(job);
  expect(readSave(saved()[0])?.job).not.toHaveProperty("proposals");
});

test("the further files of a program and its skip switch are saved with it; a save without them is as before", () => {
  const program = { name: "MAIN.H", text: "CALL PGM A", encoding: "utf-8" as const };
  const file = { name: "a.h", text: "L X+1 ;\u00d8", encoding: "windows-1252" as const };
  for (const job of [program, { ...program, files: [file], skipMarked: true }, { ...program, remarks: "⌀62 h6\n" }])
    expect(readSave(JSON.parse(JSON.stringify({ version: SAVE_VERSION, savedAt: 1, job })))?.job).toEqual(job);
  expect(readSave({ version: SAVE_VERSION, savedAt: 1, job: { ...program, files: [{ name: "a.h" }] } })).toBeNull();
});

test.each<[string, unknown]>([
  ["nothing", undefined],
  ["text", "{"],
  ["a list", []],
  ["another thing", { broken: true }],
  ["a newer edition", { ...saved()[0], version: SAVE_VERSION + 1 }],
  ["a job without a blank", { ...saved()[0], job: { ...saved()[0]?.job, blank: undefined } }],
  [
    "a number where text was",
    {
      ...saved()[0],
      job: { ...saved()[0]?.job, rapid: 10000 },
    },
  ],
])("%s is damage, and does not throw", (_, raw) => expect(readSave(raw)).toBeNull());

test("no input makes reading throw", () =>
  fc.assert(
    fc.property(fc.anything({ withBigInt: true, withDate: true, withMap: true }), (raw) => readSave(raw) === null),
  ));

test("an old save passes every step up to the present version", () => {
  const steps = {
    1: (old: Readonly<Record<string, unknown>>) => ({ ...old, version: 2, seen: [1] }),
    2: (old: Readonly<Record<string, unknown>>) => ({ ...old, version: 3, seen: [...(old["seen"] as number[]), 2] }),
  };
  expect(upgrade({ version: 1 }, steps, 3)).toEqual({ version: 3, seen: [1, 2] });
  expect(upgrade({ version: 2, seen: [] }, steps, 3)).toEqual({ version: 3, seen: [2] });
  expect(upgrade({ version: 4 }, steps, 3)).toEqual({ version: 4 });
});

test("a work saved before machines had settings shows the same program", () => {
  const files = import.meta.glob<unknown>("../../../tests/saved/v2/*.json", { eager: true, import: "default" });
  const programs = import.meta.glob<string>("../../../tests/saved/v2/*.h", {
    eager: true,
    query: "?raw",
    import: "default",
  });
  expect(Object.keys(files)).toHaveLength(3);
  for (const [path, raw] of Object.entries(files)) {
    const job = readSave(raw)?.job as SetJob;
    const labels = ncLabels(job.ncLanguage);
    const shown = job.layout === "manual" ? printAsInManual(job, labels) : printJob(job, labels);
    expect(shown, path).toBe(programs[path.replace(/json$/, "h")]);
  }
});

test("a real file of each version still opens", () => {
  const files = import.meta.glob<unknown>("../../../tests/saved/v*/*.json", { eager: true, import: "default" });
  expect(Object.keys(files).length).toBeGreaterThan(0);
  for (const [path, raw] of Object.entries(files)) expect(readSave(raw)?.version, path).toBe(SAVE_VERSION);
});

test("a work of the first version: a field without stock is none, its layout and its program end stay", () => {
  const [newest] = saved();
  const typed = (blank: object, layout: string) => {
    const old = { version: 1, savedAt: 7, job: { ...newest?.job, blank, layout, output: undefined } };
    const { version, savedAt, job } = (readSave(JSON.parse(JSON.stringify(old))) ?? {}) as {
      version?: number;
      savedAt?: number;
      job?: SetJob;
    };
    return [version, savedAt, job?.blank, job?.layout, job?.output];
  };
  const blank = (bore: string, allowance: string) => ({ outside: "60", bore, length: "90", allowance });
  expect(typed(blank("", ""), "tnc640")).toEqual([SAVE_VERSION, 7, blank("0", "0"), "manual", LEGACY_OUTPUT]);
  expect(typed(blank("12.5", "1"), "tnc7")).toEqual([SAVE_VERSION, 7, blank("12.5", "1"), "tnc7", LEGACY_OUTPUT]);
});
