import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { areaOf } from "../../kernel/area/area.ts";
import { intersection } from "../../kernel/area/clip.ts";
import { holderOutlines } from "../../kernel/cutter/holder.ts";
import { insertOutline, insertShape } from "../../kernel/cutter/insert.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { CellName } from "../tools/tool-columns.ts";
import { readEntry, type ToolEntry } from "../tools/tool-entry.ts";
import { fillingOf, isWholeCode } from "./code-cells.ts";
import { readToolCodes } from "./tool-code.ts";

const row = (cells: ToolEntry["cells"] = { T: "21", TYPE: "ROUGH", TO: "1" }): ToolEntry => ({ id: "r", cells });
const filled = (text: string, entry = row()) =>
  Object.fromEntries(fillingOf(readToolCodes(text), entry).cells.map(({ cell, to }) => [cell, to])) as Partial<
    Record<CellName, string>
  >;
const notes = (text: string, entry = row()) => fillingOf(readToolCodes(text), entry).notes.map((note) => note.is);
const taken = (text: string, entry = row()): ToolEntry => ({
  ...entry,
  cells: { ...entry.cells, ...filled(text, entry) },
});

describe("inserts", () => {
  test.each([
    ["DNMG 15 06 08", "DNMG150608", 55, 15.5, 0.8],
    ["dnmg150608-pm", "DNMG150608", 55, 15.5, 0.8],
    ["  D-N-M-G 15.06.08".replaceAll(".", " "), "DNMG150608", 55, 15.5, 0.8],
    ["CNMG 12 04 08", "CNMG120408", 80, 12.9, 0.8],
    ["CNMG 16 06 12 EN", "CNMG160612", 80, 16.12, 1.2],
    ["VBMT160404", "VBMT160404", 35, 16.61, 0.4],
    ["VCGT 110302FN-ALU", "VCGT110302", 35, 11.07, 0.2],
    ["CCMT 09T304", "CCMT09T304", 80, 9.67, 0.4],
    ["CCMT 0602 04", "CCMT060204", 80, 6.45, 0.4],
    ["DCMT 11T3 08-F1", "DCMT11T308", 55, 11.63, 0.8],
    ["DCMT070202", "DCMT070202", 55, 7.75, 0.2],
    ["TNMG 160408", "TNMG160408", 60, 16.5, 0.8],
    ["TPMR 220412", "TPMR220412", 60, 22, 1.2],
    ["WNMG 080412-WPP20S", "WNMG080412", 80, 8.69, 1.2],
    ["WNMG 06T304", "WNMG06T304", 80, 6.52, 0.4],
    ["SNMG 190616", "SNMG190616", 90, 19.05, 1.6],
    ["ENMG 130408", "ENMG130408", 75, 13.15, 0.8],
    ["KNUX 160405R11", "KNUX160405", 55, 16, 0.5],
    ["DNGA 150600", "DNGA150600", 55, 15.5, 0],
    ["CNMG 432", "CNMG432", 80, 12.9, 0.8],
    ["cnmg-643", "CNMG643", 80, 19.34, 1.2],
    ["CCMT 32.51", "CCMT32.51", 80, 9.67, 0.4],
    ["CCMT 21.50.5", "CCMT21.50.5", 80, 6.45, 0.2],
    ["DNMG 442WPP20S", "DNMG442", 55, 15.5, 0.8],
  ])("%s", (text, code, angle, edge, corner) => {
    const { insert, holder } = readToolCodes(text);
    expect(insert).toMatchObject({ code, angle, edge, corner });
    expect(holder).toBeNull();
    const cells = filled(text);
    expect(cells).toMatchObject({ NAME: code, "P-ANGLE": String(angle), CUTLENGTH: String(edge), RS: String(corner) });
    expect(Object.keys(cells).sort()).toEqual(["CUTLENGTH", "NAME", "P-ANGLE", "RS"]);
  });

  test.each([
    ["RCMT 10T3M0", 5],
    ["RCMT1204MO-RH", 6],
    ["RNMG 120400", 6.35],
    ["rcmt 0602M0", 3],
    ["RNMG 43", null],
  ])("%s is round", (text, RS) => {
    const cells = filled(text);
    expect(cells.TYPE).toBe("BUTTON");
    expect(cells["P-ANGLE"]).toBeUndefined();
    if (RS !== null) expect(cells.RS).toBe(String(RS));
  });

  test("each place says what it means", () => {
    expect(
      readToolCodes("TNMG 16 04 08 EN-M5").insert?.parts.map(({ name, text, meaning }) => [name, text, meaning]),
    ).toEqual([
      ["shape", "T", { is: "form", form: "triangle", angle: 60 }],
      ["clearance", "N", { is: "angle", angle: 0 }],
      ["tolerance", "M", { is: "tolerance", from: 0.05, to: 0.15, thickness: 0.13 }],
      ["type", "G", { is: "type", hole: "plain", breaker: "both" }],
      ["edge", "16", { is: "mm", mm: 16.5 }],
      ["thickness", "04", { is: "mm", mm: 4.76 }],
      ["corner", "08", { is: "mm", mm: 0.8 }],
      ["finish", "E", { is: "finish", finish: "E" }],
      ["direction", "N", { is: "hand", hand: "N" }],
      ["maker", "M5", { is: "nothing" }],
    ]);
    expect(readToolCodes("SPKN 1203EDR").insert?.parts[6]).toMatchObject({
      text: "ED",
      meaning: { is: "wiper", angle: 75 },
    });
  });

  test("an unknown letter is reported, and the others still fill", () => {
    const { insert } = readToolCodes("DQMG 15 06 08");
    expect(insert?.parts.find((part) => part.meaning === null)).toMatchObject({ name: "clearance", text: "Q" });
    expect(filled("DQMG 15 06 08")).toMatchObject({ "P-ANGLE": "55", RS: "0.8" });
    expect(isWholeCode(readToolCodes("DQMG 15 06 08"))).toBe(false);
    expect(isWholeCode(readToolCodes("DNMG 15 06 08"))).toBe(true);
    expect(isWholeCode(readToolCodes("DNMG 1506"))).toBe(false);
  });

  test("a size without a usual circle is read by its digits, and reported", () => {
    expect(filled("DNMG 120408").CUTLENGTH).toBe("12");
    expect(notes("DNMG 120408")).toContain("sizeUnsure");
    expect(notes("DNMG 150608")).toEqual([]);
  });
});

