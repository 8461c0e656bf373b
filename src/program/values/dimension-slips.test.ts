import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { parse } from "../../nc/parse.ts";
import { simulate } from "../../sim/simulate.ts";
import { stockIssues } from "../../sim/issues.ts";
import { firstValues } from "../../cycles/first-values.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

interface Called {
  readonly cycle: number;
  readonly change: Readonly<Record<string, number>>;
  readonly tool?: number;
  readonly blank?: string;
  readonly start?: string;
  readonly unit?: "MM" | "INCH";
}

const signed = (n: number) => (n < 0 ? String(n) : `+${n}`);

/** Findings of run and stock for one call, without notes. */
function told({ cycle: number, change, tool, blank, start, unit = "MM" }: Called) {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  const { outside, bore, length, allowance } = cycle.setup.blank;
  const scale = unit === "INCH" ? 25.4 : 1;
  const words = Object.entries({ ...firstValues(cycle), ...change }).map(([q, n]) => {
    const isLength = ["diameter", "axial", "length", "radial"].includes(cycle.params[q]?.kind ?? "");
    return `${q}=${signed(isLength ? n / scale : n)}`;
  });
  const { x, z } = cycle.setup.start;
  const lines = [
    `BEGIN PGM T ${unit}`,
    `BLK FORM CYLINDER Z ${blank ?? `D${outside} L${length} DIST${signed(Number(allowance))}${Number(bore) > 0 ? ` DI${bore}` : ""}`}`,
    "FUNCTION MODE TURN",
    `TOOL CALL ${tool ?? cycle.setup.tool}`,
    "FUNCTION TURNDATA SPIN VCONST:OFF S500",
    "M136",
    "L X+160 Z+60 R0 FMAX M303",
    `CYCL DEF ${number} NAME ~\n${words.join(" ~\n")}`,
    `L ${start ?? `X${signed(Number(x) / scale)} Z${signed(Number(z) / scale)}`} FMAX`,
    "CYCL CALL",
    "M30",
    `END PGM T ${unit}`,
  ];
  const ran = run(parse(`${lines.map((line, i) => `${i} ${line}`).join("\n")}\n`), {
    tools: shippedTools,
    rapid: 10_000,
  });
  const all = [...ran.issues, ...stockIssues(simulate(ran))].map((found) => found.issue);
  return all.filter(({ severity }) => severity !== "info");
}
const codes = (called: Called) => told(called).map(({ code }) => code);
const ofType = (type: string, orientations: readonly number[]): number =>
  shippedTools.find(({ TYPE, TO }) => TYPE === type && orientations.includes(TO))?.T ?? 0;

describe("an impossible sign is questioned, and nothing else is reported for the operation", () => {
  test.each([
    [812, 55],
    [811, 55],
    [813, 55],
    [822, 15],
    [831, 15],
    [841, 50],
    [852, 50],
    [871, 10],
  ])("%i to Z+%d", (cycle, end) => {
    const found = told({ cycle, change: { Q494: end } });
    expect(found).toMatchObject([{ code: "endInFront", at: "Q494", data: { value: end, nearest: -end } }]);
  });

  test("it is an error where no path results, like the findings it replaces", () => {
    expect(told({ cycle: 812, change: { Q494: 55 } })[0]?.severity).toBe("error");
    expect(told({ cycle: 841, change: { Q494: 50 } })[0]?.severity).toBe("warning");
  });

  test("contour faults that remain either way follow it", () => {
    expect(codes({ cycle: 812, change: { Q494: 55, Q500: 500 } })).toEqual(["endInFront", "elementTooLong"]);
    expect(codes({ cycle: 872, change: { Q494: 50 } })).toEqual(["endInFront"]);
  });
});

describe("a start far in front of the blank is questioned", () => {
  test.each([
    [813, 10],
    [842, 20],
    [852, 20],
  ])("%i from Z+%d", (cycle, start) => {
    expect(told({ cycle, change: { Q492: start } })).toMatchObject([
      { code: "startInFront", at: "Q492", data: { value: start, nearest: -start } },
    ]);
  });
  test("both signs: the end first", () => {
    expect(told({ cycle: 812, change: { Q492: 20, Q494: 55 } })).toMatchObject([
      { code: "endInFront", severity: "error", at: "Q494" },
    ]);
  });
  test("cutting from the air just in front is usual", () => {
    expect(codes({ cycle: 812, change: { Q492: 4 } })).not.toContain("startInFront");
  });
});

describe("a diameter larger than the blank is named as the cause", () => {
  test("instead of a boring bar", () => {
    expect(told({ cycle: 812, change: { Q493: 96.4 } })).toMatchObject([
      { code: "diameterOutside", severity: "error", at: "Q493", data: { value: 96.4, blank: 75 } },
    ]);
  });
});

