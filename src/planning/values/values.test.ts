import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { at } from "../../kernel/geometry/point.ts";
import { never } from "../../kernel/never.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { cuttingValues as cuttingValueTexts } from "../../i18n/en/cutting-values.ts";
import { degrees, length } from "../../kernel/units.ts";
import { exampleJob } from "../../program/job/job.ts";
import { usualTable } from "../../program/tools/cutting-table.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { cuttingForce, cuttingPower, leadOf } from "../../report/advice/formulas.ts";
import { rzByRule } from "../../sim/load/cusp.ts";
import { barDiameter, cuttingValues } from "./cutting-values.ts";
import { withCuttingValues } from "./cycle-values.ts";
import { VALUE_FORMULAS, type ReasonedNumber } from "./formulas.ts";
import { heldWorkpiece } from "../../report/advice/held-workpiece.ts";
import { rzOf } from "./turning-values.ts";
import type { CuttingValues, ValuesRequest, Work } from "./values-request.ts";

const tool = (T: number) => shippedTools.find((t) => t.T === T) ?? never("no such tool");
const material = (id: string) => usualTable.materials.find((m) => m.id === id) ?? never("no such material");
const drill = (d: number): Tool => ({
  T: 31,
  NAME: "DRILL",
  TYPE: "DRILL",
  TO: 7,
  RS: length(0),
  R: length(d / 2),
  "T-ANGLE": degrees(118),
});

const base: ValuesRequest = {
  work: "rough",
  tool: tool(1),
  material: material("c45"),
  smallest: 23,
  largest: 61,
  workpiece: null,
  bar: null,
  machine: null,
  power: 11,
  roughness: null,
};
const said = (value: ReasonedNumber | null) => value && `${value.value} ${value.formula} ${value.limitedBy}`;

