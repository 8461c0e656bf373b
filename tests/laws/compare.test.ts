import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { catalogue } from "../../src/cycles/index.ts";
import { ncLabels } from "../../src/i18n/nc-labels.ts";
import { parse } from "../../src/nc/parse.ts";
import { blockText } from "../../src/nc/print.ts";
import type { Program } from "../../src/nc/program.ts";
import type { Style } from "../../src/nc/style.ts";
import { comparePrograms, type BlockDifference } from "../../src/program/compare/compare.ts";
import { exampleJob } from "../../src/program/job/job.ts";
import { printJob } from "../../src/program/job/print-job.ts";
import { setupOf, withSetup } from "../../src/program/job/setup.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";

const samples = Object.values({
  ...import.meta.glob<string>("../programs/**/*.h", { query: "?raw", import: "default", eager: true }),
  ...import.meta.glob<string>("../../src/examples/*.h", { query: "?raw", import: "default", eager: true }),
}).filter((text) => text.length < 40_000);
const sample = fc.constantFrom(...samples);

/** Differences in meaning, not only in writing. */
const inMeaning = (a: string, b: string): readonly BlockDifference[] =>
  comparePrograms(parse(a), parse(b)).differences.filter(({ kind }) => kind !== "form" && kind !== "note");

const style = fc.record<Style>({
  plus: fc.boolean(),
  decimal: fc.constantFrom(".", ","),
  wide: fc.boolean(),
  continued: fc.constant(true),
  indent: fc.constantFrom("", " ", "   "),
  rapid: fc.constantFrom("FMAX", "F MAX"),
  spacedWords: fc.boolean(),
  newLine: fc.constantFrom("\n", "\r\n", "\r"),
});

/** Blocks that were read completely, printed again; all others unchanged. */
const rewritten = ({ blocks }: Program, to: Style, first: number, step: number): string =>
  blocks
    .map((block, i) => {
      if (block.issues || block.statement.kind === "unknown" || block.statement.kind === "empty") return block.raw;
      return blockText(first + i * step, block.statement, to, block);
    })
    .join("");

