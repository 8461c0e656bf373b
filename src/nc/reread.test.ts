import * as fc from "fast-check";
import { expect, test } from "vitest";
import { parse } from "./parse.ts";
import { blockAt, readingOf, reread } from "./reread.ts";

const samples = import.meta.glob<string>("../../tests/programs/**/*.h", {
  query: "?raw",
  import: "default",
  eager: true,
});
const texts = Object.values(samples);

const piece = fc.oneof(
  fc.constantFrom(
    "",
    "~",
    " ~\n",
    "\n",
    "\n\n\n",
    "\r\n",
    ";",
    '"',
    "Q",
    "Q200=+5\n",
    "=",
    "7",
    "/",
    " ",
    "CYCL DEF 207\n",
    "LBL 1\n",
    "12 L X+3\nQ215=1 ;A\n",
  ),
  fc.string({ maxLength: 6 }),
);
const edits = fc.array(fc.tuple(fc.double({ min: 0, max: 1, noNaN: true }), fc.nat(30), piece), {
  minLength: 1,
  maxLength: 12,
});

test("rereading near a change equals reading the whole text", () => {
  fc.assert(
    fc.property(fc.constantFrom(...texts, "", texts.join("")), edits, (start, changes) => {
      let text = start;
      let reading = readingOf(text);
      for (const [where, drop, put] of changes) {
        const from = Math.floor(where * text.length);
        const to = Math.min(text.length, from + drop);
        text = text.slice(0, from) + put + text.slice(to);
        reading = reread(reading, { from, to, length: put.length }, (a, b) => text.slice(a, b));
        expect(reading.program).toEqual(parse(text));
        expect(reading.starts.at(-1)).toBe(text.length);
      }
    }),
    { numRuns: 500 },
  );
});

test("blocks away from the change stay the same objects", () => {
  const text = Array.from({ length: 1000 }, (_, i) => `${i} L X+${i} Z-${i}\n`).join("");
  const before = readingOf(text);
  const at = text.indexOf("500 L") + 7;
  const after = reread(before, { from: at, to: at + 1, length: 1 }, (a, b) =>
    (text.slice(0, at) + "9" + text.slice(at + 1)).slice(a, b),
  );
  const fresh = after.program.blocks.filter((b, i) => b !== before.program.blocks[i]);
  expect(fresh.length).toBeLessThan(40);
  expect(blockAt(after, at)).toBe(500);
});
