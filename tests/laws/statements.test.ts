import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { parse } from "../../src/nc/parse.ts";
import { blockText, statementLines } from "../../src/nc/print.ts";
import { print } from "../../src/nc/program.ts";
import type { Statement } from "../../src/nc/statement.ts";
import { LAYOUTS, type Style } from "../../src/nc/style.ts";
import { statements } from "./statements.ts";

describe("a printed statement parses to itself", () => {
  const styles: Style[] = [
    ...Object.values(LAYOUTS),
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
  test.each(styles.map((s, i) => [i, s] as const))("style %i", (_, style) =>
    fc.assert(
      fc.property(statements, fc.nat(9999), (statement, n) => {
        const text = blockText(n, statement, style);
        const { blocks } = parse(text);
        expect(blocks).toHaveLength(1);
        expect(blocks[0]?.number).toBe(n);
        expect(blocks[0]?.statement).toEqual(statement);
        expect(statementLines(statement, style).length).toBe(blocks[0]?.lines);
      }),
      { numRuns: 1200 },
    ),
  );
});

/** Spellings of a block that posts and older controls use, each with its contents. */
const number4 = fc.nat(9999);
const numbered = fc
  .tuple(fc.constantFrom("N", "n", ""), number4, fc.constantFrom(" ", "  ", "\t"))
  .map(([n, at, gap]) => `${n}${at}${gap}`);
const isPlain = (s: Statement) => s.kind !== "cycle" && s.kind !== "comment";

describe("other spellings mean the same, and are printed back byte for byte", () => {
  const style = LAYOUTS.tnc7;
  const same = (text: string, statement: Statement, numberOfBlock: number | null, skip: boolean) => {
    const program = parse(text);
    expect(print(program)).toBe(text);
    expect(program.blocks).toHaveLength(1);
    expect({ skip: false, ...program.blocks[0] }).toMatchObject({ number: numberOfBlock, skip });
    expect(program.blocks[0]?.statement).toEqual(statement);
  };
  test("N in front of the number, and the skip mark on either side of it", () =>
    fc.assert(
      fc.property(statements.filter(isPlain), numbered, fc.constantFrom("", "/", "behind"), (statement, head, mark) => {
        const bare = statementLines(statement, style).join("\n");
        const text = `${mark === "/" ? "/" : ""}${head}${mark === "behind" ? "/ " : ""}${bare}`;
        same(text, statement, Number(head.trim().replace(/^n/i, "")), mark !== "");
      }),
      { numRuns: 800 },
    ));
  test("CYCLE DEF, CYCLDEF, and the point of an older cycle with blanks", () =>
    fc.assert(
      fc.property(
        statements.filter((s) => s.kind === "cycle" || s.kind === "cycleLine"),
        fc.constantFrom("CYCLE DEF ", "CYCL  DEF ", "cycl def ", "CYCLDEF "),
        fc.boolean(),
        (statement, word, wide) => {
          const text = blockText(7, statement, style).replace("CYCL DEF ", word);
          const spaced = statement.kind === "cycleLine" && wide ? text.replace(/(\d+)\.(\d)/, "$1 .$2") : text;
          same(spaced, statement, 7, false);
        },
      ),
      { numRuns: 400 },
    ));
  test("a coordinate without L", () =>
    fc.assert(
      fc.property(
        statements.filter((s) => s.kind === "path" && s.path === "L" && s.words.axes.length > 0),
        number4,
        (statement, n) =>
          same(`${n} ${statementLines(statement, style).join("").replace(/^L +/, "")}`, statement, n, false),
      ),
      { numRuns: 500 },
    ));
  test("the areas of a contour on lines of their own", () =>
    fc.assert(
      fc.property(
        statements.filter((s) => s.kind === "contourDefinition"),
        (statement) => {
          if (statement.kind !== "contourDefinition") return;
          const areas = statement.areas.map((area) =>
            statementLines({ kind: "contourDefinition", areas: [area] }, style)
              .join("")
              .replace("CONTOUR DEF", ""),
          );
          same(`5 CONTOUR DEF ~\n${areas.join(" ~\n")}\n`, statement, 5, false);
        },
      ),
      { numRuns: 300 },
    ));
});
