import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { isoPage } from "../../scripts/iso-page.ts";
import { cuttingCycles } from "../../src/cycles/index.ts";
import { ncLabels } from "../../src/i18n/nc-labels.ts";
import { isIsoText } from "../../src/nc/iso/lines.ts";
import { ENGLISH_NAMES, type IsoNames } from "../../src/nc/iso/names.ts";
import { isoProgramText } from "../../src/nc/iso/print-iso.ts";
import { klartextOfIso } from "../../src/nc/iso/read-iso.ts";
import { parse } from "../../src/nc/parse.ts";
import { programText } from "../../src/nc/print.ts";
import type { Statement } from "../../src/nc/statement.ts";
import { LAYOUTS } from "../../src/nc/style.ts";
import { exampleJob } from "../../src/program/job/job.ts";
import { printJob } from "../../src/program/job/print-job.ts";
import { run } from "../../src/program/run/run.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { listing } from "../../src/report/listing.ts";
import { traceStock } from "../../src/sim/tracing.ts";
import { projectFile } from "../sources.ts";
import { statements } from "./statements.ts";

const style = LAYOUTS.tnc7;
const shop = { tools: shippedTools, rapid: 10_000, tracing: traceStock };

/** A Klartext text converted to DIN/ISO and back. */
const through = (text: string, names?: IsoNames) => klartextOfIso(isoProgramText(parse(text)).text, style, names);

/** Cycles without names and labels, which DIN/ISO does not contain. */
function nameless(s: Statement): Statement {
  if (s.kind === "cycle") return { ...s, name: "", parameters: s.parameters.map((p) => ({ ...p, label: null })) };
  return s.kind === "cycleLine" && s.line === 0 ? { ...s, text: "" } : s;
}
const meant = (text: string) => parse(text).blocks.map((b) => nameless(b.statement));

/** Cycles of numbered lines whose texts have words in DIN/ISO, so that both are tested. */
const number = fc
  .tuple(fc.integer({ min: -99999, max: 99999 }), fc.constantFrom(1, 100, 1000))
  .map(([n, s]) => (n === 0 ? 0 : n / s));
const sign = (n: number) => `${n < 0 ? "" : "+"}${n}`;
const older: fc.Arbitrary<Statement[]> = fc
  .oneof(
    fc.tuple(
      fc.constant(7),
      fc.array(
        fc.tuple(fc.constantFrom("X", "IY", "Z", "IC"), number).map(([a, n]) => a + sign(n)),
        {
          minLength: 1,
          maxLength: 3,
        },
      ),
    ),
    fc.tuple(
      fc.constant(7),
      fc.nat(99).map((n) => [`#${n}`]),
    ),
    fc.tuple(fc.constant(8), fc.constantFrom([""], ["X"], ["X Z"])),
    fc.tuple(fc.constant(9), fc.constantFrom(["DWELL 0.25"], ["DWELL 12"])),
    fc.tuple(
      fc.constant(10),
      fc.tuple(fc.constantFrom("ROT", "IROT"), number).map(([w, n]) => [w + sign(n)]),
    ),
    fc.tuple(fc.constant(11), fc.constantFrom(["SCL 0.995"], ["SCL 3"])),
    fc.tuple(fc.constant(12), fc.constantFrom(["PGM TNC:\\A\\B.H"], ["PGM 7"])),
    fc.tuple(fc.constant(13), fc.constantFrom(["ANGLE 12.5"])),
    fc.tuple(fc.constant(14), fc.constantFrom(["CONTOUR LABEL2"], ["CONTOUR LABEL2 /5"], ['CONTOUR LABEL"A" /13'])),
    fc.tuple(fc.constant(19), fc.constantFrom(["A+0 B+45.5"], ["C-3"])),
    fc.tuple(fc.constant(32), fc.constantFrom(["T0.05"], ["T0.05", "HSC-MODE:1 TA0.5"])),
    fc.tuple(fc.constant(247), fc.constant(["NO WORD"])),
  )
  .map(([cycle, texts]): Statement[] =>
    ["TITLE", ...texts].map((text, line) => ({ kind: "cycleLine", cycle, line, text })),
  );

test("any statements come back from DIN/ISO, except names and labels of cycles", () =>
  fc.assert(
    fc.property(
      fc.array(
        fc.oneof(
          statements.map((s) => [s]),
          older,
        ),
        { minLength: 1, maxLength: 8 },
      ),
      (list) => {
        const text = programText(list.flat(), style);
        const back = through(text);
        expect(meant(back.text)).toEqual(meant(text));
        expect(back.issues).toEqual([]);
      },
    ),
    { numRuns: 1500 },
  ));

test("block numbers come back, and requested names", () =>
  fc.assert(
    fc.property(fc.array(statements, { maxLength: 8 }), (list) => {
      const text = programText(
        [
          { kind: "begin", name: "P", unit: "MM" },
          ...list.filter((s) => s.kind !== "begin" && s.kind !== "end"),
          {
            kind: "end",
            name: "P",
            unit: "MM",
          },
        ],
        style,
      );
      const named = {
        ...ENGLISH_NAMES,
        cycle: (n: number) => `NAME ${"ABCDEFGHIJ"[n % 10]}`,
        label: (n: number, q: string) => `L${n}${q}`,
      };
      const [before, after] = [parse(text).blocks, parse(through(text, named).text).blocks];
      expect(after.map((b) => b.number)).toEqual(before.map((b) => b.number));
      for (const { statement: s } of after)
        if (s.kind === "cycle" && s.cycle >= 200)
          expect([s.name, ...s.parameters.map((p) => p.label)]).toEqual([
            named.cycle(s.cycle),
            ...s.parameters.map((p) => named.label(s.cycle, p.q)),
          ]);
    }),
    { numRuns: 400 },
  ));

