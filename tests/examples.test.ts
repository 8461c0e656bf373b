import { describe, expect, test } from "vitest";
import { examples } from "../src/examples/index.ts";
import { texts } from "../src/i18n/index.ts";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { toDiameter } from "../src/kernel/units.ts";
import { parse } from "../src/nc/parse.ts";
import { issuesOf, print } from "../src/nc/program.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { stockIssues as proved } from "../src/sim/issues.ts";
import { simulate } from "../src/sim/simulate.ts";

function verified(text: string) {
  const done = run(parse(text), { tools: shippedTools, rapid: 10_000 });
  const simulation = simulate(done);
  return { done, simulation, issues: [...done.issues.map((f) => f.issue), ...proved(simulation).map((p) => p.issue)] };
}
const textOf = (id: string) => examples.find((e) => e.id === id)?.text ?? "";
const isTurned = (text: string) => text.includes("FUNCTION MODE TURN");

test.each(examples.map((e) => [e.id, e.text] as const))(
  "%s is printed as it was read, and the reader finds nothing",
  (id, text) => {
    const program = parse(text);
    expect(print(program)).toBe(text);
    expect(issuesOf(program)).toEqual([]);
    for (const l of LANGUAGES) expect(texts(l).page.examples[id]).toBeTruthy();
  },
);

test.each(examples.map((e) => [e.id, e.text] as const))(
  "%s runs without a finding and cuts nothing it should not",
  (_, text) => {
    const { done, simulation, issues } = verified(text);
    expect(done.operations.length > 0).toBe(isTurned(text));
    expect(done.seconds).toBeGreaterThan(0);
    expect(issues.filter((i) => i.code !== "airPasses" && i.code !== "depthFromPitch")).toEqual([]);
    expect(simulation.proof).toMatchObject({ gouge: 0, rapidInStock: 0 });
  },
);

describe("the flange", () => {
  const { done, simulation } = verified(textOf("flange"));

  test("has six tools and eight cycle calls", () => {
    expect(new Set(done.operations.map((o) => o.tool.T))).toEqual(new Set([15, 1, 3, 5, 6, 8]));
    expect(done.operations.length).toBe(8);
    expect(new Set(done.operations.map((o) => o.cycle)).size).toBe(3);
  });

  test("becomes one ring with the drawn diameters and lengths", () => {
    expect(simulation.final.length).toBe(1);
    const corners = (simulation.final[0] ?? []).map((p) => ({ x: toDiameter(p.r), z: p.z }));
    const has = (x: number, z: number) => corners.some((p) => Math.abs(p.x - x) < 0.02 && Math.abs(p.z - z) < 0.02);
    // Front face with the chamfers of the shoulder and the bore, and the groove between them.
    expect([has(59, 0), has(62, -1.5), has(42, 0), has(40, -1), has(56.6, 0), has(45.4, 0)]).not.toContain(false);
    // Both shoulders and the end of the bore, and the floor of the groove.
    expect([has(78, -40), has(80, -41), has(99, -58), has(25, -32)]).not.toContain(false);
    expect(corners.some((p) => Math.abs(p.z + 4) < 0.01 && p.x > 46 && p.x < 56)).toBe(true);
    expect(Math.max(...corners.map((p) => p.x))).toBeCloseTo(100, 3);
    expect(Math.max(...corners.map((p) => p.z))).toBeCloseTo(0, 3);
  });
});

describe("the shaft", () => {
  const { done, simulation } = verified(textOf("shaft"));
  const corners = simulation.final.flat().map((p) => ({ x: toDiameter(p.r), z: p.z }));
  const within = (from: number, to: number) => corners.filter((p) => p.z < from && p.z > to);

  test("has ten operations of six cycles, all proved", () => {
    expect(done.operations.map((o) => o.cycle)).toEqual([821, 810, 810, 862, 842, 831, 812, 812, 842, 831]);
    expect(done.unproved).toEqual([]);
    expect(simulation.proof.residual).toEqual([]);
  });

  test("has its taper, undercut, grooves, bore and threads", () => {
    const has = (x: number, z: number) => corners.some((p) => Math.abs(p.x - x) < 0.02 && Math.abs(p.z - z) < 0.02);
    // The ends of the taper, the floor of the undercut before the shoulder, the wall behind the last cylinder.
    expect([has(66, -26), has(72, -46), has(91.6, -104)]).toEqual([true, true, false]);
    expect(
      Math.min(
        ...within(-72, -74)
          .map((p) => p.x)
          .filter((x) => x > 60),
      ),
    ).toBeCloseTo(71.4, 1);
    // The floors of the groove, of the recess and of the relief in the bore.
    expect(Math.min(...within(-57.9, -62.3).map((p) => p.x))).toBeCloseTo(66.5, 2);
    expect(Math.min(...within(-79, -99).map((p) => p.x))).toBeCloseTo(76, 2);
    expect(
      Math.max(
        ...within(-28.9, -34.1)
          .map((p) => p.x)
          .filter((x) => x < 50),
      ),
    ).toBeCloseTo(45, 2);
    // Roots of both threads.
    expect(
      Math.min(
        ...within(-3, -19)
          .map((p) => p.x)
          .filter((x) => x > 50),
      ),
    ).toBeCloseTo(60 - 2 * 0.6134 * 1.5, 2);
    expect(
      Math.max(
        ...within(-3, -25)
          .map((p) => p.x)
          .filter((x) => x < 50),
      ),
    ).toBeCloseTo(44, 2);
  });
});
