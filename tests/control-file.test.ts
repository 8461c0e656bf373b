import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { refusals } from "../src/control-file/refusals.ts";
import { cuttingCycles } from "../src/cycles/index.ts";
import { examples } from "../src/examples/index.ts";
import { NC_LANGUAGES } from "../src/nc/nc-languages.ts";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { isoProgramText } from "../src/nc/iso/print-iso.ts";
import { parse } from "../src/nc/parse.ts";
import { programText } from "../src/nc/print.ts";
import { issuesOf } from "../src/nc/program.ts";
import type { Statement } from "../src/nc/statement.ts";
import { LAYOUTS, type Style } from "../src/nc/style.ts";
import { emptyProgram } from "../src/program/job/empty-program.ts";
import { exampleJob, type SetJob } from "../src/program/job/job.ts";
import { JOB_LAYOUTS, NC_OUTPUTS } from "../src/program/machine/nc-output.ts";
import { printAsInManual, printJob } from "../src/program/job/print-job.ts";
import { asControlStores, typedJobs } from "./control-file-texts.ts";
import { statements } from "./laws/statements.ts";
import { projectFile, projectFolder } from "./sources.ts";

/** The refusals of both controls, with line numbers: none in a text that the printer may output. */
const refused = (text: string) =>
  (["tnc640", "tnc7"] as const).flatMap((control) =>
    refusals(text, control).map(
      (r) => `${r.code} ${JSON.stringify(r.data)} in line ${r.line}: ${text.split(/\r\n|\n|\r/)[r.line - 1]}`,
    ),
  );
/** The refusals of a program converted to DIN/ISO. */
function refusedAsIso(klartext: string): readonly string[] {
  const { text } = isoProgramText(parse(klartext));
  const lines = text.split(/\r\n|\n|\r/);
  return refusals(text, "iso").map(
    (r) => `${r.code} ${JSON.stringify(r.data)} in line ${r.line}: ${lines[r.line - 1]}`,
  );
}
/** File layouts, without the manual's layout. */
const FILES: readonly Style[] = [
  ...(["tnc640", "tnc7"] as const).map((name) => LAYOUTS[name]),
  {
    ...LAYOUTS.tnc7,
    plus: false,
    decimal: ",",
    indent: "    ",
    rapid: "F MAX",
    spacedWords: true,
    newLine: "\r\n",
  },
];
describe("a control loads what the printer prints", () => {
  test.each(cuttingCycles.map((c) => [c.number, c] as const))(
    "the example of cycle %i in each language, layout and setting",
    (_, cycle) => {
      for (const ncLanguage of NC_LANGUAGES) {
        for (const layout of JOB_LAYOUTS) {
          for (const output of Object.values(NC_OUTPUTS)) {
            const job: SetJob = { ...exampleJob(cycle), ncLanguage, layout, output };
            const text = printJob(job, ncLabels(ncLanguage));
            expect([...refused(text), ...refusedAsIso(text)]).toEqual([]);
          }
        }
      }
    },
  );

  test("whatever is typed, when the program has no error of its own", () => {
    let read = 0;
    fc.assert(
      fc.property(typedJobs, (job) => {
        const text = printJob(job, ncLabels(job.ncLanguage));
        if (issuesOf(parse(text)).some((i) => i.severity === "error")) return;
        read += 1;
        expect(refused(text)).toEqual([]);
      }),
      { numRuns: 400 },
    );
    expect(read).toBeGreaterThan(20);
  });

  test("any statements, numbered or not", () => {
    const inside = fc.array(statements, { minLength: 1, maxLength: 12 });
    fc.assert(
      fc.property(
        inside,
        fc.constantFrom(...FILES),
        fc.boolean(),
        fc.constantFrom("\n" as const, "\r\n" as const),
        (list, style, numbered, newLine) => {
          const framed: Statement[] = [
            { kind: "begin", name: "A", unit: "MM" },
            ...asControlStores(list),
            {
              kind: "end",
              name: "A",
              unit: "MM",
            },
          ];
          expect(refused(programText(framed, { ...style, newLine }, numbered))).toEqual([]);
          expect(refusedAsIso(programText(framed, { ...style, newLine }))).toEqual([]);
        },
      ),
      { numRuns: 1200 },
    );
  });

  test.each([...NC_LANGUAGES])("a new program, named as in %s", (language) => {
    for (const name of ["", "Welle 7/2", "轴 1", "a:b*c?", "é".repeat(60)])
      expect(
        refused(emptyProgram(`${name} ${language}`, { outside: "75", bore: "0", length: "100", allowance: "1" })),
      ).toEqual([]);
  });
});