/** Layout issues: DIN/ISO does not contain the layout, and the conversion back is well formed. */
const OF_LAYOUT = /^! \w+ (?:listWithoutTilde|equalsMissing|blankBeforeEquals|continuationOpen)\b.*\n/gm;
/** Moves and findings of a run, without line numbers: a list may be on other lines. */
const moves = (text: string) =>
  listing(run(parse(text), shop))
    .replaceAll(OF_LAYOUT, "")
    .replaceAll(/, line \d+$/gm, "");
const programs = Object.entries(
  import.meta.glob<string>("../programs/*.h", { query: "?raw", import: "default", eager: true }),
);

describe("every program of the folder runs the same after DIN/ISO", () => {
  test.each(programs)("%s", (_, text) => {
    const back = through(text);
    // Two lists of printed examples count from the number on their manual page.
    const recounted = back.issues.length > 0;
    expect(back.issues.map((i) => i.code)).toEqual(recounted ? ["isoBlocksRecounted"] : []);
    const seen = (of: string) =>
      recounted
        ? moves(of)
            .replaceAll(/^! info blockNumber.*\n/gm, "")
            .replaceAll(/block \d+/g, "block")
        : moves(of);
    expect(seen(back.text)).toBe(seen(text));
  });
});

describe("the example of every cycle runs the same after DIN/ISO", () => {
  const labels = ncLabels("en");
  test.each(cuttingCycles.map((cycle) => [cycle.number, cycle] as const))("%i", (number, cycle) => {
    const text = printJob(exampleJob(cycle), labels);
    const iso = isoProgramText(parse(text));
    expect(isIsoText(iso.text)).toBe(true);
    expect(isIsoText(text)).toBe(false);
    const back = klartextOfIso(iso.text, style, { ...ENGLISH_NAMES, cycle: labels.cycleName, contour: labels.contour });
    expect(back.issues).toEqual([]);
    expect(back.text).toContain(`CYCL DEF ${number} ${labels.cycleName(number)} ~`);
    expect(moves(back.text)).toBe(moves(text));
  });
});

/** DIN/ISO programs with pieces copied, dropped or swapped. */
const damaged = fc
  .tuple(
    fc.constantFrom(...programs.map(([, text]) => isoProgramText(parse(text)).text)),
    fc.array(
      fc.tuple(
        fc.double({ min: 0, max: 1, noNaN: true }),
        fc.nat(40),
        fc.oneof(
          fc.constantFrom(
            "",
            "~",
            "\r",
            "\n",
            ";",
            '"',
            "Q",
            "=",
            "+",
            "/",
            "*",
            " *",
            "\t",
            ",",
            "1e99",
            "9".repeat(400),
            "G",
            "G200 ",
            "N",
            "N5 ",
            "G91",
            "G05 ",
            "G26 R5",
            "I+5",
            "T",
            "D01 Q1 P01",
            "L2,",
            "%",
            "%A G71",
            "G37 P01",
            "G53",
            "BEGIN PGM",
            "ß",
            "中",
            "M128",
            "R",
          ),
          fc.string({ maxLength: 8 }),
        ),
      ),
      { minLength: 1, maxLength: 12 },
    ),
  )
  .map(([text, edits]) =>
    edits.reduce((t, [where, drop, put]) => {
      const at = Math.floor(where * t.length);
      return t.slice(0, at) + put + t.slice(at + drop);
    }, text),
  );

test("no text makes the reader throw, every finding has its place, and what it reads can be printed again", () =>
  fc.assert(
    fc.property(fc.oneof(damaged, fc.string({ unit: "binary" })), (text) => {
      const read = klartextOfIso(text, style);
      const lines = text.split(/\r\n|\n|\r/);
      for (const { line, column } of read.issues) {
        expect(line).toBeGreaterThan(0);
        expect(column).toBeGreaterThan(0);
        expect(column).toBeLessThanOrEqual((lines[line - 1]?.length ?? -1) + 1);
      }
      if (!/NaN|Infinity/.test(text)) expect(read.text).not.toMatch(/NaN|Infinity/);
      expect(isoProgramText(parse(read.text)).text).not.toContain("undefined");
    }),
    { numRuns: 800 },
  ));

test("untranslatable blocks are kept and reported, never dropped", () =>
  fc.assert(
    fc.property(damaged, (text) => {
      const read = klartextOfIso(text, style);
      const unknown = parse(read.text).blocks.filter((b) => b.statement.kind === "unknown").length;
      const said = new Set(read.issues.filter((i) => i.severity === "error").map((i) => i.line)).size;
      expect(said).toBe(unknown);
    }),
    { numRuns: 400 },
  ));

test("the page of DIN/ISO is what `npm run docs` writes", () => expect(projectFile("docs/din-iso.md")).toBe(isoPage()));
