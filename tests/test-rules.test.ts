import { readdirSync, readFileSync } from "node:fs";
import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { REPLACING } from "./replacing.ts";
import { projectPath } from "./sources.ts";

const text = (found: Record<string, string>) =>
  Object.entries(found).filter(([path]) => !path.endsWith("/test-rules.test.ts"));
const journeys = text(import.meta.glob<string>("../e2e/*.spec.ts", { query: "?raw", import: "default", eager: true }));
const tests = text(
  import.meta.glob<string>(["../src/**/*.test.{ts,tsx}", "./**/*.test.ts"], {
    query: "?raw",
    import: "default",
    eager: true,
  }),
);

/** Tests must pass on a machine that is many times slower and busy. */
describe("rules for tests", () => {
  test("there are tests to look at", () => {
    expect(journeys.length).toBeGreaterThan(10);
    expect(tests.length).toBeGreaterThan(50);
  });

  test("none reads a clock: a time depends on the machine", () => {
    expect(
      [...journeys, ...tests]
        .filter(([, t]) => /performance\.now|Date\.now\(\)|test\.slow\(|setTimeout\(\d/.test(t))
        .map(([path]) => path),
    ).toEqual([]);
  });

  test("what replaces a module is listed, since the others share their modules", () => {
    const replacing = tests.filter(([path, t]) => path.endsWith(".ts") && /\bvi\.(?:do)?[mM]ock\(/.test(t));
    expect(replacing.map(([path]) => path.replace(/^(?:\.\.\/|\.\/)/, (up) => (up === "./" ? "tests/" : "")))).toEqual([
      ...REPLACING,
    ]);
  });

  test("none asks for an environment of its own, which would end the worker that the others share", () => {
    expect(tests.filter(([, t]) => /@vitest-environment/.test(t)).map(([path]) => path)).toEqual([]);
  });

  test("no law has a time limit, and a failing one shrinks its case only on request", () => {
    expect(
      tests
        .filter(([, t]) => /interruptAfterTimeLimit|skipAllAfterTimeLimit|endOnFailure/.test(t))
        .map(([path]) => path),
    ).toEqual([]);
    const { interruptAfterTimeLimit, skipAllAfterTimeLimit, endOnFailure } = fc.readConfigureGlobal();
    expect([interruptAfterTimeLimit, skipAllAfterTimeLimit, endOnFailure]).toEqual([
      undefined,
      undefined,
      process.env["LAW_SHRINK"] !== "1",
    ]);
    let tried = 0;
    const failing = fc.property(fc.integer({ min: 100 }), () => {
      tried += 1;
      throw new Error("as it must");
    });
    expect(() => fc.assert(failing)).toThrow(/seed: /);
    if (endOnFailure) expect(tried).toBe(1);
  });

  test("every e2e test uses the test that can be slowed, and waits for conditions, not for a time", () => {
    expect(
      journeys
        .filter(([, t]) => /from "@playwright\/test"/.test(t.replace(/import type .*\n/g, "")))
        .map(([path]) => path),
    ).toEqual([]);
    // A held clock must be seen standing still for a while.
    expect(
      journeys
        .filter(([path, t]) => t.includes("waitForTimeout") && !path.endsWith("playback.spec.ts"))
        .map(([path]) => path),
    ).toEqual([]);
  });
});

/** A planted fault whose place is gone tests nothing. */
test("every planted fault still has exactly one place", () => {
  const faults = readdirSync(projectPath("tests/mutants")).flatMap(
    (name) =>
      JSON.parse(readFileSync(projectPath(`tests/mutants/${name}`), "utf8")) as readonly {
        what: string;
        file: string;
        find: string;
      }[],
  );
  const lost = faults.filter(({ file, find }) => readFileSync(projectPath(file), "utf8").split(find).length !== 2);
  expect(faults.length).toBeGreaterThan(400);
  expect(lost.map(({ what }) => what)).toEqual([]);
});
