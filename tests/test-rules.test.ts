import { readdirSync, readFileSync } from "node:fs";
import fc from "fast-check";
import { describe, expect, test } from "vitest";
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

/** Tests have to pass on a machine many times slower and busy. */
describe("what no test does", () => {
  test("there are tests to look at", () => {
    expect(journeys.length).toBeGreaterThan(10);
    expect(tests.length).toBeGreaterThan(50);
  });

  test("none looks at a clock: what a time says about is the machine", () => {
    expect(
      [...journeys, ...tests]
        .filter(([, t]) => /performance\.now|Date\.now\(\)|test\.slow\(|setTimeout\(\d/.test(t))
        .map(([path]) => path),
    ).toEqual([]);
  });

  test("no law is ended by the time, and one that fails looks for no smaller case unless it is asked to", () => {
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

  test("every journey runs with the test that can be slowed, and waits for things, not for a time", () => {
    expect(
      journeys
        .filter(([, t]) => /from "@playwright\/test"/.test(t.replace(/import type .*\n/g, "")))
        .map(([path]) => path),
    ).toEqual([]);
    // A clock that is held has to be seen standing still for a while.
    expect(
      journeys
        .filter(([path, t]) => t.includes("waitForTimeout") && !path.endsWith("playback.spec.ts"))
        .map(([path]) => path),
    ).toEqual([]);
  });
});

/** A planted fault whose place has gone is a fault that nothing looks for any more. */
test("every planted fault still has its one place", () => {
  const faults = readdirSync(projectPath("tests/mutants")).flatMap(
    (name) =>
      JSON.parse(readFileSync(projectPath(`tests/mutants/${name}`), "utf8")) as readonly {
        what: string;
        file: string;
        find: string;
      }[],
  );
  const lost = faults.filter(({ file, find }) => readFileSync(projectPath(file), "utf8").split(find).length !== 2);
  expect(faults.length).toBeGreaterThan(100);
  expect(lost.map(({ what }) => what)).toEqual([]);
});
