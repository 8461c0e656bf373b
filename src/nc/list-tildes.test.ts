import { describe, expect, test } from "vitest";
import { parse } from "./parse.ts";
import { issuesOf, print } from "./program.ts";
import { withListTildes } from "./list-tildes.ts";

const findingsOf = (text: string) =>
  issuesOf(parse(`BEGIN PGM A MM\n${text}END PGM A MM\n`))
    .filter((i) => i.code === "listWithoutTilde")
    .map((i) => [i.line - 1, i.column, i.data]);
const withTildes = (text: string) => print(withListTildes(parse(text)));

describe("a list of a cycle without ~", () => {
  test.each([
    [
      "11 CYCL DEF 811  X\nQ215=+0 ;A\nQ460=+2.3 ;B\n",
      [[1, 19, { places: 1 }]],
      "11 CYCL DEF 811  X ~\nQ215=+0 ;A ~\nQ460=+2.3 ;B\n",
    ],
    // One line alone lacks it, with blanks behind, and CR LF.
    [
      "CYCL DEF 200 B ~\r\n  Q200=-2.75 ;C  \r\n  Q201=-18\r\n",
      [[2, 16, { places: 1 }]],
      "CYCL DEF 200 B ~\r\n  Q200=-2.75 ;C ~\r\n  Q201=-18\r\n",
    ],
    // A printed misprint stays: it has its own finding.
    [
      "7 CYCL DEF 852  E\nQ491=+75\nQ493+50 ;F\n",
      [[1, 18, { places: 1 }]],
      "7 CYCL DEF 852  E ~\nQ491=+75 ~\nQ493+50 ;F\n",
    ],
    // A label wrapped by copying a page is on one line again.
    [
      "7 CYCL DEF 200 DRILL\nQ200=+2 ;SET-UP\nCLEARANCE\nQ201=-5.5\n",
      [[1, 21, { places: 1 }]],
      "7 CYCL DEF 200 DRILL ~\nQ200=+2 ;SET-UP CLEARANCE ~\nQ201=-5.5\n",
    ],
  ])("%j is reported where it begins, and fixed", (text, places, whole) => {
    expect(findingsOf(text)).toEqual(places);
    expect(withTildes(text)).toBe(whole);
    expect(findingsOf(withTildes(text))).toEqual([]);
    expect(parse(withTildes(text)).blocks[0]?.statement).toEqual(parse(text).blocks[0]?.statement);
  });

  test("all lists of a program are one finding, at the first, and one fix", () => {
    const text =
      "1 CYCL DEF 811 A\nQ215=+0\n2 CYCL CALL\n3 CYCL DEF 812 B ~\nQ215=+1\n4 CYCL DEF 821 C\nQ215=+2\nQ460=+1.5\n";
    expect(findingsOf(text)).toEqual([[1, 17, { places: 2 }]]);
    expect(findingsOf(withTildes(text))).toEqual([]);
  });

  test.each([
    "3 CYCL DEF 811 A ~\nQ215=+0 ~\nQ460=+2\n",
    "CYCL DEF 801 RESET\n",
    "CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 LABEL2\n",
    "CYCL DEF 200 Q200=+2 Q201=-3\n",
    "CYCL DEF 811 A ~\n\nQ215=+0\n",
  ])("%j has no finding and stays", (text) => {
    expect(findingsOf(text)).toEqual([]);
    expect(withTildes(text)).toBe(text);
  });
});