describe("a diameter far outside the blank is named as the cause", () => {
  test.each([
    [812, "Q493", 161],
    [811, "Q493", 161],
  ])("%i, %s=%d: the value, not the tool", (cycle, at, value) => {
    expect(told({ cycle, change: { [at]: value } })).toMatchObject([
      { code: "diameterOutside", severity: "error", at, data: { value, blank: 75 } },
    ]);
  });
});

describe("a start inside a solid blank is named as the cause, where no bore lets a tool in", () => {
  test.each([
    [812, 0],
    [812, 40],
    [813, 0],
    [814, 0],
    [822, 0],
  ])("%i from ⌀%d: not the tool, nor what its contour lacks", (cycle, value) => {
    expect(told({ cycle, change: { Q491: value } })).toMatchObject([
      { code: "diameterInSolid", severity: "error", at: "Q491", data: { value } },
    ]);
  });
  test("but not in a bored one, nor where another start mends nothing", () => {
    const bored = { blank: "D75 L100 DIST+0 DI30" };
    expect(codes({ cycle: 812, change: { Q491: 40 }, ...bored })).not.toContain("diameterInSolid");
    expect(codes({ cycle: 812, change: { Q491: 0, Q500: 500 } })).not.toContain("diameterInSolid");
  });
});

describe("a minus sign on a diameter is named as the cause", () => {
  test.each([
    [811, "Q493", 50, "warning"],
    [812, "Q491", 75, "error"],
    [812, "Q493", 50, "error"],
    [813, "Q493", 50, "error"],
    [821, "Q493", 30, "warning"],
    [822, "Q491", 75, "error"],
    [822, "Q493", 30, "error"],
    [823, "Q491", 75, "error"],
    [841, "Q493", 50, "warning"],
    [842, "Q491", 75, "error"],
    [851, "Q493", 50, "warning"],
    [852, "Q493", 50, "error"],
    [861, "Q493", 50, "warning"],
    [871, "Q493", 50, "warning"],
  ])("%i, %s: not what follows from -%d", (cycle, at, size, severity) => {
    expect(told({ cycle, change: { [at]: -size } })).toMatchObject([
      { code: "diameterNegative", severity, at, data: { value: -size, nearest: size } },
    ]);
  });
  test("a face may end beyond the axis", () => {
    for (const cycle of [821, 823]) expect(codes({ cycle, change: { Q493: -1.6 } })).not.toContain("diameterNegative");
  });
});

describe("an impossible order is questioned", () => {
  test.each([
    ["X", 812, { Q491: 50, Q493: 75 }, "Q491", { start: 50, end: 75, other: "Q493" }],
    ["Z", 812, { Q492: -55, Q494: 0 }, "Q492", { start: -55, end: 0, other: "Q494" }],
    ["Z", 812, { Q492: -55, Q494: -10 }, "Q492", { start: -55, end: -10, other: "Q494" }],
    ["X", 842, { Q491: 50, Q493: 75 }, "Q491", { start: 50, end: 75, other: "Q493" }],
    ["Z", 822, { Q492: -15, Q494: 0 }, "Q492", { start: -15, end: 0, other: "Q494" }],
  ])("in %s of %i", (axis, cycle, change, at, data) => {
    expect(told({ cycle, change })).toMatchObject([
      { code: "endsExchanged", severity: "error", at, data: { axis, ...data } },
    ]);
  });
});

describe("plausible values are not questioned", () => {
  test("a blank that reaches so far in front", () => {
    expect(
      codes({ cycle: 812, change: { Q492: 80, Q494: 25 }, blank: "D75 L100 DIST+80", start: "X+75 Z+82" }),
    ).toEqual([]);
    expect(
      codes({ cycle: 812, change: { Q492: 80, Q494: 95 }, blank: "D75 L100 DIST+80", start: "X+75 Z+82" }),
    ).not.toContain("endInFront");
  });
  test("a tool that works away from the chuck", () => {
    const tool = ofType("ROUGH", [3, 4, 5]);
    expect(tool).toBeGreaterThan(0);
    expect(codes({ cycle: 812, change: { Q494: 55 }, tool })).not.toContain("endInFront");
    expect(codes({ cycle: 812, change: { Q492: -55, Q494: 0 }, tool, start: "X+85 Z-57" })).not.toContain(
      "endsExchanged",
    );
  });
  test("a bore that is there, whatever the tool", () => {
    const change = { Q491: 50, Q493: 75 };
    expect(codes({ cycle: 812, change, blank: "D100 L100 DIST+0 DI40", start: "X+45 Z+2" })).not.toContain(
      "endsExchanged",
    );
  });
  test("the examples of the catalogue", () => {
    for (const cycle of [811, 812, 813, 814, 821, 822, 823, 824, 831, 841, 842, 851, 852, 861, 862, 871, 872])
      expect(codes({ cycle, change: {} }).filter((code) => code === "endInFront" || code === "endsExchanged")).toEqual(
        [],
      );
  });
});
