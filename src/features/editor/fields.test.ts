import { expect, test } from "vitest";
import { catalogue } from "../../cycles/index.ts";
import { withBlock } from "../../nc/edit.ts";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import { fieldsOf } from "../../app/fields/blocks/block-fields.ts";
import { readingOfBlock, withPrompt } from "../../app/fields/blocks/block-prompts.ts";
import { cycleStatement, palette } from "./palette.ts";
import { partsOf } from "../../app/fields/blocks/program-parts.ts";

const samples = import.meta.glob<string>("../../../tests/programs/**/*.h", {
  query: "?raw",
  import: "default",
  eager: true,
});
const programs = Object.values(samples).map(parse);
const statements: readonly Statement[] = [
  ...programs.flatMap((p) => p.blocks.map((b) => b.statement)),
  ...palette.flatMap((offered) => offered.make?.("en") ?? []),
  ...catalogue.map((cycle) => cycleStatement(cycle, "en")),
  ...parse(
    "TRANS DATUM AXIS X+3 IZ-2.5\nTRANS DATUM RESET\nTRANS ROTATION IROT-12.5\nTRANS SCALE SCL0.75\nFPOL X+2 Y-7\nFSELECT 2\n" +
      "FLT PR+8 IPA+30 AN+20 P1X+2 P1Y+Q4 PAR12 CLSD+ F300\nFC IX+4 DR- R10.5 CCX+2 ICCY-1 RCCY5 CCA90 LEN7 RL",
  ).blocks.map((b) => b.statement),
];
const edited = (text: string, id: string, typed: string): string => {
  const program = parse(text);
  const s = program.blocks[0]?.statement;
  const field = s && fieldsOf(s).find((f) => f.id === id);
  const next = s && field?.write(s, typed);
  return next ? print(withBlock(program, 0, next)) : "refused";
};

test("the text of a field, typed again, gives the same value", () => {
  for (const s of statements)
    for (const field of fieldsOf(s)) {
      const shown = field.read(s);
      if (shown === "" && field.write(s, "") === null) continue;
      expect(field.write(s, shown), `${s.kind} ${field.id} ${shown}`).toEqual(s);
    }
});

test("every kind of block with values has a dialog with names of its own", () => {
  for (const s of statements) {
    if (s.kind === "empty") continue;
    const ids = fieldsOf(s).map((f) => f.id);
    expect(new Set(ids).size, s.kind).toBe(ids.length);
    if (s.kind !== "cycle" || s.parameters.length > 0) expect(ids.length, s.kind).toBeGreaterThan(0);
  }
});

test.each([
  ["7 L  X+140 Z+80 R0 FMAX ;there\n", "X", "142,5", "7 L  X+142.5 Z+80 R0 FMAX ;there\n"],
  ["7 L X+140 Z+80\n", "Z", "", "7 L X+140\n"],
  ["7 L X+140\n", "feed", "0.2", "7 L X+140 F0.2\n"],
  ["7 L X+140\n", "functions", "8 M303", "7 L X+140 M8 M303\n"],
  ["7 CR X+1 Z+2 R5 DR-\n", "turn", "ccw", "7 CR X+1 Z+2 R5 DR+\n"],
  ["4 TOOL CALL 15\n", "tool", "CNMG", '4 TOOL CALL "CNMG"\n'],
  ["3 UDC TYPE_E R1 DEPTH2\n", "word BREADTH", "15", "3 UDC TYPE_E R1 DEPTH2 BREADTH15\n"],
  ["3 Q1 = 2\n", "formula", "Q2 * 3", "3 Q1 = Q2 * 3\n"],
  ["3 L X+1\n", "X", "Q5", "3 L X+Q5\n"],
  ["3 L X+1\n", "X", "one", "refused"],
  ["3 * - PART\n", "text", "OTHER", "3 * - OTHER\n"],
  ["3 FL X+1 AN+20 F300\n", "word AN", "31,5", "3 FL X+1 AN+31.5 F300\n"],
  ["3 FC DR- R5\n", "word CCX", "-2", "3 FC DR- CCX-2 R5\n"],
  ["3 TRANS DATUM AXIS X+3\n", "Z", "-4.2", "3 TRANS DATUM AXIS X+3 Z-4.2\n"],
  ["3 TRANS ROTATION ROT+20\n", "ROT", "-7", "3 TRANS ROTATION ROT-7\n"],
  ["3 STRANGE 1\n", "text", "STOP M8", "3 STOP M8\n"],
])("%s: %s as %s", (text, id, typed, result) => expect(edited(text, id, typed)).toBe(result));

test("a prompt of a cycle changes only its own characters", () => {
  for (const program of programs)
    program.blocks.forEach((block, index) => {
      const read = readingOfBlock(program, index, {});
      if (!read || block.statement.kind !== "cycle") return;
      for (const { q } of block.statement.parameters) {
        if (read.cycle.params[q]?.choices || read.draft[q] === "") continue;
        const after = print(withPrompt(program, index, q, "Q77"));
        expect(after.replace(/\+Q77|Q77/, ""), q).not.toBe(print(program));
        expect(after.split("\n").filter((line, i) => line !== print(program).split("\n")[i])).toHaveLength(1);
      }
    });
});

test("a cycle that acts where it is defined does not count as never called", () => {
  const program = parse(
    "0 BEGIN PGM A MM\n1 CYCL DEF 801\n2 CYCL DEF 247 Q339=+1\n3 CYCL DEF 880 Q215=+0\n4 END PGM A MM\n",
  );
  expect(partsOf(program, null).map((p) => p.acts)).toEqual([true, true, false]);
});

test("the list of parts names tools, cycles, labels and notes", () => {
  const program = parse('0 BEGIN PGM A MM\n1 * - FIRST\n2 TOOL CALL 3\n3 LBL "C"\n4 L X+1\n5 LBL 0\n6 END PGM A MM\n');
  expect(partsOf(program, null).map((p) => `${p.number} ${p.kind} ${p.text}`)).toEqual([
    "1 structure * - FIRST",
    "2 toolCall TOOL CALL 3",
    '3 label LBL "C"',
  ]);
});
