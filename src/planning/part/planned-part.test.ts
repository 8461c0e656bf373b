import { expect, test } from "vitest";
import { areaOf } from "../../kernel/area/area.ts";
import { newRow, type ContourRow } from "../../program/job/job.ts";
import type { Chain } from "../types.ts";
import { newPart, type FinishedPart } from "./finished-part.ts";
import { plannedPart } from "./planned-part.ts";

/** Rows from short text: "L 20 -10", "CHF 1", "UDC E", "CR 20 -10 5 ccw", "RND 2"; "-" leaves a coordinate out. */
function rowsOf(letter: string, lines: string): readonly ContourRow[] {
  return lines
    .split("|")
    .map((each) => each.trim().split(" "))
    .map(([kind = "", a = "", b = "", r = "", turn = "cw"], i) => {
      const id = `${letter}${i + 1}`,
        cell = (text: string) => (text === "-" ? "" : text);
      if (kind === "CHF" || kind === "RND") return newRow(id, { kind, r: a });
      if (kind === "UDC") return newRow(id, { kind, form: a });
      return newRow(id, { kind: kind as ContourRow["kind"], x: cell(a), z: cell(b), r, turn: turn as "cw" | "ccw" });
    });
}

const partWith = (outside: string, inside = "", given: Partial<FinishedPart> = {}): FinishedPart => ({
  ...newPart("PART"),
  outside: outside === "" ? [] : rowsOf("e", outside),
  inside: inside === "" ? [] : rowsOf("i", inside),
  ...given,
});

const written = ({ segments, marks }: Chain) => {
  const [first] = segments;
  const point = ({ z, r }: { z: number; r: number }) => `${Number((r + r).toFixed(3))},${Number(z.toFixed(3))}`;
  return first ? [point(first.from), ...segments.map((s, i) => `${point(s.to)} ${marks[i]?.row}`)].join(" > ") : "";
};

const SOLID = "0,0 > 20,0 e1 > 20,-10 e2 > 30,-10 e3 > 30,-30 e4";
const OUTER = "20,0 > 40,0 e2 > 40,-30 e2",
  BORE = "20,0 > 20,-30";

/** The same part as people bring it. */
test.each([
  [
    "from the first ⌀",
    "L 20 0 | L - -10 | L 30 - | L - -30",
    "",
    "0,0 > 20,0 e2 > 20,-10 e2 > 30,-10 e3 > 30,-30 e4",
    "",
  ],
  [
    "with its front face",
    "L 0 0 | L 20 - | L - -10 | L 30 - | L - -30",
    "",
    SOLID.replaceAll(/e(\d)/g, (_, n) => `e${Number(n) + 1}`),
    "",
  ],
  [
    "from a point before the face",
    "L 0 2 | L 0 0 | L 20 - | L - -10 | L 30 - | L - -30",
    "",
    SOLID.replaceAll(/e(\d)/g, (_, n) => `e${Number(n) + 2}`),
    "",
  ],
  [
    "from the rear to the front",
    "L 30 -30 | L - -10 | L 20 - | L - 0 | L 0 -",
    "",
    "0,0 > 20,0 e5 > 20,-10 e4 > 30,-10 e3 > 30,-30 e2",
    "",
  ],
  ["with its rear face", "L 20 0 | L - -10 | L 30 - | L - -30 | L 0 -", "", SOLID.replace("e1", "e2"), ""],
  [
    "closed along the axis",
    "L 0 0 | L 20 - | L - -10 | L 30 - | L - -30 | L 0 - | L 0 0",
    "",
    SOLID.replaceAll(/e(\d)/g, (_, n) => `e${Number(n) + 1}`),
    "",
  ],
  [
    "hollow in two contours",
    "L 20 0 | L 40 - | L - -30",
    "L 20 0 | L - -30",
    "20,0 > 40,0 e2 > 40,-30 e3",
    `${BORE} i2`,
  ],
  ["hollow, its bore from the rear", "L 40 0 | L - -30", "L 20 -30 | L - 0", OUTER, `${BORE} i2`],
  ["hollow, its bore past both faces", "L 40 0 | L - -30", "L 20 2 | L - -32", OUTER, `${BORE} i2`],
  ["hollow, its bore with both faces", "L 40 0 | L - -30", "L 40 0 | L 20 - | L - -30 | L 40 -", OUTER, `${BORE} i3`],
  ["hollow, closed", "L 20 0 | L 40 - | L - -30 | L 20 - | L - 0", "", "20,0 > 40,0 e2 > 40,-30 e3", `${BORE} e5`],
  [
    "hollow, closed the other way round from its rear",
    "L 20 -30 | L - 0 | L 40 - | L - -30 | L 20 -",
    "",
    "20,0 > 40,0 e3 > 40,-30 e4",
    `${BORE} e2`,
  ],
  ["hollow, open at its front", "L 40 0 | L - -30 | L 20 - | L - 0", "", OUTER, `${BORE} e4`],
  ["blind, without its bottom", "L 40 0 | L - -30", "L 20 0 | L - -15", OUTER, "20,0 > 20,-15 i2 > 0,-15 i2"],
  [
    "blind, closed",
    "L 20 0 | L 40 - | L - -30 | L 0 - | L - -15 | L 20 - | L - 0",
    "",
    "20,0 > 40,0 e2 > 40,-30 e3",
    "20,0 > 20,-15 e7 > 0,-15 e6",
  ],
  [
    "a bore that begins at its chamfer",
    "L 40 0 | L - -30",
    "L 22 0 | L 20 -1 | L - -30",
    "22,0 > 40,0 e2 > 40,-30 e2",
    "22,0 > 20,-1 i2 > 20,-30 i3",
  ],
])("%s", (_, outside, inside, wanted, bore) => {
  const { part, problems } = plannedPart(partWith(outside, inside));
  expect(problems).toEqual([]);
  expect(part && [written(part.outside), written(part.inside)]).toEqual([wanted, bore]);
  expect(areaOf(part?.rings ?? [])).toBeGreaterThan(0);
});

