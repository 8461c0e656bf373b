import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { readEntry, type ToolEntry } from "../tools/tool-entry.ts";
import { fillingOf, isWholeCode, nameOfCodes } from "./code-cells.ts";
import { readToolCodes } from "./tool-code.ts";

const row = (cells: ToolEntry["cells"] = { T: "21", TYPE: "ROUGH", TO: "1", RS: "0.1" }): ToolEntry => ({
  id: "r",
  cells,
});
const read = (text: string, entry = row()) => {
  const { cells, notes } = fillingOf(readToolCodes(text), entry);
  return {
    cells: Object.fromEntries(cells.map(({ cell, to }) => [cell, to])),
    notes: notes.map(({ is }) => is),
  };
};
const pitches = (text: string) => {
  const meaning = readToolCodes(text).maker?.parts.find(({ name }) => name === "pitch")?.meaning;
  return meaning?.is === "pitches" ? [meaning.from, meaning.to, meaning.inch ? "tpi" : "mm"] : null;
};

describe("thread inserts", () => {
  test.each([
    ["16ER AG60", "2", "60", [0.5, 3, "mm"]],
    ["16 ER AG 60", "2", "60", [0.5, 3, "mm"]],
    ["16IR-AG55", "6", "55", [48, 8, "tpi"]],
    ["11IRA60", "6", "60", [0.5, 1.5, "mm"]],
    ["22ER N60", "2", "60", [3.5, 5, "mm"]],
    ["16EL G60", "2", "60", [1.75, 3, "mm"]],
    ["16IL G55", "6", "55", [14, 8, "tpi"]],
    ["27ER Q60", "2", "60", [5.5, 6, "mm"]],
    ["16ER 1.50 ISO", "2", "60", [1.5, 1.5, "mm"]],
    ["16ER1.5ISO IC908", "2", "60", [1.5, 1.5, "mm"]],
    ["16ER100ISO", "2", "60", [1, 1, "mm"]],
    ["16 IR 2.0 ISO", "6", "60", [2, 2, "mm"]],
    ["16ERM 1.75 ISO", "2", "60", [1.75, 1.75, "mm"]],
    ["16ER 14W", "2", "55", [14, 14, "tpi"]],
    ["16IR 11 BSPT", "6", "55", [11, 11, "tpi"]],
    ["16ER 14 NPT", "2", "60", [14, 14, "tpi"]],
    ["16ER 11.5NPTF", "2", "60", [11.5, 11.5, "tpi"]],
    ["22ER 5.0 TR", "2", "30", [5, 5, "mm"]],
    ["16IR 4.0TR", "6", "30", [4, 4, "mm"]],
    ["16ER 20UN", "2", "60", [20, 20, "tpi"]],
    ["16ER 8 ACME", "2", "29", [8, 8, "tpi"]],
    ["16ER 10 RND", "2", "30", [10, 10, "tpi"]],
    ["16ER 1.0 MJ", "2", "60", [1, 1, "mm"]],
  ])("%s", (text, TO, angle, pitch) => {
    expect(read(text)).toMatchObject({ cells: { TYPE: "THREAD", TO, "P-ANGLE": angle }, notes: ["cornerMissing"] });
    expect(pitches(text)).toEqual(pitch);
  });
  test("a profile with two flank angles leaves P-ANGLE, one for both sides leaves TO", () => {
    expect(read("16ER 2.0 SAGE")).toMatchObject({ cells: { TYPE: "THREAD", TO: "2" } });
    expect(read("16ER 2.0 SAGE").notes).toContain("flanksDiffer");
    expect(read("16ER 2.0 SAGE").cells).not.toHaveProperty("P-ANGLE");
    expect(read("22UEIRL U60").cells).not.toHaveProperty("TO");
  });
  test.each([
    ["SER 2020 K16", "2"],
    ["SEL 2525M16", "2"],
    ["SIR 0020P16", "6"],
    ["SIR0016 M11", "6"],
  ])("holder %s", (text, TO) =>
    expect(read(text)).toMatchObject({ cells: { TYPE: "THREAD", TO }, notes: ["holderUnplaced"] }),
  );
});