/* Calculated by hand from the formulas of decision 0056 with C45E: kc1.1 2220, mc 0.14, 190 and 250 m/min. */
describe("values and what limits them", () => {
  test.each<[string, Partial<ValuesRequest>, keyof CuttingValues, string | null]>([
    ["ten times the feed", {}, "infeed", "3 depthOfFeed chip"],
    ["the feed of the material", {}, "feed", "0.3 feedOfMaterial material"],
    ["a small nose", { tool: { ...tool(1), RS: length(0.2) } }, "feed", "0.16 feedOfNose insert"],
    ["two thirds of a short edge", { tool: { ...tool(1), CUTLENGTH: length(3) } }, "infeed", "2 depthOfEdge cutLength"],
    ["a round insert", { tool: tool(11) }, "infeed", "1.5 depthOfButton insert"],
    // 2220 · 0.29886^−0.14 = 2629: 4 · 60 000 / (0.3 · 2629 · 190) = 1.602
    ["four kilowatts", { power: 4 }, "infeed", "1.6 depthOfPower power"],
    // I = 20480 mm⁴ for ⌀25.415: F = 0.05 · 3 · 210 000 · 20 480 / 110³ / 0.4 = 1211.7 N; / (0.3 · 2629) = 1.536
    [
      "a free shaft",
      { workpiece: { overhang: 110, diameter: 25.415, support: "chuck" } },
      "infeed",
      "1.5 depthOfWorkpiece slenderness",
    ],
    [
      "the same shaft with a centre",
      { workpiece: { overhang: 110, diameter: 25.415, support: "chuckAndCentre" } },
      "infeed",
      "3 depthOfFeed chip",
    ],
    // F = 0.05 · 3 · 210 000 · 3217 / 64³ / 0.4 = 966.4 N; / (0.3 · 2629) = 1.2254
    ["a boring bar", { tool: tool(5), bar: { overhang: 64, diameter: 16 } }, "infeed", "1.2 depthOfBar bar"],
    [
      "a face bends no shaft",
      { work: "face", workpiece: { overhang: 200, diameter: 20, support: "chuck" } },
      "infeed",
      "3 depthOfFeed chip",
    ],
    // √(8 · 0.4 · 6.4 / 1000) = 0.1431
    [
      "Ra 1.6",
      { work: "finish", tool: tool(3), roughness: { kind: "Ra", value: 1.6 } },
      "feed",
      "0.14 feedOfRoughness roughness",
    ],
    // √(8 · 0.8 · 4 / 1000) = 0.16
    [
      "Rz 4",
      { work: "finish", tool: tool(2), roughness: { kind: "Rz", value: 4 } },
      "feed",
      "0.16 feedOfRoughness roughness",
    ],
    ["no mark: Rz 6.3", { work: "finish", tool: tool(3) }, "feed", "0.14 feedOfRoughness roughness"],
    ["no mark: the finishing feed", { work: "finish", tool: tool(2) }, "feed", "0.15 feedOfMaterial material"],
    [
      "a coarse mark: the nose",
      { work: "finish", tool: { ...tool(2), RS: length(0.2) }, roughness: { kind: "Rz", value: 63 } },
      "feed",
      "0.16 feedOfNose insert",
    ],
    ["finishing is faster", { work: "finish", tool: tool(3) }, "speed", "250 speedOfMaterial material"],
    ["a finishing cut", { work: "finish", tool: tool(3) }, "infeed", "0.25 depthOfNose insert"],
    ["a blade of 2 mm", { work: "recess", tool: tool(10), depth: 2 }, "feed", "0.08 feedOfWidth width"],
    ["a shallow groove", { work: "recess", tool: tool(10), depth: 2 }, "step", null],
    ["a deep groove", { work: "recess", tool: tool(10), depth: 6 }, "step", "3 stepOfWidth width"],
    ["slower in a groove", { work: "recess", tool: tool(10), depth: 2 }, "speed", "152 speedOfShare material"],
    ["slowest when parting off", { work: "partOff", tool: tool(9), depth: 30 }, "speed", "133 speedOfShare material"],
    [
      "a blade's sharp corners",
      { work: "recess", tool: { ...tool(9), CUTWIDTH: length(6), RS: length(0.1) } },
      "feed",
      "0.1 feedOfCorner insert",
    ],
    ["recess turning", { tool: { ...tool(9), CUTWIDTH: length(1) } }, "infeed", "0.5 depthOfWidth width"],
    // 0.65 · 190 = 124; 1000 · 124 / (π · 30) = 1315.7
    [
      "a thread",
      { work: "thread", tool: tool(12), largest: 30, pitch: 1.5, depth: 0.92 },
      "speed",
      "1310 rpmOfSpeed material",
    ],
    // 0.92 / √7 = 0.3477
    [
      "its first pass",
      { work: "thread", tool: tool(12), largest: 30, pitch: 1.5, depth: 0.92 },
      "infeed",
      "0.34 depthOfThread pitch",
    ],
    [
      "a coarse thread",
      { work: "thread", tool: tool(12), largest: 30, pitch: 3, depth: 1.84, fastest: 2000 },
      "speed",
      "660 rpmOfThread pitch",
    ],
    [
      "its first pass",
      { work: "thread", tool: tool(12), largest: 60, pitch: 4, depth: 2.45 },
      "infeed",
      "0.5 depthOfTooth insert",
    ],
    // 0.6134 · 1.5 = 0.92
    [
      "a depth that the control takes",
      { work: "thread", tool: tool(12), largest: 30, pitch: 1.5, depth: 0 },
      "infeed",
      "0.34 depthOfThread pitch",
    ],
    [
      "a sharp finishing nose",
      { work: "finish", tool: { ...tool(3), RS: length(0.1) } },
      "infeed",
      "0.2 depthLeast least",
    ],
    [
      "a shaft that bends under any cut",
      { workpiece: { overhang: 400, diameter: 12, support: "chuck" } },
      "infeed",
      "0.2 depthLeast least",
    ],
    // 1000 · 24 / (π · 10) = 763.9
    ["a drill", { work: "drill", tool: drill(10), depth: 20 }, "speed", "760 rpmOfSpeed material"],
    ["its feed", { work: "drill", tool: drill(10), depth: 20 }, "feed", "0.2 feedOfDrill material"],
    ["its depth", { work: "drill", tool: drill(10), depth: 20 }, "step", "20 wholeDepth depth"],
    // 0.6 · 24 → 14: 1000 · 14 / (π · 10) = 445.6
    ["a deep hole", { work: "drill", tool: drill(10), depth: 63 }, "speed", "440 rpmOfSpeed material"],
    ["is drilled in steps", { work: "drill", tool: drill(10), depth: 63 }, "step", "10 stepOfDiameter depth"],
    ["a large drill", { work: "drill", tool: drill(26), depth: 40 }, "feed", "0.3 feedOfMaterial material"],
    ["a slow machine", { machine: { most: 1800 } }, "limit", "1800 limitOfMachine machine"],
    ["an unknown machine", {}, "limit", "2500 limitAssumed machine"],
  ])("%s", (_, change, of, wanted) => {
    const found = cuttingValues({ ...base, ...change })[of];
    expect(said(found as ReasonedNumber | null)).toBe(wanted);
  });

  test("the marks of a drawing as Rz", () => {
    expect(rzOf({ kind: "Rz", value: 10 })).toBe(10);
    expect(rzOf({ kind: "Ra", value: 3.2 })).toBeCloseTo(12.8, 9);
  });

  test("an oversize that the finishing nose cuts", () => {
    const { oversize } = cuttingValues({ ...base, work: "finish", tool: tool(2) });
    expect(said(oversize?.diameter ?? null)).toBe("1 oversizeOfNose insert");
    expect(said(oversize?.z ?? null)).toBe("0.25 halfOfDepth insert");
  });

  test.each<[string, Partial<ValuesRequest>, readonly string[]]>([
    ["nothing", { workpiece: { overhang: 60, diameter: 20, support: "chuck" } }, []],
    ["a long free shaft", { workpiece: { overhang: 62, diameter: 20, support: "chuck" } }, ["slenderWorkpiece 3.1"]],
    ["a shaft with a centre", { workpiece: { overhang: 162, diameter: 20, support: "chuckAndCentre" } }, []],
    ["a long bar", { tool: tool(5), bar: { overhang: 52, diameter: 10 } }, ["slenderBar 5.2"]],
    ["a narrow blade in a deep groove", { work: "partOff", tool: tool(10), depth: 17 }, ["deepGroove 8.5"]],
    ["an edge of unknown length", { tool: { ...tool(1), CUTLENGTH: length(0) } }, ["edgeUnknown 0.0"]],
    ["hardened steel", { work: "drill", tool: drill(8), depth: 9, material: material("100cr6") }, ["notDrilled 0.0"]],
  ])("%s needs attention", (_, change, wanted) => {
    expect(cuttingValues({ ...base, ...change }).risks.map((r) => `${r.kind} ${r.ratio.toFixed(1)}`)).toEqual(wanted);
  });
});