describe("holders", () => {
  test.each<[string, Partial<Record<CellName, string>>]>([
    ["PDJNR 2525M15", { "T-ANGLE": "93", TO: "1", width: "25", offsetZ: "7" }],
    ["pdjnl2525m15", { "T-ANGLE": "93", TO: "3", width: "25", offsetZ: "-7" }],
    ["PCLNR 2020K12", { "T-ANGLE": "95", width: "20", offsetZ: "5" }],
    ["SVJBR 2525 M 16-B", { "T-ANGLE": "93", width: "25", offsetZ: "7" }],
    ["MTJNR3232P22", { "T-ANGLE": "93", width: "32", offsetZ: "8" }],
    ["SDNCN 2020K11", { "T-ANGLE": "62.5", TO: "2", width: "20", offsetZ: "-10" }],
    ["SVVBN 2525M16", { "T-ANGLE": "72.5", TO: "2", width: "25", offsetZ: "-12.5" }],
    ["A25R-SCLCR09", { "T-ANGLE": "95", TO: "7", width: "25", offsetX: "-4.5" }],
    ["S20S-PDUNR 11", { "T-ANGLE": "93", TO: "7", width: "20", offsetX: "-3" }],
    ["A16Q SCLCL 09", { "T-ANGLE": "95", TO: "7", width: "16", offsetX: "-3" }],
    ["E16R-SDQCR07-R", { "T-ANGLE": "107.5", TO: "7", width: "16" }],
    ["PSBNR 2525M12", { "T-ANGLE": "75", TO: "1" }],
  ])("%s", (text, cells) => {
    const found = { TO: "1", ...filled(text) };
    expect(found).toMatchObject(cells);
    if (cells.width === undefined) expect(found.width).toBeUndefined();
  });

  test("the length of the code is head and shank together", () => {
    for (const [text, all, place] of [
      ["PDJNR 2525M15", 150, "offsetX"],
      ["A20Q-SCLCR09", 180, "offsetZ"],
    ] as const) {
      const cells = filled(text);
      expect(Number(cells.length) + Number(cells[place])).toBe(all);
    }
  });

  test("facts alone are filled: shape and edge only where the row has none, the name only where there is none", () => {
    const entry = row({ T: "5", NAME: "MINE", TYPE: "FINISH", TO: "1", RS: "1.2", "P-ANGLE": "55", CUTLENGTH: "15.5" });
    expect(Object.keys(filled("PDJNR 2525M15", entry)).sort()).toEqual([
      "T-ANGLE",
      "head",
      "length",
      "offsetX",
      "offsetZ",
      "width",
    ]);
    expect(notes("PDJNR 2525M15", entry)).toEqual(["headDrawn"]);
    expect(notes("PCLNR 2525M12", entry)).toEqual(["rowAngle", "rowEdge", "headDrawn"]);
    expect(filled("PDJNR 2525M15")).toMatchObject({ NAME: "PDJNR2525M15", "P-ANGLE": "55", CUTLENGTH: "15.5" });
    expect(filled("DNMG 150608", entry)).toEqual({ RS: "0.8" });
  });

  test("another code renames a row that has its name from a code, and no name that was typed", () => {
    const named = (NAME: string) => row({ T: "5", NAME, TYPE: "ROUGH", TO: "1" });
    expect(filled("CNMG120408", named("DNMG150608")).NAME).toBe("CNMG120408");
    expect(filled("DNMG150608", named("PDJNR2525M15")).NAME).toBe("DNMG150608");
    expect(filled("PCLNR 2525M12", named("PDJNR2525M15")).NAME).toBe("PCLNR2525M12");
    expect(filled("PDJNR 2525M15", named("DNMG150608")).NAME).toBeUndefined();
    expect(filled("CNMG120408", named("ROUGHER 1")).NAME).toBeUndefined();
  });

  test("contradictions between holder and insert are reported", () => {
    expect(notes("DNMG 150608 PCLNR 2525M12")).toContain("shapesDiffer");
    expect(notes("DNMG 110408 + PDJNR 2525M15")).toContain("sizesDiffer");
    expect(notes("DCMT 11T304, PDJNR 2525M11")).toContain("clearancesDiffer");
    expect(notes("PDJNR 2525M15 DNMG 150608")).toEqual(["headDrawn"]);
    expect(readToolCodes("PDJNR 2525M15 DNMG 150608 E-PM").insert?.code).toBe("DNMG150608");
  });

  test.each([
    ["PSKNR 2525M12", "endCutting"],
    ["PDUNR 2525M15", "endCutting"],
    ["PSBNR 2525M12", "noShank"],
    ["PCLNR 2230M12", "noShank"],
    ["PDHNR 2525M15", "unsure"],
    ["S25T-PCLNL12", "leftBar"],
    ["DCLNR 164D", "inchHolder"],
    ["DCLNL 16 4D", "inchHolder"],
    ["PXLNR 2525M12", "noShank"],
  ])("%s: %s", (text, note) => {
    if (text === "PXLNR 2525M12")
      expect(readToolCodes(text).holder?.parts.find((part) => part.meaning === null)?.text).toBe("X");
    else expect(notes(text)).toContain(note);
  });
});