describe("groove and part-off inserts", () => {
  test.each([
    ["N123H2-0400-0004-TF", "RECESS", "4", "0.4", []],
    ["N123G2-0300-0002-CM 1125", "RECESS", "3", "0.2", []],
    ["L123G2-0300-0502-CM", "RECESS", "3", "0.2", ["frontAngle"]],
    ["DGN 3102J IC908", "RECESS", "3.1", "0.2", []],
    ["DGN 2202C", "RECESS", "2.2", "0.2", []],
    ["DGR 3102C-6D", "RECESS", "3.1", "0.2", ["frontAngle"]],
    ["GRIP 3002Y", "RECTURN", "3", "0.2", []],
    ["GRIP 6008Y", "RECTURN", "6", "0.8", []],
    ["HFPL 6004", "RECTURN", "6", "0.4", []],
    ["GIP 3.00E-0.40", "RECTURN", "3", "0.4", ["unverified"]],
    ["LCMF 031304-CM", "RECTURN", "3", "0.4", []],
    ["LCMF 041604", "RECTURN", "4", "0.4", []],
    ["TDT 4E-0.4", "RECTURN", "4", "0.4", ["unverified"]],
    ["TDC 3", "RECESS", "3", null, ["cornerMissing", "unverified"]],
    ["TDJ 3-6R", "RECESS", "3", null, ["cornerMissing", "frontAngle", "unverified"]],
    ["MGMN200-G", "RECTURN", "2", null, ["cornerMissing", "unverified"]],
    ["MGMN 150", "RECTURN", "1.5", null, ["cornerMissing", "unverified"]],
    ["MGGN300-L", "RECTURN", "3", null, ["cornerMissing", "unverified"]],
    ["MGEHR 2020-3", "RECTURN", "3", null, ["cornerMissing", "holderUnplaced", "unverified"]],
    ["MGIVR2016-2", "RECTURN", "2", null, ["cornerMissing", "holderUnplaced", "unverified"]],
  ])("%s", (text, TYPE, CUTWIDTH, RS, notes) => {
    const made = read(text);
    expect(made).toMatchObject({ cells: { TYPE, CUTWIDTH, ...(RS !== null && { RS }) }, notes });
    if (RS === null) expect(made.cells).not.toHaveProperty("RS");
  });
  test.each([
    ["MRMN300-M", "1.5"],
    ["MRMN 400", "2"],
    ["N123H2-0400-RO", "2"],
    ["N123F2-0300-RM", "1.5"],
  ])("%s is a full radius", (text, RS) => {
    expect(read(text)).toMatchObject({ cells: { TYPE: "BUTTON", RS } });
    expect(read(text).notes).toContain("fullRadius");
  });
  test("a row of a fitting type keeps it; a blade is sound at once", () => {
    const entry = row({ T: "9", TYPE: "RECTURN", TO: "2", RS: "0.2" });
    expect(read("DGN 3102J", entry).cells).not.toHaveProperty("TYPE");
    const cells = { ...entry.cells, ...read("DGN 3102J", entry).cells };
    expect(readEntry({ id: "r", cells }).tool).toMatchObject({ TYPE: "RECTURN", CUTWIDTH: 3.1, RS: 0.2 });
  });
});

test("each code names the tool, its parts name the makers, and its name is the same code again", () => {
  for (const text of [
    "16ER AG60",
    "16IR 2.0 ISO",
    "SER 2020 K16",
    "DGN 3102J",
    "N123H2-0400-0004",
    "MGMN300-M",
    "TDC 3",
  ]) {
    const codes = readToolCodes(text);
    const name = nameOfCodes(codes);
    expect(name).toMatch(/^[A-Z0-9.-]+$/);
    expect(codes.maker?.parts.at(-1)?.name).toBe("source");
    expect(isWholeCode(readToolCodes(name)) && nameOfCodes(readToolCodes(name))).toBe(name);
  }
});

test("no text makes it throw, and no width is absurd", () =>
  fc.assert(
    fc.property(
      fc.oneof(
        fc.string(),
        fc.stringMatching(/^(16|22)[EI][RL] ?[AGNQU0-9.]{1,5}(60|55|ISO|W|TR)?$/),
        fc.stringMatching(/^(DGN|MGMN|N123H2|TDC|LCMF|GIP) ?[0-9.-]{1,10}[A-Z]{0,2}$/),
      ),
      (text) => {
        const { cells } = read(text);
        const width = cells["CUTWIDTH"];
        if (width !== undefined && readToolCodes(text).maker)
          expect(Number(width) > 0 && Number(width) <= 20).toBe(true);
      },
    ),
    { numRuns: 500, seed: 42 },
  ));