describe("laws", () => {
  const WORKS: readonly Work[] = ["rough", "face", "finish", "recess", "partOff", "thread", "drill", "centre"];
  const positive = (min: number, max: number) => fc.double({ min, max, noNaN: true });
  const torque = positive(20, 300).map((t) => [
    { speed: 0, torque: t },
    { speed: 1500, torque: t },
    { speed: 4500, torque: t / 4 },
  ]);
  const requests = fc.record({
    work: fc.constantFrom(...WORKS),
    tool: fc.oneof(fc.constantFrom(...shippedTools), positive(1, 30).map(drill)),
    material: fc.constantFrom(...usualTable.materials),
    smallest: positive(0, 20),
    largest: positive(20, 300),
    workpiece: fc.option(
      fc.record({
        overhang: positive(5, 400),
        diameter: positive(5, 200),
        support: fc.constantFrom("chuck" as const, "chuckAndCentre" as const, "centres" as const),
      }),
      { nil: null },
    ),
    bar: fc.option(fc.record({ overhang: positive(10, 200), diameter: positive(6, 40) }), { nil: null }),
    machine: fc.option(fc.record({ most: positive(500, 6000), power: positive(2, 40), torque }), { nil: null }),
    power: positive(2, 40),
    roughness: fc.option(
      fc.record({ kind: fc.constantFrom("Ra" as const, "Rz" as const), value: positive(0.4, 100) }),
      { nil: null },
    ),
    depth: positive(0.1, 80),
    pitch: positive(0.25, 6),
    fastest: fc.option(positive(500, 10_000), { nil: null }),
  }) satisfies fc.Arbitrary<ValuesRequest>;

  test("values are positive, within edge, power, machine and mark, and each has its formula", () => {
    fc.assert(
      fc.property(requests, (request) => {
        const { infeed, feed, plungeFeed, step, speed, limit, spindle, oversize } = cuttingValues(request);
        const all = [infeed, feed, plungeFeed, step, speed, limit, oversize?.diameter, oversize?.z].filter((v) => !!v);
        for (const { value, formula, inputs } of all) {
          expect(value).toBeGreaterThan(0);
          expect(value).toBeLessThan(Infinity);
          expect(VALUE_FORMULAS[formula]).toBeDefined();
          for (const input of Object.values(inputs)) expect(Number.isNaN(input)).toBe(false);
        }
        const { CUTLENGTH, CUTWIDTH, RS } = request.tool;
        const isTurned = request.work === "rough" || request.work === "face";
        if (isTurned && CUTLENGTH && !CUTWIDTH) expect(infeed?.value).toBeLessThanOrEqual(CUTLENGTH);
        if (isTurned && CUTWIDTH) expect(infeed?.value).toBeLessThanOrEqual(CUTWIDTH);
        if (isTurned && !request.machine && spindle.kind === "surface")
          expect(
            cuttingPower(request.material, infeed?.value ?? 0, feed.value, spindle.cuttingSpeed, leadOf(request.tool)),
          ).toBeLessThanOrEqual(request.power * 1.0001);
        if (spindle.kind === "constant" && request.machine)
          expect(spindle.speed).toBeLessThanOrEqual(request.machine.most);
        if (limit && request.machine) expect(limit.value).toBeLessThanOrEqual(request.machine.most);
        if (request.work === "finish" && request.roughness && RS > 0 && request.tool.TYPE !== "BUTTON" && !CUTWIDTH)
          expect(rzByRule(feed.value, RS)).toBeLessThanOrEqual(
            Math.max(rzOf(request.roughness), rzByRule(0.01, RS)) * 1.0001,
          );
      }),
      { numRuns: 400 },
    );
  });

  test("a longer or a thinner workpiece is never cut with more force", () => {
    const size = fc.record({ overhang: positive(20, 300), diameter: positive(8, 80), more: positive(1, 2) });
    const forceFor = (overhang: number, diameter: number) => {
      const { infeed, feed } = cuttingValues({ ...base, workpiece: { overhang, diameter, support: "chuck" } });
      return cuttingForce(base.material, infeed?.value ?? 0, feed.value, leadOf(base.tool));
    };
    fc.assert(
      fc.property(size, ({ overhang, diameter, more }) => {
        // Rounding to typed values may move one step.
        const force = forceFor(overhang, diameter) * 1.35;
        expect(forceFor(overhang * more, diameter)).toBeLessThanOrEqual(force);
        expect(forceFor(overhang, diameter / more)).toBeLessThanOrEqual(force);
      }),
      { numRuns: 100 },
    );
  });

  test("a finer mark never gives a larger feed, a larger drill never a faster spindle", () => {
    fc.assert(
      fc.property(positive(0.2, 50), positive(1, 3), positive(1, 30), (value, more, d) => {
        const feedFor = (rz: number) =>
          cuttingValues({ ...base, work: "finish", roughness: { kind: "Rz", value: rz } }).feed.value;
        const turnsFor = (across: number) =>
          cuttingValues({ ...base, work: "drill", tool: drill(across), depth: 1 }).speed.value;
        expect(feedFor(value)).toBeLessThanOrEqual(feedFor(value * more));
        expect(turnsFor(d * more)).toBeLessThanOrEqual(turnsFor(d));
      }),
      { numRuns: 100 },
    );
  });
});

