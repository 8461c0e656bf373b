import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { simulate } from "../../sim/simulate.ts";
import { length, toDiameter } from "../../kernel/units.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const lines = (...blocks: string[]) =>
  ["0 BEGIN PGM T MM", ...blocks, "M30", "END PGM T MM"].map((b, i) => `${i === 0 ? "" : `${i} `}${b}`).join("\n");
const shop = { tools: shippedTools, rapid: 10_000 };
function cut(...blocks: string[]) {
  const done = run(parse(lines(...blocks)), shop);
  const { final } = simulate(done);
  const has = (x: number, z: number) =>
    final.flat().some((p) => Math.abs(toDiameter(p.r) - x) < 0.01 && Math.abs(p.z - z) < 0.03);
  return { done, has, codes: done.issues.map((f) => f.issue.code) };
}
const frame = [
  "BLK FORM CYLINDER Z D50 L60 DIST+0",
  "FUNCTION MODE TURN",
  "TOOL CALL 3",
  "FUNCTION TURNDATA SPIN VCONST:OFF S900",
  "M136",
];

test("a correction offsets the insert from the programmed tip, adds up over both systems, and ends with the tool call", () => {
  // Tool 3 has a nose radius of 0.4 mm: it leaves the cylinder where its nose begins, 0.4 mm before the shoulder.
  const { done, has, codes } = cut(
    ...frame,
    "FUNCTION TURNDATA CORR-TCS:Z/X DZL:0.1 DXL:0.25",
    "L X+40 Z+2 R0 FMAX",
    "L Z-20 F0.2",
    "L X+52",
    "L X+80 Z+30 FMAX",
    "FUNCTION TURNDATA CORR-WPL:Z/X DXL:-0.05",
    "L X+46 Z-19 FMAX",
    "L Z-25 F0.2",
    "L X+52",
    "L X+80 Z+30 FMAX",
    "TOOL CALL 4",
    "L X+48 Z-24 FMAX",
    "L Z-30 F0.2",
    "L X+60",
  );
  expect([has(40.5, -19.5), has(46.4, -24.5), has(48, -29.6)]).toEqual([true, true, true]);
  expect(done.steps[0]?.move.to).toEqual({ z: -20, r: 20 });
  expect(codes.filter((c) => c === "wordsRecalled").length).toBe(2);
});

test("a correction needs a tool, and its words a value", () => {
  expect(cut("FUNCTION MODE TURN", "FUNCTION TURNDATA CORR-TCS:Z/X DZL:0.1").codes).toContain("noToolCalled");
  expect(cut(...frame, "FUNCTION TURNDATA CORR-TCS:Z/X DZL:Q5").codes).toContain("parameterUnset");
});

test.each([
  ["FUNCTION TURNDATA CORR OFF", 40],
  ["FUNCTION CORRDATA RESET #TCS", 40],
  ["CORRDATA RESET", 40],
  ["FUNCTION CORRDATA RESET #WPL", 40.5],
])("%s resets the correction of its system and moves no axis", (reset, left) => {
  const { done, has } = cut(
    ...frame,
    "FUNCTION TURNDATA CORR-TCS:Z/X DXL:0.25",
    reset,
    "L X+40 Z+2 R0 FMAX M303",
    "L Z-20 F0.2",
    "L X+52",
  );
  expect(has(left, -19.6)).toBe(true);
  expect(done.unproved).toEqual([]);
});

