import { describe, expect, test } from "vitest";
import { parse } from "../parse.ts";
import { LAYOUTS } from "../style.ts";
import keptText from "./kept.cases.txt?raw";
import pairsText from "./pairs.cases.txt?raw";
import { isoProgramText } from "./print-iso.ts";
import { klartextOfIso } from "./read-iso.ts";
import { isoWords } from "./words.ts";

const cases = (text: string) => text.split("\n").filter((line) => line !== "" && !line.startsWith("#"));
/** The lines of a case as a program: a line that begins a block gets its number. */
function program(lines: string): string {
  let number = 3;
  return (
    lines
      .split(" ⏎ ")
      .map((line) => (/^Q\d+=/.test(line) ? line : `${number++} ${line}`))
      .join("\n") + "\n"
  );
}

/** `=` both ways; `->` to DIN/ISO and back. Formulas contain `=` with blanks as well, so the middle one separates. */
const pairs = cases(pairsText).map((line) => {
  const way = line.split(" -> ");
  if (way.length === 3) return way;
  const parts = line.split(" = ");
  const half = parts.length / 2;
  const [klartext, iso] = line.includes(" = D")
    ? [line.slice(0, line.lastIndexOf(" = D")), line.slice(line.lastIndexOf(" = D") + 3)]
    : [parts.slice(0, half).join(" = "), parts.slice(half).join(" = ")];
  return [klartext, iso, klartext];
});

describe("each kind of block once, in both languages", () => {
  test("the pairs are read at all", () => expect(pairs.length).toBeGreaterThan(90));
  test.each(pairs)("%s = %s", (klartext = "", iso = "", back = "") => {
    const printed = isoProgramText(parse(program(klartext)));
    expect(printed.text).toBe(`N3 ${iso} *\n`);
    const read = klartextOfIso(printed.text, LAYOUTS.tnc7);
    expect(read.issues).toEqual([]);
    expect(read.text).toBe(program(back));
  });
});

describe("blocks without a DIN/ISO word are kept and listed", () => {
  test.each(cases(keptText))("%s", (klartext) => {
    const before = parse(program(klartext));
    const printed = isoProgramText(before);
    expect(printed.untranslated).toEqual(before.blocks.map((b, index) => ({ index, number: b.number })));
    expect(printed.text).toBe(
      klartext
        .split(" ⏎ ")
        .map((line, i) => `N${3 + i} ${line} *\n`)
        .join(""),
    );
    const known = before.blocks.every((b) => b.statement.kind !== "unknown");
    const read = klartextOfIso(printed.text, LAYOUTS.tnc7);
    expect(read.issues.map((i) => i.code)).toEqual(known ? [] : ["isoBlockNotUnderstood"]);
    expect(parse(read.text).blocks.map((b) => b.statement)).toEqual(before.blocks.map((b) => b.statement));
  });
});

describe("the table of words", () => {
  test.each(isoWords.filter((w) => w.klartext !== "").map((w) => [w.word, w] as const))(
    "%s is printed for its example",
    (_, row) => {
      const { text, untranslated } = isoProgramText(parse(`${row.klartext}\n`));
      expect(untranslated).toEqual([]);
      // "I J K" are alternatives; "G90 … G91 …" are both in one block.
      const all = row.word.split(/ ?… ?/).filter((w) => w !== "");
      for (const words of all)
        expect(text).toMatch(new RegExp(String.raw`(?:^|[ \d])(?:${words.replaceAll(" ", "|")})`));
    },
  );

  test.each(isoWords.filter((w) => w.klartext === "").map((w) => [w.word, w.means.kind]))(
    "%s is read or reported",
    (word, kind) => {
      const { text, issues } = klartextOfIso(`N1 G02 X+5 R5 *\nN2 ${word} X+3 H+5 R+2 *\n`, LAYOUTS.tnc7);
      if (kind === "unread") {
        expect(issues).toMatchObject([{ code: "isoWordNotUnderstood", number: 2, line: 2, data: { word } }]);
        expect(parse(text).blocks[1]?.statement).toEqual({ kind: "unknown", text: `${word} X+3 H+5 R+2` });
      } else expect(parse(text).blocks[1]?.statement.kind === "path").toBe(issues.length === 0);
    },
  );

  test("no word has two meanings, and a recalled word has no page", () => {
    const coded = isoWords.filter((w) => /^[GD]\d+$/.test(w.word));
    expect(new Set(coded.map((w) => w.word)).size).toBe(coded.length);
    for (const w of isoWords) expect(w.source === "").toBe(w.evidence.startsWith("K"));
  });
});