describe("a stock in its clamping", () => {
  const clamped = (kind: "chuckOutside" | "centres", tailstock = false) => ({
    clamping: {
      kind,
      diameter: 40,
      length: 30,
      face: -100,
      ...(tailstock && { tailstock: { quill: 40, tip: 2, angle: 60 } }),
    },
    bodies: [],
  });
  const plain = [[at(-130, 0), at(0, 0), at(0, 20), at(-130, 20)]];
  const thinAtEnd = [[at(-130, 0), at(0, 0), at(0, 5), at(-20, 5), at(-20, 20), at(-130, 20)]];
  const thinAtJaws = [[at(-130, 0), at(0, 0), at(0, 20), at(-80, 20), at(-80, 5), at(-130, 5)]];

  test("a plain bar has its own diameter, a bore makes it weaker", () => {
    expect(heldWorkpiece(plain, clamped("chuckOutside"))).toEqual({
      overhang: 100,
      diameter: expect.closeTo(40, 6),
      support: "chuck",
    });
    const tube = [[at(-130, 15), at(0, 15), at(0, 20), at(-130, 20)]];
    // (40⁴ − 30⁴)^¼
    expect(heldWorkpiece(tube, clamped("chuckOutside"))?.diameter).toBeCloseTo(36.371, 2);
  });

  test("a thin place counts by its bending moment", () => {
    const [end, jaws] = [thinAtEnd, thinAtJaws].map((s) => heldWorkpiece(s, clamped("chuckOutside"))?.diameter ?? 0);
    expect(end).toBeGreaterThan(25);
    expect(jaws).toBeLessThan(15);
  });

  test("how it is held", () => {
    expect(heldWorkpiece(plain, clamped("chuckOutside", true))?.support).toBe("chuckAndCentre");
    expect(heldWorkpiece(plain, clamped("centres", true))?.support).toBe("centres");
    expect(heldWorkpiece(plain, null)).toBeNull();
    expect(heldWorkpiece([[at(-130, 0), at(-110, 0), at(-110, 20), at(-130, 20)]], clamped("chuckOutside"))).toBeNull();
  });

  test("the bar of a boring tool is its shank", () => {
    expect(barDiameter(tool(5))).toBe(20);
    expect(barDiameter(tool(1))).toBeNull();
  });
});

