import { EditorState } from "@codemirror/state";
import * as fc from "fast-check";
import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import {
  changesBetween,
  duplicated,
  exchanged,
  inserted,
  removed,
  type TextChange,
} from "../../app/fields/blocks/block-edits.ts";
import { decode, encode } from "../../app/document/encoding.ts";
import { numberTyped } from "../../app/fields/blocks/typed-numbers.ts";
import { readingField } from "../../app/fields/blocks/reading-field.ts";
import { fromEditor, lineEndsOf, toEditor } from "../../app/fields/blocks/line-ends.ts";

const text = "0 BEGIN PGM A MM\n1 L X+10 Z+2 R0 FMAX\n2 L Z-5 ;cut\n3 M30\n4 END PGM A MM\n";
const applied = (from: string, changes: readonly TextChange[]) =>
  [...changes].reverse().reduce((t, c) => t.slice(0, c.from) + c.insert + t.slice(c.to), from);

test("line ends stay as they are", () => {
  const lines = fc.array(fc.tuple(fc.string({ maxLength: 5 }), fc.constantFrom("\n", "\r\n", "\r")), { maxLength: 8 });
  fc.assert(
    fc.property(lines, fc.boolean(), (all, alike) => {
      const whole = all.map(([line, end]) => line + (alike ? (all[0]?.[1] ?? "") : end)).join("");
      const ends = lineEndsOf(whole);
      expect(fromEditor(toEditor(whole, ends), ends)).toBe(whole);
    }),
  );
});

test("bytes are preserved, whatever they encode", () => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 60 }), (bytes) => {
      const read = decode(bytes);
      expect([...encode(read.text, read.encoding)]).toEqual([...bytes]);
    }),
  );
  expect(decode(Uint8Array.of(0xd8)).text).toBe("Ø");
  expect(encode("中", "windows-1252")).toEqual(new TextEncoder().encode("中"));
});

test("thousands of pasted lines are numbered by two changes, and the cursor stays between them", () => {
  const [head, lines] = ["0 BEGIN PGM A MM", Array.from({ length: 3000 }, (_, i) => `L X+${i}.5`)];
  const startState = EditorState.create({ doc: `${head}\n1 END PGM A MM\n`, extensions: readingField });
  const tr = startState.update({
    changes: { from: head.length, insert: ["", ...lines].join("\n") },
    selection: { anchor: head.length + ["", ...lines].join("\n").length },
    userEvent: "input.paste",
  });
  const changes = numberTyped({
    state: tr.state,
    startState,
    transactions: [tr],
    docChanged: true,
    selectionSet: true,
  });
  expect(changes.length).toBe(2);
  const { doc, selection } = tr.state.update({ changes }).state;
  const numbered = lines.map((line, i) => `${i + 1} ${line}`);
  expect(doc.toString()).toBe([head, ...numbered, "3001 END PGM A MM", ""].join("\n"));
  expect(selection.main.head).toBe([head, ...numbered].join("\n").length);
});

test("changes between programs turn one text into the other", () => {
  const before = parse(text);
  for (const after of [
    inserted(before, 2, { kind: "structure", text: "HERE" }),
    removed(before, 2),
    duplicated(before, 2),
    exchanged(before, 2),
    exchanged(before, 0),
    before,
  ])
    expect(applied(text, changesBetween(before, after))).toBe(print(after));
});

test("blocks are copied and moved letter by letter, and numbers stay in order", () => {
  expect(print(duplicated(parse(text), 2))).toBe(
    "0 BEGIN PGM A MM\n1 L X+10 Z+2 R0 FMAX\n2 L Z-5 ;cut\n3 L Z-5 ;cut\n4 M30\n5 END PGM A MM\n",
  );
  expect(print(exchanged(parse(text), 1))).toBe(
    "0 BEGIN PGM A MM\n1 L Z-5 ;cut\n2 L X+10 Z+2 R0 FMAX\n3 M30\n4 END PGM A MM\n",
  );
  expect(print(exchanged(parse("1 L X+1\n2 L X+2"), 0))).toBe("1 L X+2\n2 L X+1");
  expect(print(removed(parse(text), 1))).toBe("0 BEGIN PGM A MM\n1 L Z-5 ;cut\n2 M30\n3 END PGM A MM\n");
});