test.each([
  ["16ER 99XYZ", "thread"],
  ["44ER AG60", "thread"],
  ["LTER 2525 16", "thread"],
  ["GTN-3", "groove"],
  ["SP300", "groove"],
  ["N151.2-300-30-4G", "groove"],
  ["GX 24-3", "groove"],
  ["hello world", "unknown"],
  ["4711", "unknown"],
])("%s is not covered: %s", (text, why) => {
  expect(readToolCodes(text)).toEqual({ insert: null, holder: null, notCovered: why });
  expect(fillingOf(readToolCodes(text), row())).toEqual({ cells: [], notes: [] });
});

/** Distance of a corner behind the nearest cutting edge, with the edges extended indefinitely. */
const behindEdges = (tool: Tool, p: Pt) =>
  Math.min(
    ...insertShape(tool).flatMap((e) => {
      if (e.kind !== "line" || (e.feature !== "mainEdge" && e.feature !== "secondaryEdge")) return [];
      const [u, v] = [e.to.u - e.from.u, e.to.v - e.from.v];
      return [(u * (p.r - e.from.v) - v * (p.z - e.from.u)) / Math.hypot(u, v)];
    }),
  );

describe("a tool made of two codes", () => {
  const pairs = ["DNMG 150608", "DNMG 150616", "DNMG 110404"]
    .flatMap((insert) =>
      ["PDJNR 2525M15", "PDJNL 2020K15", "PDNNN 3232P15", "S40V-PDUNR15", "A25R-PDUNL 11"].map((holder) => [
        insert,
        holder,
      ]),
    )
    .concat([
      ["CNMG 120408", "PCLNR 2525M12"],
      ["CCMT 060202", "A12K-SCLCR06"],
      ["CCMT 09T308", "A25R-SCLCR09"],
      ["VBMT 160404", "SVJBR 2525M16"],
      ["VCMT 160412", "SVVCN 2020K16"],
      ["WNMG 080412", "PWLNL 2525M08"],
      ["TNMG 160404", "PTGNR 2020K16"],
      ["SNMG 120416", "PSDNN 2525M12"],
      ["DCMT 070204", "E16R-SDQCR07"],
      ["SCMT 120408", "S32T-PSKCR12"],
    ]) as [string, string][];

  test.each(pairs)("%s in %s can be drawn and has a head behind its edges", (insert, holder) => {
    const { tool, issues } = readEntry(taken(`${insert} ${holder}`));
    expect(issues.filter((issue) => issue.severity === "error")).toEqual([]);
    const drawn = tool as Tool;
    expect(drawn.holder).toBeDefined();
    const [head, shank] = holderOutlines(drawn) as [Ring, Ring];
    for (const p of head) expect(behindEdges(drawn, p)).toBeGreaterThan(0.3);
    expect(areaOf(intersection([head], [insertOutline(drawn, 1e-3)]))).toBeGreaterThan(1);
    const touches = shank.some((p) => head.some((q) => Math.abs(p.z - q.z) < 0.051 && Math.abs(p.r - q.r) < 0.051));
    expect(touches || areaOf(intersection([head], [shank])) > 0.01).toBe(true);
    expect(Math.min(...shank.map((p) => (drawn.TO === 7 ? p.z : p.r)))).toBeGreaterThan(3);
  });

  test("a round insert in a neutral holder", () => {
    const { tool } = readEntry(taken("RCMT 1204M0 SRDCN 2525M12", row({ T: "1" })));
    expect(tool).toMatchObject({ TYPE: "BUTTON", RS: 6, TO: 2, holder: { width: 25, offsetZ: -12.5 } });
    expect(
      areaOf(intersection([holderOutlines(tool as Tool)[0] as Ring], [insertOutline(tool as Tool, 1e-3)])),
    ).toBeGreaterThan(1);
  });

  test("a left-hand holder is the mirror image of the right-hand one", () => {
    const [right, left] = ["R", "L"].map((hand) => filled(`PDJN${hand} 2525M15`));
    const corners = (head = "") => head.split(" ").map((corner) => corner.split("/").map(Number));
    expect(corners(left?.head).map(([z, x]) => [-(z ?? 0) + 0, x])).toEqual(corners(right?.head));
  });

  test("inserts lie as their holders hold them", () => {
    const most = (text: string, of: (p: Pt) => number) =>
      Math.max(...insertOutline(readEntry(taken(text)).tool as Tool, 1e-3).map(of));
    // 93° and 95° are beyond square: no part of the insert is ahead of the tip towards the chuck.
    expect(most("DNMG 150608 PDJNR 2525M15", (p) => -p.z)).toBeCloseTo(0, 3);
    expect(most("CCMT 09T304 A25R-SCLCR09", (p) => p.r)).toBeCloseTo(0, 3);
    // A 75° edge leads its tip.
    expect(most("SNMG 120408 PSBNR 2525M12", (p) => -p.z)).toBeGreaterThan(3);
  });
});

test("nothing typed makes it throw, and what it fills can be read", () =>
  fc.assert(
    fc.property(
      fc.oneof(
        fc.string(),
        fc.stringMatching(/^[A-Z]{4,5} ?[0-9T]{2,6}[A-Z0-9 -]{0,6}$/),
        fc.stringMatching(/^[SAE][0-9]{2}[A-Y]-[CDMPS][A-Z]{4}[0-9]{2}$/),
        fc.stringMatching(
          /^[CDMPS][ABCDEHKLMOPRSTVW][A-Y][ABCDNP][RLN] ?(1616|2020|2525|3232)[A-Y](06|09|11|12|15|16)$/,
        ),
      ),
      (text) => {
        const entry = taken(text);
        const wrong = readEntry(entry).issues.filter(
          (issue) => issue.severity === "error" && issue.code !== "toolColumn",
        );
        expect(
          wrong.filter((issue) => issue.at === "head" || issue.at === "width" || issue.code === "notANumber"),
        ).toEqual([]);
      },
    ),
    { numRuns: 2000 },
  ));