test("every formula has its reason in the texts", () => {
  expect(Object.keys(cuttingValueTexts.reasons).sort()).toEqual(Object.keys(VALUE_FORMULAS).sort());
});

test("a job takes the values of its cycle, with a reason for each", () => {
  const cycle = cycleByNumber(812) ?? never("no such cycle");
  const main = cuttingValues(base);
  const finish = cuttingValues({ ...base, work: "finish", tool: tool(3), roughness: { kind: "Ra", value: 0.8 } });
  const { job, values } = withCuttingValues(exampleJob(cycle), cycle, { main, finish });
  expect(job.drafts[cycle.number]).toMatchObject({ Q463: "3", Q478: "0.3", Q505: "0.1", Q483: "0.5", Q484: "0.1" });
  expect(job.spindle).toMatchObject({ mode: "surface", cuttingSpeed: "190", limit: "2500" });
  expect(values.map(({ q, formula }) => `${q} ${formula}`)).toEqual([
    "Q463 depthOfFeed",
    "Q478 feedOfMaterial",
    "Q483 oversizeOfNose",
    "Q484 halfOfDepth",
    "Q505 feedOfRoughness",
    "speed speedOfMaterial",
    "limit limitAssumed",
  ]);
});

test("a thread turns at a constant speed and takes only its first pass", () => {
  const cycle = cycleByNumber(831) ?? never("no such cycle");
  const main = cuttingValues({ ...base, work: "thread", tool: tool(12), largest: 30, pitch: 1.5, depth: 0.92 });
  const { job, values } = withCuttingValues(exampleJob(cycle), cycle, { main });
  expect(job.spindle).toMatchObject({ mode: "constant", speed: "1310" });
  expect(values.map(({ q, value }) => `${q} ${value}`)).toEqual(["Q463 0.34", "speed 1310"]);
});