/** Every letter in lower case, but between quotes and in comments. */
const lowered = (text: string): string =>
  text
    .split(/("[^"\r\n]*"|;[^\r\n]*)/)
    .map((part, i) => (i % 2 === 1 ? part : part.toLowerCase()))
    .join("");

describe("no difference in meaning", () => {
  test.each(samples.map((text, i) => [i, text] as const))("sample %i with itself", (_, text) =>
    expect(comparePrograms(parse(text), parse(text)).differences).toEqual([]),
  );

  test("renumbered and rewritten in another style", () =>
    fc.assert(
      fc.property(sample, style, fc.nat(50), fc.integer({ min: 1, max: 10 }), (text, to, first, step) => {
        expect(inMeaning(text, rewritten(parse(text), to, first, step))).toEqual([]);
      }),
      { numRuns: 150 },
    ));

  test("in lower case", () => {
    const plain = samples.filter((text) => parse(text).blocks.every(({ issues }) => !issues));
    expect(plain.length).toBeGreaterThan(10);
    for (const text of plain) expect(inMeaning(text, lowered(text))).toEqual([]);
  });

  test("with comments put in and taken out", () =>
    fc.assert(
      fc.property(sample, fc.array(fc.double({ min: 0, max: 1, noNaN: true }), { maxLength: 9 }), (text, places) => {
        const lines = parse(text).blocks.map(({ raw }) => raw);
        if (lines.some((line) => !/[\r\n]$/.test(line))) return;
        for (const place of places) lines.splice(Math.floor(place * (lines.length + 1)), 0, `; seen at ${place}\n`);
        expect(inMeaning(text, lines.join(""))).toEqual([]);
      }),
      { numRuns: 150 },
    ));

  test.each(catalogue.map((cycle) => [cycle.number, cycle] as const))(
    "cycle %i by both layouts and in each language",
    (_, cycle) => {
      const typed = exampleJob(cycle);
      const job = withSetup(typed, setupOf(typed, shippedTools));
      const printed = (["tnc640", "tnc7"] as const).flatMap((layout) =>
        (["en", "de", "fr"] as const).map((ncLanguage) =>
          printJob({ ...job, layout, ncLanguage }, ncLabels(ncLanguage)),
        ),
      );
      for (const other of printed) expect(inMeaning(printed[0] ?? "", other)).toEqual([]);
    },
  );
});

const withValues = samples.filter((text) => /^ *Q\d+=[+-]?\d/m.test(text));

test("one changed value of a cycle is the only difference", () => {
  expect(withValues.length).toBeGreaterThan(5);
  fc.assert(
    fc.property(fc.constantFrom(...withValues), fc.double({ min: 0, max: 1, noNaN: true }), (text, where) => {
      const program = parse(text);
      const places = program.blocks.flatMap(({ statement: s }, i) =>
        s.kind === "cycle"
          ? s.parameters.flatMap(({ q, value }) => (typeof value === "number" ? [{ i, q, value }] : []))
          : [],
      );
      const place = places[Math.floor(where * places.length)];
      if (!place || places.filter(({ i, q }) => i === place.i && q === place.q).length > 1) return;
      const to = Number((place.value + 0.37).toFixed(4));
      const raw = program.blocks[place.i]?.raw ?? "";
      const changed = raw.replace(
        new RegExp(String.raw`(?<![A-Z\d])(${place.q}\s*=?\s*)[+-]?[\d.,]+`),
        `$1${to < 0 ? "" : "+"}${to}`,
      );
      const other = program.blocks.map((block, i) => (i === place.i ? changed : block.raw)).join("");
      const words = [{ name: place.q, from: String(place.value), to: String(to) }];
      expect(inMeaning(text, other)).toEqual([{ kind: "changed", a: place.i, b: place.i, words }]);
    }),
    { numRuns: 300 },
  );
});

/** A program with some of its blocks left out, doubled, moved or taken from another program. */
const mixed = fc
  .tuple(
    sample,
    sample,
    fc.array(
      fc.tuple(
        fc.constantFrom("drop", "double", "move", "take"),
        fc.double({ min: 0, max: 1, noNaN: true }),
        fc.double({ min: 0, max: 1, noNaN: true }),
        fc.nat(8),
      ),
      { maxLength: 5 },
    ),
  )
  .map(([text, more, edits]) => {
    const blocks = parse(text).blocks.map(({ raw }) => raw);
    const others = parse(more).blocks.map(({ raw }) => raw);
    for (const [what, from, to, count] of edits) {
      const [at, behind] = [Math.floor(from * blocks.length), Math.floor(to * blocks.length)];
      if (what === "drop") blocks.splice(at, count);
      if (what === "double") blocks.splice(behind, 0, ...blocks.slice(at, at + count));
      if (what === "move") blocks.splice(Math.min(behind, blocks.length - count), 0, ...blocks.splice(at, count));
      if (what === "take") blocks.splice(behind, 0, ...others.slice(at, at + count));
    }
    return [text, blocks.join("")] as const;
  });

const INVERSE = {
  changed: "changed",
  added: "removed",
  removed: "added",
  moved: "moved",
  note: "note",
  form: "form",
} as const;

test("swapped programs give the inverse, and each block is reported once", () => {
  fc.assert(
    fc.property(mixed, ([one, other]) => {
      const [a, b] = [parse(one), parse(other)];
      const there = comparePrograms(a, b);
      const back = comparePrograms(b, a).differences.map(({ kind, a: from, b: to, words }) => ({
        kind: INVERSE[kind],
        a: to,
        b: from,
        words: words.map((word) => ({ ...word, from: word.to, to: word.from })),
      }));
      const sorted = (list: readonly BlockDifference[]) => list.map((each) => JSON.stringify(each)).sort();
      expect(sorted(back)).toEqual(sorted(there.differences));
      for (const side of ["a", "b"] as const) {
        const told = there.differences.flatMap((each) => each[side] ?? []);
        expect(new Set(told).size).toBe(told.length);
      }
      // Nothing is lost: a block without a partner is reported.
      const said = (program: Program) =>
        program.blocks.flatMap(({ statement: { kind } }, i) =>
          kind === "empty" || kind === "comment" || kind === "structure" ? [] : [i],
        );
      const lost = said(a).filter((i) => (there.partners[i] ?? -1) < 0);
      expect(there.differences.flatMap((d) => (d.kind === "removed" ? [d.a] : []))).toEqual(lost);
    }),
    { numRuns: 300 },
  );
});

test("the comparison takes steps proportional to the length of the programs", () => {
  const lines = (n: number, x: (i: number) => number) =>
    Array.from({ length: n }, (_, i) => `${i + 1} L X+${x(i)} Z-${i % 7} F0.2\n`).join("");
  const one = lines(4_000, (i) => (i * 37) % 1009);
  const shifted = comparePrograms(parse(one), parse(lines(4_000, (i) => ((i * 37) % 1009) + 0.5))).differences;
  expect(shifted).toHaveLength(4_000);
  expect(shifted.every(({ kind, words }) => kind === "changed" && words.length === 1)).toBe(true);
  const foreign = comparePrograms(parse(one), parse(lines(4_000, (i) => (i * 7919) % 12_011))).differences;
  expect(foreign.length).toBeGreaterThan(2_000);
  const inserted = comparePrograms(parse(one), parse(`${one.slice(0, 40_010)}L X+1\n${one.slice(40_010)}`)).differences;
  expect(inserted.length).toBeLessThan(4);
});