test("a tube keeps its own bore", () => {
  const tube = { outside: "42", bore: "20", length: "60", allowance: "1" };
  const { part, problems } = plannedPart(partWith("L 40 0 | L - -30", "", { blank: tube }));
  expect([written(part?.inside ?? { segments: [], marks: [] }), problems]).toEqual([`${BORE} e2`, []]);
  const counterbored = plannedPart(partWith("L 40 0 | L - -30", "L 26 0 | L - -8", { blank: tube }));
  expect(counterbored.part && written(counterbored.part.inside)).toBe("26,0 > 26,-8 i2 > 20,-8 i2 > 20,-30 i2");
  const open = plannedPart(partWith("L 40 0 | L - -30", "L 26 0 | L - -8", { blank: tube, unmachinedBehind: true }));
  expect(open.part && written(open.part.inside)).toBe("26,0 > 26,-8 i2 > 20,-8 i2");
});

test("a contour that ends in a face ends in the blank", () => {
  const { part, blank, problems } = plannedPart(partWith("L 20 0 | L - -10 | L 30 -"));
  expect(problems).toEqual([]);
  expect(areaOf(part?.rings ?? [])).toBeCloseTo(10 * 10 + 16 * 30, 3);
  expect(areaOf(blank)).toBeCloseTo(16 * 41, 3);
});

test("what is not machined behind the contour stays as the blank is", () => {
  const blank = { outside: "50", bore: "0", length: "62", allowance: "2" };
  const { part } = plannedPart(partWith("L 20 0 | L - -10 | L 30 - | L - -30", "", { blank, unmachinedBehind: true }));
  expect(areaOf(part?.rings ?? [])).toBeCloseTo(10 * 10 + 15 * 20 + 25 * 30, 3);
});

