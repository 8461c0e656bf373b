import { deflateSync, strToU8 } from "fflate";
import * as fc from "fast-check";
import { expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { CLAMPING_KINDS } from "../../program/clamping/words.ts";
import { exampleJob } from "../../program/job/job.ts";
import { BESIDE_CELLS, MILL_COLUMNS, TOOL_COLUMNS, type CellName } from "../../program/tools/tool-columns.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import { LARGEST_PROGRAM } from "../base/limits.ts";
import { plainWork } from "./save-file.ts";
import type { ProgramWork, Work } from "../document/work.ts";
import { LINK_MARK, linkOf, readLink } from "./link.ts";
import { LINK_DICTIONARY } from "./link-dictionary.ts";

const PAGE = "https://example.org/page";
const hashOf = (work: Work) => new URL(linkOf(PAGE, work)).hash;
const coded = (bytes: Uint8Array) => Buffer.from(bytes).toString("base64url");
const packed = (text: string, mark = LINK_MARK) =>
  mark + coded(deflateSync(strToU8(text), /^#h/.test(mark) ? { dictionary: LINK_DICTIONARY } : {}));

const CELLS: readonly CellName[] = [...new Set<CellName>([...TOOL_COLUMNS, ...MILL_COLUMNS, ...BESIDE_CELLS])];
const anyText = fc.string({ unit: "grapheme", maxLength: 40 });
const awkward = fc.oneof(
  anyText,
  fc.constantFrom("0,8", "-0.0004", "1e-3", "", " ", "DNMG 15 06 08", "8/0 8/-6; 4/2 1/1 9/9.25", "⌀", '"},{'),
  fc.double({ noNaN: true }).map(String),
);
const row = fc.dictionary(fc.constantFrom(...CELLS), awkward).map((cells) => ({ ...cells }));
const tools = fc.array(row, { maxLength: 9 }).map((rows) => rows.map((cells, i) => ({ id: `r${i * 7 + 1}`, cells })));
const textFile = fc.record({
  name: fc.string({ unit: "grapheme", minLength: 1, maxLength: 20 }),
  text: fc.string({ unit: "grapheme", maxLength: 300 }),
  encoding: fc.constantFrom("utf-8" as const, "windows-1252" as const),
});
const brought = {
  tools: fc.option(tools, { nil: undefined }),
  control: fc.constantFrom("TNC 640" as const, "TNC7" as const, undefined),
};
const bare = <T extends object>(made: T): T =>
  Object.fromEntries(Object.entries(made).filter(([, value]) => value !== undefined)) as T;
const program: fc.Arbitrary<Work> = fc
  .tuple(
    textFile,
    fc.record({
      files: fc.option(fc.array(textFile, { maxLength: 3 }), { nil: undefined }),
      skipMarked: fc.option(fc.boolean(), { nil: undefined }),
      remarks: fc.option(anyText, { nil: undefined }),
      ...brought,
    }),
  )
  .map(([file, others]) => bare({ ...file, ...others }) as unknown as ProgramWork);
const clamping = fc.option(
  fc.record({
    kind: fc.constantFrom(...CLAMPING_KINDS),
    words: fc.dictionary(fc.constantFrom("D", "FACE", "TIP"), anyText),
  }),
  {
    nil: undefined,
  },
);
const job: fc.Arbitrary<Work> = fc
  .tuple(fc.constantFrom(...cuttingCycles), fc.record({ name: anyText, rapid: awkward, clamping, ...brought }))
  .map(([cycle, others]) => bare({ ...exampleJob(cycle), ...others }) as unknown as Work);

test("a link restores the work with its files, tools and control, whatever they contain", () => {
  fc.assert(
    fc.property(fc.oneof(program, job), (work) => {
      expect(linkOf(PAGE, work)).toMatch(/^https:\/\/example\.org\/page#h2=[\w-]+$/);
      const read = readLink(hashOf(work));
      expect(read).toEqual({ kind: "work", work });
      if (read.kind === "work") expect(hashOf(read.work)).toBe(hashOf(work));
    }),
    { numRuns: 25 },
  );
});

test("received data is read like saved works, or not at all", () => {
  fc.assert(
    fc.property(fc.json(), (text) => {
      const read = readLink(packed(`{"work":${text}}`));
      expect(read).toEqual(
        plainWork(JSON.parse(text)) ? { kind: "work", work: plainWork(JSON.parse(text)) } : { kind: "damaged" },
      );
    }),
  );
  const [first] = shippedList;
  for (const wrong of [
    { tools: [{ ...first, cells: { ...first?.cells, COLOUR: "red" } }] },
    { tools: [{ id: "r1", cells: { RS: 0.8 } }] },
    { tools: {} },
    { control: "iTNC 530" },
    { files: [{ name: "a.h" }] },
    { encoding: "utf-16" },
  ])
    expect(readLink(packed(JSON.stringify({ work: { name: "A.h", text: "", encoding: "utf-8", ...wrong } })))).toEqual({
      kind: "damaged",
    });
});

test("lost or changed letters never throw, and never give half a work", () => {
  const whole: Work = {
    name: "A.h",
    text: "0 BEGIN PGM A MM\n1 TOOL CALL 3\n2 END PGM A MM\n",
    encoding: "utf-8",
    tools: shippedList,
  };
  const hash = hashOf(whole);
  const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_%= ";
  fc.assert(
    fc.property(fc.nat({ max: hash.length - 1 }), fc.constantFrom(...letters), fc.boolean(), (at, letter, cut) => {
      const read = readLink(cut ? hash.slice(0, at) : hash.slice(0, at) + letter + hash.slice(at + 1));
      expect(["work", "damaged", "tooLarge", "newer"]).toContain(read.kind);
      if (cut) expect(read.kind).toBe("damaged");
      if (read.kind === "work") expect(plainWork(read.work)).toEqual(read.work);
    }),
    { numRuns: 150 },
  );
  for (const hash of ["", "#", "#h1=", "#h2=", "#h0=AA", "#h1=%%%", "#p=%%%", "#w=e30", "#q=1"])
    expect(readLink(hash)).toEqual({ kind: "damaged" });
});

test("a link format of a newer edition is recognised, whatever it contains", () => {
  for (const hash of ["#h3=", "#h3=%%", "#h10=AAAA", `#h4=${"A".repeat(5000)}`])
    expect(readLink(hash)).toEqual({ kind: "newer" });
});

test("a small link that unpacks to more than is opened is refused", () => {
  const bomb = deflateSync(new Uint8Array(2 * LARGEST_PROGRAM), { level: 9 });
  expect(bomb.length).toBeLessThan(LARGEST_PROGRAM / 200);
  for (const mark of ["#p=", "#w=", LINK_MARK]) expect(readLink(mark + coded(bomb))).toEqual({ kind: "tooLarge" });
  const work: Work = { name: "A.h", text: "L X+1 ;Ø\n".repeat(200), encoding: "windows-1252" };
  const size = strToU8(JSON.stringify({ work })).length;
  expect(readLink(hashOf(work), size)).toEqual({ kind: "work", work });
  expect(readLink(hashOf(work), size - 1)).toEqual({ kind: "tooLarge" });
});

test("links of earlier editions still give the same work", () => {
  const text = "0 BEGIN PGM OLD/1 MM\r\n1 L X+10 ;Ø\r\n2 END PGM OLD/1 MM\r\n";
  expect(readLink(packed(text, "#p="))).toEqual({ kind: "work", work: { name: "OLD_1.h", text, encoding: "utf-8" } });
  const work = {
    name: "MAIN.H",
    text: "CALL PGM CUT\r\n",
    encoding: "windows-1252",
    files: [{ name: "cut.h", text: "L X+1 ;Ø\n", encoding: "utf-8" }],
    skipMarked: true,
  };
  expect(readLink(packed(JSON.stringify(work), "#w="))).toEqual({ kind: "work", work });
});

test("a link made today stays readable: the compression dictionary never changes", () => {
  // Made by the first edition that had this form.
  const made = "#h1=QzRWMPo20EaJI7j5Am21GCJ5CxhKqA0WSCOkthYA";
  expect(readLink(made)).toEqual({
    kind: "work",
    work: { name: "A.h", text: "1 TOOL CALL 3\n", encoding: "utf-8", control: "TNC7" },
  });
});

test.each([
  ["tnc640", "manual"],
  ["tnc7", "tnc7"],
] as const)("a cycle in the layout %s of an earlier link keeps its text", (was, is) => {
  const [cycle] = cuttingCycles;
  if (!cycle) throw new Error("no cycle");
  const { output: _, ...earlier } = { ...exampleJob(cycle), layout: was };
  const read = readLink(packed(JSON.stringify({ work: earlier }), "#h1="));
  expect(read).toMatchObject({ kind: "work", work: { layout: is, output: { spindleOn: 303, spindleOff: null } } });
});