describe("an index of a tool", () => {
  const indexed = { ...(shippedTools[2] as (typeof shippedTools)[number]), T: 3.1 };
  const mills = [{ T: 20, NAME: "END10", R: 5, DR: 0 }];
  const told = (call: string, mode = "TURN", before = "") =>
    run(
      parse(lines("BLK FORM CYLINDER Z D50 L60 DIST+0", before, `FUNCTION MODE ${mode}`, call, "L X+60 Z+5 R0 FMAX")),
      {
        tools: [...shippedTools, indexed],
        mills,
        rapid: 10_000,
      },
    ).issues.flatMap<unknown>(({ issue }) =>
      issue.code === "toolIndexUnknown" ? [issue.data] : issue.code === "toolUnknown" ? [issue.code] : [],
    );
  test("is a row of its own", () => {
    expect(told("TOOL CALL 3.1")).toEqual([]);
    expect(told("TOOL CALL 3.2")).toEqual([{ tool: "3.2", rows: ["3", "3.1"] }]);
    expect(told("TOOL CALL 77.2")).toEqual([{ tool: "77.2", rows: [] }]);
    expect(told("TOOL CALL 77")).toEqual(["toolUnknown"]);
  });
  test("of a mill is reported where the tables have that tool; an unknown tool is machine-specific", () => {
    expect(told("TOOL CALL 20.1", "MILL")).toEqual([{ tool: "20.1", rows: ["20"] }]);
    expect(told("TOOL CALL 20", "MILL")).toEqual([]);
    expect(told("TOOL CALL 77.1", "MILL")).toEqual([]);
    expect(told("TOOL CALL 20.1", "MILL", "TOOL DEF 20.1 L+0 R+4")).toEqual([]);
  });
});

test("DYL is off the turning plane: unverified unless it is 0", () => {
  const told = (DYL: number) => {
    const tools = shippedTools.map((t) => (t.T === 3 ? { ...t, DYL: length(DYL) } : t));
    const text = lines(...frame, "L X+40 Z+2 R0 FMAX M3", "L Z-20 F0.2", "L X+80 Z+30 FMAX");
    return run(parse(text), { tools, rapid: 10_000 }).unproved.map((u) => u.what);
  };
  expect([told(-0.037), told(0)]).toEqual([["DYL"], []]);
});

const casting = ['LBL "CASTING"', "L X+0 Z+1", "L X+58", "L X+72 Z-9", "L Z-60", "L X+0", "LBL 0"];
const withBlank = (blank: string, ...turnData: string[]) =>
  run(
    parse(
      [
        "BEGIN PGM T MM",
        blank,
        "FUNCTION MODE TURN",
        "TOOL CALL 3",
        ...turnData,
        "M30",
        ...casting,
        "END PGM T MM",
      ].join("\n"),
    ),
    shop,
  );

test("FUNCTION TURNDATA BLANK gives the stock where BLK FORM gives none", () => {
  const own = withBlank(
    "BLK FORM 0.1 Z X+0 Y+0 Z-20",
    'FUNCTION TURNDATA BLANK LBL "CASTING"',
    "FUNCTION TURNDATA BLANK OFF",
  );
  expect(
    own.blank
      .flat()
      .map((p) => toDiameter(p.r))
      .sort((a, b) => a - b),
  ).toEqual([0, 0, 58, 72, 72]);
  expect(own.issues.map((f) => f.issue.code)).toEqual(["blankTraced", "blankTaken"]);
  const given = withBlank("BLK FORM CYLINDER Z D80 L60", 'FUNCTION TURNDATA BLANK LBL "CASTING"');
  expect(Math.max(...given.blank.flat().map((p) => p.r))).toBe(36);
  expect(given.issues.map((f) => f.issue.code)).toEqual(["blankTraced", "blankLacks", "notProved", "blankAdds"]);
});

test("a blank or a contour in another file is reported where it is named and where it is needed", () => {
  expect(
    withBlank("BLK FORM CYLINDER Z D80 L60", 'FUNCTION TURNDATA BLANK "CAST.H"').issues.map((f) => f.issue),
  ).toMatchObject([
    {
      code: "programNotOpened",
      data: { file: "CAST.H" },
    },
    {
      code: "notProved",
      severity: "warning",
    },
    { code: "neverReached", data: { by: "M30" } },
  ]);
  const contour = run(
    parse(
      lines(
        ...frame,
        'SEL CONTOUR "PART.H"',
        "CYCL DEF 820 TURN CONTOUR TRANSV. ~\nQ215=+0 ~\nQ460=+2",
        "L X+60 Z+2 R0 FMAX",
        "CYCL CALL",
      ),
    ),
    shop,
  ).issues.map((f) => f.issue);
  expect(contour).toMatchObject([
    { code: "notSimulated", data: { what: 'SEL CONTOUR "PART.H"' } },
    ...contour.slice(1, -1).map(() => ({})),
    {},
  ]);
  expect(contour.some((i) => i.code === "contourInFile" && i.severity === "error")).toBe(true);
  expect(contour.some((i) => i.code === "contourNotNamed")).toBe(false);
});