describe("the look of the manual is refused where its first list is", () => {
  test.each(cuttingCycles.map((c) => [c.number, c] as const))("cycle %i", (_, cycle) => {
    const text = printAsInManual(exampleJob(cycle), ncLabels("fr"));
    const lines = text.split("\n");
    const head = lines.findIndex((line) => /CYCL DEF \d+ /.test(line));
    const block = Number(/^\d+/.exec(lines[head] ?? "")?.[0]);
    for (const control of ["tnc640", "tnc7"] as const) {
      expect(refusals(text, control)).toEqual([
        expect.objectContaining({
          line: head + 2,
          column: 1,
          block,
          code: "listWithoutTilde",
          data: expect.objectContaining({ list: `CYCL DEF ${cycle.number}` }) as object,
        }),
      ]);
    }
  });
});

/** Lines of a manual without BEGIN and END. */
const isPiece = (text: string) => !text.includes("BEGIN PGM") || !text.includes("END PGM");
/** Index of the first list line that the previous line does not announce; -1 in a file that a control loads. */
const firstStray = (lines: readonly string[]) =>
  lines.findIndex((line, i) => /^Q\d+\s*[=+-]/.test(line) && !/~\s*$/.test(lines[i - 1] ?? ""));

/** A shipped or tested program: a control loads it, or it has the manual's layout and is refused there. */
function isFileOrLook(text: string): void {
  const lines = text.split(/\r?\n/);
  const stray = firstStray(lines);
  const found = refusals(text, "tnc640").filter(
    ({ code }) => !isPiece(text) || !["beginMissing", "endMissing", "tildeAtEnd"].includes(code),
  );
  if (stray < 0) return expect(found).toEqual([]);
  const block = Number(/^\d+/.exec(lines[stray - 1] ?? "")?.[0]);
  expect(found[0]).toMatchObject({ code: "listWithoutTilde", line: stray + 1, column: 1, block });
  expect(found.filter(({ code }) => code !== "listWithoutTilde")).toEqual([]);
}

describe("programs of the tests, the examples and the course", () => {
  const names = projectFolder("tests/programs").filter((name) => name.endsWith(".h"));
  const texts = names.map((name) => projectFile(`tests/programs/${name}`));
  test.each(names.map((name, i) => [name, texts[i] ?? ""]))("%s", (_, text) => isFileOrLook(text));
  test.each(examples.map(({ id, text }) => [id, text]))("example %s", (_, text) => isFileOrLook(text));

  test("some are in the look of the manual, and most are files", () => {
    const codes = texts.map((text) => refusals(text, "tnc640").map((r) => r.code));
    expect(codes.filter((each) => each.includes("listWithoutTilde")).length).toBeGreaterThanOrEqual(3);
    expect(codes.filter((each) => each.length === 0).length).toBeGreaterThan(40);
  });

  test("lessons and tasks", () => {
    const files = projectFolder("src/course/lessons").map((name) => `src/course/lessons/${name}`);
    const tasks = projectFolder("src/course/tasks").map((name) => `src/course/tasks/${name}`);
    const programs = [...files, ...tasks]
      .filter((path) => path.endsWith(".json"))
      .flatMap((path) => programsIn(JSON.parse(projectFile(path))));
    expect(programs.length).toBeGreaterThan(100);
    expect(programs.flatMap((text) => refused(text))).toEqual([]);
  });

  test("damage is refused or not, and never more than that", () => {
    const pieces = fc.constantFrom(
      "",
      "~",
      "\r",
      "\n",
      ";",
      '"',
      "Q",
      "=",
      "/",
      "*",
      "%",
      "(",
      "{",
      " ",
      "\t",
      "1e9",
      "9".repeat(99),
      "CYCL DEF ",
      "\ufeff",
    );
    const edits = fc.array(
      fc.tuple(fc.double({ min: 0, max: 1, noNaN: true }), fc.nat(40), fc.oneof(pieces, fc.string({ maxLength: 8 }))),
      {
        maxLength: 12,
      },
    );
    const control = fc.constantFrom("tnc640" as const, "tnc7" as const, "iso" as const);
    fc.assert(
      fc.property(fc.constantFrom(...texts, ""), edits, control, (whole, changes, as) => {
        const text = changes.reduce((t, [where, drop, put]) => {
          const at = Math.floor(where * t.length);
          return t.slice(0, at) + put + t.slice(at + drop);
        }, whole);
        const lines = text.split(/\r\n|\n|\r/);
        for (const { line, column, block } of refusals(text, as)) {
          expect(lines.length).toBeGreaterThanOrEqual(line);
          expect((lines[line - 1] ?? "").length + 1).toBeGreaterThanOrEqual(column);
          expect(block === null || block >= 0).toBe(true);
        }
      }),
      { numRuns: 600 },
    );
  });
});

/** Every whole program in a file of the course: a list of lines from BEGIN PGM on. */
function programsIn(value: unknown): readonly string[] {
  if (typeof value !== "object" || value === null) return [];
  if (Array.isArray(value) && value.every((line): line is string => typeof line === "string"))
    return value.some((line) => line.includes("BEGIN PGM")) ? [value.join("\n")] : [];
  return Object.values(value).flatMap(programsIn);
}