/** Sizes at the middle of their tolerances: ⌀ and Z of the chain. */
test.each([
  [
    "a cylinder with its chamfer",
    "L 0 0 | L 20 - | CHF 1 | L - -10 | L 30 - | L - -30",
    { e4: { tolerance: "0/-0.04" } },
    "0,0 > 17.98,0 e2 > 19.98,-1 e3 > 19.98,-10 e4 > 30,-10 e5 > 30,-30 e6",
  ],
  [
    "two rows on one cylinder",
    "L 20 0 | L - -10 | L - -15 | L 30 - | L - -30",
    { e2: { tolerance: "h6" } },
    "0,0 > 19.994,0 e2 > 19.994,-10 e2 > 19.994,-15 e3 > 30,-15 e4 > 30,-30 e5",
  ],
  [
    "a face",
    "L 20 0 | L - -10 | L 30 - | L - -30",
    { e3: { tolerance: "+0.1/0" } },
    "0,0 > 20,0 e2 > 20,-10.05 e2 > 30,-10.05 e3 > 30,-30 e4",
  ],
  [
    "an arc keeps its radius",
    "L 20 0 | L - -10 | CR 30 -15 5 cw | L - -30",
    { e4: { tolerance: "+0.02/0" } },
    "0,0 > 20,0 e2 > 20,-10 e2 > 30.01,-15 e3 > 30.01,-30 e4",
  ],
  [
    "a chamfer keeps its angle",
    "L 17 0 | L 20 -1.5 | L - -15 | L 30 - | L - -30",
    { e3: { tolerance: "0/-0.4" } },
    "0,0 > 17,0 e2 > 19.8,-1.4 e2 > 19.8,-15 e3 > 30,-15 e4 > 30,-30 e5",
  ],
  [
    "an outside thread",
    "L 20 0 | L - -15 | L 30 - | L - -30",
    { e2: { thread: "M20" } },
    "0,0 > 19.791,0 e2 > 19.791,-15 e2 > 30,-15 e3 > 30,-30 e4",
  ],
] as const)("%s", (_, outside, marks, wanted) => {
  const { part, problems } = plannedPart(partWith(outside, "", { marks }));
  expect(problems).toEqual([]);
  expect(part && written(part.outside)).toBe(wanted);
});

test.each([
  ["nothing", "", "", {}, "noOutside"],
  ["a contour across the axis", "L 20 0 | L -20 -30 | L 20 -40", "", {}, "belowAxis"],
  ["a loop", "L 20 0 | L - -20 | L 30 -20 | L 30 -10 | L 10 -10 | L 10 -40", "", {}, "row"],
  ["a bore larger than the part", "L 20 0 | L - -30", "L 24 0 | L - -30", {}, "openFront"],
  [
    "a bore that breaks through",
    "L 20 0 | L - -30",
    "L 10 0 | L - -10 | L 24 - | L - -20 | L 10 - | L - -30",
    {},
    "boreOutside",
  ],
  ["a bore that begins inside", "L 20 0 | L - -30", "L 10 -5 | L - -30", {}, "openFront"],
  ["a thread without a name", "L 20 0 | L - -30", "", { marks: { e2: { thread: "X20" } } }, "threadName"],
  ["a thread on a face", "L 0 0 | L 20 0 | L - -30", "", { marks: { e2: { thread: "M20" } } }, "threadPlace"],
  ["a thread of another size", "L 30 0 | L - -30", "", { marks: { e2: { thread: "M20" } } }, "threadSize"],
  [
    "an undercut without a name",
    "L 20 0 | L - -10 | UDC E | L 30 - | L - -30",
    "",
    { marks: { e3: { undercut: "DIN 1" } } },
    "undercutName",
  ],
  ["a tolerance that is none", "L 20 0 | L - -30", "", { marks: { e2: { tolerance: "hh" } } }, "toleranceText"],
  ["a tolerance of a cone", "L 20 0 | L 30 -30", "", { marks: { e2: { tolerance: "h6" } } }, "tolerancePlace"],
  ["a front that is not at Z0", "L 20 5 | L - -30", "", {}, "front"],
  [
    "a blank too small",
    "L 20 0 | L - -30",
    "",
    { blank: { outside: "18", bore: "0", length: "40", allowance: "1" } },
    "beyondBlank",
  ],
  [
    "a blank that is none",
    "L 20 0 | L - -30",
    "",
    { blank: { outside: "18", bore: "30", length: "40", allowance: "1" } },
    "blankWrong",
  ],
  ["an incomplete clamping", "L 20 0 | L - -30", "", { clamping: { kind: "collet", words: {} } }, "missing"],
] as const)("%s is named", (_, outside, inside, given, code) => {
  expect(plannedPart(partWith(outside, inside, given)).problems.map((p) => p.code)).toContain(code);
});
